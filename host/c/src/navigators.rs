//! The functions of each navigator: those of the core's catalogue with the windows that targets have, each for
//! samples of one length and for samples of any, and the textbook.

mod reading;
mod starting;
mod taking;

use crate::digest::{Running, schuler_digest};
use crate::held::{forget, held, held_mut, keep};
use crate::navigation::{Navigation, Numbered};
use crate::pointer::{bytes, bytes_mut, get, put};
use crate::results::result;
use crate::sizes::{saved, words};
use crate::values::*;
use pastey::paste;
use reading::reading;
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::strapdown::block::unequal::Unequal;
use schuler::strapdown::block::window::*;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler::{every_frame, windows_of};
use starting::starting;
use taking::{taking, taking_any};

/// One navigator: its name, its scalar, its type, whether samples may have any length, and what it is.
macro_rules! navigator {
    ([] $name:ident, $number:ident, $type:ty, $any:ident, [$($about:tt)+]) => {
        paste! {
            impl Numbered for $type {
                const ANY_INTERVAL: bool = $any;
            }

            #[doc = $($about)+ ". Its state: allocate it anywhere, on the stack or statically, and pass it by pointer. The "
                "bytes are the library's; a copy goes on by itself, bit for bit."]
            #[repr(C)]
            #[derive(Clone, Copy, Debug)]
            pub struct [<schuler_ $name>] {
                /// The library's.
                pub opaque: [u64; words!($name)],
            }

            #[doc = "Bytes that schuler_" $name "_save writes."]
            pub const [<SCHULER_ $name:upper _SAVED>]: usize = saved!($name);
        }
        starting! { $name, $number, $type }
        taking! { $name, $number, $type }
        navigator! { @any $any $name, $number, $type }
        reading! { $name, $number, $type }
    };
    (@any false $name:ident, $number:ident, $type:ty) => {};
    (@any true $name:ident, $number:ident, $type:ty) => {
        taking_any! { $name, $number, $type }
    };
}

/// Calls a macro for each window in one frame, after the tokens given here.
macro_rules! windows {
    ($each:ident $first:tt $frame_name:ident, $number:ident, $frame:ty; $($window:ident),+) => { paste! {$(
        $each! {
            $first [<$frame_name:snake _ $window:lower>], $number, Strapdown<$frame, $window>, false,
            ["The navigator " $frame_name " with the window " $window " (history, block and look-ahead in samples)"]
        }
        $each! {
            $first [<$frame_name:snake _ $window:lower _any>], $number, Strapdown<$frame, Unequal<$window>>, true,
            ["The navigator " $frame_name " with the window " $window ", for samples of any length"]
        }
    )+} };
}

/// Calls a macro for each navigator, after the tokens given here: the catalogue's frames with the windows of targets.
macro_rules! navigators {
    ($each:ident $first:tt
     $($name:ident: $precision:ident, $axes:ident, $frame:ty, $windows:ident, [$($of:ident: $textbook:ty)?];)+) => {
        $(
            navigators! { @windows $precision $each $first $name, $frame }
            $(navigators! { @textbook $precision $each $first $of, $textbook })?
        )+
    };
    (@windows F64 $each:ident $first:tt $name:ident, $frame:ty) => {
        windows_of! { target windows! $each $first $name, f64, $frame; }
    };
    (@windows $single:ident $each:ident $first:tt $name:ident, $frame:ty) => {
        windows_of! { target windows! $each $first $name, f32, $frame; }
    };
    (@textbook F64 $each:ident $first:tt $name:ident, $frame:ty) => {
        navigators! { @number f64 $each $first $name, $frame }
    };
    (@textbook $single:ident $each:ident $first:tt $name:ident, $frame:ty) => {
        navigators! { @number f32 $each $first $name, $frame }
    };
    (@number $number:ident $each:ident $first:tt $name:ident, $frame:ty) => { paste! {
        $each! {
            $first [<$name:snake>], $number, Textbook<$frame>, true,
            ["The textbook's algorithm, " $name ": a step for every sample, of any length, without delay"]
        }
    } };
}
every_frame! { navigators! navigator [] }

#[cfg(not(feature = "archive"))]
/// Shows the name of a navigator, its number, and the bytes of its state and of its stored form.
macro_rules! measure {
    ([$see:ident] $name:ident, $number:ident, $type:ty, $any:ident, $about:tt) => {
        let size = crate::held::size::<Navigation<$type>>();
        let stored = Navigation::<$type>::level().map_or(0, |navigation| navigation.saved_size());
        $see(stringify!($name), <Navigation<$type> as crate::held::Keep>::KIND, size, stored);
    };
}

/// Every navigator: its name, the number that its states are marked with, and the bytes of its state and of its
/// stored form. It is for the tests, which hold the table of sizes against it.
#[cfg(not(feature = "archive"))]
#[doc(hidden)]
pub fn navigator_sizes(see: &mut dyn FnMut(&str, u32, usize, usize)) {
    every_frame! { navigators! measure [see] }
}
