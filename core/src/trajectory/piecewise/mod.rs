//! Any path: piecewise polynomials of the outward normal, the height and the attitude.
//!
//! | file | what it has |
//! |---|---|
//! | [`piece`] | one piece, and the order of its channels |

pub mod piece;
