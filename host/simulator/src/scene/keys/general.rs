//! The top level of a scene, its navigator and its link.

use crate::input::Range;
use crate::input::key::Takes::{Number, Said};
use crate::scene::limits;
use crate::table;

table! {
    /// The top level.
    ROOT = "The top level", "What flies, for how long, and how often it is sampled.";
    TITLE = "title": Said("text"), "the file's name", "one line for people";
    DURATION = "duration_s": Number(limits::DURATION_S), "the path's length; with channels it must be there", "length of the flight";
    RATE = "rate_hz": Number(limits::RATE_HZ), "", "samples of the inertial unit per second";
    SEED = "seed": Said("an integer from 0 to 18446744073709551615"), "1", "seed of everything random";
    TRAJECTORY = "trajectory": Said("a table"), "rest at 0° N 0° E", "the true motion";
    GYROS = "gyro": Said("a table"), "perfect gyros", "the errors of the gyros";
    ACCELEROMETERS = "accelerometer": Said("a table"), "perfect accelerometers", "the errors of the accelerometers";
    TEMPERATURES = "temperature": Said("a table"), "that of calibration", "the temperature of the sensors";
    INITIAL_ERROR = "initial_error": Said("a table"), "none", "what the navigator's start is off by";
    ALIGNED = "alignment": Said("a table"), "navigation starts from the truth and `initial_error`", "an alignment that navigation begins with";
    RECEIVER = "gnss": Said("a table"), "none", "a satellite receiver";
    PRESSURE = "barometer": Said("a table"), "none", "a barometer";
    WHEEL = "odometer": Said("a table"), "none", "an odometer";
    STANDING = "zero_velocity": Said("a table"), "none", "what says that the vehicle stands still";
    WHEELS = "non_holonomic": Said("a table"), "none", "what says that it goes neither sideways nor up";
    FILTERED = "filter": Said("a table"), "its defaults", "how these are filtered";
    NAVIGATION = "navigator": Said("a table"), "its defaults", "how the samples are navigated";
    LINKED = "link": Said("a table"), "nothing is lost", "what happens to samples on their way";
}

table! {
    /// An alignment.
    ALIGNMENT = "[alignment]", "A filter that finds attitude and biases on the first samples, from the attitude that `initial_error` leaves; navigation begins where it ends.";
    ALIGNING = "duration_s": Number(SECONDS), "", "how long it takes";
    BASE = "base": Said("\"still\", \"swaying\", \"moving\""), "\"still\"", "what is known of the motion meanwhile: still stands, or turns about itself; swaying is displaced by decimetres in some seconds; moving has its velocity measured";
    HEADING_SIGMA = "heading_sigma_deg": Number(FIRST_HEADING), "nothing is known of it", "standard deviation of the first heading, which each run draws";
    SWAY_RMS = "sway_rms_m": Number(Range { accepted: "metres, above 0", ..Range::POSITIVE }), "0.2", "of a base that sways: rms of its displacement per axis";
    SWAY_PERIOD = "sway_period_s": Number(SECONDS), "7", "of a base that sways: its period";
    SWAY_DAMPING = "sway_damping": Number(DAMPING), "0.03", "of a base that sways: how irregular it is, half the width of its spectrum by its frequency";
    VELOCITY_SIGMA = "velocity_sigma_m_s": Number(SPEED_SIGMA), "0.05", "of a base that moves: standard deviation of a measured velocity";
    VELOCITY_EVERY = "velocity_interval_s": Number(SECONDS), "1", "of a base that moves: time from one measured velocity to the next";
}

const FIRST_HEADING: Range = Range::above(0.0, 60.0, "degrees, above 0 and at most 60");
const DAMPING: Range = Range::from_to(1e-4, 0.5, "a number from 1e-4 to 0.5");
const SPEED_SIGMA: Range = Range::above(0.0, 1e3, "m/s, above 0 and at most 1e3");

