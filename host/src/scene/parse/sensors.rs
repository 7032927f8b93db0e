//! The `[gyro]` and `[accelerometer]` tables: one line per error, with its unit and its limits.

use crate::input::document::Section;
use crate::input::{InputError, Range};
use crate::scene::{GaussMarkov, SensorErrors};
use crate::units::*;

/// A key of a sensor's table: the unit of its values, what they may be, where they go.
struct Term(&'static str, f64, Range, fn(&mut SensorErrors) -> &mut Option<[f64; 3]>);

const SCALE: Range = Range::from_to(-1e6, 1e6, "ppm, from -1e6 to 1e6");
const SMALL_ANGLE: Range = Range::from_to(-36000.0, 36000.0, "arcsec, from -36000 to 36000 (10°)");
const ANY: Range = Range::FINITE;
const RMS: Range = Range::NOT_NEGATIVE;
const STEP: Range = Range::POSITIVE;

#[rustfmt::skip]
const GYRO: &[Term] = &[
    Term("constant_deg_h", DEGREE_PER_HOUR, ANY, |s| &mut s.constant),
    Term("turn_on_bias_deg_h", DEGREE_PER_HOUR, RMS, |s| &mut s.turn_on),
    Term("angle_random_walk_deg_sqrt_h", DEGREE_PER_ROOT_HOUR, RMS, |s| &mut s.white),
    Term("rate_random_walk_deg_h_sqrt_h", DEGREE_PER_HOUR_PER_ROOT_HOUR, RMS, |s| &mut s.random_walk),
    Term("bias_instability_deg_h", DEGREE_PER_HOUR, RMS, |s| &mut s.bias_instability),
    Term("scale_factor_ppm", PART_PER_MILLION, SCALE, |s| &mut s.scale_factor),
    Term("misalignment_arcsec", ARCSECOND, SMALL_ANGLE, |s| &mut s.misalignment),
    Term("g_sensitivity_deg_h_g", DEGREE_PER_HOUR_PER_G, ANY, |s| &mut s.g_sensitivity),
    Term("quantization_arcsec", ARCSECOND, STEP, |s| &mut s.quantization),
    Term("saturation_deg_s", DEGREE, STEP, |s| &mut s.saturation),
];

#[rustfmt::skip]
const ACCELEROMETER: &[Term] = &[
    Term("constant_ug", MICRO_G, ANY, |s| &mut s.constant),
    Term("turn_on_bias_ug", MICRO_G, RMS, |s| &mut s.turn_on),
    Term("velocity_random_walk_m_s_sqrt_h", METRE_PER_SECOND_PER_ROOT_HOUR, RMS, |s| &mut s.white),
    Term("acceleration_random_walk_ug_sqrt_h", MICRO_G_PER_ROOT_HOUR, RMS, |s| &mut s.random_walk),
    Term("bias_instability_ug", MICRO_G, RMS, |s| &mut s.bias_instability),
    Term("scale_factor_ppm", PART_PER_MILLION, SCALE, |s| &mut s.scale_factor),
    Term("misalignment_arcsec", ARCSECOND, SMALL_ANGLE, |s| &mut s.misalignment),
    Term("quantization_m_s", 1.0, STEP, |s| &mut s.quantization),
    Term("saturation_g", STANDARD_GRAVITY, STEP, |s| &mut s.saturation),
];

/// The `[gyro]` table: rad, rad/s.
pub fn gyro(root: &Section<'_>) -> Result<SensorErrors, InputError> {
    sensor(root, "gyro", GYRO, "rms_deg_h", DEGREE_PER_HOUR)
}

/// The `[accelerometer]` table: m/s, m/s².
pub fn accelerometer(root: &Section<'_>) -> Result<SensorErrors, InputError> {
    sensor(root, "accelerometer", ACCELEROMETER, "rms_ug", MICRO_G)
}

fn sensor(
    root: &Section<'_>,
    table: &str,
    terms: &[Term],
    rms: &str,
    rms_unit: f64,
) -> Result<SensorErrors, InputError> {
    let mut errors = SensorErrors::default();
    let mut known: Vec<_> = terms.iter().map(|term| term.0).collect();
    known.push("gauss_markov");
    let Some(section) = root.section(table, &known)? else { return Ok(errors) };
    for Term(key, unit, range, slot) in terms {
        if let Some(value) = section.get(key) {
            *slot(&mut errors) = Some(value.axes(range)?.map(|x| x * unit));
        }
    }
    if let Some(process) = section.section("gauss_markov", &[rms, "correlation_s"])? {
        let time = Range { accepted: "seconds, above 0", ..Range::POSITIVE };
        let rms = process.require(rms, RMS.accepted)?.axes(&RMS)?.map(|x| x * rms_unit);
        let correlation_s = process.require("correlation_s", time.accepted)?.axes(&time)?;
        errors.gauss_markov = Some(GaussMarkov { rms, correlation_s });
    }
    Ok(errors)
}
