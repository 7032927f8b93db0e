//! The self-test's flights by the program on this machine: the same code, and so the same bits.

use std::path::Path;
use std::process::Command;

/// A flight of the self-test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Twin {
    /// Its name in the report.
    pub name: &'static str,
    /// The built-in scene.
    pub scene: &'static str,
    /// The navigator's precision.
    pub precision: &'static str,
}

/// Every flight of the self-test.
pub const TWINS: [Twin; 4] = [
    Twin { name: "paper-perfect f32", scene: "paper-perfect", precision: "f32" },
    Twin { name: "paper-perfect f32x2", scene: "paper-perfect", precision: "f32x2" },
    Twin { name: "paper f32", scene: "paper", precision: "f32" },
    Twin { name: "paper f64", scene: "paper", precision: "f64" },
];

impl Twin {
    /// The digest of every state of the flight, from the summary that `schuler run` writes.
    pub fn digest(&self, schuler: &Path, seconds: u32) -> Result<String, String> {
        let out = tempfile::tempdir().map_err(|error| error.to_string())?;
        let mut command = Command::new(schuler);
        command.args(["run", self.scene, "--precision", self.precision, "--no-report"]);
        command.args(["--window", "0,4,0", "--duration", &seconds.to_string(), "--out"]);
        let ran = command.arg(out.path()).output();
        let ran = ran.map_err(|error| format!("{}: {error}", schuler.display()))?;
        if !ran.status.success() {
            return Err(format!("{}: {}", schuler.display(), String::from_utf8_lossy(&ran.stderr)));
        }
        let file = out.path().join("summary.json");
        let text = std::fs::read_to_string(&file).map_err(|error| error.to_string())?;
        let summary: serde_json::Value =
            serde_json::from_str(&text).map_err(|error| error.to_string())?;
        let digest = summary.get("digest").and_then(|digest| digest.as_str());
        digest.map(str::to_owned).ok_or_else(|| "no digest in the summary".to_owned())
    }
}
