//! The Allan variances of six axes: of a scene's sensor errors, or of a recording at rest.

use super::still::{AXES, Stillness, six};
use crate::input::{Complaint, InputError};
use crate::number::{counted, parameter};
use crate::recording::Kind;
use crate::recording::rows::Recording;
use crate::recording::survey::Survey;
use crate::recording::timeline::{self, Timeline};
use crate::scene::Scene;
use crate::scene::terms::TERMS;
use crate::source::{Source, SourceError};
use schuler::allan::octaves::{Octaves, Point};
use schuler::sample::Increment;
use schuler::sensor::Timing;
use schuler::units::STANDARD_GRAVITY;

/// Fewer samples say nothing.
pub const FEWEST: u64 = 32;
/// How far the mean specific force at rest may be from gravity, of it.
const GRAVITY: f64 = 0.08;

/// What was measured.
#[derive(Clone, Debug)]
pub struct Record {
    /// Its timing.
    pub timing: Timing<f64>,
    /// Gyros x, y, z, then accelerometers; none of an axis that never changes.
    pub axes: [Vec<Point<f64>>; 6],
    /// What is to be said of it, a line each.
    pub said: Vec<String>,
}

/// Six axes being measured.
struct Gathering {
    axes: [Octaves<f64>; 6],
    first: [f64; 6],
    changes: [bool; 6],
}

impl Gathering {
    fn new(interval_s: f64) -> Result<Self, Complaint> {
        let axis = Octaves::new(interval_s).map_err(|e| Complaint::new(e.to_string(), ""))?;
        Ok(Self { axes: [axis; 6], first: [0.0; 6], changes: [false; 6] })
    }

    fn add(&mut self, values: [f64; 6]) -> Result<(), Complaint> {
        for (i, (axis, value)) in self.axes.iter_mut().zip(values).enumerate() {
            if axis.samples() == 0 {
                self.first[i] = value;
            }
            self.changes[i] |= value != self.first[i];
            let refused = |e: schuler::allan::octaves::Refused| {
                Complaint::new(format!("{}: {e}", AXES[i]), "")
            };
            axis.add(value).map_err(refused)?;
        }
        Ok(())
    }

    fn samples(&self) -> u64 {
        self.axes[0].samples()
    }

    fn points(&self) -> [Vec<Point<f64>>; 6] {
        std::array::from_fn(|i| match self.changes[i] {
            true => self.axes[i].points().collect(),
            false => Vec::new(),
        })
    }
}

/// Who adds up the increments of six axes.
pub trait Sums {
    /// Takes a sample.
    fn add(&mut self, sample: &Increment<f64>) -> Result<(), Complaint>;
    /// The points of each axis so far.
    fn points(&mut self) -> Result<[Vec<Point<f64>>; 6], Complaint>;
}

impl Sums for Gathering {
    fn add(&mut self, sample: &Increment<f64>) -> Result<(), Complaint> {
        Gathering::add(self, six(sample))
    }

    fn points(&mut self) -> Result<[Vec<Point<f64>>; 6], Complaint> {
        Ok(Gathering::points(self))
    }
}

/// The sensor errors of a scene: what the sensors read less what perfect ones would.
pub fn of_scene(scene: &Scene) -> Result<Record, SceneError> {
    of_scene_by(scene, &mut Gathering::new(1.0 / scene.rate_hz)?)
}

/// The same, added up by somebody else.
pub fn of_scene_by(scene: &Scene, sums: &mut dyn Sums) -> Result<Record, SceneError> {
    let source = Source::new(scene, false)?;
    let (interval_s, samples) = (1.0 / scene.rate_hz, scene.samples());
    if samples < FEWEST {
        return Err(too_few(samples).into());
    }
    let mut stream = source.start(0);
    let (mut first, mut changes) = (None, [false; 6]);
    for sample in 1..=samples {
        let perfect = source.perfect_sample(sample);
        let read = stream.sense(&perfect);
        let off = Increment {
            angle_b: read.angle_b - perfect.angle_b,
            velocity_b: read.velocity_b - perfect.velocity_b,
        };
        sums.add(&off)?;
        let values = six(&off);
        let first = first.get_or_insert(values);
        for (change, (value, first)) in changes.iter_mut().zip(values.iter().zip(first.iter())) {
            *change |= value != first;
        }
    }
    let mut axes = sums.points()?;
    for (points, changes) in axes.iter_mut().zip(changes) {
        if !changes {
            points.clear();
        }
    }
    let mut said = Vec::new();
    if stream.saturated() > 0 {
        let samples = stream.saturated();
        said.push(format!(
            "a sensor was at its limit in {samples} samples, which look like errors"
        ));
    }
    let shows =
        |errors: &crate::scene::SensorErrors| TERMS.iter().any(|term| term.follows_motion(errors));
    if !source.is_constant() && (shows(&scene.gyro) || shows(&scene.accelerometer)) {
        said.push(
            "the scene moves: what its motion makes of scale factor, misalignment, g-sensitivity, bandwidth and latency is in the deviation"
                .to_owned(),
        );
    }
    let timing = Timing::new(interval_s, samples).map_err(SourceError::Sensor)?;
    Ok(Record { timing, axes, said })
}

/// Why a scene has no deviation.
#[derive(Debug)]
pub enum SceneError {
    /// The core cannot build it.
    Source(SourceError),
    /// Its samples say nothing.
    Complaint(Complaint),
}

impl From<SourceError> for SceneError {
    fn from(error: SourceError) -> Self {
        Self::Source(error)
    }
}

impl From<Complaint> for SceneError {
    fn from(complaint: Complaint) -> Self {
        Self::Complaint(complaint)
    }
}

