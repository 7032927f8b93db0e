//! The `schuler` command. Exit codes: 0 done, 1 a check failed, 2 bad usage or input.

use clap::Parser;
use schuler_host::cli::{Cli, Command};
use schuler_host::{
    align, allan, audit, datasheet, emulate, ensemble, frontier, hil, replay, run, scenes, stress,
    trajectory,
};
use schuler_simulator::output::{say_error, stop, wrap};
use schuler_simulator::simulate::FlightError;
use std::process::ExitCode;

fn main() -> ExitCode {
    stop::watch();
    let cli = Cli::try_parse().unwrap_or_else(|error| refuse(&error));
    let done = match cli.command() {
        Command::Run(args) => run::run(&args),
        Command::Emulate(args) => emulate::emulate(&args),
        Command::Replay(args) => replay::replay(&args),
        Command::Align(args) => align::align(&args),
        Command::Frontier(args) => frontier::frontier(&args),
        Command::Stress(args) => stress::stress(&args),
        Command::Ensemble(args) => ensemble::ensemble(&args),
        Command::Allan(args) => allan::allan(&args),
        Command::Datasheet(args) => datasheet::datasheet(&args).map_err(FlightError::from),
        Command::Audit(command) => audit::audit(&command),
        Command::Hil(args) => hil::hil(&args),
        Command::Twin => hil::serve::serve().map_err(FlightError::from),
        Command::Scenes(args) => scenes::scenes(&args).map_err(FlightError::from),
        Command::Trajectory(args) => trajectory::trajectory(&args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            say_error(&format!("schuler: {error}"));
            match error {
                FlightError::Input(_) => ExitCode::from(2),
                FlightError::Lost { .. }
                | FlightError::Rejected { .. }
                | FlightError::Turned { .. }
                | FlightError::Failed { .. }
                | FlightError::Runs { .. }
                | FlightError::Stopped(_) => ExitCode::from(1),
            }
        }
    }
}

/// Says what is wrong with the command line, or helps, and ends the program. What is too wide is plain, as colours have
/// no width.
fn refuse(error: &clap::Error) -> ! {
    let text = error.to_string();
    let text = text.trim_end();
    match wrap::error_columns().filter(|_| error.use_stderr()) {
        Some(columns) if text.lines().any(|line| line.chars().count() > columns) => {
            say_error(text);
            std::process::exit(error.exit_code())
        }
        _ => error.exit(),
    }
}
