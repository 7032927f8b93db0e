//! Fast random words: SplitMix64 of Steele, Lea and Flood.

/// The state's step: 2⁶⁴ over the golden ratio.
pub const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// The next word.
pub fn word(state: &mut u64) -> u64 {
    *state = state.wrapping_add(STEP);
    let x = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}
