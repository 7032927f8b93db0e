//! Aiding: the covariance of a navigator's errors, measurements of them, and their feedback.
//!
//! A filter stands beside a mechanization. Over every step it carries the covariance on from the integrals of the
//! body step; a measurement gives an estimate of the errors, which goes back into the running state as a
//! [`Correction`](crate::strapdown::correction::Correction), and into the biases.
//!
//! | room or file | what it has |
//! |---|---|
//! | [`covariance`] | the factors U and D, and the operations on them |
//! | [`transition`] | how errors grow over a step: Φ from R, u, s, T and Γ |
//! | [`surroundings`] | the Earth's rate, the gradient of gravitation and the radii at a place |
//! | [`states`] | biases and further states: their noise, and their estimates |
//! | [`model`] | the list of states of a filter, with its noise |
//! | [`filter`] | covariance and estimates together: a step, a measurement, its feedback |
//! | [`measurement`] | rows of measurements: position, velocity, displacement, height, along the body |
//! | [`gate`] | a vector accepted or refused as a whole; what happens after many refusals |
//! | [`transport`] | a measurement of the past as one of the present |
//! | [`standstill`] | whether a vehicle stands still, by the scatter of its samples |
//! | [`chi_square`] | limits for a false alarm's frequency |
//! | [`feedback`] | the estimated errors as a correction |
//! | [`aided`] | the aided navigator: a mechanization with a filter, and measurements that come late |
//! | [`alignment`] | fine alignment of a vehicle that stands still, sways or turns |
//!
//! The state is ordered δr, δv, ψ, gyro biases, accelerometer biases, further states.
//!
//! ```
//! use schuler::aiding::filter::Filter;
//! use schuler::aiding::model::Model;
//! use schuler::aiding::states::Process;
//!
//! let model = Model::new(1e-6_f64, 1e-4, Process::constant(1e-7), Process::constant(1e-3));
//! let filter = Filter::<f64, 15, 120, 0>::new(&model);
//! assert!((filter.covariance().sigma(9) - 1e-7).abs() < 1e-20);
//! ```

pub mod aided;
pub mod alignment;
pub mod chi_square;
pub mod covariance;
pub mod feedback;
pub mod filter;
pub mod gate;
pub mod measurement;
pub mod model;
pub mod standstill;
pub mod states;
pub mod surroundings;
pub mod transition;
pub mod transport;
