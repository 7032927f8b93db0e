//! Covariance and estimates together: a step, a measurement, and its feedback.
//!
//! ```
//! use schuler::aiding::filter::Filter;
//! use schuler::aiding::model::Model;
//! use schuler::aiding::states::Process;
//! use schuler::aiding::transition::{Stretch, Transition};
//!
//! let model = Model::new(1e-6_f64, 1e-4, Process::constant(1e-7), Process::constant(1e-3));
//! let mut filter = Filter::<f64, 15, 120, 0>::new(&model);
//! // After 10 s an accelerometer bias of 1 mm/s² has grown to 1 cm/s.
//! filter.advance(&model, &Transition::new(&Stretch { time_s: 10.0, ..Stretch::NONE }));
//! assert!((filter.covariance().sigma(3) - 1e-2).abs() < 1e-5);
//! ```

use super::covariance::ud::Ud;
use super::gate::{Judged, Rows};
use super::model::{ACCELEROMETER_BIAS, BIAS_EVERY_S, FIRST_EXTRA, GYRO_BIAS, Model};
use super::surroundings::Pose;
use super::transition::Transition;
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::sample::Increment;
use crate::strapdown::plausible::Damaged;

/// State of a filter with `N` = 15 + `E` states, whose covariance takes `P` = N(N + 1)/2 numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Filter<R, const N: usize, const P: usize, const E: usize> {
    pub(super) ud: Ud<R, N, P>,
    /// Estimates, rad/s and m/s².
    pub(super) gyro_bias: Vector<Pair<R>>,
    pub(super) accelerometer_bias: Vector<Pair<R>>,
    pub(super) extras: [R; E],
    /// Since the last noise of the biases, s.
    since_s: R,
}

/// Nine navigation errors and six biases.
pub type Filter15<R> = Filter<R, 15, 120, 0>;
/// The same with six further states.
pub type Filter21<R> = Filter<R, 21, 231, 6>;

/// By what biases and further states have faded at the end of a step, beside Φ.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fading<R, const E: usize> {
    /// Of the gyros' biases, and of the accelerometers'.
    pub biases: [R; 2],
    /// Of each further state; 1 for those of a resonator, which has a matrix of its own.
    pub extras: [R; E],
}

impl<R: Real, const E: usize> Fading<R, E> {
    /// Nothing has faded.
    pub const NONE: Self = Self { biases: [R::ONE; 2], extras: [R::ONE; E] };
}

impl<R: Record, const E: usize> Record for Fading<R, E> {
    record!(biases, extras);
}

impl<R: Real, const N: usize, const P: usize, const E: usize> Filter<R, N, P, E> {
    /// The compiler stops at a wrong size.
    const FITS: () = assert!(N == FIRST_EXTRA + E, "a filter has 15 states and its further ones");

    /// Biases and further states with their standard deviations at the start; position, velocity and attitude
    /// known exactly. States beyond those of the model stay exactly 0; groups that do not fit are left out.
    pub fn new(model: &Model<R>) -> Self {
        let () = Self::FITS;
        let mut sigmas = [R::ZERO; N];
        for (state, sigma) in sigmas.iter_mut().enumerate().skip(GYRO_BIAS) {
            *sigma = if state < ACCELEROMETER_BIAS {
                model.gyro_bias.sigma()
            } else if state < FIRST_EXTRA {
                model.accelerometer_bias.sigma()
            } else {
                let own = |(first, extra): (usize, &super::states::Extra<R>)| {
                    let at = state.checked_sub(first)?;
                    (at < extra.states()).then(|| extra.sigma(at))
                };
                model.extras().find_map(own).unwrap_or(R::ZERO)
            };
        }
        Self {
            ud: Ud::diagonal(sigmas),
            gyro_bias: Vector::new(Pair::default(), Pair::default(), Pair::default()),
            accelerometer_bias: Vector::new(Pair::default(), Pair::default(), Pair::default()),
            extras: [R::ZERO; E],
            since_s: R::ZERO,
        }
    }

    /// Adds an uncertainty in north, east and down to the error vector of body axes that begins at a state:
    /// 0 position, 3 velocity, 6 attitude.
    pub fn add_uncertainty(&mut self, first: usize, sigma_ned: Vector<R>, pose: &Pose<R>) {
        for (axis, sigma) in pose.body_to_ned.rows.into_iter().zip(sigma_ned.into_array()) {
            let mut along = [R::ZERO; N];
            for (cell, x) in along.iter_mut().skip(first).zip(axis.into_array()) {
                *cell = x;
            }
            self.ud.add_rank_one_to(first + 3, sigma * sigma, along);
        }
    }

