//! The table of sensor error terms: what a file calls them, how the core's sensors take them, how people
//! read them, and what linear theory makes of them.
//!
//! A term whose value is one number for each axis, or a matrix, is one entry here. The Gauss-Markov process has
//! two numbers, and stands beside the table wherever it is walked.

use super::SensorErrors;
use super::felt::{self, Felt};
use super::values::Values;
use crate::input::document::Value;
use crate::input::{InputError, Range};
use crate::units::*;
use schuler::math::quaternion::Matrix;
use schuler::math::vector::Vector;
use schuler::sensor::Timing;
use schuler::sensor::bandwidth::Bandwidth;
use schuler::sensor::constant::Constant;
use schuler::sensor::flicker::Flicker;
use schuler::sensor::g_sensitivity::GSensitivity;
use schuler::sensor::g_sensitivity_matrix::GSensitivityMatrix;
use schuler::sensor::latency::{LONGEST, Latency};
use schuler::sensor::misalignment::Misalignment;
use schuler::sensor::misalignment_matrix::MisalignmentMatrix;
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::quantization::Quantization;
use schuler::sensor::random_walk::RandomWalk;
use schuler::sensor::saturation::Saturation;
use schuler::sensor::scale_factor::ScaleFactor;
use schuler::sensor::temperature::Ramp;
use schuler::sensor::temperature_bias::TemperatureBias;
use schuler::sensor::temperature_scale::TemperatureScale;
use schuler::sensor::triad::Triad;
use schuler::sensor::turn_on::TurnOn;
use schuler::sensor::white::White;

/// Sets a term of a triad to its values in SI units.
pub type Build = fn(&mut Triad<f64>, Values, &Conditions) -> Result<(), ParameterError>;

/// What terms need to know besides their values.
#[derive(Clone, Copy, Debug)]
pub struct Conditions {
    /// The sampling.
    pub timing: Timing<f64>,
    /// The sensors' temperature above that of calibration.
    pub ramp: Ramp<f64>,
}

/// An error term of a triad of gyros, of accelerometers, or of both.
pub struct Term {
    /// What people call it.
    pub name: &'static str,
    /// In the gyros' table of a file.
    pub gyro: Option<Key>,
    /// In the accelerometers' table.
    pub accelerometer: Option<Key>,
    /// What its values may be.
    pub range: Range,
    /// Whether they are a matrix: a row for each sensor.
    pub is_matrix: bool,
    /// Its values, in SI.
    pub values: fn(&SensorErrors) -> Option<Values>,
    /// Sets them, or takes them away.
    pub set: fn(&mut SensorErrors, Option<Values>),
    /// Gives it to the core's sensors.
    pub build: Build,
    /// What linear theory makes of it.
    pub source: Source,
}

impl Term {
    /// Whether its error is another one where the sensors move.
    pub fn follows_motion(&self, errors: &SensorErrors) -> bool {
        let (Source::Systematic(part), Some(values)) = (self.source, (self.values)(errors)) else {
            return false;
        };
        let felt = |x| Felt { x, f: x, warmer_k: 1.0, earlier: &|_| Vector::ZERO };
        part(values, &felt(Vector::ZERO)) != part(values, &felt(Vector::new(1.0, 1.0, 1.0)))
    }

    /// Reads its values, in the unit of the file.
    pub fn read(&self, value: &Value<'_>) -> Result<Values, InputError> {
        Ok(match self.is_matrix {
            true => Values::Rows(value.rows(&self.range)?),
            false => Values::Axes(value.axes(&self.range)?),
        })
    }
}

/// A key of a file.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Its name.
    pub key: &'static str,
    /// Its unit, in SI.
    pub unit: f64,
    /// Its unit, for people.
    pub symbol: &'static str,
}

