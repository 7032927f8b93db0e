//! A device that is another process: its standard input and output are the line.

use super::channel::{Broken, Channel};
use schuler_simulator::output::stop::Listed;
use std::io::{Read, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// A running child; dropped, it is ended.
pub struct Process {
    child: Child,
    _listed: Listed,
    to: ChildStdin,
    from: Receiver<Vec<u8>>,
}

impl Process {
    /// Starts it.
    pub fn start(command: &mut Command) -> Result<Self, Broken> {
        let program = command.get_program().to_string_lossy().into_owned();
        let fault = |what: &str| Broken(format!("{program} {what}"));
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child =
            command.spawn().map_err(|error| fault(&format!("cannot be started: {error}")))?;
        let listed = Listed::process(child.id());
        let (Some(to), Some(mut out)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(fault("has no standard input and output"));
        };
        let (send, from) = channel();
        thread::spawn(move || {
            let mut buffer = [0; 4096];
            while let Ok(length @ 1..) = out.read(&mut buffer) {
                if send.send(buffer[..length].to_vec()).is_err() {
                    break;
                }
            }
        });
        Ok(Self { child, _listed: listed, to, from })
    }
}

impl Channel for Process {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        self.to.write_all(frame)?;
        Ok(self.to.flush()?)
    }

    fn receive(&mut self, into: &mut Vec<u8>, patience: Duration) -> Result<(), Broken> {
        match self.from.recv_timeout(patience) {
            Ok(bytes) => into.extend(bytes),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                let status = self.child.wait()?;
                return Err(Broken(format!("it ended with {status}")));
            }
        }
        into.extend(self.from.try_iter().flatten());
        Ok(())
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // One that has ended by itself cannot be ended again.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
