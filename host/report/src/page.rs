//! A self-contained page, with style, palette and script.

use crate::canvas::Ink;
use crate::svg::escape;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// A whole page; title and body are HTML already.
pub fn page(title: &str, body: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{}{STYLE}</style>\n</head>\n\
         <body>\n<main>\n{body}</main>\n\
         <script>\n{SCRIPT}</script>\n</body>\n</html>\n",
        colours()
    )
}

/// The palette for light and dark, and a class per ink.
fn colours() -> String {
    let palette = |sheet: &str, colour: fn(Ink) -> [u8; 3]| -> String {
        let variable = |ink: Ink| {
            let [r, g, b] = colour(ink);
            format!(" --{}: #{r:02x}{g:02x}{b:02x};", ink.name())
        };
        format!(":root {{ --sheet: {sheet};{} }}", Ink::ALL.map(variable).concat())
    };
    let class = |ink: Ink| format!(".i-{0} {{ color: var(--{0}); }}\n", ink.name());
    format!(
        ":root {{ color-scheme: light dark; }}\n{}\n@media (prefers-color-scheme: dark) {{ {} }}\n{}",
        palette("#f5f6f8", Ink::light),
        palette("#121418", Ink::dark),
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
    format!("<div class=\"panel\"><table>\n{head}{rows}</table></div>\n")
}
