//! Runs flown side by side, one in each lane: every one has the bits of its run flown alone.

use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::{EarthFixedSolution, Solution};
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, Line8, Window};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::limits::Rejected;
use schuler::strapdown::navigator::Strapdown;
use schuler_simulator::lanes::abreast::{Abreast, Packed, SideBySide as _, pack};
use schuler_simulator::lanes::pack::Lanes;
use schuler_simulator::lanes::{InLanes, Registers, in_registers};
use schuler_simulator::scene::builtin;
use schuler_simulator::source::Source;
use std::array;

const SAMPLES: usize = 3001;
const ORDER: usize = 20;

/// Runs with noise of their own, from places far apart.
struct Runs<const N: usize> {
    interval_s: Pair<f64>,
    initial: [Solution<f64>; N],
    samples: [Vec<Increment<f64>>; N],
}

fn runs<const N: usize>() -> Runs<N> {
    let mut scene = builtin::scene("hard").unwrap();
    let paper = builtin::scene("paper").unwrap();
    (scene.gyro, scene.accelerometer) = (paper.gyro, paper.accelerometer);
    let source = Source::new(&scene, false).unwrap();
    let samples = array::from_fn(|run| {
        let mut stream = source.start(run as u64);
        (0..SAMPLES).map(|_| stream.advance().unwrap()).collect()
    });
    let initial = array::from_fn(|run| {
        let mut initial = source.initial(0);
        initial.position.latitude.hi += 0.08 * run as f64;
        initial.position.longitude.lo = 1e-18 * run as f64;
        initial.velocity_ned.y.hi -= 15.0 * run as f64;
        initial
    });
    Runs { interval_s: Pair::new(scene.rate_hz).reciprocal(), initial, samples }
}

impl<const N: usize> Runs<N> {
    fn packed<P: Lanes<N>>(&self) -> Vec<Increment<P>> {
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
fn same<F, W, const N: usize>(runs: &Runs<N>)
where
    F: Packed<N, Alone: Frame<Output: Bits>>,
    W: Window,
{
    let alone = Strapdown::<F::Alone, W>::new(runs.interval_s).unwrap().with_order(ORDER);
    let mut states = runs.initial.map(|initial| alone.start(&initial).unwrap());
    let mut lanes = Abreast::<F, W, N>::start(runs.interval_s, ORDER, &runs.initial).unwrap();
    let packed = runs.packed();
    let compare = |lanes: &Abreast<F, W, N>, states: &[_; N]| {
        for (run, (together, state)) in lanes.output().iter().zip(states).enumerate() {
            let state: &schuler::strapdown::navigator::State<F::Alone, W> = state;
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
        // A stream may end and go on: before its first block, within one, and at last.
        if piece == 1 || piece == 50 || end == SAMPLES {
            lanes.finish();
            states.iter_mut().for_each(|state| alone.finish(state));
            assert_eq!(lanes.integrated(), end as u64);
            compare(&lanes, &states);
        }
        (at, piece) = (end, piece + 7);
    }
    let last = lanes.output();
    assert_ne!(last[0].bits(), last[N - 1].bits(), "the runs differ");
}

struct EveryWindow;

impl InLanes for EveryWindow {
    type Output = ();
    fn run<P: Lanes<N>, const N: usize>(self) {
        let runs = runs();
        same::<EarthFixed<Pair<P>>, H0B4A0, N>(&runs);
        same::<LocalLevel<Pair<P>>, H0B4A0, N>(&runs);
        same::<EarthFixed<Pair<P>>, H2B4A2, N>(&runs);
        same::<LocalLevel<Pair<P>>, H2B4A2, N>(&runs);
        same::<EarthFixed<Pair<P>>, Line8, N>(&runs);
        same::<LocalLevel<Pair<P>>, Line8, N>(&runs);
    }
}

#[test]
fn each_lane_of_a_register_has_the_bits_of_its_run_alone() {
    for registers in [Registers::Avx512, Registers::Avx2] {
        let done = in_registers(registers, EveryWindow);
        assert_eq!(done.is_some(), registers.are_there(), "{registers:?}");
    }
    #[cfg(target_arch = "x86_64")]
    {
        assert_eq!(Registers::Avx2.are_there(), is_x86_feature_detected!("avx2"));
        let all = is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512vl");
        assert_eq!(Registers::Avx512.are_there(), all);
    }
}

#[test]
fn a_sample_that_is_wrong_in_one_lane_stops_all_before_it() {
    for registers in [Registers::Avx512, Registers::Avx2] {
        // Among those that each run takes alone, and among those that all take together.
        for wrong in [2, 102] {
            in_registers(registers, WrongSample(wrong));
        }
    }
}

struct WrongSample(usize);

impl InLanes for WrongSample {
    type Output = ();
    fn run<P: Lanes<N>, const N: usize>(self) {
        let Self(wrong) = self;
        let runs = runs();
        let mut packed = runs.packed::<P>();
        let start = || {
            let (interval_s, initial) = (runs.interval_s, &runs.initial);
            Abreast::<EarthFixed<Pair<P>>, H0B4A0, N>::start(interval_s, ORDER, initial).unwrap()
        };
        let (mut whole, mut stopped) = (start(), start());
        whole.push(&packed[..wrong]).unwrap();
        let mut lanes = packed[wrong].velocity_b.y.lanes();
        lanes[2] = f64::NAN;
        packed[wrong].velocity_b.y = P::from_lanes(lanes);
        let refused = stopped.push(&packed[..wrong + 8]).unwrap_err();
        assert_eq!((refused.taken, refused.reason), (wrong, Rejected::Velocity));
        assert_eq!(whole.integrated(), stopped.integrated());
        for (a, b) in whole.output().iter().zip(&stopped.output()) {
            assert_eq!(a.bits(), b.bits());
        }
        // Both go on alike: what was refused left no trace in any lane.
        whole.push(&packed[wrong + 1..wrong + 30]).unwrap();
        stopped.push(&packed[wrong + 1..wrong + 30]).unwrap();
        for (a, b) in whole.output().iter().zip(&stopped.output()) {
            assert_eq!(a.bits(), b.bits());
        }
    }
}
