//! Segments in the units of scene files.

use crate::units::DEGREE;
use schuler::trajectory::segment::compile::segment::{
    Amount, Length, Pace, Segment, Tightness, Way,
};
use schuler::trajectory::segment::control::Line;

/// `hold_s`.
pub const fn hold(duration_s: f64) -> Segment {
    Segment::Hold { duration_s }
}

/// `accelerate_to_m_s` within `blend_s`.
pub const fn accelerate(speed: f64, blend_s: f64) -> Segment {
    Segment::Accelerate { speed, pace: Pace::Blend(blend_s) }
}

/// `climb_m` at `climb_m_s`.
pub const fn climb(height: f64, rate: f64, blend_s: f64) -> Segment {
    Segment::Climb { height, rate, blend_s }
}

/// `straight_s` or `straight_m`.
pub const fn straight(length: Length) -> Segment {
    Segment::Straight { length, line: Line::Geodesic }
}

/// `turn_deg`.
pub const fn by(degrees: f64) -> Amount {
    Amount::By(degrees * DEGREE)
}

/// `course_deg`.
pub const fn to(course_deg: f64) -> Amount {
    Amount::To { course: course_deg * DEGREE, way: Way::Shorter }
}

/// A turn with `bank_deg`.
pub const fn turn(amount: Amount, bank_deg: f64, blend_s: f64) -> Segment {
    Segment::Turn { amount, tightness: Tightness::Bank(bank_deg * DEGREE), blend_s }
}

/// A turn with `radius_m`.
pub const fn radius(amount: Amount, radius_m: f64, blend_s: f64) -> Segment {
    Segment::Turn { amount, tightness: Tightness::Radius(radius_m), blend_s }
}
