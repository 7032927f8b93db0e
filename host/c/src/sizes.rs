//! The size of each state in words of eight bytes, and of its stored form in bytes: those of a processor of 64 bits,
//! the largest. `tests/header.rs` writes this file, with SCHULER_WRITE=1 in its environment.

#[rustfmt::skip]
macro_rules! words {
    (f64_local_level_h0b4a0) => { 117 };
    (f64_local_level_h0b4a0_any) => { 126 };
    (f64_local_level_h2b4a2) => { 165 };
    (f64_local_level_h2b4a2_any) => { 182 };
    (f64_local_level_textbook) => { 35 };
    (f64_earth_fixed_h0b4a0) => { 118 };
    (f64_earth_fixed_h0b4a0_any) => { 127 };
    (f64_earth_fixed_h2b4a2) => { 166 };
    (f64_earth_fixed_h2b4a2_any) => { 183 };
    (f64_earth_fixed_textbook) => { 34 };
    (f32_local_level_h0b4a0) => { 62 };
    (f32_local_level_h0b4a0_any) => { 67 };
    (f32_local_level_h2b4a2) => { 86 };
    (f32_local_level_h2b4a2_any) => { 95 };
    (f32_local_level_textbook) => { 19 };
    (f32_earth_fixed_h0b4a0) => { 63 };
    (f32_earth_fixed_h0b4a0_any) => { 67 };
    (f32_earth_fixed_h2b4a2) => { 87 };
    (f32_earth_fixed_h2b4a2_any) => { 95 };
    (f32_earth_fixed_textbook) => { 18 };
    (f32x2_local_level_h0b4a0) => { 62 };
    (f32x2_local_level_h0b4a0_any) => { 67 };
    (f32x2_local_level_h2b4a2) => { 86 };
    (f32x2_local_level_h2b4a2_any) => { 95 };
    (f32x2_earth_fixed_h0b4a0) => { 63 };
    (f32x2_earth_fixed_h0b4a0_any) => { 67 };
    (f32x2_earth_fixed_h2b4a2) => { 87 };
    (f32x2_earth_fixed_h2b4a2_any) => { 95 };
}
pub(crate) use words;

#[rustfmt::skip]
macro_rules! saved {
    (f64_local_level_h0b4a0) => { 768 };
    (f64_local_level_h0b4a0_any) => { 840 };
    (f64_local_level_h2b4a2) => { 1152 };
    (f64_local_level_h2b4a2_any) => { 1288 };
    (f64_local_level_textbook) => { 240 };
    (f64_earth_fixed_h0b4a0) => { 776 };
    (f64_earth_fixed_h0b4a0_any) => { 848 };
    (f64_earth_fixed_h2b4a2) => { 1160 };
    (f64_earth_fixed_h2b4a2_any) => { 1296 };
    (f64_earth_fixed_textbook) => { 232 };
    (f32_local_level_h0b4a0) => { 768 };
    (f32_local_level_h0b4a0_any) => { 840 };
    (f32_local_level_h2b4a2) => { 1152 };
    (f32_local_level_h2b4a2_any) => { 1288 };
    (f32_local_level_textbook) => { 240 };
    (f32_earth_fixed_h0b4a0) => { 776 };
    (f32_earth_fixed_h0b4a0_any) => { 848 };
    (f32_earth_fixed_h2b4a2) => { 1160 };
    (f32_earth_fixed_h2b4a2_any) => { 1296 };
    (f32_earth_fixed_textbook) => { 232 };
    (f32x2_local_level_h0b4a0) => { 768 };
    (f32x2_local_level_h0b4a0_any) => { 840 };
    (f32x2_local_level_h2b4a2) => { 1152 };
    (f32x2_local_level_h2b4a2_any) => { 1288 };
    (f32x2_earth_fixed_h0b4a0) => { 776 };
    (f32x2_earth_fixed_h0b4a0_any) => { 848 };
    (f32x2_earth_fixed_h2b4a2) => { 1160 };
    (f32x2_earth_fixed_h2b4a2_any) => { 1296 };
}
pub(crate) use saved;
