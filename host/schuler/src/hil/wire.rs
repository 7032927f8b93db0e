//! A device at the end of a real line: a serial port, or a TCP connection.

use super::channel::{Broken, Channel};
use serialport::SerialPort;
use std::io::{ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::Duration;

/// Whatever bytes can be read from with a limit of time, and written to.
pub trait Line: Read + Write + Send {
    /// How long a read waits.
    fn wait(&mut self, patience: Duration) -> std::io::Result<()>;
}

impl Line for TcpStream {
    fn wait(&mut self, patience: Duration) -> std::io::Result<()> {
        self.set_read_timeout(Some(patience))
    }
}

impl Line for Box<dyn SerialPort> {
    fn wait(&mut self, patience: Duration) -> std::io::Result<()> {
        Ok(self.set_timeout(patience)?)
    }
}

/// A line as a channel.
pub struct Wire<L>(pub L);

impl<L: Line> Channel for Wire<L> {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        self.0.write_all(frame)?;
        Ok(self.0.flush()?)
    }

    fn receive(&mut self, into: &mut Vec<u8>, patience: Duration) -> Result<(), Broken> {
        self.0.wait(patience)?;
        let mut buffer = [0; 4096];
        match self.0.read(&mut buffer) {
            Ok(0) => Err(Broken("its other end was closed".to_owned())),
            Ok(length) => {
                into.extend_from_slice(&buffer[..length]);
                Ok(())
            }
            Err(error) => match error.kind() {
                ErrorKind::TimedOut | ErrorKind::WouldBlock | ErrorKind::Interrupted => Ok(()),
                _ => Err(error.into()),
            },
        }
    }
}
