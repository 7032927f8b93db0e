//! The `schuler` command. Exit codes: 0 done, 1 a check failed, 2 bad usage or input.

use clap::Parser;
use schuler_host::cli::{Cli, Command};
use schuler_host::{
    align, allan, audit, datasheet, emulate, ensemble, frontier, hil, replay, run, scenes, stress,
    trajectory,
};
use schuler_simulator::output::stop;
use schuler_simulator::simulate::FlightError;
use std::process::ExitCode;

fn main() -> ExitCode {
    stop::watch();
    let done = match Cli::parse().command() {
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
            eprintln!("schuler: {error}");
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
