//! Perfect increments in, those of a real unit out: every error term of the core.

use crate::held::{Keep, held_mut, keep};
use crate::pointer::{get, put};
use crate::results::{Code, result};
use crate::values::{schuler_increment_f32, schuler_increment_f64, vector};
use pastey::paste;
use schuler::math::quaternion::Matrix;
use schuler::sensor::Timing;
use schuler::sensor::bandwidth::Bandwidth;
use schuler::sensor::constant::Constant;
use schuler::sensor::emulator::{Emulator, State};
use schuler::sensor::flicker::Flicker;
use schuler::sensor::g_sensitivity::GSensitivity;
use schuler::sensor::g_sensitivity_matrix::GSensitivityMatrix;
use schuler::sensor::gauss_markov::GaussMarkov;
use schuler::sensor::latency::Latency;
use schuler::sensor::misalignment::Misalignment;
use schuler::sensor::misalignment_matrix::MisalignmentMatrix;
use schuler::sensor::quantization::Quantization;
use schuler::sensor::random_walk::RandomWalk;
use schuler::sensor::saturation::Saturation;
use schuler::sensor::scale_factor::ScaleFactor;
use schuler::sensor::temperature::Ramp;
use schuler::sensor::temperature_bias::TemperatureBias;
use schuler::sensor::temperature_scale::TemperatureScale;
use schuler::sensor::triad::Triad;
use schuler::sensor::turn_on::TurnOn;
use schuler::sensor::white::White;

/// An emulator with the state of one run.
struct Run<R: schuler::noise::Deviate> {
    emulator: Emulator<R, Triad<R>, Triad<R>>,
    state: State<R, Triad<R>, Triad<R>>,
}

