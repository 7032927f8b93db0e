//! Emulators of aiding sensors, beside that of the inertial unit.
//!
//! | file | what it has |
//! |---|---|
//! | [`truth`] | the true motion that they measure |
//! | [`mod@line`] | when a sensor measures, when it does not, and how late its measurements arrive |
//! | [`noise`] | white and correlated noise of a vector |
//! | [`fault`] | outliers, and positions that somebody forges |
//! | [`gnss`] | positions and velocities of a satellite receiver |
//! | [`barometer`] | heights |
//! | [`odometer`] | speeds |
//! | [`still`] | that the vehicle stands still |
//! | [`wheels`] | that it does not slip sideways |
//!
//! Every source of randomness has a stream of its own, and draws the same numbers in every epoch, heard or not. So
//! measurements do not change when a fault is added elsewhere.
//!
//! ```
//! use schuler::aiding::aided::instant::Instant;
//! use schuler::math::vector::Vector;
//! use schuler::sensor::aiding::line::Line;
//! use schuler::sensor::aiding::odometer::Odometer;
//! use schuler::sensor::aiding::truth::Truth;
//! use schuler::solution::{Euler, Solution};
//!
//! let speed = Vector::new(20.0_f64, 0.0, 0.0);
//! let solution = Solution::new(Default::default(), speed, Euler::default());
//! let truth = Truth::of(&solution, Vector::new(7.292115e-5, 0.0, 0.0));
//! let odometer = Odometer { quantum: 0.5, ..Odometer::new(Line::every(0.1), 0.2) }.checked()?;
//! let mut state = odometer.start(1, 0);
//! assert_eq!(odometer.line.epoch_s(&state.line), 0.1);
//! let heard = odometer.measure(&mut state, &truth, Instant::of_sample(10)).unwrap();
//! assert!((heard.measured.velocity.x - 20.0).abs() < 1.5);
//! assert_eq!(heard.measured.velocity.x % 0.5, 0.0);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

pub mod barometer;
pub mod fault;
pub mod gnss;
pub mod line;
pub mod noise;
pub mod odometer;
pub mod still;
pub mod truth;
pub mod wheels;
