//! Level and north from a vehicle at rest.

use crate::held::{Keep, held, held_mut, keep};
use crate::pointer::{get, put};
use crate::results::{Code, result};
use crate::values::{
    schuler_increment_f32, schuler_increment_f64, schuler_vector_f32, schuler_vector_f64,
};
use pastey::paste;
use schuler::alignment::judge::{Contradiction, judge};
use schuler::alignment::place::Place;
use schuler::alignment::still::Still;
use schuler::alignment::units::Kind;
use schuler::earth::Geodetic;
use schuler::solution::Euler;

/// Readings at rest contradict nothing.
pub const SCHULER_STILL: i32 = 0;
/// Readings at rest are in another unit, or of another kind, than stated.
pub const SCHULER_STILL_UNITS: i32 = 1;
/// Specific force varies: the vehicle is not still.
pub const SCHULER_STILL_MOVING: i32 = 2;
/// Specific force is not gravity in any unit.
pub const SCHULER_STILL_FORCE: i32 = 3;
/// Specific force is not gravity, and steadier than a sensor with such an error: an acceleration.
pub const SCHULER_STILL_ACCELERATING: i32 = 4;
/// The body turns: gyros and the direction of specific force agree.
pub const SCHULER_STILL_TURNING: i32 = 5;
/// A rate that is too large for a bias and does not show in the accelerometers.
pub const SCHULER_STILL_RATE: i32 = 6;
/// Gyros and accelerometers contradict each other or the latitude: a sign, an axis, or the latitude is wrong.
pub const SCHULER_STILL_DIRECTIONS: i32 = 7;

fn contradiction<R>(found: &Option<Contradiction<R>>) -> i32 {
    match found {
        None => SCHULER_STILL,
        Some(Contradiction::Units { .. }) => SCHULER_STILL_UNITS,
        Some(Contradiction::Moving) => SCHULER_STILL_MOVING,
        Some(Contradiction::Force) => SCHULER_STILL_FORCE,
        Some(Contradiction::Accelerating) => SCHULER_STILL_ACCELERATING,
        Some(Contradiction::Turning) => SCHULER_STILL_TURNING,
        Some(Contradiction::Rate) => SCHULER_STILL_RATE,
        Some(Contradiction::Directions(_)) => SCHULER_STILL_DIRECTIONS,
    }
}

