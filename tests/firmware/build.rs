//! Hands the linker the board's memory map.

use std::path::{Path, PathBuf};
use std::{env, fs};

/// The memory map of each board, by the feature that chooses it.
const MAPS: [(&str, &str); 4] = [
    ("MPS2", "../../memory.x"),
    ("MPS2_AN505", "memory/mps2-an505.x"),
    ("MICROBIT", "memory/microbit.x"),
    ("VIRT", "memory/virt.x"),
];

/// What is done with defmt's table in each image.
const SCRIPTS: [(&str, &str); 8] = [
    ("selftest", "defmt.x"),
    ("circuit", "defmt.x"),
    ("budget", "defmt.x"),
    ("aiding", "defmt.x"),
    ("navigator", "quiet.x"),
    ("navigator-f32", "quiet.x"),
    ("single", "quiet.x"),
    ("single-planned", "quiet.x"),
];

fn main() {
    let chosen = |feature: &str| env::var_os(format!("CARGO_FEATURE_{feature}")).is_some();
    let boards: Vec<_> = MAPS.into_iter().filter(|(feature, _)| chosen(feature)).collect();
    let [(_, map)] = boards[..] else {
        panic!("choose one board by its feature: mps2, mps2-an505, microbit or virt");
    };
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    copy(&root.join(map), &out.join("memory.x"));
    copy(&root.join("quiet.x"), &out.join("quiet.x"));
    println!("cargo:rustc-link-search={}", out.display());
    println!("cargo:rustc-link-arg-bins=--nmagic");
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    for (image, script) in SCRIPTS {
        println!("cargo:rustc-link-arg-bin={image}=-T{script}");
    }
}

fn copy(from: &Path, to: &Path) {
    println!("cargo:rerun-if-changed={}", from.display());
    fs::copy(from, to).unwrap_or_else(|error| panic!("{}: {error}", from.display()));
}
