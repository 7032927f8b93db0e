//! What error terms look like in an Allan deviation, each of magnitude 1.

use schuler::allan::term::Term;
use schuler::sensor::{Timing, flicker};

/// A term without its magnitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Quantization, Q = 1.
    Quantization,
    /// White noise, N = 1.
    White,
    /// Flicker, B = 1, as the emulator makes it for a run of these samples: a pole for each decade.
    Flicker(Timing<f64>),
    /// Random walk of the bias, K = 1.
    RandomWalk,
    /// Ramp of the bias, R = 1.
    Ramp,
    /// First-order Gauss-Markov bias of rms 1, and its correlation time, s.
    GaussMarkov(f64),
}

impl Shape {
    /// The core's closed form. Flicker stands there for that of 1/f alone.
    pub fn term(self) -> Term<f64> {
        match self {
            Self::Quantization => Term::Quantization(1.0),
            Self::White => Term::White(1.0),
            Self::Flicker(_) => Term::Flicker(1.0),
            Self::RandomWalk => Term::RandomWalk(1.0),
            Self::Ramp => Term::Ramp(1.0),
            Self::GaussMarkov(correlation_s) => Term::GaussMarkov { rms: 1.0, correlation_s },
        }
    }

    /// The processes that it is the sum of.
    fn parts(self, mut of: impl FnMut(Term<f64>) -> f64) -> f64 {
        match self {
            Self::Flicker(timing) => {
                let pole = |(correlation_s, rms)| Term::GaussMarkov { rms, correlation_s };
                flicker::poles(timing).map(|p| of(pole(p))).sum()
            }
            other => of(other.term()),
        }
    }

    /// Its Allan variance.
    pub fn variance(self, tau_s: f64) -> f64 {
        self.parts(|term| term.variance(tau_s))
    }

    /// The generalised covariance of its integral, as the core's terms have it.
    pub fn covariance(self, t_s: f64) -> f64 {
        self.parts(|term| term.covariance(t_s))
    }
}
