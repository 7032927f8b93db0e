//! A run: the scene's samples through the navigator, every row against truth and theory.

mod error;
mod log;
mod riding;
pub mod start;
mod vehicle;

pub use error::{FlightError, Refused};
pub use log::{Log, largest};
pub use riding::Claims;
use riding::Riding;
pub use vehicle::Vehicle;

use crate::aided::report::Report;
use crate::aided::smoother::{self, Smoothed};
use crate::aided::vehicle::AidedVehicle;
use crate::alignment::begin::{Beginning, begin};
use crate::alignment::outcome::Outcome;
use crate::flight::{Ended, Flight, Instant, Nine};
use crate::input::InputError;
use crate::plan::Plan;
use crate::scene::{Scene, Vertical};
use crate::source::{Source, SourceError};
use crate::theory::{Outside, Theory};
use crate::timing;
use crate::units::{ARCSECOND, DEGREE};
use schuler::drift::compare::{Drift, drift};
use schuler::link::gap::Bridge;
use schuler::solution::Solution;
use std::cell::{Cell, RefCell};

/// A scene ready to be flown: all that can be wrong with it has been found.
pub struct Simulation<'a> {
    scene: &'a Scene,
    source: Source,
    plan: Plan,
    theory: Theory,
    initial: Solution<f64>,
    vehicle: Box<dyn Vehicle>,
    run: u64,
    /// Samples before the first row.
    before: u64,
    aligned: Option<Outcome>,
    /// What an aided navigator says of itself.
    claims: Option<Claims>,
}

impl<'a> Simulation<'a> {
    /// Of a scene's run 0; `force_all` skips nothing.
    pub fn new(scene: &'a Scene, force_all: bool) -> Result<Self, FlightError> {
        Self::of_run(scene, force_all, 0)
    }

    /// Of the run of a number, as an ensemble flies it.
    pub fn of_run(scene: &'a Scene, force_all: bool, run: u64) -> Result<Self, FlightError> {
        let source = Source::new(scene, force_all)?;
        let plan = Plan::new(scene, &source, force_all);
        let theory = Theory::new(scene).map_err(SourceError::Trajectory)?;
        let Beginning { navigator, initial, before, outcome } = begin(scene, &source, &plan, run)?;
        let claims = scene.aiding.is_there().then(Claims::default);
        let vehicle: Box<dyn Vehicle> = match &claims {
            None => Box::new(navigator),
            Some(claims) => {
                let smoother = scene.aiding.filter.smoother;
                let aided = AidedVehicle::new(scene, &source, run, &initial, smoother)?;
                Box::new(Riding::new(aided, navigator, claims.clone()))
            }
        };
        let aligned = outcome;
        Ok(Self { scene, source, plan, theory, initial, vehicle, run, before, aligned, claims })
    }

    /// Where an aided navigator says what it claims; none if the scene is not aided.
    pub fn claims(&self) -> Option<Claims> {
        self.claims.clone()
    }

    /// Whether theory expects anything at all, so that its columns are not zero throughout.
    pub fn expects_scatter(&self) -> bool {
        self.claims.is_some() || !self.theory.is_zero()
    }

    /// With something else in place of the navigator: `board` gets the plan and the initial solution.
    pub fn aboard<E>(
        self,
        board: impl FnOnce(&Plan, &Solution<f64>) -> Result<Box<dyn Vehicle>, E>,
    ) -> Result<Self, E> {
        let vehicle = board(&self.plan, &self.initial)?;
        Ok(Self { vehicle, ..self })
    }

    /// Flies it to its end. Every instant is shown to `observe` in order of time; `progress` gets the
    /// number of samples flown.
    pub fn fly(
        self,
        observe: &mut dyn FnMut(&Instant) -> Result<(), InputError>,
        progress: &dyn Fn(u64),
    ) -> Result<Flight, FlightError> {
        let (flight, end) = self.fly_as_far(observe, progress)?;
        end.map(|()| flight)
    }

