//! A drive: a harmonic course of 4 to 46 m/s with a MEMS unit and a receiver of 1 Hz, and how an aided navigator
//! does on it.

use super::figures::{Flown, Read};
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::Measured;
use schuler::aiding::aided::navigator::Aided;
use schuler::aiding::aided::settings::{Settings, Start, States};
use schuler::aiding::aided::state::AidedState;
use schuler::aiding::aided::verdict::{Verdict, Witness};
use schuler::aiding::states::Process;
use schuler::drift::compare::drift;
use schuler::earth::Radii;
use schuler::imu::Quadrature;
use schuler::math::real::{Real, Scalar};
use schuler::noise::{Stream, Streams};
use schuler::prelude::*;
use schuler::sensor::aiding::gnss::Gnss;
use schuler::sensor::aiding::line::{Line, Outage};
use schuler::sensor::aiding::truth::Truth as Motion;
use schuler::strapdown::block::body::BodyMotion;
use schuler::trajectory::Trajectory;
use schuler::trajectory::harmonic::{Channel, Channels, Harmonic, HarmonicTrajectory};
use schuler::units::{DEGREE, DEGREE_PER_HOUR};

pub const RATE_HZ: f64 = 100.0;
pub const LEVER: Vector<f64> = Vector::new(0.5, -0.3, -1.0);
pub const GYRO_BIAS: f64 = 10.0 * DEGREE_PER_HOUR;
pub const ACCELEROMETER_BIAS: f64 = 1e-3;
pub const GYRO_NOISE: f64 = 0.1 * DEGREE / 60.0;
pub const ACCELEROMETER_NOISE: f64 = 0.05 / 60.0;
pub const POSITION_SIGMA: f64 = 1.0;
pub const VELOCITY_SIGMA: f64 = 0.05;
/// Without fixes, s: after the first, up to the second.
pub const OUTAGE: [f64; 2] = [400.0, 460.0];

pub fn three<T: Copy>(x: T) -> Vector<T> {
    Vector::new(x, x, x)
}

/// The course.
pub fn course() -> HarmonicTrajectory<f64, 16> {
    let latitude = 45.0 * DEGREE;
    let radii = Radii::at(latitude.sin(), latitude.cos());
    let east = radii.prime_vertical * latitude.cos();
    let wave = |amplitude: f64, period: f64, phase: f64| Harmonic {
        amplitude,
        angular_rate: core::f64::consts::TAU / period,
        phase,
    };
    let channel = Channel::constant;
    let roll = [wave(2.0 * DEGREE, 23.0, 0.1)];
    let pitch = [wave(1.5 * DEGREE, 37.0, 0.7)];
    let yaw = [wave(70.0 * DEGREE, 120.0, 0.3), wave(10.0 * DEGREE, 41.0, 0.1)];
    let north = [wave(500.0 / radii.meridian, 120.0, 0.0), wave(30.0 / radii.meridian, 31.0, 0.4)];
    let along = [wave(700.0 / east, 170.0, 0.7), wave(40.0 / east, 29.0, 0.8)];
    let up = [wave(20.0, 200.0, 0.0), wave(1.0, 13.0, 0.0)];
    HarmonicTrajectory::new(Channels {
        roll: Channel { harmonics: &roll, ..channel(0.0) },
        pitch: Channel { harmonics: &pitch, ..channel(0.0) },
        yaw: Channel { harmonics: &yaw, ..channel(60.0 * DEGREE) },
        latitude: Channel { harmonics: &north, ..channel(latitude) },
        longitude: Channel { harmonics: &along, ..channel(8.0 * DEGREE) },
        altitude: Channel { harmonics: &up, ..channel(200.0) },
    })
    .unwrap()
}

/// The truth: increments, and the solution and the motion at the end of each from the start on.
pub struct Truth {
    pub increments: Vec<Increment<f64>>,
    pub solutions: Vec<Solution<f64>>,
    pub motions: Vec<Motion<f64>>,
}

pub fn truth(seconds: f64) -> Truth {
    truth_of(&course(), seconds)
}

