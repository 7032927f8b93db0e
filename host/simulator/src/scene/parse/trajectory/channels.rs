//! Channels: each a number or offset + rate·t + harmonics, in degrees or metres.

use crate::input::document::{Section, Value};
use crate::input::key::Key;
use crate::input::{Complaint, InputError, Range};
use crate::scene::keys::motion as keys;
use crate::scene::{Channel, Trajectory};
use crate::units::DEGREE;
use schuler::earth::Radii;
use schuler::trajectory::harmonic::Harmonic;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The keys that channels have, and no path.
pub const CHANNELS: [&Key; 8] = [
    &keys::ROLL,
    &keys::PITCH,
    &keys::YAW,
    &keys::LATITUDE,
    &keys::LONGITUDE,
    &keys::ALTITUDE,
    &keys::NORTH,
    &keys::EAST,
];

/// The motion that channels describe, and whether a latitude beyond 90° is meant.
pub fn read(section: &Section<'_>, crosses_pole: bool) -> Result<Trajectory, InputError> {
    let mut motion = Trajectory {
        roll: angle(section, &keys::ROLL)?,
        pitch: angle(section, &keys::PITCH)?,
        yaw: angle(section, &keys::YAW)?,
        latitude: angle(section, &keys::LATITUDE)?,
        longitude: angle(section, &keys::LONGITUDE)?,
        altitude: length(section, &keys::ALTITUDE)?,
        ..Trajectory::default()
    };
    local_plane(section, &mut motion)?;
    let swing: f64 = motion.latitude.harmonics.iter().map(|h| h.amplitude.abs()).sum();
    if motion.latitude.offset.abs() - swing > FRAC_PI_2 && !crosses_pole {
        let at = motion.latitude.offset / DEGREE;
        let complaint = Complaint::new(
            format!("is about {at}°, beyond a pole: is it a longitude?"),
            "from -90 to 90, or crosses_pole = true",
        );
        return Err(section.blame(keys::LATITUDE.name, complaint));
    }
    Ok(motion)
}

/// Adds the metres north and east of a local plane about the offset.
fn local_plane(section: &Section<'_>, motion: &mut Trajectory) -> Result<(), InputError> {
    let (sine, cosine) = motion.latitude.offset.sin_cos();
    let radii = Radii::at(sine, cosine);
    let altitude = motion.altitude.offset;
    // φ += north/(R_M + h),  λ += east/((R_N + h) cosφ)
    motion.latitude.add(&length(section, &keys::NORTH)?, radii.meridian + altitude);
    let east = length(section, &keys::EAST)?;
    if east != Channel::default() {
        let radius = (radii.prime_vertical + altitude) * cosine;
        // 64 m from a pole a metre is a degree of longitude.
        if radius.abs() < 64.0 {
            let complaint = Complaint::new(
                "is not to be had at a pole, where there is no east",
                "an offset of the latitude off the pole",
            );
            return Err(section.blame(keys::EAST.name, complaint));
        }
        motion.longitude.add(&east, radius);
    }
    Ok(())
}

impl Channel {
    /// Adds a channel in metres, as angles of a radius.
    fn add(&mut self, metres: &Self, radius: f64) {
        self.offset += metres.offset / radius;
        self.rate += metres.rate / radius;
        let angle = |h: &Harmonic<f64>| Harmonic { amplitude: h.amplitude / radius, ..*h };
        self.harmonics.extend(metres.harmonics.iter().map(angle));
    }
}

/// A channel of an angle, 0 where it is absent.
pub fn angle(section: &Section<'_>, key: &Key) -> Result<Channel, InputError> {
    get(section, key, DEGREE, &keys::DEGREES)
}

/// A channel of a length, 0 where it is absent.
pub fn length(section: &Section<'_>, key: &Key) -> Result<Channel, InputError> {
    get(section, key, 1.0, &Range::FINITE)
}

/// A channel of a lever, 0 where it is absent.
pub fn lever(section: &Section<'_>, key: &Key) -> Result<Channel, InputError> {
    let short = Range { accepted: "metres, from -1000 to 1000", ..keys::CHANNEL_LEVER };
    get(section, key, 1.0, &short)
}

/// A channel whose numbers are in a unit; the range is that of offsets and amplitudes.
fn get(section: &Section<'_>, key: &Key, unit: f64, range: &Range) -> Result<Channel, InputError> {
    let Some(value) = section.get(key.name) else { return Ok(Channel::default()) };
    if !value.is_table() {
        let constant = Range { accepted: key.accepted(), ..*range };
        return Ok(Channel { offset: value.number(&constant)? * unit, ..Channel::default() });
    }
    let section = value.section(&keys::CHANNEL.names())?;
    let harmonics = match section.get(keys::HARMONICS.name) {
        None => Vec::new(),
        Some(list) => list
            .items(keys::HARMONICS.accepted())?
            .iter()
            .map(|item| harmonic(item, unit, range))
            .collect::<Result<_, _>>()?,
    };
    Ok(Channel {
        offset: section.number_or(keys::OFFSET.name, 0.0, range)? * unit,
        rate: section.number_or(keys::SLOPE.name, 0.0, &keys::SLOPE.range())? * unit,
        harmonics,
    })
}

fn harmonic(value: &Value<'_>, unit: f64, range: &Range) -> Result<Harmonic<f64>, InputError> {
    let section = value.section(&keys::HARMONIC.names())?;
    Ok(Harmonic {
        amplitude: section.number(keys::AMPLITUDE.name, range)? * unit,
        angular_rate: TAU / section.need(&keys::PERIOD)?,
        phase: section.read(&keys::PHASE)?.unwrap_or(0.0) * DEGREE,
    })
}
