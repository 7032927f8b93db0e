//! Where an aided replay starts, and how well that is known.

use super::given::Given;
use crate::cli::ReplayArgs;
use crate::replay::initial;
use crate::replay::spans::Spans;
use schuler::aiding::aided::measured::Kind;
use schuler::alignment::place::Place;
use schuler::drift::compare::drift;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::solution::Euler;
use schuler_simulator::aided::told::Told;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::say;
use schuler_simulator::recording::navigation::NavigationRow;
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::Samples;
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::units::DEGREE;

/// A vehicle of this speed goes where it points, m/s.
const FAST: f64 = 3.0;
/// The next fix, by which the acceleration is known, comes within this, s.
const NEXT_S: f64 = 1.5;
/// First standard deviations by velocity and specific force: level and heading, rad.
const BY_FIX: [f64; 2] = [3.0 * DEGREE, 10.0 * DEGREE];
/// Those of a state that is given, of which nothing is said: m, m/s, rad, rad.
pub const GIVEN: [f64; 4] = [10.0, 1.0, 2.0 * DEGREE, 10.0 * DEGREE];
/// An attitude that does not count.
const LEVEL: Euler<f64> = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
/// Those at rest, beside what the alignment says: m, m/s, rad, rad.
pub const AT_REST: [f64; 4] = [5.0, 0.05, 1.0 * DEGREE, 5.0 * DEGREE];

/// How it starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum How {
    /// From a state that is given.
    Given,
    /// At rest, aligned.
    Rest,
    /// By a fix, with its standard deviations.
    Fix([f64; 4]),
}

/// A start.
pub struct Beginning {
    /// The state, or its place alone where it is aligned.
    pub row: NavigationRow,
    /// The options as they then are.
    pub args: ReplayArgs,
    /// The spans of the recording.
    pub spans: Spans,
    /// How.
    pub how: How,
}

/// By `--initial`, else by `--align` at the nearest fix, else by the first fix that is fast.
pub fn beginning(
    args: &ReplayArgs,
    recording: &Recording,
    survey: &Survey,
    given: &Given,
) -> Result<Beginning, InputError> {
    if args.initial.is_some() || recording.initial.is_some() {
        let (row, args) = initial::initial(args, recording)?;
        let spans = Spans::new(&args, survey, &row)?;
        let how = if args.align.is_some() { How::Rest } else { How::Given };
        return Ok(Beginning { row, args, spans, how });
    }
    if let Some(align_s) = args.align {
        let at_s = args.start.unwrap_or(survey.start_s) + align_s;
        let off = |told: &&&Told| (told.time_s - at_s).abs();
        let positions = given.fixes.positions();
        let nearest = positions.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let Some(told) = nearest else {
            let complaint = Complaint::new("has no position", "one or more");
            return Err(InputError::file(&given.fixes.name, complaint));
        };
        let row = row(told, at_s, LEVEL);
        let row = NavigationRow { velocity_ned: Vector::ZERO, ..row };
        say(&format!("{}:{}: place of the alignment\n", given.fixes.name, told.line))?;
        let spans = Spans::new(args, survey, &row)?;
        return Ok(Beginning { row, args: args.clone(), spans, how: How::Rest });
    }
    by_fix(args, recording, survey, given)
}

fn row(told: &Told, time_s: f64, attitude: Euler<f64>) -> NavigationRow {
    let position = told.measured.position.map(|c| c.hi);
    let [north, east] = told.north_east().unwrap_or_default();
    let down = told.measured.velocity.z;
    NavigationRow { time_s, position, velocity_ned: Vector::new(north, east, down), attitude }
}

/// A fix, and how fast it moves.
#[derive(Clone, Copy)]
struct Moving<'a> {
    told: &'a Told,
    velocity_ned: Vector<f64>,
    /// Whether the fix itself tells the whole velocity.
    is_measured: bool,
}

impl Moving<'_> {
    fn speed(&self) -> f64 {
        self.velocity_ned.x.hypot(self.velocity_ned.y)
    }
}

/// By its own velocity, else by the fixes before and after it.
fn moving<'a>(positions: &[&'a Told], i: usize) -> Option<Moving<'a>> {
    let told = *positions.get(i)?;
    let is_measured = told.measured.kind == Kind::PositionVelocity;
    let velocity_ned = if let Some([north, east]) = told.north_east() {
        Vector::new(north, east, told.measured.velocity.z)
    } else {
        let (before, after) = (positions.get(i.checked_sub(1)?)?, positions.get(i + 1)?);
        let time_s = after.time_s - before.time_s;
        if !(time_s > 0.0 && time_s <= 2.0 * NEXT_S) {
            return None;
        }
        let place = |told: &Told| row(told, told.time_s, LEVEL).solution();
        drift(&place(after), &place(before)).position_ned * (1.0 / time_s)
    };
    Some(Moving { told, velocity_ned, is_measured })
}

