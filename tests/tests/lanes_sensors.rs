//! Sensors of runs side by side, and of one run whose deviates are made many at a time: the bits of the core's
//! own, which makes them one by one.

use schuler::math::real::Real;
use schuler::math::vector::Vector;
use schuler::noise::quantile::double::CENTRE;
use schuler::noise::{Deviate, Stream};
use schuler::record::Record;
use schuler::sample::{Increment, Rates};
use schuler_simulator::emulator::{self, SceneEmulator};
use schuler_simulator::lanes::drawn::{AT_ONCE, Lines};
use schuler_simulator::lanes::one::One;
use schuler_simulator::lanes::pack::Lanes;
use schuler_simulator::lanes::sensors::{Sensors, in_lanes, same};
use schuler_simulator::lanes::{InLanes, Registers, in_registers};
use schuler_simulator::scene::{GaussMarkov, Scene, SensorErrors, Temperature, builtin};
use std::array;

/// Not a multiple of what is made at once.
const SAMPLES: usize = 3001;
const SEED: u64 = 5;

fn bits(v: Vector<f64>) -> [u64; 3] {
    v.map(f64::to_bits).into_array()
}

/// Every term.
fn every_term(size: f64) -> SensorErrors {
    let axes = |x: f64| Some([x, 1.25 * x, 0.5 * x]);
    SensorErrors {
        constant: axes(0.1 * size),
        turn_on: axes(0.1 * size),
        gauss_markov: Some(GaussMarkov { rms: [size; 3], correlation_s: [3.0, 60.0, 700.0] }),
        white: axes(0.1 * size),
        random_walk: axes(0.01 * size),
        bias_instability: axes(0.1 * size),
        scale_factor: axes(1e-3),
        misalignment: axes(1e-3),
        misalignment_matrix: Some([[0.0, 1e-3, -2e-3], [3e-3, 0.0, 1e-3], [2e-3, 1e-3, 0.0]]),
        g_sensitivity: axes(1e-3 * size),
        g_sensitivity_matrix: Some([[1e-3 * size, 2e-3 * size, 0.0]; 3]),
        temperature_bias: axes(1e-3 * size),
        temperature_scale: axes(1e-4),
        // It ends within a sample of the run.
        temperature: Some(Temperature { offset_k: 5.0, rate_k_s: 0.3, until_s: 12.345 }),
        // On the first axis noise passes, which leaves its limit by that.
        bandwidth: Some([1e4, 40.0, 30.0]),
        latency: axes(0.021),
        // Often on the first axis, on the others in jolts alone.
        saturation: Some([1.6 * size, 10.0 * size, 10.0 * size]),
        // The last axis stays continuous.
        quantization: Some([1e-4 * size, 1e-3 * size, 0.0]),
    }
}

fn scene() -> Scene {
    let mut scene = builtin::scene("hard").unwrap();
    scene.gyro = every_term(0.3);
    scene.accelerometer = every_term(5.0);
    scene
}

fn perfect() -> Vec<Increment<f64>> {
    let sample = |n: usize| {
        let swing = (0.01 * n as f64).sin();
        let jolt = if n % 500 == 7 { 100.0 } else { 1.0 };
        Increment {
            angle_b: Vector::new(3e-3 * swing, -1e-3, 2e-3 * swing) * jolt,
            velocity_b: Vector::new(0.05 * swing, 0.02, -0.0981) * jolt,
        }
    };
    (0..SAMPLES).map(sample).collect()
}

/// What the core makes of a run, one deviate at a time, and how many samples were at a limit.
fn alone(emulator: &SceneEmulator, run: u64) -> (Vec<Increment<f64>>, u64) {
    let mut state = emulator.start(SEED, run);
    let read = perfect().iter().map(|perfect| emulator.emulate(&mut state, perfect)).collect();
    (read, state.saturated)
}

struct EveryTerm;

impl InLanes for EveryTerm {
    type Output = ();
    fn run<P: Lanes<N>, const N: usize>(self) {
        let emulator = emulator::build(&scene()).unwrap();
        let ones = emulator.map(One);
        let terms = in_lanes::<P, N>(&ones);
        let mut sensors = Sensors::<P, N>::start(&ones, SEED, 3);
        let mut measured = Vec::new();
        for piece in perfect().chunks(37) {
            sensors.read(&terms, piece, &mut measured);
        }
        let runs: [_; N] = array::from_fn(|lane| alone(&emulator, 3 + lane as u64));
        for (lane, (alone, saturated)) in runs.iter().enumerate() {
            for (n, (together, alone)) in measured.iter().zip(alone).enumerate() {
                let of_lane = |v: Vector<P>| bits(v.map(|x| x.lanes()[lane]));
                assert_eq!(of_lane(together.angle_b), bits(alone.angle_b), "{lane} at {n}");
                assert_eq!(of_lane(together.velocity_b), bits(alone.velocity_b), "{lane} at {n}");
            }
            assert_eq!(sensors.saturated()[lane], *saturated);
            assert!((1..SAMPLES as u64).contains(saturated), "{saturated}");
        }
        assert_eq!(measured.len(), SAMPLES);
        // Not the same run everywhere.
        assert!(N == 1 || runs[0] != runs[N - 1]);
    }
}

#[test]
fn each_lane_has_the_sensors_of_its_run_alone() {
    for registers in [Registers::Avx512, Registers::Avx2] {
        in_registers(registers, EveryTerm);
    }
    EveryTerm.run::<One, 1>();
}

