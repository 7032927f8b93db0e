//! A scene: the flight, the sensor errors and the navigation, in SI units.
//!
//! `parse` reads it from TOML, `builtin` holds the scenes that come with the program.

pub mod aiding;
pub mod alignment;
pub mod build;
pub mod builtin;
pub mod felt;
pub mod keys;
pub mod limits;
pub mod navigator;
pub mod parse;
pub mod route;
pub mod terms;
pub mod values;
pub mod window;

use crate::course::Path;
use crate::input::document::{Document, did_you_mean};
use crate::input::name::path_of;
use crate::input::{Complaint, InputError, read_text};
pub use aiding::{Aiding, Filtering};
pub use alignment::{Alignment, Base};
pub use navigator::{Gap, Link, Navigator, Vertical};
pub use schuler::flight::configuration::{Algorithm, Axes, Precision};
pub use schuler::strapdown::block::shape::WindowShape;

use route::Route;
use schuler::trajectory::harmonic::Harmonic;
use std::sync::Arc;

/// Everything that one run needs to know.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The built-in name, or the file's stem.
    pub name: String,
    /// One line for people.
    pub title: String,
    /// SHA-256 of the text that it was read from, hex.
    pub text_sha256: String,
    /// Length, s.
    pub duration_s: f64,
    /// Inertial samples per second.
    pub rate_hz: f64,
    /// Seed of everything random.
    pub seed: u64,
    /// The true motion.
    pub trajectory: Trajectory,
    /// Gyro errors: rad, rad/s.
    pub gyro: SensorErrors,
    /// Accelerometer errors: m/s, m/s².
    pub accelerometer: SensorErrors,
    /// What the navigator's start is off by.
    pub initial_error: InitialError,
    /// What aids the navigator.
    pub aiding: Aiding,
    /// The alignment that navigation begins with, if any.
    pub alignment: Option<Alignment>,
    /// How it is navigated.
    pub navigator: Navigator,
    /// What happens to samples on their way.
    pub link: Link,
}

impl Scene {
    /// How many samples the scene has: the whole ones within its duration.
    pub fn samples(&self) -> u64 {
        (self.duration_s * self.rate_hz * (1.0 + 1e-12)).floor() as u64
    }
}

/// A built-in scene by its name, or the scene in a TOML file by its path.
pub fn load(name_or_path: &str) -> Result<Scene, InputError> {
    load_beside(name_or_path, &[])
}

/// What a built-in scene, or a TOML file that may have no more than this, says of its sensors and their filter.
pub fn load_sensors(name_or_path: &str) -> Result<Scene, InputError> {
    if let Some(scene) = builtin::scene(name_or_path) {
        return Ok(scene);
    }
    if !path_of(name_or_path).exists() {
        return load(name_or_path);
    }
    parse::sensors(name_or_path, &read_text(name_or_path)?)
}

/// The same where something else may have been meant, which has these names.
pub fn load_beside(name_or_path: &str, other: &[&str]) -> Result<Scene, InputError> {
    if let Some(scene) = builtin::scene(name_or_path) {
        return Ok(scene);
    }
    let is_path = name_or_path.contains(['/', '\\', '.']) || path_of(name_or_path).exists();
    if !is_path {
        let names = builtin::names().map(|(name, _)| name);
        let names: Vec<_> = names.chain(other.iter().copied()).collect();
        let hint = did_you_mean(name_or_path, &names);
        let accepted = format!("{}, or the path of a TOML file", builtin::list());
        let what = format!("there is no such scene{hint}");
        return Err(InputError::option(name_or_path, Complaint::new(what, accepted)));
    }
    parse::scene(name_or_path, &read_text(name_or_path)?)
}

/// Refuses a scene that begins with an alignment, or is aided, where flights start from what is known and navigate by
/// inertia alone.
pub fn unaided(scene: Scene) -> Result<Scene, InputError> {
    if scene.aiding.is_there() {
        let what = "is aided, and here navigation is by inertia alone";
        let accepted = "a scene without [gnss] and the like; run and ensemble fly it";
        return Err(InputError::option("filter", Complaint::new(what, accepted)));
    }
    unaligned(scene)
}

/// Refuses a scene that begins with an alignment, where flights start from what is known.
pub fn unaligned(scene: Scene) -> Result<Scene, InputError> {
    if scene.alignment.is_none() {
        return Ok(scene);
    }
    let what = "begins navigation with an alignment, and here it starts from what is known";
    let accepted = "a scene without [alignment]; run and ensemble fly it";
    Err(InputError::option("alignment", Complaint::new(what, accepted)))
}

/// A complaint about a key of a scene that was loaded, at its line where it is a file's.
pub fn blame(name_or_path: &str, key: &str, complaint: Complaint) -> InputError {
    if builtin::scene(name_or_path).is_some() {
        return InputError::option(key, complaint);
    }
    read_text(name_or_path).map_or_else(
        |error| error,
        |text| match Document::parse(name_or_path, &text) {
            Ok(document) => document.error(key, complaint),
            Err(error) => error,
        },
    )
}