    /// Flies it as far as it goes: what was flown, and what ended it early, if anything. It is an error
    /// of its own that `observe` fails.
    pub fn fly_as_far(
        self,
        observe: &mut dyn FnMut(&Instant) -> Result<(), InputError>,
        progress: &dyn Fn(u64),
    ) -> Result<(Flight, Result<(), FlightError>), FlightError> {
        let Self {
            scene,
            source,
            plan,
            mut theory,
            initial,
            mut vehicle,
            run,
            before,
            aligned,
            claims,
        } = self;
        let (samples, gap) = (scene.samples(), scene.navigator.gap);
        let mut log = Log::new(samples, scene.rate_hz);
        let (written, flown) = (RefCell::new(Ok(())), Cell::new(0));
        // Samples that theory knows nothing of: what comes after them is not compared with it.
        let strayed = Cell::new(false);
        let mut outside = None;
        let mut row = |n: u64, computed: &Solution<f64>| {
            let mut instant = instant(&source, &mut theory, n, computed);
            outside = match strayed.get() {
                true => Some(Outside::Samples),
                false => theory.outside(instant.time_s),
            };
            if let Some(claims) = &claims {
                (outside, instant.mean, instant.sigma) =
                    (None, Nine::default(), claims.sigma.get());
            } else if outside.is_some() {
                (instant.mean, instant.sigma) = (Nine::UNKNOWN, Nine::UNKNOWN);
            }
            log.add(n, &instant);
            flown.set(n);
            let mut written = written.borrow_mut();
            if written.is_ok() {
                *written = observe(&instant);
            }
        };
        row(before, &initial);
        let mut stream = source.start(run);
        for _ in 0..before {
            stream.advance();
        }
        let mut bridge = Bridge::new(gap.into());
        let mut end = None;
        for sample in before + 1..=samples {
            let measured = stream.advance();
            if measured.is_none() || stream.saturated() > 0 {
                strayed.set(true);
            }
            let taken = bridge.take(measured, |increment| {
                push(vehicle.as_mut(), increment, scene, &source, &mut row)
            });
            if let Err(refused) = taken {
                if refused.is_of_the_sample() {
                    vehicle.break_off(&mut row);
                }
                let angle_b = measured.map(|increment| increment.angle_b.into_array());
                let block = plan.window.block;
                end = Some((sample, refused.at_increment(sample, &source, gap, angle_b, block)));
                break;
            }
            if written.borrow().is_err() {
                break;
            }
            progress(sample);
        }
        if end.is_none() {
            let finished = bridge
                .finish(|increment| push(vehicle.as_mut(), increment, scene, &source, &mut row))
                .and_then(|()| vehicle.finish(&mut row));
            end = finished.err().map(|refused| (samples, refused.at(samples, &source, gap)));
        }
        written.into_inner()?;
        log.finish();
        let ended = end.as_ref().map(|(sample, error)| Ended {
            sample: *sample,
            time_s: source.time_s(*sample),
            reason: error.to_string(),
            planned_samples: samples,
            planned_duration_s: scene.duration_s,
        });

        let flight = Flight {
            scene: scene.clone(),
            samples: flown.get(),
            time: ended.is_none().then(|| timing::stages(scene, &source, vehicle.navigator())),
            ended,
            window: plan.flown_window(scene),
            planned: plan.trial,
            edges: vehicle.navigator().edges(),
            skipped: plan.skipped(scene, &source, vehicle.navigator()),
            digest: format!("{:016x}", vehicle.digest()),
            last: log.last,
            max: log.max,
            overview: log.overview,
            first_minute: log.first_minute,
            neglected: log.highest.neglected(),
            saturated: stream.saturated(),
            lost: bridge.lost().into(),
            outside,
            link: None,
            aligned,
            smoothed: claims.as_ref().map_or(Vec::new(), |claims| {
                let states = claims.smoothed.borrow();
                states.iter().map(|state| smoothed_instant(&source, state)).collect()
            }),
            aided: claims.and_then(|claims| {
                let smoothed = claims.smoothed.borrow();
                let truth = |samples| source.truth(samples);
                let compared = smoother::compared(&smoothed, scene.rate_hz, truth);
                claims.report.take().map(|report| Report { smoothed: compared, ..report })
            }),
        };
        Ok((flight, end.map_or(Ok(()), |(_, error)| Err(error))))
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

fn push(
    vehicle: &mut dyn Vehicle,
    increment: &schuler::sample::Increment<f64>,
    scene: &Scene,
    source: &Source,
    row: &mut dyn FnMut(u64, &Solution<f64>),
) -> Result<(), Refused> {
    let before = vehicle.integrated();
    vehicle.push(increment, row)?;
    if scene.navigator.vertical == Vertical::Held && vehicle.integrated() != before {
        let truth = source.truth(vehicle.integrated());
        vehicle.hold_vertical(truth.position.altitude.hi, truth.velocity_ned.z.hi)?;
    }
    Ok(())
}

/// Where the scene's first run starts: [`start::of_run`] of run 0.
pub fn offset(truth: &Solution<f64>, scene: &Scene) -> Solution<f64> {
    start::of_run(truth, scene, 0)
}

fn instant(source: &Source, theory: &mut Theory, sample: u64, computed: &Solution<f64>) -> Instant {
    let time_s = source.time_s(sample);
    let expected = theory.at(time_s);
    let (mean, sigma) = (nine(&expected.mean), nine(&expected.sigma));
    Instant { mean, sigma, ..compared(time_s, computed, &source.truth(sample)) }
}

fn smoothed_instant(source: &Source, smoothed: &Smoothed) -> Instant {
    let Smoothed { samples, solution, covariance, .. } = smoothed;
    let compared = compared(source.time_s(*samples), solution, &source.truth(*samples));
    Instant { mean: Nine::default(), sigma: Nine::of_covariance(covariance), ..compared }
}

/// An instant of which theory says nothing.
pub fn compared(time_s: f64, computed: &Solution<f64>, truth: &Solution<f64>) -> Instant {
    let attitude = truth.euler();
    Instant {
        time_s,
        drift: nine(&drift(computed, truth)),
        mean: Nine::UNKNOWN,
        sigma: Nine::UNKNOWN,
        position: [
            truth.position.latitude.hi / DEGREE,
            truth.position.longitude.hi / DEGREE,
            truth.position.altitude.hi,
        ],
        attitude_deg: [attitude.roll, attitude.pitch, attitude.yaw].map(|angle| angle / DEGREE),
        computed: *computed,
        truth: *truth,
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
