//! A run: the scene's samples through the navigator, every row against truth and theory.

use crate::flight::{Extremes, Flight, Instant, Nine};
use crate::gap::{Bridge, Missing};
use crate::input::{Complaint, InputError};
use crate::navigator::{self, Navigate, Unavailable};
use crate::plan::Plan;
use crate::scene::{Scene, Vertical};
use crate::source::{Source, SourceError};
use crate::theory::Theory;
use crate::timing;
use crate::units::{ARCSECOND, DEGREE};
use schuler::drift::compare::{Drift, drift};
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::solution::Solution;
use schuler::strapdown::mechanization::Rejected;
use std::fmt;

/// Points of the overview's curves, about.
const OVERVIEW: u64 = 3000;
/// Points of the first minute's, at most.
const FIRST_MINUTE: u64 = 3000;

/// Why a run ended early.
#[derive(Debug)]
pub enum FlightError {
    /// The scene or an option asks for something that is not to be had.
    Input(InputError),
    /// The link lost a sample, and gaps are not bridged.
    Lost {
        /// Its number, from 1.
        sample: u64,
        /// Its end, s.
        time_s: f64,
    },
    /// The navigator refused a sample.
    Rejected {
        /// Its number, from 1.
        sample: u64,
        /// Its end, s.
        time_s: f64,
        /// Why.
        why: Rejected,
    },
    /// Checks that did not keep their bounds.
    Failed {
        /// How many.
        failed: usize,
        /// Of how many.
        checks: usize,
    },
    /// A recording cannot be navigated beyond this place.
    Stopped(InputError),
}

impl fmt::Display for FlightError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(error) | Self::Stopped(error) => error.fmt(f),
            Self::Lost { sample, time_s } => write!(
                f,
                "sample {sample} at {time_s} s was lost on the link; \
                 navigator.gap = \"bridge\" would fill it from its neighbours"
            ),
            Self::Failed { failed, checks } => write!(f, "{failed} of {checks} checks failed"),
            Self::Rejected { sample, time_s, why } => {
                write!(f, "sample {sample} at {time_s} s: {why}")
            }
        }
    }
}

impl std::error::Error for FlightError {}

impl From<InputError> for FlightError {
    fn from(error: InputError) -> Self {
        Self::Input(error)
    }
}

/// A sample refused by the bridge or by the navigator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refused {
    /// It is missing, and gaps are not bridged.
    Missing,
    /// It cannot be right, or leads where the navigator cannot go.
    Rejected(Rejected),
}

impl From<Missing> for Refused {
    fn from(_: Missing) -> Self {
        Self::Missing
    }
}

impl From<Rejected> for Refused {
    fn from(why: Rejected) -> Self {
        Self::Rejected(why)
    }
}

impl From<SourceError> for FlightError {
    fn from(error: SourceError) -> Self {
        let (key, what) = match error {
            SourceError::Trajectory(error) => ("trajectory", error.to_string()),
            SourceError::Sensor(error) => ("sensor", error.to_string()),
        };
        Self::Input(InputError::option(key, Complaint::new(what, "")))
    }
}

impl From<Unavailable> for FlightError {
    fn from(error: Unavailable) -> Self {
        let key = match error {
            Unavailable::Window(_) => "window",
            Unavailable::TwoFloat => "precision",
            Unavailable::Start(_) => "navigator",
        };
        Self::Input(InputError::option(key, Complaint::new(error.to_string(), "")))
    }
}

/// A scene ready to be flown: all that can be wrong with it has been found.
pub struct Simulation<'a> {
    scene: &'a Scene,
    source: Source,
    plan: Plan,
    theory: Theory,
    initial: Solution<f64>,
    navigator: Box<dyn Navigate>,
}

impl<'a> Simulation<'a> {
    /// Of a scene; `force_all` skips nothing.
    pub fn new(scene: &'a Scene, force_all: bool) -> Result<Self, FlightError> {
        let source = Source::new(scene, force_all)?;
        let plan = Plan::new(scene, &source, force_all);
        let theory = Theory::new(scene).map_err(SourceError::Trajectory)?;
        let interval_s = Pair::new(scene.rate_hz).reciprocal();
        let initial = offset(&source.motion(0).initial(), scene);
        let navigator =
            navigator::start(&scene.navigator, plan.window, plan.order, interval_s, &initial)?;
        Ok(Self { scene, source, plan, theory, initial, navigator })
    }

    /// Flies it. Every instant is shown to `observe` in order of time; `progress` gets the number of
    /// samples flown.
    pub fn fly(
        self,
        observe: &mut dyn FnMut(&Instant) -> Result<(), InputError>,
        progress: &dyn Fn(u64),
    ) -> Result<Flight, FlightError> {
        let Self { scene, source, plan, mut theory, initial, mut navigator } = self;
        let samples = scene.samples();
        let mut log = Log::new(samples, scene.rate_hz);
        let mut written = Ok(());
        let mut row = |n: u64, computed: &Solution<f64>| {
            let instant = instant(&source, &mut theory, n, computed);
            log.add(n, &instant);
            if written.is_ok() {
                written = observe(&instant);
            }
        };
        row(0, &initial);
        let mut stream = source.start(0);
        let mut bridge = Bridge::new(scene.navigator.gap);
        for sample in 1..=samples {
            let measured = stream.advance();
            let taken = bridge.take(measured, |increment| -> Result<(), Refused> {
                Ok(push(navigator.as_mut(), increment, scene, &source, &mut row)?)
            });
            taken.map_err(|refused| refused.at(sample, &source))?;
            progress(sample);
        }
        bridge
            .finish(|increment| -> Result<(), Refused> {
                Ok(push(navigator.as_mut(), increment, scene, &source, &mut row)?)
            })
            .map_err(|refused| refused.at(samples, &source))?;
        navigator.finish(&mut row);
        written?;

        Ok(Flight {
            scene: scene.clone(),
            samples,
            window: plan.flown_window(scene),
            skipped: plan.skipped(scene, &source, navigator.as_ref()),
            digest: format!("{:016x}", navigator.digest()),
            last: log.last,
            max: log.max,
            overview: log.overview,
            first_minute: log.first_minute,
            saturated: stream.saturated(),
            lost: bridge.lost,
            time: Some(timing::stages(scene, &source, navigator.as_ref())),
        })
    }
}

