//! What a recording is flown with: fixes on its own time, and what its sensors are taken for.

use crate::cli::{LeverArm, ReplayArgs};
use schuler::aiding::aided::settings::Settings;
use schuler_simulator::aided::fixes::{Epoch, Fixes};
use schuler_simulator::aided::{settings, unit};
use schuler_simulator::input::name::name_of;
use schuler_simulator::input::{Complaint, InputError};
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
    /// Samples per second.
    pub rate_hz: f64,
}

/// Reads it and says what it is.
pub fn given(
    args: &ReplayArgs,
    gnss: &Path,
    recording: &Recording,
    survey: &Survey,
) -> Result<Given, InputError> {
    let aiding = &args.aiding;
    let Clock::Even { interval_s, .. } = survey.clock else {
        let what = "needs samples of a constant rate, and the stamps of the recording tell none";
        return Err(InputError::option(
            "--gnss",
            Complaint::new(what, "--rate HZ, which states it"),
        ));
    };
    let whole = (1.0 / interval_s).round();
    let rate_hz = if 1.0 / whole == interval_s { whole } else { 1.0 / interval_s };
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
    let fixes = Fixes::read(&name_of(gnss), epoch, aiding.gnss_lag, &aiding.gnss_sigma.0)?;
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
    Ok(Given { fixes, unit, settings, rate_hz })
}
