//! The measurements to make: scenes, rates and durations.

use crate::cli::FrontierArgs;
use schuler::trajectory::Trajectory as _;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::scene::{self, Scene, limits};
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::Source;
use std::collections::HashSet;

/// The scenes that are measured when none is named.
pub const SCENES: [&str; 6] =
    ["paper-perfect", "hard", "manoeuvre", "vibration", "coning", "stationary"];
/// The rates that are measured when none is given, Hz.
pub const RATES_HZ: [f64; 8] = [5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0];
/// How far from the scene's own rate in that list `--quick` goes: a fifth of it and five times.
const QUICK_STEP: usize = 2;
/// The motion's bandwidth times the sampling interval, at most: two samples for the fastest wave.
const COARSEST: f64 = std::f64::consts::PI;
/// Samples of one flight of `--quick`, at most; the scene is cut short for it.
const QUICK_SAMPLES: f64 = 180_000.0;

/// A scene at the rates that it is measured at.
pub struct Task {
    /// Without errors of sensors and start.
    pub scene: Scene,
    /// Ascending.
    pub rates_hz: Vec<f64>,
    /// Those of the usual rates that are too coarse for its motion.
    pub too_coarse_hz: Vec<f64>,
}

impl Task {
    /// Samples of all flights of one case.
    pub fn samples(&self) -> u64 {
        self.at_rates().map(|scene| scene.samples()).sum()
    }

    /// The scene at each rate.
    pub fn at_rates(&self) -> impl Iterator<Item = Scene> {
        self.rates_hz.iter().map(|&rate_hz| Scene { rate_hz, ..self.scene.clone() })
    }
}

/// What the options ask for, each scene once.
pub fn tasks(args: &FrontierArgs) -> Result<Vec<Task>, FlightError> {
    let named = args.scene.iter().map(String::as_str);
    let mut names: Vec<&str> = if args.scene.is_empty() { SCENES.into() } else { named.collect() };
    let mut seen = HashSet::new();
    names.retain(|name| seen.insert(*name));
    let tasks: Vec<_> = names.into_iter().map(|name| task(name, args)).collect::<Result<_, _>>()?;
    // Files tell their points apart by the scene's name.
    let mut seen = HashSet::new();
    if let Some(task) = tasks.iter().find(|task| !seen.insert(&task.scene.name)) {
        let what = format!("two scenes are called {}", task.scene.name);
        Err(InputError::option("--scene", Complaint::new(what, "different file names")))?;
    }
    Ok(tasks)
}

fn task(name: &str, args: &FrontierArgs) -> Result<Task, FlightError> {
    let mut scene = scene::load(name)?;
    (scene.gyro, scene.accelerometer) = Default::default();
    (scene.initial_error, scene.link) = Default::default();
    (scene.aiding, scene.alignment) = Default::default();
    let mut rates_hz = args.rate.clone();
    let mut too_coarse_hz = Vec::new();
    if rates_hz.is_empty() {
        let usual = if args.quick { quick_rates(scene.rate_hz) } else { RATES_HZ.into() };
        let bandwidth = Source::new(&scene, false)?.course.bound().bandwidth;
        (rates_hz, too_coarse_hz) =
            usual.into_iter().partition(|rate_hz| bandwidth <= COARSEST * rate_hz);
    }
    if rates_hz.is_empty() {
        rates_hz.push(scene.rate_hz);
    }
    rates_hz.sort_by(f64::total_cmp);
    rates_hz.dedup();
    if let (true, Some(fastest)) = (args.quick, rates_hz.last()) {
        scene.duration_s = scene.duration_s.min(QUICK_SAMPLES / fastest);
    }
    let task = Task { scene, rates_hz, too_coarse_hz };
    for scene in task.at_rates() {
        let rate_hz = scene.rate_hz;
        limits::check(&scene).map_err(|(key, complaint)| {
            let what = format!("with {rate_hz} Hz, {key} of {name} {}", complaint.what);
            InputError::option("--rate", Complaint::new(what, complaint.accepted))
        })?;
        if scene.samples() < 2 {
            let what = format!("{rate_hz} Hz leaves {name} without two samples");
            let accepted = format!("a rate above {}", 2.0 / scene.duration_s);
            Err(InputError::option("--rate", Complaint::new(what, accepted)))?;
        }
    }
    Ok(task)
}

/// The usual rate that is nearest to a scene's own, with one well below and one well above.
fn quick_rates(own_hz: f64) -> Vec<f64> {
    let distance = |rate_hz: f64| (rate_hz / own_hz).ln().abs();
    let nearest = |a: &usize, b: &usize| distance(RATES_HZ[*a]).total_cmp(&distance(RATES_HZ[*b]));
    let own = (0..RATES_HZ.len()).min_by(nearest).unwrap_or_default();
    let wanted = [own.checked_sub(QUICK_STEP), Some(own), own.checked_add(QUICK_STEP)];
    wanted.into_iter().flatten().filter_map(|n| RATES_HZ.get(n).copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plan(line: &str) -> Result<Vec<Task>, FlightError> {
        use clap::Parser;
        let words = ["schuler", "frontier"].into_iter().chain(line.split_whitespace());
        match crate::cli::Cli::try_parse_from(words).expect(line).command() {
            crate::cli::Command::Frontier(args) => tasks(&args),
            other => panic!("{line}: {other:?}"),
        }
    }

    #[test]
    fn every_scene_is_flown_at_the_rates_that_can_follow_it() {
        let tasks = plan("").expect("built in");
        let rates = |name: &str| {
            let task = tasks.iter().find(|task| task.scene.name == name).expect(name);
            assert_eq!(task.rates_hz.len() + task.too_coarse_hz.len(), RATES_HZ.len());
            (task.rates_hz[0], task.rates_hz[task.rates_hz.len() - 1])
        };
        assert_eq!(tasks.len(), SCENES.len());
        assert_eq!(rates("paper-perfect"), (5.0, 1000.0));
        assert_eq!(rates("stationary"), (5.0, 1000.0));
        assert_eq!(rates("hard"), (10.0, 1000.0));
        assert_eq!(rates("vibration"), (50.0, 1000.0));
        assert_eq!(rates("coning"), (50.0, 1000.0));
        assert!(tasks.iter().all(|task| task.scene.gyro == Default::default()));
    }

    #[test]
    fn quick_flies_fewer_rates_and_bounded_flights() {
        let tasks = plan("--quick").expect("built in");
        let rates = |name: &str| {
            &tasks.iter().find(|task| task.scene.name == name).expect(name).rates_hz[..]
        };
        assert_eq!(rates("paper-perfect"), [5.0, 20.0, 100.0]);
        assert_eq!(rates("hard"), [20.0, 100.0, 500.0]);
        assert_eq!(rates("coning"), [50.0, 200.0, 1000.0]);
        assert_eq!(quick_rates(1e5), [200.0, 1000.0]);
        let tasks = plan("--quick --scene paper --rate 20 --rate 1000 --rate 20").expect("given");
        let [task] = &tasks[..] else { panic!("one scene") };
        assert_eq!((task.scene.duration_s, &task.rates_hz[..]), (180.0, &[20.0, 1000.0][..]));
        assert_eq!(task.scene.gyro, Default::default());
        assert_eq!(task.samples(), 183_600);
        let tasks = plan("--quick --scene hard --rate 20").expect("given");
        assert_eq!(tasks[0].scene.duration_s, 60.0);
    }
}
