//! The navigators' images in lockstep with the program on this machine, over the machine's UART.

use super::image::Image;
use super::machine::Machine;
use std::net::TcpListener;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

/// Seconds of the paper's scene that are flown in lockstep.
const FLIGHT_S: &str = "10";

/// A machine that serves its UART on a port of this machine; stopped when dropped.
struct Serving(Child);

impl Drop for Serving {
    fn drop(&mut self) {
        // It serves for ever, and may have ended all the same.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Whether `schuler hil` finds the same bits in every solution; else what it says.
pub fn fly(machine: &Machine, image: &Image, schuler: &Path) -> Result<Option<String>, String> {
    let free = TcpListener::bind("127.0.0.1:0").and_then(|listener| listener.local_addr());
    let address = free.map_err(|error| format!("no port: {error}"))?;
    let mut command = Command::new(machine.program);
    command.args(machine.arguments).args(["-display", "none", "-monitor", "none", "-serial"]);
    command.arg(format!("tcp:{address},server=on,wait=on")).arg("-kernel").arg(&image.path);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    let started = command.spawn().map_err(|error| format!("{}: {error}", machine.program));
    let _serving = Serving(started?);

    let out = tempfile::tempdir().map_err(|error| error.to_string())?;
    let mut said = String::new();
    // Until the machine listens, the program finds nobody.
    for _ in 0..50 {
        thread::sleep(Duration::from_millis(200));
        let mut command = Command::new(schuler);
        command.args(["hil", "paper", "--precision", "f32", "--window", "0,4,0", "--no-report"]);
        command.args(["--duration", FLIGHT_S, "--device", &format!("tcp:{address}"), "--out"]);
        let ran = command.arg(out.path()).output().map_err(|error| error.to_string())?;
        if ran.status.success() {
            return Ok(None);
        }
        said = String::from_utf8_lossy(&ran.stderr).into_owned();
        if !said.contains("refused") {
            break;
        }
    }
    Ok(Some(said))
}

/// What `schuler hil --device qemu` is flown with, with the image of every mechanization: in double precision, by the
/// textbook, and with faults.
pub const EVERY: [&str; 3] = [
    "paper --precision f64 --window 2,4,2 --duration 3",
    "paper --precision f64 --algorithm textbook --duration 3",
    "paper --precision f32x2 --window 0,4,0 --duration 5 --faults all=0.1 --retries 20",
];

/// The same with the image of aided flights: with measurements, and a unit that identifies itself.
pub const AIDED: [&str; 3] = [
    "aided-drive --precision f32 --duration 20",
    "aided-drive --precision f32 --duration 20 --faults all=0.05 --retries 20",
    "paper --precision f32 --allan --duration 60 --faults all=0.05 --retries 20",
];

/// What `schuler hil` says of flights with an image that it starts QEMU for by itself, where one fails.
pub fn emulated(image: &Image, flights: &[&str], schuler: &Path) -> Result<Vec<String>, String> {
    let mut failed = Vec::new();
    for options in flights {
        let out = tempfile::tempdir().map_err(|error| error.to_string())?;
        let whole = |path: &Path| path.canonicalize().map_err(|error| error.to_string());
        let mut command = Command::new(whole(schuler)?);
        // What identifies itself writes no files.
        command.current_dir(out.path()).args(["hil", "--device", "qemu", "--image"]);
        command.arg(whole(&image.path)?);
        command.args(options.split_whitespace());
        let ran = command.output().map_err(|error| format!("{}: {error}", schuler.display()))?;
        if !ran.status.success() {
            let said = String::from_utf8_lossy(&ran.stderr);
            failed.push(format!("schuler hil --device qemu {options}: {said}"));
        }
    }
    Ok(failed)
}
