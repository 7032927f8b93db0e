//! What benchmarks measure: the paper's flight, flown by each mechanization.

pub mod paper;
pub mod work;
