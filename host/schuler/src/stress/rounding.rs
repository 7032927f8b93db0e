//! Rounding: the same flight with every operation rounded at random, for many seeds. The spread of the runs
//! shows how many digits of each output are trustworthy.
//!
//! A sum that rounds at random has a spread of ulp/√6 on average, and n of them of √(n/6) ulps. Compensated
//! sums carry more than a double prints, so theirs may exceed sixteen digits: what is left there is the
//! rounding of the increments.

use super::case::{Case, Check, Outcome};
use super::floor;
use super::flown::built_in;
use schuler::earth::{EQUATORIAL_GRAVITY, SEMI_MAJOR_AXIS};
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::window;
use schuler_simulator::navigator::compared::Arithmetic;
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::rounding::{Window, fly};
use schuler_simulator::scene::{Axes, Precision};
use schuler_simulator::source::Source;

const GROUP: &str = "rounding";
const SEEDS: u64 = 32;

/// The arithmetic and axes of a flight.
#[derive(Clone, Copy)]
struct Kind(Arithmetic, Axes);

impl Kind {
    const ALL: [Self; 6] = [
        Self(Arithmetic::PlainDouble, Axes::LocalLevel),
        Self(Arithmetic::Named(Precision::F64), Axes::LocalLevel),
        Self(Arithmetic::PlainDouble, Axes::EarthFixed),
        Self(Arithmetic::Named(Precision::F64), Axes::EarthFixed),
        Self(Arithmetic::PlainSingle, Axes::LocalLevel),
        Self(Arithmetic::Named(Precision::F32), Axes::LocalLevel),
    ];

    /// Whether the state is compensated.
    fn is_compensated(self) -> bool {
        matches!(self.0, Arithmetic::Named(_))
    }

    /// Whether positions are of the Earth's size.
    fn is_earth_sized(self) -> bool {
        self.1 == Axes::EarthFixed
    }

    /// An ulp of 1.
    fn unit(self) -> f64 {
        if self.0.is_double() { f64::EPSILON } else { f32::EPSILON.into() }
    }
}

/// The group's cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for (scene, seconds, long) in [("manoeuvre", 20.0, false), ("paper-perfect", 1800.0, true)] {
        for kind in Kind::ALL {
            let Kind(arithmetic, axes) = kind;
            let sums = if kind.is_compensated() { "compensated" } else { "plain" };
            let what = format!("{axes} {} {sums}", arithmetic.precision());
            let name = format!("{scene} {seconds} s, {what}");
            let case = Case::new(GROUP, name, move |p| spread(kind, scene, seconds, p));
            cases.push(if long { case.long() } else { case });
        }
    }
    cases
}

/// Digits of every output, by the spread over the seeds.
fn spread(kind: Kind, scene: &str, seconds: f64, progress: &CaseProgress) -> Outcome {
    let scene = built_in(scene, |scene| scene.duration_s = seconds)?;
    let source = Source::new(&scene, false).map_err(|error| error.to_string())?;
    let samples: Vec<_> = (1..=scene.samples()).map(|n| source.perfect_sample(n)).collect();
    let initial = source.initial(0);
    let interval_s = Pair::new(scene.rate_hz).reciprocal();
    let mut ends = Vec::new();
    for seed in 1..=SEEDS {
        let Kind(arithmetic, axes) = kind;
        let mut reach =
            |n| progress.reach((seed - 1) * scene.samples() + n, SEEDS * scene.samples());
        ends.push(fly(arithmetic, axes, seed, &samples, &initial, interval_s, &mut reach)?);
    }
    let measured = Five::spread(&ends);
    let size = Five::size(&ends[0]);
    let bound = Motion::of(&source, &samples, seconds).spread(kind, &ends[0]);
    // Where every run ends alike, all that a double prints can be trusted.
    let digits = |size: f64, sigma: f64| (size / (2.0 * sigma)).log10();
    let seen = |size: f64, sigma: f64| {
        if sigma == 0.0 { -floor::UNIT.log10() } else { digits(size, sigma) }
    };
    let why = "√(cn/6) ulps of the state (c = 1) and of its increments (c = 8), twice over";
    let row = |(i, what): (usize, &str)| {
        let least = digits(size.0[i], 2.0 * bound.0[i]);
        Check::at_least(what, least, seen(size.0[i], measured.0[i]), "digits", why)
    };
    let names = ["latitude", "longitude", "height", "velocity", "attitude"];
    Ok(names.into_iter().enumerate().map(row).collect())
}

/// Latitude and longitude in rad, height in m, |velocity| in m/s, attitude in rad.
struct Five([f64; 5]);

impl Five {
    /// The outputs' own size: what their digits are counted from.
    fn size(end: &Solution<f64>) -> Self {
        let (p, v) = (end.position.map(|c| c.hi), end.velocity_ned.map(|c| c.hi));
        Self([p.latitude.abs(), p.longitude.abs(), p.altitude.abs(), v.norm(), 1.0])
    }

