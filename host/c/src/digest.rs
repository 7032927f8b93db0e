//! The running digest of a chain, for ports that compare states with the golden ones.

use crate::held::{Keep, held, held_mut, keep};
use crate::pointer::put;
use crate::results::{Code, result};
use schuler::digest::Digest;

/// A digest with the number of samples behind the state that it has taken in last.
#[derive(Clone, Copy, Default)]
pub(crate) struct Running {
    pub(crate) digest: Digest,
    pub(crate) integrated: u64,
}

impl Keep for Running {
    const KIND: u32 = 0xf000_0002;
}

/// A running digest of states. Allocate it anywhere.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct schuler_digest {
    /// The library's.
    pub opaque: [u64; 7],
}

/// Starts with no state; `abi` is SCHULER_ABI. Fails with SCHULER_ERROR_NULL, _MISALIGNED or _ABI.
///
/// # Safety
///
/// The pointer is null or leads to what its type says, which nothing else uses meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schuler_digest_start(digest: *mut schuler_digest, abi: u32) -> i32 {
    // SAFETY: as promised.
    result(unsafe { keep(digest, abi, || Ok(Running::default())) })
}

/// Adds a state: `count` words, each with the bits of a number in its low end, as a row of a chain has them. Fails
/// with SCHULER_ERROR_NULL, _MISALIGNED, _NOT_STARTED, _FOREIGN or _STALE; nothing changes then.
///
/// # Safety
///
/// Each pointer is null or leads to what its type says, `words` to `count` of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schuler_digest_add(
    digest: *mut schuler_digest,
    words: *const u64,
    count: usize,
) -> i32 {
    // SAFETY: as promised; the pointer is looked at before it is followed.
    result(unsafe {
        held_mut::<_, Running>(digest).and_then(|digest| {
            if words.is_null() {
                return Err(Code::NULL);
            }
            if !words.is_aligned() {
                return Err(Code::MISALIGNED);
            }
            digest.digest.add_words(core::slice::from_raw_parts(words, count).iter().copied());
            Ok(())
        })
    })
}

/// The digest of everything so far: that of a chain's `#` and `=` lines. Fails as schuler_digest_add does.
///
/// # Safety
///
/// Each pointer is null or leads to what its type says, which nothing writes meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schuler_digest_value(
    digest: *const schuler_digest,
    value: *mut u64,
) -> i32 {
    // SAFETY: as promised.
    result(unsafe {
        held::<_, Running>(digest).and_then(|digest| put(value, || Ok(digest.digest.value())))
    })
}

/// For the tests.
#[cfg(not(feature = "archive"))]
pub(crate) fn needs(see: &mut dyn FnMut(&str, usize, usize)) {
    see("schuler_digest", size_of::<schuler_digest>(), crate::held::size::<Running>());
}
