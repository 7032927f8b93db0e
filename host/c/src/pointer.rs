//! What comes through a pointer: null and misaligned ones are refused, everything else the caller answers for.

use crate::results::Code;

/// Whether a pointer can be one to a `T`.
fn admit<T>(pointer: *const T) -> Result<(), Code> {
    if pointer.is_null() {
        Err(Code::NULL)
    } else if pointer.is_aligned() {
        Ok(())
    } else {
        Err(Code::MISALIGNED)
    }
}

/// A copy of what a pointer leads to.
///
/// # Safety
///
/// The pointer is null, misaligned, or one to a valid `T`.
pub(crate) unsafe fn get<T: Copy>(pointer: *const T) -> Result<T, Code> {
    admit(pointer)?;
    // SAFETY: it is neither null nor misaligned, so it is valid.
    Ok(unsafe { pointer.read() })
}

/// Writes where a pointer leads to, unless what was to be written is refused.
///
/// # Safety
///
/// The pointer is null, misaligned, or one to memory for a `T`.
pub(crate) unsafe fn put<T>(
    pointer: *mut T,
    value: impl FnOnce() -> Result<T, Code>,
) -> Result<(), Code> {
    admit(pointer)?;
    let value = value()?;
    // SAFETY: it is neither null nor misaligned, so it leads to memory for a `T`.
    unsafe { pointer.write(value) };
    Ok(())
}

/// What a pointer leads to, for as long as a function runs.
///
/// # Safety
///
/// The pointer is null, misaligned, or one to a valid `T` that nothing else reads or writes meanwhile.
pub(crate) unsafe fn change<'a, T>(pointer: *mut T) -> Result<&'a mut T, Code> {
    admit(pointer)?;
    // SAFETY: it is neither null nor misaligned, so it is valid and no one else's.
    Ok(unsafe { &mut *pointer })
}

/// The bytes from a pointer on.
///
/// # Safety
///
/// The pointer is null, or one to so many bytes that nothing writes meanwhile.
pub(crate) unsafe fn bytes<'a>(pointer: *const u8, length: usize) -> Result<&'a [u8], Code> {
    admit(pointer)?;
    // SAFETY: it is not null, so the bytes are there.
    Ok(unsafe { core::slice::from_raw_parts(pointer, length) })
}

/// The same, to be written.
///
/// # Safety
///
/// The pointer is null, or one to so many bytes that nothing else reads or writes meanwhile.
pub(crate) unsafe fn bytes_mut<'a>(pointer: *mut u8, length: usize) -> Result<&'a mut [u8], Code> {
    admit(pointer)?;
    // SAFETY: it is not null, so the bytes are there. Any byte is a u8, but uninitialised ones must not be
    // read: only writes go there.
    Ok(unsafe { core::slice::from_raw_parts_mut(pointer, length) })
}
