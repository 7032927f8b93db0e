//! The audit program: flies short scenes in the core's types, one of them aided, and prints the digest of every stage.
//!
//! The same source on every target; only `platform` knows where it runs. With a standard library it
//! takes the name of a flight, such as `paper/f32-local-level-textbook` or `turns/noise`, and prints
//! its chain, row by row.

#![cfg_attr(not(feature = "std"), no_std, no_main)]

mod aided;
#[cfg(feature = "std")]
mod chain_file;
mod configuration;
mod lines;
mod platform;
mod recording;
mod scene;
mod truth;

use lines::Lines;
use scene::{MOST_SAMPLES, SCENES};
use schuler::sample::Increment;
use truth::Refused;

#[cfg(feature = "std")]
fn main() -> std::process::ExitCode {
    platform::main()
}

/// Flies everything, and prints its digests.
fn digests() -> Result<(), Refused> {
    let mut samples = [Increment::ZERO; MOST_SAMPLES];
    for scene in &SCENES {
        let mut lines = Lines { scene: scene.name, configuration: None };
        let flown = truth::fly(scene, &mut samples, &mut lines)?;
        let mut refused = Ok(());
        configuration::each(|configuration| {
            lines.configuration = Some(*configuration);
            refused = refused.and_then(|()| configuration::fly(configuration, &flown, &mut lines));
        });
        refused?;
    }
    let mut refused = Ok(());
    aided::each(|configuration| {
        let configuration = *configuration;
        let mut lines =
            Lines { scene: aided::SCENE.name, configuration: Some(configuration) };
        refused = refused.and_then(|()| aided::fly(&configuration, &mut lines));
    });
    refused
}
