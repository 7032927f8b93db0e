//! Samples in, and what a filter or an altimeter knows.

/// The functions that take a sample of the interval of the start: `taking!(name, scalar, type)`.
macro_rules! taking {
    ($name:ident, $number:ident, $type:ty) => { paste! {
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
    } };
}
pub(super) use taking;

/// Those that take a sample of any length.
macro_rules! taking_any {
    ($name:ident, $number:ident, $type:ty) => { paste! {
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
pub(super) use taking_any;
