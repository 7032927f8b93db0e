//! The numbers that data sheets give, and the term of a scene that each stands for.

use crate::input::Range;
use crate::scene::SensorErrors;
use crate::units::{DEGREE, DEGREE_PER_HOUR, DEGREE_PER_HOUR_PER_G, MICRO_G};
use crate::units::{DEGREE_PER_ROOT_HOUR, STANDARD_GRAVITY};

/// A number of a data sheet.
pub struct Entry {
    /// Its key.
    pub key: &'static str,
    /// The key of the scene's term that it gives, of gyros or accelerometers.
    pub gives: &'static str,
    /// One of it, in the term's SI unit.
    pub factor: f64,
    /// What it may be.
    pub range: Range,
    /// Where the term lies.
    pub slot: fn(&mut SensorErrors) -> &mut Option<[f64; 3]>,
    /// What is assumed; empty where the unit alone differs.
    pub assumed: &'static str,
}

impl Entry {
    /// Whether a scene may say it, too: nothing is assumed but a unit.
    pub fn is_unit(&self) -> bool {
        self.assumed.is_empty()
    }
}

const SIZE: Range = Range::NOT_NEGATIVE;
const ANY: Range = Range::FINITE;
const LIMIT: Range = Range::POSITIVE;
/// The floor of 1/f noise over B: √(2 ln 2/π).
const FLOOR: f64 = 0.664_282_47;
const PERCENT: f64 = 0.01;

macro_rules! entries {
    ($($key:literal = $factor:expr, $gives:literal $slot:ident $range:ident $assumed:expr;)+) => {
        &[$(Entry {
            key: $key,
            gives: $gives,
            factor: $factor,
            range: $range,
            slot: |errors| &mut errors.$slot,
            assumed: $assumed,
        }),+]
    };
}

const FLICKER: &str =
    "the lowest point of the Allan curve is taken for the floor of flicker, B = σ_min/0.664";
const REPEATS: &str =
    "taken as rms, normally distributed from run to run; of a maximum enter a third";
const ROTATION: &str =
    "all cross-axis sensitivity is taken for one small rotation, alike about each axis";
const STEPS: &str = "a step of the rate, held for a sample, is taken for a step of the increments";

/// Keys of [gyro]. The steps of an output are per sample, and have to be multiplied by its length.
pub const GYRO: &[Entry] = entries! {
    "noise_density_deg_s_sqrt_hz" = DEGREE, "angle_random_walk_deg_sqrt_h" white SIZE "";
    "noise_density_mdps_sqrt_hz" = 1e-3 * DEGREE, "angle_random_walk_deg_sqrt_h" white SIZE "";
    "noise_density_deg_h_sqrt_hz" = DEGREE_PER_HOUR, "angle_random_walk_deg_sqrt_h" white SIZE "";
    "noise_density_rad_s_sqrt_hz" = 1.0, "angle_random_walk_deg_sqrt_h" white SIZE "";
    "angle_random_walk_deg_sqrt_hour" = DEGREE_PER_ROOT_HOUR, "angle_random_walk_deg_sqrt_h" white SIZE "";
    "in_run_bias_stability_deg_h" = DEGREE_PER_HOUR / FLOOR, "bias_instability_deg_h" bias_instability SIZE FLICKER;
    "in_run_bias_stability_deg_s" = DEGREE / FLOOR, "bias_instability_deg_h" bias_instability SIZE FLICKER;
    "bias_repeatability_deg_h" = DEGREE_PER_HOUR, "turn_on_bias_deg_h" turn_on SIZE REPEATS;
    "bias_repeatability_deg_s" = DEGREE, "turn_on_bias_deg_h" turn_on SIZE REPEATS;
    "offset_deg_s" = DEGREE, "constant_deg_h" constant ANY "";
    "offset_mdps" = 1e-3 * DEGREE, "constant_deg_h" constant ANY "";
    "scale_factor_percent" = PERCENT, "scale_factor_ppm" scale_factor ANY "";
    "cross_axis_percent" = PERCENT, "misalignment_arcsec" misalignment ANY ROTATION;
    "misalignment_mrad" = 1e-3, "misalignment_arcsec" misalignment ANY "";
    "misalignment_deg" = DEGREE, "misalignment_arcsec" misalignment ANY "";
    "g_sensitivity_deg_s_g" = 3600.0 * DEGREE_PER_HOUR_PER_G, "g_sensitivity_deg_h_g" g_sensitivity ANY "";
    "full_scale_deg_s" = DEGREE, "saturation_deg_s" saturation LIMIT "";
    "resolution_mdps" = 1e-3 * DEGREE, "quantization_arcsec" quantization LIMIT STEPS;
    "resolution_deg_s" = DEGREE, "quantization_arcsec" quantization LIMIT STEPS;
};

/// Keys of [accelerometer].
pub const ACCELEROMETER: &[Entry] = entries! {
    "noise_density_ug_sqrt_hz" = MICRO_G, "velocity_random_walk_m_s_sqrt_h" white SIZE "";
    "noise_density_mg_sqrt_hz" = 1e3 * MICRO_G, "velocity_random_walk_m_s_sqrt_h" white SIZE "";
    "noise_density_m_s2_sqrt_hz" = 1.0, "velocity_random_walk_m_s_sqrt_h" white SIZE "";
    "in_run_bias_stability_ug" = MICRO_G / FLOOR, "bias_instability_ug" bias_instability SIZE FLICKER;
    "in_run_bias_stability_mg" = 1e3 * MICRO_G / FLOOR, "bias_instability_ug" bias_instability SIZE FLICKER;
    "bias_repeatability_ug" = MICRO_G, "turn_on_bias_ug" turn_on SIZE REPEATS;
    "bias_repeatability_mg" = 1e3 * MICRO_G, "turn_on_bias_ug" turn_on SIZE REPEATS;
    "offset_mg" = 1e3 * MICRO_G, "constant_ug" constant ANY "";
    "scale_factor_percent" = PERCENT, "scale_factor_ppm" scale_factor ANY "";
    "cross_axis_percent" = PERCENT, "misalignment_arcsec" misalignment ANY ROTATION;
    "misalignment_mrad" = 1e-3, "misalignment_arcsec" misalignment ANY "";
    "misalignment_deg" = DEGREE, "misalignment_arcsec" misalignment ANY "";
    "full_scale_g" = STANDARD_GRAVITY, "saturation_g" saturation LIMIT "";
    "resolution_ug" = MICRO_G, "quantization_m_s" quantization LIMIT STEPS;
    "resolution_mg" = 1e3 * MICRO_G, "quantization_m_s" quantization LIMIT STEPS;
};

/// The entries of a triad, 0 or 1.
pub fn of(triad: usize) -> &'static [Entry] {
    if triad == 0 { GYRO } else { ACCELEROMETER }
}

/// What a scene has no term for.
pub const LEFT_OUT: [(&str, &str); 3] = [
    ("bandwidth_hz", "a scene has no bandwidth: noise is white up to half the sample rate"),
    ("nonlinearity_percent_fs", "a scene's sensors are linear"),
    ("temperature_coefficient_percent_k", "a scene has no temperature"),
];
