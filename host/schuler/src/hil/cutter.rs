//! Frames from a stream of bytes, whole or damaged, unchanged.

/// Cuts a stream of bytes into frames with the zero bytes about them.
#[derive(Clone, Debug, Default)]
pub struct Cutter {
    frame: Vec<u8>,
}

impl Cutter {
    /// Takes the next byte, and gives what it ends.
    pub fn take(&mut self, byte: u8) -> Option<Vec<u8>> {
        if byte != 0 {
            self.frame.push(byte);
            return None;
        }
        let is_end = self.frame.len() > 1;
        if self.frame.is_empty() {
            self.frame.push(0);
        }
        if !is_end {
            return None;
        }
        self.frame.push(0);
        Some(std::mem::take(&mut self.frame))
    }
}
