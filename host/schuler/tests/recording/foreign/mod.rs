//! Logs that others wrote: the emulator's samples in their formats navigate as they do in our own.

mod formats;
mod maps;
mod refused;
mod start;
mod told;

use super::replay::{apart, program, rows};
use super::{scratch, text};
use schuler_simulator::recording::foreign::Given;
use schuler_simulator::recording::rows::Recording;
use std::fs;
use std::path::{Path, PathBuf};

/// Six seconds of turns to and fro about all axes, at a place of 45° N.
const SWAY: &str = "title = \"sway\"\nduration_s = 6\nrate_hz = 100\n[trajectory]\n\
    latitude_deg = 45\nlongitude_deg = 10\naltitude_m = 100\n\
    roll_deg = { offset = 3, harmonics = [{ amplitude = 5, period_s = 4, phase_deg = -90 }] }\n\
    pitch_deg = { offset = -7, harmonics = [{ amplitude = 3, period_s = 3, phase_deg = -90 }] }\n\
    yaw_deg = { offset = 40, harmonics = [{ amplitude = 20, period_s = 6, phase_deg = -90 }] }\n";

/// Time, then angles and velocities or their rates, forward, right, down.
type Sample = [f64; 7];

/// What the emulator makes of the sway, in a folder.
struct Sway {
    folder: tempfile::TempDir,
    increments: Vec<Sample>,
    rates: Vec<Sample>,
    /// The same at 125 Hz.
    others: Vec<Sample>,
}

impl Sway {
    fn new() -> Self {
        let folder = scratch();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("sway.toml"), SWAY).expect("the disk has room");
        let scene = at("sway.toml");
        for (name, more) in [
            ("increments.csv", &[][..]),
            ("rates.csv", &["--rates"]),
            ("others.csv", &["--rates", "--rate", "125"]),
        ] {
            let out = at(name);
            let line = ["emulate", text(&scene), "--perfect", "--out", text(&out)];
            program(&[&line[..], more].concat()).unwrap_or_else(|e| panic!("{e}"));
        }
        let samples = |name: &str| -> Vec<Sample> {
            rows(&at(name)).into_iter().map(|row| row.try_into().expect("seven")).collect()
        };
        let [increments, rates, others] =
            ["increments.csv", "rates.csv", "others.csv"].map(samples);
        Self { folder, increments, rates, others }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn write(&self, name: &str, content: &str) -> PathBuf {
        let path = self.path(name);
        fs::write(&path, content).expect("the disk has room");
        path
    }

    /// The rows of nav.csv of a file that begins at a time.
    fn flown(&self, imu: &Path, origin_s: f64, more: &[&str]) -> Result<Vec<Vec<f64>>, String> {
        let initial = format!(
            "time_s = {origin_s}\nlatitude_deg = 45\nlongitude_deg = 10\naltitude_m = 100\nnorth_m_s = 0\n\
             east_m_s = 0\ndown_m_s = 0\nroll_deg = 3\npitch_deg = -7\nyaw_deg = 40\n"
        );
        let initial = self.write("initial.toml", &initial);
        let out = self.path("nav.csv");
        let line = ["replay", "--imu", text(imu), "--initial", text(&initial), "--out", text(&out)];
        program(&[&line[..], more].concat())?;
        Ok(rows(&out))
    }
}

/// Asserts that a file flies as one of our own: every row within some metres, and attitudes as near in radians.
#[track_caller]
fn alike(sway: &Sway, own: &str, imu: &Path, origin_s: f64, more: &[&str], tolerance: f64) {
    let expected = sway.flown(&sway.path(own), 0.0, &[]).unwrap_or_else(|e| panic!("{e}"));
    let found = sway.flown(imu, origin_s, more).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(&expected) {
        let off = apart(a, b);
        let turned = (7..10).map(|i| (a[i] - b[i]).abs().to_radians()).fold(0.0, f64::max);
        let late = (a[0] - origin_s - b[0]).abs();
        assert!(off <= tolerance && turned <= tolerance, "{off:e} m, {turned:e} rad at {} s", b[0]);
        assert!(late < 2e-6, "{late} s");
    }
}

/// What is said on opening a file, or why it is refused.
fn opened(path: &Path, given: &Given) -> Result<Vec<String>, String> {
    Recording::open_as(text(path), given).map(|recording| recording.said).map_err(|e| e.to_string())
}

/// Forward, left, up of forward, right, down.
fn left_up([t, x, y, z, u, v, w]: Sample) -> Sample {
    [t, x, -y, -z, u, -v, -w]
}

/// Right, forward, up.
fn forward_up([t, x, y, z, u, v, w]: Sample) -> Sample {
    [t, y, x, -z, v, u, -w]
}

/// A table with a header.
fn table(header: &str, samples: &[Sample], line: impl Fn(Sample) -> String) -> String {
    let lines: String = samples.iter().map(|&sample| line(sample) + "\n").collect();
    if header.is_empty() { lines } else { format!("{header}\n{lines}") }
}

/// Whole nanoseconds of a time after another, s.
fn nanoseconds(origin_s: u64, time_s: f64) -> u64 {
    origin_s * 1_000_000_000 + (time_s * 1e9).round() as u64
}
