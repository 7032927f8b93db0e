//! A state in the caller's memory. Two words before it tell whose it is: a state that was never started, one of
//! another type, and one that another version of the library has left are refused before anything is read.

use crate::SCHULER_ABI;
use crate::results::Code;
use core::mem::offset_of;

/// The upper half of the first word of every state; the version of the interface is the lower.
const MARK: u32 = 0x5c1e << 16;

/// A value with its mark.
#[repr(C)]
pub(crate) struct Held<T> {
    mark: u32,
    kind: u32,
    value: T,
}

/// What is kept in the caller's memory.
pub(crate) trait Keep: Sized {
    /// A number that no other type has.
    const KIND: u32;
}

/// Whether a program was compiled for this library.
pub(crate) fn check_abi(abi: u32) -> Result<(), Code> {
    if abi == SCHULER_ABI { Ok(()) } else { Err(Code::ABI) }
}

/// Whether the caller's memory can hold a state, and the state's place in it.
fn place<O, T: Keep>(memory: *mut O) -> Result<*mut Held<T>, Code> {
    const {
        assert!(
            size_of::<Held<T>>() <= size_of::<O>(),
            "a state has grown: enter its size in sizes.rs"
        );
        assert!(align_of::<Held<T>>() <= align_of::<O>());
    }
    if memory.is_null() {
        Err(Code::NULL)
    } else if memory.is_aligned() {
        Ok(memory.cast())
    } else {
        Err(Code::MISALIGNED)
    }
}

/// The place of a state, if its mark says that one is there.
///
/// # Safety
///
/// The pointer is null, misaligned, or one to an `O`.
unsafe fn marked<O, T: Keep>(memory: *mut O) -> Result<*mut Held<T>, Code> {
    let held = place::<O, T>(memory)?;
    // SAFETY: it leads to an `O`, which is at least as large, and any bits are a u32.
    let (mark, kind) = unsafe {
        let words = held.cast::<u8>();
        (
            words.add(offset_of!(Held<T>, mark)).cast::<u32>().read(),
            words.add(offset_of!(Held<T>, kind)).cast::<u32>().read(),
        )
    };
    if mark & 0xffff_0000 != MARK {
        Err(Code::NOT_STARTED)
    } else if mark != MARK | SCHULER_ABI {
        Err(Code::STALE)
    } else if kind != T::KIND {
        Err(Code::FOREIGN)
    } else {
        Ok(held)
    }
}

/// A state that was started.
///
/// # Safety
///
/// The pointer is null, misaligned, or one to an `O` that is zero, not yet used, or written by this library, and
/// that nothing writes meanwhile.
pub(crate) unsafe fn held<'a, O, T: Keep>(memory: *const O) -> Result<&'a T, Code> {
    // SAFETY: as promised; the mark says that this library has written a `T`.
    unsafe { Ok(&(*marked::<O, T>(memory.cast_mut())?).value) }
}

/// The same, to go on with.
///
/// # Safety
///
/// As for [`held`], and nothing else reads it meanwhile.
pub(crate) unsafe fn held_mut<'a, O, T: Keep>(memory: *mut O) -> Result<&'a mut T, Code> {
    // SAFETY: as promised; the mark says that this library has written a `T`.
    unsafe { Ok(&mut (*marked::<O, T>(memory)?).value) }
}

/// Puts a state into the caller's memory, unless it cannot be made.
///
/// # Safety
///
/// The pointer is null, misaligned, or one to an `O` that nothing else reads or writes meanwhile.
pub(crate) unsafe fn keep<O, T: Keep>(
    memory: *mut O,
    abi: u32,
    make: impl FnOnce() -> Result<T, Code>,
) -> Result<(), Code> {
    check_abi(abi)?;
    let held = place::<O, T>(memory)?;
    let value = make()?;
    // SAFETY: it leads to an `O`, which is at least as large and aligned.
    unsafe { held.write(Held { mark: MARK | SCHULER_ABI, kind: T::KIND, value }) };
    Ok(())
}

/// Takes the mark away: whoever uses the state before it is started again is refused.
///
/// # Safety
///
/// As for [`held_mut`].
pub(crate) unsafe fn forget<O, T: Keep>(memory: *mut O) -> Result<(), Code> {
    // SAFETY: as promised.
    unsafe { (*marked::<O, T>(memory)?).mark = 0 };
    Ok(())
}

/// Bytes that a state takes with its mark.
pub(crate) const fn size<T>() -> usize {
    size_of::<Held<T>>()
}
