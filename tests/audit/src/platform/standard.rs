//! An operating system with Rust's standard library.

use crate::chain_file;
use std::io::Write;
use std::process::ExitCode;

const REFUSED: &str = "the core refuses a scene, a start or a sample";

/// Prints a line.
pub fn print(line: &[u8]) {
    if std::io::stdout().write_all(line).is_err() {
        // Nobody reads: there is nothing left to do.
        std::process::exit(2);
    }
}

/// Without an argument prints every digest, with the name of a flight its chain.
pub fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let done = match arguments.as_slice() {
        [] => crate::digests().map_err(|_| REFUSED.to_owned()),
        [flight] => match chain_file::of(flight) {
            Some(Ok(text)) => {
                print(text.as_bytes());
                Ok(())
            }
            Some(Err(_)) => Err(REFUSED.to_owned()),
            None => Err(format!(
                "no flight {flight}; accepted: paper/ or turns/ and trajectory, increments, noise \
                 or a configuration such as f32-local-level-taylor-0-4-0"
            )),
        },
        _ => Err("usage: audit [SCENE/FLIGHT]".to_owned()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(what) => {
            eprintln!("audit: {what}");
            ExitCode::from(2)
        }
    }
}
