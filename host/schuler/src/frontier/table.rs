//! The front as a table of what to choose, and of what was left out.

use super::case::Case;
use super::task::Task;
use super::{LeftOut, Point};
use schuler_simulator::number::{Quantity, parameter, rounded};

/// Powers of ten that errors are sorted by, m: a picometre is below every rounding.
const DECADES: std::ops::RangeInclusive<i32> = -12..=7;
/// Characters of a line.
const WIDTH: usize = 80;

/// Points scene by scene, in the order in which scenes first occur.
pub fn by_scene(points: &[Point]) -> Vec<Vec<&Point>> {
    let mut scenes: Vec<Vec<&Point>> = Vec::new();
    for point in points {
        match scenes.iter_mut().find(|scene| scene[0].scene == point.scene) {
            Some(scene) => scene.push(point),
            None => scenes.push(vec![point]),
        }
    }
    scenes
}

/// The points of a front from the cheapest to the most accurate.
pub fn front_of<'a>(scene: &[&'a Point]) -> Vec<&'a Point> {
    let mut front: Vec<&Point> = scene.iter().copied().filter(|p| p.on_front).collect();
    front.sort_by(|a, b| a.cost_us_per_s().total_cmp(&b.cost_us_per_s()));
    front
}

/// What to pick in every scene: for this error, the cheapest is …
pub fn table(points: &[Point]) -> String {
    let mut text = String::from(
        "What to pick: for this position error, the cheapest is … Time is that of\n\
         navigation per second of flight (ns per sample × samples per second), at block\n\
         ends with no row read; errors are the largest over every row, with perfect\n\
         sensors. Where the sensor's rate is given, --rate holds it.\n",
    );
    for scene in by_scene(points) {
        let Some(first) = scene.first() else { continue };
        text += &format!(
            "\n{}, {} s\n{:>7}  {:<42} {:>9} {:>9} {:>8}\n{}\n",
            first.scene,
            parameter(first.duration_s),
            "within",
            "the cheapest is",
            "per s",
            "position",
            "attitude",
            "─".repeat(WIDTH)
        );
        for (bound, point) in picks(&scene) {
            text += &format!(
                "{:>7}  {:<42} {:>9} {:>9} {:>8}\n",
                error(Quantity::Position, bound, 1),
                point.name(),
                format!("{} µs", rounded(point.cost_us_per_s(), 3)),
                error(Quantity::Position, point.max_position_m, 2),
                error(Quantity::Attitude, point.max_attitude_arcsec, 2),
            );
        }
    }
    text
}

/// Powers of ten in metres, falling, each with the cheapest point of a scene that stays within it; of
/// those that the same point stays within, the least.
fn picks<'a>(scene: &[&'a Point]) -> Vec<(f64, &'a Point)> {
    let front = front_of(scene);
    let mut picks: Vec<(f64, &Point)> = Vec::new();
    for power in DECADES.rev() {
        let bound = 10f64.powi(power);
        // The front is sorted by cost, so the first is the cheapest.
        let Some(&pick) = front.iter().find(|point| point.max_position_m <= bound) else { break };
        match picks.last_mut() {
            Some((least, last)) if *last == pick => *least = bound,
            _ => picks.push((bound, pick)),
        }
    }
    picks
}

