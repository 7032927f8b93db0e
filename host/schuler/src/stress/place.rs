//! Place: both poles, rings about one, the antimeridian, the equator, from a mine to space.

use super::case::{Case, Check, Outcome};
use super::flown::{built_in, fly, scene};
use schuler::flight::plan;
use schuler::math::compensated::Pair;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler_simulator::navigator::{self, Unavailable};
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::scene::Axes;
use schuler_simulator::simulate::{self, FlightError};
use schuler_simulator::source::Source;
use schuler_simulator::units::DEGREE;

const GROUP: &str = "place";

/// The group's cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    let mut add = |name: String, run: Box<dyn Fn(&CaseProgress) -> Outcome>| {
        cases.push(Case::new(GROUP, name, run));
    };
    for (pole, sign) in [("north", 1.0), ("south", -1.0)] {
        add(format!("across the {pole} pole, earth-fixed"), Box::new(move |p| across(sign, p)));
        add(format!("on the {pole} pole, earth-fixed"), Box::new(move |p| on_the_pole(sign, p)));
        add(format!("{pole} pole, local-level"), Box::new(move |_| refuses(sign)));
    }
    for (frame, latitude_deg) in [
        ("local-level", 89.9),
        ("local-level", -89.99),
        ("earth-fixed", 89.99),
        ("earth-fixed", -89.999),
        ("earth-fixed", 89.99999),
    ] {
        let name = format!("a ring at latitude {latitude_deg}°, {frame}");
        add(name, Box::new(move |p| ring(frame, latitude_deg, p)));
    }
    for frame in [Axes::LocalLevel, Axes::EarthFixed] {
        let name = frame.name();
        for (way, sign) in [("eastward", 1.0), ("westward", -1.0)] {
            add(
                format!("antimeridian {way}, {name}"),
                Box::new(move |p| antimeridian(sign, frame, p)),
            );
            add(format!("equator {way}, {name}"), Box::new(move |p| equator(sign, name, p)));
            add(
                format!("over the equator {way}, {name}"),
                Box::new(move |p| over_the_equator(sign, name, p)),
            );
        }
        add(format!("-400 m to 100 km, {name}"), Box::new(move |p| heights(name, p)));
    }
    cases
}

/// 250 m/s along a meridian. Next to the pole the heading against north is the position's; 75 km beyond
/// it can be told again.
fn across(sign: f64, progress: &CaseProgress) -> Outcome {
    let scene = built_in("polar", |scene| {
        scene.trajectory.latitude.offset *= sign;
        scene.trajectory.latitude.rate *= sign;
    })?;
    let flown = fly(&scene, progress)?;
    Ok(vec![
        flown.position(),
        flown.attitude("tilt", flown.tilt_arcsec, 0.0, 1.0),
        flown.attitude("attitude at the end", flown.last_attitude_arcsec, 0.0, 86.0),
    ])
}

fn on_the_pole(sign: f64, progress: &CaseProgress) -> Outcome {
    let latitude_deg = 90.0 * sign;
    let scene = scene(&format!(
        "duration_s = 1800\nrate_hz = 20\n[trajectory]\nlatitude_deg = {latitude_deg}\n\
         longitude_deg = 30\naltitude_m = 2835\nroll_deg = 3\npitch_deg = -7\n\
         yaw_deg = {{ rate = 1 }}\n[navigator]\nframe = \"earth-fixed\"\n"
    ))?;
    let flown = fly(&scene, progress)?;
    let tilt = flown.attitude("tilt", flown.tilt_arcsec, 1800.0 * DEGREE, 1.0);
    Ok(vec![flown.position(), tilt])
}

