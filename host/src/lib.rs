//! Flies scenes through the `schuler` core: truth, sensors, navigation, drift against theory.

pub mod audit;
pub mod cli;
pub mod emulate;
pub mod emulator;
pub mod ensemble;
pub mod flight;
pub mod frontier;
pub mod hil;
pub mod input;
pub mod lanes;
pub mod navigator;
pub mod output;
pub mod plan;
pub mod progress;
pub mod recording;
pub mod replay;
pub mod report;
pub mod rest;
pub mod run;
pub mod scene;
pub mod simulate;
pub mod source;
pub mod stress;
pub mod theory;
pub mod timing;
pub mod units;
