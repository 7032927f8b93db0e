//! The input to a scene's theory: the true motion and the sources of error.

use super::sources::{SENSORS, Sources, unit};
use super::steps;
use crate::course;
use crate::scene::{InitialError, Scene, Vertical};
use schuler::drift::compare::Drift;
use schuler::drift::linear::{ErrorDynamics, ErrorState};
use schuler::drift::meridian::MeridianShift;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::sample::Rates;
use schuler::trajectory::harmonic::CourseError;
use schuler::trajectory::{Motion, Trajectory};

/// The longest step, s: 1/400 of Schuler's period over 2π, for a rule of fourth order.
const LONGEST_STEP_S: f64 = 2.0;
/// The largest turn of the body in a step, rad.
const LARGEST_TURN: f64 = 0.2;

/// The fastest turn of north, rad/s, that is followed: at 250 m/s that is 250 m from a pole.
const FASTEST_MERIDIAN: f64 = 1.0;
/// Instants at which a path's meridians are looked at.
const LOOKS: u32 = 4096;

/// A symmetric matrix over position, velocity and attitude, north, east and down of each.
pub type Covariance = [[f64; 9]; 9];

/// A scene, as theory sees it.
#[derive(Clone, Debug)]
pub struct Course {
    trajectory: course::Course,
    pub sources: Sources,
    vertical_held: bool,
    /// Whether there is a covariance at all.
    pub random: bool,
    /// Sensors whose steps are coarse against what they should read.
    pub coarse: [bool; SENSORS],
    /// Whether there is nothing to expect but zero.
    pub quiet: bool,
    /// Whether the path passes a pole so closely that its meridians turn too fast to be followed.
    pub over_a_pole: bool,
    /// The longest step that resolves the motion, s.
    pub longest_step_s: f64,
    /// The mean error at the start.
    pub initial: ErrorState<f64>,
    /// Its covariance.
    pub initial_covariance: Covariance,
}

/// The motion and its error dynamics at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Instant {
    pub time_s: f64,
    pub motion: Motion<f64>,
    /// What the sensors read too much on average.
    pub systematic: Rates<f64>,
    pub dynamics: ErrorDynamics<f64>,
}

impl Course {
    /// Of a scene.
    pub fn new(scene: &Scene) -> Result<Self, CourseError> {
        let trajectory = scene.trajectory.build()?;
        let sources = Sources::new(scene);
        let initial = &scene.initial_error;
        let random = sources.are_random() || initial.is_random();
        let mut drift = Drift {
            position_ned: initial.position_m.into(),
            velocity_ned: initial.velocity_m_s.into(),
            attitude_ned: initial.attitude_rad.into(),
        };
        let vertical_held = scene.navigator.vertical == Vertical::Held;
        if vertical_held {
            (drift.position_ned.z, drift.velocity_ned.z) = (0.0, 0.0);
        }
        let shift = MeridianShift::new(&trajectory.at(0.0));
        let quiet = !random && !sources.are_systematic() && drift == Drift::default();
        // Harmonic latitudes run on over a pole, and their north with them; that of a path turns round.
        let turning = match trajectory.path() {
            Some(_) if !quiet => meridians(&trajectory, scene.duration_s),
            _ => 0.0,
        };
        let coarse = steps::coarse(&trajectory, &sources, scene.duration_s);
        let bound = trajectory.bound();
        Ok(Self {
            random,
            coarse,
            quiet,
            over_a_pole: turning > FASTEST_MERIDIAN,
            longest_step_s: LONGEST_STEP_S
                .min(LARGEST_TURN / bound.angular_rate.max(turning))
                .min(bound.bandwidth.recip()),
            initial: shift.error(&drift),
            initial_covariance: scattered(&shift, initial, vertical_held),
            trajectory,
            sources,
            vertical_held,
        })
    }

