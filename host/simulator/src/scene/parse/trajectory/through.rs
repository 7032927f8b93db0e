//! The path through the rows of a log.

use schuler::trajectory::log::{Log, LogError, Outcome, compile};
use schuler::trajectory::piecewise::piece::Piece;
use schuler::trajectory::spline::smooth::Workspace;
use schuler::trajectory::spline::{BAND, EXTRA};

/// The pieces of a path by all rows.
pub(super) fn pieces(rows: &Log<'_>) -> Result<(Vec<Piece<8>>, Outcome), LogError> {
    let room = rows.times_s.len() + EXTRA;
    let (mut gram, mut factors) = (vec![[0.0; BAND]; room], vec![[0.0; BAND]; room]);
    let mut right = vec![[0.0; 4]; room];
    let (mut position, mut turning) = (right.clone(), right.clone());
    let workspace = Workspace { gram: &mut gram, factors: &mut factors, right: &mut right };
    let (path, outcome) = compile(rows, rows.times_s, workspace, &mut position, &mut turning)?;
    Ok(((0..path.pieces()).filter_map(|index| path.piece(index)).collect(), outcome))
}
