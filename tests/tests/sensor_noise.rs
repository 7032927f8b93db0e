//! Random streams and normal deviates, against references computed to 50 digits, against the
//! published generators written out again, and against the moments of their distributions.

#![allow(clippy::excessive_precision, reason = "references with more digits than the type has")]

use schuler::noise::{Deviate, Stream, Streams};
use schuler_simulator::rounding::split_mix;

/// k of the f64 deviate's 63 bits, and the deviate: Φ⁻¹ at ½ + (k + ½)/2⁶⁴.
const DOUBLE: [(u64, f64); 24] = [
    (0x0000000000000000, 6.7942295524213059625e-20),
    (0x0000000000000001, 2.0382688657263917887e-19),
    (0x0000010000000000, 1.4940668789339957897e-7),
    (0x0080000000000000, 0.0048957779063424516802),
    (0x0ccccccccccccccc, 0.12566134685507403417),
    (0x2000000000000000, 0.31863936396437516309),
    (0x4000000000000000, 0.67448975019608174329),
    (0x57625e89069be800, 0.99999999999999990585),
    (0x6cac083126e97800, 1.4360082279441818947),
    (0x6ccccda38c61a400, 1.4395318241570885584),
    (0x7333333333333400, 1.6448536269514728228),
    (0x7999999999999800, 1.9599639845400538561),
    (0x7eb851eb851eb800, 2.5758293035489004557),
    (0x7fdf3b645a1cac00, 3.2905267314918945586),
    (0x7ffc72815b398000, 3.8709315916073843591),
    (0x7fffff172b5af000, 5.3120140918191754475),
    (0x7fffffffc4653600, 6.4547185379859973921),
    (0x7ffffffff0000000, 6.6510353801671203384),
    (0x7ffffffff8000000, 6.7523004319473414031),
    (0x7ffffffffff0bdc0, 7.4302163908773087722),
    (0x7ffffffffffffc18, 8.2952402067767239451),
    (0x7ffffffffffffff6, 8.8318057496124454296),
    (0x7ffffffffffffffe, 9.0359188485719379718),
    (0x7fffffffffffffff, 9.155293772686072546),
];

/// The same for the f32 deviate's 31 bits: Φ⁻¹ at ½ + (k + ½)/2³².
const SINGLE: [(u32, f32); 21] = [
    (0x00000000, 2.91809937292e-10),
    (0x00000001, 8.75429811875e-10),
    (0x000003e8, 5.83911684521e-7),
    (0x00100000, 0.000611970123619),
    (0x0ccccccc, 0.125661346679),
    (0x20000000, 0.318639364271),
    (0x40000000, 0.674489750562),
    (0x57625e89, 1.00000000046),
    (0x6cac0831, 1.43600822851),
    (0x6ccccda3, 1.43953182408),
    (0x73333333, 1.64485362763),
    (0x79999999, 1.95996398414),
    (0x7eb851eb, 2.57582930323),
    (0x7fdf3b64, 3.29052675088),
    (0x7ffe7960, 4.07222633841),
    (0x7fffd8f0, 4.57970239651),
    (0x7ffffc18, 5.04004250793),
    (0x7fffff9c, 5.46483676071),
    (0x7ffffff6, 5.86751379108),
    (0x7ffffffe, 6.16642951782),
    (0x7fffffff, 6.33795775455),
];

#[test]
fn deviates_match_the_quantiles_of_the_normal_distribution() {
    for (k, expected) in DOUBLE {
        let z = f64::normal(k);
        assert!((z / expected - 1.0).abs() <= 1e-15, "{k:#x}: {z:e} for {expected:e}");
        assert_eq!(f64::normal(k | 1 << 63), -z, "both tails are alike");
    }
    for (k, expected) in SINGLE {
        let z = f32::normal(k);
        assert!((z / expected - 1.0).abs() <= 4e-7, "{k:#x}: {z:e} for {expected:e}");
        assert_eq!(f32::normal(k | 1 << 31), -z, "both tails are alike");
    }
}

/// Φ⁻¹ at ½ + (k + ½)/2³², of k of 31 bits, in double precision.
fn precise(k: u32) -> f64 {
    f64::normal(u64::from(k) << 32 | 0x7fff_ffff)
}

#[test]
fn single_precision_follows_double_in_every_piece() {
    const LAST: u32 = u32::MAX >> 1;
    let of_distance = |k: u32| {
        let error = f64::from(f32::normal(k)) / precise(k) - 1.0;
        assert!(error.abs() < 2e-7, "{k:#x}: {error:e}");
    };
    // From ½ on, and across the border of its polynomial.
    (0..5000).for_each(of_distance);
    (0..31).for_each(|bit| of_distance(1 << bit));
    (0..1 << 18).for_each(|n| of_distance(n << 12 | n & 0xfff));
    ((1 << 30) - 1000..(1 << 30) + 1000).for_each(of_distance);
    // Pieces of every octave of the distance from the end, their borders and what lies between.
    for octave in 0..30 {
        for place in 0..8 * 32 {
            let from_end = (u64::from(256u32 + place) << octave >> 8) as u32;
            (from_end.saturating_sub(2)..from_end + 3).for_each(|n| of_distance(LAST - n));
        }
    }
}

