//! The drift of a scene by the linear error model: mean and covariance.
//!
//! Along the true motion, small errors obey ẋ = F x + G u (`schuler::drift::linear`). Systematic
//! sensor errors and initial errors determine the mean, random ones the covariance. The linear model does
//! not include saturation, samples lost or late on the link, quantization so coarse that the signal does not
//! cross several steps per sample, and errors that are too large. A bandwidth acts on the motion and on noise; latency
//! on the motion alone, since noise arises behind it. Their products with other errors are small, and left out.
//! [`Theory::outside`] tells when the model no longer applies.

mod bias;
mod course;
mod lag;
mod limits;
mod march;
mod moments;
mod sources;
mod steps;

pub use course::Covariance;
pub use limits::Outside;

use crate::scene::Scene;
use course::{Course, array};
use march::{March, NODES};
use schuler::drift::compare::Drift;
use schuler::drift::linear::ErrorState;
use schuler::earth::SEMI_MAJOR_AXIS;
use schuler::math::vector::Vector;
use schuler::trajectory::harmonic::CourseError;

/// Closer to the Earth's axis than so many times the step's motion or the error, each time is worked
/// out for itself.
const POLAR_DISTANCE: f64 = 20.0;

/// The drift to be expected at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Expected {
    /// Its mean, m, m/s, rad.
    pub mean: Drift,
    /// Its standard deviation, m, m/s, rad.
    pub sigma: Drift,
}

impl Expected {
    /// Where the linear model has ended.
    pub const UNKNOWN: Self = {
        let vector = Vector::new(f64::NAN, f64::NAN, f64::NAN);
        let drift = Drift { position_ned: vector, velocity_ned: vector, attitude_ned: vector };
        Self { mean: drift, sigma: drift }
    };
}

/// Mean and covariance of a scene's drift, at times that increase.
#[derive(Clone)]
pub struct Theory {
    course: Course,
    march: March,
    /// What ends the model in the current step or before it; large errors do not become small again.
    outside: Option<Outside>,
    /// What second-order terms may come to beside what is expected.
    share: f64,
    /// What ends it from the start on.
    always: Option<Outside>,
    /// Coefficients of mean and variance over the current step; `None` next to a pole.
    cubic: Option<[[f64; NODES]; 18]>,
}

impl Theory {
    /// Of a scene.
    pub fn new(scene: &Scene) -> Result<Self, CourseError> {
        let course = Course::new(scene)?;
        let march = March::new(&course);
        let always = if course.over_a_pole {
            Some(Outside::Pole)
        } else if scene.alignment.is_some() {
            Some(Outside::Aligned)
        } else {
            (scene.link.jitter_s > 0.0).then_some(Outside::Jitter)
        };
        let mut theory =
            Self { course, march, outside: None, share: limits::SHARE, always, cubic: None };
        theory.look();
        Ok(theory)
    }

    /// To be compared with the mean of so many runs, which shows smaller errors of the mean.
    pub fn for_runs(self, runs: u64) -> Self {
        Self { share: limits::SHARE.min((runs as f64).sqrt().recip()), ..self }
    }

    /// Which of the drift's nine numbers the neglected terms shift by too much of their σ about a time, s.
    pub fn shifted(&mut self, time_s: f64) -> [bool; 9] {
        if self.course.quiet {
            return [false; 9];
        }
        self.reach(time_s);
        limits::shifted(self.march.end(), self.share)
    }

    /// What the linear model does not know of the scene up to a time, s. Times as for [`Theory::at`].
    pub fn outside(&mut self, time_s: f64) -> Option<Outside> {
        if self.always.is_some() || self.course.quiet {
            return self.always;
        }
        self.reach(time_s);
        self.outside
    }

