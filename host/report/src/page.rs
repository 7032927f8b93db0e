//! A self-contained page, with style, palette and, where it has charts, what draws them.

use crate::canvas::Ink;
use crate::svg::escape;

const STYLE: &str = include_str!("script/page.css");
/// The library under the charts, with its style and its licence.
const LIBRARY: [&str; 3] = [
    include_str!("uplot/uPlot.iife.min.js"),
    include_str!("uplot/uPlot.min.css"),
    include_str!("uplot/LICENSE"),
];
const SCRIPTS: [&str; 7] = [
    include_str!("script/format.js"),
    include_str!("script/plot.js"),
    include_str!("script/layers.js"),
    include_str!("script/read.js"),
    include_str!("script/move.js"),
    include_str!("script/save.js"),
    include_str!("script/start.js"),
];

/// A whole page; title and body are HTML already.
pub fn page(title: &str, body: &str) -> String {
    page_with(title, body, "")
}

/// The same with a script of its own, which follows that of the charts.
pub fn page_with(title: &str, body: &str, script: &str) -> String {
    let has_charts = body.contains("<figure class=\"plot");
    let [library, style, licence] = if has_charts { LIBRARY } else { [""; 3] };
    let scripts = if has_charts { SCRIPTS.concat() } else { String::new() };
    let libraries = match has_charts {
        true => format!(
            "<!--\nThe charts are drawn with uPlot.\n\n{licence}\n-->\n<script>\n{library}</script>\n"
        ),
        false => String::new(),
    };
    let needed = match has_charts {
        true => "<noscript><p>The charts of this page are drawn by its script.</p></noscript>\n",
        false => "",
    };
    let script = match scripts.is_empty() && script.is_empty() {
        true => String::new(),
        false => format!("<script>\n{scripts}{script}</script>\n"),
    };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{style}\n{}{STYLE}</style>\n</head>\n\
         <body>\n<main>\n{needed}{body}</main>\n{libraries}{script}</body>\n</html>\n",
        colours()
    )
}

/// The palette for light and dark, and a class per ink. Paper is light.
fn colours() -> String {
    let palette = |sheet: &str, verdict: [&str; 2], colour: fn(Ink) -> [u8; 3]| -> String {
        let variable = |ink: Ink| {
            let [r, g, b] = colour(ink);
            format!(" --{}: #{r:02x}{g:02x}{b:02x};", ink.name())
        };
        let [good, bad] = verdict;
        let inks = Ink::ALL.map(variable).concat();
        format!("--sheet: {sheet}; --good: {good}; --bad: {bad};{inks}")
    };
    let class = |ink: Ink| format!(".i-{0} {{ color: var(--{0}); }}\n", ink.name());
    format!(
        ":root {{ color-scheme: light dark; {} }}\n\
         @media screen and (prefers-color-scheme: dark) {{ :root:not([data-print]) {{ {} }} }}\n{}",
        palette("#f5f6f8", ["#0b6b3a", "#b3261e"], Ink::light),
        palette("#121418", ["#63d197", "#ff8a80"], Ink::dark),
        Ink::ALL.map(class).concat()
    )
}

/// A table; its cells are plain text.
pub fn panel(heads: &[&str], rows: &[Vec<String>]) -> String {
    let heads: String = heads.iter().map(|head| format!("<th>{head}</th>")).collect();
    let head = if heads.is_empty() { heads } else { format!("<tr>{heads}</tr>\n") };
    let row = |row: &Vec<String>| {
        let cells = row.iter().map(|cell| format!("<td>{}</td>", escape(cell)));
        format!("<tr>{}</tr>\n", cells.collect::<String>())
    };
    let rows: String = rows.iter().map(row).collect();
    framed(&format!("<table>\n{head}{rows}</table>"))
}

/// What may be wider than the page, in a frame that scrolls, also by the keyboard.
pub fn framed(content: &str) -> String {
    format!(
        "<div class=\"panel\" role=\"group\" aria-label=\"table\" tabindex=\"0\">{content}</div>\n"
    )
}

/// A row of large figures, each over what it is.
pub fn cards(cards: &[(String, String)]) -> String {
    let card = |(value, what): &(String, String)| {
        format!("<div class=\"card\"><b>{}</b><span>{}</span></div>\n", escape(value), escape(what))
    };
    format!("<div class=\"cards\">\n{}</div>\n", cards.iter().map(card).collect::<String>())
}

/// A verdict above everything else.
pub fn verdict(is_good: bool, text: &str) -> String {
    let class = if is_good { "good" } else { "bad" };
    format!("<p class=\"verdict {class}\">{}</p>\n", escape(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_library_comes_with_its_licence_and_only_with_charts() {
        let plain = page("t", "<p>words</p>");
        assert!(!plain.contains("uPlot") && !plain.contains("<script>"));
        let charts = page("t", "<figure class=\"plot\"></figure>");
        assert!(charts.contains("uPlot") && charts.contains("MIT License"));
        assert!(LIBRARY.iter().map(|part| part.len()).sum::<usize>() < 150_000);
        for part in LIBRARY.iter().chain(&SCRIPTS) {
            assert!(!part.contains("</script") && !part.contains("-->"));
        }
    }
}