/// Mean, variance, kurtosis and tails of n deviates, each within five of its standard errors.
fn check_distribution<R: Deviate>(n: usize) {
    let mut stream = Streams::new(2024, 7).open();
    let mut sums = [0.0f64; 4];
    let limits = [(1.0, 0.317310507862914), (3.0, 2.69979606326019e-3), (4.0, 6.33424836662398e-5)];
    let mut beyond = [0.0f64; 3];
    for _ in 0..n {
        let z = stream.normal::<R>().widen();
        for (power, sum) in (1..).zip(&mut sums) {
            *sum += z.powi(power);
        }
        for (count, (limit, _)) in beyond.iter_mut().zip(limits) {
            *count += f64::from(z.abs() > limit);
        }
    }
    // E zᵏ = 0, 1, 0, 3 and Var zᵏ = 1, 2, 15, 96
    let moments = [(0.0, 1.0), (1.0, 2.0), (0.0, 15.0), (3.0, 96.0)];
    let n = n as f64;
    for (sum, (mean, variance)) in sums.iter().zip(moments) {
        assert!((sum / n - mean).abs() < 5.0 * f64::sqrt(variance / n), "{} for {mean}", sum / n);
    }
    for (count, (limit, p)) in beyond.iter().zip(limits) {
        let expected = n * p;
        assert!((count - expected).abs() < 5.0 * expected.sqrt(), "{count} beyond {limit} sigma");
    }
}

#[test]
fn deviates_have_the_moments_and_tails_of_the_normal_distribution() {
    check_distribution::<f64>(4_000_000);
    check_distribution::<f32>(4_000_000);
}

#[test]
fn single_precision_draws_the_same_deviates() {
    let (mut single, mut double) = (Streams::new(1, 1).open(), Streams::new(1, 1).open());
    for _ in 0..100_000 {
        let (s, d) = (single.normal::<f32>(), double.normal::<f64>());
        assert!((f64::from(s) - d).abs() < 1e-4, "{s} for {d}");
    }
}

#[test]
fn uniform_numbers_fill_the_interval_from_0_to_1() {
    let mut stream = Streams::new(5, 0).branch(Streams::LINK).open();
    let n = 1_000_000;
    let (mut sum, mut squares, mut lost) = (0.0, 0.0, 0.0);
    for _ in 0..n {
        let u: f64 = stream.uniform();
        assert!((0.0..1.0).contains(&u));
        sum += u;
        squares += u * u;
        lost += f64::from(u < 0.01);
    }
    let n = f64::from(n);
    // Var u = 1/12, Var u² = 4/45
    assert!((sum / n - 0.5).abs() < 5.0 * f64::sqrt(1.0 / 12.0 / n));
    assert!((squares / n - 1.0 / 3.0).abs() < 5.0 * f64::sqrt(4.0 / 45.0 / n));
    assert!((lost - 0.01 * n).abs() < 5.0 * f64::sqrt(0.01 * n));
    assert_eq!((f64::uniform(0), f32::uniform(0)), (0.0, 0.0));
    assert_eq!(f64::uniform(u64::MAX), 1.0 - f64::EPSILON / 2.0);
    assert_eq!(f32::uniform(u32::MAX), 1.0 - f32::EPSILON / 2.0);
}

/// SplitMix64's output for a state (Steele, Lea & Flood 2014).
fn mix(mut state: u64) -> u64 {
    split_mix::word(&mut state)
}

/// xoshiro256++ (Blackman & Vigna 2019).
fn xoshiro(s: &mut [u64; 4]) -> u64 {
    let result = s[0].wrapping_add(s[3]).rotate_left(23).wrapping_add(s[0]);
    let t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = s[3].rotate_left(45);
    result
}

#[test]
fn a_stream_is_the_documented_function_of_seed_run_and_identity() {
    let (seed, run, identity) = (42, 3, 0xdead_beef);
    let mut words = [1, 2, 3, 4].map(|i| mix(mix(mix(mix(i) ^ seed) ^ run) ^ identity));
    let mut stream = Stream::new(seed, run, identity);
    for _ in 0..100 {
        assert_eq!(stream.next_u64(), xoshiro(&mut words));
    }
    assert_eq!(stream.next_u32(), (xoshiro(&mut words) >> 32) as u32);

    let mut branch = Streams::new(seed, run).branch(1).branch(5).open();
    let identity = mix(mix(mix(1)) ^ mix(5));
    assert_eq!(branch, Stream::new(seed, run, identity));
    assert_eq!(branch.next_u64(), Stream::new(seed, run, identity).next_u64());
}

#[test]
fn a_stream_goes_on_from_its_bytes() {
    let mut stream = Streams::new(9, 9).open();
    for _ in 0..17 {
        stream.normal::<f64>();
    }
    let mut copy = Stream::from_bytes(stream.to_bytes());
    for _ in 0..100 {
        assert_eq!(stream.normal::<f32>().to_bits(), copy.normal::<f32>().to_bits());
    }
}

#[test]
fn streams_of_neighbouring_seeds_runs_and_places_are_uncorrelated() {
    let mut streams = Vec::new();
    for (seed, run) in [(1, 0), (1, 1), (2, 0), (0, 1)] {
        let root = Streams::new(seed, run);
        streams.extend([root.open(), root.branch(Streams::LINK).open()]);
        for place in [root.branch(0).branch(0), root.branch(0).branch(1), root.branch(1).branch(0)]
        {
            streams.extend(place.axes());
        }
    }
    let n = 20_000;
    let noise: Vec<Vec<f64>> =
        streams.iter_mut().map(|s| (0..n).map(|_| s.normal()).collect()).collect();
    let bound = 5.0 * f64::sqrt(f64::from(n));
    for (i, a) in noise.iter().enumerate() {
        let lag: f64 = a.iter().zip(&a[1..]).map(|(x, y)| x * y).sum();
        assert!(lag.abs() < bound, "stream {i} with itself");
        for (j, b) in noise.iter().enumerate().skip(i + 1) {
            let dot: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
            assert!(dot.abs() < bound, "streams {i} and {j}: {dot}");
        }
    }
}
