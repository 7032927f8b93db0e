//! The functions of each navigator: those of the core's catalogue with the windows that targets have, each for
//! samples of one length and for samples of any, and the textbook.

use crate::digest::{Running, schuler_digest};
use crate::held::{forget, held, held_mut, keep};
use crate::navigation::{Navigation, Numbered};
use crate::pointer::{bytes, bytes_mut, get, put};
use crate::results::result;
use crate::sizes::{saved, words};
use crate::values::*;
use pastey::paste;
use schuler::{every_frame, windows_of};
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::strapdown::block::unequal::Unequal;
use schuler::strapdown::block::window::*;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};

/// One navigator: its name, its scalar, its type, whether samples may have any length, and what it is.
macro_rules! navigator {
    ([] $name:ident, $number:ident, $type:ty, $any:ident, [$($about:tt)+]) => { paste! {
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

        #[doc = "Starts a navigator at `rate_hz` samples per second (at least 1) from an initial solution in local axes. "
            "`abi` is SCHULER_ABI; `order` is the highest order of its series, 0 for that of its window (for what a motion "
            "needs, see `plan::order` of the core). Fails with SCHULER_ERROR_NULL, _MISALIGNED, _ABI, _INTERVAL, "
            "_POSITION, _VELOCITY, _ATTITUDE, _POLE or _FLUSH_TO_ZERO; `state` is as it was then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _start>](
            state: *mut [<schuler_ $name>],
            abi: u32,
            rate_hz: f64,
            order: u32,
            initial: *const schuler_solution_f64,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe { keep(state, abi, || Navigation::<$type>::start(rate_hz, order, &get(initial)?.into())) })
        }

        #[doc = "The same in the navigator's own precision, with nothing in double precision where that is single: "
            "`interval_s` is the interval from sample to sample, s, at most 1 s, with its rest."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _start_own>](
            state: *mut [<schuler_ $name>],
            abi: u32,
            interval_s: *const [<schuler_pair_ $number>],
            order: u32,
            initial: *const [<schuler_solution_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                keep(state, abi, || {
                    let interval_s = get(interval_s)?.into();
                    Navigation::<$type>::start_own(interval_s, order, &get(initial)?.into())
                })
            })
        }

        #[doc = "Takes a sample: increments over the interval that the navigator was started with. The state moves on "
            "whenever a block is complete. Fails with SCHULER_REJECTED_ANGLE, _VELOCITY, _TURN, _POLE or _PLACE, "
            "SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; the state is as it was then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _push>](
            state: *mut [<schuler_ $name>],
            sample: *const [<schuler_increment_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held_mut::<_, Navigation<$type>>(state).and_then(|navigation| navigation.push(get(sample)?.into()))
            })
        }

        #[doc = "The same for a unit that delivers rates: those at the start and at the end of the sample, integrated by "
            "the trapezoid. A unit that averages over the sample has increments: mean times interval, for _push."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _push_rates>](
            state: *mut [<schuler_ $name>],
            at_start: *const [<schuler_rates_ $number>],
            at_end: *const [<schuler_rates_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held_mut::<_, Navigation<$type>>(state)
                    .and_then(|navigation| navigation.push_rates(&get(at_start)?.into(), &get(at_end)?.into()))
            })
        }

        navigator! { @any $any $name, $number, $type }

        #[doc = "Ends the stream: integrates the samples that wait for look-ahead. More may follow. Fails with "
            "SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE."]
        ///
        /// # Safety
        ///
        /// The pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _finish>](state: *mut [<schuler_ $name>]) -> i32 {
            // SAFETY: as promised.
            result(unsafe { held_mut::<_, Navigation<$type>>(state).map(Navigation::finish) })
        }

        #[doc = "The solution at the end of the last block, in local axes and in double precision, from all digits that "
            "the navigator carries. Fails as _finish does; `solution` is as it was then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing writes meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _read>](
            state: *const [<schuler_ $name>],
            solution: *mut schuler_solution_f64,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Navigation<$type>>(state)
                    .and_then(|navigation| put(solution, || Ok(navigation.read().into())))
            })
        }

        #[doc = "The same in the navigator's own precision and axes: every bit of its output, and the least work."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing writes meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _read_own>](
            state: *const [<schuler_ $name>],
            solution: *mut [<schuler_solution_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Navigation<$type>>(state)
                    .and_then(|navigation| put(solution, || Ok(navigation.read_own().into())))
            })
        }

        #[doc = "The solution at the newest sample, without the delay of a block, as _read has it. The state does not "
            "change. Fails as _finish does; `solution` is as it was then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing writes meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _predict>](
            state: *const [<schuler_ $name>],
            solution: *mut schuler_solution_f64,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Navigation<$type>>(state)
                    .and_then(|navigation| put(solution, || Ok(navigation.predict().into())))
            })
        }

        #[doc = "The same as _read_own has it."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing writes meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _predict_own>](
            state: *const [<schuler_ $name>],
            solution: *mut [<schuler_solution_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Navigation<$type>>(state)
                    .and_then(|navigation| put(solution, || Ok(navigation.predict_own().into())))
            })
        }

        #[doc = "Corrects the state at the end of the last block, as a filter does. Fails with SCHULER_CORRECTION_SIZE, "
            "_POLE, _PLACE or _STATE, and as _finish does; the state is as it was then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _correct>](
            state: *mut [<schuler_ $name>],
            correction: *const [<schuler_correction_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held_mut::<_, Navigation<$type>>(state).and_then(|navigation| navigation.correct(get(correction)?))
            })
        }

        #[doc = "Holds the vertical, as an altimeter would: height above the ellipsoid, m, and vertical velocity, down "
            "positive, m/s. Fails with SCHULER_REJECTED_HELD, and as _finish does; the state is as it was then."]
        ///
        /// # Safety
        ///
        /// The pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _hold_vertical>](
            state: *mut [<schuler_ $name>],
            altitude_m: $number,
            down_m_s: $number,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held_mut::<_, Navigation<$type>>(state)
                    .and_then(|navigation| navigation.hold_vertical(altitude_m, down_m_s))
            })
        }

        #[doc = "How many samples lie behind the solution that _read gives. Fails as _finish does."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing writes meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _integrated>](
            state: *const [<schuler_ $name>],
            samples: *mut u64,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Navigation<$type>>(state)
                    .and_then(|navigation| put(samples, || Ok(navigation.integrated())))
            })
        }

        #[doc = "Adds the state to a running digest if a block has been completed since the last time: call it after every "
            "sample, then _finish and _digest_end. For the same samples the digest is the same on every target, and that "
            "of `schuler run` and `schuler hil`. Fails as _finish does; nothing changes then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _digest>](
            state: *const [<schuler_ $name>],
            digest: *mut schuler_digest,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Navigation<$type>>(state)
                    .and_then(|navigation| Ok(navigation.digest(held_mut::<_, Running>(digest)?, false)))
            })
        }

        #[doc = "The same at the end of the stream, after _finish: the last state is added in any case."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _digest_end>](
            state: *const [<schuler_ $name>],
            digest: *mut schuler_digest,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Navigation<$type>>(state)
                    .and_then(|navigation| Ok(navigation.digest(held_mut::<_, Running>(digest)?, true)))
            })
        }

        #[doc = "Writes the state as bytes that any target can restore, with a check: SCHULER_" $name:upper "_SAVED of "
            "them, to the front of `length`. Fails with SCHULER_ERROR_SPACE, and as _finish does; nothing is written then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, `bytes` to `length` of them.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _save>](
            state: *const [<schuler_ $name>],
            bytes: *mut u8,
            length: usize,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Navigation<$type>>(state)
                    .and_then(|navigation| navigation.save(bytes_mut(bytes, length)?).map(|_| ()))
            })
        }

        #[doc = "Goes on from `length` bytes that _save has written, bit for bit; the state need not have been started. "
            "Fails with SCHULER_ERROR_DAMAGED, _FOREIGN (another navigator's), _STALE (another version's), _ABI, _NULL or "
            "_MISALIGNED; the state is as it was then."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, `stored` to `length` of them.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _restore>](
            state: *mut [<schuler_ $name>],
            abi: u32,
            stored: *const u8,
            length: usize,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe { keep(state, abi, || Navigation::<$type>::restore(bytes(stored, length)?)) })
        }

        #[doc = "Ends the use of a state: until it is started again, it is refused with SCHULER_ERROR_NOT_STARTED. Fails "
            "as _finish does."]
        ///
        /// # Safety
        ///
        /// The pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _forget>](state: *mut [<schuler_ $name>]) -> i32 {
            // SAFETY: as promised.
            result(unsafe { forget::<_, Navigation<$type>>(state) })
        }

        #[doc = "Bytes that the library needs of a schuler_" $name ": at most its size."]
        #[unsafe(no_mangle)]
        pub extern "C" fn [<schuler_ $name _size>]() -> usize {
            crate::held::size::<Navigation<$type>>()
        }
    } };
    (@any false $name:ident, $number:ident, $type:ty) => {};
    (@any true $name:ident, $number:ident, $type:ty) => { paste! {
        #[doc = "Takes a sample that lasts `interval_s` seconds, above 0 and at most 1, given with its rest. At the "
            "interval of the start it leaves the bits of _push. Fails as _push does, and with SCHULER_REJECTED_INTERVAL."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _push_over>](
            state: *mut [<schuler_ $name>],
            sample: *const [<schuler_increment_ $number>],
            interval_s: *const [<schuler_pair_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held_mut::<_, Navigation<$type>>(state)
                    .and_then(|navigation| navigation.push_over(get(sample)?.into(), get(interval_s)?.into()))
            })
        }

        #[doc = "The same for rates at the sample's start and end."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<schuler_ $name _push_rates_over>](
            state: *mut [<schuler_ $name>],
            at_start: *const [<schuler_rates_ $number>],
            at_end: *const [<schuler_rates_ $number>],
            interval_s: *const [<schuler_pair_ $number>],
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held_mut::<_, Navigation<$type>>(state).and_then(|navigation| {
                    let (start, end) = (get(at_start)?.into(), get(at_end)?.into());
                    navigation.push_rates_over(&start, &end, get(interval_s)?.into())
                })
            })
        }
    } };
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
