//! What a recording is flown with: fixes on its own time, and what its sensors are taken for.

use crate::cli::{LeverArm, ReplayArgs};
use schuler::aiding::aided::settings::Settings;
use schuler::math::compensated::Pair;
use schuler_simulator::aided::fixes::{Epoch, Fixes, Late};
use schuler_simulator::aided::{settings, unit};
use schuler_simulator::input::InputError;
use schuler_simulator::input::name::name_of;
use schuler_simulator::output::say;
use schuler_simulator::recording::clock::Clock;
use schuler_simulator::recording::instant::Scale;
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::recording::time_tag;
use schuler_simulator::scene::Scene;
use std::path::Path;

/// Fixes and sensors.
pub struct Given {
    /// What was measured.
    pub fixes: Fixes,
    /// What is said of the sensors and the filter.
    pub unit: Scene,
    /// The filter.
    pub settings: Settings<f64>,
    /// Samples per second, as they are filtered.
    pub rate_hz: f64,
    /// Their interval, s.
    pub interval: Pair<f64>,
    /// Whether they are the recording's own.
    pub is_even: bool,
}

/// Reads it and says what it is.
pub fn given(
    args: &ReplayArgs,
    gnss: &Path,
    recording: &Recording,
    survey: &Survey,
) -> Result<Given, InputError> {
    let aiding = &args.aiding;
    let usual_hz = (1.0 / survey.clock.interval_s()).round().max(1.0);
    let is_even = matches!(survey.clock, Clock::Even { .. });
    let (interval, rate_hz) = match survey.clock {
        Clock::Even { interval_s, .. } if 1.0 / usual_hz != interval_s => {
            (survey.clock.interval(), 1.0 / interval_s)
        }
        _ => (Pair::new(usual_hz).reciprocal(), usual_hz),
    };
    if !is_even {
        say(&format!(
            "samples at times of their own are cut to {usual_hz} Hz (--rate HZ, if they are even)\n"
        ))?;
    }
    let epoch = match &aiding.time_tag {
        None => recording.scale.map(|scale| Epoch { scale, ahead_s: 0.0 }),
        Some(tags) => {
            let tied = time_tag::tie(&name_of(tags), recording, survey)?;
            say(&format!(
                "{}: GPS time is the recording's and {:.3} s, by {} tags (half of them within {:.1} ms)\n",
                tags.display(),
                tied.ahead_s,
                tied.count,
                1e3 * tied.scatter_s
            ))?;
            Some(Epoch { scale: Scale::Gps, ahead_s: tied.ahead_s })
        }
    };
    let late = Late { stamps_s: aiding.gnss_lag, velocities: aiding.velocity_lag.0 };
    let fixes = Fixes::read(&name_of(gnss), epoch, late, &aiding.gnss_sigma.0)?;
    for line in &fixes.said {
        say(&format!("{line}\n"))?;
    }
    let unit = unit::unit(aiding.sensors.as_deref(), rate_hz)?;
    let mut settings = settings::of(&unit);
    if let Some(LeverArm(lever)) = aiding.lever_arm {
        settings.lever_b = lever.into();
    }
    if aiding.sensors.is_none() {
        let lines = unit::MEMS.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
        let words: Vec<_> = lines.collect();
        say(&format!(
            "the sensors are taken for those of a MEMS unit (--sensors SCENE says otherwise):\n  {}\n",
            words.join("; ").replace("];", "]").replace("; [", "\n  [")
        ))?;
    }
    Ok(Given { fixes, unit, settings, rate_hz, interval, is_even })
}
