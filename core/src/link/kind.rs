//! What a frame is for.
//!
//! ```
//! use schuler::link::kind::Kind;
//!
//! assert_eq!(Kind::Sample.code(), 0x04);
//! assert_eq!(Kind::from_code(0x04), Some(Kind::Sample));
//! assert_eq!(Kind::from_code(0x7f), None);
//! ```

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
    /// Host: asks the target to identify itself.
    Greet = 0x01,
    /// Host: start navigation.
    Start = 0x02,
    /// Host: a piece of a stored state, to go on from.
    Restore = 0x03,
    /// Host: a sample.
    Sample = 0x04,
    /// Host: height and vertical velocity.
    Hold = 0x05,
    /// Host: end of the stream.
    Finish = 0x06,
    /// Host: reset, as if switched off and on.
    Reset = 0x07,
    /// Host: the settings of a flight that measurements aid.
    Aid = 0x08,
    /// Host: a measurement.
    Measure = 0x09,
    /// Host: asks for a piece of the state.
    Read = 0x0a,
    /// Target: identification; also sent when it is switched on.
    Hello = 0x81,
    /// Target: its state.
    Solution = 0x82,
    /// Target: the number of words of a stored state that it has.
    Restoring = 0x83,
    /// Target: refusal.
    Refused = 0x84,
    /// Target: a piece of its state.
    State = 0x85,
}
