//! Measurements of aiding sensors.
//!
//! ```
//! use schuler::aiding::aided::instant::Instant;
//! use schuler::aiding::aided::measured::{Measured, Sensor};
//! use schuler::earth::Geodetic;
//! use schuler::math::compensated::Pair;
//! use schuler::math::vector::Vector;
//!
//! let place = Geodetic { latitude: 0.8, longitude: 0.1, altitude: 30.0 }.map(Pair::<f64>::of);
//! let fix = Measured::position(Instant::of_sample(100), place, Vector::new(1.0, 1.0, 2.0));
//! assert_eq!((fix.sensor(), fix.degrees()), (Sensor::Gnss, 3));
//! ```

use super::fault::AidedFault;
use super::instant::Instant;
use crate::earth::Geodetic;
use crate::math::compensated::Pair;
use crate::math::real::Scalar;
use crate::math::vector::Vector;
use crate::record::{Record, record};

/// The largest standard deviation, m and m/s.
const MOST_SIGMA: f64 = 1e6;
/// The largest velocity, m/s.
const MOST_VELOCITY: f64 = 1e5;
/// The largest height above and below the ellipsoid, m.
const MOST_ALTITUDE: f64 = 1e6;

/// What is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u32)]
pub enum Kind {
    /// The position of the antenna.
    #[default]
    Position,
    /// The velocity of the antenna.
    Velocity,
    /// Both: one vector, accepted or refused as a whole.
    PositionVelocity,
    /// A height, by a barometer.
    Height,
    /// A speed along the body's first axis, by an odometer.
    Speed,
    /// That the vehicle stands still.
    ZeroVelocity,
    /// That it moves neither to its right nor downwards.
    NonHolonomic,
}

impl Kind {
    /// All of them, in the order of their codes.
    pub const ALL: [Self; 7] = [
        Self::Position,
        Self::Velocity,
        Self::PositionVelocity,
        Self::Height,
        Self::Speed,
        Self::ZeroVelocity,
        Self::NonHolonomic,
    ];

    /// Components of the vector.
    pub const fn degrees(self) -> u32 {
        match self {
            Self::Height | Self::Speed => 1,
            Self::NonHolonomic => 2,
            Self::Position | Self::Velocity | Self::ZeroVelocity => 3,
            Self::PositionVelocity => 6,
        }
    }

    /// The sensor that it comes from.
    pub const fn sensor(self) -> Sensor {
        match self {
            Self::Position | Self::Velocity | Self::PositionVelocity => Sensor::Gnss,
            Self::Height => Sensor::Barometer,
            Self::Speed => Sensor::Odometer,
            Self::ZeroVelocity => Sensor::ZeroVelocity,
            Self::NonHolonomic => Sensor::NonHolonomic,
        }
    }
}

/// Where a measurement comes from. Of the same time they are taken in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Sensor {
    /// A satellite receiver.
    Gnss,
    /// A barometer.
    Barometer,
    /// An odometer.
    Odometer,
    /// A detector of standing still.
    ZeroVelocity,
    /// Wheels.
    NonHolonomic,
}

impl Sensor {
    /// All of them, in their order.
    pub const ALL: [Self; 5] =
        [Self::Gnss, Self::Barometer, Self::Odometer, Self::ZeroVelocity, Self::NonHolonomic];
}

/// A measurement. Numbers that its kind does not have are 0, and their standard deviations 1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Measured<R> {
    /// When it was true; it may arrive later.
    pub at: Instant<R>,
    /// What is measured.
    pub kind: Kind,
    /// Position, rad and m; of a barometer the height alone.
    pub position: Geodetic<Pair<R>>,
    /// Velocity, north, east, down, m/s; of an odometer the speed along the first axis.
    pub velocity: Vector<R>,
    /// Standard deviations of the position, north, east, down, m.
    pub position_sigma: Vector<R>,
    /// Standard deviations of the velocity, m/s.
    pub velocity_sigma: Vector<R>,
}

impl<R: Scalar> Measured<R> {
    /// One of double precision in fewer digits.
    pub fn narrow(measured: &Measured<f64>) -> Self {
        let of = |x: f64| R::narrow(x);
        let Measured { at, kind, position, velocity, position_sigma, velocity_sigma } = *measured;
        Self {
            at: Instant { samples: at.samples, part: of(at.part) },
            kind,
            position: position.map(Pair::narrow),
            velocity: velocity.map(of),
            position_sigma: position_sigma.map(of),
            velocity_sigma: velocity_sigma.map(of),
        }
    }

    /// Without numbers.
    fn of(at: Instant<R>, kind: Kind) -> Self {
        let one = Vector::new(R::ONE, R::ONE, R::ONE);
        let none = Geodetic::default();
        Self {
            at,
            kind,
            position: none,
            velocity: Vector::ZERO,
            position_sigma: one,
            velocity_sigma: one,
        }
    }

