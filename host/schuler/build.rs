//! Tells reports which libm the core was built with, its version from the lock file, and which compiler.

use std::env;
use std::fs;
use std::path::Path;
use std::process::Command;

fn main() {
    let home = env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it");
    let lock =
        Path::new(&home).ancestors().map(|place| place.join("Cargo.lock")).find(|p| p.exists());
    let version = lock.and_then(|lock| {
        println!("cargo::rerun-if-changed={}", lock.display());
        let text = fs::read_to_string(lock).ok()?;
        let (_, after) = text.split_once("name = \"libm\"")?;
        Some(after.split('"').nth(1)?.to_owned())
    });
    println!("cargo::rustc-env=SCHULER_LIBM_VERSION={}", version.as_deref().unwrap_or("unknown"));
    let compiler = env::var_os("RUSTC")
        .and_then(|rustc| Command::new(rustc).arg("--version").output().ok())
        .and_then(|output| String::from_utf8(output.stdout).ok());
    let compiler = compiler.as_deref().unwrap_or("rustc unknown").trim();
    println!("cargo::rustc-env=SCHULER_COMPILER={compiler}");
}
