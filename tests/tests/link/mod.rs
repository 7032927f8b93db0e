//! The link: frames that any byte may hit, and the target's application at its end.

mod aided;
mod application;
mod damaged;
mod framing;
mod last_number;
mod line;
mod session;
