//! The body's motion over a block of samples, fitted and integrated by a series, for any navigation frame.
//!
//! | file | what it has |
//! |---|---|
//! | [`shape`] | how many samples a window has |
//! | [`window`] | the named windows: which samples a block is integrated from |
//! | [`fit`] | the polynomial through a window's samples |
//! | `least_squares` | a line or a parabola through more samples than coefficients |
//! | [`series`] | the power series of attitude, velocity and position over a block |
//! | [`body`] | the block's motion: rotation, u = ∫Cf, s = ∬Cf, ∫s |
//! | [`inside`] | the same up to a row within the block |
//! | `alike` | a correction that makes all samples count alike, wherever they lie in a block |
//! | [`any_window`] | a window as a value, for a navigator whose window is chosen at run time |
//! | [`unequal`], [`intervals`], `abscissae` | samples of unequal intervals |
//! | [`newton`], `behind`, `support`, `gain` | blocks at the ends of a stream, and windows without look-ahead: as many samples as the motion supports |

pub(crate) mod abscissae;
#[doc(hidden)]
pub mod alike;
pub mod any_window;
#[doc(hidden)]
pub mod behind;
pub mod body;
pub mod fit;
#[doc(hidden)]
pub mod gain;
pub mod inside;
pub mod intervals;
#[doc(hidden)]
pub mod least_squares;
pub mod newton;
pub mod series;
pub mod shape;
#[doc(hidden)]
pub mod support;
pub mod unequal;
#[macro_use]
pub mod window;
