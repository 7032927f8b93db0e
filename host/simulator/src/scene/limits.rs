//! The limits of a scene, the same for its file and for the command line.

mod path;

use super::alignment::BLOCK;
use super::{Channel, Scene, SensorErrors, Trajectory, Vertical, WindowShape};
use crate::aided::smoother;
use crate::course::HARMONICS;
use crate::input::{Complaint, Range};
use crate::units::DEGREE;
use schuler::earth::SEMI_MAJOR_AXIS;
use schuler::sensor::latency::LONGEST;
use schuler::strapdown::block::window::NAMED;
use schuler::trajectory::Trajectory as _;
use std::f64::consts::TAU;

/// Length of a scene, s.
pub const DURATION_S: Range = Range::above(0.0, 1e9, "seconds, above 0 and at most 1e9");
/// Samples per second: a sample is at most 1 s long.
pub const RATE_HZ: Range = Range::from_to(1.0, 1e6, "samples per second, from 1 to 1e6");
/// Probability of loss.
pub const LOSS: Range =
    Range::from_to(0.0, 1.0 - f64::EPSILON / 2.0, "a probability from 0 to below 1");
/// Samples of one scene.
pub const MAX_SAMPLES: u64 = u32::MAX as u64;
/// Altitude, m.
pub const ALTITUDE_M: Range =
    Range::from_to(-10_000.0, 1_000_000.0, "metres, from -10000 to 1000000");
/// Rms of the link's jitter, samples: instants that far apart do not change their order.
const MAX_JITTER: f64 = 0.1;

/// Angular rate of one attitude channel, rad/s.
const MAX_ANGULAR_RATE: f64 = 1e5 * DEGREE;
/// The motion's phase within a sample, rad: 1024 panels of 8 nodes, the most that
/// [`schuler::imu::Quadrature`] takes, leave a hundredth of the rounding of it.
const MOST_PHASE: f64 = 2000.0;
/// Acceleration along one channel, m/s².
const MAX_ACCELERATION: f64 = 1e5;
/// Speed along one channel, m/s.
const MAX_SPEED: f64 = 1e5;

/// What a window may be, for people.
pub fn windows() -> String {
    let shapes: Vec<_> = NAMED.iter().map(WindowShape::to_string).collect();
    format!("\"auto\", or history,block,lookahead: {}", shapes.join("; "))
}

/// A window's shape, from its numbers.
pub fn window(history: u64, block: u64, lookahead: u64) -> Result<WindowShape, Complaint> {
    let counts = |shape: &&WindowShape| {
        [shape.history, shape.block, shape.lookahead].map(|n| n as u64)
            == [history, block, lookahead]
    };
    NAMED.iter().find(counts).copied().ok_or_else(|| {
        Complaint::new(format!("there is no window {history},{block},{lookahead}"), windows())
    })
}

/// A window's shape from text: three counts with commas between, or none of "auto".
pub fn window_of(text: &str) -> Result<Option<WindowShape>, Complaint> {
    if text == "auto" {
        return Ok(None);
    }
    let wrong = || Complaint::new(format!("\"{text}\" is not a window"), windows());
    let counts: Vec<u64> =
        text.split(',').map(|n| n.trim().parse().map_err(|_| wrong())).collect::<Result<_, _>>()?;
    let [history, block, lookahead] = counts[..] else { return Err(wrong()) };
    window(history, block, lookahead).map(Some)
}

impl Channel {
    /// The largest magnitude of the n-th derivative (n > 0), at most.
    fn derivative_bound(&self, n: i32) -> f64 {
        let steady = if n == 1 { self.rate.abs() } else { 0.0 };
        let oscillating =
            self.harmonics.iter().map(|h| (h.amplitude * h.angular_rate.powi(n)).abs());
        steady + oscillating.sum::<f64>()
    }

    /// The least and the greatest value within a time, at most.
    fn extent(&self, duration_s: f64) -> [f64; 2] {
        let swing: f64 = self.harmonics.iter().map(|h| h.amplitude.abs()).sum();
        let travel = self.rate * duration_s;
        [self.offset + travel.min(0.0) - swing, self.offset + travel.max(0.0) + swing]
    }
}

