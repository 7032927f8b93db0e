//! The size of each state in words of eight bytes, and of its stored form in bytes: those of a processor of 64 bits,
//! the largest. `tests/header.rs` writes this file, with SCHULER_WRITE=1 in its environment.

macro_rules! words {
    (f64_local_level_h0b4a0) => { 1000 };
    (f64_local_level_h0b4a0_any) => { 1000 };
    (f64_local_level_h2b4a2) => { 1000 };
    (f64_local_level_h2b4a2_any) => { 1000 };
    (f64_local_level_textbook) => { 1000 };
    (f64_earth_fixed_h0b4a0) => { 1000 };
    (f64_earth_fixed_h0b4a0_any) => { 1000 };
    (f64_earth_fixed_h2b4a2) => { 1000 };
    (f64_earth_fixed_h2b4a2_any) => { 1000 };
    (f64_earth_fixed_textbook) => { 1000 };
    (f32_local_level_h0b4a0) => { 1000 };
    (f32_local_level_h0b4a0_any) => { 1000 };
    (f32_local_level_h2b4a2) => { 1000 };
    (f32_local_level_h2b4a2_any) => { 1000 };
    (f32_local_level_textbook) => { 1000 };
    (f32_earth_fixed_h0b4a0) => { 1000 };
    (f32_earth_fixed_h0b4a0_any) => { 1000 };
    (f32_earth_fixed_h2b4a2) => { 1000 };
    (f32_earth_fixed_h2b4a2_any) => { 1000 };
    (f32_earth_fixed_textbook) => { 1000 };
    (f32x2_local_level_h0b4a0) => { 1000 };
    (f32x2_local_level_h0b4a0_any) => { 1000 };
    (f32x2_local_level_h2b4a2) => { 1000 };
    (f32x2_local_level_h2b4a2_any) => { 1000 };
    (f32x2_earth_fixed_h0b4a0) => { 1000 };
    (f32x2_earth_fixed_h0b4a0_any) => { 1000 };
    (f32x2_earth_fixed_h2b4a2) => { 1000 };
    (f32x2_earth_fixed_h2b4a2_any) => { 1000 };
}
pub(crate) use words;

macro_rules! saved {
    (f64_local_level_h0b4a0) => { 1000 };
    (f64_local_level_h0b4a0_any) => { 1000 };
    (f64_local_level_h2b4a2) => { 1000 };
    (f64_local_level_h2b4a2_any) => { 1000 };
    (f64_local_level_textbook) => { 1000 };
    (f64_earth_fixed_h0b4a0) => { 1000 };
    (f64_earth_fixed_h0b4a0_any) => { 1000 };
    (f64_earth_fixed_h2b4a2) => { 1000 };
    (f64_earth_fixed_h2b4a2_any) => { 1000 };
    (f64_earth_fixed_textbook) => { 1000 };
    (f32_local_level_h0b4a0) => { 1000 };
    (f32_local_level_h0b4a0_any) => { 1000 };
    (f32_local_level_h2b4a2) => { 1000 };
    (f32_local_level_h2b4a2_any) => { 1000 };
    (f32_local_level_textbook) => { 1000 };
    (f32_earth_fixed_h0b4a0) => { 1000 };
    (f32_earth_fixed_h0b4a0_any) => { 1000 };
    (f32_earth_fixed_h2b4a2) => { 1000 };
    (f32_earth_fixed_h2b4a2_any) => { 1000 };
    (f32_earth_fixed_textbook) => { 1000 };
    (f32x2_local_level_h0b4a0) => { 1000 };
    (f32x2_local_level_h0b4a0_any) => { 1000 };
    (f32x2_local_level_h2b4a2) => { 1000 };
    (f32x2_local_level_h2b4a2_any) => { 1000 };
    (f32x2_earth_fixed_h0b4a0) => { 1000 };
    (f32x2_earth_fixed_h0b4a0_any) => { 1000 };
    (f32x2_earth_fixed_h2b4a2) => { 1000 };
    (f32x2_earth_fixed_h2b4a2_any) => { 1000 };
}
pub(crate) use saved;
