//! Every function of a navigator does what the core does: called side by side, they leave the same bits.

#![allow(unsafe_code, reason = "the functions are C's")]

use schuler::flight::catalogue::Entry;
use schuler::flight::plan::HIGHEST_ORDER;
use schuler::math::compensated::Pair;
use schuler::navigators::{EarthFixedNavigator8, Navigator4, TextbookNavigator};
use schuler::prelude::*;
use schuler::record::Record;
use schuler::strapdown::block::unequal::Unequal;
use schuler::strapdown::block::window::H2B4A2;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler_c::*;

/// The words of a record.
fn words(record: &impl Record) -> Vec<u64> {
    let mut words = Vec::new();
    record.record("", &mut |_, bits| words.push(bits));
    words
}

fn initial() -> Solution<f64> {
    let at = Geodetic { latitude: 0.8, longitude: -2.0, altitude: 300.0 };
    Solution::new(at, Vector::new(30.0, -5.0, 1.0), Euler { roll: 0.1, pitch: -0.2, yaw: 2.0 })
}

/// A number that moves with the sample.
fn moving(sample: u32, axis: u32) -> f64 {
    1e-3 * f64::from((sample * 7 + axis * 13) % 29) - 0.014
}

macro_rules! same {
    ($test:ident, $name:ident, $number:ident, $core:ty, |$navigator:ident, $state:ident, $over:ident| $push_over:tt) => {
        #[test]
        fn $test() {
            pastey::paste! {
                // SAFETY: every pointer leads to a variable of this function.
                unsafe {
                    let level = words(&initial()).into_iter().map(f64::from_bits).collect::<Vec<_>>();
                    let mut start = schuler_solution_f64::default();
                    let pair = |n: usize| schuler_pair_f64 { value: level[2 * n], rest: level[2 * n + 1] };
                    start.position = [pair(0), pair(1), pair(2)];
                    start.velocity = [pair(3), pair(4), pair(5)];
                    start.attitude = [pair(6), pair(7), pair(8), pair(9)];

                    let interval_s = Pair::<$number>::narrow(Pair::new(50.0).reciprocal());
                    let $navigator = <$core as Entry>::configured(interval_s, HIGHEST_ORDER).unwrap();
                    let mut $state = $navigator.start(&Solution::narrow(&initial())).unwrap();
                    let mut state: [<schuler_ $name>] = std::mem::zeroed();
                    assert_eq!([<schuler_ $name _start>](&mut state, SCHULER_ABI, 50.0, 0, &start), SCHULER_OK);

                    for sample in 0..40 {
                        let three = |from: u32| [0, 1, 2].map(|axis| moving(sample, from + axis) as $number);
                        let rates = |from: u32| [<schuler_rates_ $number>] {
                            rate_ib_b: three(from),
                            specific_force_b: three(from + 3),
                        };
                        let own = |rates: [<schuler_rates_ $number>]| Rates {
                            rate_ib_b: rates.rate_ib_b.into(),
                            specific_force_b: rates.specific_force_b.into(),
                        };
                        let (a, b) = (rates(0), rates(6));
                        match sample {
                            10..20 => {
                                let done = [<schuler_ $name _push_rates>](&mut state, &a, &b);
                                assert_eq!(done, SCHULER_OK);
                                let sample = Increment::from_rates(&own(a), &own(b), interval_s);
                                $navigator.push(&mut $state, sample).unwrap();
                            }
                            20 => {
                                let done = [<schuler_ $name _hold_vertical>](&mut state, 310.0, -0.5);
                                assert_eq!(done, SCHULER_OK);
                                $navigator.hold_vertical(&mut $state, 310.0, -0.5).unwrap();
                            }
                            21 => {
                                let by = [<schuler_correction_ $number>] {
                                    position_ned: three(0), velocity_ned: three(3), attitude_ned: three(6),
                                };
                                assert_eq!([<schuler_ $name _correct>](&mut state, &by), SCHULER_OK);
                                let by = Correction {
                                    position_ned: three(0).into(),
                                    velocity_ned: three(3).into(),
                                    attitude_ned: three(6).into(),
                                };
                                $navigator.correct(&mut $state, &by).unwrap();
                            }
                            _ => {
                                let sample = [<schuler_increment_ $number>] { angle_b: three(0), velocity_b: three(3) };
                                let $over = Increment { angle_b: three(0).into(), velocity_b: three(3).into() };
                                same!(@push $name, state, sample, $push_over, $navigator, $state, $over);
                            }
                        }
                        let mut integrated = 0;
                        [<schuler_ $name _integrated>](&state, &mut integrated);
                        assert_eq!(integrated, <$core as Mechanization>::integrated(&$state));
                    }
                    let mut read = schuler_solution_f64::default();
                    let flat = |s: &schuler_solution_f64| {
                        let pairs = s.position.into_iter().chain(s.velocity).chain(s.attitude);
                        pairs.flat_map(|pair| [pair.value.to_bits(), pair.rest.to_bits()]).collect::<Vec<_>>()
                    };
                    assert_eq!([<schuler_ $name _read>](&state, &mut read), SCHULER_OK);
                    assert_eq!(flat(&read), words(&$navigator.output(&$state).wide()));
                    assert_eq!([<schuler_ $name _predict>](&state, &mut read), SCHULER_OK);
                    assert_eq!([<schuler_ $name _finish>](&mut state), SCHULER_OK);
                    $navigator.finish(&mut $state);
                    assert_eq!(flat(&read), words(&$navigator.output(&$state).wide()));
                    let mut own = [<schuler_solution_ $number>]::default();
                    assert_eq!([<schuler_ $name _read_own>](&state, &mut own), SCHULER_OK);
                    let first = words(&$navigator.output(&$state))[0];
                    assert_eq!(u64::from(own.position[0].value.to_bits()), first);
                }
            }
        }
    };
    (@push $name:ident, $c:ident, $sample:ident, None, $navigator:ident, $state:ident, $over:ident) => { pastey::paste! {
        assert_eq!([<schuler_ $name _push>](&mut $c, &$sample), SCHULER_OK);
        $navigator.push(&mut $state, $over).unwrap();
    } };
    (@push $name:ident, $c:ident, $sample:ident, $interval:expr, $navigator:ident, $state:ident, $over:ident) => { pastey::paste! {
        let (c_interval, interval) = $interval;
        assert_eq!([<schuler_ $name _push_over>](&mut $c, &$sample, &c_interval), SCHULER_OK);
        $navigator.push_over(&mut $state, $over, interval).unwrap();
    } };
}

