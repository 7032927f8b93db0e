//! Options of `hil`.

use super::{Every, FlightOptions, Handling, NavigatorOptions, load, options};
use crate::hil::Manner;
use crate::hil::device::Device;
use crate::hil::faults::Rates;
use crate::report::Wanted;
use clap::Args;
use schuler_simulator::input::{Complaint, InputError, Range};
use schuler_simulator::scene::Scene;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Where `tests/firmware` leaves the navigator for QEMU.
const IMAGE: &str = "tests/firmware/target/thumbv7em-none-eabihf/release/navigator";

/// Options of `hil`.
#[derive(Args, Clone, Debug, PartialEq)]
#[command(after_help = "Examples:\n  \
    schuler hil paper --duration 60 --precision f32\n  \
    schuler hil hard --faults all=0.01 --fault-seed 7\n  \
    schuler hil aided-drive --faults all=0.01\n  \
    schuler hil paper --allan --duration 3600\n  \
    schuler hil paper --device serial:/dev/ttyACM0 --stream")]
pub struct HilArgs {
    /// A built-in scene (`schuler scenes` lists them) or the path of a TOML file [default: paper]
    #[arg(value_parser = options::name())]
    pub scene: Option<String>,
    /// What flies beside the host: twin, qemu, serial:PORT, serial:PORT@BAUD or tcp:HOST:PORT
    #[arg(long, value_name = "DEVICE", default_value = "twin", value_parser = Device::parse)]
    pub device: Device,
    /// The image that `--device qemu` runs [default: what tests/firmware builds]
    #[arg(long, value_name = "FILE")]
    pub image: Option<PathBuf>,
    /// Let the target identify the scene's sensors in place of flying: it gets their errors sample by sample, its Allan
    /// sums are read back, and what `allan` says of them is printed
    #[arg(long, conflicts_with_all = ["stream", "rows", "every", "no_report", "out"])]
    pub allan: bool,
    /// Send each sample at its own time, and measure how long its answer takes
    #[arg(long)]
    pub stream: bool,
    /// Faults to put in on the way: NAME=RATE,… of drop, duplicate, reorder, delay, truncate, flip, stall,
    /// reboot; or all=RATE, shared by all of them
    #[arg(long, value_name = "FAULTS", value_parser = Rates::parse)]
    pub faults: Option<Rates>,
    /// Seed of the faults
    #[arg(long, value_name = "N", default_value = "1", requires = "faults", allow_negative_numbers = true, value_parser = seed)]
    pub fault_seed: u64,
    /// How often a sample that is not answered is sent again before it is given up
    #[arg(long, value_name = "N", default_value = "5", allow_negative_numbers = true, value_parser = retries)]
    pub retries: u32,
    /// How long each answer is waited for, seconds [default: 5 at first, then as long as answers take]
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = timeout)]
    pub timeout: Option<Duration>,
    /// Folder for summary.json, drift.csv, drift.png and report.html [default: out/ and the name of the scene]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// What replaces the scene's own values.
    #[command(flatten)]
    pub flight: FlightOptions,
    /// How to navigate.
    #[command(flatten)]
    pub navigator: NavigatorOptions,
    /// The vertical channel and missing samples.
    #[command(flatten)]
    pub handling: Handling,
    /// Write no report.html and no drift.png
    #[arg(long)]
    pub no_report: bool,
    /// Write drift.svg, too: the picture of the drift for documents
    #[arg(long)]
    pub svg: bool,
    /// Write nav.csv and truth.csv, too: the computed and the true motion, row by row
    #[arg(long)]
    pub rows: bool,
    /// Rows of drift.csv (and of --rows) to write: every N-th sample, or one each S seconds, as in 10s [default: all]
    #[arg(long, value_name = "N|S", allow_negative_numbers = true, value_parser = Every::parse)]
    pub every: Option<Every>,
}

impl HilArgs {
    /// The image for QEMU; no other device runs one.
    pub fn image(&self) -> Result<&Path, InputError> {
        match &self.image {
            Some(_) if self.device != Device::Qemu => {
                let what = format!("the device {} runs no image", self.device);
                Err(InputError::option("--image", Complaint::new(what, "--device qemu beside it")))
            }
            image => Ok(image.as_deref().unwrap_or(Path::new(IMAGE))),
        }
    }

    /// The scene, with every option applied.
    pub fn scene(&self) -> Result<Scene, InputError> {
        load(self.scene.as_deref(), &self.flight, &self.navigator, &self.handling)
            .and_then(schuler_simulator::scene::unaligned)
    }

    /// What is written of it.
    pub fn wanted(&self) -> Wanted {
        Wanted {
            every: self.every,
            report: !self.no_report,
            rows: self.rows,
            svg: self.svg,
            ..Wanted::default()
        }
    }

    /// How it is flown.
    pub fn manner(&self) -> Manner {
        let faults = self.faults.map(|rates| (rates, self.fault_seed));
        let Self { retries, stream, timeout, .. } = *self;
        Manner { retries, faults, stream, timeout }
    }
}

/// The shortest wait that lines know, and one that nobody sits out.
const TIMEOUT_S: Range = Range::from_to(0.001, 3600.0, "seconds, from 0.001 to 3600");

fn timeout(text: &str) -> Result<Duration, Complaint> {
    let seconds =
        text.parse().map_err(|_| Complaint::new("is not a number", TIMEOUT_S.accepted))?;
    TIMEOUT_S.check(seconds).map(Duration::from_secs_f64)
}

fn seed(text: &str) -> Result<u64, Complaint> {
    options::whole(text, 0..=u64::MAX)
}

fn retries(text: &str) -> Result<u32, Complaint> {
    options::whole(text, 0..=u32::MAX)
}
