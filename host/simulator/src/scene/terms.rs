//! The table of sensor error terms: what a file calls them, how the core's sensors take them, how people
//! read them, and what linear theory makes of them.
//!
//! A term whose value is one number for each axis is one entry here. The Gauss-Markov process has two,
//! and stands beside the table wherever it is walked.

use super::SensorErrors;
use crate::input::Range;
use crate::units::*;
use schuler::math::vector::Vector;
use schuler::sensor::Timing;
use schuler::sensor::constant::Constant;
use schuler::sensor::flicker::Flicker;
use schuler::sensor::g_sensitivity::GSensitivity;
use schuler::sensor::misalignment::Misalignment;
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::quantization::Quantization;
use schuler::sensor::random_walk::RandomWalk;
use schuler::sensor::saturation::Saturation;
use schuler::sensor::scale_factor::ScaleFactor;
use schuler::sensor::triad::Triad;
use schuler::sensor::turn_on::TurnOn;
use schuler::sensor::white::White;

/// Sets a term of a triad to its values in SI units.
pub type Build = fn(&mut Triad<f64>, Vector<f64>, Timing<f64>) -> Result<(), ParameterError>;

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
    /// Its values, in SI.
    pub values: fn(&SensorErrors) -> Option<[f64; 3]>,
    /// The same, to be set.
    pub values_mut: fn(&mut SensorErrors) -> &mut Option<[f64; 3]>,
    /// Gives it to the core's sensors.
    pub build: Build,
    /// What linear theory makes of it.
    pub source: Source,
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
    /// It moves the mean: what sensors read too much, from the values k, the reading x and the specific
    /// force f.
    Systematic(fn(k: Vector<f64>, x: Vector<f64>, f: Vector<f64>) -> Vector<f64>),
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
const ANY: Range = Range::FINITE;
const RMS: Range = Range::NOT_NEGATIVE;
const STEP: Range = Range::POSITIVE;

const fn key(key: &'static str, unit: f64, symbol: &'static str) -> Option<Key> {
    Some(Key { key, unit, symbol })
}

macro_rules! terms {
    ($($name:literal: $field:ident in $range:ident, $source:expr,
        gyro $gyro:expr, accelerometer $accelerometer:expr,
        $slot:ident = $term:ident($($argument:ident),+);)+) => {
        /// All of them, in the order in which files and messages list their keys.
        pub const TERMS: &[Term] = &[$(Term {
            name: $name,
            gyro: $gyro,
            accelerometer: $accelerometer,
            range: $range,
            values: |errors| errors.$field,
            values_mut: |errors| &mut errors.$field,
            build: |triad, terms!(@ x $($argument)+), terms!(@ timing $($argument)+)| {
                triad.$slot = Some($term::new($($argument),+)?);
                Ok(())
            },
            source: $source,
        }),+];
    };
    (@ x $x:ident) => { $x };
    (@ x $x:ident $timing:ident) => { $x };
    (@ timing $x:ident) => { _ };
    (@ timing $x:ident $timing:ident) => { $timing };
}

terms! {
    "constant bias": constant in ANY, Source::Systematic(|k, _, _| k),
        gyro key("constant_deg_h", DEGREE_PER_HOUR, "°/h"),
        accelerometer key("constant_ug", MICRO_G, "µg"),
        constant = Constant(x, timing);
    "turn-on bias, rms": turn_on in RMS, Source::Stays,
        gyro key("turn_on_bias_deg_h", DEGREE_PER_HOUR, "°/h"),
        accelerometer key("turn_on_bias_ug", MICRO_G, "µg"),
        turn_on = TurnOn(x, timing);
    "angle, velocity random walk": white in RMS, Source::White,
        gyro key("angle_random_walk_deg_sqrt_h", DEGREE_PER_ROOT_HOUR, "°/√h"),
        accelerometer key("velocity_random_walk_m_s_sqrt_h", METRE_PER_SECOND_PER_ROOT_HOUR, "m/s/√h"),
        white = White(x, timing);
    "rate, acceleration random walk": random_walk in RMS, Source::Walks,
        gyro key("rate_random_walk_deg_h_sqrt_h", DEGREE_PER_HOUR_PER_ROOT_HOUR, "°/h/√h"),
        accelerometer key("acceleration_random_walk_ug_sqrt_h", MICRO_G_PER_ROOT_HOUR, "µg/√h"),
        random_walk = RandomWalk(x, timing);
    "bias instability": bias_instability in RMS, Source::Flickers,
        gyro key("bias_instability_deg_h", DEGREE_PER_HOUR, "°/h"),
        accelerometer key("bias_instability_ug", MICRO_G, "µg"),
        flicker = Flicker(x, timing);
    // S·x
    "scale factor": scale_factor in SCALE, Source::Systematic(|k, x, _| k.zip(x, |k, x| k * x)),
        gyro key("scale_factor_ppm", PART_PER_MILLION, "ppm"),
        accelerometer key("scale_factor_ppm", PART_PER_MILLION, "ppm"),
        scale_factor = ScaleFactor(x);
    // −m × x
    "misalignment": misalignment in SMALL_ANGLE, Source::Systematic(|k, x, _| x.cross(k)),
        gyro key("misalignment_arcsec", ARCSECOND, "arcsec"),
        accelerometer key("misalignment_arcsec", ARCSECOND, "arcsec"),
        misalignment = Misalignment(x);
    // G·f
    "g-sensitivity": g_sensitivity in ANY, Source::Systematic(|k, _, f| k.zip(f, |k, f| k * f)),
        gyro key("g_sensitivity_deg_h_g", DEGREE_PER_HOUR_PER_G, "°/h/g"),
        accelerometer None,
        g_sensitivity = GSensitivity(x);
    "quantization": quantization in STEP, Source::Steps,
        gyro key("quantization_arcsec", ARCSECOND, "arcsec"),
        accelerometer key("quantization_m_s", 1.0, "m/s"),
        quantization = Quantization(x);
    "saturation": saturation in STEP, Source::LeftOut,
        gyro key("saturation_deg_s", DEGREE, "°/s"),
        accelerometer key("saturation_g", STANDARD_GRAVITY, "g"),
        saturation = Saturation(x, timing);
}
