//! Sentences that fit the terminal.
//!
//! A line that is too long goes on in the next one, at a blank, as far to the right as it began; that of a comment (`#`) as
//! a comment. Rows of tables, whose cells lie three blanks apart, stay as they are.

use console::Term;
use std::borrow::Cow;
use std::env;
use std::io::{self, IsTerminal};

/// What a terminal has that does not tell.
const COLUMNS: usize = 80;
/// Narrower terminals break the lines themselves.
const FEWEST: usize = 20;

/// The columns of the terminal that the output goes to. In a file or a pipe lines end where sentences do, unless the
/// environment has `COLUMNS`.
pub fn columns() -> Option<usize> {
    of(io::stdout().is_terminal().then(Term::stdout)).map(|columns| columns.max(FEWEST))
}

/// The same of what errors and warnings go to.
pub fn error_columns() -> Option<usize> {
    of(io::stderr().is_terminal().then(Term::stderr)).map(|columns| columns.max(FEWEST))
}

fn of(terminal: Option<Term>) -> Option<usize> {
    match terminal {
        Some(terminal) => {
            Some(terminal.size_checked().map_or(COLUMNS, |(_, columns)| columns.into()))
        }
        None => env::var("COLUMNS").ok().and_then(|columns| columns.parse().ok()),
    }
}

/// A text whose sentences fit so many columns.
///
/// ```
/// use schuler_simulator::output::wrap::wrapped;
/// assert_eq!(wrapped("  two words and more\n", 12), "  two words\n  and more\n");
/// assert_eq!(wrapped("a table   of one row\n", 12), "a table   of one row\n");
/// ```
pub fn wrapped(text: &str, columns: usize) -> Cow<'_, str> {
    if text.lines().all(|line| width(line) <= columns) {
        return Cow::Borrowed(text);
    }
    text.split_inclusive('\n').map(|line| folded(line, columns)).collect::<String>().into()
}

fn width(line: &str) -> usize {
    line.chars().count()
}

/// One line as several.
fn folded(line: &str, columns: usize) -> Cow<'_, str> {
    let words = line.trim_start();
    let is_row = words.trim_end().contains("   ");
    if width(line.trim_end_matches('\n')) <= columns || is_row {
        return Cow::Borrowed(line);
    }
    let (start, words) = match words.strip_prefix("# ") {
        Some(comment) => (format!("{}# ", blanks(line, words)), comment),
        None => (blanks(line, words).to_owned(), words),
    };
    let mut text = start.clone();
    let mut used = width(&start);
    for (place, word) in words.split(' ').enumerate() {
        let with_blank = usize::from(place > 0) + width(word.trim_end_matches('\n'));
        if place > 0 && used + with_blank > columns {
            text.push('\n');
            text += &start;
            used = width(&start);
        } else if place > 0 {
            text.push(' ');
            used += 1;
        }
        text += word;
        used += width(word);
    }
    text.into()
}

/// What stands before the words of a line.
fn blanks<'a>(line: &'a str, words: &str) -> &'a str {
    line.get(..line.len() - words.len()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_word_is_lost_and_no_line_is_too_long() {
        let text = "The sampling jitters, so theory's mean and σ are left out here.\n  it does not apply\n\nend";
        for columns in 20..70 {
            let told = wrapped(text, columns);
            assert!(told.lines().all(|line| width(line) <= columns), "{columns}: {told}");
            let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
            assert_eq!(words(&told), words(text));
            assert!(told.contains("\n\nend") && !told.contains(" \n"));
        }
        assert!(matches!(wrapped(text, 70), Cow::Borrowed(_)));
        assert_eq!(wrapped("# one two three\n", 9), "# one two\n# three\n");
        // What has no blank cannot be broken.
        assert_eq!(wrapped("to a/very/long/path\n", 8), "to\na/very/long/path\n");
    }
}
