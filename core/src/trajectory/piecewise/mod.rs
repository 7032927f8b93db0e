//! Any path: piecewise polynomials of the outward normal, the height and the attitude.
//!
//! The truth of a simulated motion is the polynomials themselves, to the last digit. They are evaluated with
//! + − × ÷ √ alone and are singular nowhere: no pole, no antimeridian, no pitch of 90°.
//!
//! | file | what it has |
//! |---|---|
//! | [`piece`] | one piece, and the order of its channels |
//! | [`place`] | normal and position as power series |
//! | `axes` | attitude by a rule: [`Attitude`] |
//! | [`stream`] | a few pieces at a time |
//! | `bound` | bounds of a motion, from its pieces |
//!
//! ```
//! use schuler::math::compensated::Pair;
//! use schuler::trajectory::Trajectory as _;
//! use schuler::trajectory::piecewise::{Attitude, Piecewise, piece::Piece};
//!
//! // From the equator to the north, 1 µrad/s, for ten seconds.
//! let mut piece = Piece::<8>::new(0.0, 10.0);
//! piece.coefficients[0] = [1.0, 0.0, 0.0, 100.0, 0.0, 0.0, 0.0, 0.0];
//! piece.coefficients[1][2] = 1e-6;
//! let path = Piecewise::new([piece], Attitude::Upright).expect("it moves");
//! let rates = path.rates_at(Pair::new(5.0));
//! assert!((rates.specific_force_b.z + 9.78).abs() < 1e-3);
//! ```

mod axes;
mod bound;
pub mod piece;
pub mod place;
pub mod stream;

pub use axes::Attitude;

use super::geographic::State;
use super::kinematics::{Kinematics, specific_force_e, to_body};
use super::motion::Motion;
use super::series::Series;
use super::{Bound, Trajectory, geographic};
use crate::earth::ROTATION_RATE;
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::sample::Rates;
use crate::solution::Solution;
use axes::{Axes, Turning, motion};
use piece::{Half, Piece};
use place::Place;

/// Why pieces are no path.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PathError {
    /// There is none.
    Empty,
    /// A piece does not begin where the one before it ends, or does not end after it begins.
    Order {
        /// Its index, from 0.
        piece: usize,
    },
    /// A piece has a number that is not finite, or a normal or a quaternion without direction.
    NotFinite {
        /// Its index, from 0.
        piece: usize,
    },
    /// The path is too slow there for an attitude along the velocity.
    Slow {
        /// When, s.
        time_s: f64,
        /// How fast it is, m/s.
        speed: f64,
    },
}

/// The least speed at which the velocity tells an attitude, m/s.
pub const LEAST_SPEED: f64 = 0.1;

impl core::fmt::Display for PathError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Empty => f.write_str("a path has a piece at least"),
            Self::Order { piece } => {
                write!(f, "piece {piece} of the path must begin where the one before it ends")
            }
            Self::NotFinite { piece } => {
                write!(f, "piece {piece} of the path must be finite, with a direction throughout")
            }
            Self::Slow { time_s, speed } => write!(
                f,
                "at {time_s} s the path moves at {speed} m/s: below {LEAST_SPEED} m/s its \
                 velocity tells no attitude"
            ),
        }
    }
}

impl core::error::Error for PathError {}

/// A path by its pieces, which follow each other: an array, a `heapless::Vec`, a `Vec`, a slice.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Piecewise<P, const TERMS: usize> {
    pieces: P,
    attitude: Attitude,
    bound: Bound<f64>,
}

impl<P: AsRef<[Piece<TERMS>]>, const TERMS: usize> Piecewise<P, TERMS> {
    /// From pieces in the order of time.
    ///
    /// # Errors
    ///
    /// [`PathError`] where they are no path.
    pub fn new(pieces: P, attitude: Attitude) -> Result<Self, PathError> {
        let mut this = Self { pieces, attitude, bound: Bound::default() };
        bound::check(this.pieces.as_ref())?;
        this.bound = bound::bound(&this)?;
        Ok(this)
    }

