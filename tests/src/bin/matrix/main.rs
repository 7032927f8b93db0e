//! The audit program on every target of this machine, all to the same bits. `tests/matrix.sh` calls it.
//!
//! | file | what |
//! |---|---|
//! | `arguments` | the command line |
//! | `target` | the rows: what is built how, and what runs it |
//! | `tools` | what this machine has |
//! | `build` | building and running one target |
//! | `fly` | every target |
//! | `output` | the digests that are printed |
//! | `golden` | the digests that are stored |
//! | `verdict` | what a row came to |
//! | `judge` | the rows compared |
//! | `show` | the table |
//!
//! Exit codes: 0 all the same bits, 1 some differ or are missing, 2 bad usage.

mod arguments;
mod build;
mod fly;
mod golden;
mod judge;
mod output;
mod show;
mod target;
mod tools;
mod verdict;

use arguments::MatrixArgs;
use clap::Parser;
use schuler_host::audit::page::{self, Table, Top};
use schuler_simulator::input::InputError;
use schuler_simulator::output::say;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run(&MatrixArgs::parse()) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(failed) => {
            eprintln!("matrix: {failed} failed");
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("matrix: {error}");
            ExitCode::from(2)
        }
    }
}

/// How many rows fail.
fn run(args: &MatrixArgs) -> Result<usize, InputError> {
    // Nobody listening any more shows when the table is printed.
    let matrix = fly::matrix(args, &|row| drop(say(&show::ended(row))))?;
    let tables = show::tables(&matrix);
    say(&tables.iter().map(Table::text).collect::<String>())?;
    if let Some(folder) = &args.out {
        let top = Top { title: "The same bits on every target".to_owned(), ..Top::default() };
        page::write(folder, &top, &tables, &matrix)?;
    }
    Ok(matrix.failed(args.require_all))
}
