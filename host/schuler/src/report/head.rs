//! What every summary says of its origin: by it a result can be made again, and read by a program of another
//! version.

use schuler_simulator::scene::{Navigator, WindowShape};
use serde::Serialize;
use std::path::Path;

/// Of the form of a summary: it grows where a key gets another meaning or goes.
pub const SCHEMA_VERSION: u32 = 1;

/// The start of a summary.
#[derive(Clone, Debug, Serialize)]
pub struct Head<'a> {
    schema_version: u32,
    /// What was done: `run`, `hil`, `replay` or `ensemble`.
    kind: &'a str,
    /// The program's.
    version: &'static str,
    /// The command line, an argument each.
    command: Vec<String>,
    /// The files that belong together, this one included.
    files: &'a [&'a str],
}

impl<'a> Head<'a> {
    /// Of what was done, and the files that were written of it.
    pub fn new(kind: &'a str, files: &'a [&'a str]) -> Self {
        Self::of_command(kind, files, &command()[1..])
    }

    /// The same of another command than the program's own: an argument each, after the program's name.
    pub fn of_command(kind: &'a str, files: &'a [&'a str], arguments: &[String]) -> Self {
        let command = std::iter::once("schuler".to_owned()).chain(arguments.iter().cloned());
        let version = env!("CARGO_PKG_VERSION");
        Self { schema_version: SCHEMA_VERSION, kind, version, command: command.collect(), files }
    }
}

/// How a summary's flight was navigated.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Navigated {
    precision: &'static str,
    frame: &'static str,
    algorithm: &'static str,
    #[serde(with = "schuler_simulator::scene::window")]
    window: Option<WindowShape>,
    vertical: &'static str,
}

impl Navigated {
    /// By a navigator, with its window if it has one.
    pub fn new(navigator: &Navigator, window: Option<WindowShape>) -> Self {
        Self {
            precision: navigator.precision.name(),
            frame: navigator.frame.name(),
            algorithm: navigator.algorithm.name(),
            window,
            vertical: navigator.vertical.name(),
        }
    }
}

/// The command line, an argument each.
pub fn command() -> Vec<String> {
    let arguments = std::env::args_os().skip(1);
    let arguments = arguments.map(|argument| argument.to_string_lossy().into_owned());
    std::iter::once("schuler".to_owned()).chain(arguments).collect()
}

/// The command line, as it may be given again to a POSIX shell.
pub fn command_line() -> String {
    shell(&command())
}

/// The same of any arguments.
pub fn shell(arguments: &[String]) -> String {
    arguments.iter().map(|argument| quoted(argument)).collect::<Vec<_>>().join(" ")
}

fn quoted(argument: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./,:=@%+".contains(c);
    match !argument.is_empty() && argument.chars().all(is_plain) {
        true => argument.to_owned(),
        false => format!("'{}'", argument.replace('\'', "'\\''")),
    }
}

/// The program, libm and the machine, for people.
pub fn versions() -> String {
    format!(
        "schuler {}, libm {}, {} {}",
        env!("CARGO_PKG_VERSION"),
        env!("SCHULER_LIBM_VERSION"),
        std::env::consts::ARCH,
        std::env::consts::OS
    )
}

/// The files that a summary in a folder says belong to it; none where there is no summary.
pub fn files_of(summary: &Path) -> Vec<String> {
    texts(&tree(summary)["files"])
}

/// The command line of a summary in a folder, an argument each; none where there is no summary.
pub fn command_of(summary: &Path) -> Option<Vec<String>> {
    let command = texts(&tree(summary)["command"]);
    (!command.is_empty()).then_some(command)
}

fn tree(summary: &Path) -> serde_json::Value {
    let text = std::fs::read_to_string(summary).unwrap_or_default();
    serde_json::from_str(&text).unwrap_or_default()
}

fn texts(list: &serde_json::Value) -> Vec<String> {
    let texts = list.as_array().into_iter().flatten();
    texts.filter_map(|text| text.as_str().map(str::to_owned)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_line_can_be_given_again() {
        let arguments = ["schuler", "run", "a b.toml", "it's", "", "--every=10s"];
        let told = shell(&arguments.map(str::to_owned));
        assert_eq!(told, "schuler run 'a b.toml' 'it'\\''s' '' --every=10s");
    }
}
