//! `stress.html`: every check with its margin, what fails first.

use super::Row;
use super::case::{Bound, Check, number};
use crate::report::head;
use schuler_report::page::{self, framed};
use schuler_report::svg::escape;

/// The file's name.
pub const NAME: &str = "stress.html";

/// A margin of so many powers of ten fills its bar.
const DECADES: f64 = 4.0;

/// How many times farther from its bound a number might be; none where the bound is zero, or nothing was measured.
pub fn margin(check: &Check) -> Option<f64> {
    let margin = match check.bound {
        Bound::AtMost(bound) if bound > 0.0 => bound / check.measured,
        Bound::AtLeast(bound) if bound > 0.0 => check.measured / bound,
        _ => return None,
    };
    (margin >= 0.0).then_some(margin)
}

/// A margin in a few characters.
pub fn told(margin: Option<f64>) -> String {
    match margin {
        None => "–".to_owned(),
        Some(margin) if margin >= 1e4 => "> 9999 ×".to_owned(),
        Some(margin) => format!("{} ×", number(margin)),
    }
}

/// The page: what fails, then what passes, from the least margin to the largest.
pub fn page(rows: &[Row]) -> String {
    let failed = rows.iter().filter(|row| !row.passes()).count();
    let verdict = match failed {
        0 => format!("{} checks, all pass", rows.len()),
        _ => format!("{failed} of {} checks fail", rows.len()),
    };
    let of = |row: &&Row| row.check.as_ref().ok().and_then(margin).unwrap_or(f64::INFINITY);
    let mut sorted: Vec<&Row> = rows.iter().collect();
    sorted.sort_by(|a, b| a.passes().cmp(&b.passes()).then(of(a).total_cmp(&of(b))));
    let body: String = sorted.into_iter().map(line).collect();
    let heads =
        ["group", "case", "bound", "measured", "verdict", "margin", "where the bound comes from"];
    let heads = heads.map(|head| format!("<th>{head}</th>")).concat();
    let body = format!(
        "<h1>Numerical stability</h1>\n<p class=\"quiet\">{} · <code>{}</code></p>\n{}\
         <p class=\"quiet\">A margin is how many times closer to its bound a number might come: 1 × is at it, and a full bar is \
         ten thousand times.</p>\n{}",
        escape(&head::versions()),
        escape(&head::command_line()),
        page::verdict(failed == 0, &verdict),
        framed(&format!("<table>\n<tr>{heads}</tr>\n{body}</table>"))
    );
    page::page("Numerical stability", &body)
}

fn line(row: &Row) -> String {
    let (class, verdict) = if row.passes() { ("good", "pass") } else { ("bad", "✗ fail") };
    let cells = match &row.check {
        Ok(check) => {
            let Check { bound, measured, unit, why, .. } = check;
            let margin = margin(check);
            let part = margin.map_or(0.0, |m| (m.log10() / DECADES).clamp(0.0, 1.0));
            let bar =
                format!("<span class=\"bar {class}\" style=\"--part:{part:.3}\"><i></i></span>");
            format!(
                "<td>{bound} {unit}</td><td>{} {unit}</td><td class=\"{class}\">{verdict}</td><td>{bar}{}</td><td>{}</td>",
                number(*measured),
                told(margin),
                escape(why)
            )
        }
        Err(why) => format!(
            "<td></td><td></td><td class=\"{class}\">{verdict}</td><td></td><td>{}</td>",
            escape(why)
        ),
    };
    let class = if row.passes() { "" } else { " class=\"bad\"" };
    format!("<tr{class}><td>{}</td><td>{}</td>{cells}</tr>\n", row.group, escape(&row.name()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(case: &str, check: Check) -> Row {
        Row { group: "time", case: case.to_owned(), check: Ok(check) }
    }

    #[test]
    fn margins_are_told_and_the_worst_comes_first() {
        let checks = [
            Check::at_most("a", 10.0, 2.0, "m", "why"),
            Check::at_least("b", 3.0, 4.5, "m", "why"),
            Check::at_most("c", 1.0, 4.0, "m", "why"),
            Check::never("d", 0, "why"),
            Check::at_most("e", 1.0, f64::NAN, "m", "why"),
        ];
        let margins = checks.clone().map(|check| told(margin(&check)));
        assert_eq!(margins, ["5 ×", "1.50 ×", "0.25 ×", "–", "–"]);
        let mut rows: Vec<Row> = checks.into_iter().map(|check| row("x", check)).collect();
        let why = "it <broke> off".to_owned();
        rows.push(Row { group: "time", case: "y".to_owned(), check: Err(why) });
        let page = page(&rows);
        let at = |text: &str| page.find(text).unwrap_or_else(|| panic!("{text}: {page}"));
        assert!(page.contains("3 of 6 checks fail"));
        assert!(at("x, c") < at("x, b") && at("x, b") < at("x, a") && at("x, a") < at("x, d"));
        assert!(at("it &lt;broke&gt; off") < at("x, b") && at("x, e") < at("x, b"));
    }
}
