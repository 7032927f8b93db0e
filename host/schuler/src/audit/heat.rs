//! The effect of one unit in the last place as a heat map: a row for each input, a column for each time.

use super::sensitivity::Effect;
use schuler_report::axis::printed;
use schuler_report::page::framed;
use schuler_report::svg::escape;
use schuler_simulator::number::{Quantity, parameter};

const QUANTITIES: [(&str, Quantity); 3] = [
    ("position", Quantity::Position),
    ("velocity", Quantity::Velocity),
    ("attitude", Quantity::Attitude),
];

/// Decades from the least colour to the most, at least.
const LEAST_DECADES: f64 = 2.0;

/// The map. Colours are by the logarithm, from the least to the most of each quantity.
pub fn map(effects: &[Effect]) -> String {
    let times: Vec<f64> = effects
        .first()
        .map_or(Vec::new(), |effect| effect.after.iter().map(|a| a.time_s).collect());
    let ranges: [[f64; 2]; 3] = std::array::from_fn(|k| {
        let all = effects.iter().flat_map(|effect| effect.after.iter().map(move |a| a.norms()[k]));
        let known = all.filter(|x| *x > 0.0 && x.is_finite()).map(f64::log10);
        let [low, high] =
            known.fold([f64::MAX, f64::MIN], |[low, high], x| [low.min(x), high.max(x)]);
        // What differs by little has little of a colour's range.
        [low.min(high - LEAST_DECADES), high]
    });
    let groups: String = QUANTITIES
        .iter()
        .map(|(name, _)| format!("<th class=\"group\" colspan=\"{}\">{name}</th>", times.len()))
        .collect();
    let heads: String = times.iter().map(|t| format!("<th>{} s</th>", parameter(*t))).collect();
    let row = |effect: &Effect| {
        let cells = (0..3).flat_map(|k| {
            let norms = effect.after.iter().map(move |a| a.norms()[k]);
            norms.map(move |x| cell(x, ranges[k], QUANTITIES[k].1))
        });
        format!("<tr><td>{}</td>{}</tr>\n", escape(&effect.input), cells.collect::<String>())
    };
    let rows: String = effects.iter().map(row).collect();
    let table = format!(
        "<table class=\"numbers heat\">\n<tr><th></th>{groups}</tr>\n<tr><th>one ulp of</th>{}</tr>\n{rows}</table>",
        heads.repeat(3)
    );
    format!("<h2>What moves what</h2>\n{}", framed(&table))
}

/// How hot a value is, 0 to 1, and the value.
fn cell(value: f64, [low, high]: [f64; 2], quantity: Quantity) -> String {
    let heat = match value > 0.0 && high > low {
        true => (value.log10() - low) / (high - low),
        false => 0.0,
    };
    format!("<td style=\"--heat:{heat:.2}\">{}</td>", printed(&quantity.show(value)))
}

#[cfg(test)]
mod tests {
    use super::super::sensitivity::Moved;
    use super::*;

    #[test]
    fn the_hottest_is_the_largest_and_nothing_is_cold() {
        let moved = |north: f64| Moved { position_m: [north, 0.0, 0.0], ..Moved::default() };
        let effect = |input: &str, after: [f64; 2]| Effect {
            input: input.to_owned(),
            ulp: 1e-16,
            after: after.map(moved).to_vec(),
        };
        let map = map(&[effect("latitude", [1e-9, 1e-7]), effect("<gyro>", [0.0, 1e-5])]);
        for part in [
            "--heat:0.00\">1.000 nm",
            "--heat:0.50\">100.0 nm",
            "--heat:1.00\">10.00 µm",
            "--heat:0.00\">0 m",
        ] {
            assert!(map.contains(part), "{part}: {map}");
        }
        assert!(map.contains("&lt;gyro&gt;") && map.contains("colspan=\"2\">velocity"));
    }
}
