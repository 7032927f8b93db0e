//! The devices that a flight can be flown with, and how each is reached.

use super::channel::Channel;
use super::child::Process;
use super::wire::Wire;
use schuler_simulator::input::{Complaint, InputError};
use std::fmt;
use std::net::TcpStream;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

/// Bits per second of a serial port, unless it says otherwise.
const BAUD: u32 = 115_200;

/// A device.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Device {
    /// The target's application on this machine, in a process of its own.
    #[default]
    Twin,
    /// A Cortex-M4F in QEMU.
    Qemu,
    /// A serial port.
    Serial {
        /// Its name.
        port: String,
        /// Bits per second.
        baud: u32,
    },
    /// A TCP server.
    Tcp(String),
}

impl Device {
    /// As `--device` gives it.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let accepted = "twin, qemu, serial:PORT, serial:PORT@BAUD or tcp:HOST:PORT";
        let wrong = |what: String| Complaint::new(what, accepted);
        match text.split_once(':') {
            None if text == "twin" => Ok(Self::Twin),
            None if text == "qemu" => Ok(Self::Qemu),
            Some(("tcp", address)) if address.contains(':') => Ok(Self::Tcp(address.to_owned())),
            Some(("serial", line)) if !line.is_empty() => {
                let (port, baud) = line.rsplit_once('@').unwrap_or((line, ""));
                let baud = match baud {
                    "" => Ok(BAUD),
                    _ => baud.parse().map_err(|_| wrong(format!("{baud} is no bit rate"))),
                };
                Ok(Self::Serial { port: port.to_owned(), baud: baud? })
            }
            _ => Err(wrong(format!("{text} is no device"))),
        }
    }

    /// Connects to it; `image` is what QEMU runs.
    pub fn open(&self, image: &Path) -> Result<Box<dyn Channel>, InputError> {
        let fault = |what: String, accepted: &str| {
            InputError::option("--device", Complaint::new(what, accepted))
        };
        match self {
            Self::Twin => {
                let program = std::env::current_exe()
                    .map_err(|error| fault(format!("this program cannot be found: {error}"), ""))?;
                let process = Process::start(Command::new(program).arg("twin"));
                Ok(Box::new(process.map_err(|broken| fault(broken.0, ""))?))
            }
            Self::Qemu => {
                if !image.is_file() {
                    let file = image.display().to_string();
                    let complaint = Complaint::new(
                        "there is no such image",
                        "a navigator for QEMU's mps2-an386, which `cargo build --release --bin navigator` \
                         in tests/firmware makes",
                    );
                    return Err(InputError::file(&file, complaint));
                }
                let process = Process::start(&mut qemu(image));
                let accepted = "qemu where qemu-system-arm is installed, else twin";
                Ok(Box::new(process.map_err(|broken| fault(broken.0, accepted))?))
            }
            Self::Serial { port, baud } => {
                let line = serialport::new(port, *baud).timeout(Duration::from_secs(1)).open();
                Ok(Box::new(Wire(line.map_err(|error| fault(format!("{port}: {error}"), ""))?)))
            }
            Self::Tcp(address) => {
                let line = TcpStream::connect(address)
                    .and_then(|line| line.set_nodelay(true).map(|()| line));
                Ok(Box::new(Wire(line.map_err(|error| fault(format!("{address}: {error}"), ""))?)))
            }
        }
    }
}

/// A Cortex-M4F whose first UART is the process's standard input and output.
fn qemu(image: &Path) -> Command {
    let mut command = Command::new("qemu-system-arm");
    command.args(["-machine", "mps2-an386", "-cpu", "cortex-m4", "-display", "none"]);
    command.args(["-monitor", "none", "-serial", "stdio", "-chardev", "null,id=quiet"]);
    command.args(["-semihosting-config", "enable=on,target=native,chardev=quiet", "-kernel"]);
    command.arg(image);
    command
}

impl fmt::Display for Device {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Twin => f.write_str("twin"),
            Self::Qemu => f.write_str("qemu"),
            Self::Serial { port, baud } => write!(f, "serial:{port}@{baud}"),
            Self::Tcp(address) => write!(f, "tcp:{address}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn devices_are_read_and_refused_with_what_would_be_accepted() {
        let serial = |port: &str, baud| Device::Serial { port: port.to_owned(), baud };
        assert_eq!(Device::parse("twin"), Ok(Device::Twin));
        assert_eq!(Device::parse("serial:/dev/ttyACM0"), Ok(serial("/dev/ttyACM0", 115_200)));
        assert_eq!(Device::parse("serial:COM3@921600"), Ok(serial("COM3", 921_600)));
        assert_eq!(Device::parse("tcp:127.0.0.1:5000").unwrap().to_string(), "tcp:127.0.0.1:5000");
        for text in ["", "twins", "serial:", "serial:/dev/ttyS0@fast", "tcp:5000"] {
            let complaint = Device::parse(text).unwrap_err();
            assert!(complaint.accepted.starts_with("twin, qemu, serial:PORT"), "{complaint}");
        }
    }
}
