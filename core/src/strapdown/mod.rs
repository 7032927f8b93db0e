//! Strapdown mechanization: increments in, position, velocity and attitude out.

pub mod behind;
pub mod block_time;
pub mod body;
mod displacement;
pub mod earth_fixed;
pub mod fit;
pub mod frame;
pub mod gain;
pub mod gravitation;
pub mod inside;
pub mod least_squares;
pub mod local_level;
pub mod mechanization;
pub mod meridian;
pub mod navigator;
pub mod newton;
pub mod plan;
pub mod rk4;
mod rows;
pub mod series;
mod stored;
pub mod support;
pub mod textbook;
mod two_float;
pub mod window;