    /// At a time, s.
    pub fn instant(&self, time_s: f64) -> Instant {
        let motion = self.trajectory.at(time_s);
        let rates = self.trajectory.rates_at(Pair::new(time_s));
        let dynamics = ErrorDynamics::new(&motion, &rates, self.vertical_held);
        let earlier =
            |seconds: f64| self.trajectory.rates_at(Pair::new((time_s - seconds).max(0.0)));
        let systematic = self.sources.systematic(&rates, time_s, &earlier);
        Instant { time_s, motion, systematic, dynamics }
    }

    /// Mean and covariance of the drift, from those of the error.
    pub fn drift(
        &self,
        at: &Instant,
        mean: &ErrorState<f64>,
        covariance: &Covariance,
    ) -> (Drift, Covariance) {
        let shift = MeridianShift::new(&at.motion);
        let drift = |x: &ErrorState<f64>| {
            let mut drift = shift.drift(x);
            if self.vertical_held {
                (drift.position_ned.z, drift.velocity_ned.z) = (0.0, 0.0);
            }
            drift
        };
        let mean = drift(mean);
        if !self.random {
            return (mean, Covariance::default());
        }
        // The rounding of quantized increments: Q² G Gᵀ on top of P.
        let mut total = *covariance;
        for (sensor, q2) in self.sources.quantization.into_iter().enumerate() {
            if q2 != 0.0 && at.time_s > 0.0 {
                let direct = at.dynamics.drive(&unit(sensor)).into_array();
                for (row, a) in total.iter_mut().zip(direct) {
                    for (entry, b) in row.iter_mut().zip(direct) {
                        *entry += q2 * a * b;
                    }
                }
            }
        }
        // M P Mᵀ = M(M P)ᵀ: P is symmetric
        let rows = total.map(|row| array(drift(&row.into())));
        let columns = std::array::from_fn::<[f64; 9], 9, _>(|i| rows.map(|row| row[i]));
        (mean, columns.map(|column| array(drift(&column.into()))))
    }
}

/// The covariance of the error at the start: of independent drifts with the σ of the scene.
fn scattered(
    shift: &MeridianShift<f64>,
    initial: &InitialError,
    vertical_held: bool,
) -> Covariance {
    let sigmas: [[f64; 3]; 3] =
        [initial.position_sigma_m, initial.velocity_sigma_m_s, initial.attitude_sigma_rad];
    let mut covariance = Covariance::default();
    for component in 0..9 {
        let sigma = sigmas[component / 3][component % 3];
        let is_held = vertical_held && [2, 5].contains(&component);
        if sigma == 0.0 || is_held {
            continue;
        }
        let [position, velocity, attitude] = std::array::from_fn(|group| {
            let at = |axis| if 3 * group + axis == component { sigma } else { 0.0 };
            Vector::new(at(0), at(1), at(2))
        });
        let drift =
            Drift { position_ned: position, velocity_ned: velocity, attitude_ned: attitude };
        // P₀ = Σ σᵢ² eᵢeᵢᵀ, eᵢ the error that belongs to a unit of the drift's component i
        let error = shift.error(&drift).into_array();
        for (row, a) in covariance.iter_mut().zip(error) {
            for (entry, b) in row.iter_mut().zip(error) {
                *entry += a * b;
            }
        }
    }
    covariance
}

/// How fast north turns about the vertical along a path, at most, rad/s; infinite at a pole.
fn meridians(trajectory: &impl Trajectory<f64>, duration_s: f64) -> f64 {
    (0..=LOOKS)
        .map(|look| {
            let motion = trajectory.at(duration_s * f64::from(look) / f64::from(LOOKS));
            // ω_enⁿ about down: −λ̇ sinφ
            let rate = (motion.longitude.first * motion.latitude.value.sin()).abs();
            if rate.is_nan() { f64::INFINITY } else { rate }
        })
        .fold(0.0, f64::max)
}

/// Position, velocity, attitude; north, east, down of each.
pub fn array(drift: Drift) -> [f64; 9] {
    let Drift { position_ned: position, velocity_ned: velocity, attitude_ned: attitude } = drift;
    ErrorState { position, velocity, attitude }.into_array()
}
