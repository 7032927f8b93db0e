//! Sensors that aid a navigator, and its filter.

use crate::input::Range;
use crate::input::key::Takes::{Number, Said};
use crate::table;

const SECONDS: Range = Range::above(0.0, 1e6, "seconds, above 0 and at most 1e6");
const DELAY: Range = Range::from_to(0.0, 60.0, "seconds, from 0 to 60");
/// Half of what a filter remembers: 256 steps of 0.1 s.
const WAIT: Range = Range::from_to(0.0, 12.8, "seconds, from 0 to 12.8");
const HZ: Range = Range::above(0.0, 1e3, "measurements per second, above 0 and at most 1e3");
/// A probability.
pub const SHARE: Range = Range::from_to(0.0, 1.0, "a probability from 0 to 1");
/// A size in metres.
pub const METRES: Range = Range::from_to(0.0, 1e6, "metres, from 0 to 1e6");
/// A size in m/s.
pub const SPEED: Range = Range::from_to(0.0, 1e5, "m/s, from 0 to 1e5");
/// A lever arm's component.
pub const LEVER: Range = Range::from_to(-57.0, 57.0, "metres, from -57 to 57");
/// A component of a forged position.
pub const FORGED: Range = Range::from_to(-1e6, 1e6, "a number from -1e6 to 1e6");
/// What is claimed.
pub const CLAIMED: Range = Range::above(0.0, 1e6, "above 0 and at most 1e6");
const ANGLE: Range = Range::above(0.0, 180.0, "degrees, above 0 and at most 180");

/// Keys that every sensor has, in this order.
pub const LINE: [&str; 6] = ["rate_hz", "latency_s", "jitter_s", "loss", "repetition", "outages_s"];

table! {
    /// A satellite receiver.
    GNSS = "[gnss]", "A satellite receiver, whose measurements a filter takes: `run` and `ensemble` are aided then.";
    RATE = "rate_hz": Number(HZ), "1; of an odometer and of wheels 10", "measurements per second";
    LATENCY = "latency_s": Number(DELAY), "0", "how long one is on its way";
    JITTER = "jitter_s": Number(DELAY), "0", "how much longer than that at most";
    LOSS = "loss": Number(SHARE), "0", "the share that never arrives";
    REPETITION = "repetition": Number(SHARE), "0", "the share that arrives twice";
    OUTAGES = "outages_s": Said("a list of up to 8 [from, until] in seconds"), "none", "when there is nothing: after the first time, up to the second";
    REPORTS = "reports": Said("\"position\", \"velocity\", \"position-velocity\""), "\"position-velocity\"", "what it reports";
    POSITION = "position_m": Number(METRES), "1", "white noise of a position; one number, or [north, east, down]";
    VELOCITY = "velocity_m_s": Number(SPEED), "0.05", "white noise of a velocity; one number, or [north, east, down]";
    POSITION_WANDERS = "position_correlated_m": Number(METRES), "0", "rms of a Gauss-Markov error of the position; one number, or [north, east, down]";
    VELOCITY_WANDERS = "velocity_correlated_m_s": Number(SPEED), "0", "the same of the velocity";
    WANDERS = "correlation_s": Number(SECONDS), "100", "their correlation time";
    CLAIMED_POSITION = "claimed_position_m": Number(CLAIMED), "the rms of its noise", "what it says its positions are good for";
    CLAIMED_VELOCITY = "claimed_velocity_m_s": Number(CLAIMED), "the rms of its noise", "what it says its velocities are good for";
    ANTENNA = "lever_arm_m": Said("[forward, right, down], metres"), "[0, 0, 0]", "from the inertial unit to the antenna";
    OUTLIERS = "outlier_probability": Number(SHARE), "0", "the share of positions that are far off";
    OUTLIER_SIZE = "outlier_m": Number(METRES), "100", "by how much";
    SPOOFING = "spoofing": Said("{ from_s, until_s, jump_m, ramp_m_s }"), "none", "a forged position";
}

