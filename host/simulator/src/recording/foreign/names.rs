//! Columns whose names speak for themselves, such as gyro_x, accZ or "Angular velocity y (rad/s)".

use super::head::Head;
use super::map::{Column, Map};
use crate::rest::units::{Units, kind_of};

/// What a column is by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum What {
    Time,
    Gyro(usize),
    Accelerometer(usize),
}

/// Beginnings of words that name gyros, and accelerometers.
const GYROS: [&str; 5] = ["gyr", "omega", "angular", "angvel", "rotation"];
const ACCELEROMETERS: [&str; 2] = ["acc", "specific"];
/// Words of columns that are neither.
const OTHERS: [&str; 8] = ["bias", "cov", "std", "sigma", "mag", "user", "temp", "ref"];
/// Names of one letter and an axis.
const SHORT: [(&str, bool); 4] = [("w", true), ("g", true), ("a", false), ("f", false)];
const AXES: [&str; 3] = ["x", "y", "z"];

/// A map of the columns that a header names, and what to say of it; none unless each axis is named just once.
pub fn columns(head: &Head) -> Option<(Map, String)> {
    head.headers.iter().rev().find_map(|(_, fields)| {
        let named: Vec<_> = fields.iter().map(|field| what(field)).collect();
        let all = |wanted: What| {
            (0..fields.len()).filter(|&i| named[i] == Some(wanted)).collect::<Vec<_>>()
        };
        let one = |wanted: What| {
            let found = all(wanted);
            found.first().copied().filter(|_| found.len() == 1)
        };
        let three = |of: fn(usize) -> What| Some([one(of(0))?, one(of(1))?, one(of(2))?]);
        let (gyro, accelerometer) = (three(What::Gyro)?, three(What::Accelerometer)?);
        // The first of several times.
        let time = *all(What::Time).first()?;
        let mut map = Map::default();
        let numbers = |places: [usize; 3]| places.map(|at| Column::Number(at + 1)).to_vec();
        map.time.columns = vec![Column::Number(time + 1)];
        map.gyro.columns = numbers(gyro);
        map.accelerometer.columns = numbers(accelerometer);
        let unit = |places: [usize; 3]| {
            let [a, b, c] = places.map(|at| unit(&fields[at]));
            a.filter(|_| a == b && b == c)
        };
        let rate = unit(gyro).filter(|(units, _)| units.rate.is_some());
        let force = unit(accelerometer).filter(|(units, _)| units.force.is_some());
        let stamp = unit([time; 3]).filter(|(units, _)| units.time.is_some());
        let units = [rate, force, stamp].into_iter().flatten().map(|(units, _)| units);
        map.units = units.fold(Units::default(), Units::or);
        // Per second or not: both sensors must agree, else nothing is said.
        let kinds: Vec<_> = [rate, force].into_iter().flatten().map(|(_, kind)| kind).collect();
        map.units.kind = kinds.first().copied().filter(|first| kinds.iter().all(|k| k == first));
        let names = |places: [usize; 3]| places.map(|at| fields[at].as_str()).join(", ");
        let said = format!(
            "{}: by the names {} is the time, {} are accelerometers, {} gyros",
            head.name,
            fields[time],
            names(accelerometer),
            names(gyro)
        );
        Some((map, said))
    })
}

/// The words of a name, without what stands in brackets: at capitals, and at all that is no letter or digit.
fn words(name: &str) -> Vec<String> {
    let plain = name.split(['(', '[']).next().unwrap_or_default();
    let mut words = vec![String::new()];
    let mut before = ' ';
    for c in plain.chars() {
        let begins = c.is_uppercase() && (before.is_lowercase() || before.is_ascii_digit());
        if begins || !c.is_alphanumeric() {
            words.push(String::new());
        }
        if let Some(word) = words.last_mut().filter(|_| c.is_alphanumeric()) {
            word.extend(c.to_lowercase());
        }
        before = c;
    }
    words.retain(|word| !word.is_empty());
    words
}

fn what(name: &str) -> Option<What> {
    let words = words(name);
    let begins = |list: &[&str]| words.iter().any(|word| list.iter().any(|l| word.starts_with(l)));
    if begins(&OTHERS) {
        return None;
    }
    let axis = |word: &str| AXES.iter().position(|axis| word == *axis);
    if let [short] = words.as_slice()
        && let Some((letter, i)) = short.split_at_checked(1)
        && let Some(i) = axis(i)
    {
        let found = SHORT.iter().find(|(of, _)| *of == letter);
        return found.map(|(_, gyro)| if *gyro { What::Gyro(i) } else { What::Accelerometer(i) });
    }
    let mut axes = words.iter().filter_map(|word| axis(word));
    let axis = axes.next().filter(|_| axes.next().is_none());
    let single = |letter: &str| words.iter().any(|word| word == letter);
    let gyro = begins(&GYROS) || single("w");
    let accelerometer = begins(&ACCELEROMETERS) || (single("a") || single("f"));
    match (axis, gyro, accelerometer) {
        (Some(i), true, false) => Some(What::Gyro(i)),
        (Some(i), false, true) => Some(What::Accelerometer(i)),
        (None, false, false) if begins(&["time", "stamp"]) || name.trim() == "t" => {
            Some(What::Time)
        }
        _ => None,
    }
}

/// The unit that a name has in brackets or at its end, and the kind of samples that it is one of.
fn unit(name: &str) -> Option<(Units, super::super::Kind)> {
    let words = words(name);
    let bracketed = name.split(['(', '[']).nth(1).map(|text| text.trim_end_matches([')', ']']));
    let behind = words.iter().position(|word| AXES.contains(&word.as_str()));
    let behind = behind.map(|at| words[at + 1..].join("/"));
    let last = || words.last().cloned().filter(|_| words.len() > 1);
    let text =
        bracketed.map(str::to_owned).or(behind.filter(|text| !text.is_empty())).or_else(last)?;
    let text =
        text.trim().to_lowercase().replace("sec", "s").replace(" s^-", "/s").replace("/s1", "/s");
    let units = Units::parse(&text).ok()?;
    Some((units, kind_of(&text)))
}
