//! Paths: segments, way-points, logs.

use super::motion::DEGREES;
use crate::input::Range;
use crate::input::key::Takes::{Number, Said};
use crate::scene::limits::ALTITUDE_M;
use crate::table;

/// A geodetic latitude of a point.
pub const LATITUDE_RANGE: Range = Range::from_to(-90.0, 90.0, "degrees, from -90 to 90");
/// A longitude or a course of a point.
pub const TURN_RANGE: Range = Range::from_to(-360.0, 360.0, "degrees, from -360 to 360");
/// A speed.
pub const SPEED_RANGE: Range = Range::from_to(0.0, 1e5, "m/s, from 0 to 1e5");
/// A bank.
pub const BANK_RANGE: Range = Range::above(0.0, 85.0, "degrees, above 0 and at most 85");
const SECONDS: Range = Range::above(0.0, 1e9, "seconds, above 0 and at most 1e9");
const METRES: Range = Range::above(0.0, 1e9, "metres, above 0 and at most 1e9");

table! {
    /// Where segments begin.
    START = "[trajectory] start = { … }", "Where the segments begin.";
    START_LATITUDE = "latitude_deg": Number(LATITUDE_RANGE), "", "geodetic latitude";
    START_LONGITUDE = "longitude_deg": Number(TURN_RANGE), "", "longitude, positive to the east";
    START_ALTITUDE = "altitude_m": Number(ALTITUDE_M), "0", "height above the ellipsoid";
    START_COURSE = "course_deg": Number(TURN_RANGE), "0", "course, from north to east";
    START_SPEED = "speed_m_s": Number(SPEED_RANGE), "0", "speed at the start";
}

table! {
    /// What a pilot or a driver does.
    SEGMENT = "[[trajectory.segment]]", "What a pilot or a driver does, one after the other; each has exactly one of hold_s, \
        accelerate_to_m_s, climb_m, turn_deg, course_deg, straight_s, straight_m, rotate_deg.";
    HOLD = "hold_s": Number(SECONDS), "another", "goes on as it is: stands, or flies straight on";
    ACCELERATE = "accelerate_to_m_s": Number(SPEED_RANGE), "another", "changes its speed";
    CLIMB = "climb_m": Number(Range::from_to(-1e6, 1e6, "metres, from -1e6 to 1e6")), "another", "climbs so far; below 0 it descends";
    CLIMB_RATE = "climb_m_s": Number(SPEED_RANGE), "must be there with climb_m", "vertical speed of the climb";
    TURN = "turn_deg": Number(DEGREES), "another", "turns by so much, to the right; below 0 to the left";
    COURSE = "course_deg": Number(TURN_RANGE), "another", "turns to this course";
    BANK = "bank_deg": Number(BANK_RANGE), "radius_m in its place", "bank of the turn, which sets its radius";
    RADIUS = "radius_m": Number(METRES), "bank_deg in its place", "radius of a turn";
    STRAIGHT_TIME = "straight_s": Number(SECONDS), "another", "goes straight on for a time at its speed";
    STRAIGHT_LENGTH = "straight_m": Number(METRES), "another", "goes straight on for a distance";
    ROTATE = "rotate_deg": Said("[roll, pitch, yaw], degrees"), "another", "turns the body by so much on its path or where it stands";
    WAY = "way": Said("\"shorter\", \"left\", \"right\""), "\"shorter\"", "which way round it turns to a course";
    ACCELERATION = "acceleration_m_s2": Number(Range::above(0.0, 1e5, "m/s², above 0 and at most 1e5")), "blend_s in its place", "the largest acceleration of accelerate_to_m_s";
    BLEND = "blend_s": Number(SECONDS), "4; with accelerate_to_m_s it or acceleration_m_s2 must be there",
        "time of the smooth change at the beginning and at the end; of accelerate_to_m_s and rotate_deg the whole";
    LINE = "line": Said("\"geodesic\", \"rhumb\""), "\"geodesic\"", "what is straight";
}

table! {
    /// Way-points.
    WAYPOINTS = "[trajectory.waypoints]", "A path through points, or past them in turns.";
    MODE = "mode": Said("\"through\", \"fly-by\""), "\"through\"", "through: a smooth curve through the points; fly-by: straight legs with turns";
    WAYPOINT_LINE = "line": Said("\"geodesic\", \"rhumb\""), "\"geodesic\"", "of fly-by: what a leg is";
    WAYPOINT_BANK = "bank_deg": Number(BANK_RANGE), "25", "of fly-by: the bank of the turns";
    WAYPOINT_BLEND = "blend_s": Number(SECONDS), "4", "of fly-by: the time in which the bank is reached";
    WAYPOINT_SPEED = "speed_m_s": Number(Range::above(0.0, 1e5, "m/s, above 0 and at most 1e5")), "of the points", "the speed at all points that have none, nor a time";
    LIST = "points": Said("a list of tables"), "file in its place", "the points, in their order";
    WAYPOINT_FILE = "file": Said("the name of a GPX, KML, NMEA or RTKLIB .pos file"), "points in its place", "the points, by the file's times or at speed_m_s; relative to the scene's";
    WAYPOINT_ALTITUDE = "altitude_m": Number(ALTITUDE_M), "must be there where a point of the file has none", "height of such points";
    NEAR_ORIGIN = "near_origin": Said("true, false"), "false", "whether all points do lie within 1.6° of the equator and 3.2° of Greenwich: else they are taken for radians, and refused";
}

table! {
    /// A way-point.
    POINT = "points = [{ … }]", "A way-point; all of them have a time, or a speed.";
    POINT_LATITUDE = "latitude_deg": Number(LATITUDE_RANGE), "", "geodetic latitude";
    POINT_LONGITUDE = "longitude_deg": Number(TURN_RANGE), "", "longitude, positive to the east";
    POINT_ALTITUDE = "altitude_m": Number(ALTITUDE_M), "", "height above the ellipsoid";
    POINT_TIME = "time_s": Number(Range::from_to(0.0, 1e9, "seconds, from 0 to 1e9")), "the speed's", "when it is passed; the first at 0";
    POINT_SPEED = "speed_m_s": Number(SPEED_RANGE), "that of all", "how fast it is passed";
}

table! {
    /// A log.
    LOG = "[trajectory.log]", "A path from a CSV file with the columns time_s, latitude_deg, longitude_deg, altitude_m, and roll_deg, pitch_deg, \
        yaw_deg where the attitude is that of the log: a nav.csv is one; or from a GPX, KML, NMEA or RTKLIB .pos file with times.";
    FILE = "file": Said("the name of a file"), "", "the file, relative to the scene's";
    NOISE = "noise_m": Said("metres, from 0 up, or [horizontal, vertical]"), "0: the path meets every row, to its rounding", "rms noise of its positions, which is smoothed away";
    NOISE_ANGLE = "noise_deg": Number(Range::from_to(0.0, 45.0, "degrees, from 0 to 45")), "0", "rms noise of its angles";
    GAP = "max_gap_s": Number(SECONDS), "10 times the median of the steps", "a longer pause between rows is an error";
    LOG_NEAR_ORIGIN = "near_origin": Said("true, false"), "false", "as in way-points";
}
