//! `allan.csv`: every point with its interval and what is configured.

use super::{Axis, table};
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
            let fit = &axis.identified.fit;
            let [lower, upper] = table::bounds(fit.freedom.get(i).copied().unwrap_or(1.0));
            let deviation = point.deviation();
            let configured = axis.expected(point.tau_s).sqrt();
            [
                name.to_owned(),
                exact(point.tau_s),
                point.differences.to_string(),
                exact(deviation),
                exact(deviation * lower),
                exact(deviation * upper),
                exact(fit.expected.get(i).copied().unwrap_or(0.0).sqrt()),
                exact(configured),
            ]
        })
    });
    csv(COLUMNS, rows)
}
