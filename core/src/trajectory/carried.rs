//! A unit off the reference point of a path, and shaken: a lever arm and harmonic vibration on any motion.
//!
//! The path is that of a vehicle's reference point. The unit sits at a lever arm from it in the vehicle's axes;
//! vibration turns it and moves it there. Source: rigid-body kinematics, Goldstein, Classical Mechanics, ch. 4.
//!
//! ```
//! use schuler::math::compensated::Pair;
//! use schuler::math::vector::Vector;
//! use schuler::trajectory::Trajectory as _;
//! use schuler::trajectory::carried::{Carried, Mount};
//! use schuler::trajectory::harmonic::{Channel, Channels, HarmonicTrajectory};
//!
//! // A turntable at 1 rad/s, and a unit 2 m in front of its axis.
//! let still = Channel::constant(0.0);
//! let table = HarmonicTrajectory::<f64, 1>::new(Channels {
//!     roll: still,
//!     pitch: still,
//!     yaw: Channel::steady(0.0, 1.0),
//!     latitude: Channel::constant(0.8),
//!     longitude: still,
//!     altitude: Channel::constant(100.0),
//! })?;
//! let mount = Mount::<1>::rigid(Vector::new(2.0, 0.0, 0.0));
//! let unit = Carried::new(table, mount);
//! // It is pulled towards the axis by ω²r.
//! let force = unit.rates_at(Pair::new(3.0)).specific_force_b;
//! assert!((force.x + 2.0).abs() < 1e-3);
//! # Ok::<(), schuler::trajectory::harmonic::CourseError>(())
//! ```

use super::displaced::displaced;
use super::geographic::State;
use super::harmonic::HarmonicTrajectory;
use super::kinematics::{Kinematics, euler_rates, to_body};
use super::{Bound, Jet, Motion, Trajectory, geographic};
use crate::math::compensated::Pair;
use crate::math::vector::Vector;
use crate::sample::Rates;
use crate::solution::{Euler, Solution};

/// Where a unit sits in its vehicle, with room for `N` harmonics of its vibration.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mount<const N: usize> {
    /// From the reference point of the path to the unit, in the vehicle's axes, m.
    pub lever_arm_b: Vector<f64>,
    /// Roll, pitch and yaw of the unit in the vehicle, rad.
    pub turning: Option<HarmonicTrajectory<f64, N>>,
    /// What is added to the lever arm, m: forward, right, down in the channels roll, pitch, yaw.
    pub moving: Option<HarmonicTrajectory<f64, N>>,
}

impl<const N: usize> Mount<N> {
    /// A lever arm without vibration.
    pub fn rigid(lever_arm_b: Vector<f64>) -> Self {
        Self { lever_arm_b, turning: None, moving: None }
    }
}

/// A path with a unit that it carries.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Carried<T, const N: usize> {
    path: T,
    mount: Mount<N>,
}

/// The first three channels of a motion, their rates and their accelerations.
fn channels(motion: &Motion<f64>) -> [Vector<f64>; 3] {
    let Motion { roll, pitch, yaw, .. } = *motion;
    let of = |f: fn(Jet<f64>) -> f64| Vector::new(f(roll), f(pitch), f(yaw));
    [of(|jet| jet.value), of(|jet| jet.first), of(|jet| jet.second)]
}

impl<T: Trajectory<f64>, const N: usize> Carried<T, N> {
    /// Of a path and a mount.
    pub fn new(path: T, mount: Mount<N>) -> Self {
        Self { path, mount }
    }

    /// The path of the reference point.
    pub fn path(&self) -> &T {
        &self.path
    }

    fn unit(&self, time_s: Pair<f64>) -> Kinematics {
        let vehicle = self.path.kinematics_at(time_s);
        let [moved, speed, acceleration] = match &self.mount.moving {
            Some(moving) => channels(&moving.at_instant(time_s)),
            None => [Vector::ZERO; 3],
        };
        // r' = r + Rδ,  ṙ' = ṙ + R(ω × δ + δ̇),  r̈' = r̈ + R(ω × (ω × δ) + α × δ + 2ω × δ̇ + δ̈)
        let delta = self.mount.lever_arm_b + moved;
        let (rate, change) = (vehicle.rate_eb_b, vehicle.angular_acceleration_b);
        let to_earth = |v: Vector<f64>| to_body(vehicle.attitude.conjugate(), v);
        let swept = rate.cross(delta);
        let velocity_e = vehicle.velocity_e + to_earth(swept + speed);
        let acceleration_e = vehicle.acceleration_e
            + to_earth(
                rate.cross(swept) + change.cross(delta) + rate.cross(speed) * 2.0 + acceleration,
            );
        let (normal_e, altitude) = displaced(vehicle.normal_e, vehicle.altitude, to_earth(delta));
        let mut unit = Kinematics { normal_e, altitude, velocity_e, acceleration_e, ..vehicle };
        if let Some(turning) = &self.mount.turning {
            let [angle, first, second] = channels(&turning.at_instant(time_s));
            let euler = Euler { roll: angle.x, pitch: angle.y, yaw: angle.z };
            let turned = euler.quaternion();
            let (own, own_change) = euler_rates(euler, first, second);
            // ω' = Cᵀω + ω_v,  α' = Cᵀα + α_v − ω_v × Cᵀω
            let carried = to_body(turned, rate);
            unit.attitude = vehicle.attitude * turned;
            unit.rate_eb_b = carried + own;
            unit.angular_acceleration_b = to_body(turned, change) + own_change - own.cross(carried);
        }
        unit
    }
}

impl<T: Trajectory<f64>, const N: usize> Trajectory<f64> for Carried<T, N> {
    fn at_instant(&self, time_s: Pair<f64>) -> Motion<f64> {
        let unit = self.unit(time_s);
        let climb = unit.velocity_e.dot(unit.normal_e);
        geographic::motion(&unit, climb, geographic::climb_change(&unit))
    }

    fn rates_at(&self, time_s: Pair<f64>) -> Rates<f64> {
        self.unit(time_s).rates()
    }

    fn kinematics_at(&self, time_s: Pair<f64>) -> Kinematics {
        self.unit(time_s)
    }

    fn solution_at(&self, time_s: Pair<f64>) -> Solution<f64> {
        geographic::solution(&State::from(&self.unit(time_s)))
    }

    fn initial_at(&self, time_s: Pair<f64>) -> Solution<f64> {
        geographic::initial(&State::from(&self.unit(time_s)))
    }

    fn joint_after(&self, time_s: f64) -> Option<f64> {
        self.path.joint_after(time_s)
    }

    fn bound(&self) -> Bound<f64> {
        let path = self.path.bound();
        let of = |harmonics: &Option<HarmonicTrajectory<f64, N>>| {
            harmonics.as_ref().map_or(Bound::default(), |h| h.bound())
        };
        let (turning, moving) = (of(&self.mount.turning), of(&self.mount.moving));
        let fastest = |a: f64, b: f64| if a > b { a } else { b };
        Bound {
            bandwidth: path.bandwidth
                + fastest(turning.bandwidth, moving.bandwidth)
                + if self.mount.lever_arm_b == Vector::ZERO { 0.0 } else { path.bandwidth },
            angular_rate: path.angular_rate + turning.angular_rate,
        }
    }
}
