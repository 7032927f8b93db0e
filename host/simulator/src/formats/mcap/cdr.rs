//! CDR, the plain little-endian form of ROS 2 messages.
//!
//! Source: OMG, *DDS-XTypes* 1.3, §7.4.3: after four bytes of a head, every number is aligned to its own size.

/// A message while it is written.
#[derive(Clone, Debug)]
pub struct Cdr {
    bytes: Vec<u8>,
}

/// Bytes of the head: plain CDR, little-endian, no options.
const HEAD: [u8; 4] = [0, 1, 0, 0];

impl Default for Cdr {
    fn default() -> Self {
        Self { bytes: HEAD.to_vec() }
    }
}

impl Cdr {
    fn align(&mut self, size: usize) {
        while !(self.bytes.len() - HEAD.len()).is_multiple_of(size) {
            self.bytes.push(0);
        }
    }

    /// One byte.
    #[must_use]
    pub fn u8(mut self, value: u8) -> Self {
        self.bytes.push(value);
        self
    }

    /// Two bytes.
    #[must_use]
    pub fn u16(mut self, value: u16) -> Self {
        self.align(2);
        self.bytes.extend(value.to_le_bytes());
        self
    }

    /// Four bytes.
    #[must_use]
    pub fn u32(mut self, value: u32) -> Self {
        self.align(4);
        self.bytes.extend(value.to_le_bytes());
        self
    }

    /// Numbers, without their count.
    #[must_use]
    pub fn numbers(mut self, values: &[f64]) -> Self {
        for value in values {
            self.align(8);
            self.bytes.extend(value.to_le_bytes());
        }
        self
    }

    /// Text.
    #[must_use]
    pub fn text(self, text: &str) -> Self {
        // Its length counts the zero that ends it.
        let mut this = self.u32(text.len() as u32 + 1);
        this.bytes.extend(text.as_bytes());
        this.bytes.push(0);
        this
    }

    /// The message.
    pub fn bytes(self) -> Vec<u8> {
        self.bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_aligned_behind_the_head() {
        let bytes = Cdr::default().text("ab").u8(7).u16(1).numbers(&[1.0]).bytes();
        let expected = [
            0, 1, 0, 0, 3, 0, 0, 0, b'a', b'b', 0, 7, 1, 0, 0, 0, // the head, then 12 bytes
            0, 0, 0, 0, 0, 0, 0xf0, 0x3f,
        ];
        assert_eq!(bytes.len(), 4 + 24);
        assert_eq!(bytes[..16], expected[..16]);
        assert_eq!(bytes[20..], expected[16..]);
    }
}