fn by_fix(
    args: &ReplayArgs,
    recording: &Recording,
    survey: &Survey,
    given: &Given,
) -> Result<Beginning, InputError> {
    let from_s = args.start.unwrap_or(f64::NEG_INFINITY).max(survey.start_s);
    let to_s = args.until.unwrap_or(f64::INFINITY).min(survey.end_s);
    let positions = given.fixes.positions();
    let moving: Vec<_> = (0..positions.len()).filter_map(|i| moving(&positions, i)).collect();
    let within = |one: &Moving| one.told.time_s >= from_s && one.told.time_s <= to_s;
    let fast = moving.iter().enumerate().filter(|(_, one)| within(one) && one.speed() >= FAST);
    let pair = fast.filter_map(|(i, one)| {
        // The last of those in reach: noise counts least then.
        let after = moving.iter().skip(i + 1).take_while(|next| {
            within(next) && next.speed() >= FAST && next.told.time_s - one.told.time_s <= NEXT_S
        });
        let next = after.last().filter(|next| next.told.time_s > one.told.time_s);
        next.map(|next| [*one, *next])
    });
    let Some([now, next]) = pair.into_iter().next() else {
        let what = format!(
            "is missing, and no two fixes within {NEXT_S} s from {from_s} to {to_s} s make a velocity above {FAST} m/s to start with"
        );
        let accepted = "--initial FILE, or --align S where the vehicle stands (with --heading DEG if the gyros do not find north)";
        return Err(InputError::option("--initial", Complaint::new(what, accepted)));
    };
    let fix = now.told;
    let begin_s = boundary(recording, survey, fix.time_s)?;
    let force_b = mean_force(recording, survey, [begin_s, next.told.time_s])?;
    let place = Place::new(fix.measured.position.map(|c| c.hi));
    let attitude = attitude(now, next, force_b, place.gravity);
    let row = NavigationRow { velocity_ned: now.velocity_ned, ..row(fix, begin_s, attitude) };
    let sigma = &fix.measured;
    let most = |v: Vector<f64>| v.into_array().into_iter().fold(0.0, f64::max);
    let moved = now.speed() * survey.clock.interval_s() + given.settings.lever_b.norm();
    let [level, heading] = BY_FIX;
    let velocity = if now.is_measured { most(sigma.velocity_sigma) + 0.1 } else { 0.5 };
    let how = How::Fix([most(sigma.position_sigma) + moved, velocity, level, heading]);
    say(&format!(
        "{}:{}: starts at {:.3} s with {:.1} m/s: heading {:.1}° by the velocity, roll {:.1}°, pitch {:.1}° by the specific \
         force (1σ: {:.0}°, {:.0}°)\n",
        given.fixes.name,
        fix.line,
        begin_s,
        now.speed(),
        (attitude.yaw / DEGREE).rem_euclid(360.0),
        attitude.roll / DEGREE,
        attitude.pitch / DEGREE,
        heading / DEGREE,
        level / DEGREE,
    ))?;
    let spans = Spans::from_fix(args, survey, begin_s)?;
    Ok(Beginning { row, args: args.clone(), spans, how })
}

/// The beginning of the sample that begins nearest to a time, s.
fn boundary(recording: &Recording, survey: &Survey, time_s: f64) -> Result<f64, InputError> {
    let mut samples = Samples::new(recording, survey, None)?;
    let mut nearest_s = f64::INFINITY;
    while let Some(sample) = samples.advance()? {
        let begin_s = sample.end_s - sample.interval_s;
        if (begin_s - time_s).abs() < (nearest_s - time_s).abs() {
            nearest_s = begin_s;
        }
        if begin_s > time_s {
            break;
        }
    }
    Ok(nearest_s)
}

/// The mean specific force between two times, m/s².
fn mean_force(
    recording: &Recording,
    survey: &Survey,
    [from_s, to_s]: [f64; 2],
) -> Result<Vector<f64>, InputError> {
    let mut samples = Samples::new(recording, survey, None)?;
    let (mut sum, mut time_s) = (Vector::ZERO, 0.0);
    while let Some(sample) = samples.advance()? {
        let middle_s = sample.end_s - 0.5 * sample.interval_s;
        if middle_s > to_s {
            break;
        }
        if middle_s > from_s {
            sum = sum + sample.increment.velocity_b;
            time_s += sample.interval_s;
        }
    }
    Ok(sum * (1.0 / time_s.max(f64::MIN_POSITIVE)))
}

/// The heading of a velocity, and the least turn that makes the mean specific force what the change of velocity and
/// gravity are: f = a − g.
fn attitude(from: Moving, to: Moving, force_b: Vector<f64>, gravity: f64) -> Euler<f64> {
    let (now, then) = (from.velocity_ned, to.velocity_ned);
    let change = (then - now) * (1.0 / (to.told.time_s - from.told.time_s));
    let yaw = now.y.atan2(now.x);
    let (sine, cosine) = yaw.sin_cos();
    let force = Vector::new(
        change.x * cosine + change.y * sine,
        change.y * cosine - change.x * sine,
        change.z - gravity,
    );
    let unit = |v: Vector<f64>| v * (1.0 / v.norm().max(f64::MIN_POSITIVE));
    let (a, b) = (unit(force_b), unit(force));
    // q = (1 + a·b, a × b), normalised, turns a to b
    let level = Quaternion::new(1.0 + a.dot(b), a.cross(b)).normalised();
    let Euler { roll, pitch, .. } = Euler::from_quaternion(level);
    Euler { roll, pitch, yaw }
}
