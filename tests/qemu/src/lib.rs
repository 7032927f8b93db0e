//! The firmware's images, flown in QEMU: what they report, against the host and against the budget.

pub mod budget;
pub mod check;
pub mod hil;
pub mod image;
pub mod machine;
pub mod paths;
pub mod qemu;
pub mod twin;
