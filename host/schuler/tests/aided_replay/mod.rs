//! Recordings that are flown with fixes: `emulate --gnss` and `replay --gnss`.
//!
//! | file | what |
//! |---|---|
//! | `drift` | a replay drifts as the run did, however its measurements come |
//! | `fixes` | what receivers wrote, and when it counts |
//! | `smoothed` | a flight in the light of all measurements |
//! | `refused` | what cannot be |

mod drift;
mod fixes;
mod refused;
mod smoothed;

use std::fs;
use std::path::Path;
use std::process::Command;

/// What a command that succeeds prints.
#[track_caller]
fn schuler(folder: &Path, line: &str) -> String {
    let (code, out, errors) = ended(folder, line);
    assert_eq!(code, Some(0), "{line}\n{errors}");
    out
}

fn ended(folder: &Path, line: &str) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    let done = command.current_dir(folder).args(line.split_ascii_whitespace()).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (done.status.code(), text(&done.stdout), text(&done.stderr))
}

/// The rows of a CSV file of numbers; what is none is not a number.
fn rows(path: &Path) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(path).unwrap();
    let row = |line: &str| line.split(',').map(|x| x.parse().unwrap_or(f64::NAN)).collect();
    text.lines().skip(1).map(row).collect()
}

/// From the first place to the second, north, east, down, m.
fn apart(from: &[f64], to: &[f64]) -> [f64; 3] {
    let north = (to[1] - from[1]).to_radians() * 6.37e6;
    let east = (to[2] - from[2]).to_radians() * 6.39e6 * from[1].to_radians().cos();
    [north, east, from[3] - to[3]]
}

fn norm(v: [f64; 3]) -> f64 {
    v.into_iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The row of a time.
fn at(rows: &[Vec<f64>], time_s: f64) -> &[f64] {
    rows.iter().find(|row| (row[0] - time_s).abs() < 1e-6).unwrap()
}

/// The rows of a file in the opposite order.
fn reversed(text: &str) -> String {
    let mut lines: Vec<_> = text.lines().collect();
    lines[1..].reverse();
    lines.join("\n") + "\n"
}

const FROM: &str = "--imu imu.csv --sensors aided-drive --initial initial.toml";
