//! What an aided replay leaves beside the rows of `nav.csv`, in memory.

use schuler_simulator::aided::report::{Judgement, Report};
use schuler_simulator::output::NumberRows;

/// What it leaves.
pub struct Kept {
    /// What became of the measurements.
    pub report: Report,
    /// Each of them as it was judged, at the recording's own time.
    pub judged: Vec<Judgement>,
    /// What was estimated beside the motion: a row for each of `nav.csv`.
    pub estimates: NumberRows,
    /// The smoothed states, if it is smoothed.
    pub smoothed: Option<NumberRows>,
    /// How far off it was after each span without fixes.
    pub withheld: NumberRows,
}