    /// Carries covariance and estimates on over a step. The result says by what biases and further states have
    /// faded at its end.
    pub fn advance(&mut self, model: &Model<R>, transition: &Transition<R>) -> Fading<R, E> {
        self.ud.propagate(transition, &model.noise);
        let mut fading = Fading::NONE;
        for (first, extra) in model.extras() {
            let at = first - FIRST_EXTRA;
            if let Some(estimate) = self.extras.get_mut(at..at + extra.states()) {
                let factor = extra.advance(&mut self.ud, first, estimate, transition);
                for slot in fading.extras.iter_mut().skip(at).take(extra.states()) {
                    *slot = factor;
                }
            }
        }
        self.since_s = self.since_s + transition.time_s();
        // A thousandth for steps that rounding ends early.
        if R::any(R::of(BIAS_EVERY_S * 0.999).less(self.since_s)) {
            fading.biases = self.drift(model);
        }
        fading
    }

    /// The noise of the biases, for the time since the last one; the result is their factors.
    fn drift(&mut self, model: &Model<R>) -> [R; 2] {
        let time_s = core::mem::replace(&mut self.since_s, R::ZERO);
        let (gyro, force) = (&mut self.gyro_bias, &mut self.accelerometer_bias);
        let groups = [
            (GYRO_BIAS, model.gyro_bias, gyro),
            (ACCELEROMETER_BIAS, model.accelerometer_bias, force),
        ];
        groups.map(|(first, process, bias)| {
            let mut factor = R::ONE;
            for (axis, bias) in bias.each_mut().into_iter().enumerate() {
                factor = process.advance(&mut self.ud, first + axis, time_s);
                if let super::states::Process::GaussMarkov(_) = process {
                    *bias = *bias * Pair::new(factor);
                }
            }
            factor
        })
    }

    /// Takes a vector of measurements, or refuses it as a whole if its NIS exceeds the limit: then every bit of the
    /// state stays. The result has the estimated errors, which are to be [fed back](Self::feed).
    pub fn measure<const M: usize>(&mut self, rows: &Rows<R, N, M>, limit: R) -> Judged<R, N> {
        let before = self.ud;
        let judged = super::gate::judge(&mut self.ud, rows, limit);
        self.ud.revert_unless(judged.accepted, &before);
        judged
    }

    /// A sample without the estimated biases; `interval_s` is its interval.
    #[inline]
    pub fn without_biases(&self, sample: &Increment<R>, interval_s: R) -> Increment<R> {
        let less = |x: R, bias: Pair<R>| x - bias.hi * interval_s;
        Increment {
            angle_b: sample.angle_b.zip(self.gyro_bias, less),
            velocity_b: sample.velocity_b.zip(self.accelerometer_bias, less),
        }
    }

    /// The covariance of the errors.
    pub fn covariance(&self) -> &Ud<R, N, P> {
        &self.ud
    }

    /// The standard deviation of the attitude about an axis of the body, rad.
    pub fn sigma_about(&self, axis_b: Vector<R>) -> R {
        let mut h = [R::ZERO; N];
        for (cell, x) in h.iter_mut().skip(6).zip(axis_b.into_array()) {
            *cell = x;
        }
        self.ud.variance_of(&h).sqrt()
    }

    /// The covariance, to write.
    pub fn covariance_mut(&mut self) -> &mut Ud<R, N, P> {
        &mut self.ud
    }

    /// Estimated gyro biases, rad/s.
    pub fn gyro_bias(&self) -> Vector<R> {
        self.gyro_bias.map(|c| c.hi)
    }

    /// Estimated accelerometer biases, m/s².
    pub fn accelerometer_bias(&self) -> Vector<R> {
        self.accelerometer_bias.map(|c| c.hi)
    }

    /// Estimates of the further states.
    pub fn extras(&self) -> &[R; E] {
        &self.extras
    }

    /// Checks a state that was restored.
    ///
    /// # Errors
    ///
    /// [`Damaged`] if a number is not finite, or a D negative.
    pub fn check(&self) -> Result<(), Damaged> {
        let most = R::of(1e6);
        let pair =
            |v: Vector<Pair<R>>| v.map(|c| c.hi).is_within(most) && v.map(|c| c.lo).is_within(most);
        let sound = self.ud.is_plausible()
            && pair(self.gyro_bias)
            && pair(self.accelerometer_bias)
            && self.extras.iter().all(|x| x.is_within(most))
            && self.since_s.is_within(R::of(1e3));
        if sound { Ok(()) } else { Err(Damaged) }
    }
}

impl<R: Record, const N: usize, const P: usize, const E: usize> Record for Filter<R, N, P, E> {
    record!(ud, gyro_bias, accelerometer_bias, extras, since_s);
}
