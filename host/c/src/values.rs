//! Samples, solutions and corrections as C has them, in single and double precision.

use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::noise::Deviate;
use schuler::record::Record;
use schuler::sample::{Increment, Rates};
use schuler::solution::{Euler, Solution};
use schuler::strapdown::correction::Correction;

/// The C structs of a scalar.
pub(crate) trait Plain: Scalar + Record + Deviate {
    /// A number with its rest.
    type Pair: Copy + Into<Pair<Self>> + From<Pair<Self>>;
    /// A sample of increments.
    type Increment: Copy + Into<Increment<Self>> + From<Increment<Self>>;
    /// Rates at an instant.
    type Rates: Copy + Into<Rates<Self>>;
    /// A solution.
    type Solution: Copy + Into<Solution<Self>> + From<[Pair<Self>; 10]>;
    /// A correction.
    type Correction: Copy + Into<Correction<Self>>;
}

pub(crate) fn vector<T: Copy>([x, y, z]: [T; 3]) -> Vector<T> {
    Vector::new(x, y, z)
}

macro_rules! values {
    ($($number:ident)+) => {$( pastey::paste! {
        #[doc = "A number of type " $number " as the sum of two: `value` is the number rounded, `rest` what rounding dropped, or 0."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct [<schuler_pair_ $number>] {
            /// The number, rounded.
            pub value: $number,
            /// What rounding has dropped.
            pub rest: $number,
        }

        #[doc = "A sample: the integrals of the rates over its interval, which it stands at the end of, in body axes "
            "(forward, right, down)."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct [<schuler_increment_ $number>] {
            /// Angular rate against inertial space, integrated, rad.
            pub angle_b: [$number; 3],
            /// Specific force (at rest gravity's magnitude upwards, hence negative z), integrated, m/s.
            pub velocity_b: [$number; 3],
        }

        #[doc = "Rates at an instant, in body axes (forward, right, down)."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct [<schuler_rates_ $number>] {
            /// Angular rate against inertial space, rad/s.
            pub rate_ib_b: [$number; 3],
            /// Specific force, m/s^2.
            pub specific_force_b: [$number; 3],
        }

        #[doc = "Position, velocity and attitude. Where a navigator puts out its own axes, those of an Earth-fixed one "
            "are Earth-fixed: position x, y, z in m, velocity x, y, z, attitude from body to Earth-fixed axes."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct [<schuler_solution_ $number>] {
            /// Latitude (north positive) and longitude (east positive), rad; height above the ellipsoid, m.
            pub position: [[<schuler_pair_ $number>]; 3],
            /// North, east, down, relative to the Earth, m/s.
            pub velocity: [[<schuler_pair_ $number>]; 3],
            /// Unit quaternion w, x, y, z from body axes to north, east, down.
            pub attitude: [[<schuler_pair_ $number>]; 4],
        }

        #[doc = "The corrected state less the present one, in north, east and down. Zeros change no bit."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct [<schuler_correction_ $number>] {
            /// Position, m, at most 10 km.
            pub position_ned: [$number; 3],
            /// Velocity, m/s, at most 10 km/s.
            pub velocity_ned: [$number; 3],
            /// Attitude as the rotation vector from the present to the corrected one, rad, at most half a turn.
            pub attitude_ned: [$number; 3],
        }

        impl Plain for $number {
            type Pair = [<schuler_pair_ $number>];
            type Increment = [<schuler_increment_ $number>];
            type Rates = [<schuler_rates_ $number>];
            type Solution = [<schuler_solution_ $number>];
            type Correction = [<schuler_correction_ $number>];
        }

        impl From<[<schuler_pair_ $number>]> for Pair<$number> {
            fn from(pair: [<schuler_pair_ $number>]) -> Self {
                Self { hi: pair.value, lo: pair.rest }
            }
        }

        impl From<Pair<$number>> for [<schuler_pair_ $number>] {
            fn from(pair: Pair<$number>) -> Self {
                Self { value: pair.hi, rest: pair.lo }
            }
        }

        impl From<[<schuler_increment_ $number>]> for Increment<$number> {
            fn from(sample: [<schuler_increment_ $number>]) -> Self {
                Self { angle_b: vector(sample.angle_b), velocity_b: vector(sample.velocity_b) }
            }
        }

        impl From<Increment<$number>> for [<schuler_increment_ $number>] {
            fn from(sample: Increment<$number>) -> Self {
                let Increment { angle_b, velocity_b } = sample;
                Self { angle_b: angle_b.into_array(), velocity_b: velocity_b.into_array() }
            }
        }

        impl From<[<schuler_rates_ $number>]> for Rates<$number> {
            fn from(rates: [<schuler_rates_ $number>]) -> Self {
                let [<schuler_rates_ $number>] { rate_ib_b, specific_force_b } = rates;
                Self { rate_ib_b: vector(rate_ib_b), specific_force_b: vector(specific_force_b) }
            }
        }

        impl From<[<schuler_correction_ $number>]> for Correction<$number> {
            fn from(correction: [<schuler_correction_ $number>]) -> Self {
                Self {
                    position_ned: vector(correction.position_ned),
                    velocity_ned: vector(correction.velocity_ned),
                    attitude_ned: vector(correction.attitude_ned),
                }
            }
        }

        impl From<[<schuler_solution_ $number>]> for Solution<$number> {
            fn from(solution: [<schuler_solution_ $number>]) -> Self {
                let [latitude, longitude, altitude] = solution.position.map(Into::into);
                let [w, attitude @ ..] = solution.attitude.map(Into::into);
                Self {
                    position: Geodetic { latitude, longitude, altitude },
                    velocity_ned: vector(solution.velocity.map(Into::into)),
                    attitude: Quaternion::new(w, vector(attitude)),
                }
            }
        }

        impl From<[Pair<$number>; 10]> for [<schuler_solution_ $number>] {
            fn from(pairs: [Pair<$number>; 10]) -> Self {
                let [a, b, c, d, e, f, g, h, i, j] = pairs.map(Into::into);
                Self { position: [a, b, c], velocity: [d, e, f], attitude: [g, h, i, j] }
            }
        }

        #[doc = "A solution from plain numbers: latitude, longitude (rad) and height (m), velocity north, east, down (m/s), "
            "and roll, pitch, yaw (rad, at most 2 pi: yaw about down from north, then pitch about right, then roll about "
            "forward). Fails with SCHULER_ERROR_NULL or _MISALIGNED."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_solution_ $number _from>](
            latitude_rad: $number,
            longitude_rad: $number,
            altitude_m: $number,
            velocity_ned_m_s: *const [<schuler_vector_ $number>],
            roll_pitch_yaw_rad: *const [<schuler_vector_ $number>],
            solution: *mut [<schuler_solution_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            crate::results::result(unsafe {
                let make = |velocity: [<schuler_vector_ $number>], angles: [<schuler_vector_ $number>]| {
                    let at = Geodetic { latitude: latitude_rad, longitude: longitude_rad, altitude: altitude_m };
                    let attitude = Euler { roll: angles.x, pitch: angles.y, yaw: angles.z };
                    let velocity = Vector::new(velocity.x, velocity.y, velocity.z);
                    [<schuler_solution_ $number>]::from(pairs(&Solution::new(at, velocity, attitude)))
                };
                crate::pointer::get(velocity_ned_m_s).and_then(|velocity| {
                    let angles = crate::pointer::get(roll_pitch_yaw_rad)?;
                    crate::pointer::put(solution, || Ok(make(velocity, angles)))
                })
            })
        }

        #[doc = "Roll, pitch and yaw of a solution in local axes, rad, to the digits of " $number
            ": yaw within 180 degrees, pitch within 90. Fails with SCHULER_ERROR_NULL or _MISALIGNED."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_solution_ $number _euler>](
            solution: *const [<schuler_solution_ $number>],
            roll_pitch_yaw_rad: *mut [<schuler_vector_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            crate::results::result(unsafe {
                crate::pointer::get(solution).and_then(|solution| {
                    let Euler { roll, pitch, yaw } = Solution::from(solution).euler();
                    crate::pointer::put(roll_pitch_yaw_rad, || {
                        Ok([<schuler_vector_ $number>] { x: roll, y: pitch, z: yaw })
                    })
                })
            })
        }

        #[doc = "Three numbers."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct [<schuler_vector_ $number>] {
            /// The first: x, north, or roll.
            pub x: $number,
            /// The second: y, east, or pitch.
            pub y: $number,
            /// The third: z, down, or yaw.
            pub z: $number,
        }
    } )+};
}

values! { f32 f64 }

/// The ten pairs of a solution, in the order of its record.
pub(crate) fn pairs<R: Scalar + Record>(solution: &impl Record) -> [Pair<R>; 10] {
    let mut pairs = [Pair::new(R::ZERO); 10];
    let mut word = 0_usize;
    solution.record("", &mut |_, bits| {
        if let Some(pair) = pairs.get_mut(word / 2) {
            let half = if word.is_multiple_of(2) { &mut pair.hi } else { &mut pair.lo };
            *half = R::from_bits(bits);
        }
        word += 1;
    });
    pairs
}