/// Flies a scene: [`Simulation::new`] and [`Simulation::fly`] in one.
pub fn fly(
    scene: &Scene,
    force_all: bool,
    observe: &mut dyn FnMut(&Instant) -> Result<(), InputError>,
    progress: &dyn Fn(u64),
) -> Result<Flight, FlightError> {
    Simulation::new(scene, force_all)?.fly(observe, progress)
}

impl Refused {
    /// The error that ends a run at a sample.
    pub fn at(self, sample: u64, source: &Source) -> FlightError {
        let time_s = source.time_s(sample);
        match self {
            Self::Missing => FlightError::Lost { sample, time_s },
            Self::Rejected(why) => FlightError::Rejected { sample, time_s, why },
        }
    }
}

fn push(
    navigator: &mut dyn Navigate,
    increment: &schuler::sample::Increment<f64>,
    scene: &Scene,
    source: &Source,
    row: &mut dyn FnMut(u64, &Solution<f64>),
) -> Result<(), Rejected> {
    let before = navigator.integrated();
    navigator.push(increment, row)?;
    if scene.navigator.vertical == Vertical::Held && navigator.integrated() != before {
        let truth = source.truth(navigator.integrated());
        navigator.hold_vertical(truth.position.altitude.hi, truth.velocity_ned.z.hi);
    }
    Ok(())
}

/// The truth, off by the scene's initial error; what is held is not off.
pub fn offset(truth: &Solution<f64>, scene: &Scene) -> Solution<f64> {
    let mut error = scene.initial_error;
    if scene.navigator.vertical == Vertical::Held {
        (error.position_m[2], error.velocity_m_s[2]) = (0.0, 0.0);
    }
    let error = Drift {
        position_ned: error.position_m.into(),
        velocity_ned: error.velocity_m_s.into(),
        attitude_ned: error.attitude_rad.into(),
    };
    if error == Drift::default() { *truth } else { error.added_to(truth) }
}

fn instant(source: &Source, theory: &mut Theory, sample: u64, computed: &Solution<f64>) -> Instant {
    let time_s = source.time_s(sample);
    let truth = source.truth(sample);
    let expected = theory.at(time_s);
    let attitude = truth.euler();
    Instant {
        time_s,
        drift: nine(&drift(computed, &truth)),
        mean: nine(&expected.mean),
        sigma: nine(&expected.sigma),
        position: [
            truth.position.latitude.hi / DEGREE,
            truth.position.longitude.hi / DEGREE,
            truth.position.altitude.hi,
        ],
        attitude_deg: [attitude.roll, attitude.pitch, attitude.yaw].map(|angle| angle / DEGREE),
    }
}

/// A drift in the units of files.
pub fn nine(drift: &Drift) -> Nine {
    Nine {
        position_m: drift.position_ned.into_array(),
        velocity_m_s: drift.velocity_ned.into_array(),
        attitude_arcsec: drift.attitude_ned.map(|angle| angle / ARCSECOND).into_array(),
    }
}

/// What is kept of a run's instants.
struct Log {
    stride: u64,
    minute_stride: u64,
    minute: u64,
    samples: u64,
    last: Instant,
    max: Extremes,
    overview: Vec<Instant>,
    first_minute: Vec<Instant>,
}

impl Log {
    fn new(samples: u64, rate_hz: f64) -> Self {
        let minute = ((60.0 * rate_hz).ceil() as u64).min(samples);
        Self {
            stride: samples.div_ceil(OVERVIEW).max(1),
            minute_stride: minute.div_ceil(FIRST_MINUTE).max(1),
            minute,
            samples,
            last: Instant::default(),
            max: Extremes::default(),
            overview: Vec::new(),
            first_minute: Vec::new(),
        }
    }

    fn add(&mut self, sample: u64, instant: &Instant) {
        let Nine { position_m, velocity_m_s, attitude_arcsec } = instant.drift;
        let max = &mut self.max;
        for (most, now) in [
            (&mut max.components.position_m, position_m),
            (&mut max.components.velocity_m_s, velocity_m_s),
            (&mut max.components.attitude_arcsec, attitude_arcsec),
        ] {
            for (most, now) in most.iter_mut().zip(now) {
                *most = largest(*most, now.abs());
            }
        }
        for (most, now) in max.norms.iter_mut().zip([position_m, velocity_m_s, attitude_arcsec]) {
            *most = largest(*most, Vector::from(now).norm());
        }
        if sample.is_multiple_of(self.stride) || sample == self.samples {
            self.overview.push(*instant);
        }
        if sample <= self.minute && sample.is_multiple_of(self.minute_stride) {
            self.first_minute.push(*instant);
        }
        self.last = *instant;
    }
}

/// The larger; a NaN is kept for everyone to see.
fn largest(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
