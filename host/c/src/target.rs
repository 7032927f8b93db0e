//! The application of a target: a C program that is flown beside its host twin by `schuler hil`.

use crate::held::{Keep, held, held_mut, keep};
use crate::pointer::put;
use crate::results::{Code, result};
use core::ffi::c_void;
use pastey::paste;
use schuler::link::fleet::{Every, Fleet, Single};
use schuler::link::target::Target;

/// Sends bytes, all of them. `context` is what the caller gave beside it.
pub type schuler_send =
    Option<unsafe extern "C" fn(context: *mut c_void, bytes: *const u8, count: usize)>;

macro_rules! target {
    ($name:ident, $fleet:ty, $kind:literal, $words:literal, $about:literal) => { paste! {
        impl Keep for Target<$fleet> {
            const KIND: u32 = $kind;
        }

        #[doc = "The application of a target: it navigates what a host sends, " $about ". Allocate it anywhere."]
        #[repr(C)]
        #[derive(Clone, Copy, Debug)]
        pub struct $name {
            /// The library's.
            pub opaque: [u64; $words],
        }

        #[doc = "Switches a target on; `boot` is how often it was before, or another number that differs every time, and "
            "`abi` SCHULER_ABI. Then say _hello. Fails with SCHULER_ERROR_NULL, _MISALIGNED or _ABI."]
        ///
        /// # Safety
        ///
        /// The pointer is null or leads to what its type says, which nothing else uses meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<$name _start>](target: *mut $name, abi: u32, boot: u32) -> i32 {
            // SAFETY: as promised.
            result(unsafe { keep(target, abi, || Ok(Target::<$fleet>::new(boot))) })
        }

        #[doc = "Announces the target: the first frame that it sends, through `send`. Fails with SCHULER_ERROR_NULL, "
            "_MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE."]
        ///
        /// # Safety
        ///
        /// The target is null or leads to what its type says, which nothing else uses meanwhile, `send` neither; `send`
        /// is null or a function that can be called with `context`.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<$name _hello>](
            target: *mut $name,
            send: schuler_send,
            context: *mut c_void,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe { with::<_, $fleet>(target, send, context, |target, send| target.hello(&mut |bytes: &[u8]| send(bytes))) })
        }

        #[doc = "Takes a byte from the line. A frame that it completes is answered through `send`, which gets all bytes of "
            "the answer at once. Fails as _hello does; nothing changes then."]
        ///
        /// # Safety
        ///
        /// As for _hello.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<$name _take>](
            target: *mut $name,
            byte: u8,
            send: schuler_send,
            context: *mut c_void,
        ) -> i32 {
            // SAFETY: as promised.
            result(unsafe { with::<_, $fleet>(target, send, context, |target, send| target.take(byte, &mut |bytes: &[u8]| send(bytes))) })
        }

        #[doc = "How many samples the target has taken; 0 before the host has started a flight. Fails as _hello does."]
        ///
        /// # Safety
        ///
        /// Each pointer is null or leads to what its type says, which nothing writes meanwhile.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<$name _taken>](target: *const $name, samples: *mut u32) -> i32 {
            // SAFETY: as promised.
            result(unsafe {
                held::<_, Target<$fleet>>(target)
                    .and_then(|target| put(samples, || Ok(target.flight().map_or(0, Fleet::taken))))
            })
        }
    } };
}

/// Lets a target answer through the caller's function.
///
/// # Safety
///
/// As for the exported functions.
unsafe fn with<O, F: Fleet>(
    target: *mut O,
    send: schuler_send,
    context: *mut c_void,
    answer: impl FnOnce(&mut Target<F>, &mut dyn FnMut(&[u8])),
) -> Result<(), Code>
where
    Target<F>: Keep,
{
    // SAFETY: as promised.
    let target = unsafe { held_mut::<_, Target<F>>(target) }?;
    let send = send.ok_or(Code::NULL)?;
    // SAFETY: as promised.
    answer(target, &mut |bytes: &[u8]| unsafe { send(context, bytes.as_ptr(), bytes.len()) });
    Ok(())
}

target!(schuler_target, Every, 0xf000_0008, 224, "with every navigator that the link knows");
target!(
    schuler_target_f32,
    Single,
    0xf000_0009,
    142,
    "in single precision and local axes, without a double"
);

/// For the tests.
#[cfg(not(feature = "archive"))]
pub(crate) fn needs(see: &mut dyn FnMut(&str, usize, usize)) {
    see("schuler_target", size_of::<schuler_target>(), crate::held::size::<Target<Every>>());
    see(
        "schuler_target_f32",
        size_of::<schuler_target_f32>(),
        crate::held::size::<Target<Single>>(),
    );
}
