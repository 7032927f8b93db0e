//! Runs flown side by side, one in each lane: every one has the bits of its run flown alone.

use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::{EarthFixedSolution, Solution};
use schuler::strapdown::earth_fixed::EarthFixed;
use schuler::strapdown::frame::Frame;
use schuler::strapdown::local_level::LocalLevel;
use schuler::strapdown::mechanization::Rejected;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::window::{H0B4A0, H2B4A2, Line8, Window};
use schuler_host::lanes::pack::{Four, Lanes, RUNS};
use schuler_host::lanes::{Abreast, InLanes, Split, in_registers, pack};
use schuler_host::scene::builtin;
use schuler_host::source::Source;
use std::array;

const SAMPLES: usize = 3001;
const ORDER: usize = 20;

/// Four runs with noise of their own, from places far apart.
struct Runs {
    interval_s: Pair<f64>,
    initial: [Solution<f64>; RUNS],
    samples: [Vec<Increment<f64>>; RUNS],
}

fn runs() -> Runs {
    let mut scene = builtin::scene("hard").unwrap();
    let paper = builtin::scene("paper").unwrap();
    (scene.gyro, scene.accelerometer) = (paper.gyro, paper.accelerometer);
    let source = Source::new(&scene, false).unwrap();
    let samples = array::from_fn(|run| {
        let mut stream = source.start(run as u64);
        (0..SAMPLES).map(|_| stream.advance().unwrap()).collect()
    });
    let initial = array::from_fn(|run| {
        let mut initial = source.motion(0).initial();
        initial.position.latitude.hi += 0.2 * run as f64;
        initial.position.longitude.lo = 1e-18 * run as f64;
        initial.velocity_ned.y.hi -= 30.0 * run as f64;
        initial
    });
    Runs { interval_s: Pair::new(scene.rate_hz).reciprocal(), initial, samples }
}

impl Runs {
    fn packed<P: Lanes>(&self) -> Vec<Increment<P>> {
        (0..SAMPLES).map(|n| pack(&array::from_fn(|run| self.samples[run][n]))).collect()
    }
}

fn bits(x: Pair<f64>) -> [u64; 2] {
    [x.hi.to_bits(), x.lo.to_bits()]
}

trait Bits {
    fn bits(&self) -> [[u64; 2]; 10];
}

impl Bits for Solution<f64> {
    fn bits(&self) -> [[u64; 2]; 10] {
        let (r, v, q) = (self.position, self.velocity_ned, self.attitude);
        [r.latitude, r.longitude, r.altitude, v.x, v.y, v.z, q.w, q.v.x, q.v.y, q.v.z].map(bits)
    }
}

impl Bits for EarthFixedSolution<f64> {
    fn bits(&self) -> [[u64; 2]; 10] {
        let (r, v, q) = (self.position_e, self.velocity_e, self.attitude);
        [r.x, r.y, r.z, v.x, v.y, v.z, q.w, q.v.x, q.v.y, q.v.z].map(bits)
    }
}

/// Flies the runs alone and together, and compares after pieces of many lengths and at the end.
fn same<F, P, W>(runs: &Runs)
where
    F: Frame<Real = f64, Output: Bits>,
    P: Frame<Real: Lanes, Output: Split<Alone = F::Output>>,
    W: Window,
{
    let alone = Strapdown::<F, W>::new(runs.interval_s).unwrap().with_order(ORDER);
    let mut states = runs.initial.map(|initial| alone.start(&initial).unwrap());
    let mut lanes = Abreast::<P, W>::start(runs.interval_s, ORDER, &runs.initial).unwrap();
    let packed = runs.packed();
    let compare = |lanes: &Abreast<P, W>, states: &[_; RUNS]| {
        for (run, (together, state)) in lanes.output().iter().zip(states).enumerate() {
            let state: &schuler::strapdown::navigator::State<F, W> = state;
            assert_eq!(lanes.integrated(), state.integrated());
            assert_eq!(together.bits(), state.output().bits(), "run {run}");
        }
    };
    let (mut at, mut piece) = (0, 1);
    while at < SAMPLES {
        let end = SAMPLES.min(at + piece);
        lanes.push(&packed[at..end]).unwrap();
        for (state, samples) in states.iter_mut().zip(&runs.samples) {
            for &sample in &samples[at..end] {
                alone.push(state, sample).unwrap();
            }
        }
        compare(&lanes, &states);
        (at, piece) = (end, piece + 7);
    }
    lanes.finish();
    for state in &mut states {
        alone.finish(state);
    }
    assert_eq!(lanes.integrated(), SAMPLES as u64);
    compare(&lanes, &states);
    let [first, second, ..] = lanes.output();
    assert_ne!(first.bits(), second.bits(), "the runs differ");
}

struct EveryWindow;

impl InLanes for EveryWindow {
    type Output = ();
    fn run<P: Lanes>(self) {
        let runs = runs();
        same::<EarthFixed<Pair<f64>>, EarthFixed<Pair<P>>, H0B4A0>(&runs);
        same::<LocalLevel<Pair<f64>>, LocalLevel<Pair<P>>, H0B4A0>(&runs);
        same::<EarthFixed<Pair<f64>>, EarthFixed<Pair<P>>, H2B4A2>(&runs);
        same::<LocalLevel<Pair<f64>>, LocalLevel<Pair<P>>, H2B4A2>(&runs);
        same::<EarthFixed<Pair<f64>>, EarthFixed<Pair<P>>, Line8>(&runs);
        same::<LocalLevel<Pair<f64>>, LocalLevel<Pair<P>>, Line8>(&runs);
    }
}

#[test]
fn each_lane_has_the_bits_of_its_run_alone() {
    EveryWindow.run::<Four>();
}

#[test]
fn each_lane_of_a_register_has_the_bits_of_its_run_alone() {
    let done = in_registers(EveryWindow);
    #[cfg(target_arch = "x86_64")]
    assert_eq!(done.is_some(), is_x86_feature_detected!("avx2"));
    #[cfg(not(target_arch = "x86_64"))]
    assert_eq!(done, None);
}

#[test]
fn a_sample_that_is_wrong_in_one_lane_stops_all_before_it() {
    let runs = runs();
    let mut packed = runs.packed();
    let start =
        || Abreast::<EarthFixed<Pair<Four>>, H0B4A0>::start(runs.interval_s, ORDER, &runs.initial);
    let (mut whole, mut stopped) = (start().unwrap(), start().unwrap());
    whole.push(&packed[..100]).unwrap();
    let mut lanes = packed[102].velocity_b.y.lanes();
    lanes[2] = f64::NAN;
    packed[102].velocity_b.y = Four::from_lanes(lanes);
    let refused = stopped.push(&packed[..110]).unwrap_err();
    assert_eq!((refused.taken, refused.reason), (102, Rejected::Velocity));
    for (a, b) in whole.output().iter().zip(&stopped.output()) {
        assert_eq!(a.bits(), b.bits());
    }
}
