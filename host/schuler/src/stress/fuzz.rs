//! Random scenes: the plan's window against every named one, and against a run that skips nothing.

use super::case::{Case, Check, Outcome};
use super::flown::{fly, fly_forced, scene};
use schuler::strapdown::block::window::NAMED;
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::rounding::split_mix::word;
use schuler_simulator::scene::Scene;

const GROUP: &str = "plan";
/// A plan may be so many times worse than the best named window, or err by this much, m.
const TIMES_WORSE: f64 = 3.0;
const FLOOR_M: f64 = 3e-8;
/// Scenes in the short table, and with `--full`.
const SCENES: [(u64, f64); 2] = [(60, 1500.0), (300, 20_000.0)];

/// The group's cases.
pub fn cases() -> Vec<Case> {
    let [(few, short), (many, long)] = SCENES;
    let name = |count| format!("{count} random scenes");
    vec![
        Case::new(GROUP, name(few), move |progress| fuzz(few, short, progress)),
        Case::new(GROUP, name(many), move |progress| fuzz(many, long, progress)).long(),
    ]
}

/// Numbers of one scene.
struct Numbers(u64);

impl Numbers {
    fn within(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * (word(&mut self.0) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Spread evenly over orders of magnitude.
    fn magnitude(&mut self, from: f64, to: f64) -> f64 {
        self.within(from.ln(), to.ln()).exp()
    }

    fn one_in(&mut self, n: u64) -> bool {
        word(&mut self.0).is_multiple_of(n)
    }
}

/// A scene's text: a spin or swings of any channel, at rest or fast, in either frame.
pub fn text(seed: u64, most_samples: f64) -> String {
    let mut numbers = Numbers(seed);
    let rate_hz = numbers.magnitude(5.0, 400.0).round();
    let duration_s = numbers.magnitude(10.0, 2000.0).min(most_samples / rate_hz).ceil();
    let mut text = format!("duration_s = {duration_s}\nrate_hz = {rate_hz}\n[trajectory]\n");
    // (channel, offset, the largest steady rate, acceleration per unit)
    let channels = [
        ("roll_deg", 0.0, 2000.0, None),
        ("pitch_deg", 0.0, 300.0, None),
        ("yaw_deg", 30.0, 2000.0, None),
        ("latitude_deg", 40.0, 0.002, Some(1.1e5)),
        ("longitude_deg", 100.0, 0.003, Some(0.9e5)),
        ("altitude_m", 5000.0, 1.0, Some(1.0)),
    ];
    for (name, offset, fastest, metres) in channels {
        let rate = if numbers.one_in(4) { numbers.magnitude(1e-3, 1.0) * fastest } else { 0.0 };
        let mut harmonics = Vec::new();
        while harmonics.len() < 3 && numbers.one_in(3) {
            let period_s = numbers.magnitude(2.2 / rate_hz, 7200.0);
            let swing = std::f64::consts::TAU / period_s;
            let amplitude = match metres {
                None => numbers.magnitude(0.01, 40.0).min(2000.0 / swing),
                // At most 50 m/s² and 300 m/s.
                Some(metres) => {
                    let most = numbers.magnitude(1e-3, 1.0) * (50.0 / swing).min(300.0) / swing;
                    // Heights stay within 15 km of the first.
                    (if name == "altitude_m" { most.min(4500.0) } else { most }) / metres
                }
            };
            let phase = numbers.within(0.0, 360.0).round();
            harmonics.push(format!(
                "{{ amplitude = {amplitude:.3e}, period_s = {period_s:.5e}, phase_deg = {phase} }}"
            ));
        }
        let harmonics = harmonics.join(", ");
        text += &format!(
            "{name} = {{ offset = {offset}, rate = {rate:.3e}, harmonics = [{harmonics}] }}\n"
        );
    }
    let frame = if numbers.one_in(2) { "local-level" } else { "earth-fixed" };
    text + &format!("[navigator]\nframe = \"{frame}\"\n")
}

/// How far a scene's plan is beyond what it promises, as a share of it: against the best window, and
/// against a run that skips nothing. A scene that turns too fast for every window promises nothing.
fn excess(scene: &Scene, progress: &CaseProgress) -> Result<[f64; 2], String> {
    let best_m = NAMED.iter().fold(f64::INFINITY, |best, &shape| {
        let mut other = scene.clone();
        other.navigator.window = Some(shape);
        // Blocks that turn too far are refused.
        fly(&other, progress).map_or(best, |flown| best.min(flown.position_m))
    });
    if best_m.is_infinite() {
        return Ok([0.0; 2]);
    }
    let planned = fly(scene, progress)?;
    let forced = fly_forced(scene, progress)?;
    let apart_m = (planned.last_position_m - forced.last_position_m).norm();
    let apart = if scene.rate_hz > 5.0 { apart_m / FLOOR_M } else { 0.0 };
    Ok([planned.position_m / (TIMES_WORSE * best_m).max(FLOOR_M), apart])
}

fn fuzz(count: u64, most_samples: f64, progress: &CaseProgress) -> Outcome {
    let mut worst = [0.0_f64; 2];
    for seed in 1..=count {
        let text = text(seed, most_samples);
        let scene = scene(&text)?;
        let excess = excess(&scene, progress).map_err(|why| format!("{why} in\n{text}"))?;
        if excess.iter().any(|&x| x.is_nan() || x > 1.0) {
            eprintln!("# {:.2} and {:.2} of what is promised\n{text}", excess[0], excess[1]);
        }
        for (worst, excess) in worst.iter_mut().zip(excess) {
            *worst = if excess.is_nan() { excess } else { worst.max(excess) };
        }
        progress.reach(seed, count);
    }
    Ok(vec![
        Check::at_most(
            "the plan's window",
            1.0,
            worst[0],
            "",
            "3 times the best named window, or 3e-8 m; scenes beyond it are printed",
        ),
        Check::at_most(
            "apart from a run that skips nothing",
            1.0,
            worst[1],
            "",
            "3e-8 m; scenes beyond it are printed",
        ),
    ])
}
