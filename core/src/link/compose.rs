//! Fleets made of others.
//!
//! ```
//! use schuler::link::fleet::{Fleet, Single};
//! use schuler::link::flight::LinkedFlight;
//! use schuler::navigators::Navigator4;
//!
//! schuler::fleet! {
//!     /// Single precision, and one navigator in double precision.
//!     Mine {
//!         Single: Single,
//!         Double: LinkedFlight<Navigator4<f64>>,
//!     }
//! }
//! let mut offers = Vec::new();
//! Mine::offers(&mut |one| offers.push(one.to_string()));
//! assert_eq!(offers.last().map(String::as_str), Some("f64 local-level taylor 0,4,0"));
//! ```

/// Makes a [`Fleet`](crate::link::fleet::Fleet) of some others: of single mechanizations, each in a
/// [`LinkedFlight`](crate::link::flight::LinkedFlight), or of fleets.
#[macro_export]
macro_rules! fleet {
    ($($(#[$doc:meta])* $visibility:vis $name:ident $([$($generic:tt)+] of [$($argument:ident)+])? {
        $($variant:ident: $fleet:ty,)+
    })+) => {$(
        $(#[$doc])*
        // Nothing is on a heap, and a target has one of them.
        #[allow(clippy::large_enum_variant)]
        #[derive(Clone, Copy)]
        $visibility enum $name $(<$($generic)+>)? {
            $(
                #[doc = concat!("`", stringify!($fleet), "`.")]
                $variant($fleet),
            )+
        }

        const _: () = {
            use $crate::link::bytes::Bytes;
            use $crate::link::fleet::{Fleet, Visitor};
            use $crate::link::flight::Taken;
            use $crate::link::frame::Writer;
            use $crate::link::message::Start;
            use $crate::link::offer::Offer;
            use $crate::link::refusal::Refusal;

            impl $(<$($generic)+>)? Fleet for $name $(<$($argument)+>)? {
                #[inline]
                fn offers(offer: &mut impl FnMut(Offer)) {
                    $(<$fleet as Fleet>::offers(offer);)+
                }

                #[inline]
                fn start(start: &Start) -> Result<Self, Refusal> {
                    $(match <$fleet as Fleet>::start(start) {
                        Err(Refusal::Configuration) => {}
                        started => return started.map(Self::$variant),
                    })+
                    Err(Refusal::Configuration)
                }

                #[inline]
                fn take(&mut self, number: u32, increment: Bytes) -> Result<Taken, Refusal> {
                    match self {
                        $(Self::$variant(fleet) => Fleet::take(fleet, number, increment),)+
                    }
                }

                #[inline]
                fn hold(&mut self, vertical: Bytes) -> Result<(), Refusal> {
                    match self {
                        $(Self::$variant(fleet) => Fleet::hold(fleet, vertical),)+
                    }
                }

                #[inline]
                fn finish(&mut self, samples: u32) -> Result<Taken, Refusal> {
                    match self {
                        $(Self::$variant(fleet) => Fleet::finish(fleet, samples),)+
                    }
                }

                #[inline]
                fn taken(&self) -> u32 {
                    match self {
                        $(Self::$variant(fleet) => Fleet::taken(fleet),)+
                    }
                }

                fn bridged(&self) -> u32 {
                    match self {
                        $(Self::$variant(fleet) => Fleet::bridged(fleet),)+
                    }
                }

                #[inline]
                fn write(&self, to: &mut Writer) {
                    match self {
                        $(Self::$variant(fleet) => Fleet::write(fleet, to),)+
                    }
                }

                #[inline]
                fn words(&self, read: &mut dyn FnMut(u64)) {
                    match self {
                        $(Self::$variant(fleet) => Fleet::words(fleet, read),)+
                    }
                }

                #[inline]
                fn restore(&mut self, write: &mut dyn FnMut(u64) -> u64) {
                    match self {
                        $(Self::$variant(fleet) => Fleet::restore(fleet, write),)+
                    }
                }

                #[inline]
                fn check(&self) -> Result<(), Refusal> {
                    match self {
                        $(Self::$variant(fleet) => Fleet::check(fleet),)+
                    }
                }

                #[inline]
                fn aid(&mut self, settings: Bytes) -> Result<(), Refusal> {
                    match self {
                        $(Self::$variant(fleet) => Fleet::aid(fleet, settings),)+
                    }
                }

                #[inline]
                fn measure(&mut self, number: u32, measured: Bytes) -> Result<Taken, Refusal> {
                    match self {
                        $(Self::$variant(fleet) => Fleet::measure(fleet, number, measured),)+
                    }
                }

                #[inline]
                fn visit<V: Visitor>(&mut self, visitor: V) -> Option<V::Result> {
                    match self {
                        $(Self::$variant(fleet) => Fleet::visit(fleet, visitor),)+
                    }
                }
            }
        };
    )+};
}
