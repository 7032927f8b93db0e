//! `include/schuler.h` and the table of sizes are what the sources make them. With SCHULER_WRITE=1 they are written.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

fn crate_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}

/// The source with every macro expanded, which cbindgen cannot do by itself.
fn expanded() -> String {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let expanded = Command::new(cargo)
        .args(["rustc", "--locked", "--quiet", "--package", "schuler-c", "--lib"])
        .args(["--profile", "dev", "--", "-Zunpretty=expanded"])
        .env("RUSTC_BOOTSTRAP", "1")
        .env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).join("expanded"))
        .current_dir(crate_folder())
        .output()
        .unwrap();
    assert!(expanded.status.success(), "{}", String::from_utf8_lossy(&expanded.stderr));
    String::from_utf8(expanded.stdout).unwrap()
}

/// Columns of a line of the header.
const WIDTH: usize = 110;

/// A comment, wrapped, without what `# Safety` asks of each function: the header says that once for all.
fn comment(indent: &str, lines: &[&str]) -> String {
    let lines = lines.iter().map(|line| line.trim().trim_start_matches('*').trim());
    let text = lines.take_while(|line| *line != "# Safety").collect::<Vec<_>>().join(" ");
    let mut wrapped = vec![format!("{indent}/**")];
    for word in text.split_whitespace() {
        let last = wrapped.last_mut().unwrap();
        if last.len() + 1 + word.len() + " */".len() > WIDTH {
            wrapped.push(format!("{indent} * {word}"));
        } else {
            last.push(' ');
            last.push_str(word);
        }
    }
    wrapped.join("\n") + " */\n"
}

/// The header with its comments in order.
fn tidy(text: &str) -> String {
    let mut tidied = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if line.trim() == "/**" {
            let indent = line.trim_end_matches("/**");
            let inside: Vec<_> = lines.by_ref().take_while(|line| line.trim() != "*/").collect();
            tidied += &comment(indent, &inside);
        } else {
            tidied += line;
            tidied.push('\n');
        }
    }
    tidied
}

/// The header.
fn header() -> String {
    let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join("expanded.rs");
    std::fs::write(&source, expanded()).unwrap();
    let config = cbindgen::Config::from_file(crate_folder().join("cbindgen.toml")).unwrap();
    let bindings =
        cbindgen::Builder::new().with_config(config).with_src(&source).generate().unwrap();
    let mut text = Vec::new();
    bindings.write(&mut text);
    tidy(&String::from_utf8(text).unwrap())
}

/// The table of sizes.
fn sizes() -> String {
    let (mut words, mut saved) = (String::new(), String::new());
    schuler_c::navigator_sizes(&mut |name, _, size, stored| {
        let _ = writeln!(words, "    ({name}) => {{ {} }};", size.div_ceil(8));
        let _ = writeln!(saved, "    ({name}) => {{ {stored} }};");
    });
    format!(
        "//! The size of each state in words of eight bytes, and of its stored form in bytes: those of a processor of \
         64 bits,\n//! the largest. `tests/header.rs` writes this file, with SCHULER_WRITE=1 in its environment.\n\n\
         #[rustfmt::skip]\nmacro_rules! words {{\n{words}}}\npub(crate) use words;\n\n\
         #[rustfmt::skip]\nmacro_rules! saved {{\n{saved}}}\npub(crate) use saved;\n"
    )
}

/// Holds a file against what it should be, or writes it.
fn hold(file: &str, text: &str) {
    let path = crate_folder().join(file);
    if std::env::var_os("SCHULER_WRITE").is_some() {
        std::fs::write(&path, text).unwrap();
    }
    let stored = std::fs::read_to_string(&path).unwrap();
    let differs = stored.lines().zip(text.lines()).position(|(a, b)| a != b);
    assert!(stored == text, "{file} differs from line {differs:?} on: SCHULER_WRITE=1 writes it");
}

#[test]
fn sizes_are_those_of_the_states() {
    hold("src/sizes.rs", &sizes());
}

#[test]
fn the_header_is_that_of_the_sources() {
    hold("include/schuler.h", &header());
}

#[test]
fn what_goes_beside_a_navigator_is_as_large_as_it_has_to_be() {
    let mut wrong = Vec::new();
    schuler_c::sizes_beside(&mut |name, has, needs| {
        let words = needs.div_ceil(8);
        wrong.extend((has != 8 * words).then(|| format!("{name} takes {words} words")));
    });
    assert_eq!(wrong, Vec::<String>::new());
}

/// The C++ header, with a line for each navigator.
fn wrapper() -> String {
    let path = crate_folder().join("include/schuler.hpp");
    let text = std::fs::read_to_string(path).unwrap();
    let (before, rest) = text.split_once("// <navigators>\n").unwrap();
    let (_, after) = rest.split_once("// </navigators>\n").unwrap();
    let mut lines = String::new();
    schuler_c::navigator_sizes(&mut |name, _, _, _| {
        let number = if name.starts_with("f64") { "f64" } else { "f32" };
        let any = name.ends_with("_any") || name.ends_with("_textbook");
        let any = if any { "_ANY" } else { "" };
        let upper = name.to_uppercase();
        let _ = writeln!(lines, "SCHULER_NAVIGATOR{any}({name}, {number}, {upper})");
    });
    format!("{before}// <navigators>\n{lines}// </navigators>\n{after}")
}

#[test]
fn the_wrapper_has_every_navigator() {
    hold("include/schuler.hpp", &wrapper());
}

#[test]
fn no_two_states_have_one_mark() {
    let mut kinds = Vec::new();
    schuler_c::navigator_sizes(&mut |_, kind, _, _| kinds.push(kind));
    let count = kinds.len();
    kinds.sort_unstable();
    kinds.dedup();
    assert_eq!((kinds.len(), count), (28, 28));
}