/// What linear theory makes of a term.
#[derive(Clone, Copy, Debug)]
pub enum Source {
    /// It moves the mean: what sensors read too much, from the values k and what is felt.
    Systematic(fn(k: Values, felt: &Felt<'_>) -> Vector<f64>),
    /// A random bias that stays.
    Stays,
    /// A random bias that walks.
    Walks,
    /// Flicker.
    Flickers,
    /// White noise.
    White,
    /// Rounding to steps.
    Steps,
    /// It is left out: runs with it are not comparable where it acts.
    LeftOut,
}

impl Source {
    /// Whether it is drawn from the seed.
    pub fn is_random(self) -> bool {
        matches!(self, Self::Stays | Self::Walks | Self::Flickers | Self::White)
    }
}

const SCALE: Range = Range::from_to(-1e6, 1e6, "ppm, from -1e6 to 1e6");
const SMALL_ANGLE: Range = Range::from_to(-36000.0, 36000.0, "arcsec, from -36000 to 36000 (10°)");
// No sensor is near the greatest in any unit of a file; what is far beyond cannot be computed with.
const ANY: Range = Range::from_to(-1e12, 1e12, "a number from -1e12 to 1e12");
const RMS: Range = Range::from_to(0.0, 1e12, "a number from 0 up to 1e12");
const STEP: Range = Range::above(0.0, 1e12, "a number above 0, up to 1e12");
// The most samples that the core keeps, of the longest: those of 1 Hz. A scene's own rate allows less.
const DELAY: Range =
    Range::from_to(0.0, LONGEST as f64, "seconds, from 0 to 8 samples, so 8 at most");

const fn key(key: &'static str, unit: f64, symbol: &'static str) -> Option<Key> {
    Some(Key { key, unit, symbol })
}

macro_rules! terms {
    ($($name:literal: $field:ident $shape:ident in $range:ident, $source:expr,
        gyro $gyro:expr, accelerometer $accelerometer:expr,
        $slot:ident = $term:ident(x $(, $argument:ident)*);)+) => {
        /// All of them, in the order in which files and messages list their keys.
        pub const TERMS: &[Term] = &[$(Term {
            name: $name,
            gyro: $gyro,
            accelerometer: $accelerometer,
            range: $range,
            is_matrix: terms!(@ is_matrix $shape),
            values: |errors| errors.$field.map(Values::$shape),
            set: |errors, values| errors.$field = values.map(|values| terms!(@ take $shape values)),
            build: |triad, values, _conditions| {
                let x = terms!(@ take $shape values).into();
                triad.$slot = Some($term::new(x $(, _conditions.$argument)*)?);
                Ok(())
            },
            source: $source,
        }),+];
    };
    (@ is_matrix Axes) => { false };
    (@ is_matrix Rows) => { true };
    (@ take Axes $values:ident) => { $values.axes() };
    (@ take Rows $values:ident) => { $values.rows() };
}

terms! {
    "constant bias": constant Axes in ANY, Source::Systematic(|k, _| k.axes().into()),
        gyro key("constant_deg_h", DEGREE_PER_HOUR, "°/h"),
        accelerometer key("constant_ug", MICRO_G, "µg"),
        constant = Constant(x, timing);
    "turn-on bias, rms": turn_on Axes in RMS, Source::Stays,
        gyro key("turn_on_bias_deg_h", DEGREE_PER_HOUR, "°/h"),
        accelerometer key("turn_on_bias_ug", MICRO_G, "µg"),
        turn_on = TurnOn(x, timing);
    "angle, velocity random walk": white Axes in RMS, Source::White,
        gyro key("angle_random_walk_deg_sqrt_h", DEGREE_PER_ROOT_HOUR, "°/√h"),
        accelerometer key("velocity_random_walk_m_s_sqrt_h", METRE_PER_SECOND_PER_ROOT_HOUR, "m/s/√h"),
        white = White(x, timing);
    "rate, acceleration random walk": random_walk Axes in RMS, Source::Walks,
        gyro key("rate_random_walk_deg_h_sqrt_h", DEGREE_PER_HOUR_PER_ROOT_HOUR, "°/h/√h"),
        accelerometer key("acceleration_random_walk_ug_sqrt_h", MICRO_G_PER_ROOT_HOUR, "µg/√h"),
        random_walk = RandomWalk(x, timing);
    "bias instability": bias_instability Axes in RMS, Source::Flickers,
        gyro key("bias_instability_deg_h", DEGREE_PER_HOUR, "°/h"),
        accelerometer key("bias_instability_ug", MICRO_G, "µg"),
        flicker = Flicker(x, timing);
    // S·x
    "scale factor": scale_factor Axes in SCALE, Source::Systematic(felt::scaled),
        gyro key("scale_factor_ppm", PART_PER_MILLION, "ppm"),
        accelerometer key("scale_factor_ppm", PART_PER_MILLION, "ppm"),
        scale_factor = ScaleFactor(x);
    // −m × x
    "misalignment": misalignment Axes in SMALL_ANGLE,
        Source::Systematic(|k, felt| felt.x.cross(k.axes().into())),
        gyro key("misalignment_arcsec", ARCSECOND, "arcsec"),
        accelerometer key("misalignment_arcsec", ARCSECOND, "arcsec"),
        misalignment = Misalignment(x);
    // M·x
    "misalignment of each axis": misalignment_matrix Rows in SMALL_ANGLE,
        Source::Systematic(|k, felt| Matrix::from(k.rows()) * felt.x),
        gyro key("misalignment_matrix_arcsec", ARCSECOND, "arcsec"),
        accelerometer key("misalignment_matrix_arcsec", ARCSECOND, "arcsec"),
        misalignment_matrix = MisalignmentMatrix(x);
    // G·f
    "g-sensitivity": g_sensitivity Axes in ANY,
        Source::Systematic(|k, felt| Vector::from(k.axes()).zip(felt.f, |k, f| k * f)),
        gyro key("g_sensitivity_deg_h_g", DEGREE_PER_HOUR_PER_G, "°/h/g"),
        accelerometer None,
        g_sensitivity = GSensitivity(x);
    "g-sensitivity across axes": g_sensitivity_matrix Rows in ANY,
        Source::Systematic(|k, felt| Matrix::from(k.rows()) * felt.f),
        gyro key("g_sensitivity_matrix_deg_h_g", DEGREE_PER_HOUR_PER_G, "°/h/g"),
        accelerometer None,
        g_sensitivity_matrix = GSensitivityMatrix(x);
    // c(T − T₀), and c(T − T₀)·x
    "bias by temperature": temperature_bias Axes in ANY,
        Source::Systematic(|k, felt| Vector::from(k.axes()) * felt.warmer_k),
        gyro key("temperature_bias_deg_h_k", DEGREE_PER_HOUR, "°/h/K"),
        accelerometer key("temperature_bias_ug_k", MICRO_G, "µg/K"),
        temperature_bias = TemperatureBias(x, ramp, timing);
    "scale factor by temperature": temperature_scale Axes in SCALE,
        Source::Systematic(|k, felt| felt::scaled(k, felt) * felt.warmer_k),
        gyro key("temperature_scale_factor_ppm_k", PART_PER_MILLION, "ppm/K"),
        accelerometer key("temperature_scale_factor_ppm_k", PART_PER_MILLION, "ppm/K"),
        temperature_scale = TemperatureScale(x, ramp);
    "bandwidth": bandwidth Axes in STEP, Source::Systematic(felt::lagging),
        gyro key("bandwidth_hz", 1.0, "Hz"),
        accelerometer key("bandwidth_hz", 1.0, "Hz"),
        bandwidth = Bandwidth(x, timing);
    "latency": latency Axes in DELAY, Source::Systematic(felt::delayed),
        gyro key("latency_s", 1.0, "s"),
        accelerometer key("latency_s", 1.0, "s"),
        latency = Latency(x, timing);
    "quantization": quantization Axes in STEP, Source::Steps,
        gyro key("quantization_arcsec", ARCSECOND, "arcsec"),
        accelerometer key("quantization_m_s", 1.0, "m/s"),
        quantization = Quantization(x);
    "saturation": saturation Axes in STEP, Source::LeftOut,
        gyro key("saturation_deg_s", DEGREE, "°/s"),
        accelerometer key("saturation_g", STANDARD_GRAVITY, "g"),
        saturation = Saturation(x, timing);
}
