//! Flies an image in QEMU, and decodes what it reports through defmt.

use super::image::Image;
use super::machine::Machine;
use defmt_decoder::{DecodeError, Table};
use std::collections::BTreeMap;
use std::io::Read;
use std::process::{Command, ExitStatus, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// An image that says nothing more is stopped after this.
const PATIENCE: Duration = Duration::from_secs(600);

/// What a flight came to.
#[derive(Clone, Debug)]
pub struct Flight {
    /// What stood in `key = value` lines.
    pub values: BTreeMap<String, String>,
    /// Whether the image ended with 0.
    pub passed: bool,
}

impl Flight {
    /// The text of a key.
    pub fn text(&self, key: &str) -> Result<&str, String> {
        self.values.get(key).map(String::as_str).ok_or_else(|| format!("no `{key}` was reported"))
    }

    /// The number of a key.
    pub fn number(&self, key: &str) -> Result<f64, String> {
        let text = self.text(key)?;
        text.parse().map_err(|_| format!("`{key} = {text}` is no number"))
    }
}

/// Flies an image on a machine; every line is shown to `line` as it comes.
pub fn fly(machine: &Machine, image: &Image, line: &mut dyn FnMut(&str)) -> Result<Flight, String> {
    let parsed = Table::parse(&image.bytes).map_err(|error| error.to_string());
    let table = parsed?.ok_or_else(|| format!("{}: reports nothing", image.path.display()))?;
    let file = Loaded::new(image)?;
    let mut command = Command::new(machine.program);
    command.args(machine.arguments).args(["-icount", "shift=0", "-display", "none"]);
    command.args(["-monitor", "none", "-serial", "null"]);
    command.args(["-semihosting-config", "enable=on,target=native", "-kernel"]).arg(&file.0);
    let spawned = command.stdin(Stdio::null()).stdout(Stdio::piped()).spawn();
    let mut child = spawned.map_err(|error| format!("{}: {error}", machine.program))?;
    let mut output = child.stdout.take().ok_or("no output")?;

    let (alive, silence) = mpsc::channel::<()>();
    let ended = thread::spawn(move || -> std::io::Result<ExitStatus> {
        while let Ok(()) = silence.recv_timeout(PATIENCE) {}
        // Its output has ended, or nothing came for long: then it does not end by itself.
        if let Some(status) = waited(&mut child)? {
            return Ok(status);
        }
        child.kill()?;
        child.wait()
    });

    let mut decoder = table.new_stream_decoder();
    let mut values = BTreeMap::new();
    let mut chunk = [0; 1024];
    loop {
        let read = output.read(&mut chunk).map_err(|error| error.to_string())?;
        if read == 0 {
            break;
        }
        let _ = alive.send(());
        decoder.received(&chunk[..read]);
        loop {
            match decoder.decode() {
                Ok(frame) => {
                    let text = frame.display_message().to_string();
                    line(&text);
                    if let Some((key, value)) = text.split_once(" = ") {
                        values.insert(key.to_owned(), value.to_owned());
                    }
                }
                Err(DecodeError::UnexpectedEof) => break,
                Err(DecodeError::Malformed) => line("(a report that cannot be decoded)"),
            }
        }
    }
    drop(alive);
    let status = ended.join().map_err(|_| "the watch over QEMU failed")?;
    let passed = status.map_err(|error| error.to_string())?.success();
    Ok(Flight { values, passed })
}

/// Waits a moment for a child that is about to end.
fn waited(child: &mut std::process::Child) -> std::io::Result<Option<ExitStatus>> {
    for _ in 0..500 {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        thread::sleep(Duration::from_millis(10));
    }
    Ok(None)
}

/// The image as a file of its own: words may be set otherwise than in the one that it was read from.
struct Loaded(tempfile::TempPath);

impl Loaded {
    fn new(image: &Image) -> Result<Self, String> {
        let write = || -> std::io::Result<tempfile::TempPath> {
            let mut file = tempfile::NamedTempFile::new()?;
            std::io::Write::write_all(&mut file, &image.bytes)?;
            Ok(file.into_temp_path())
        };
        write().map(Self).map_err(|error| format!("a copy of {}: {error}", image.path.display()))
    }
}
