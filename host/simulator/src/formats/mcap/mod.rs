//! MCAP with ROS 2 messages: `Imu`, `NavSatFix`, `PoseStamped`, in CDR.
//!
//! | topic | message |
//! |---|---|
//! | `/imu` | what the sensors read |
//! | `/truth/fix`, `/truth/pose` | the true motion |
//! | `/computed/fix`, `/computed/pose` | the computed one |
//!
//! In ROS a body's axes are forward, left, up, and an attitude is relative to east, north, up (REP 103); a pose in the
//! frame `earth` has Earth-fixed axes (REP 105). Stamps are the flight's own time.
//!
//! | file | what |
//! |---|---|
//! | [`cdr`] | bytes of a message |
//! | `schema` | definitions of the messages |

pub mod cdr;
mod schema;

use crate::input::{Complaint, InputError};
use crate::output::OutputFile;
use crate::units::DEGREE;
use cdr::Cdr;
use mcap::records::MessageHeader;
use mcap::write::NoSeek;
use mcap::{McapResult, WriteOptions, Writer};
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::sample::{Increment, Rates};
use schuler::solution::Solution;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_1_SQRT_2;
use std::path::Path;

/// Half a turn about forward: between forward, right, down and forward, left, up.
const FLIP: Quaternion<f64> = Quaternion { w: 0.0, v: Vector { x: 1.0, y: 0.0, z: 0.0 } };
/// Half a turn about north-east: between north, east, down and east, north, up.
const EAST_NORTH_UP: Quaternion<f64> =
    Quaternion { w: 0.0, v: Vector { x: FRAC_1_SQRT_2, y: FRAC_1_SQRT_2, z: 0.0 } };

/// Whose motion a message tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// What is true.
    Truth,
    /// What was computed.
    Computed,
}

/// Topics with the names and definitions of their messages.
const TOPICS: [(&str, &str, &str); 5] = [
    ("/imu", "sensor_msgs/msg/Imu", schema::IMU),
    ("/truth/fix", "sensor_msgs/msg/NavSatFix", schema::FIX),
    ("/truth/pose", "geometry_msgs/msg/PoseStamped", schema::POSE),
    ("/computed/fix", "sensor_msgs/msg/NavSatFix", schema::FIX),
    ("/computed/pose", "geometry_msgs/msg/PoseStamped", schema::POSE),
];

/// Seconds of a stamp, which has 31 bits for them.
const MOST_S: f64 = 2_147_483_647.0;

/// Writes a file of a flight, message by message; no more than a chunk of them is held in memory.
pub struct McapWriter {
    name: String,
    writer: Writer<NoSeek<OutputFile>>,
    /// Of each topic: its channel, from its first message on, and the messages so far.
    topics: [(Option<u16>, u32); TOPICS.len()],
}

impl McapWriter {
    /// To be at a path.
    ///
    /// # Errors
    ///
    /// Of the file.
    pub fn create(path: impl AsRef<Path>) -> Result<Self, InputError> {
        let name = path.as_ref().display().to_string();
        let file = OutputFile::create(path)?;
        // Pipes cannot seek.
        let options = WriteOptions::new().compression(None).disable_seeking(true);
        let options = options.profile("ros2").library("schuler");
        let writer = options.create(NoSeek::new(file)).map_err(|error| fault(&name, &error))?;
        Ok(Self { name, writer, topics: Default::default() })
    }

    /// What the sensors read at a time, s, with the attitude where that is known.
    ///
    /// # Errors
    ///
    /// Of the file, or a time that no stamp can say.
    pub fn rates(
        &mut self,
        time_s: f64,
        rates: &Rates<f64>,
        state: Option<&Solution<f64>>,
    ) -> Result<(), InputError> {
        let at = self.nanoseconds(time_s)?;
        self.put(0, at, imu(at, state, rates))
    }

