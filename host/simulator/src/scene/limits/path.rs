//! The limits of a path, and of what rides on a motion.

use super::{ALTITUDE_M, MAX_ACCELERATION, MAX_ANGULAR_RATE, MAX_SPEED, exceeds};
use crate::course::HARMONICS;
use crate::input::Complaint;
use crate::number;
use crate::scene::route::Peak;
use crate::scene::{Scene, Trajectory};

/// A complaint with the key to blame.
type Blamed = (&'static str, Complaint);

/// Refuses a path that leaves the limits, and a flight that goes on behind its end.
pub fn check(scene: &Scene) -> Result<(), Blamed> {
    let Trajectory { path: Some(path), route: Some(route), .. } = &scene.trajectory else {
        return Ok(());
    };
    let end_s = path.end_s();
    // A sum of times rounds.
    if scene.duration_s > end_s * (1.0 + 1e-12) {
        let what = format!("{} s is beyond the path's end", scene.duration_s);
        return Err(("duration_s", Complaint::new(what, format!("seconds, at most {end_s}"))));
    }
    let key = route.from.key();
    let peaks = &route.peaks;
    let refuse = |peak: Peak, most: f64, what: &str, unit: &str| {
        if !exceeds(peak.size, most) {
            return Ok(());
        }
        let Peak { size, time_s } = peak;
        let what = format!("{what} {} {unit} at {time_s} s", number::short(size));
        Err((key, Complaint::new(what, format!("at most {most} {unit}"))))
    };
    refuse(peaks.acceleration, MAX_ACCELERATION, "jumps: is accelerated by", "m/s²")?;
    refuse(peaks.speed, MAX_SPEED, "moves by", "m/s")?;
    refuse(peaks.rate, MAX_ANGULAR_RATE, "turns by", "rad/s")?;
    for altitude in [peaks.lowest, peaks.highest] {
        if let Err(mut complaint) = ALTITUDE_M.check(altitude) {
            complaint.what = format!("reaches a height of {altitude} m, which is out of range");
            return Err((key, complaint));
        }
    }
    Ok(())
}

/// Refuses a vibration that has too many harmonics or is too violent.
pub fn mounting(motion: &Trajectory) -> Result<(), Blamed> {
    let shaken = &motion.mounting.vibration;
    let angles = [
        ("trajectory.vibration.roll_deg", &shaken.roll),
        ("trajectory.vibration.pitch_deg", &shaken.pitch),
        ("trajectory.vibration.yaw_deg", &shaken.yaw),
    ];
    let lever = [
        ("trajectory.vibration.forward_m", &shaken.forward),
        ("trajectory.vibration.right_m", &shaken.right),
        ("trajectory.vibration.down_m", &shaken.down),
    ];
    for three in [&angles, &lever] {
        let harmonics: usize = three.iter().map(|(_, channel)| channel.harmonics.len()).sum();
        if harmonics > HARMONICS {
            let accepted = format!("at most {HARMONICS} in angles, and in lengths");
            let complaint = Complaint::new(format!("has {harmonics} harmonics"), accepted);
            return Err(("trajectory.vibration", complaint));
        }
    }
    for (key, channel) in angles {
        if exceeds(channel.derivative_bound(1), MAX_ANGULAR_RATE) {
            let accepted = "what turns by at most 1e5 degrees per second";
            return Err((key, Complaint::new("turns too fast", accepted)));
        }
    }
    for (key, channel) in lever {
        if exceeds(channel.derivative_bound(2), MAX_ACCELERATION)
            || exceeds(channel.derivative_bound(1), MAX_SPEED)
        {
            let accepted = "what moves by at most 1e5 m/s and 1e5 m/s²";
            return Err((key, Complaint::new("moves too fast", accepted)));
        }
    }
    Ok(())
}