pub fn truth_of(flight: &impl Trajectory<f64>, seconds: f64) -> Truth {
    let quadrature = Quadrature::plan(flight.bound().bandwidth, 1.0 / RATE_HZ);
    let samples = (seconds * RATE_HZ).round() as u64;
    let at = |k: u64| schuler::imu::instant(k as f64, RATE_HZ);
    let solutions: Vec<_> = (0..=samples).map(|k| flight.initial_at(at(k))).collect();
    let motion = |(solution, k): (&Solution<f64>, u64)| {
        Motion::of(solution, flight.rates_at(at(k)).rate_ib_b)
    };
    Truth {
        increments: (1..=samples).map(|k| quadrature.sample(flight, k, RATE_HZ)).collect(),
        motions: solutions.iter().zip(0..).map(motion).collect(),
        solutions,
    }
}

/// The receiver of the drive.
pub fn receiver() -> Gnss<f64> {
    let outage = Outage { from_s: OUTAGE[0], until_s: OUTAGE[1] };
    let line = Line::every(1.0).with_outage(outage).unwrap();
    Gnss { lever_b: LEVER, ..Gnss::new(line, POSITION_SIGMA, VELOCITY_SIGMA) }
}

/// A run of the drive.
#[derive(Clone)]
pub struct Run {
    pub number: u64,
    pub samples: Vec<Increment<f64>>,
    pub start: Solution<f64>,
}

fn deviates(stream: &mut Stream, sigma: f64) -> Vector<f64> {
    Vector::new(stream.normal::<f64>(), stream.normal(), stream.normal()) * sigma
}

/// Moves a position by metres.
pub fn moved(at: &Geodetic<Pair<f64>>, way: Vector<f64>) -> Geodetic<Pair<f64>> {
    let latitude = at.latitude.hi;
    let radii = Radii::at(latitude.sin(), latitude.cos());
    let h = at.altitude.hi;
    let add = |to: Pair<f64>, x: f64| to + Pair::new(x);
    Geodetic {
        latitude: add(at.latitude, way.x / (radii.meridian + h)),
        longitude: add(at.longitude, way.y / ((radii.prime_vertical + h) * latitude.cos())),
        altitude: add(at.altitude, -way.z),
    }
}

/// The readings of a run. `heading` is the standard deviation of the first one, rad.
pub fn run(truth: &Truth, number: u64, heading: f64) -> Run {
    let h = 1.0 / RATE_HZ;
    let root = Streams::new(2026, number).branch(17);
    let mut stream = root.branch(0).open();
    let gyro = deviates(&mut stream, GYRO_BIAS);
    let force = deviates(&mut stream, ACCELEROMETER_BIAS);
    let mut samples = Vec::with_capacity(truth.increments.len());
    for perfect in &truth.increments {
        samples.push(Increment {
            angle_b: perfect.angle_b + gyro * h + deviates(&mut stream, GYRO_NOISE * h.sqrt()),
            velocity_b: perfect.velocity_b
                + force * h
                + deviates(&mut stream, ACCELEROMETER_NOISE * h.sqrt()),
        });
    }
    let mut stream = root.branch(2).open();
    let place = deviates(&mut stream, POSITION_SIGMA);
    let velocity = deviates(&mut stream, 0.1);
    let tilt = deviates(&mut stream, 1.0);
    let turn = Vector::new(tilt.x * 0.2 * DEGREE, tilt.y * 0.2 * DEGREE, tilt.z * heading);
    let first = &truth.solutions[0];
    let start = Solution {
        position: moved(&first.position, place),
        velocity_ned: first.velocity_ned.zip(velocity, |v, e| v + Pair::new(e)),
        attitude: turned(turn) * first.attitude,
    };
    Run { number, samples, start }
}

/// The rotation by a vector.
fn turned(vector: Vector<f64>) -> Quaternion<Pair<f64>> {
    let angle = vector.norm().max(1e-300);
    let axis = vector * (1.0 / angle);
    Quaternion::new((0.5 * angle).cos(), axis * (0.5 * angle).sin()).map(Pair::new)
}

/// The settings that fit the drive.
pub fn settings<R: Scalar>(heading: f64) -> Settings<R> {
    let of = |x: f64| R::narrow(x);
    let states = States::new(
        of(GYRO_NOISE),
        of(ACCELEROMETER_NOISE),
        Process::constant(of(GYRO_BIAS)),
        Process::constant(of(ACCELEROMETER_BIAS)),
    );
    let start = Start {
        position_m: of(POSITION_SIGMA),
        velocity_m_s: of(0.1),
        level_rad: of(0.2 * DEGREE),
        heading_rad: of(heading),
    };
    Settings { lever_b: LEVER.map(R::narrow), ..Settings::new(states, start) }
}

