//! The command line.

use clap::Parser;
use std::path::PathBuf;

/// Builds and runs the audit program on every target of this machine: the same bits?
#[derive(Clone, Debug, Default, Parser, PartialEq)]
#[command(
    name = "matrix",
    after_help = "Example:\n  tests/matrix.sh --target thumbv7em-none-eabihf --target wasm32-unknown-unknown"
)]
pub struct MatrixArgs {
    /// The project's folder [default: the nearest one above that holds tests/audit]
    #[arg(long, value_name = "DIR")]
    pub source: Option<PathBuf>,
    /// Golden chains to compare with [default: tests/golden of the project]
    #[arg(long, value_name = "DIR")]
    pub golden: Option<PathBuf>,
    /// Only these targets, beside the first; may be repeated [default: all]
    #[arg(long, value_name = "NAME")]
    pub target: Vec<String>,
    /// Not optimised, every target but the first
    #[arg(long)]
    pub debug: bool,
    /// Folder for audit.json and audit.html
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Fail where a tool is missing, instead of skipping its targets
    #[arg(long)]
    pub require_all: bool,
}