    /// What the sensors read over an interval, s, that ends at a time, s: the means.
    ///
    /// # Errors
    ///
    /// As of [`Self::rates`].
    pub fn increment(
        &mut self,
        time_s: f64,
        interval_s: f64,
        increment: &Increment<f64>,
    ) -> Result<(), InputError> {
        let rates = Rates {
            rate_ib_b: increment.angle_b.map(|angle| angle / interval_s),
            specific_force_b: increment.velocity_b.map(|velocity| velocity / interval_s),
        };
        self.rates(time_s, &rates, None)
    }

    /// A state at a time, s.
    ///
    /// # Errors
    ///
    /// As of [`Self::rates`].
    pub fn state(
        &mut self,
        whose: Motion,
        time_s: f64,
        state: &Solution<f64>,
    ) -> Result<(), InputError> {
        let at = self.nanoseconds(time_s)?;
        let first = if whose == Motion::Truth { 1 } else { 3 };
        self.put(first, at, fix(at, state))?;
        self.put(first + 1, at, pose(at, state))
    }

    fn nanoseconds(&self, time_s: f64) -> Result<u64, InputError> {
        if !(0.0..MOST_S).contains(&time_s) {
            let what = format!("cannot have a message at {time_s} s");
            let accepted = format!("stamps from 0 to {MOST_S} s");
            return Err(InputError::file(&self.name, Complaint::new(what, accepted)));
        }
        let whole = time_s.floor();
        Ok(whole as u64 * 1_000_000_000 + ((time_s - whole) * 1e9).round() as u64)
    }

    fn put(&mut self, topic: usize, time: u64, message: Cdr) -> Result<(), InputError> {
        let Self { name, writer, topics } = self;
        let (channel, sequence) = &mut topics[topic];
        let write = || -> McapResult<()> {
            let channel_id = match *channel {
                Some(id) => id,
                None => {
                    let (topic, name, definition) = TOPICS[topic];
                    let schema = writer.add_schema(name, "ros2msg", definition.as_bytes())?;
                    let id = writer.add_channel(schema, topic, "cdr", &BTreeMap::new())?;
                    *channel.insert(id)
                }
            };
            let (log_time, publish_time) = (time, time);
            let header = MessageHeader { channel_id, sequence: *sequence, log_time, publish_time };
            writer.write_to_known_channel(&header, &message.bytes())
        };
        write().map_err(|error| fault(name, &error))?;
        *sequence = sequence.wrapping_add(1);
        Ok(())
    }

    /// The file with its index, whole, but not in its place yet.
    ///
    /// # Errors
    ///
    /// Of the file.
    pub fn into_file(mut self) -> Result<OutputFile, InputError> {
        self.writer.finish().map_err(|error| fault(&self.name, &error))?;
        Ok(self.writer.into_inner().into_inner())
    }
}

fn fault(name: &str, error: &dyn std::fmt::Display) -> InputError {
    InputError::file(name, Complaint::new(format!("cannot be written: {error}"), ""))
}

fn header(nanoseconds: u64, frame: &str) -> Cdr {
    let [seconds, rest] = [nanoseconds / 1_000_000_000, nanoseconds % 1_000_000_000];
    Cdr::default().u32(seconds as u32).u32(rest as u32).text(frame)
}

/// x, y, z, w.
fn quaternion(q: Quaternion<f64>) -> [f64; 4] {
    [q.v.x, q.v.y, q.v.z, q.w]
}

/// Forward, left, up.
fn left_up(v: Vector<f64>) -> [f64; 3] {
    [v.x, -v.y, -v.z]
}

/// A covariance that is not known.
const UNKNOWN: [f64; 9] = [0.0; 9];