/// Where the local-level frame ends it says so: at the start, and on the way.
fn refuses(sign: f64) -> Outcome {
    let way = built_in("polar", |scene| {
        scene.trajectory.latitude.offset *= sign;
        scene.trajectory.latitude.rate *= sign;
        scene.navigator.frame = Axes::LocalLevel;
    })?;
    let flown = simulate::fly(&way, false, &mut |_| Ok(()), &|_| ());
    let on_the_way = matches!(flown, Err(FlightError::Rejected { why: Rejected::Pole, .. }));
    let mut start = way.clone();
    start.trajectory.latitude.offset = sign * 90.0 * DEGREE;
    start.trajectory.latitude.rate = 0.0;
    let source = Source::new(&start, false).map_err(|error| error.to_string())?;
    let initial = source.initial(0);
    let interval_s = Pair::new(start.rate_hz).reciprocal();
    let (window, order) = (plan::UNKNOWN, plan::HIGHEST_ORDER);
    let started = navigator::start(&start.navigator, window, order, interval_s, &initial);
    let at_the_start = matches!(started, Err(Unavailable::Start(StartError::Pole)));
    let wrong = u64::from(!on_the_way) + u64::from(!at_the_start);
    Ok(vec![Check::never("not refused", wrong, "the local-level frame has no axes at a pole")])
}

/// Round the pole in 404 s, the fastest that a scene may.
fn ring(frame: &str, latitude_deg: f64, progress: &CaseProgress) -> Outcome {
    let scene = scene(&format!(
        "duration_s = 1212\nrate_hz = 50\n[trajectory]\nlatitude_deg = {latitude_deg}\n\
         longitude_deg = {{ rate = 0.89 }}\naltitude_m = 3000\nroll_deg = 5\npitch_deg = 2\n\
         yaw_deg = {{ offset = 90, harmonics = [{{ amplitude = 3, period_s = 60 }}] }}\n\
         [navigator]\nframe = \"{frame}\"\n"
    ))?;
    let turned = 1212.0 * 0.89 * DEGREE;
    Ok(fly(&scene, progress)?.floor(turned, (latitude_deg * DEGREE).tan().abs()))
}

fn antimeridian(sign: f64, frame: Axes, progress: &CaseProgress) -> Outcome {
    let scene = built_in("cruise-180", |scene| {
        scene.trajectory.longitude.offset *= sign;
        scene.trajectory.longitude.rate *= sign;
        scene.navigator.frame = frame;
    })?;
    Ok(fly(&scene, progress)?.floor(0.0, (61.0 * DEGREE).tan()))
}

/// Along the equator at 250 m/s, with a latitude that is exactly 0.
fn equator(sign: f64, frame: &str, progress: &CaseProgress) -> Outcome {
    let rate = sign * 2.246e-3;
    let scene = scene(&format!(
        "duration_s = 1800\nrate_hz = 20\n[trajectory]\nlatitude_deg = 0\n\
         longitude_deg = {{ rate = {rate} }}\naltitude_m = 10000\nyaw_deg = 90\n\
         pitch_deg = {{ offset = 2, harmonics = [{{ amplitude = 1, period_s = 120 }}] }}\n\
         [navigator]\nframe = \"{frame}\"\n"
    ))?;
    Ok(fly(&scene, progress)?.floor(0.0, 1.0))
}

/// Over it and back, aslant.
fn over_the_equator(sign: f64, frame: &str, progress: &CaseProgress) -> Outcome {
    let rate = sign * 1.5e-3;
    let scene = scene(&format!(
        "duration_s = 1800\nrate_hz = 20\n[trajectory]\n\
         latitude_deg = {{ harmonics = [{{ amplitude = 0.4, period_s = 900, phase_deg = 30 }}] }}\n\
         longitude_deg = {{ offset = -1, rate = {rate} }}\naltitude_m = 5000\n\
         yaw_deg = {{ harmonics = [{{ amplitude = 45, period_s = 900 }}] }}\nroll_deg = 1\n\
         [navigator]\nframe = \"{frame}\"\n"
    ))?;
    Ok(fly(&scene, progress)?.floor(0.0, 1.0))
}

/// Up and down within 20 minutes, 526 m/s at most.
fn heights(frame: &str, progress: &CaseProgress) -> Outcome {
    let scene = scene(&format!(
        "duration_s = 1200\nrate_hz = 20\n[trajectory]\nlatitude_deg = 31.5\nlongitude_deg = 35.5\n\
         altitude_m = {{ offset = 49800, harmonics = [{{ amplitude = -50200, period_s = 600 }}] }}\n\
         pitch_deg = {{ harmonics = [{{ amplitude = 60, period_s = 300 }}] }}\n\
         [navigator]\nframe = \"{frame}\"\n"
    ))?;
    Ok(fly(&scene, progress)?.floor(0.0, 1.0))
}