    /// Standard deviations over some ends.
    fn spread(ends: &[Solution<f64>]) -> Self {
        let first = ends[0];
        // Against the first run, without cancellation: two-float coordinates may agree to a double's end.
        let off = |a: Pair<f64>, b: Pair<f64>| (a.hi - b.hi) + (a.lo - b.lo);
        let columns = ends.iter().map(|end| {
            let (p, q) = (end.position, first.position);
            let v = end.velocity_ned.zip(first.velocity_ned, off);
            let [a, b] = [end.attitude, first.attitude];
            let Quaternion { w, v: x } = Quaternion::new(off(a.w, b.w), a.v.zip(b.v, off));
            let position = [
                off(p.latitude, q.latitude),
                off(p.longitude, q.longitude),
                off(p.altitude, q.altitude),
            ];
            // A rotation by a small angle is twice its quaternion's difference.
            (position, v, [2.0 * w, 2.0 * x.x, 2.0 * x.y, 2.0 * x.z])
        });
        let columns: Vec<_> = columns.collect();
        let sigma = |of: &dyn Fn(usize) -> f64| {
            let count = columns.len() as f64;
            let mean = (0..columns.len()).map(of).sum::<f64>() / count;
            let squares = (0..columns.len()).map(|i| (of(i) - mean).powi(2)).sum::<f64>();
            (squares / (count - 1.0)).sqrt()
        };
        let position = |axis: usize| sigma(&|i| columns[i].0[axis]);
        let velocity = Vector::new(
            sigma(&|i| columns[i].1.x),
            sigma(&|i| columns[i].1.y),
            sigma(&|i| columns[i].1.z),
        );
        let attitude: f64 = (0..4).map(|part| sigma(&|i| columns[i].2[part]).powi(2)).sum();
        Self([position(0), position(1), position(2), velocity.norm(), attitude.sqrt()])
    }
}

/// What a flight's roundings scale with.
struct Motion {
    time_s: f64,
    blocks: f64,
    /// Rms of |Δθ| and |Δv| of a block, rad and m/s.
    angle: f64,
    velocity: f64,
    /// Largest speed, m/s.
    speed: f64,
}

impl Motion {
    fn of(source: &Source, samples: &[Increment<f64>], time_s: f64) -> Self {
        let block = <Window as window::Window>::BLOCK as f64;
        let rms = |of: &dyn Fn(&Increment<f64>) -> f64| {
            (samples.iter().map(|s| of(s).powi(2)).sum::<f64>() / samples.len() as f64).sqrt()
        };
        let speed = (0..samples.len() as u64)
            .step_by(100)
            .map(|n| source.motion(n).velocity_ned().norm())
            .fold(0.0, f64::max);
        Self {
            time_s,
            blocks: samples.len() as f64 / block,
            angle: block * rms(&|s| s.angle_b.norm()),
            velocity: block * rms(&|s| s.velocity_b.norm()),
            speed,
        }
    }

    /// The spread to expect of an end, from the sizes of what is rounded and how often.
    fn spread(&self, kind: Kind, end: &Solution<f64>) -> Five {
        let unit = kind.unit();
        let Self { time_s, blocks, angle, velocity, speed } = *self;
        let walk = |roundings: f64| (roundings * blocks / 6.0).sqrt();
        // A plain state is rounded to itself, a compensated one only as its increments are.
        let rounded = |state: f64, increment: f64| {
            let state = if kind.is_compensated() { 0.0 } else { unit * state * walk(1.0) };
            state.hypot(unit * increment * walk(floor::ROUNDINGS))
        };
        // Four components, each counting twice as an angle.
        let attitude = 4.0 * rounded(1.0, 0.5 * angle);
        // Earth-fixed velocities contain the Earth's own.
        let earth = if kind.is_earth_sized() { 465.0 } else { 0.0 };
        let force = velocity * blocks / time_s;
        let rounding = 3.0_f64.sqrt() * rounded(speed + earth, velocity);
        // An error of the attitude turns gravity into the level, and only what else is felt into the
        // vertical; the level holds, the vertical grows.
        let mean = time_s / 3.0_f64.sqrt();
        let kappa = floor::vertical_rate(0.0);
        let growth = (kappa * time_s).cosh();
        let beyond_gravity = (force - EQUATORIAL_GRAVITY).max(0.0);
        let level = rounding.hypot(force * attitude * mean);
        let vertical = rounding.hypot(beyond_gravity * attitude * mean) * growth;
        // Earth-fixed axes read a block's time to its leading part: one rounding for all of a run, and of
        // gravity's product with it.
        let (fallen, falling) = if kind.is_earth_sized() {
            let pull = unit * EQUATORIAL_GRAVITY / 6.0_f64.sqrt();
            (pull * (growth - 1.0) / (kappa * kappa), pull * (kappa * time_s).sinh() / kappa)
        } else {
            (0.0, 0.0)
        };
        let position = end.position.map(|c| c.hi.abs());
        let step = (speed + earth) * time_s / blocks;
        let cosine = position.latitude.cos();
        // Earth-fixed coordinates are printed from their leading parts.
        let printed = |size: f64| if kind.is_earth_sized() { 2.0 * unit * size } else { 0.0 };
        let sigma = |state: f64, scale: f64, carried: f64| {
            let radius = SEMI_MAJOR_AXIS * scale;
            let state = if kind.is_earth_sized() { radius } else { state };
            rounded(state, step * scale).hypot(carried * scale).hypot(printed(radius))
        };
        Five([
            sigma(position.latitude, 1.0 / SEMI_MAJOR_AXIS, level * mean),
            sigma(position.longitude, 1.0 / (SEMI_MAJOR_AXIS * cosine), level * mean),
            sigma(position.altitude, 1.0, (vertical * mean).hypot(fallen)),
            level.hypot(vertical).hypot(falling),
            attitude.hypot(level * mean / SEMI_MAJOR_AXIS).hypot(printed(1.0)),
        ])
    }
}
