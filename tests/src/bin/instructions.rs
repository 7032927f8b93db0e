//! Compares Gungraun's summaries on standard input with the stored instruction counts, or stores them.
//! `tests/instructions.sh` calls it.

use schuler_speed::work::SAMPLES;
use schuler_tests::baseline::Baseline;
use std::io::Read;
use std::process::{Command, ExitCode};

const HEAD: &str =
    "Instructions per sample on the paper's flight, block ends only unless it says rows, as Callgrind counts them
(Gungraun, tests/speed/benches/instructions.rs). CI compares within 2 %.
To store what is measured now: tests/instructions.sh --store";

/// What others are compared with.
const UNIT: &str = "textbook_local_level_f64";

fn main() -> ExitCode {
    match run() {
        Ok(code) => code,
        Err(what) => {
            eprintln!("instructions: {what}");
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<ExitCode, String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (path, store) = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [path] => (path.to_owned(), false),
        ["--store", path] => (path.to_owned(), true),
        _ => return Err("usage: instructions [--store] FILE < summaries".to_owned()),
    };
    let mut summaries = String::new();
    std::io::stdin().read_to_string(&mut summaries).map_err(|error| error.to_string())?;
    let version = rustc("--version")?;
    let verbose = rustc("-vV")?;
    let target = verbose.lines().find_map(|line| line.strip_prefix("host: ")).unwrap_or("unknown");
    let measured = Baseline::measured(&summaries, SAMPLES, version.trim(), target)?;
    if measured.instructions_per_sample.is_empty() {
        return Err("no summary on standard input".to_owned());
    }
    if store {
        std::fs::write(&path, measured.text(HEAD)).map_err(|error| format!("{path}: {error}"))?;
        println!("stored {} counts in {path}", measured.instructions_per_sample.len());
        return Ok(ExitCode::SUCCESS);
    }
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{path}: {error}"))?;
    let stored = Baseline::parse(&text).map_err(|error| format!("{path}: {error}"))?;
    if stored.target != measured.target {
        println!("skipped: {path} was counted on {}, this is {target}", stored.target);
        return Ok(ExitCode::SUCCESS);
    }
    let (band, faults) = stored.compare(&measured);
    if stored.rustc != measured.rustc {
        let percent = 100.0 * band;
        println!(
            "{path} belongs to another compiler, {}; this is {}: compared within {percent} %",
            stored.rustc, measured.rustc
        );
    }
    // Beside each count its ratio to the unit of the README's table.
    let unit = measured.instructions_per_sample.get(UNIT).copied().unwrap_or(f64::NAN);
    for (name, count) in &measured.instructions_per_sample {
        println!("{name:38} {count:8.1} {:6.2}", count / unit);
    }
    if faults.is_empty() {
        return Ok(ExitCode::SUCCESS);
    }
    eprintln!("instructions per sample off the baseline by more than {} %:", 100.0 * band);
    faults.iter().for_each(|fault| eprintln!("  {fault}"));
    eprintln!("if that is meant: tests/instructions.sh --store");
    Ok(ExitCode::FAILURE)
}

fn rustc(argument: &str) -> Result<String, String> {
    let compiler = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let output = Command::new(&compiler).arg(argument).output();
    let output = output.map_err(|error| format!("{compiler}: {error}"))?;
    String::from_utf8(output.stdout).map_err(|error| format!("{compiler}: {error}"))
}
