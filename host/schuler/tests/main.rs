//! Every integration test of the program, in one program: it is linked once.
//!
//! | module | what |
//! |---|---|
//! | `command_line`, `exit_codes` | options, and how the program ends |
//! | `left_behind` | what is left of a run that is stopped or cannot go on |
//! | `scene` | what scenes may say |
//! | `recording`, `rest` | what recordings may say, and what contradicts itself |
//! | `reference` | positions that others measured |
//! | `aided` | scenes aided by satellites, wheels, a barometer |
//! | `aided_replay` | recordings flown with fixes |
//! | `align` | level and north by runs of a scene and by recordings |
//! | `allan` | sensors by their Allan deviation, and by their data sheets |
//! | `audit` | chains, recorded and compared |
//! | `ensemble` | many runs |
//! | `frontier` | run time against error |
//! | `hil` | a target and its twin |
//! | `mcap` | ROS 2 messages |
//! | `terminal` | tables of 80 columns, and words for what cannot be |
//! | `trajectory` | what a flight is like, its files, and scenes to start from |
//! | `summaries` | what summaries hold, by their schema |
//! | `stress`, `stochastic` | numerical stability, and the scalar that rounds at random |

mod aided;
mod aided_replay;
mod align;
mod allan;
mod audit;
mod audit_limits;
mod audit_refused;
mod command_line;
mod ensemble;
mod exit_codes;
mod frontier;
mod hil;
mod left_behind;
mod mcap;
mod recording;
mod reference;
mod rest;
mod scene;
mod stochastic;
mod stress;
mod summaries;
mod terminal;
mod trajectory;

/// A text without the ends of its lines, which depend on the terminal's width.
fn on_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
