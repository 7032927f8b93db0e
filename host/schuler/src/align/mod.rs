//! `schuler align`: level, north and biases of a vehicle, from a recording or over the runs of a scene.
//!
//! | file | what it has |
//! |---|---|
//! | `recorded` | a recorded vehicle that stands still |
//! | `flown` | the runs of a scene |
//! | [`table`] | what is printed of those |
//! | `toml` | the file that is written |

mod flown;
mod recorded;
pub mod table;
mod toml;

use crate::cli::AlignArgs;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::simulate::FlightError;

/// Aligns, prints what is found, and writes it.
pub fn align(args: &AlignArgs) -> Result<(), FlightError> {
    match (&args.scene, &args.imu) {
        (Some(name), _) => flown::align(args, name),
        (None, Some(imu)) => recorded::align(args, imu),
        (None, None) => {
            let complaint = Complaint::new(
                "nothing to align",
                "a recording, --imu FILE, or a scene, a built-in one or the path of a TOML file",
            );
            Err(InputError::option("align", complaint).into())
        }
    }
}
