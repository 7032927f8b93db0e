//! The table in the terminal: 80 columns, a name that is longer than its column over several lines.

use super::Row;
use super::case::{Check, number};
use super::page::{margin, told};

/// Width of the column of names.
const NAME: usize = 36;

/// The heads of the columns.
pub fn head() -> String {
    let [bound, measured, margin] = ["bound", "measured", "margin"];
    format!("     {:NAME$} {bound:>10} {measured:>9} {:7} {margin:>8}\n", "case", "")
}

/// A row as it is printed; where a check fails, with the reason of its bound.
pub fn line(row: &Row) -> String {
    let verdict = if row.passes() { "pass" } else { "FAIL" };
    let names = wrapped(&row.name(), NAME);
    let (first, rest) =
        names.split_first().map_or((String::new(), &[][..]), |(f, r)| (f.clone(), r));
    let rest: String = rest.iter().map(|part| format!("       {part}\n")).collect();
    match &row.check {
        Ok(check) => {
            let Check { bound, measured, unit, why, .. } = check;
            let (bound, measured) = (bound.to_string(), number(*measured));
            let margin = told(margin(check));
            let why = wrapped(&format!("bound: {why}"), 70);
            let why = why.iter().map(|part| format!("         {part}\n"));
            let why = if row.passes() { String::new() } else { why.collect() };
            format!(
                "{verdict} {first:NAME$} {bound:>10} {measured:>9} {unit:7} {margin:>8}\n{rest}{why}"
            )
        }
        Err(why) => {
            let why = wrapped(why, 70)
                .iter()
                .map(|part| format!("         {part}\n"))
                .collect::<String>();
            format!("{verdict} {first}\n{rest}{why}")
        }
    }
}

/// A text in lines of at most so many characters, broken at spaces; a word that is longer stays whole.
fn wrapped(text: &str, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_names_stay_within_80_columns() {
        let name = "coning 1° at 10 Hz with 2.2 samples per cycle, flown for a day at 60° N, in single precision";
        let check = Check::at_least(
            "velocity",
            1.234e-10,
            f64::NAN,
            "arcsec",
            "the cubic \
            interpolation of three samples leaves so much of a cone, and the rest is rounding",
        );
        for check in [
            Ok(check),
            Err("it broke off, and told at some length why it did not go on".to_owned()),
        ] {
            let line = line(&Row { group: "motion", case: name.to_owned(), check });
            assert!(line.lines().all(|line| line.chars().count() <= 80), "{line}");
            assert!(line.lines().count() >= 4 && line.starts_with("FAIL coning"), "{line}");
        }
        assert!(head().trim_end().chars().count() <= 80);
        assert_eq!(wrapped("ab cd ef", 5), ["ab cd", "ef"]);
        assert_eq!(wrapped("abcdefgh i", 5), ["abcdefgh", "i"]);
    }
}
