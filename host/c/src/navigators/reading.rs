//! Solutions and digests out.

/// The functions that read a state: `reading!(name, scalar, type)`.
macro_rules! reading {
    ($name:ident, $number:ident, $type:ty) => { paste! {
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
    } };
}
pub(super) use reading;