/// The true motion: six channels, angles in rad, altitude in m; or a path in their place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trajectory {
    /// The path that is flown; the channels are not asked then.
    pub path: Option<Path>,
    /// What that was made from.
    pub route: Option<Arc<Route>>,
    /// Roll γ.
    pub roll: Channel,
    /// Pitch θ.
    pub pitch: Channel,
    /// Yaw ψ.
    pub yaw: Channel,
    /// Latitude φ.
    pub latitude: Channel,
    /// Longitude λ.
    pub longitude: Channel,
    /// Altitude h.
    pub altitude: Channel,
    /// Where the unit sits in what moves so.
    pub mounting: Mounting,
}

/// Where the unit sits in its vehicle; all of it 0 is the unit itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mounting {
    /// From the reference point of the path, forward, right, down, m.
    pub lever_arm_m: [f64; 3],
    /// What shakes it.
    pub vibration: Vibration,
}

/// What shakes a unit in its vehicle: angles in rad, added to its attitude, and lengths in m, added to its lever.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vibration {
    /// Roll.
    pub roll: Channel,
    /// Pitch.
    pub pitch: Channel,
    /// Yaw.
    pub yaw: Channel,
    /// Forward.
    pub forward: Channel,
    /// To the right.
    pub right: Channel,
    /// Down.
    pub down: Channel,
}

/// offset + rate·t + Σ harmonics.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Channel {
    /// Mean value.
    pub offset: f64,
    /// Per second.
    pub rate: f64,
    /// Oscillations.
    pub harmonics: Vec<Harmonic<f64>>,
}

/// The errors of three like sensors, a value per axis x, y, z; what is absent is perfect.
///
/// "Angle" below is the sensor's integral: rad for a gyro, m/s for an accelerometer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SensorErrors {
    /// Constant bias, angle/s.
    pub constant: Option<[f64; 3]>,
    /// Rms of a constant bias that is drawn for each run, angle/s.
    pub turn_on: Option<[f64; 3]>,
    /// First-order Gauss-Markov bias.
    pub gauss_markov: Option<GaussMarkov>,
    /// Angle or velocity random walk: white noise, angle/√s.
    pub white: Option<[f64; 3]>,
    /// Rate or acceleration random walk, angle/s/√s.
    pub random_walk: Option<[f64; 3]>,
    /// Bias instability B (flicker), angle/s.
    pub bias_instability: Option<[f64; 3]>,
    /// Relative scale factor error; positive reads too much.
    pub scale_factor: Option<[f64; 3]>,
    /// Small rotation of the sensor triad, rad.
    pub misalignment: Option<[f64; 3]>,
    /// What each sensor feels of the body axes besides its own, rad, a row for each.
    pub misalignment_matrix: Option<[[f64; 3]; 3]>,
    /// Gyro only: rad/s per m/s² along the same axis.
    pub g_sensitivity: Option<[f64; 3]>,
    /// Gyro only: rad/s per m/s² along the body axes, a row for each gyro.
    pub g_sensitivity_matrix: Option<[[f64; 3]; 3]>,
    /// Bias for each kelvin above the temperature of calibration, angle/s/K.
    pub temperature_bias: Option<[f64; 3]>,
    /// Relative scale factor error for each kelvin, 1/K.
    pub temperature_scale: Option<[f64; 3]>,
    /// The temperature that these two follow.
    pub temperature: Option<Temperature>,
    /// Frequency of −3 dB of a first-order lag, Hz.
    pub bandwidth: Option<[f64; 3]>,
    /// Delay of the motion that is read, s.
    pub latency: Option<[f64; 3]>,
    /// Least significant bit of the increments, angle.
    pub quantization: Option<[f64; 3]>,
    /// Largest output, angle/s.
    pub saturation: Option<[f64; 3]>,
}

/// The sensors' temperature above that of their calibration: a ramp, then constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temperature {
    /// At the start, K.
    pub offset_k: f64,
    /// How fast it rises, K/s.
    pub rate_k_s: f64,
    /// When it stops to rise, s.
    pub until_s: f64,
}

impl Temperature {
    /// At a time, s.
    pub fn at(&self, time_s: f64) -> f64 {
        self.offset_k + self.rate_k_s * time_s.min(self.until_s)
    }
}

/// A first-order Gauss-Markov process.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaussMarkov {
    /// Rms, angle/s.
    pub rms: [f64; 3],
    /// Correlation time, s.
    pub correlation_s: [f64; 3],
}

/// The navigator's start less the truth: what is the same in every run, and the standard deviation of what
/// each run draws on top of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InitialError {
    /// North, east, down, m.
    pub position_m: [f64; 3],
    /// North, east, down, m/s.
    pub velocity_m_s: [f64; 3],
    /// Rotation vector from the true to the computed body frame, in north, east, down, rad.
    pub attitude_rad: [f64; 3],
    /// Standard deviation of the position, m.
    pub position_sigma_m: [f64; 3],
    /// Standard deviation of the velocity, m/s.
    pub velocity_sigma_m_s: [f64; 3],
    /// Standard deviation of the attitude, rad.
    pub attitude_sigma_rad: [f64; 3],
}

impl InitialError {
    /// Whether runs draw any of it.
    pub fn is_random(&self) -> bool {
        [self.position_sigma_m, self.velocity_sigma_m_s, self.attitude_sigma_rad] != [[0.0; 3]; 3]
    }
}