    /// Its pieces.
    pub fn pieces(&self) -> &[Piece<TERMS>] {
        self.pieces.as_ref()
    }

    /// Where its attitude comes from.
    pub fn attitude(&self) -> Attitude {
        self.attitude
    }

    /// When it ends, s.
    pub fn end_s(&self) -> f64 {
        self.pieces().last().map_or(0.0, |piece| piece.end_s)
    }

    /// The piece at a time; before the first and after the last, these go on.
    #[inline(always)]
    fn piece(&self, time_s: f64) -> &Piece<TERMS> {
        let pieces = self.pieces();
        let index = pieces.partition_point(|piece| piece.end_s <= time_s);
        // Checked when the path was made: there is one at least.
        pieces.get(index).or_else(|| pieces.last()).unwrap_or(const { &Piece::EMPTY })
    }
}

/// s, ṡ, s̈ as quaternions.
#[inline(always)]
fn turning<const N: usize>(s: &[Series<N>; 4]) -> [Quaternion<f64>; N] {
    let [w, x, y, z] = s;
    core::array::from_fn(|k| {
        let of = |c: &Series<N>| c.coefficient(k);
        Quaternion::new(of(w), Vector::new(of(x), of(y), of(z)))
    })
}

impl<const TERMS: usize> Piece<TERMS> {
    const EMPTY: Self = Self {
        start_s: 0.0,
        end_s: 0.0,
        middle_s: 0.0,
        coefficients: [[0.0; piece::CHANNELS]; TERMS],
    };

    /// What perfect sensors read.
    #[inline]
    pub fn rates(&self, attitude: Attitude, time_s: Pair<f64>) -> Rates<f64> {
        let earth_rate = Vector::new(0.0, 0.0, ROTATION_RATE);
        if attitude != Attitude::Stored {
            let [x, y, z, h] = self.series::<4>(Half::Position, time_s);
            let place = Place::new(Vector::new(x, y, z), h);
            let (velocity, force) = motion::<4, 2>(&place);
            let turning = Turning::by_rule(attitude, &place, velocity, force);
            let mut specific_force_b = turning.to_body(force.map(|f| f.value()));
            if attitude == Attitude::Coordinated {
                specific_force_b.y = 0.0;
            }
            return Rates {
                rate_ib_b: turning.rate_eb_b + turning.to_body(earth_rate),
                specific_force_b,
            };
        }
        let [x, y, z, h] = self.series::<3>(Half::Position, time_s);
        let place = Place::new(Vector::new(x, y, z), h);
        let velocity_e = place.position.map(|r| r.coefficient(1));
        let acceleration_e = place.position.map(|r| 2.0 * r.coefficient(2));
        let normal = place.normal::<1>();
        let gravity = (normal * place.gravity()).map(|g| g.value());
        let force = specific_force_e(velocity_e, acceleration_e, gravity);
        let [s, rate] = turning(&self.series::<2>(Half::Attitude, time_s));
        // ω_ibᵇ = 2 Vec(s* ⊗ ṡ)/|s|² + RᵀΩ
        let rate_eb_b = (s.conjugate() * rate).v * (2.0 / s.dot(s));
        Rates { rate_ib_b: rate_eb_b + to_body(s, earth_rate), specific_force_b: to_body(s, force) }
    }

