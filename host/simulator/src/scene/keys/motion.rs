//! Channels of harmonics, and what rides on any motion.

use crate::input::Range;
use crate::input::key::Takes::{Number, Said};
use crate::table;

/// Turns of which a double still knows the 10⁻¹⁰th degree.
pub const DEGREES: Range = Range::from_to(-1e6, 1e6, "degrees, from -1e6 to 1e6");
/// What a channel of angles takes.
const ANGLE: &str = "degrees, from -1e6 to 1e6, or { offset, rate, harmonics }";
/// What a channel of lengths takes.
const LENGTH: &str = "a finite number, or { offset, rate, harmonics }";
/// What a channel of a lever takes.
const LEVER: &str = "metres, from -1000 to 1000, or { offset, rate, harmonics }";
/// Degrees of an angle in a channel.
pub const CHANNEL_ANGLE: Range = Range { accepted: ANGLE, ..DEGREES };
/// Metres in a channel.
pub const CHANNEL_LENGTH: Range = Range { accepted: LENGTH, ..Range::FINITE };
/// Metres in a channel of a lever.
pub const CHANNEL_LEVER: Range = Range::from_to(-1000.0, 1000.0, LEVER);

table! {
    /// The motion.
    TRAJECTORY = "[trajectory]", "The true motion: the channels, or `start` with `[[trajectory.segment]]`, or \
        `[trajectory.waypoints]`, or `[trajectory.log]`. A lever arm and vibration ride on any of them.";
    ROLL = "roll_deg": Number(CHANNEL_ANGLE), "0", "channel: roll";
    PITCH = "pitch_deg": Number(CHANNEL_ANGLE), "0", "channel: pitch";
    YAW = "yaw_deg": Number(CHANNEL_ANGLE), "0", "channel: yaw, from north to east";
    LATITUDE = "latitude_deg": Number(CHANNEL_ANGLE), "0", "channel: geodetic latitude; beyond 90° it goes on over the pole";
    LONGITUDE = "longitude_deg": Number(CHANNEL_ANGLE), "0", "channel: longitude, positive to the east";
    ALTITUDE = "altitude_m": Number(CHANNEL_LENGTH), "0", "channel: height above the ellipsoid";
    NORTH = "north_m": Number(CHANNEL_LENGTH), "0", "channel: metres to the north of the latitude's offset, over R_M + h there";
    EAST = "east_m": Number(CHANNEL_LENGTH), "0", "channel: metres to the east of the longitude's offset, over (R_N + h)cos φ there";
    CROSSES_POLE = "crosses_pole": Said("true, false"), "false", "whether a latitude beyond 90° is meant, and a point at a pole";
    ATTITUDE = "attitude": Said("\"coordinated\", \"upright\", \"level\", \"log\""), "\"coordinated\"; of a log that has angles, \"log\"",
        "of a path: coordinated banks so that no force is felt to the side, upright stays level to the sides as a vehicle does, level has \
         no pitch either, log takes the angles of the log";
    BEGIN = "start": Said("a table"), "must be there with segments", "where the segments begin";
    SEGMENTS = "segment": Said("a list of tables, [[trajectory.segment]]"), "no segments", "what a pilot or a driver does, one after the other";
    POINTS = "waypoints": Said("a table"), "no way-points", "a path through or past points";
    RECORD = "log": Said("a table"), "no log", "a path from a file of positions";
    SHAKEN = "vibration": Said("a table"), "none", "what shakes the unit";
    LEVER_ARM = "lever_arm_m": Number(CHANNEL_LEVER), "[0, 0, 0]", "[forward, right, down] from the path's reference point to the unit";
}

table! {
    /// A channel.
    CHANNEL = "a channel = { … }", "offset + rate·t + the sum of harmonics.";
    OFFSET = "offset": Number(DEGREES), "0", "its mean";
    SLOPE = "rate": Number(Range::FINITE), "0", "its steady change per second";
    HARMONICS = "harmonics": Said("a list of { amplitude, period_s, phase_deg }"), "none", "its oscillations";
}

table! {
    /// A harmonic.
    HARMONIC = "harmonics = [{ … }]", "amplitude·cos(2πt/period_s + phase_deg).";
    AMPLITUDE = "amplitude": Number(DEGREES), "", "in the channel's unit";
    PERIOD = "period_s": Number(Range { accepted: "seconds, above 0", ..Range::POSITIVE }), "", "its period";
    PHASE = "phase_deg": Number(DEGREES), "0", "its phase at the start; -90 makes it a sine";
}

table! {
    /// What shakes the unit.
    VIBRATION = "[trajectory.vibration]", "Channels that are added to the attitude and to the lever arm, in the body's axes.";
    VIBRATION_ROLL = "roll_deg": Number(CHANNEL_ANGLE), "0", "roll of the unit in its vehicle";
    VIBRATION_PITCH = "pitch_deg": Number(CHANNEL_ANGLE), "0", "pitch of the unit in its vehicle";
    VIBRATION_YAW = "yaw_deg": Number(CHANNEL_ANGLE), "0", "yaw of the unit in its vehicle";
    FORWARD = "forward_m": Number(CHANNEL_LEVER), "0", "added to the lever arm, forward";
    RIGHT = "right_m": Number(CHANNEL_LEVER), "0", "added to the lever arm, to the right";
    DOWN = "down_m": Number(CHANNEL_LEVER), "0", "added to the lever arm, down";
}
