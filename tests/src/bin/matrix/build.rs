//! Building and running the audit program for one target.

use super::target::{Profile, Target};
use super::tools::{Machine, Toolchain};
use std::ffi::OsString;
use std::io::{Read, Seek};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// After this a program that prints nothing more is taken to hang.
const PATIENCE: Duration = Duration::from_secs(600);

/// Where everything is.
#[derive(Clone, Debug)]
pub struct Place {
    /// The audit program's sources.
    pub program: PathBuf,
    /// What is built: the images, and cargo's own folders.
    pub builds: PathBuf,
}

impl Place {
    /// Builds the program for a target, in one of cargo's folders: the image, or the compiler's complaint.
    pub fn build(
        &self,
        target: &Target,
        lane: usize,
        machine: &Machine,
        toolchain: &Toolchain,
    ) -> Result<PathBuf, String> {
        let Toolchain { compiler, builds_core, linker } = toolchain;
        let triple = target.triple(machine);
        let folder = self.builds.join(format!("lane-{lane}"));
        let mut cargo = Command::new(compiler.cargo);
        cargo.current_dir(&self.program).args(["build", "--quiet", "--locked"]);
        cargo
            .args(["--target", triple, "--features", target.features, "--target-dir"])
            .arg(&folder);
        for name in ["RUSTFLAGS", "CARGO_BUILD_TARGET", "RUSTC"] {
            cargo.env_remove(name);
        }
        cargo.env("CARGO_ENCODED_RUSTFLAGS", target.flags.join("\u{1f}"));
        if target.profile == Profile::Release {
            cargo.arg("--release");
        }
        for setting in target.settings {
            cargo.args(["--config", setting]);
        }
        if *builds_core {
            cargo.args(["-Z", "build-std=core", "-Z", "build-std-features=compiler-builtins-mem"]);
            cargo.env("RUSTC", compiler.rustc).env("RUSTC_BOOTSTRAP", "1");
        }
        if let Some(linker) = linker {
            let name = triple.to_uppercase().replace('-', "_");
            cargo.env(format!("CARGO_TARGET_{name}_LINKER"), linker);
        }
        let output = cargo.stdin(Stdio::null()).output();
        let output = output.map_err(|error| format!("{}: {error}", compiler.cargo))?;
        if !output.status.success() {
            return Err(format!("the build fails: {}", last_error(&output.stderr)));
        }
        let ending = match triple {
            _ if triple.starts_with("wasm") => ".wasm",
            _ if target.triple.is_none() => std::env::consts::EXE_SUFFIX,
            _ => "",
        };
        let built =
            folder.join(triple).join(target.profile.folder()).join(format!("audit{ending}"));
        // Rows of one triple would overwrite each other's.
        let image = self.builds.join("images").join(format!("{}{ending}", target.name));
        std::fs::create_dir_all(self.builds.join("images"))
            .and_then(|()| std::fs::copy(&built, &image))
            .map_err(|error| format!("{}: {error}", built.display()))?;
        Ok(image)
    }

    /// Runs an image: what it prints, or why it doesn't.
    pub fn run(&self, target: &Target, image: &Path) -> Result<String, String> {
        let image = image.as_os_str().to_owned();
        let mut words = target.runner.iter().map(OsString::from).chain([image]);
        let program = words.next().unwrap_or_default();
        let fault = |error: std::io::Error| format!("{}: {error}", program.display());
        let mut printed = tempfile::tempfile().map_err(fault)?;
        let mut complaints = tempfile::tempfile().map_err(fault)?;
        let mut child = Command::new(&program)
            .args(words)
            .current_dir(&self.program)
            .stdin(Stdio::null())
            .stdout(printed.try_clone().map_err(fault)?)
            .stderr(complaints.try_clone().map_err(fault)?)
            .spawn()
            .map_err(fault)?;
        let start = Instant::now();
        let status = loop {
            if let Some(status) = child.try_wait().map_err(fault)? {
                break status;
            }
            if start.elapsed() > PATIENCE {
                child.kill().and_then(|()| child.wait()).map_err(fault)?;
                return Err(format!("does not end within {} s", PATIENCE.as_secs()));
            }
            std::thread::sleep(Duration::from_millis(20));
        };
        let mut text = Vec::new();
        printed.rewind().and_then(|()| printed.read_to_end(&mut text)).map_err(fault)?;
        if status.success() {
            return String::from_utf8(text).map_err(|_| "prints what is no text".to_owned());
        }
        complaints.rewind().and_then(|()| complaints.read_to_end(&mut text)).map_err(fault)?;
        let last = String::from_utf8_lossy(&text).lines().last().unwrap_or_default().to_owned();
        Err(format!("ends with {status}: {last}"))
    }
}

/// The line of a compiler's output that says most.
fn last_error(output: &[u8]) -> String {
    let text = String::from_utf8_lossy(output);
    let error = text.lines().find(|line| line.starts_with("error"));
    error.or_else(|| text.lines().last()).unwrap_or_default().to_owned()
}
