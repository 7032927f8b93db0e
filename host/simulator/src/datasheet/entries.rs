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
    pub slot: Slot,
    /// What is assumed; empty where the unit alone differs.
    pub assumed: &'static str,
}

/// Where a term lies.
pub enum Slot {
    /// A number for each axis.
    Axes(fn(&mut SensorErrors) -> &mut Option<[f64; 3]>),
    /// The elements of a matrix off its diagonal, a number for each row.
    OffDiagonal(fn(&mut SensorErrors) -> &mut Option<[[f64; 3]; 3]>),
}

impl Slot {
    /// Sets the term; false where it is set.
    pub fn set(&self, errors: &mut SensorErrors, [x, y, z]: [f64; 3]) -> bool {
        match self {
            Self::Axes(slot) => {
                let slot = slot(errors);
                slot.is_none() && slot.replace([x, y, z]).is_none()
            }
            Self::OffDiagonal(slot) => {
                let slot = slot(errors);
                let rows = [[0.0, x, x], [y, 0.0, y], [z, z, 0.0]];
                slot.is_none() && slot.replace(rows).is_none()
            }
        }
    }
}

impl Entry {
    /// Whether it is a step of the output, which the length of a sample makes one of the increments.
    pub fn is_step(&self) -> bool {
        self.gives.starts_with("quantization")
    }

    /// Whether it is a share of the largest output.
    pub fn is_of_full_scale(&self) -> bool {
        self.key.ends_with("_percent_fs")
    }
}

const SIZE: Range = Range::NOT_NEGATIVE;
const ANY: Range = Range::FINITE;
const LIMIT: Range = Range::POSITIVE;
/// The floor of 1/f noise over B: √(2 ln 2/π).
const FLOOR: f64 = 0.664_282_47;
const PERCENT: f64 = 0.01;

macro_rules! entries {
    ($($key:literal = $factor:expr, $gives:literal $slot:ident $(($of:ident))? $range:ident $assumed:expr;)+) => {
        &[$(Entry {
            key: $key,
            gives: $gives,
            factor: $factor,
            range: $range,
            slot: entries!(@ $($of)?)(|errors| &mut errors.$slot),
            assumed: $assumed,
        }),+]
    };
    (@) => { Slot::Axes };
    (@ off_diagonal) => { Slot::OffDiagonal };
}

const FLICKER: &str =
    "the lowest point of the Allan curve is taken for the floor of flicker, B = σ_min/0.664";
const REPEATS: &str =
    "taken as rms, normally distributed from run to run; of a maximum enter a third";
const CROSS: &str = "each sensor is taken to feel so much of both other axes, with this sign";
const WARM: &str = "[temperature] of the scene says how warm it is";
const STEPS: &str = "a step of the rate, held for a sample, is taken for a step of the increments";

/// Keys of `[gyro]`. The steps of an output are per sample, and have to be multiplied by its length.
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
    "offset_percent_fs" = PERCENT, "constant_deg_h" constant ANY "";
    "scale_factor_percent" = PERCENT, "scale_factor_ppm" scale_factor ANY "";
    "cross_axis_percent" = PERCENT, "misalignment_matrix_arcsec" misalignment_matrix (off_diagonal) ANY CROSS;
    "misalignment_mrad" = 1e-3, "misalignment_arcsec" misalignment ANY "";
    "misalignment_deg" = DEGREE, "misalignment_arcsec" misalignment ANY "";
    "g_sensitivity_deg_s_g" = 3600.0 * DEGREE_PER_HOUR_PER_G, "g_sensitivity_deg_h_g" g_sensitivity ANY "";
    "temperature_bias_deg_s_k" = DEGREE, "temperature_bias_deg_h_k" temperature_bias ANY WARM;
    "temperature_bias_mdps_k" = 1e-3 * DEGREE, "temperature_bias_deg_h_k" temperature_bias ANY WARM;
    "temperature_scale_factor_percent_k" = PERCENT, "temperature_scale_factor_ppm_k" temperature_scale ANY WARM;
    "latency_ms" = 1e-3, "latency_s" latency SIZE "";
    "full_scale_deg_s" = DEGREE, "saturation_deg_s" saturation LIMIT "";
    "resolution_mdps" = 1e-3 * DEGREE, "quantization_arcsec" quantization LIMIT STEPS;
    "resolution_deg_s" = DEGREE, "quantization_arcsec" quantization LIMIT STEPS;
};

/// Keys of `[accelerometer]`.
pub const ACCELEROMETER: &[Entry] = entries! {
    "noise_density_ug_sqrt_hz" = MICRO_G, "velocity_random_walk_m_s_sqrt_h" white SIZE "";
    "noise_density_mg_sqrt_hz" = 1e3 * MICRO_G, "velocity_random_walk_m_s_sqrt_h" white SIZE "";
    "noise_density_m_s2_sqrt_hz" = 1.0, "velocity_random_walk_m_s_sqrt_h" white SIZE "";
    "in_run_bias_stability_ug" = MICRO_G / FLOOR, "bias_instability_ug" bias_instability SIZE FLICKER;
    "in_run_bias_stability_mg" = 1e3 * MICRO_G / FLOOR, "bias_instability_ug" bias_instability SIZE FLICKER;
    "bias_repeatability_ug" = MICRO_G, "turn_on_bias_ug" turn_on SIZE REPEATS;
    "bias_repeatability_mg" = 1e3 * MICRO_G, "turn_on_bias_ug" turn_on SIZE REPEATS;
    "offset_mg" = 1e3 * MICRO_G, "constant_ug" constant ANY "";
    "offset_percent_fs" = PERCENT, "constant_ug" constant ANY "";
    "scale_factor_percent" = PERCENT, "scale_factor_ppm" scale_factor ANY "";
    "cross_axis_percent" = PERCENT, "misalignment_matrix_arcsec" misalignment_matrix (off_diagonal) ANY CROSS;
    "misalignment_mrad" = 1e-3, "misalignment_arcsec" misalignment ANY "";
    "misalignment_deg" = DEGREE, "misalignment_arcsec" misalignment ANY "";
    "temperature_bias_mg_k" = 1e3 * MICRO_G, "temperature_bias_ug_k" temperature_bias ANY WARM;
    "temperature_scale_factor_percent_k" = PERCENT, "temperature_scale_factor_ppm_k" temperature_scale ANY WARM;
    "latency_ms" = 1e-3, "latency_s" latency SIZE "";
    "full_scale_g" = STANDARD_GRAVITY, "saturation_g" saturation LIMIT "";
    "resolution_ug" = MICRO_G, "quantization_m_s" quantization LIMIT STEPS;
    "resolution_mg" = 1e3 * MICRO_G, "quantization_m_s" quantization LIMIT STEPS;
};

/// The entries of a triad, 0 or 1.
pub fn of(triad: usize) -> &'static [Entry] {
    if triad == 0 { GYRO } else { ACCELEROMETER }
}

/// What a scene has no term for.
pub const LEFT_OUT: [(&str, &str); 1] =
    [("nonlinearity_percent_fs", "a scene's sensors are linear")];
