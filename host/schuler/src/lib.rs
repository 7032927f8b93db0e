//! The program `schuler`: its commands, each on the simulator, and what they write.
//!
//! | room | what it has |
//! |---|---|
//! | [`cli`] | the command line, as plain requests |
//! | [`run`], [`emulate`], [`replay`] | one flight, one stream, one recording |
//! | [`aided`] | what became of measurements that aid |
//! | [`align`] | level and north of a recorded vehicle |
//! | [`trajectory`], [`scenes`] | what a flight is like, and what there is to fly |
//! | [`allan`], [`datasheet`] | what a sensor is made of: by measurement, by its data sheet |
//! | [`frontier`], [`stress`], [`ensemble`], [`audit`], [`hil`] | the experiments, which do not know each other |
//! | [`report`] | what a flight leaves: tables, files, charts, pages |

pub mod aided;
pub mod align;
pub mod allan;
pub mod audit;
pub mod cli;
pub mod datasheet;
pub mod emulate;
pub mod ensemble;
pub mod frontier;
pub mod hil;
pub mod replay;
pub mod report;
pub mod run;
pub mod scenes;
pub mod stress;
pub mod trajectory;
