//! What a frame is for.

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident = $code:literal,)+) => {
        /// What a frame is for.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub enum Kind {
            $($(#[$doc])* $name = $code,)+
        }

        impl Kind {
            /// From its code.
            pub fn from_code(code: u8) -> Option<Self> {
                match code {
                    $($code => Some(Self::$name),)+
                    _ => None,
                }
            }

            /// As it crosses the line.
            pub fn code(self) -> u8 {
                self as u8
            }
        }
    };
}

kinds! {
    /// Host: who is there?
    Greet = 0x01,
    /// Host: start navigation.
    Start = 0x02,
    /// Host: a piece of a stored state, to go on from.
    Restore = 0x03,
    /// Host: a sample.
    Sample = 0x04,
    /// Host: height and vertical velocity.
    Hold = 0x05,
    /// Host: the stream is at its end.
    Finish = 0x06,
    /// Host: forget everything, as if switched off and on.
    Reset = 0x07,
    /// Target: it is there; sent unasked when it is switched on.
    Hello = 0x81,
    /// Target: where it stands.
    Solution = 0x82,
    /// Target: how much of a stored state it has.
    Restoring = 0x83,
    /// Target: it does not do what was asked.
    Refused = 0x84,
}