table! {
    /// How it is navigated.
    NAVIGATOR = "[navigator]", "How the samples are navigated.";
    FRAME = "frame": Said("\"local-level\", \"earth-fixed\""), "\"local-level\"", "axes of the mechanization";
    PRECISION = "precision": Said("\"f64\", \"f32\", \"f32x2\""), "\"f64\"", "arithmetic of the navigator";
    ALGORITHM = "algorithm": Said("\"taylor\", \"textbook\""), "\"taylor\"", "method of integration";
    SHAPE = "window": Said("\"auto\", \"H,B,A\" as in \"0,4,0\", or a table"), "\"auto\": the plan chooses", "the samples that taylor looks at";
    VERTICAL = "vertical": Said("\"free\", \"held\""), "\"free\"", "held: height and vertical velocity come from the truth";
    GAP = "gap": Said("\"error\", \"bridge\""), "\"error\"", "what a missing sample does";
}

table! {
    /// A window.
    WINDOW = "window = { … }", "The samples that the taylor algorithm looks at.";
    HISTORY = "history": Said("an integer"), "", "samples before the block";
    BLOCK = "block": Said("an integer"), "", "samples of the block";
    LOOKAHEAD = "lookahead": Said("an integer"), "", "samples after the block";
}

table! {
    /// A link.
    LINK = "[link]", "What happens to samples on their way.";
    LOSS = "loss": Number(limits::LOSS), "0", "the share of samples that is lost";
    JITTER = "jitter_s": Number(Range::NOT_NEGATIVE), "0", "rms of the time of a sample; at most a tenth of a sample";
}

const KELVIN: Range = Range::from_to(-1000.0, 1000.0, "K, from -1000 to 1000");
const KELVIN_A_MINUTE: Range = Range::from_to(-1e4, 1e4, "K/min, from -1e4 to 1e4");

table! {
    /// The temperature of the sensors.
    TEMPERATURE = "[temperature]", "What the sensors are warmer than when they were calibrated: a ramp, then constant.";
    OFFSET = "offset_k": Number(KELVIN), "0", "at the start";
    RAMP = "ramp_k_min": Number(KELVIN_A_MINUTE), "0", "how fast it rises, per minute";
    UNTIL = "until_s": Number(SECONDS), "the end of the flight", "when it stops to rise";
}

const SECONDS: Range = Range { accepted: "seconds, above 0", ..Range::POSITIVE };

table! {
    /// The process of the gyros, beside the terms.
    GYRO = "[gyro]", "The errors of the gyros: the keys of \"Errors of the sensors\", and one more.";
    GYRO_PROCESS = "gauss_markov": Said("{ rms_deg_h, correlation_s }"), "none", "a first-order Gauss-Markov bias";
}

table! {
    /// The process of the accelerometers, beside the terms.
    ACCELEROMETER = "[accelerometer]", "The errors of the accelerometers: the keys of \"Errors of the sensors\", and one more.";
    ACCELEROMETER_PROCESS = "gauss_markov": Said("{ rms_ug, correlation_s }"), "none", "a first-order Gauss-Markov bias";
}

table! {
    /// The process of the gyros.
    GYRO_MARKOV = "[gyro] gauss_markov = { … }", "A first-order Gauss-Markov bias; one number, or [x, y, z].";
    GYRO_RMS = "rms_deg_h": Number(Range::NOT_NEGATIVE), "", "its rms, °/h";
    GYRO_TIME = "correlation_s": Number(SECONDS), "", "its correlation time";
}

table! {
    /// The process of the accelerometers.
    ACCELEROMETER_MARKOV = "[accelerometer] gauss_markov = { … }", "A first-order Gauss-Markov bias; one number, or [x, y, z].";
    ACCELEROMETER_RMS = "rms_ug": Number(Range::NOT_NEGATIVE), "", "its rms, µg";
    ACCELEROMETER_TIME = "correlation_s": Number(SECONDS), "", "its correlation time";
}
