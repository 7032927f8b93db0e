//! How many independent differences a point of the Allan variance is worth.
//!
//! The differences overlap. Of M that are normal with correlations ρ_j, the mean square has
//! M/(1 + 2Σ(1 − j/M)ρ_j²) degrees of freedom.
//! Source: Greenhall & Riley, *Uncertainty of stability variances based on finite differences* (2003).
//!
//! ```
//! use schuler::allan::freedom;
//! use schuler::allan::term::Term;
//!
//! // Of white noise, a difference for each quarter of a cluster is worth 1/2.875 of a free one.
//! let edf = freedom::of(Term::White(1.0_f64), 64.0, 505, 4);
//! assert!((edf / (505.0 / 2.875) - 1.0).abs() < 0.01);
//! ```

use super::term::Term;
use crate::math::real::Scalar;

/// Correlations further apart than so many clusters are left out: those of flicker, the longest, are below
/// 1/250 there, and count by their squares.
const CLUSTERS: u32 = 8;

/// Degrees of freedom where a term dominates, of so many differences of which so many end in a cluster's length τ,
/// s. A ramp is no random process: it has those of white noise.
pub fn of<R: Scalar>(term: Term<R>, tau_s: R, differences: u64, per_cluster: u32) -> R {
    let term = match term {
        Term::Ramp(_) => Term::White(R::ONE),
        term => term.unit(),
    };
    // In units of τ.
    let scaled = match term {
        Term::GaussMarkov { rms, correlation_s } => {
            Term::GaussMarkov { rms, correlation_s: correlation_s / tau_s }
        }
        other => other,
    };
    // R(t) = 6s(t) − 4[s(t + τ) + s(t − τ)] + s(t + 2τ) + s(t − 2τ)
    let correlation = |lag: u32| {
        let per = i128::from(per_cluster.max(1));
        let s = |clusters: i128| scaled.covariance(R::ratio(i128::from(lag) + clusters * per, per));
        R::of(6.0) * s(0) - R::of(4.0) * (s(1) + s(-1)) + s(2) + s(-2)
    };
    let whole = correlation(0);
    let count = R::ratio(differences.into(), 1);
    let mut sum = R::ZERO;
    for lag in 1..=CLUSTERS.saturating_mul(per_cluster) {
        if u64::from(lag) >= differences {
            break;
        }
        let rho = correlation(lag) / whole;
        sum = sum + (R::ONE - R::count(lag) / count) * rho * rho;
    }
    count / (R::ONE + R::TWO * sum)
}

impl<R: Scalar> Term<R> {
    /// The same term of magnitude 1.
    fn unit(self) -> Self {
        let one = R::ONE;
        match self {
            Self::Quantization(_) => Self::Quantization(one),
            Self::White(_) => Self::White(one),
            Self::Flicker(_) => Self::Flicker(one),
            Self::RandomWalk(_) => Self::RandomWalk(one),
            Self::Ramp(_) => Self::Ramp(one),
            Self::GaussMarkov { correlation_s, .. } => {
                Self::GaussMarkov { rms: one, correlation_s }
            }
        }
    }
}
