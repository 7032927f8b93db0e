//! An alignment of a scene, ready to be started for each run.

use super::aligner::{Aligner, Aligns, Running};
use super::sensors;
use super::under_way::UnderWay;
use crate::input::{Complaint, InputError};
use crate::scene::alignment::BLOCK;
use crate::scene::{Alignment, Base, Scene};
use crate::simulate::start;
use crate::source::Source;
use schuler::aiding::alignment::base;
use schuler::aiding::alignment::limit::Limit;
use schuler::aiding::alignment::settings::Settings;
use schuler::aiding::alignment::verdict::AlignmentFault;
use schuler::aiding::surroundings::Surroundings;
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::navigators::Navigator4;
use schuler::noise::Streams;
use schuler::solution::{Euler, Solution};
use std::f64::consts::TAU;

/// Branches of the random start: those below are the nine numbers of an initial error.
const HEADING: u64 = 3;
const VELOCITY: u64 = 4;
/// A first level is taken to be good to this at least, rad.
const LEVEL: f64 = 0.01;
/// A heading of which nothing is known, rad.
const UNKNOWN: f64 = 1.8;
/// The first velocity of a vehicle at rest, m/s per axis.
const STANDS: f64 = 1e-3;
/// What the resonator does not explain of a displacement, m.
const UNEXPLAINED: f64 = 1e-2;

/// An alignment of a scene.
pub struct Setup<'a> {
    scene: &'a Scene,
    source: &'a Source,
    alignment: Alignment,
    settings: Settings<f64>,
    interval: Pair<f64>,
    /// How many samples it takes.
    pub samples: u64,
    /// The sensors, as the filter takes them.
    pub sensors: Limit<f64>,
}

impl<'a> Setup<'a> {
    /// Of a scene, whatever it says itself.
    pub fn new(
        scene: &'a Scene,
        source: &'a Source,
        alignment: Alignment,
    ) -> Result<Self, InputError> {
        let blocks = (alignment.duration_s * scene.rate_hz / BLOCK as f64).round() as u64;
        let samples = blocks * BLOCK;
        if samples == 0 || samples > scene.samples() {
            let least = BLOCK as f64 / scene.rate_hz;
            let what = format!("{} s are not within the scene", alignment.duration_s);
            let accepted = format!("seconds, from {least} to {}", scene.duration_s);
            return Err(InputError::option("alignment.duration_s", Complaint::new(what, accepted)));
        }
        if scene.link.loss > 0.0 {
            let complaint = Complaint::new("loses samples, and an alignment needs all", "0");
            return Err(InputError::option("link.loss", complaint));
        }
        let initial = &scene.initial_error;
        let tilt = [initial.attitude_rad, initial.attitude_sigma_rad];
        let tilt = tilt.iter().flat_map(|axes| &axes[..2]).fold(LEVEL, |most, x| most.max(x.abs()));
        let (base, velocity_m_s) = match alignment.base {
            Base::Still => (base::Base::still(), STANDS),
            Base::Swaying => {
                let sway =
                    base::Base::Swaying { sway: alignment.sway, displacement_m: UNEXPLAINED };
                (sway, alignment.sway.rms_m * alignment.sway.rate)
            }
            Base::Moving => (base::Base::Moving, alignment.velocity_sigma_m_s),
        };
        let settings = Settings {
            base,
            level_rad: tilt,
            heading_rad: alignment.heading_sigma_rad.unwrap_or(UNKNOWN),
            velocity_m_s,
            ..Settings::new(sensors::model(scene))
        };
        let interval = Pair::new(scene.rate_hz).reciprocal();
        Ok(Self {
            scene,
            source,
            alignment,
            settings,
            interval,
            samples,
            sensors: sensors::limit(scene),
        })
    }

    /// Starts that of a run, from a heading that is off by what the run draws, or by an angle that is given, rad. A
    /// vehicle that moves shows its heading by its velocities in seconds: there no first one is asked.
    pub fn start(&self, run: u64, off: Option<f64>) -> Result<Aligner<'a>, AlignmentFault> {
        let truth = self.source.initial(0);
        let initial = start::of_run(&truth, self.scene, run);
        let streams = Streams::new(self.scene.seed, run).branch(Streams::START);
        let mut heading = streams.branch(HEADING).open();
        let drawn = match self.alignment.heading_sigma_rad {
            Some(sigma) => sigma * heading.normal::<f64>(),
            None => TAU * (heading.uniform::<f64>() - 0.5),
        };
        let first = initial.euler();
        let first = Euler { yaw: first.yaw + off.unwrap_or(drawn), ..first };
        let place = place(&initial);
        let navigator = Navigator4::new(self.interval).map_err(|_| AlignmentFault::Settings)?;
        let (settings, interval) = (self.settings, self.interval);
        let running: Box<dyn Aligns> = match self.alignment.base {
            Base::Still => {
                Box::new(Running::<15, 120, 0>::new(navigator, interval, place, settings, first)?)
            }
            Base::Swaying => {
                Box::new(Running::<21, 231, 6>::new(navigator, interval, place, settings, first)?)
            }
            Base::Moving => {
                let velocity = initial.velocity_ned.map(|v| v.hi);
                Box::new(UnderWay::new(navigator, interval, place, settings, velocity))
            }
        };
        let moves = self.alignment.base == Base::Moving;
        let measured = moves.then(|| streams.branch(VELOCITY).axes());
        Ok(Aligner::new(running, self.source, self.samples, &self.alignment, measured))
    }

    /// When it ends, s.
    pub fn time_s(&self) -> f64 {
        self.source.time_s(self.samples)
    }

    /// The place where it begins, and what an alignment needs to know of it.
    pub fn surroundings(&self) -> Surroundings<f64> {
        Surroundings::at(&place(&self.source.initial(0)))
    }

    /// What it is.
    pub fn alignment(&self) -> &Alignment {
        &self.alignment
    }

    /// How far the vehicle turns about the vertical meanwhile, rad.
    pub fn turned(&self) -> f64 {
        let steps = 256;
        let yaw = |n: u64| self.source.truth(self.samples * n / steps).euler().yaw;
        let turns = (1..=steps).map(|n| {
            let turn = yaw(n) - yaw(n - 1);
            turn - TAU * (turn / TAU).round()
        });
        turns.sum::<f64>().abs()
    }
}

fn place(solution: &Solution<f64>) -> Geodetic<f64> {
    solution.position.map(|coordinate| coordinate.hi)
}