macro_rules! emulator {
    ($number:ident, $kind:literal, $words:literal) => { paste! {
        impl Keep for Run<$number> {
            const KIND: u32 = $kind;
        }

        #[doc = "The errors of three gyros or three accelerometers, an axis each: x, y, z. A term whose numbers are all 0 is "
            "absent: it draws no random numbers. \"Angle\" stands for rad of a gyro, m/s of an accelerometer."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct [<schuler_triad_ $number>] {
            /// Constant bias, angle/s.
            pub constant: [$number; 3],
            /// Rms of a bias that is drawn for each run, angle/s.
            pub turn_on: [$number; 3],
            /// Rms of a first-order Gauss-Markov bias, angle/s.
            pub gauss_markov: [$number; 3],
            /// Its correlation time, s; above 0 where there is one.
            pub correlation_s: [$number; 3],
            /// White noise (angle or velocity random walk), angle/sqrt(s).
            pub white: [$number; 3],
            /// Random walk of the bias, angle/s/sqrt(s).
            pub random_walk: [$number; 3],
            /// Bias instability, angle/s.
            pub instability: [$number; 3],
            /// Scale factor error, relative; positive reads too much.
            pub scale_factor: [$number; 3],
            /// Rotation of the sensors' axes, rad.
            pub misalignment: [$number; 3],
            /// Of gyros: rad/s per m/s^2. Of accelerometers 0.
            pub g_sensitivity: [$number; 3],
            /// The largest output, angle/s.
            pub saturation: [$number; 3],
            /// The least significant bit, angle.
            pub quantization: [$number; 3],
            /// Misalignment of each axis by itself, rad: a row for each sensor, its parts along the body axes. An element of
            /// the diagonal acts as a scale factor.
            pub misalignment_matrix: [[$number; 3]; 3],
            /// Of gyros: rad/s per m/s^2, a row for each gyro, its parts along the body axes. Of accelerometers 0.
            pub g_sensitivity_matrix: [[$number; 3]; 3],
            /// Temperature less that of calibration: at the start, K; how it changes, K/s; until when, s, which is above 0
            /// where one of the next two terms is there.
            pub temperature_ramp: [$number; 3],
            /// Bias by temperature, angle/s/K.
            pub temperature_bias: [$number; 3],
            /// Scale factor error by temperature, 1/K.
            pub temperature_scale: [$number; 3],
            /// Bandwidth (-3 dB, first order), Hz; above 0 on every axis where there is one.
            pub bandwidth: [$number; 3],
            /// Delay of the output, s; at most 8 samples.
            pub latency: [$number; 3],
        }

        #[doc = "A unit of gyros and accelerometers, emulated in " $number ". Allocate it anywhere."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug)]
        pub struct [<schuler_emulator_ $number>] {
            /// The library's.
            pub opaque: [u64; $words],
        }

        fn [<triad_ $number>](
            triad: &[<schuler_triad_ $number>],
            timing: Timing<$number>,
        ) -> Result<Triad<$number>, Code> {
            let given = |term: [$number; 3]| term.iter().any(|&x| x != 0.0).then(|| vector(term));
            let rows = |term: [[$number; 3]; 3]| {
                term.as_flattened().iter().any(|&x| x != 0.0).then(|| Matrix::from(term))
            };
            let [<schuler_triad_ $number>] {
                constant, turn_on, gauss_markov, correlation_s, white, random_walk, instability, scale_factor,
                misalignment, g_sensitivity, saturation, quantization, misalignment_matrix, g_sensitivity_matrix,
                temperature_ramp: [start_k, rate_k_s, until_s], temperature_bias, temperature_scale, bandwidth, latency,
            } = *triad;
            let ramp = || Ramp::new(start_k, rate_k_s, until_s, timing);
            Ok(Triad {
                constant: given(constant).map(|x| Constant::new(x, timing)).transpose()?,
                turn_on: given(turn_on).map(|x| TurnOn::new(x, timing)).transpose()?,
                gauss_markov: given(gauss_markov)
                    .map(|x| GaussMarkov::new(x, vector(correlation_s), timing))
                    .transpose()?,
                white: given(white).map(|x| White::new(x, timing)).transpose()?,
                random_walk: given(random_walk).map(|x| RandomWalk::new(x, timing)).transpose()?,
                flicker: given(instability).map(|x| Flicker::new(x, timing)).transpose()?,
                scale_factor: given(scale_factor).map(ScaleFactor::new).transpose()?,
                misalignment: given(misalignment).map(Misalignment::new).transpose()?,
                g_sensitivity: given(g_sensitivity).map(GSensitivity::new).transpose()?,
                saturation: given(saturation).map(|x| Saturation::new(x, timing)).transpose()?,
                quantization: given(quantization).map(Quantization::new).transpose()?,
                misalignment_matrix: rows(misalignment_matrix).map(MisalignmentMatrix::new).transpose()?,
                g_sensitivity_matrix: rows(g_sensitivity_matrix).map(GSensitivityMatrix::new).transpose()?,
                temperature_bias: given(temperature_bias)
                    .map(|x| TemperatureBias::new(x, ramp()?, timing))
                    .transpose()?,
                temperature_scale: given(temperature_scale)
                    .map(|x| TemperatureScale::new(x, ramp()?))
                    .transpose()?,
                bandwidth: given(bandwidth).map(|x| Bandwidth::new(x, timing)).transpose()?,
                latency: given(latency).map(|x| Latency::new(x, timing)).transpose()?,
            })
        }

        #[doc = "Starts a unit for samples of `interval_s`, s, in a run of `samples` (which matters to bias instability "
            "alone). All that is random is a function of `seed` and `run`; `abi` is SCHULER_ABI. Fails with "
            "SCHULER_PARAMETER_ and the parameter's name, SCHULER_ERROR_NULL, _MISALIGNED or _ABI; the unit is as it was "
            "then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_emulator_ $number _start>](
            emulator: *mut [<schuler_emulator_ $number>],
            abi: u32,
            interval_s: $number,
            samples: u64,
            gyros: *const [<schuler_triad_ $number>],
            accelerometers: *const [<schuler_triad_ $number>],
            seed: u64,
            run: u64,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                keep(emulator, abi, || {
                    let timing = Timing::new(interval_s, samples)?;
                    let gyros = [<triad_ $number>](&get(gyros)?, timing)?;
                    let accelerometers = [<triad_ $number>](&get(accelerometers)?, timing)?;
                    let emulator = Emulator::new(gyros, accelerometers, timing);
                    let state = emulator.start(seed, run);
                    Ok(Run::<$number> { emulator, state })
                })
            })
        }

        #[doc = "What the unit reads in its next sample, given the true increments. `perfect` and `read` may be one. Fails "
            "with SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; nothing changes then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_emulator_ $number _read>](
            emulator: *mut [<schuler_emulator_ $number>],
            perfect: *const [<schuler_increment_ $number>],
            read: *mut [<schuler_increment_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held_mut::<_, Run<$number>>(emulator).and_then(|Run { emulator, state }| {
                    let perfect = get(perfect)?.into();
                    put(read, || Ok(emulator.emulate(state, &perfect).into()))
                })
            })
        }
    } };
}

emulator!(f32, 0xf000_0005, 488);
emulator!(f64, 0xf000_0006, 846);

/// For the tests.
#[cfg(not(feature = "archive"))]
pub(crate) fn needs(see: &mut dyn FnMut(&str, usize, usize)) {
    see("schuler_emulator_f32", size_of::<schuler_emulator_f32>(), crate::held::size::<Run<f32>>());
    see("schuler_emulator_f64", size_of::<schuler_emulator_f64>(), crate::held::size::<Run<f64>>());
}
