//! One run's alignment: samples in, attitude and biases out.

use crate::scene::Alignment;
use crate::scene::alignment::BLOCK;
use crate::source::Source;
use schuler::aiding::alignment::aligned::Aligned;
use schuler::aiding::alignment::fine::{Fine, FineState};
use schuler::aiding::alignment::settings::Settings;
use schuler::aiding::alignment::verdict::AlignmentFault;
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::navigators::Navigator4;
use schuler::noise::Stream;
use schuler::sample::Increment;
use schuler::solution::{Euler, Solution};

/// An alignment with any number of states.
pub(super) trait Aligns: Send {
    fn push(&mut self, sample: &Increment<f64>) -> Result<(), AlignmentFault>;
    fn measure_velocity(
        &mut self,
        ned: Vector<f64>,
        sigma_m_s: f64,
    ) -> Result<bool, AlignmentFault>;
    /// What it has found; `None` as long as no attitude is known.
    fn aligned(&self) -> Option<Aligned<f64>>;
    fn covariance(&self) -> [[f64; 3]; 3];
    fn solution(&self) -> Solution<f64>;
}

/// One with its state.
pub(super) struct Running<const N: usize, const P: usize, const E: usize> {
    fine: Fine<Navigator4<f64>, N, P, E>,
    state: FineState<Navigator4<f64>, N, P, E>,
}

impl<const N: usize, const P: usize, const E: usize> Running<N, P, E> {
    pub fn new(
        navigator: Navigator4<f64>,
        interval: Pair<f64>,
        place: Geodetic<f64>,
        settings: Settings<f64>,
        first: Euler<f64>,
    ) -> Result<Self, AlignmentFault> {
        let fine = Fine::new(navigator, interval, &place, settings)?;
        let state = fine.start(first)?;
        Ok(Self { fine, state })
    }
}

impl<const N: usize, const P: usize, const E: usize> Aligns for Running<N, P, E> {
    fn push(&mut self, sample: &Increment<f64>) -> Result<(), AlignmentFault> {
        self.fine.push(&mut self.state, *sample)
    }

    fn measure_velocity(
        &mut self,
        ned: Vector<f64>,
        sigma_m_s: f64,
    ) -> Result<bool, AlignmentFault> {
        self.fine.measure_velocity(&mut self.state, ned, sigma_m_s)
    }

    fn aligned(&self) -> Option<Aligned<f64>> {
        Some(self.fine.aligned(&self.state))
    }

    fn covariance(&self) -> [[f64; 3]; 3] {
        self.fine.attitude_covariance(&self.state)
    }

    fn solution(&self) -> Solution<f64> {
        self.fine.solution(&self.state)
    }
}

/// Velocities that are measured on the way.
struct Velocities {
    noise: [Stream; 3],
    sigma_m_s: f64,
    /// Samples from one to the next.
    every: f64,
    measured: u64,
}

/// A running alignment of a scene.
pub struct Aligner<'a> {
    running: Box<dyn Aligns>,
    source: &'a Source,
    velocities: Option<Velocities>,
    taken: u64,
    samples: u64,
}

impl<'a> Aligner<'a> {
    pub(super) fn new(
        running: Box<dyn Aligns>,
        source: &'a Source,
        samples: u64,
        alignment: &Alignment,
        noise: Option<[Stream; 3]>,
    ) -> Self {
        let velocities = noise.map(|noise| Velocities {
            noise,
            sigma_m_s: alignment.velocity_sigma_m_s,
            every: alignment.velocity_interval_s * source.rate_hz(),
            measured: 0,
        });
        Self { running, source, velocities, taken: 0, samples }
    }

    /// Takes a sample.
    pub fn push(&mut self, sample: &Increment<f64>) -> Result<(), AlignmentFault> {
        self.running.push(sample)?;
        self.taken += 1;
        let Some(velocities) = &mut self.velocities else { return Ok(()) };
        // The navigator stands at a block's end there.
        let due = (velocities.measured + 1) as f64 * velocities.every;
        if self.taken.is_multiple_of(BLOCK) && self.taken as f64 >= due {
            velocities.measured += 1;
            let truth = self.source.truth(self.taken).velocity_ned.map(|v| v.hi);
            let [north, east, down] =
                velocities.noise.each_mut().map(|stream| stream.normal::<f64>());
            let sigma = velocities.sigma_m_s;
            let measured = truth + Vector::new(north, east, down) * sigma;
            self.running.measure_velocity(measured, sigma)?;
        }
        Ok(())
    }

    /// Whether it has taken all of its samples.
    pub fn is_done(&self) -> bool {
        self.taken >= self.samples
    }

    /// What it has found so far; `None` as long as no attitude is known.
    pub fn aligned(&self) -> Option<Aligned<f64>> {
        self.running.aligned()
    }

    /// The covariance of the attitude as a rotation vector in north, east, down, rad².
    pub fn covariance(&self) -> [[f64; 3]; 3] {
        self.running.covariance()
    }

    /// Its navigator's solution.
    pub fn solution(&self) -> Solution<f64> {
        self.running.solution()
    }

    /// Samples that its solution has integrated.
    pub fn integrated(&self) -> u64 {
        self.taken - self.taken % BLOCK
    }
}