impl Trajectory {
    /// The channels with their keys.
    fn named(&self) -> [(&'static str, &Channel); 6] {
        [
            ("trajectory.roll_deg", &self.roll),
            ("trajectory.pitch_deg", &self.pitch),
            ("trajectory.yaw_deg", &self.yaw),
            ("trajectory.latitude_deg", &self.latitude),
            ("trajectory.longitude_deg", &self.longitude),
            ("trajectory.altitude_m", &self.altitude),
        ]
    }
}

/// Refuses a motion that goes through more of its phase within a sample than can be integrated.
fn sampled(motion: &Trajectory, rate_hz: f64) -> Result<(), (&'static str, Complaint)> {
    let Ok(course) = motion.build() else { return Ok(()) };
    let excess = course.bound().bandwidth / (MOST_PHASE * rate_hz);
    if !exceeds(excess, 1.0) {
        return Ok(());
    }
    if let Some(route) = &motion.route {
        let what = format!("is too fast for {rate_hz} samples per second");
        return Err((route.from.key(), Complaint::new(what, "a higher rate_hz")));
    }
    let fastest = |channel: &Channel| {
        channel
            .harmonics
            .iter()
            .filter(|h| h.amplitude != 0.0)
            .fold(0.0, |most: f64, h| most.max(h.angular_rate))
    };
    let share = |channel: &Channel| fastest(channel) + channel.derivative_bound(1);
    let named = motion.named();
    // Metres per second are no angular rate.
    let shares = named.map(|(key, channel)| match key {
        "trajectory.altitude_m" => fastest(channel),
        _ => share(channel),
    });
    let (key, channel) = named
        .into_iter()
        .zip(shares)
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .map_or(named[0], |(channel, _)| channel);
    let accepted = match fastest(channel) {
        0.0 => format!("what turns slower by a factor of {excess:.3}, or a higher rate_hz"),
        // Rounded up: what it names is accepted.
        wave => format!("periods from {:.2e} s, or a higher rate_hz", 1.01 * TAU / wave * excess),
    };
    Err((key, Complaint::new(format!("is too fast for {rate_hz} samples per second"), accepted)))
}

/// NaN, from an overflow, is beyond every limit.
fn exceeds(value: f64, most: f64) -> bool {
    value.is_nan() || value > most
}

/// What no key alone can get wrong: the first such complaint, with the key to blame.
pub fn check(scene: &Scene) -> Result<(), (&'static str, Complaint)> {
    let blame = |key, what: String, accepted: String| Err((key, Complaint::new(what, accepted)));
    let samples = scene.samples();
    if samples == 0 || samples > MAX_SAMPLES {
        return blame(
            "duration_s",
            format!("{} s at {} Hz are {samples} samples", scene.duration_s, scene.rate_hz),
            format!("what gives from 1 to {MAX_SAMPLES} samples"),
        );
    }
    path::check(scene)?;
    let motion = &scene.trajectory;
    path::mounting(motion)?;
    let named = motion.named();
    let harmonics: usize = named.iter().map(|(_, channel)| channel.harmonics.len()).sum();
    if harmonics > HARMONICS {
        let accepted = format!("at most {HARMONICS} over all channels");
        return blame("trajectory", format!("has {harmonics} harmonics"), accepted);
    }
    for (key, channel) in &named[..3] {
        if exceeds(channel.derivative_bound(1), MAX_ANGULAR_RATE) {
            let accepted = "what turns by at most 1e5 degrees per second";
            return blame(key, "turns too fast".to_owned(), accepted.to_owned());
        }
    }
    for ((key, channel), arm) in named[3..].iter().zip([SEMI_MAJOR_AXIS, SEMI_MAJOR_AXIS, 1.0]) {
        let acceleration = arm * channel.derivative_bound(2);
        if exceeds(acceleration, MAX_ACCELERATION)
            || exceeds(arm * channel.derivative_bound(1), MAX_SPEED)
        {
            let accepted = "what moves by at most 1e5 m/s and 1e5 m/s²";
            return blame(key, "moves too fast".to_owned(), accepted.to_owned());
        }
    }
    sampled(motion, scene.rate_hz)?;
    let extent = motion.altitude.extent(scene.duration_s);
    for altitude in extent.into_iter().filter(|_| motion.path.is_none()) {
        if let Err(mut complaint) = ALTITUDE_M.check(altitude) {
            complaint.what = format!("may reach {altitude} m, which is out of range");
            return Err(("trajectory.altitude_m", complaint));
        }
    }
    latency(scene)?;
    alignment(scene)?;
    aiding(scene)?;
    jitter(scene)
}

/// Measurements of a sensor per sample, at most.
const MOST_PER_SAMPLE: f64 = 4.0;

/// Refuses what does not go with aiding.
pub fn aiding(scene: &Scene) -> Result<(), (&'static str, Complaint)> {
    if !scene.aiding.is_there() {
        return Ok(());
    }
    let refuse = |key, what: &str, accepted: &str| Err((key, Complaint::new(what, accepted)));
    if scene.navigator.vertical == Vertical::Held {
        let accepted = "\"free\"; a barometer holds the vertical";
        return refuse("navigator.vertical", "is held, and aiding finds it", accepted);
    }
    if scene.link.loss > 0.0 || scene.link.jitter_s > 0.0 {
        let what = "loses or shifts samples, and an aided navigator takes every one at its time";
        return refuse("link", what, "no loss and no jitter_s");
    }
    if scene.alignment.is_some() {
        let what = "comes before navigation without aiding: a filter aligns by its measurements";
        return refuse("alignment", what, "heading_sigma_deg in [filter]");
    }
    let aiding = &scene.aiding;
    // Within a block, what many measurements correct is told apart to first order alone.
    let intervals = [
        ("gnss.rate_hz", aiding.gnss.map(|gnss| gnss.line.interval_s)),
        ("barometer.rate_hz", aiding.barometer.map(|barometer| barometer.line.interval_s)),
        ("odometer.rate_hz", aiding.odometer.map(|odometer| odometer.line.interval_s)),
    ];
    for (key, interval_s) in intervals {
        let most_hz = MOST_PER_SAMPLE * scene.rate_hz;
        if interval_s.is_some_and(|interval_s| interval_s * most_hz < 1.0 - 1e-9) {
            let accepted = format!("at most {most_hz}: four measurements per sample");
            return refuse(key, "is too fast beside the samples", &accepted);
        }
    }
    if scene.aiding.filter.smoother {
        // Measurements end steps, too; a receiver's of every sample at most.
        let fixes = scene.aiding.gnss.map_or(0.0, |gnss| scene.duration_s / gnss.line.interval_s);
        smoother::check(scene.duration_s, smoother::STEP_S, fixes as usize)
            .map_err(|complaint| ("filter.smoother", complaint))?;
    }
    Ok(())
}

/// Refuses an alignment that leaves no time for navigation, or misses samples.
fn alignment(scene: &Scene) -> Result<(), (&'static str, Complaint)> {
    let Some(alignment) = scene.alignment else { return Ok(()) };
    let block_s = BLOCK as f64 / scene.rate_hz;
    let longest_s = scene.duration_s - block_s;
    if !(block_s..=longest_s).contains(&alignment.duration_s) {
        let what =
            format!("{} s are not within the scene's {}", alignment.duration_s, scene.duration_s);
        let accepted = format!("seconds, from {} to {longest_s}", block_s);
        return Err(("alignment.duration_s", Complaint::new(what, accepted)));
    }
    if scene.link.loss > 0.0 {
        let complaint = Complaint::new("loses samples, and an alignment needs all of them", "0");
        return Err(("link.loss", complaint));
    }
    Ok(())
}

/// Refuses a latency of more samples than the core keeps.
fn latency(scene: &Scene) -> Result<(), (&'static str, Complaint)> {
    let sensors =
        [("gyro.latency_s", &scene.gyro), ("accelerometer.latency_s", &scene.accelerometer)];
    for (key, errors) in sensors {
        latency_of(errors, scene.rate_hz).map_err(|complaint| (key, complaint))?;
    }
    Ok(())
}

/// The same of one kind of sensors.
pub fn latency_of(errors: &SensorErrors, rate_hz: f64) -> Result<(), Complaint> {
    let longest_s = f64::from(LONGEST) / rate_hz;
    let mut delays = errors.latency.into_iter().flatten();
    delays.find(|delay_s| *delay_s > longest_s).map_or(Ok(()), |delay_s| {
        let what = format!("{delay_s} s is more than {LONGEST} samples");
        Err(Complaint::new(what, format!("seconds, from 0 to {longest_s}")))
    })
}

/// Refuses a jitter that would change the order of samples.
fn jitter(scene: &Scene) -> Result<(), (&'static str, Complaint)> {
    if scene.link.jitter_s * scene.rate_hz > MAX_JITTER {
        let what = format!("{} s is more than a tenth of a sample", scene.link.jitter_s);
        let accepted = format!("seconds, from 0 to {}", MAX_JITTER / scene.rate_hz);
        return Err(("link.jitter_s", Complaint::new(what, accepted)));
    }
    Ok(())
}
