//! What benchmarks measure: the paper's flight flown by each mechanization, and every row of others.

pub mod flight;
pub mod paper;
pub mod work;