same!(single, f32_local_level_h0b4a0, f32, Navigator4<f32>, |navigator, state, sample| None);
same!(
    double,
    f64_earth_fixed_h2b4a2,
    f64,
    EarthFixedNavigator8<f64>,
    |navigator, state, sample| None
);
same!(
    textbook,
    f32_local_level_textbook,
    f32,
    TextbookNavigator<f32>,
    |navigator, state, sample| (
        schuler_pair_f32 { value: 0.021, rest: 1e-10 },
        Pair { hi: 0.021, lo: 1e-10 }
    )
);
same!(
    any_interval,
    f64_local_level_h2b4a2_any,
    f64,
    Strapdown<LocalLevel<Pair<f64>>, Unequal<H2B4A2>>,
    |navigator, state, sample| (
        schuler_pair_f64 { value: 0.019, rest: 1e-19 },
        Pair { hi: 0.019, lo: 1e-19 }
    )
);

#[test]
fn results_say_what_the_errors_of_the_core_say() {
    use schuler::strapdown::limits::{Rejected, StartError};
    let said = |text: String| RESULTS.iter().any(|(_, _, known)| *known == text);
    for error in
        [StartError::Interval, StartError::Position, StartError::Attitude, StartError::Pole]
    {
        assert!(said(error.to_string()), "{error}");
    }
    for error in [Rejected::Angle, Rejected::Place, Rejected::Turn, Rejected::Held] {
        assert!(said(error.to_string()), "{error}");
    }
    let mut codes: Vec<i32> = RESULTS.iter().map(|(code, ..)| *code).collect();
    codes.sort_unstable();
    codes.dedup();
    assert_eq!(codes.len(), RESULTS.len());
}
