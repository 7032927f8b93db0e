//! MCAP with ROS 2 messages: `Imu`, `NavSatFix`, `PoseStamped`, in CDR.
//!
//! In ROS a body's axes are forward, left, up, and an attitude is relative to east, north, up (REP 103); a pose in the
//! frame `earth` has Earth-fixed axes (REP 105). Stamps are the flight's own time, from 0.
//!
//! | file | what |
//! |---|---|
//! | [`cdr`] | bytes of a message |
//! | `schema` | definitions of the messages |

pub mod cdr;
mod schema;

use crate::units::DEGREE;
use cdr::Cdr;
use mcap::records::MessageHeader;
use mcap::{McapResult, WriteOptions, Writer};
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::sample::Rates;
use schuler::solution::Solution;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_1_SQRT_2;
use std::io::{Seek, Write};

/// Half a turn about forward: between forward, right, down and forward, left, up.
const FLIP: Quaternion<f64> = Quaternion { w: 0.0, v: Vector { x: 1.0, y: 0.0, z: 0.0 } };
/// Half a turn about north-east: between north, east, down and east, north, up.
const EAST_NORTH_UP: Quaternion<f64> =
    Quaternion { w: 0.0, v: Vector { x: FRAC_1_SQRT_2, y: FRAC_1_SQRT_2, z: 0.0 } };

/// Writes a file of a flight.
pub struct McapWriter<W: Write + Seek> {
    writer: Writer<W>,
    imu: u16,
    fix: u16,
    pose: u16,
    sequence: u32,
}

impl<W: Write + Seek> McapWriter<W> {
    /// To a file or into memory.
    ///
    /// # Errors
    ///
    /// Of the file.
    pub fn new(to: W) -> McapResult<Self> {
        let options = WriteOptions::new().compression(None).profile("ros2").library("schuler");
        let mut writer = options.create(to)?;
        let mut channel = |topic: &str, name: &str, schema: &str| {
            let schema = writer.add_schema(name, "ros2msg", schema.as_bytes())?;
            writer.add_channel(schema, topic, "cdr", &BTreeMap::new())
        };
        let imu = channel("/imu", "sensor_msgs/msg/Imu", schema::IMU)?;
        let fix = channel("/fix", "sensor_msgs/msg/NavSatFix", schema::FIX)?;
        let pose = channel("/pose", "geometry_msgs/msg/PoseStamped", schema::POSE)?;
        Ok(Self { writer, imu, fix, pose, sequence: 0 })
    }

    /// The state at a time, s, and what the sensors read there.
    ///
    /// # Errors
    ///
    /// Of the file.
    pub fn row(
        &mut self,
        time_s: f64,
        state: &Solution<f64>,
        rates: &Rates<f64>,
    ) -> McapResult<()> {
        let nanoseconds = (time_s * 1e9).round().max(0.0) as u64;
        let attitude = state.attitude.map(|q| q.hi + q.lo);
        self.put(self.imu, nanoseconds, imu(nanoseconds, attitude, rates))?;
        self.put(self.fix, nanoseconds, fix(nanoseconds, state))?;
        self.put(self.pose, nanoseconds, pose(nanoseconds, state))?;
        self.sequence += 1;
        Ok(())
    }

    fn put(&mut self, channel_id: u16, time: u64, message: Cdr) -> McapResult<()> {
        let header = MessageHeader {
            channel_id,
            sequence: self.sequence,
            log_time: time,
            publish_time: time,
        };
        self.writer.write_to_known_channel(&header, &message.bytes())
    }

    /// Writes the index at the end.
    ///
    /// # Errors
    ///
    /// Of the file.
    pub fn finish(&mut self) -> McapResult<()> {
        self.writer.finish().map(drop)
    }
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

fn imu(nanoseconds: u64, body_to_ned: Quaternion<f64>, rates: &Rates<f64>) -> Cdr {
    header(nanoseconds, "base_link")
        .numbers(&quaternion(EAST_NORTH_UP * body_to_ned * FLIP))
        .numbers(&UNKNOWN)
        .numbers(&left_up(rates.rate_ib_b))
        .numbers(&UNKNOWN)
        .numbers(&left_up(rates.specific_force_b))
        .numbers(&UNKNOWN)
}

fn fix(nanoseconds: u64, state: &Solution<f64>) -> Cdr {
    let at = state.position.map(|x| x.hi + x.lo);
    header(nanoseconds, "base_link")
        .u8(0)
        .u16(1)
        .numbers(&[at.latitude / DEGREE, at.longitude / DEGREE, at.altitude])
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
    use std::io::Cursor;

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
        let mut bytes = Cursor::new(Vec::new());
        let mut writer = McapWriter::new(&mut bytes).expect("memory");
        writer.row(1.5, &state, &rates).expect("memory");
        writer.finish().expect("memory");
        drop(writer);
        let bytes = bytes.into_inner();
        let read = mcap::MessageStream::new(&bytes).expect("a file");
        let read: Vec<_> = read.collect::<Result<_, _>>().expect("messages");
        let topics: Vec<_> = read.iter().map(|message| message.channel.topic.as_str()).collect();
        assert_eq!(topics, ["/imu", "/fix", "/pose"]);
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