macro_rules! alignment {
    ($number:ident, $kind:literal, $words:literal) => { paste! {
        impl Keep for Still<$number> {
            const KIND: u32 = $kind;
        }

        #[doc = "Samples at rest, gathered in " $number ". Allocate it anywhere."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug)]
        pub struct [<schuler_alignment_ $number>] {
            /// The library's.
            pub opaque: [u64; $words],
        }

        #[doc = "How good readings at rest are."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct [<schuler_still_ $number>] {
            /// Mean angular rate, rad/s.
            pub rate_ib_b: [$number; 3],
            /// Mean specific force, m/s^2.
            pub specific_force_b: [$number; 3],
            /// Standard deviation of roll and pitch, rad.
            pub level_sigma_rad: $number,
            /// Standard deviation of the heading, rad; above 1 there is no heading.
            pub heading_sigma_rad: $number,
            /// Specific force less gravity, m/s^2.
            pub force_off_m_s2: $number,
            /// The smallest gyro error that explains the readings, rad/s.
            pub rate_off_rad_s: $number,
            /// SCHULER_STILL, or what the readings contradict.
            pub contradiction: i32,
        }

        #[doc = "Starts without samples. `piece_s` is the length of the pieces that tell noise from motion, s (1 suits); "
            "`abi` is SCHULER_ABI. Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI or _INTERVAL."]
        ///
        /// # Safety
        ///
        /// The pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_alignment_ $number _start>](
            alignment: *mut [<schuler_alignment_ $number>],
            abi: u32,
            piece_s: $number,
        ) -> i32 {
            let make = || {
                let usable = piece_s > 0.0 && piece_s < 1e6;
                if usable { Ok(Still::<$number>::new(piece_s)) } else { Err(Code::INTERVAL) }
            };
            // SAFETY: as promised.
            result(unsafe { keep(alignment, abi, make) })
        }

        #[doc = "Adds a sample of increments at rest that lasts `interval_s`, s. Fails with SCHULER_REJECTED_INTERVAL, "
            "SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; nothing changes then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_alignment_ $number _add>](
            alignment: *mut [<schuler_alignment_ $number>],
            sample: *const [<schuler_increment_ $number>],
            interval_s: $number,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held_mut::<_, Still<$number>>(alignment).and_then(|still| {
                    let sample = get(sample)?.into();
                    if !(interval_s > 0.0 && interval_s <= 1.0) {
                        return Err(Code::REJECTED_INTERVAL);
                    }
                    still.add(&sample, interval_s);
                    Ok(())
                })
            })
        }

        #[doc = "Roll, pitch and yaw, rad: level by the accelerometers, north by the gyros. Fails with "
            "SCHULER_ALIGNMENT_EMPTY, SCHULER_ALIGNMENT_UNDETERMINED, and as _add does; nothing is written then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing writes meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_alignment_ $number _attitude>](
            alignment: *const [<schuler_alignment_ $number>],
            roll_pitch_yaw_rad: *mut [<schuler_vector_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Still<$number>>(alignment)
                    .and_then(|still| put(roll_pitch_yaw_rad, || Ok([<angles_ $number>](still.alignment().attitude()?))))
            })
        }

        #[doc = "Roll and pitch by the accelerometers, with a yaw that is known from elsewhere, rad. Fails as _attitude does."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing writes meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_alignment_ $number _level>](
            alignment: *const [<schuler_alignment_ $number>],
            yaw_rad: $number,
            roll_pitch_yaw_rad: *mut [<schuler_vector_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Still<$number>>(alignment)
                    .and_then(|still| put(roll_pitch_yaw_rad, || Ok([<angles_ $number>](still.alignment().level(yaw_rad)?))))
            })
        }

        #[doc = "What was read so far, judged for a vehicle at rest at a latitude, a longitude (rad) and a height (m). "
            "Fails with SCHULER_ALIGNMENT_EMPTY, and as _add does; nothing is written then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing writes meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_alignment_ $number _judge>](
            alignment: *const [<schuler_alignment_ $number>],
            latitude_rad: $number,
            longitude_rad: $number,
            altitude_m: $number,
            still: *mut [<schuler_still_ $number>],
        ) -> i32 {
            let at = Geodetic { latitude: latitude_rad, longitude: longitude_rad, altitude: altitude_m };
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Still<$number>>(alignment)
                    .and_then(|gathered| put(still, || [<judged_ $number>](gathered, at)))
            })
        }

        fn [<angles_ $number>](euler: Euler<$number>) -> [<schuler_vector_ $number>] {
            [<schuler_vector_ $number>] { x: euler.roll, y: euler.pitch, z: euler.yaw }
        }

        fn [<judged_ $number>](
            still: &Still<$number>,
            at: Geodetic<$number>,
        ) -> Result<[<schuler_still_ $number>], Code> {
            let readings = still.readings().ok_or(Code::ALIGNMENT_EMPTY)?;
            let judgement = judge(&readings, Kind::Increments, &Place::new(at));
            Ok([<schuler_still_ $number>] {
                rate_ib_b: readings.rate_ib_b.into_array(),
                specific_force_b: readings.specific_force_b.into_array(),
                level_sigma_rad: judgement.quality.level_sigma,
                heading_sigma_rad: judgement.quality.heading_sigma,
                force_off_m_s2: judgement.quality.force_off,
                rate_off_rad_s: judgement.quality.rate_off,
                contradiction: contradiction(&judgement.contradiction),
            })
        }
    } };
}

alignment!(f32, 0xf000_0003, 38);
alignment!(f64, 0xf000_0004, 74);

/// For the tests.
#[cfg(not(feature = "archive"))]
pub(crate) fn needs(see: &mut dyn FnMut(&str, usize, usize)) {
    see(
        "schuler_alignment_f32",
        size_of::<schuler_alignment_f32>(),
        crate::held::size::<Still<f32>>(),
    );
    see(
        "schuler_alignment_f64",
        size_of::<schuler_alignment_f64>(),
        crate::held::size::<Still<f64>>(),
    );
}