/// What was not measured, and why: rates that are too coarse, cases that cannot be flown.
pub fn left_out(tasks: &[Task], cases: &[Case], left_out: &[LeftOut]) -> String {
    let mut text = String::new();
    for task in tasks.iter().filter(|task| !task.too_coarse_hz.is_empty()) {
        let rates: Vec<_> = task.too_coarse_hz.iter().map(|&rate| parameter(rate)).collect();
        let (scene, rates) = (&task.scene.name, rates.join(", "));
        let why = "fewer than two samples for the fastest wave of its motion";
        text += &format!("  {scene} at {rates} Hz: {why}\n");
    }
    // Scene, rate and reason in the order of their first occurrence.
    let mut groups: Vec<Vec<&LeftOut>> = Vec::new();
    for left in left_out {
        let key =
            |other: &LeftOut| (other.scene.clone(), other.rate_hz.to_bits(), other.why.clone());
        match groups.iter_mut().find(|group| key(group[0]) == key(left)) {
            Some(group) => group.push(left),
            None => groups.push(vec![left]),
        }
    }
    for group in groups {
        let LeftOut { scene, rate_hz, why, .. } = group[0];
        let flown = cases.iter().filter(|case| !group.iter().any(|left| left.case == **case));
        let flown: Vec<_> = flown.map(|case| case.method).collect();
        let mut names: Vec<String> = Vec::new();
        for left in &group {
            // A method of which nothing is flown is told once.
            let method = left.case.method;
            let name =
                if flown.contains(&method) { left.case.to_string() } else { method.to_string() };
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let rate = parameter(*rate_hz);
        text += &format!("  {scene} at {rate} Hz: {}: {why}\n", names.join("; "));
    }
    if text.is_empty() { text } else { format!("\nLeft out:\n{text}") }
}

/// A value in the unit that fits it, to some digits.
fn error(quantity: Quantity, value: f64, digits: i32) -> String {
    let unit = quantity.unit(value.abs());
    let name = if unit.name == "arcsec" { "″" } else { unit.name };
    format!("{} {name}", rounded(value * unit.factor, digits))
}

#[cfg(test)]
mod tests {
    use super::super::sample::points;
    use super::*;

    #[test]
    fn the_table_says_what_to_pick() {
        let text = table(&points());
        assert!(text.contains("for this position error, the cheapest is"), "{text}");
        let lines: Vec<&str> = text.lines().collect();
        let slow = lines.iter().position(|line| *line == "slow, 100 s").expect(&text);
        let fast = lines.iter().position(|line| *line == "fast, 100 s").expect(&text);
        // The loosest bound first; what is beaten or lost is not there.
        let picks: Vec<&str> = lines[slow + 3..fast - 1].to_vec();
        assert_eq!(picks.len(), 2, "{text}");
        for (line, begin, parts) in [
            (
                picks[0],
                "1 m  taylor 0,4,0 local-level f32 10 Hz ",
                [" 0.40 µs ", " 120 mm ", " 1.2 ″"],
            ),
            (
                picks[1],
                "10 nm  taylor 0,4,0 earth-fixed f64 20 Hz ",
                [" 1.20 µs ", " 8.0 nm ", " 80 nas"],
            ),
            (
                lines[fast + 3],
                "10000 m  taylor 2,4,2 earth-fixed f64-plain 1000 Hz ",
                [" 100 µs ", " 1500 m ", " 4.2 °"],
            ),
        ] {
            assert!(line.trim_start().starts_with(begin), "{line}");
            assert!(parts.iter().all(|part| line.contains(part)), "{line}: {parts:?}");
        }
        assert!(lines.iter().all(|line| line.chars().count() <= 80), "{text}");
    }

    #[test]
    fn the_pick_of_a_decade_is_the_cheapest_within_it() {
        let points = points();
        let scene: Vec<&Point> = points[..4].iter().collect();
        let picks = picks(&scene);
        for power in DECADES {
            let bound = 10f64.powi(power);
            let within = scene.iter().filter(|point| point.max_position_m <= bound);
            let cheapest = within.min_by(|a, b| a.cost_us_per_s().total_cmp(&b.cost_us_per_s()));
            // The first row whose bound is at most what is wanted.
            let pick = picks.iter().find(|(least, _)| *least <= bound).map(|(_, point)| point);
            assert_eq!(pick, cheapest, "{bound}");
        }
    }

    #[test]
    fn what_is_left_out_is_told_once() {
        let cases = Case::all();
        let left = |rate_hz: f64, name: &'static str| {
            let named = cases.iter().filter(move |case| case.to_string().starts_with(name));
            named.map(move |&case| {
                let (scene, why) = ("fast".to_owned(), "too far".to_owned());
                LeftOut { scene, rate_hz, case, why }
            })
        };
        let mut list: Vec<_> = left(5.0, "taylor 0,20,0 ").collect();
        list.extend(left(5.0, "taylor 0,8,0 local-level f32 "));
        list.extend(left(10.0, "taylor 0,20,0 "));
        let text = super::left_out(&[], &cases, &list);
        assert_eq!(
            text,
            "\nLeft out:\n  fast at 5 Hz: taylor 0,20,0; taylor 0,8,0 local-level f32 micromath: \
             too far\n  fast at 10 Hz: taylor 0,20,0: too far\n"
        );
        assert_eq!(super::left_out(&[], &cases, &[]), "");
    }
}