/// A measurement with the second at which it arrives.
pub type Arriving<R> = (f64, Measured<R>);

/// What a receiver delivers in a run, sorted by its arrival.
pub fn heard<R: Scalar>(gnss: &Gnss<f64>, run: &Run, truth: &Truth) -> Vec<Arriving<R>> {
    let gnss = gnss.checked().unwrap();
    let mut state = gnss.start(2026, run.number);
    let mut all = Vec::new();
    loop {
        let at_s = gnss.line.epoch_s(&state.line);
        let at = Instant::from_seconds(at_s, RATE_HZ).unwrap();
        let Some(motion) = truth.motions.get(at.samples as usize) else { break };
        assert_eq!(at.part, 0.0);
        let Some(delivered) = gnss.measure(&mut state, motion, at) else { continue };
        let measured = narrowed(&delivered.measured);
        all.push((delivered.arrives_s, measured));
        all.extend(delivered.again_s.map(|again_s| (again_s, measured)));
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all
}

/// A measurement in another precision.
pub fn narrowed<R: Scalar>(m: &Measured<f64>) -> Measured<R> {
    Measured {
        at: Instant { samples: m.at.samples, part: R::narrow(m.at.part) },
        kind: m.kind,
        position: m.position.map(Pair::narrow),
        velocity: m.velocity.map(R::narrow),
        position_sigma: m.position_sigma.map(R::narrow),
        velocity_sigma: m.velocity_sigma.map(R::narrow),
    }
}

/// Keeps every verdict.
pub struct Verdicts(pub Vec<Verdict<f64>>);

impl<R: Scalar, const N: usize, const P: usize, const E: usize> Witness<R, N, P, E> for Verdicts {
    fn judged(&mut self, v: &Verdict<R>) {
        let Verdict { at, kind, accepted, locked_out, .. } = *v;
        let at = Instant { samples: at.samples, part: at.part.widen() };
        let (age_s, nis, limit) = (v.age_s.widen(), v.nis.widen(), v.limit.widen());
        self.0.push(Verdict { at, kind, age_s, nis, limit, accepted, locked_out });
    }
}

/// Flies a run with measurements that are sorted by their arrival.
pub fn fly<R, M, const N: usize, const P: usize, const E: usize, const L: usize, const Q: usize>(
    aided: &Aided<M, N, P, E, L, Q>,
    run: &Run,
    truth: &Truth,
    arriving: &[Arriving<R>],
) -> (Flown, AidedState<M, N, P, E, L, Q>)
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    let mut state = aided.start(&Solution::narrow(&run.start)).unwrap();
    let (mut reads, mut verdicts) = (Vec::new(), Verdicts(Vec::new()));
    let mut next = arriving.iter().peekable();
    for (k, sample) in run.samples.iter().enumerate() {
        let now = (k + 1) as f64 / RATE_HZ;
        while let Some((_, measured)) = next.next_if(|(arrival, _)| *arrival <= now + 1e-9) {
            // Refusals are counted.
            let _ = aided.measure(&mut state, measured);
        }
        let sample = Increment {
            angle_b: sample.angle_b.map(R::narrow),
            velocity_b: sample.velocity_b.map(R::narrow),
        };
        aided.push_seen(&mut state, sample, &mut verdicts).unwrap();
        if (k + 1) % RATE_HZ as usize == 0 {
            let solution = aided.output(&state).wide();
            let at = state.integrated() as usize;
            let drift = drift(&solution, &truth.solutions[at]);
            let parts = [drift.position_ned, drift.velocity_ned, drift.attitude_ned];
            let mut errors = [0.0; 9];
            for (e, x) in errors.iter_mut().zip(parts.into_iter().flat_map(Vector::into_array)) {
                *e = x;
            }
            let covariance = aided.covariance_ned(&state).map(|row| row.map(Scalar::widen));
            reads.push(Read { second: now, errors, covariance });
        }
    }
    (Flown { reads, verdicts: verdicts.0 }, state)
}
