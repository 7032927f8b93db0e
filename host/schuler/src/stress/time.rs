//! Time: days of rounding, the free vertical channel, step sizes, planned windows.

use super::case::{Case, Check, Outcome};
use super::floor::{self, Parabola, UNIT};
use super::flown::{built_in, fly, watch};
use schuler::earth::{EQUATORIAL_GRAVITY, SEMI_MAJOR_AXIS};
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::scene::{Axes, Precision, Scene, Vertical, WindowShape};
use schuler_simulator::simulate::largest;
use schuler_simulator::source::Source;
use schuler_simulator::units::DEGREE;
use std::f64::consts::TAU;

pub(super) const GROUP: &str = "time";
const DAY_S: f64 = 86400.0;
const FRAMES: [Axes; 2] = [Axes::LocalLevel, Axes::EarthFixed];

/// The paper's harmonics: 5° every 7200 s.
const PAPER_PERIOD_S: f64 = 7200.0;
const PAPER_SWING: f64 = 5.0 * DEGREE;
/// The tangent of its highest latitude, 50°.
const PAPER_TANGENT: f64 = 1.2;

/// Four samples to a block, so that a block's length is known.
pub(super) const FOUR: WindowShape = WindowShape { history: 0, block: 4, lookahead: 0 };

/// The group's cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for frame in FRAMES {
        let name = frame.name();
        for (days, long) in [(1.0, false), (30.0, true)] {
            let mut add = |what: &str, run: fn(Axes, f64, &CaseProgress) -> Outcome| {
                let case = Case::new(GROUP, format!("{days} d {what}, {name}"), move |progress| {
                    run(frame, days, progress)
                });
                cases.push(if long { case.long() } else { case });
            };
            add("at rest, vertical held", rest);
            add("of the paper's motion, held", paper);
        }
        cases.push(Case::new(GROUP, format!("free vertical off by 1 mm, {name}"), move |p| {
            off_by_a_millimetre(frame, p)
        }));
        cases.push(Case::new(GROUP, format!("free vertical, {name}"), move |p| {
            perfect_start(frame, p)
        }));
        for (rate_hz, duration_s) in
            [(1000.0, 300.0), (100.0, 1800.0), (10.0, 1800.0), (2.0, 1800.0), (1.0, 1800.0)]
        {
            let step_s = 1.0 / rate_hz;
            cases.push(Case::new(
                GROUP,
                format!("paper at steps of {step_s} s, {name}"),
                move |p| steps(frame, rate_hz, duration_s, p),
            ));
        }
        for (scene, rate_hz) in [
            ("stationary", 1.0),
            ("stationary", 5.0),
            ("paper-perfect", 1.0),
            ("paper-perfect", 5.0),
        ] {
            let case = format!("{scene} at {rate_hz} Hz, window planned, {name}");
            cases.push(Case::new(GROUP, case, move |p| planned(scene, frame, rate_hz, p)));
        }
    }
    cases.push(Case::new(GROUP, "1 d at rest, held, f32", rest_in_single_precision));
    cases
}

/// Nothing moves but the Earth.
pub(super) fn at_rest(duration_s: f64, rate_hz: f64) -> Result<Scene, String> {
    built_in("stationary", |scene| {
        (scene.duration_s, scene.rate_hz) = (duration_s, rate_hz);
    })
}

fn rest(frame: Axes, days: f64, progress: &CaseProgress) -> Outcome {
    let mut scene = at_rest(days * DAY_S, 10.0)?;
    (scene.navigator.frame, scene.navigator.vertical) = (frame, Vertical::Held);
    held(&scene, floor::held_m(UNIT, scene.duration_s), 1.0, progress)
}

fn rest_in_single_precision(progress: &CaseProgress) -> Outcome {
    let mut scene = at_rest(DAY_S, 10.0)?;
    (scene.navigator.precision, scene.navigator.vertical) = (Precision::F32, Vertical::Held);
    held(&scene, floor::held_m(floor::SINGLE_UNIT, scene.duration_s), 1.0, progress)
}

fn paper(frame: Axes, days: f64, progress: &CaseProgress) -> Outcome {
    let scene = built_in("paper-perfect", |scene| {
        scene.duration_s = days * DAY_S;
        // One sample a second is enough for the paper's motion, and shows the blocks' own truncation.
        scene.rate_hz = if days > 1.0 { 1.0 } else { 10.0 };
        (scene.navigator.frame, scene.navigator.vertical) = (frame, Vertical::Held);
        scene.navigator.window = Some(FOUR);
    })?;
    // The time and the phase 2πt/7200 s are rounded, each by at most UNIT of it.
    let phase = TAU / PAPER_PERIOD_S * scene.duration_s;
    let truth = 2.0 * UNIT * phase * PAPER_SWING * 2.0_f64.sqrt() * SEMI_MAJOR_AXIS;
    // The parabola's rest is a velocity d cos ωt; the Schuler swing that starts with it is at most
    // d/(ω_s − ω).
    let rest = parabola(&scene, 4.0, PAPER_PERIOD_S)?.rate;
    let swing = rest / (floor::schuler_rate() - TAU / PAPER_PERIOD_S);
    let bound_m = floor::held_m(UNIT, scene.duration_s) + truth + swing;
    held(&scene, bound_m, PAPER_TANGENT, progress)
}

