//! How well a path does what it was asked for.

use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::trajectory::Trajectory as _;
use schuler::trajectory::segment::compile::{Compiler, SegmentError};
use schuler::trajectory::segment::control::Controls;
use schuler::trajectory::segment::flow::Track;
use schuler::trajectory::segment::state::State;
use schuler_simulator::course::{Path, Reference};
use schuler_simulator::scene::route::Manoeuvres;

/// Looks at a segment, over its length.
const LOOKS: u32 = 16;

/// The largest distance, m, of way-points from where the path is at their times.
pub fn misfit(path: &Path, points: &[(f64, Geodetic<f64>)]) -> f64 {
    let path = Reference::Path(path.clone());
    let distance = |(time_s, place): &(f64, Geodetic<f64>)| {
        let at = path.solution_at(Pair::new(*time_s)).position.map(|x| x.hi + x.lo);
        (at.to_earth_fixed() - place.to_earth_fixed()).norm()
    };
    points.iter().map(distance).fold(0.0, f64::max)
}

/// The largest distance, m, of the pieces from the manoeuvres that they stand for, each of which is followed
/// by its own series from its beginning.
pub fn fidelity(path: &Path, flown: &Manoeuvres) -> Result<f64, SegmentError> {
    let path = Reference::Path(path.clone());
    let Manoeuvres { start, rule, segments } = flown;
    let compiler = Compiler::new(*start, *rule, segments)?;
    let mut worst = 0.0f64;
    let track = Track::new(start.position, start.course);
    let mut before = State { speed: start.speed, ..State::at_rest(track) };
    for span in compiler.spans() {
        let span = span?;
        if let Some(segment) = segments.get(span.index) {
            let failed = |fault| SegmentError { index: Some(span.index), fault };
            let controls = segment.controls(&before).map_err(failed)?;
            for look in 1..=LOOKS {
                let time_s = controls.duration_s * f64::from(look) / f64::from(LOOKS);
                let ideal = before.track.after(&Controls { duration_s: time_s, ..controls });
                let at = path.kinematics_at(Pair::new(span.start_s + time_s));
                let aside = (at.normal_e - ideal.normal_e.map(|n| n.hi)).norm();
                let height = at.altitude - ideal.altitude.hi;
                worst = worst.max((aside * schuler::earth::SEMI_MAJOR_AXIS).hypot(height));
            }
        }
        before = span.state;
    }
    Ok(worst)
}
