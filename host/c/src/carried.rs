//! Samples in double precision for a navigator in single: what rounding drops goes into the next sample.

use crate::held::{Keep, held_mut, keep};
use crate::pointer::{get, put};
use crate::results::result;
use crate::values::{
    schuler_increment_f32, schuler_increment_f64, schuler_pair_f32, schuler_pair_f64,
};
use schuler::flight::carried::Carried;
use schuler::math::compensated::Pair;

impl Keep for Carried {
    const KIND: u32 = 0xf000_0001;
}

/// What the rounding of samples to single precision has dropped so far. Allocate it anywhere.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct schuler_carried {
    /// The library's.
    pub opaque: [u64; 7],
}

/// Starts with nothing dropped; `abi` is SCHULER_ABI. Fails with SCHULER_ERROR_NULL, _MISALIGNED or _ABI.
///
/// # Safety
///
/// The pointer is null or leads to what its type says, which nothing else uses meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schuler_carried_start(carried: *mut schuler_carried, abi: u32) -> i32 {
    // SAFETY: as promised.
    result(unsafe { keep(carried, abi, || Ok(Carried::default())) })
}

/// Rounds a sample to single precision: y = x + c, narrow = (float)y, c = y - narrow, for each of its numbers. The
/// rest c stays for the next sample, so that no rounding adds up. A sample that the navigator then refuses has been
/// carried all the same: copy the state before, and put the copy back. Fails with SCHULER_ERROR_NULL, _MISALIGNED,
/// _NOT_STARTED, _FOREIGN or _STALE; nothing changes then.
///
/// # Safety
///
/// Each pointer is null or leads to what its type says, which nothing else uses meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schuler_carried_narrow(
    carried: *mut schuler_carried,
    sample: *const schuler_increment_f64,
    narrow: *mut schuler_increment_f32,
) -> i32 {
    // SAFETY: as promised.
    result(unsafe {
        held_mut::<_, Carried>(carried).and_then(|carried| {
            let sample = get(sample)?.into();
            put(narrow, || Ok(carried.narrow::<f32>(&sample).into()))
        })
    })
}

/// A number of two doubles as one of two floats, such as an interval. Fails with SCHULER_ERROR_NULL or _MISALIGNED.
///
/// # Safety
///
/// Each pointer is null or leads to what its type says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schuler_pair_narrow(
    wide: *const schuler_pair_f64,
    narrow: *mut schuler_pair_f32,
) -> i32 {
    // SAFETY: as promised.
    result(unsafe {
        get(wide).and_then(|wide| put(narrow, || Ok(Pair::narrow(wide.into()).into())))
    })
}

/// The interval of a rate in hertz, s, to twice the digits of a double. Fails with SCHULER_ERROR_NULL or _MISALIGNED.
///
/// # Safety
///
/// The pointer is null or leads to what its type says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn schuler_interval_of(
    rate_hz: f64,
    interval_s: *mut schuler_pair_f64,
) -> i32 {
    // SAFETY: as promised.
    result(unsafe { put(interval_s, || Ok(Pair::new(rate_hz).reciprocal().into())) })
}

/// For the tests.
#[cfg(not(feature = "archive"))]
pub(crate) fn needs(see: &mut dyn FnMut(&str, usize, usize)) {
    see("schuler_carried", size_of::<schuler_carried>(), crate::held::size::<Carried>());
}