    /// What is expected at a time, s. Cheap while times increase; an earlier one starts anew.
    pub fn at(&mut self, time_s: f64) -> Expected {
        if self.course.quiet {
            return Expected::default();
        }
        self.reach(time_s);
        let moments = match &self.cubic {
            Some(cubic) => {
                let s = (time_s - self.march.start_s) / self.march.step_s;
                cubic.map(|[a, b, c, d]| a + s * (b + s * (c + s * d)))
            }
            None => self.moments_at(time_s),
        };
        let drift = |x: [f64; 9]| {
            let ErrorState { position, velocity, attitude } = x.into();
            Drift { position_ned: position, velocity_ned: velocity, attitude_ned: attitude }
        };
        Expected {
            mean: drift(std::array::from_fn(|i| moments[i])),
            sigma: drift(std::array::from_fn(|i| moments[9 + i].max(0.0).sqrt())),
        }
    }

    /// The covariance of the drift at a time, s: position, velocity, attitude, north, east and down
    /// of each, in m, m/s, rad. Times as for [`Theory::at`].
    pub fn covariance(&mut self, time_s: f64) -> Covariance {
        if self.course.quiet {
            return Covariance::default();
        }
        self.reach(time_s);
        let (mean, covariance) = self.march.error_at(time_s);
        self.course.drift(&self.course.instant(time_s), &mean, &covariance).1
    }

    /// Whether the scene's drift is expected to be exactly zero: then nothing is integrated.
    pub fn is_zero(&self) -> bool {
        self.course.quiet
    }

    /// Steps until a time lies within the current step.
    fn reach(&mut self, time_s: f64) {
        if time_s < self.march.start_s {
            (self.march, self.cubic) = (March::new(&self.course), None);
            self.outside = None;
            self.look();
        }
        while time_s > self.march.end_s() {
            self.march.step(&self.course);
            self.cubic = None;
            self.look();
            if time_s <= self.march.end_s() {
                self.cubic = self.fit();
            }
        }
    }

    /// Looks whether the model holds to the end of the current step.
    fn look(&mut self) {
        let steps = |outside: &Outside| {
            matches!(outside, Outside::GyroStep(_) | Outside::AccelerometerStep(_))
        };
        let Self { course, march, share, .. } = self;
        let (sources, end_s) = (&course.sources, march.end_s());
        let found = limits::outside(march.end(), sources, &course.coarse, end_s, *share);
        // Beside errors that grow, steps are forgotten.
        let left = self.outside.filter(|outside| !steps(outside));
        self.outside = found.filter(|found| left.is_none() || !steps(found)).or(left);
    }

    /// Mean and variance of the drift's nine numbers, from the error at a time within the step.
    fn moments_at(&self, time_s: f64) -> [f64; 18] {
        self.moments(&self.course.instant(time_s))
    }

    fn moments(&self, at: &course::Instant) -> [f64; 18] {
        let (mean, covariance) = self.march.error_at(at.time_s);
        let (mean, covariance) = self.course.drift(at, &mean, &covariance);
        let mean = array(mean);
        std::array::from_fn(|i| if i < 9 { mean[i] } else { covariance[i - 9][i - 9] })
    }

    /// The cubics through the values at the step's nodes; none where they would bend too much.
    fn fit(&self) -> Option<[[f64; NODES]; 18]> {
        let nodes = &self.march.nodes;
        let values = nodes.map(|node| self.moments(&node));
        let near_pole = |node: &course::Instant, moments: &[f64; 18]| {
            let travel = node.motion.velocity_ned().norm() * self.march.step_s;
            let [north, east] = [moments[0], moments[1]];
            let horizontal = (north * north + east * east + moments[9] + moments[10]).sqrt();
            let axis_distance = SEMI_MAJOR_AXIS * node.motion.latitude.value.cos().abs();
            axis_distance < POLAR_DISTANCE * travel.max(horizontal)
        };
        if nodes.iter().zip(&values).any(|(node, moments)| near_pole(node, moments)) {
            return None;
        }
        Some(std::array::from_fn(|i| {
            let [a, b, c, d] = values.map(|node| node[i]);
            [
                a,
                (-11.0 * a + 18.0 * b - 9.0 * c + 2.0 * d) / 2.0,
                (18.0 * a - 45.0 * b + 36.0 * c - 9.0 * d) / 2.0,
                (-9.0 * a + 27.0 * b - 27.0 * c + 9.0 * d) / 2.0,
            ]
        }))
    }
}