    /// A position of the antenna, with its standard deviations to the north, east and down.
    pub fn position(at: Instant<R>, position: Geodetic<Pair<R>>, sigma_ned_m: Vector<R>) -> Self {
        Self { position, position_sigma: sigma_ned_m, ..Self::of(at, Kind::Position) }
    }

    /// A velocity of the antenna relative to the Earth, m/s.
    pub fn velocity(at: Instant<R>, velocity_ned: Vector<R>, sigma_ned: Vector<R>) -> Self {
        Self { velocity: velocity_ned, velocity_sigma: sigma_ned, ..Self::of(at, Kind::Velocity) }
    }

    /// Both.
    pub fn position_velocity(
        at: Instant<R>,
        position: Geodetic<Pair<R>>,
        position_sigma: Vector<R>,
        velocity_ned: Vector<R>,
        velocity_sigma: Vector<R>,
    ) -> Self {
        let velocity = velocity_ned;
        Self {
            at,
            kind: Kind::PositionVelocity,
            position,
            velocity,
            position_sigma,
            velocity_sigma,
        }
    }

    /// A height above the ellipsoid, m.
    pub fn height(at: Instant<R>, altitude: Pair<R>, sigma_m: R) -> Self {
        let mut measured = Self::of(at, Kind::Height);
        measured.position.altitude = altitude;
        measured.position_sigma.z = sigma_m;
        measured
    }

    /// A speed along the body's first axis at the odometer's place, m/s.
    pub fn speed(at: Instant<R>, forward_m_s: R, sigma: R) -> Self {
        let mut measured = Self::of(at, Kind::Speed);
        measured.velocity.x = forward_m_s;
        measured.velocity_sigma.x = sigma;
        measured
    }

    /// That the vehicle stands still, to within a standard deviation per axis, m/s.
    pub fn zero_velocity(at: Instant<R>, sigma: R) -> Self {
        let velocity_sigma = Vector::new(sigma, sigma, sigma);
        Self { velocity_sigma, ..Self::of(at, Kind::ZeroVelocity) }
    }

    /// That the vehicle moves neither to its right nor downwards at the odometer's place, m/s.
    pub fn non_holonomic(at: Instant<R>, sigma: R) -> Self {
        let velocity_sigma = Vector::new(R::ONE, sigma, sigma);
        Self { velocity_sigma, ..Self::of(at, Kind::NonHolonomic) }
    }

    /// Where it comes from.
    pub fn sensor(&self) -> Sensor {
        self.kind.sensor()
    }

    /// Components of the vector.
    pub fn degrees(&self) -> u32 {
        self.kind.degrees()
    }

    /// Whether it can be a measurement.
    pub(super) fn admit(&self) -> Result<(), AidedFault> {
        if !self.at.is_valid() {
            return Err(AidedFault::Time);
        }
        let sigma = |x: R| x > R::ZERO && x.is_within(R::of(MOST_SIGMA));
        let sigmas =
            self.position_sigma.into_array().into_iter().chain(self.velocity_sigma.into_array());
        if !sigmas.into_iter().all(sigma) {
            return Err(AidedFault::Sigma);
        }
        let Geodetic { latitude, longitude, altitude } = self.position;
        let within = |x: Pair<R>, most: f64| x.hi.is_within(R::of(most)) && x.lo.is_within(R::ONE);
        let placed = within(latitude, core::f64::consts::FRAC_PI_2)
            && within(longitude, core::f64::consts::TAU)
            && within(altitude, MOST_ALTITUDE);
        if !placed {
            return Err(AidedFault::Place);
        }
        if !self.velocity.is_within(R::of(MOST_VELOCITY)) {
            return Err(AidedFault::Velocity);
        }
        Ok(())
    }

    /// The order in which measurements are taken.
    pub(super) fn is_before(&self, other: &Self) -> bool {
        let key = |m: &Self| (m.at.samples, m.at.part, m.sensor(), m.kind);
        key(self) < key(other)
    }

    /// Whether another one is the same again.
    pub(super) fn repeats(&self, at: &Instant<R>, kind: Kind) -> bool {
        self.at == *at && self.kind == kind
    }
}

impl Record for Kind {
    fn record(&self, name: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        (*self as u32).record(name, read);
    }
    fn restore(&mut self, name: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        let mut code = *self as u32;
        code.restore(name, write);
        *self = Self::ALL.get(code as usize).copied().unwrap_or_default();
    }
}

impl<R: Record> Record for Measured<R> {
    record!(at, kind, position, velocity, position_sigma, velocity_sigma);
}