/// The sign of an attitude that is not known (`sensor_msgs/Imu`).
const NO_ATTITUDE: [f64; 9] = [-1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

fn imu(nanoseconds: u64, state: Option<&Solution<f64>>, rates: &Rates<f64>) -> Cdr {
    let attitude = state.map(|state| state.attitude.map(|q| q.hi + q.lo));
    let to_enu = attitude.map_or(Quaternion::IDENTITY, |q| EAST_NORTH_UP * q * FLIP);
    header(nanoseconds, "base_link")
        .numbers(&quaternion(to_enu))
        .numbers(if state.is_some() { &UNKNOWN } else { &NO_ATTITUDE })
        .numbers(&left_up(rates.rate_ib_b))
        .numbers(&UNKNOWN)
        .numbers(&left_up(rates.specific_force_b))
        .numbers(&UNKNOWN)
}

fn fix(nanoseconds: u64, state: &Solution<f64>) -> Cdr {
    let at = state.position.map(|x| x.hi + x.lo);
    let longitude = at.longitude / DEGREE;
    let whole_turns = 360.0 * (longitude / 360.0).round();
    header(nanoseconds, "base_link")
        .u8(0)
        .u16(1)
        .numbers(&[at.latitude / DEGREE, longitude - whole_turns, at.altitude])
        .numbers(&UNKNOWN)
        .u8(0)
}

fn pose(nanoseconds: u64, state: &Solution<f64>) -> Cdr {
    let fixed = state.to_earth_fixed();
    let attitude = fixed.attitude.map(|q| q.hi + q.lo);
    let at = state.position.map(|x| x.hi + x.lo).to_earth_fixed();
    header(nanoseconds, "earth").numbers(&at.into_array()).numbers(&quaternion(attitude * FLIP))
}

#[cfg(test)]
mod tests {
    use super::*;
    use schuler::earth::Geodetic;
    use schuler::solution::Euler;

    fn numbers(data: &[u8], from: usize, count: usize) -> Vec<f64> {
        let number = |chunk: &[u8]| f64::from_le_bytes(chunk.try_into().expect("eight bytes"));
        data[from..from + 8 * count].chunks(8).map(number).collect()
    }

    #[test]
    fn messages_have_the_axes_of_ros() {
        let place = Geodetic { latitude: 0.0, longitude: 0.0, altitude: 100.0 };
        let euler = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
        let state = Solution::new(place, Vector::ZERO, euler);
        let rates = Rates {
            rate_ib_b: Vector::new(0.1, 0.2, 0.3),
            specific_force_b: Vector::new(1.0, 2.0, -9.8),
        };
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("flight.mcap");
        let mut writer = McapWriter::create(&path).expect("a file");
        writer.rates(1.5, &rates, Some(&state)).expect("it can be written");
        writer.state(Motion::Truth, 1.5, &state).expect("it can be written");
        for time_s in [-1e-9, 2_147_483_648.0, f64::NAN] {
            let refused = writer.state(Motion::Computed, time_s, &state);
            assert!(refused.is_err_and(|error| error.to_string().contains("stamps from 0")));
        }
        writer.into_file().and_then(OutputFile::finish).expect("it can be written");
        let bytes = std::fs::read(&path).expect("it was written");
        let read = mcap::MessageStream::new(&bytes).expect("a file");
        let read: Vec<_> = read.collect::<Result<_, _>>().expect("messages");
        let topics: Vec<_> = read.iter().map(|message| message.channel.topic.as_str()).collect();
        assert_eq!(topics, ["/imu", "/truth/fix", "/truth/pose"]);
        assert!(read.iter().all(|message| message.log_time == 1_500_000_000));
        // The head, the stamp and "base_link" take 26 bytes; numbers begin at a multiple of 8 behind the head.
        let imu = &read[0].data;
        assert_eq!(imu[4..12], [1, 0, 0, 0, 0, 0x65, 0xcd, 0x1d]);
        let orientation = numbers(imu, 28, 4);
        // Facing north is a quarter turn from east about up, or its negative.
        let size = orientation[2] * orientation[3];
        assert!(orientation[0].abs() + orientation[1].abs() < 1e-15, "{orientation:?}");
        assert!((size - 0.5).abs() < 1e-15, "{orientation:?}");
        assert_eq!(numbers(imu, 28 + 8 * 13, 3), [0.1, -0.2, -0.3]);
        assert_eq!(numbers(imu, 28 + 8 * 25, 3), [1.0, -2.0, 9.8]);
        // Status and service come first.
        let fix = numbers(&read[1].data, 36, 3);
        assert_eq!(fix, [0.0, 0.0, 100.0]);
        let pose = numbers(&read[2].data, 28, 3);
        assert_eq!(pose, [6_378_237.0, 0.0, 0.0]);
    }
}