table! {
    /// A forged position.
    FORGERY = "[gnss] spoofing = { … }", "A forged position: it jumps, and then drifts away; the velocity is forged to match.";
    FROM = "from_s": Number(Range::NOT_NEGATIVE), "", "when it begins";
    UNTIL = "until_s": Number(Range::NOT_NEGATIVE), "the end of the flight", "when it ends";
    JUMP = "jump_m": Said("[north, east, down], metres"), "[0, 0, 0]", "by how much it jumps";
    RAMP = "ramp_m_s": Said("[north, east, down], m/s"), "[0, 0, 0]", "how fast it drifts";
}

table! {
    /// A barometer.
    BAROMETER = "[barometer]", "A barometer; when it measures is said as for [gnss].";
    HEIGHT = "noise_m": Number(CLAIMED), "0.5", "white noise";
    HEIGHT_BIAS = "bias_m": Number(METRES), "5", "rms of its bias, a Gauss-Markov process, which the filter estimates";
    HEIGHT_TIME = "correlation_s": Number(SECONDS), "1000", "the bias's correlation time";
    PORT = "lever_arm_m": Said("[forward, right, down], metres"), "that of the antenna", "from the inertial unit to its port";
}

table! {
    /// An odometer.
    ODOMETER = "[odometer]", "An odometer, along the vehicle's forward axis; when it measures is said as for [gnss].";
    WHEEL_NOISE = "noise_m_s": Number(CLAIMED), "0.05", "white noise";
    WHEEL_SCALE = "scale_percent": Number(Range::from_to(0.0, 50.0, "percent, from 0 to 50")), "1", "rms of its error of scale, constant in each run, which the filter estimates";
    WHEEL_STEP = "step_m_s": Number(SPEED), "0", "the step of its reading";
    WHEEL = "lever_arm_m": Said("[forward, right, down], metres"), "[0, 0, 0]", "from the inertial unit to where the wheels do not slip sideways";
}

table! {
    /// Standing still.
    ZERO_VELOCITY = "[zero_velocity]", "Says that the vehicle stands still where it does; when is said as for [gnss].";
    STILL_SIGMA = "sigma_m_s": Number(CLAIMED), "0.01", "to within what";
    STILL_LIMIT = "limit_m_s": Number(SPEED), "0.001", "the fastest motion that is taken for none";
}

table! {
    /// Wheels.
    NON_HOLONOMIC = "[non_holonomic]", "Says that the vehicle goes neither sideways nor up; when is said as for [gnss].";
    SLIP = "sigma_m_s": Number(CLAIMED), "0.1", "to within what";
}

table! {
    /// The filter.
    FILTER = "[filter]", "How an aided navigator filters its measurements.";
    LEVER_SIGMA = "lever_arm_sigma_m": Number(CLAIMED), "the lever arm is known", "standard deviation of the antenna's lever arm, which is estimated then";
    LATENCY_SIGMA = "latency_sigma_s": Number(CLAIMED), "the latency is known", "standard deviation of the receiver's latency, which is estimated then";
    GATE = "false_refusal": Number(Range::from_to(1e-12, 0.4, "a probability from 1e-12 to 0.4")), "1e-4", "how often a measurement that fits is refused";
    PATIENCE = "patience": Said("an integer from 1 to 1000"), "5", "refusals in a row that are a lockout";
    LOCKOUT = "lockout": Said("\"inflate\", \"keep\""), "\"inflate\"", "what a lockout leads to: the filter doubts itself, or goes on refusing";
    HORIZON = "horizon_s": Number(WAIT), "none", "how long measurements wait for others: bits then do not depend on transport";
    SMOOTHER = "smoother": Said("true, false"), "false", "whether the flight is smoothed afterwards: what all measurements together say of every instant";
    START_POSITION = "position_sigma_m": Number(CLAIMED), "that of [initial_error]", "what the first position is good for";
    START_VELOCITY = "velocity_sigma_m_s": Number(CLAIMED), "that of [initial_error]", "what the first velocity is good for";
    START_LEVEL = "level_sigma_deg": Number(ANGLE), "that of [initial_error]", "what the first roll and pitch are good for";
    START_HEADING = "heading_sigma_deg": Number(ANGLE), "that of [initial_error]", "what the first heading is good for; from some degrees on it is looked for";
}
