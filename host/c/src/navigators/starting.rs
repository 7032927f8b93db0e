//! Start, store, restore and forget.

/// The functions by which a state begins and ends: `starting!(name, scalar, type)`.
macro_rules! starting {
    ($name:ident, $number:ident, $type:ty) => { paste! {
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
}
pub(super) use starting;