fn too_few(samples: u64) -> Complaint {
    let accepted = format!("{FEWEST} samples or more, and a thousand for an interval worth having");
    Complaint::new(format!("has {samples} samples"), accepted)
}

/// A recording at rest, or a span of it, s. Rates are taken as means over their samples.
pub fn of_recording(
    recording: &Recording,
    rate_hz: Option<f64>,
    span_s: Option<[f64; 2]>,
) -> Result<Record, InputError> {
    let name = recording.name.as_str();
    let [from_s, to_s] = span_s.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    let survey = Survey::of(recording, rate_hz.map(|rate_hz| 1.0 / rate_hz), (from_s, to_s))?;
    let interval_s = survey.clock.interval_s();
    let refuse = |complaint| InputError::file(name, complaint);
    if let Some([from_s, to_s]) = span_s
        && (from_s >= survey.end_s || to_s <= survey.start_s)
    {
        let [start, end] = [survey.start_s, survey.end_s].map(parameter);
        let complaint =
            Complaint::new("holds nothing of the recording", format!("within {start}..{end}"));
        return Err(InputError::option("--span", complaint));
    }
    let mut said = survey.said(recording);
    let mut timeline = Timeline::new(recording, survey.habits, timeline::EVERY)?;
    let mut gathering = Gathering::new(interval_s).map_err(refuse)?;
    let start_s = survey.start_s.max(from_s);
    let mut still = Stillness::new(start_s, interval_s);
    let (mut force, mut end_s) = (Increment::ZERO, start_s);
    while let Some(row) = timeline.advance()? {
        // A sample's stamp is its end.
        if row.time_s <= from_s + 0.5 * interval_s || row.time_s > to_s + 1e-6 * interval_s {
            continue;
        }
        if let Some(misfit) = row.unread.first().filter(|_| gathering.samples() > 0) {
            return Err(misfit.error.clone());
        }
        if row.missing > 0 && gathering.samples() > 0 {
            let at = parameter(row.time_s);
            let missing = counted(row.missing, "sample is", "samples are");
            let what = format!("{missing} missing before {at} s");
            let accepted = format!(
                "a span without gaps, as in --span {}..{}",
                parameter(start_s),
                parameter(end_s)
            );
            return Err(InputError::line(name, row.line, Complaint::new(what, accepted)));
        }
        let values = match recording.kind {
            Kind::Increments => row.values,
            Kind::Rates => Increment {
                angle_b: row.values.angle_b * interval_s,
                velocity_b: row.values.velocity_b * interval_s,
            },
        };
        still.add(&values);
        force.velocity_b = force.velocity_b + values.velocity_b;
        gathering
            .add(six(&values))
            .map_err(|complaint| InputError::line(name, row.line, complaint))?;
        end_s = row.time_s;
    }
    let samples = gathering.samples();
    if samples < FEWEST {
        return Err(refuse(too_few(samples)));
    }
    let force = force.velocity_b.norm() / (samples as f64 * interval_s);
    if let Some(warning) = contradiction(force, recording.kind, interval_s)? {
        said.push(warning);
    }
    let motion = still.motion();
    if let Some(([first_s, last_s], axis)) = motion.first() {
        let more = match motion.len() {
            1 => String::new(),
            n => {
                let until = parameter(motion[n - 1].0[1]);
                format!(", and {} more until {until} s", counted(n as u64 - 1, "time", "times"))
            }
        };
        let [first, last] = [*first_s, *last_s].map(parameter);
        let what = format!("moves from {first} to {last} s ({axis}){more}");
        let [rest, end] = still.longest_rest(end_s).map(parameter);
        if span_s.is_none() {
            let accepted = format!("a span at rest; the longest is --span {rest}..{end}");
            return Err(refuse(Complaint::new(what, accepted)));
        }
        // Who names a span knows of it; a vehicle on its springs never rests.
        said.push(format!(
            "the unit {what}, which looks like errors; the longest rest is {rest}..{end} s"
        ));
    }
    let axes = gathering.points();
    for (points, axis) in axes.iter().zip(AXES) {
        if points.is_empty() {
            said.push(format!("{axis} reads the same at every sample: nothing is told of it"));
        }
    }
    if axes.iter().all(Vec::is_empty) {
        let what = "reads the same at every sample, on every axis";
        return Err(refuse(Complaint::new(what, "a recording of a sensor that is on")));
    }
    if recording.kind == Kind::Rates {
        said.push("rates are taken as means over their samples".to_owned());
    }
    let timing = Timing::new(interval_s, samples);
    let timing = timing.map_err(|e| refuse(Complaint::new(e.to_string(), "")))?;
    Ok(Record { timing, axes, said })
}

/// What gravity says of the numbers: an error where they are of the other kind, a warning where they are of
/// another unit.
fn contradiction(force: f64, said: Kind, interval_s: f64) -> Result<Option<String>, InputError> {
    let like_gravity = |force: f64| (force / STANDARD_GRAVITY - 1.0).abs() < GRAVITY;
    if like_gravity(force) {
        return Ok(None);
    }
    if like_gravity(force * said.mistaken(interval_s).recip())
        || like_gravity(force * said.mistaken(interval_s))
    {
        let [own, other] = match said {
            Kind::Increments => ["increments", "rates"],
            Kind::Rates => ["rates", "increments"],
        };
        let what = format!(
            "mean specific force is {} m/s² where gravity is 9.8: these look like {other}, taken for {own}",
            parameter(force)
        );
        return Err(InputError::option("--imu", Complaint::new(what, format!("--units {other}"))));
    }
    let force = parameter(force);
    Ok(Some(format!(
        "mean specific force is {force} m/s², not gravity: not at rest on the ground, or in other units (--units)"
    )))
}