    /// Place and motion in Earth-fixed axes.
    pub fn kinematics(&self, attitude: Attitude, time_s: Pair<f64>) -> Kinematics {
        let [x, y, z, h] = self.series::<5>(Half::Position, time_s);
        let place = Place::new(Vector::new(x, y, z), h);
        let (quaternion, rate, acceleration) = if attitude == Attitude::Stored {
            let [s, first, second] = turning(&self.series::<3>(Half::Attitude, time_s));
            let square = s.dot(s);
            let rate = (s.conjugate() * first).v * (2.0 / square);
            // α = 2 Vec(s* ⊗ s̈)/|s|² − 2(s·ṡ/|s|²)ω;  s̈ is twice its coefficient
            let change =
                (s.conjugate() * second).v * (4.0 / square) - rate * (2.0 * s.dot(first) / square);
            (s * (1.0 / Real::sqrt(square)), rate, change)
        } else {
            let (velocity, force) = motion::<5, 3>(&place);
            let axes = Axes::new(attitude, &place, velocity, force);
            let rate = axes.rate();
            let (first, second) = (rate.map(|w| w.value()), rate.map(|w| w.coefficient(1)));
            (axes.quaternion(), first, second)
        };
        Kinematics {
            normal_e: place.normal::<1>().map(|n| n.value()),
            altitude: h.value(),
            velocity_e: place.position.map(|r| r.coefficient(1)),
            acceleration_e: place.position.map(|r| 2.0 * r.coefficient(2)),
            attitude: quaternion,
            rate_eb_b: rate,
            angular_acceleration_b: acceleration,
        }
    }

    /// The state that is printed, as it stands in the polynomials.
    fn state(&self, attitude: Attitude, time_s: Pair<f64>) -> State {
        let fixed = |[x, y, z, h]: [Series<2>; 4], velocity_e, attitude| State {
            m: Vector::new(x.value(), y.value(), z.value()),
            altitude: h.value(),
            climb: h.coefficient(1),
            velocity_e,
            attitude,
        };
        if attitude == Attitude::Stored {
            let channels = self.series::<2>(Half::Position, time_s);
            let [x, y, z, h] = channels;
            let velocity = Place::new(Vector::new(x, y, z), h).position.map(|r| r.coefficient(1));
            let [s] = turning(&self.series::<1>(Half::Attitude, time_s));
            return fixed(channels, velocity, s);
        }
        let channels = self.series::<4>(Half::Position, time_s);
        let [x, y, z, h] = channels;
        let place = Place::new(Vector::new(x, y, z), h);
        let (velocity, force) = motion::<4, 2>(&place);
        let turning = Turning::by_rule(attitude, &place, velocity, force);
        fixed(channels.map(|c| c.first()), velocity.map(|v| v.value()), turning.quaternion())
    }
}

impl<P: AsRef<[Piece<TERMS>]>, const TERMS: usize> Trajectory<f64> for Piecewise<P, TERMS> {
    fn at_instant(&self, time_s: Pair<f64>) -> Motion<f64> {
        let piece = self.piece(time_s.hi);
        let [_, _, _, h] = piece.series::<3>(Half::Position, time_s);
        let (climb, change) = (h.coefficient(1), 2.0 * h.coefficient(2));
        geographic::motion(&piece.kinematics(self.attitude, time_s), climb, change)
    }

    #[inline]
    fn rates_at(&self, time_s: Pair<f64>) -> Rates<f64> {
        self.piece(time_s.hi).rates(self.attitude, time_s)
    }

    fn kinematics_at(&self, time_s: Pair<f64>) -> Kinematics {
        self.piece(time_s.hi).kinematics(self.attitude, time_s)
    }

    fn solution_at(&self, time_s: Pair<f64>) -> Solution<f64> {
        geographic::solution(&self.piece(time_s.hi).state(self.attitude, time_s))
    }

    fn initial_at(&self, time_s: Pair<f64>) -> Solution<f64> {
        geographic::initial(&self.piece(time_s.hi).state(self.attitude, time_s))
    }

    #[inline]
    fn joint_after(&self, time_s: f64) -> Option<f64> {
        let end_s = self.piece(time_s).end_s;
        (end_s > time_s).then_some(end_s)
    }

    fn bound(&self) -> Bound<f64> {
        self.bound
    }
}
