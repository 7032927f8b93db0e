//! The effect of one unit in the last place of an input on later outputs: digits beyond it mean
//! nothing.

use schuler::drift::compare::drift;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::limits::Rejected;
use schuler_simulator::navigator;
use schuler_simulator::plan::Plan;
use schuler_simulator::scene::{Precision, Scene};
use schuler_simulator::simulate::{FlightError, nine, offset};
use schuler_simulator::source::Source;
use serde::Serialize;
use std::collections::BTreeSet;

/// What one unit in the last place of an input did.
#[derive(Clone, Debug, Serialize)]
pub struct Effect {
    /// The input.
    pub input: String,
    /// The unit, in the input's own: rad, m, m/s.
    pub ulp: f64,
    /// At each sample that is looked at.
    pub after: Vec<Moved>,
}

/// How far the outputs moved.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Moved {
    /// Seconds of flight.
    pub time_s: f64,
    /// Position, north, east, down, m.
    pub position_m: [f64; 3],
    /// Velocity, m/s.
    pub velocity_m_s: [f64; 3],
    /// Attitude, about north, east, down, arcsec.
    pub attitude_arcsec: [f64; 3],
}

/// The inputs of a sample.
const COMPONENTS: [&str; 6] = ["gyro x", "gyro y", "gyro z", "accel x", "accel y", "accel z"];

/// Where an input is moved.
#[derive(Clone, Copy)]
enum Place {
    Nowhere,
    Start(usize),
    FirstSample(usize),
    EverySample(usize),
}

/// The effect of every input of a scene, at the samples nearest to times in seconds, each once, in order.
pub fn sensitivity(scene: &Scene, times_s: &[f64]) -> Result<Vec<Effect>, FlightError> {
    let flight = Flight::new(scene, times_s)?;
    let base = flight.fly(Place::Nowhere)?.1;
    let starts = (0..STARTS.len()).map(Place::Start);
    let firsts = (0..6).map(Place::FirstSample);
    let everies = (0..6).map(Place::EverySample);
    let mut effects = Vec::new();
    for place in starts.chain(firsts).chain(everies) {
        let (ulp, moved) = flight.fly(place)?;
        let after = moved.iter().zip(&base).map(|((sample, moved), (_, base))| {
            let time_s = *sample as f64 / scene.rate_hz;
            let nine = nine(&drift(moved, base));
            let (position_m, velocity_m_s) = (nine.position_m, nine.velocity_m_s);
            Moved { time_s, position_m, velocity_m_s, attitude_arcsec: nine.attitude_arcsec }
        });
        let input = match place {
            Place::Nowhere => continue,
            Place::Start(i) => format!("initial {}", STARTS[i].0),
            Place::FirstSample(i) => format!("{} of the first sample", COMPONENTS[i]),
            Place::EverySample(i) => format!("{} of every sample", COMPONENTS[i]),
        };
        effects.push(Effect { input, ulp, after: after.collect() });
    }
    Ok(effects)
}

type Part = fn(&mut Solution<f64>) -> &mut Pair<f64>;

/// The numbers to start from.
const STARTS: [(&str, Part); 10] = [
    ("latitude", |s| &mut s.position.latitude),
    ("longitude", |s| &mut s.position.longitude),
    ("altitude", |s| &mut s.position.altitude),
    ("velocity north", |s| &mut s.velocity_ned.x),
    ("velocity east", |s| &mut s.velocity_ned.y),
    ("velocity down", |s| &mut s.velocity_ned.z),
    ("attitude w", |s| &mut s.attitude.w),
    ("attitude x", |s| &mut s.attitude.v.x),
    ("attitude y", |s| &mut s.attitude.v.y),
    ("attitude z", |s| &mut s.attitude.v.z),
];

/// The unit that was added, and the navigation after each sample that is due.
type Flown = (f64, Vec<(u64, Solution<f64>)>);

/// A scene's samples, to be flown again and again.
struct Flight<'a> {
    scene: &'a Scene,
    plan: Plan,
    initial: Solution<f64>,
    samples: Vec<Increment<f64>>,
    /// The samples after which to look, in order.
    due: BTreeSet<u64>,
}

impl<'a> Flight<'a> {
    fn new(scene: &'a Scene, times_s: &[f64]) -> Result<Self, FlightError> {
        let source = Source::new(scene, false)?;
        let plan = Plan::new(scene, &source, false);
        let initial = offset(&source.initial(0), scene);
        let mut stream = source.start(0);
        let samples = (0..scene.samples()).map(|_| stream.advance_seen().0).collect();
        let due = times_s.iter().map(|t| (t * scene.rate_hz).round() as u64).collect();
        Ok(Self { scene, plan, initial, samples, due })
    }

    fn fly(&self, place: Place) -> Result<Flown, FlightError> {
        let precision = self.scene.navigator.precision;
        let mut initial = self.initial;
        let mut unit = 0.0;
        if let Place::Start(i) = place {
            let part = STARTS[i].1(&mut initial);
            unit = ulp(precision, part.hi);
            part.hi += unit;
        }
        let interval_s = Pair::new(self.scene.rate_hz).reciprocal();
        let Plan { window, order, .. } = self.plan;
        let mut navigator =
            navigator::start(&self.scene.navigator, window, order, interval_s, &initial)?;
        let mut outputs = Vec::new();
        let mut keep = |n: u64, solution: &Solution<f64>| {
            if self.due.contains(&n) {
                outputs.push((n, *solution));
            }
        };
        for (i, sample) in self.samples.iter().enumerate() {
            let mut sample = *sample;
            match place {
                Place::FirstSample(c) if i == 0 => unit = add_ulp(precision, &mut sample, c),
                Place::EverySample(c) => unit = add_ulp(precision, &mut sample, c).max(unit),
                _ => {}
            }
            let reject = |why: Rejected| FlightError::Rejected {
                sample: i as u64 + 1,
                time_s: (i + 1) as f64 / self.scene.rate_hz,
                why,
            };
            navigator.push(&sample, &mut keep).map_err(reject)?;
        }
        navigator.finish(&mut keep);
        Ok((unit, outputs))
    }
}

fn add_ulp(precision: Precision, sample: &mut Increment<f64>, component: usize) -> f64 {
    let Increment { angle_b: a, velocity_b: v } = sample;
    let parts = [&mut a.x, &mut a.y, &mut a.z, &mut v.x, &mut v.y, &mut v.z];
    let mut unit = 0.0;
    if let Some(part) = parts.into_iter().nth(component) {
        unit = ulp(precision, *part);
        *part += unit;
    }
    unit
}

/// The distance to the next number of the navigator's type, away from zero.
fn ulp(precision: Precision, x: f64) -> f64 {
    let x = x.abs();
    match precision {
        Precision::F64 => x.next_up() - x,
        Precision::F32 | Precision::F32x2 => f64::from((x as f32).next_up()) - f64::from(x as f32),
    }
}

impl Moved {
    /// Norms: position m, velocity m/s, attitude arcsec.
    pub fn norms(&self) -> [f64; 3] {
        [self.position_m, self.velocity_m_s, self.attitude_arcsec].map(|v| Vector::from(v).norm())
    }
}
