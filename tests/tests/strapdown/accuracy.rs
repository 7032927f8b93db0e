//! How near to the truth: rows inside blocks, both frames, both precisions, orders of convergence.

use schuler::flight::carried::Carried;
use schuler::math::compensated::{Accumulate, Pair, Plain, TwoFloat};
use schuler::math::real::Scalar;
use schuler::output::Output as _;
use schuler::solution::Solution;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, H4B4A0, Window};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler_tests::{Course, largest};
use std::f64::consts::{PI, TAU};

type Local = LocalLevel<Pair<f64>>;
type Earth = EarthFixed<Pair<f64>>;

/// Largest misses over rows at blocks' ends and inside blocks, m.
fn rows_and_ends<F: Frame<Real = f64>, W: Window>() {
    // A line or a parabola is for slow motion.
    let slow = W::COEFFICIENTS < W::SAMPLES;
    let (scene, seconds) = if slow { ("paper-perfect", 60.0) } else { ("manoeuvre", 15.0) };
    let course = Course::new(scene, 1.0, seconds);
    let rows = course.fly(&Strapdown::<F, W>::new(course.interval_s).unwrap());
    let misses: Vec<f64> = rows.iter().zip(1..).map(|(row, n)| course.miss(n, row)).collect();
    // The stream's last rows belong to blocks of their own.
    let whole = misses.len() - misses.len() % W::BLOCK - W::BLOCK - W::LOOKAHEAD;
    let is_end = |n: usize| (n + 1).is_multiple_of(W::BLOCK);
    let over = |ends: bool| largest((0..whole).filter(|&n| is_end(n) == ends).map(|n| misses[n]));
    let (ends, inside) = (over(true), over(false));
    let what = format!("H{} B{} A{}", W::HISTORY, W::BLOCK, W::LOOKAHEAD);
    assert!(inside <= 2.0 * ends + 2e-9, "{what}: {inside:e} inside, {ends:e} at ends");
    assert!(ends <= 2.0 * inside + 2e-9, "{what}: {inside:e} inside, {ends:e} at ends");
}

#[test]
fn a_row_inside_a_block_is_as_good_as_its_end() {
    for_every_window!(rows_and_ends, Local);
    for_every_window!(rows_and_ends, Earth);
}

/// Two independent mechanizations: what they agree on is not the error of either.
#[test]
fn both_frames_agree_to_ten_nanometres() {
    for (scene, seconds) in
        [("paper-perfect", 1800.0), ("manoeuvre", 100.0), ("cruise-180", 1800.0)]
    {
        let course = Course::new(scene, 1.0, seconds);
        let local = course.fly(&Strapdown::<Local, H2B4A2>::new(course.interval_s).unwrap());
        let earth = course.fly(&Strapdown::<Earth, H2B4A2>::new(course.interval_s).unwrap());
        let gap = |(a, b): (&Solution<f64>, &Solution<f64>)| {
            let drift = schuler::drift::compare::drift(a, b);
            [drift.position_ned.norm(), drift.velocity_ned.norm(), drift.attitude_ned.norm()]
        };
        let gaps: Vec<_> = local.iter().zip(&earth).map(gap).collect();
        let worst = [0, 1, 2].map(|i| largest(gaps.iter().map(|gap| gap[i])));
        assert!(worst[0] <= 1e-8, "{scene}: {worst:?}");
        assert!(worst[1] <= 1e-10 && worst[2] <= 1e-12, "{scene}: {worst:?}");
    }
}

/// Rows of a flight in single precision, carried increments handed over.
fn narrow<F: Frame<Real = f32>, W: Window>(course: &Course) -> Vec<Solution<f64>> {
    let strapdown = Strapdown::<F, W>::new(Pair::narrow(course.interval_s)).unwrap();
    let mut state = strapdown.start(&Solution::narrow(&course.initial())).unwrap();
    let mut carried = Carried::default();
    let mut rows = Vec::new();
    for sample in &course.samples {
        let sample = carried.narrow(sample);
        strapdown.push_rows(&mut state, sample, |_, row| rows.push(row.wide())).unwrap();
    }
    strapdown.finish_rows(&mut state, |_, row| rows.push(row.wide()));
    rows
}

fn worst(course: &Course, rows: &[Solution<f64>]) -> f64 {
    largest(rows.iter().zip(1..).map(|(row, n)| course.miss(n, row)))
}