fn words(state: &impl Record) -> Vec<u64> {
    let mut words = Vec::new();
    state.record("", &mut |_, word| words.push(word));
    words
}

#[test]
fn one_run_has_the_state_of_the_core_and_goes_on_from_it() {
    let emulator = emulator::build(&scene()).unwrap();
    let ones = emulator.map(One);
    let (mut plain, mut ahead) = (emulator.start(SEED, 0), ones.start(SEED, 0));
    for (n, perfect) in perfect().iter().enumerate().take(600) {
        assert_eq!(words(&plain), words(&ahead), "{n}");
        if n % 100 == 99 {
            // Into the state of another run.
            let mut restored = ones.start(SEED, 1);
            let mut words = words(&plain).into_iter();
            restored.restore("", &mut |_, _| words.next().unwrap());
            ahead = restored;
        }
        let rates = |scale: f64| Rates {
            rate_ib_b: perfect.angle_b * scale,
            specific_force_b: perfect.velocity_b * scale,
        };
        let (expected, read) = if n % 2 == 0 {
            let read = ones.emulate(&mut ahead, &same(perfect));
            let expected = emulator.emulate(&mut plain, perfect);
            (expected, [read.angle_b, read.velocity_b])
        } else {
            let Rates { rate_ib_b: a, specific_force_b: f } = rates(100.0);
            let ones_rates = Rates { rate_ib_b: a.map(One), specific_force_b: f.map(One) };
            let read = ones.emulate_rates(&mut ahead, &ones_rates);
            let Rates { rate_ib_b: angle_b, specific_force_b: velocity_b } =
                emulator.emulate_rates(&mut plain, &rates(100.0));
            (Increment { angle_b, velocity_b }, [read.rate_ib_b, read.specific_force_b])
        };
        let expected = [expected.angle_b, expected.velocity_b].map(bits);
        assert_eq!(read.map(|v| bits(v.map(|One(x)| x))), expected, "{n}");
    }
}

/// Both ends, both sides of the border between centre and tail, where the tail changes its series, and words
/// with one bit; each with either sign.
fn words_at_the_edges() -> Vec<u64> {
    let centre = CENTRE as u64;
    // (−25).exp() of a half of the words.
    let far = (1 << 63) - (2f64.powi(64) * (-25f64).exp()) as u64;
    let near = [0, centre, far, 1 << 52, 1 << 53, 1 << 62, u64::MAX >> 1];
    let around = near.iter().flat_map(|&k| (0..5).map(move |n| (k + n).wrapping_sub(2)));
    let single = (0..63).flat_map(|bit| [1 << bit, (u64::MAX >> 1) ^ (1 << bit)]);
    let all = around.chain(single).map(|word| word & (u64::MAX >> 1));
    all.flat_map(|word| [word, word | 1 << 63]).collect()
}

struct Edges;

impl InLanes for Edges {
    type Output = ();
    fn run<P: Lanes<N>, const N: usize>(self) {
        let edges = words_at_the_edges();
        for first in 0..edges.len() {
            let words: [_; N] = array::from_fn(|lane| edges[(first + lane) % edges.len()]);
            // The first word of a generator with the state (0, b, c, d) is d turned by 23.
            let d = words.map(|word| word.rotate_right(23));
            let mut generator = [[0; N], [7; N], [first as u64; N], d];
            let mut deviates = Lines([0.0; AT_ONCE]);
            P::fill(&mut generator, &mut deviates);
            for (deviate, word) in deviates.0.iter().zip(words) {
                assert_eq!(deviate.to_bits(), f64::normal(word).to_bits(), "{word:#x}");
            }
        }
    }
}

#[test]
fn deviates_at_the_edges_have_the_bits_of_single_ones() {
    for registers in [Registers::Avx512, Registers::Avx2] {
        in_registers(registers, Edges);
    }
    Edges.run::<One, 1>();
}

struct Functions;

impl InLanes for Functions {
    type Output = ();
    fn run<P: Lanes<N>, const N: usize>(self) {
        let mut stream = Stream::new(1, 2, 3);
        let special = [0.0, 1.0, 0.5f64.sqrt(), 2f64.sqrt(), f64::MIN_POSITIVE, 5e-324, 0.5, 1.5];
        let special = special.into_iter().chain([f64::MAX, f64::INFINITY, f64::NAN, 2.5, 4.5e15]);
        let special: Vec<_> = special.flat_map(|x| [x, x.next_up(), x.next_down(), -x]).collect();
        for n in 0..20_000 {
            let mut x: [f64; N] = array::from_fn(|lane| match n % 3 {
                0 => f64::from_bits(stream.next_u64() >> 1),
                1 => stream.uniform::<f64>() + 2e-17,
                _ => 1e3 * stream.normal::<f64>() + lane as f64,
            });
            if n < special.len() {
                x[n % N] = special[n];
            }
            let pack = P::from_lanes(x);
            let same = |name: &str, f: fn(f64) -> f64, of_pack: P| {
                for (x, y) in x.into_iter().zip(of_pack.lanes()) {
                    let (y, expected) = (y.to_bits(), f(x));
                    assert!(y == expected.to_bits() || expected.is_nan(), "{name} {x:e}");
                }
            };
            same("ln", Real::ln, pack.ln());
            same("round", Real::round, pack.round());
        }
    }
}

#[test]
fn logarithms_and_whole_numbers_have_the_bits_of_single_ones() {
    for registers in [Registers::Avx512, Registers::Avx2] {
        in_registers(registers, Functions);
    }
}
