//! Results: 0, or a negative number with a name and a text.

use core::ffi::{CStr, c_char};
use schuler::alignment::AlignmentError;
use schuler::link::frame::TooLong;
use schuler::sensor::parameter::{Parameter, ParameterError};
use schuler::strapdown::correction::CorrectionError;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::strapdown::plausible::Damaged;

/// A result that is not success.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Code(pub(crate) i32);

macro_rules! results {
    ($($name:ident $short:ident = $code:literal, $text:literal;)+) => {
        $(
            #[doc = $text]
            pub const $name: i32 = $code;
        )+

        impl Code {
            $(#[allow(dead_code)] pub(crate) const $short: Self = Self($code);)+
        }

        /// Name and text of a result.
        fn words(result: i32) -> (&'static CStr, &'static CStr) {
            const UNKNOWN: (&CStr, &CStr) = (c"SCHULER_UNKNOWN", c"not a result of this library");
            match result {
                $($code => {
                    const NAME: &CStr = terminated(concat!(stringify!($name), "\0"));
                    const TEXT: &CStr = terminated(concat!($text, "\0"));
                    (NAME, TEXT)
                })+
                _ => UNKNOWN,
            }
        }

        /// Every result with its name and its text: for the tests.
        #[cfg(not(feature = "archive"))]
        #[doc(hidden)]
        pub const RESULTS: &[(i32, &str, &str)] = &[$(($code, stringify!($name), $text),)+];
    };
}

/// A text that ends with a zero byte, as C has it.
const fn terminated(text: &'static str) -> &'static CStr {
    match CStr::from_bytes_with_nul(text.as_bytes()) {
        Ok(text) => text,
        Err(_) => c"",
    }
}

results! {
    SCHULER_OK OK = 0, "done";
    SCHULER_FRAME FRAME = 1, "a frame is complete";
    SCHULER_ERROR_NULL NULL = -1, "a pointer is null";
    SCHULER_ERROR_MISALIGNED MISALIGNED = -2, "a pointer is not aligned for what it leads to";
    SCHULER_ERROR_ABI ABI = -3, "the header is of another version than the library";
    SCHULER_ERROR_NOT_STARTED NOT_STARTED = -4, "the state has not been started";
    SCHULER_ERROR_FOREIGN FOREIGN = -5, "the state is of another type";
    SCHULER_ERROR_STALE STALE = -6, "the state is of another version of the library";
    SCHULER_ERROR_SPACE SPACE = -7, "the buffer is too small";
    SCHULER_ERROR_DAMAGED DAMAGED = -8, "the stored state is none that navigation leaves: it was damaged on the way";
    SCHULER_ERROR_INTERVAL INTERVAL = -16, "the sampling interval must be above 0 s and at most 1 s";
    SCHULER_ERROR_LIMITS LIMITS = -17, "the limits must be positive and finite";
    SCHULER_ERROR_POSITION POSITION = -18, "the initial position must be finite: latitude within 90°, longitude within 360°, height within 1000 km";
    SCHULER_ERROR_VELOCITY VELOCITY = -19, "the initial velocity must be finite and at most 100 km/s";
    SCHULER_ERROR_ATTITUDE ATTITUDE = -20, "the initial attitude must be a unit quaternion to a thousandth";
    SCHULER_ERROR_POLE POLE = -21, "the local-level frame cannot start at a pole; earth-fixed can";
    SCHULER_ERROR_FLUSH_TO_ZERO FLUSH_TO_ZERO = -22, "the processor flushes subnormal numbers to zero; clear that mode";
    SCHULER_REJECTED_ANGLE REJECTED_ANGLE = -32, "the angle increment is not finite or exceeds the limit";
    SCHULER_REJECTED_VELOCITY REJECTED_VELOCITY = -33, "the velocity increment is not finite or exceeds the limit";
    SCHULER_REJECTED_POLE REJECTED_POLE = -34, "the local-level frame ends at the pole; earth-fixed goes on";
    SCHULER_REJECTED_PLACE REJECTED_PLACE = -35, "navigation has left the ellipsoid by over 1000 km: check signs and units of the samples, or hold the vertical";
    SCHULER_REJECTED_HELD REJECTED_HELD = -36, "the vertical to hold must be finite, within 1000 km and 100 km/s";
    SCHULER_REJECTED_INTERVAL REJECTED_INTERVAL = -37, "the sample's interval must be above 0 s and at most 1 s";
    SCHULER_REJECTED_TURN REJECTED_TURN = -38, "the angle increment turns a block by over 2 rad: a window with a shorter block or a higher rate would do";
    SCHULER_CORRECTION_SIZE CORRECTION_SIZE = -48, "the correction must be finite, within 10 km, 10 km/s and half a turn";
    SCHULER_CORRECTION_POLE CORRECTION_POLE = -49, "the correction is too large so near a pole; earth-fixed takes it";
    SCHULER_CORRECTION_PLACE CORRECTION_PLACE = -50, "the correction leads over 1000 km from the ellipsoid";
    SCHULER_CORRECTION_STATE CORRECTION_STATE = -51, "the corrected state is none to go on from";
    SCHULER_ALIGNMENT_EMPTY ALIGNMENT_EMPTY = -64, "there is no sample to align on";
    SCHULER_ALIGNMENT_UNDETERMINED ALIGNMENT_UNDETERMINED = -65, "specific force and angular rate do not determine an attitude: one vanishes, or they are parallel";
    SCHULER_PARAMETER_INTERVAL PARAMETER_INTERVAL = -80, "sample interval: not positive, not finite or out of range";
    SCHULER_PARAMETER_SAMPLES PARAMETER_SAMPLES = -81, "number of samples: not positive";
    SCHULER_PARAMETER_CONSTANT PARAMETER_CONSTANT = -82, "constant bias: not finite or out of range";
    SCHULER_PARAMETER_TURN_ON PARAMETER_TURN_ON = -83, "rms of the turn-on bias: negative, not finite or out of range";
    SCHULER_PARAMETER_GAUSS_MARKOV PARAMETER_GAUSS_MARKOV = -84, "rms of the Gauss-Markov bias: negative, not finite or out of range";
    SCHULER_PARAMETER_CORRELATION PARAMETER_CORRELATION = -85, "correlation time of the Gauss-Markov bias: not positive, not finite or out of range";
    SCHULER_PARAMETER_WHITE PARAMETER_WHITE = -86, "white noise: negative, not finite or out of range";
    SCHULER_PARAMETER_RANDOM_WALK PARAMETER_RANDOM_WALK = -87, "random walk of the bias: negative, not finite or out of range";
    SCHULER_PARAMETER_INSTABILITY PARAMETER_INSTABILITY = -88, "bias instability: negative, not finite or out of range";
    SCHULER_PARAMETER_SCALE_FACTOR PARAMETER_SCALE_FACTOR = -89, "scale factor error: not finite or out of range";
    SCHULER_PARAMETER_MISALIGNMENT PARAMETER_MISALIGNMENT = -90, "misalignment: not finite or out of range";
    SCHULER_PARAMETER_G_SENSITIVITY PARAMETER_G_SENSITIVITY = -91, "g-sensitivity: not finite or out of range";
    SCHULER_PARAMETER_SATURATION PARAMETER_SATURATION = -92, "saturation: not positive, not finite or out of range";
    SCHULER_PARAMETER_QUANTIZATION PARAMETER_QUANTIZATION = -93, "quantization: negative, not finite or out of range";
    SCHULER_PARAMETER_MISALIGNMENT_MATRIX PARAMETER_MISALIGNMENT_MATRIX = -100, "misalignment matrix: not finite or out of range";
    SCHULER_PARAMETER_G_SENSITIVITY_MATRIX PARAMETER_G_SENSITIVITY_MATRIX = -101, "g-sensitivity matrix: not finite or out of range";
    SCHULER_PARAMETER_TEMPERATURE PARAMETER_TEMPERATURE = -102, "temperature and its rate: not finite";
    SCHULER_PARAMETER_RAMP_TIME PARAMETER_RAMP_TIME = -103, "how long the temperature changes: not positive or not finite";
    SCHULER_PARAMETER_TEMPERATURE_BIAS PARAMETER_TEMPERATURE_BIAS = -104, "bias by temperature: not finite or out of range";
    SCHULER_PARAMETER_TEMPERATURE_SCALE PARAMETER_TEMPERATURE_SCALE = -105, "scale factor by temperature: not finite or out of range";
    SCHULER_PARAMETER_BANDWIDTH PARAMETER_BANDWIDTH = -106, "bandwidth: not positive, not finite or out of range";
    SCHULER_PARAMETER_LATENCY PARAMETER_LATENCY = -107, "latency: negative, not finite or longer than 8 samples";
    SCHULER_ERROR_PAYLOAD PAYLOAD = -96, "the payload is longer than a frame holds";
    SCHULER_ERROR_KIND KIND = -97, "there is no such kind of frame";
    SCHULER_ERROR_OTHER OTHER = -127, "an error that this version of the header has no name for";
}

/// Conversions of the core's errors, variant by variant.
macro_rules! from {
    ($($error:ident { $($variant:ident $code:ident),+ $(,)? })+) => {$(
        impl From<$error> for Code {
            fn from(error: $error) -> Self {
                match error {
                    $($error::$variant => Self::$code,)+
                    _ => Self::OTHER,
                }
            }
        }
    )+};
}

from! {
    StartError {
        Interval INTERVAL, Limits LIMITS, Position POSITION, Velocity VELOCITY, Attitude ATTITUDE, Pole POLE,
        FlushToZero FLUSH_TO_ZERO,
    }
    Rejected {
        Angle REJECTED_ANGLE, Velocity REJECTED_VELOCITY, Pole REJECTED_POLE, Place REJECTED_PLACE,
        Held REJECTED_HELD, Interval REJECTED_INTERVAL, Turn REJECTED_TURN,
    }
    CorrectionError {
        Size CORRECTION_SIZE, Pole CORRECTION_POLE, Place CORRECTION_PLACE, State CORRECTION_STATE,
    }
    AlignmentError { Empty ALIGNMENT_EMPTY, Undetermined ALIGNMENT_UNDETERMINED }
    Parameter {
        Interval PARAMETER_INTERVAL, Samples PARAMETER_SAMPLES, Constant PARAMETER_CONSTANT,
        TurnOnRms PARAMETER_TURN_ON, GaussMarkovRms PARAMETER_GAUSS_MARKOV,
        CorrelationTime PARAMETER_CORRELATION, WhiteNoise PARAMETER_WHITE, RandomWalk PARAMETER_RANDOM_WALK,
        BiasInstability PARAMETER_INSTABILITY, ScaleFactor PARAMETER_SCALE_FACTOR,
        Misalignment PARAMETER_MISALIGNMENT, GSensitivity PARAMETER_G_SENSITIVITY,
        Saturation PARAMETER_SATURATION, Quantization PARAMETER_QUANTIZATION,
        MisalignmentMatrix PARAMETER_MISALIGNMENT_MATRIX, GSensitivityMatrix PARAMETER_G_SENSITIVITY_MATRIX,
        Temperature PARAMETER_TEMPERATURE, RampTime PARAMETER_RAMP_TIME,
        TemperatureBias PARAMETER_TEMPERATURE_BIAS, TemperatureScale PARAMETER_TEMPERATURE_SCALE,
        Bandwidth PARAMETER_BANDWIDTH, Latency PARAMETER_LATENCY,
    }
}

impl From<ParameterError> for Code {
    fn from(error: ParameterError) -> Self {
        error.parameter.into()
    }
}

impl From<Damaged> for Code {
    fn from(_: Damaged) -> Self {
        Self::DAMAGED
    }
}

impl From<TooLong> for Code {
    fn from(_: TooLong) -> Self {
        Self::PAYLOAD
    }
}

/// As C gets it.
pub(crate) fn result(done: Result<(), Code>) -> i32 {
    done.map_or_else(|Code(code)| code, |()| SCHULER_OK)
}

/// The name of a result, such as "SCHULER_ERROR_NULL": a constant text, never null.
#[unsafe(no_mangle)]
pub extern "C" fn schuler_result_name(result: i32) -> *const c_char {
    words(result).0.as_ptr()
}

/// What a result means, in English and UTF-8: a constant text, never null.
#[unsafe(no_mangle)]
pub extern "C" fn schuler_result_text(result: i32) -> *const c_char {
    words(result).1.as_ptr()
}