#[test]
fn single_precision_compensated_and_not() {
    let course = Course::new("paper-perfect", 1.0, 1800.0);
    let miss = |rows: Vec<_>| worst(&course, &rows);
    let compensated = miss(narrow::<LocalLevel<Pair<f32>>, H0B4A0>(&course));
    let plain = miss(narrow::<LocalLevel<Plain<f32>>, H0B4A0>(&course));
    let earth = miss(narrow::<EarthFixed<Pair<f32>>, H0B4A0>(&course));
    let two_float = miss(narrow::<LocalLevel<TwoFloat<f32>>, H0B4A0>(&course));
    assert!(compensated <= 0.15, "{compensated}");
    // Compensation is what does it, and two-float products the rest.
    assert!((10.0..100.0).contains(&plain), "{plain}");
    assert!(earth <= 0.6, "{earth}");
    assert!(two_float <= 5e-3, "{two_float}");
}

#[test]
fn double_precision_without_compensation() {
    let course = Course::new("paper-perfect", 1.0, 1800.0);
    let plain = Strapdown::<LocalLevel<Plain<f64>>, H0B4A0>::new(course.interval_s).unwrap();
    let pair = Strapdown::<Local, H0B4A0>::new(course.interval_s).unwrap();
    let (plain, pair) = (course.largest_miss(&plain), course.largest_miss(&pair));
    assert!(pair <= 1e-8 && plain <= 1e-6 && plain > 3.0 * pair, "{plain:e} {pair:e}");
}

/// Misses at some multiples of a scene's rate.
fn misses(scene: &str, seconds: f64, rates: [f64; 3], fly: impl Fn(&Course) -> f64) -> [f64; 3] {
    rates.map(|faster| fly(&Course::new(scene, faster, seconds)))
}

#[test]
fn the_textbook_converges_with_the_square_of_the_interval() {
    for (scene, seconds, rates) in [
        ("manoeuvre", 20.0, [1.0, 2.0, 4.0]),
        ("hard", 20.0, [1.0, 2.0, 4.0]),
        ("paper-perfect", 600.0, [0.5, 1.0, 2.0]),
    ] {
        let local = misses(scene, seconds, rates, |course| {
            let textbook = Textbook::<LocalLevelTextbook<f64>>::new(course.interval_s.hi);
            course.largest_miss(&textbook.unwrap())
        });
        let earth = misses(scene, seconds, rates, |course| {
            let textbook = Textbook::<EarthFixedTextbook<f64>>::new(course.interval_s.hi);
            course.largest_miss(&textbook.unwrap())
        });
        for all @ [coarse, middle, fine] in [local, earth] {
            assert!(middle < coarse / 3.6 && fine < middle / 3.6, "{scene}: {all:?}");
        }
    }
}

#[test]
fn a_window_of_eight_converges_far_faster() {
    // Below the motion's bandwidth, so that the floor is not reached at once.
    let local = misses("hard", 20.0, [0.25, 0.5, 1.0], |course| {
        course.largest_miss(&Strapdown::<Local, H4B4A0>::new(course.interval_s).unwrap())
    });
    let four = misses("hard", 20.0, [0.25, 0.5, 1.0], |course| {
        course.largest_miss(&Strapdown::<Earth, H0B4A0>::new(course.interval_s).unwrap())
    });
    let [coarse, middle, fine] = local;
    assert!(middle < coarse / 64.0 && fine < middle / 64.0, "{local:?}");
    let [coarse, middle, fine] = four;
    assert!(middle < coarse / 12.0 && fine < middle / 12.0, "{four:?}");
}

#[test]
fn across_the_pole_in_earth_fixed_axes() {
    let course = Course::new("polar", 1.0, 600.0);
    let rows = course.fly(&Strapdown::<Earth, H0B4A0>::new(course.interval_s).unwrap());
    let latitudes: Vec<f64> = rows.iter().map(|row| row.position.latitude.hi).collect();
    assert!(largest(latitudes.iter().copied()) > PI / 2.0 - 1e-6);
    let miss = worst(&course, &rows);
    let textbook = Textbook::<EarthFixedTextbook<f64>>::new(course.interval_s.hi).unwrap();
    let plain = course.largest_miss(&textbook);
    assert!(miss <= 1e-8, "{miss:e}");
    assert!(plain <= 1e-2, "{plain:e}");
}

