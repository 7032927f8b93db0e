//! Scenes that come with the program, one TOML file each in `host/simulator/scenes`.

use super::{Scene, parse};

macro_rules! scenes {
    ($($name:literal),+ $(,)?) => {
        &[$(($name, include_str!(concat!("../../scenes/", $name, ".toml")))),+]
    };
}

/// Name and text of each.
const SCENES: &[(&str, &str)] = scenes![
    "paper",
    "paper-perfect",
    "hard",
    "manoeuvre",
    "vibration",
    "coning",
    "stationary",
    "cruise-180",
    "polar",
    "sea-state",
    "circuit",
    "waypoints",
    "drive",
    "pole-circuit",
    "aided-drive",
    "align-still",
    "align-turn",
    "align-sway",
];

/// The scene that flies when none is named.
pub const DEFAULT: &str = "paper";

/// Every built-in name with one line about it.
pub fn names() -> impl Iterator<Item = (&'static str, String)> {
    SCENES.iter().map(|&(name, text)| (name, load(name, text).title))
}

/// The names as an error lists them.
pub fn list() -> String {
    let names: Vec<_> = SCENES.iter().map(|(name, _)| *name).collect();
    names.join(", ")
}

/// The built-in scene of a name.
pub fn scene(name: &str) -> Option<Scene> {
    SCENES.iter().find(|scene| scene.0 == name).map(|&(name, text)| load(name, text))
}

/// The text of a built-in scene.
pub fn text(name: &str) -> Option<&'static str> {
    SCENES.iter().find(|scene| scene.0 == name).map(|&(_, text)| text)
}

fn load(name: &str, text: &str) -> Scene {
    let file = format!("{name}.toml");
    match parse::scene(&file, text) {
        Ok(scene) => scene,
        // The text is part of the program, and a test reads every one.
        Err(error) => unreachable!("{error}"),
    }
}
