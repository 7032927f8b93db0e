//! Paths by manoeuvres: that they end as they say, follow what they should, and are smooth.

mod ends;
mod follows;
mod joints;
mod refused;

use schuler::earth::Geodetic;
use schuler::trajectory::hermite::TERMS;
use schuler::trajectory::piecewise::piece::Piece;
use schuler::trajectory::piecewise::{Attitude, Piecewise};
use schuler::trajectory::segment::attitude::AttitudeRule;
use schuler::trajectory::segment::compile::segment::{
    Amount, Length, Pace, Segment, Tightness, Way,
};
use schuler::trajectory::segment::compile::{Compiler, Span, Start};
use schuler::trajectory::segment::control::Line;

type Path = Piecewise<Vec<Piece<TERMS>>, TERMS>;

fn start(latitude_deg: f64, course_deg: f64, altitude: f64, speed: f64) -> Start {
    let position =
        Geodetic { latitude: latitude_deg.to_radians(), longitude: 100_f64.to_radians(), altitude };
    Start { position, course: course_deg.to_radians(), speed }
}

fn pieces(start: Start, rule: AttitudeRule, segments: &[Segment]) -> Vec<Piece<TERMS>> {
    let compiler = Compiler::new(start, rule, segments).unwrap();
    compiler.map(Result::unwrap).collect()
}

fn path(start: Start, rule: AttitudeRule, segments: &[Segment]) -> Path {
    Piecewise::new(pieces(start, rule, segments), Attitude::Stored).unwrap()
}

fn spans(start: Start, rule: AttitudeRule, segments: &[Segment]) -> Vec<Span> {
    let compiler = Compiler::new(start, rule, segments).unwrap();
    compiler.spans().map(Result::unwrap).collect()
}

/// By an angle, or to a course, in degrees.
fn turn(degrees: f64, bank_deg: f64, blend_s: f64) -> Segment {
    Segment::Turn {
        amount: Amount::By(degrees.to_radians()),
        tightness: Tightness::Bank(bank_deg.to_radians()),
        blend_s,
    }
}

fn turn_to(course_deg: f64, way: Way) -> Segment {
    Segment::Turn {
        amount: Amount::To { course: course_deg.to_radians(), way },
        tightness: Tightness::Bank(25_f64.to_radians()),
        blend_s: 4.0,
    }
}

fn straight_s(duration_s: f64) -> Segment {
    Segment::Straight { length: Length::Time(duration_s), line: Line::Geodesic }
}

fn straight_m(distance: f64, line: Line) -> Segment {
    Segment::Straight { length: Length::Distance(distance), line }
}

fn accelerate(speed: f64, blend_s: f64) -> Segment {
    Segment::Accelerate { speed, pace: Pace::Blend(blend_s) }
}

/// Stand, take off, climb, banked turns up to 60°, land, stand.
fn circuit() -> (Start, Vec<Segment>) {
    let mut segments = vec![
        Segment::Hold { duration_s: 60.0 },
        accelerate(80.0, 40.0),
        Segment::Climb { height: 1000.0, rate: 10.0, blend_s: 6.0 },
        accelerate(150.0, 60.0),
    ];
    let turns = [(90.0, 25.0, 4.0), (-120.0, 30.0, 4.0), (180.0, 45.0, 3.0), (360.0, 30.0, 4.0)];
    for (degrees, bank, blend_s) in turns {
        segments.extend([turn(degrees, bank, blend_s), straight_s(30.0)]);
    }
    segments.extend([
        turn(75.0, 60.0, 4.0),
        turn_to(30.0, Way::Left),
        Segment::Climb { height: -1000.0, rate: 8.0, blend_s: 6.0 },
        accelerate(0.0, 60.0),
        Segment::Hold { duration_s: 60.0 },
    ]);
    (start(45.0, 30.0, 300.0, 0.0), segments)
}
