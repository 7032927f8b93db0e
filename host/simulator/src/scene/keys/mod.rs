//! Every key of a scene, once: the parser asks here what a table may have, and the reference is written from it.
//!
//! | file | tables |
//! |---|---|
//! | [`general`] | the top level, navigator, link |
//! | [`motion`] | channels, vibration, lever arm |
//! | [`aiding`] | sensors that aid a navigator, and its filter |
//! | [`path`] | segments, way-points, logs |

pub mod aiding;
pub mod general;
pub mod motion;
pub mod path;

use super::terms::{Key as Term, TERMS};
use crate::allan::TRIADS;
use crate::datasheet::entries;
use crate::flight::Nine;
use crate::input::key::Table;
use std::fmt::Write as _;

const TABLES: [&Table; 26] = [
    &general::ROOT,
    &motion::TRAJECTORY,
    &motion::CHANNEL,
    &motion::HARMONIC,
    &motion::VIBRATION,
    &path::START,
    &path::SEGMENT,
    &path::WAYPOINTS,
    &path::POINT,
    &path::LOG,
    &general::ALIGNMENT,
    &aiding::GNSS,
    &aiding::FORGERY,
    &aiding::BAROMETER,
    &aiding::ODOMETER,
    &aiding::ZERO_VELOCITY,
    &aiding::NON_HOLONOMIC,
    &aiding::FILTER,
    &general::NAVIGATOR,
    &general::WINDOW,
    &general::LINK,
    &general::TEMPERATURE,
    &general::GYRO,
    &general::ACCELEROMETER,
    &general::GYRO_MARKOV,
    &general::ACCELEROMETER_MARKOV,
];

/// The reference of all keys, in Markdown.
pub fn reference() -> String {
    let mut text =
        "# Keys of a scene\n\nA scene is a TOML file; `schuler scenes NAME` prints one to start \
                    from. A key that is not listed here is refused, with its file and line.\n"
            .to_owned();
    for table in TABLES {
        text += "\n";
        text += &table.reference();
    }
    text += "\n## Errors of the sensors\n\nEach takes one number for all axes, or [x, y, z], but where it says rows; what is absent \
             is perfect.\n\n| error | in [gyro] | in [accelerometer] | takes |\n|---|---|---|---|\n";
    let name = |key: Option<Term>| key.map_or(String::new(), |key| format!("`{}`", key.key));
    for term in TERMS {
        let (gyro, accelerometer) = (name(term.gyro), name(term.accelerometer));
        let rows = if term.is_matrix { "three rows [x, y, z]: " } else { "" };
        let takes = term.range.accepted;
        // A String takes all that is written.
        let _ = writeln!(text, "| {} | {gyro} | {accelerometer} | {rows}{takes} |", term.name);
    }
    text += "\n### In the units of data sheets\n\nThe same terms may be given so, as in `schuler datasheet`:\n\n| in | key | gives | as |\n|---|---|---|---|\n";
    for (triad, table) in TRIADS.iter().enumerate() {
        for entry in entries::of(triad) {
            let _ = writeln!(
                text,
                "| [{table}] | `{}` | `{}` | {} |",
                entry.key, entry.gives, entry.assumed
            );
        }
    }
    text += "\n## [initial_error]\n\nWhat the navigator's start is off by; 0 where absent: ";
    let list = |names: [&str; 9]| names.map(|name| format!("`{name}`")).join(", ");
    text += &list(Nine::NAMES);
    text += ".\n\nThe standard deviation of what each run of an ensemble draws on top of it, from a stream of its own \
             by its number; `run` flies run 0 unless `--run` names another: ";
    text + &list(Nine::SIGMAS) + ".\n"
}
