//! What the aiding sensors of a run deliver, in the order of arrival.

use crate::scene::Scene;
use crate::source::Source;
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::Measured;
use schuler::math::compensated::Pair;
use schuler::sensor::aiding::line::{Delivered, Line, LineState};
use schuler::sensor::aiding::truth::Truth;
use schuler::trajectory::Trajectory as _;

/// A measurement, and when it arrives, s.
pub type Arriving = (f64, Measured<f64>);

/// The measurements of a run on their way.
#[derive(Clone, Debug)]
pub struct Arrivals {
    all: Vec<Arriving>,
    next: usize,
    rate_hz: f64,
}

impl Arrivals {
    /// Of a run of a scene.
    pub fn new(scene: &Scene, source: &Source, run: u64) -> Self {
        Self::of(of_run(scene, source, run), scene.rate_hz)
    }

    /// Of measurements in the order of their arrival, beside samples of a rate in hertz.
    pub fn of(all: Vec<Arriving>, rate_hz: f64) -> Self {
        Self { all, next: 0, rate_hz }
    }

    /// The next one that has arrived by the end of a sample.
    pub fn by(&mut self, sample: u64) -> Option<Measured<f64>> {
        let now_s = sample as f64 / self.rate_hz;
        // A millionth of a sample for times that are no whole numbers.
        let (_, measured) = self
            .all
            .get(self.next)
            .filter(|(arrives_s, _)| *arrives_s <= now_s + 1e-6 / self.rate_hz)?;
        self.next += 1;
        Some(*measured)
    }
}

/// When one was true and when it arrives, beside samples of a rate in hertz, s.
pub fn times_s((arrives_s, measured): &Arriving, rate_hz: f64) -> [f64; 2] {
    let time_s = (measured.at.samples as f64 + measured.at.part) / rate_hz;
    // What arrives in time arrives then to the last bit.
    [time_s, arrives_s.max(time_s)]
}

/// All measurements of a run, sorted by their arrival; of the same time in the order of the sensors.
pub fn of_run(scene: &Scene, source: &Source, run: u64) -> Vec<Arriving> {
    let (seed, aiding) = (scene.seed, &scene.aiding);
    let mut all = Vec::new();
    if let Some(gnss) = &aiding.gnss {
        let mut state = gnss.start(seed, run);
        every(
            scene,
            &gnss.line,
            &mut all,
            source,
            &mut state,
            |s| &s.line,
            |s, truth, at| gnss.measure(s, truth, at),
        );
    }
    if let Some(barometer) = &aiding.barometer {
        let mut state = barometer.start(seed, run);
        every(
            scene,
            &barometer.line,
            &mut all,
            source,
            &mut state,
            |s| &s.line,
            |s, truth, at| barometer.measure(s, truth, at),
        );
    }
    if let Some(odometer) = &aiding.odometer {
        let mut state = odometer.start(seed, run);
        every(
            scene,
            &odometer.line,
            &mut all,
            source,
            &mut state,
            |s| &s.line,
            |s, truth, at| odometer.measure(s, truth, at),
        );
    }
    if let Some(still) = &aiding.still {
        let mut state = still.start(seed, run);
        every(
            scene,
            &still.line,
            &mut all,
            source,
            &mut state,
            |s| &s.line,
            |s, truth, at| still.measure(s, truth, at),
        );
    }
    if let Some(wheels) = &aiding.wheels {
        let mut state = wheels.start(seed, run);
        every(
            scene,
            &wheels.line,
            &mut all,
            source,
            &mut state,
            |s| &s.line,
            |s, _, at| wheels.measure(s, at),
        );
    }
    all.sort_by(|one, other| one.0.total_cmp(&other.0));
    all
}

/// Every measurement of a sensor within the scene.
fn every<S>(
    scene: &Scene,
    line: &Line<f64>,
    all: &mut Vec<Arriving>,
    source: &Source,
    state: &mut S,
    epochs: impl Fn(&S) -> &LineState,
    mut measure: impl FnMut(&mut S, &Truth<f64>, Instant<f64>) -> Option<Delivered<f64>>,
) {
    let end_s = source.time_s(scene.samples());
    loop {
        let time_s = line.epoch_s(epochs(state));
        if time_s > end_s {
            return;
        }
        let Some(at) = Instant::from_seconds(time_s, scene.rate_hz) else { return };
        let truth = truth(source, time_s, &at);
        if let Some(Delivered { measured, arrives_s, again_s }) = measure(state, &truth, at) {
            all.push((arrives_s, measured));
            all.extend(again_s.map(|again_s| (again_s, measured)));
        }
    }
}

/// The vehicle at a time: at the end of a sample as the scene has it there.
fn truth(source: &Source, time_s: f64, at: &Instant<f64>) -> Truth<f64> {
    if at.part == 0.0 {
        return Truth::of(&source.truth(at.samples), source.rates(at.samples).rate_ib_b);
    }
    let time_s = Pair::new(time_s);
    let rates = source.course.rates_at(time_s);
    Truth::of(&source.course.solution_at(time_s), rates.rate_ib_b)
}