/// With the vertical held the horizontal position is what is left to drift; the attitude goes with it, the
/// heading by the tangent of the latitude.
fn held(scene: &Scene, bound_m: f64, tangent: f64, progress: &CaseProgress) -> Outcome {
    let flown = fly(scene, progress)?;
    let bound_arcsec = floor::attitude_arcsec(bound_m * tangent.hypot(1.0), 0.0);
    let attitude = flown.attitude_arcsec;
    Ok(vec![
        Check::at_most("position", bound_m, flown.horizontal_m, "m", floor::HELD_WHY),
        Check::at_most("attitude", bound_arcsec, attitude, "arcsec", floor::HELD_WHY),
    ])
}

/// How far the vertical goes before the flight is over, m.
const FAR_M: f64 = 1000.0;

/// δh cosh κt leaves 1 km when theory says, and grows by κ on the way.
fn off_by_a_millimetre(frame: Axes, progress: &CaseProgress) -> Outcome {
    let start_m = 1e-3;
    let kappa = floor::vertical_rate((45.0 * DEGREE).sin());
    let expected_s = (FAR_M / start_m).acosh() / kappa;
    let mut scene = at_rest((1.02 * expected_s).ceil(), 5.0)?;
    scene.trajectory.altitude.offset = 0.0;
    scene.initial_error.position_m[2] = -start_m;
    scene.navigator.frame = frame;
    let (mut metre_s, mut far_s) = (f64::NAN, f64::NAN);
    watch(&scene, progress, &mut |instant| {
        let height = instant.drift.position_m[2].abs();
        for (time_s, at) in [(&mut metre_s, 1.0), (&mut far_s, FAR_M)] {
            if time_s.is_nan() && height >= at {
                *time_s = instant.time_s;
            }
        }
    })?;
    let rate = FAR_M.ln() / (far_s - metre_s);
    let off = |measured: f64, theory: f64| 100.0 * (measured / theory - 1.0).abs();
    // Coriolis takes (2ω cosφ)²/κ² = 0.34 % off κ², and 1 km of height 3h/a = 0.05 %.
    let why = "δh·cosh κt, less Coriolis (2ω cosφ)²/2κ² = 0.17 % and 3h/2a at 1 km = 0.02 %";
    Ok(vec![
        Check::at_most("time to 1 km off theory", 0.25, off(far_s, expected_s), "%", why),
        Check::at_most("growth off theory", 0.25, off(rate, kappa), "%", why),
    ])
}

/// From a perfect start, rounding of gravity alone must not leave 1 km any sooner than it can.
fn perfect_start(frame: Axes, progress: &CaseProgress) -> Outcome {
    let kappa = floor::vertical_rate((45.0 * DEGREE).sin());
    let offset_m = floor::ROUNDINGS * UNIT * EQUATORIAL_GRAVITY / (kappa * kappa);
    let least_s = (FAR_M / offset_m).acosh() / kappa;
    let mut scene = at_rest(18000.0, 5.0)?;
    (scene.navigator.frame, scene.navigator.window) = (frame, Some(FOUR));
    let (mut far_s, mut half_hour_m) = (f64::INFINITY, 0.0_f64);
    watch(&scene, progress, &mut |instant| {
        let height = instant.drift.position_m[2].abs();
        if instant.time_s <= 1800.0 {
            half_hour_m = largest(half_hour_m, height);
        }
        if height >= FAR_M {
            far_s = far_s.min(instant.time_s);
        }
    })?;
    let why = "8 roundings of gravity, through cosh κt";
    Ok(vec![
        Check::at_least("time to 1 km", least_s, far_s, "s", why),
        Check::at_most("within half an hour", floor::free_m(1800.0), half_hour_m, "m", why),
    ])
}

fn steps(frame: Axes, rate_hz: f64, duration_s: f64, progress: &CaseProgress) -> Outcome {
    let scene = built_in("paper-perfect", |scene| {
        (scene.duration_s, scene.rate_hz) = (duration_s, rate_hz);
        (scene.navigator.frame, scene.navigator.window) = (frame, Some(FOUR));
    })?;
    let bound_m = floor::SCENE_M + parabola(&scene, 4.0, duration_s)?.position_m;
    let flown = fly(&scene, progress)?;
    let why = "what the scene holds, and of each block T²(19/180)∇³G and T(19/720)∇⁴G";
    Ok(vec![
        Check::at_most("position", bound_m, flown.position_m, "m", why),
        Check::at_most(
            "attitude",
            floor::attitude_arcsec(2.0 * bound_m, 0.0),
            flown.attitude_arcsec,
            "arcsec",
            floor::ATTITUDE_WHY,
        ),
    ])
}

/// A window left to the plan loses no more than the shortest block there is.
fn planned(name: &str, frame: Axes, rate_hz: f64, progress: &CaseProgress) -> Outcome {
    let scene = built_in(name, |scene| {
        (scene.rate_hz, scene.navigator.frame) = (rate_hz, frame);
    })?;
    let bound_m = floor::SCENE_M + parabola(&scene, 2.0, scene.duration_s)?.position_m;
    let flown = fly(&scene, progress)?;
    let why = "the plan takes the cheapest window that loses nothing: as good as a block of two";
    Ok(vec![Check::at_most("position", bound_m, flown.position_m, "m", why)])
}

/// What gravity's parabola leaves in blocks of some samples.
fn parabola(scene: &Scene, block: f64, duration_s: f64) -> Result<Parabola, String> {
    let source = Source::new(scene, false).map_err(|error| error.to_string())?;
    Ok(Parabola::along(&source, block / scene.rate_hz, duration_s))
}
