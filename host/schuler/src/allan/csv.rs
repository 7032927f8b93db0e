//! `allan.csv`: every point with its interval and what is configured.

use super::Axis;
use schuler_simulator::allan::still::AXES;
use schuler_simulator::number::exact;
use schuler_simulator::output::csv;

const COLUMNS: [&str; 8] =
    ["axis", "tau_s", "differences", "deviation", "lower_95", "upper_95", "fitted", "configured"];

/// The file, in SI: rad/s and m/s².
pub fn bytes(axes: &[Option<Axis>; 6]) -> Vec<u8> {
    let rows = axes.iter().zip(AXES).filter_map(|(axis, name)| Some((axis.as_ref()?, name)));
    let rows = rows.flat_map(|(axis, name)| {
        axis.points.iter().enumerate().map(move |(i, point)| {
            let [deviation, lower, upper, fitted, configured] = axis.beside(i, point).map(exact);
            let differences = point.differences.to_string();
            let name = name.to_owned();
            [name, exact(point.tau_s), differences, deviation, lower, upper, fitted, configured]
        })
    });
    csv(COLUMNS, rows)
}
