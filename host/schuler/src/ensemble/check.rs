//! Which scenes can be flown as an ensemble.

use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::scene::terms::TERMS;
use schuler_simulator::scene::values::Values;
use schuler_simulator::scene::{Algorithm, Link, Scene, SensorErrors};

/// The keys of what is drawn from the seed.
const RANDOM: &str = "a scene with gauss_markov, turn_on_bias, angle_random_walk, velocity_random_walk, \
    rate_random_walk, acceleration_random_walk or bias_instability, or a σ in [initial_error]";

/// Refuses what lanes do not fly, and what theory does not speak of.
pub fn check(scene: &Scene) -> Result<(), InputError> {
    let refuse = |key: &str, what: &str, accepted: &str| {
        Err(InputError::option(key, Complaint::new(what, accepted)))
    };
    let navigator = &scene.navigator;
    if navigator.algorithm != Algorithm::Taylor {
        return refuse("algorithm", "ensembles fly no textbook", "taylor");
    }
    if scene.link != Link::default() {
        let what = "theory knows of no samples lost or late";
        return refuse("link", what, "loss = 0 and jitter_s = 0");
    }
    let sensors = is_random(&scene.gyro) || is_random(&scene.accelerometer);
    if !sensors && !scene.initial_error.is_random() && !scene.aiding.is_there() {
        let what = format!("{} has no random errors, so every run would be the same", scene.name);
        return refuse("scene", &what, RANDOM);
    }
    Ok(())
}

/// Whether anything is drawn from the seed.
fn is_random(errors: &SensorErrors) -> bool {
    let terms = TERMS.iter().filter(|term| term.source.is_random());
    let drawn = terms.filter_map(|term| (term.values)(errors));
    let rms = errors.gauss_markov.map(|process| Values::Axes(process.rms));
    drawn.chain(rms).any(|values| !values.are_zero())
}
