//! Recordings that contradict themselves, or that tell less than is asked of them.

mod refused;
mod theory;
mod told;

use std::fs;
use std::path::Path;
use std::process::Command;

const INITIAL: &str = "time_s = 0\nlatitude_deg = 45\nlongitude_deg = 100\naltitude_m = 1000\n\
    north_m_s = 0\neast_m_s = 0\ndown_m_s = 0\nroll_deg = 3\npitch_deg = -7\nyaw_deg = 40\n";

/// Runs: exit code, standard output, error stream.
fn schuler(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    let done = command.current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (done.status.code(), text(&done.stdout), text(&done.stderr))
}

/// A folder with half a minute at rest at 100 Hz, imu.csv of increments and rates.csv, and where it
/// starts.
fn at_rest() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for more in [&["imu.csv"][..], &["rates.csv", "--rates"]] {
        let emulate = ["emulate", "stationary", "--duration", "30", "--rate", "100", "--out"];
        let (code, _, said) = schuler(folder.path(), &[&emulate[..], more].concat());
        assert_eq!(code, Some(0), "{said}");
    }
    fs::write(folder.path().join("initial.toml"), INITIAL).unwrap();
    folder
}

/// Changes the six numbers of each row of a file, and its header.
fn change(
    folder: &Path,
    from: &str,
    to: &str,
    header: Option<&str>,
    by: impl Fn(usize, [f64; 6]) -> [f64; 6],
) {
    let text = fs::read_to_string(folder.join(from)).unwrap();
    let mut lines = text.lines();
    let mut changed = format!("{}\n", header.unwrap_or(lines.next().unwrap()));
    for (row, line) in text.lines().skip(1).enumerate() {
        let mut numbers = line.split(',').map(|number| number.parse::<f64>().unwrap());
        changed += &numbers.next().unwrap().to_string();
        let values = std::array::from_fn(|_| numbers.next().unwrap());
        changed += &by(row, values).map(|value| format!(",{value:e}")).concat();
        changed.push('\n');
    }
    fs::write(folder.join(to), changed).unwrap();
}

/// Replays a file from initial.toml.
fn replay(folder: &Path, imu: &str, more: &[&str]) -> (Option<i32>, String, String) {
    let arguments = ["replay", "--initial", "initial.toml", "--out", "nav.csv", "--imu", imu];
    schuler(folder, &[&arguments[..], more].concat())
}