/// Both frames print longitudes within ±180°, and the same ones.
#[test]
fn across_the_antimeridian() {
    let course = Course::new("cruise-180", 1.0, 1800.0);
    let local = course.fly(&Strapdown::<Local, H0B4A0>::new(course.interval_s).unwrap());
    let earth = course.fly(&Strapdown::<Earth, H0B4A0>::new(course.interval_s).unwrap());
    let textbook = Textbook::<LocalLevelTextbook<f64>>::new(course.interval_s.hi).unwrap();
    let plain = course.fly(&textbook);
    let longitude = |row: &Solution<f64>| row.position.longitude.hi;
    for rows in [&local, &earth, &plain] {
        assert!(rows.iter().all(|row| longitude(row).abs() <= PI));
        let jumps = rows
            .windows(2)
            .filter(|pair| (longitude(&pair[1]) - longitude(&pair[0])).abs() > 1.0)
            .count();
        assert_eq!(jumps, 1);
    }
    for (a, b) in local.iter().zip(&earth) {
        let gap = (longitude(a) - longitude(b)).abs();
        assert!(gap.min(TAU - gap) < 2e-15, "{gap:e}");
    }
}

/// Held height and vertical velocity are those given; the rest stays.
#[test]
fn held_vertical() {
    fn check<F: Frame<Real = R>, R: Scalar>(course: &Course, most: f64) {
        let initial: Solution<R> = Solution::narrow(&course.initial());
        let mut frame = F::start(&initial);
        let before = frame.output().wide();
        let (altitude, down) = (R::of(3210.0), R::of(-1.25));
        frame.hold_vertical(altitude, down);
        let after = frame.output().wide();
        assert!((after.position.altitude.widen() - 3210.0).abs() <= most, "{after:?}");
        assert!((after.velocity_ned.z.widen() + 1.25).abs() <= most, "{after:?}");
        let horizontal = |s: &Solution<f64>| [s.velocity_ned.x.widen(), s.velocity_ned.y.widen()];
        for (a, b) in horizontal(&after).into_iter().zip(horizontal(&before)) {
            assert!((a - b).abs() <= most, "{after:?} {before:?}");
        }
        let place = |s: &Solution<f64>| [s.position.latitude.widen(), s.position.longitude.widen()];
        for (a, b) in place(&after).into_iter().zip(place(&before)) {
            assert!((a - b).abs() * 6.4e6 <= most, "{after:?} {before:?}");
        }
        // Against axes that stand where the place does.
        let turn = after.attitude.map(Pair::widen) - before.attitude.map(Pair::widen);
        assert!(turn.dot(turn).sqrt() <= most / 6.4e6, "{after:?} {before:?}");
    }
    let course = Course::new("manoeuvre", 1.0, 0.1);
    check::<Local, f64>(&course, 5e-9);
    check::<Earth, f64>(&course, 5e-9);
    check::<LocalLevel<Pair<f32>>, f32>(&course, 1e-7);
    check::<EarthFixed<Pair<f32>>, f32>(&course, 1.0);
    check::<EarthFixed<TwoFloat<f32>>, f32>(&course, 1.0);
}

/// A vertical held at the truth makes no flight worse: its channels are the horizontal ones' alone.
#[test]
fn flights_with_the_vertical_held() {
    fn check<M: Mechanization<Real = f64>>(mechanization: &M, course: &Course) {
        let free = course.largest_miss(mechanization);
        let mut state = mechanization.start(&course.initial()).unwrap();
        let mut held = 0.0_f64;
        for &sample in &course.samples {
            let before = M::integrated(&state);
            mechanization.push(&mut state, sample).unwrap();
            let now = M::integrated(&state);
            if now != before {
                let truth = course.source.truth(now);
                let (altitude, down) = (truth.position.altitude.hi, truth.velocity_ned.z.hi);
                mechanization.hold_vertical(&mut state, altitude, down).unwrap();
                held = largest([held, course.miss(now, &mechanization.output(&state).wide())]);
            }
        }
        assert!(held <= 2.0 * free + 2e-9, "{held:e} held, {free:e} free");
    }
    let course = Course::new("paper-perfect", 1.0, 1800.0);
    check(&Strapdown::<Local, H0B4A0>::new(course.interval_s).unwrap(), &course);
    check(&Strapdown::<Earth, H0B4A0>::new(course.interval_s).unwrap(), &course);
    check(&Textbook::<LocalLevelTextbook<f64>>::new(course.interval_s.hi).unwrap(), &course);
    check(&Textbook::<EarthFixedTextbook<f64>>::new(course.interval_s.hi).unwrap(), &course);
}

/// Compensation is a type: `Plain` and `Pair` print what they carry.
#[test]
fn what_is_carried_is_printed() {
    let course = Course::new("paper-perfect", 1.0, 1.0);
    let carried = Local::start(&course.initial()).output();
    assert_eq!(carried, course.initial());
    let plain = LocalLevel::<Plain<f64>>::start(&course.initial()).output();
    assert_eq!(plain.attitude, course.initial().attitude.map(|c| Plain::from_pair(c).pair()));
}
