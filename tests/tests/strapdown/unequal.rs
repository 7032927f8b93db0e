//! Samples that differ in length: nothing changes where they do not, and time is what the intervals say.

use schuler::drift::compare::drift;
use schuler::flight::carried::Carried;
use schuler::imu::Quadrature;
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::math::real::Scalar;
use schuler::output::Output as _;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::unequal::Unequal;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, H4B4A0, H4B4A4, Line8, Window};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::limits::Rejected;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::mechanization::UnequalIntervals;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler::trajectory::Trajectory as _;
use schuler_simulator::source::Source;
use schuler_tests::{Course, Numbers, at_rest, bits, reader};
use std::f64::consts::TAU;

type Local = LocalLevel<Pair<f64>>;
type Earth = EarthFixed<Pair<f64>>;

/// A motion sampled at intervals of its own.
pub struct Uneven {
    source: Source,
    pub interval_s: Pair<f64>,
    /// Ends of the samples, after the start.
    times_s: Vec<f64>,
    samples: Vec<Increment<f64>>,
}

impl Uneven {
    /// `interval` gives a sample's length in nominal ones, from the time it begins at and its number.
    pub fn new(source: Source, seconds: f64, mut interval: impl FnMut(f64, usize) -> f64) -> Self {
        let quadrature = Quadrature::plan(source.course.bound().bandwidth, 0.1).finest();
        let (mut times_s, mut samples) = (vec![0.0], Vec::new());
        let mut now = 0.0;
        while now < seconds {
            let next = now + interval(now, samples.len()) / source.rate_hz();
            samples.push(quadrature.increment(&source.course, now, next));
            times_s.push(next);
            now = next;
        }
        let interval_s = Pair::new(source.rate_hz()).reciprocal();
        Self { source, interval_s, times_s, samples }
    }

    /// At rest, at 100 Hz.
    fn at_rest(seconds: f64, interval: impl FnMut(f64, usize) -> f64) -> Self {
        let mut scene = at_rest(seconds);
        scene.rate_hz = 100.0;
        Self::new(Source::new(&scene, false).unwrap(), seconds, interval)
    }

    /// The violent flight, at 100 Hz.
    fn manoeuvre(seconds: f64, interval: impl FnMut(f64, usize) -> f64) -> Self {
        Self::new(Course::new("manoeuvre", 1.0, 0.1).source, seconds, interval)
    }

    pub fn initial<R: Scalar>(&self) -> Solution<R> {
        Solution::narrow(&self.source.initial(0))
    }

    /// Each sample with its interval.
    pub fn stream<R: Scalar>(&self) -> impl Iterator<Item = (Increment<R>, Pair<R>)> {
        let mut carried = Carried::default();
        let intervals = self.times_s.windows(2).map(|edge| Pair::new(edge[1] - edge[0]));
        let narrow = move |(sample, interval)| (carried.narrow(sample), Pair::narrow(interval));
        self.samples.iter().zip(intervals).map(narrow)
    }

    /// The largest distance from the truth over every row, m.
    fn largest_miss<M: UnequalIntervals<Real: Scalar>>(&self, mechanization: &M) -> f64 {
        let (mut largest, mut rows) = (0.0_f64, 0);
        let mut read = |n: u64, row: M::Output| {
            rows += 1;
            assert_eq!(n, rows);
            let truth = self.source.course.at(self.times_s[n as usize]).solution();
            let miss = drift(&row.wide(), &truth).position_ned.norm();
            largest = if miss <= largest { largest } else { miss };
        };
        let mut state = mechanization.start(&self.initial()).unwrap();
        for (sample, interval_s) in self.stream() {
            mechanization
                .push_rows_over(&mut state, sample, interval_s, reader(&mut read))
                .unwrap();
        }
        mechanization.finish_rows(&mut state, reader(&mut read));
        assert_eq!(rows, self.samples.len() as u64);
        largest
    }
}

pub fn jitter(share: f64) -> impl FnMut(f64, usize) -> f64 {
    let mut numbers = Numbers(12);
    move |_, _| 1.0 + numbers.within(share)
}

/// Runs of `push` and of `push_over` by turns, against `push` of the plain window.
pub fn same_bits<P, U>(course: &Course, plain: &P, unequal: &U, interval_s: Pair<f64>, name: &str)
where
    P: Mechanization<Real = f64, Frame: Record>,
    U: UnequalIntervals<Real = f64, Frame = P::Frame>,
{
    let mut expected = plain.start(&course.initial()).unwrap();
    let mut state = unequal.start(&course.initial()).unwrap();
    let (mut rows, mut other) = (Vec::new(), Vec::new());
    let mut numbers = Numbers(3);
    let mut over = true;
    for &sample in &course.samples {
        if numbers.word().is_multiple_of(7) {
            over = !over;
        }
        plain
            .push_rows(&mut expected, sample, |n, row| rows.push((n, format!("{:?}", row.wide()))))
            .unwrap();
        let mut read = |n, row: U::Output| other.push((n, format!("{:?}", row.wide())));
        if over {
            unequal.push_rows_over(&mut state, sample, interval_s, reader(&mut read)).unwrap();
        } else {
            unequal.push_rows(&mut state, sample, reader(&mut read)).unwrap();
        }
        assert_eq!(bits(U::frame(&state)), bits(P::frame(&expected)), "{name}");
    }
    plain.finish(&mut expected);
    unequal.finish(&mut state);
    assert_eq!(rows, other, "{name}");
    assert_eq!(bits(U::frame(&state)), bits(P::frame(&expected)), "{name} at the end");
}

fn constant<F: Frame<Real = f64> + Record, W: Window>() {
    // Slow enough for every window: no block turns by 2 rad.
    let course = Course::new("hard", 1.0, 1.0);
    let interval_s = course.interval_s;
    let plain = Strapdown::<F, W>::new(interval_s).unwrap();
    let unequal = Strapdown::<F, Unequal<W>>::new(interval_s).unwrap();
    same_bits(&course, &plain, &unequal, interval_s, &format!("{:?}", W::SHAPE));
}

#[test]
fn at_the_nominal_interval_nothing_changes() {
    for_every_window!(constant, Local);
    constant::<Earth, H2B4A2>();
    constant::<Earth, Line8>();
    let course = Course::new("manoeuvre", 1.0, 1.0);
    let interval_s = Pair::new(0.01);
    let local = Textbook::<LocalLevelTextbook<f64>>::new(0.01).unwrap();
    same_bits(&course, &local, &local, interval_s, "local-level textbook");
    let earth = Textbook::<EarthFixedTextbook<f64>>::new(0.01).unwrap();
    same_bits(&course, &earth, &earth, interval_s, "earth-fixed textbook");
}

/// At rest, whatever the intervals: 100 → 120 Hz, a slow wander, jitter.
fn rests<F: Frame<Real: Scalar>, W: Window>(bound_m: f64) {
    let changes = |time: f64, _: usize| if time < 10.0 { 1.0 } else { 1.0 / 1.2 };
    let wanders = |time: f64, _: usize| 1.0 + 0.01 * (TAU * time / 20.0).sin();
    let flights = [
        Uneven::at_rest(30.0, changes),
        Uneven::at_rest(30.0, wanders),
        Uneven::at_rest(30.0, jitter(0.2)),
        Uneven::at_rest(30.0, jitter(0.75)),
        Uneven::at_rest(30.0, |_, n| if n % 100 == 50 { 10.0 } else { 1.0 }),
    ];
    for (n, flight) in flights.iter().enumerate() {
        let interval_s = Pair::narrow(flight.interval_s);
        let strapdown = Strapdown::<F, Unequal<W>>::new(interval_s).unwrap();
        let miss = flight.largest_miss(&strapdown);
        assert!(miss <= bound_m, "{:?}, flight {n}: {miss} m", W::SHAPE);
    }
}

fn rests_in_double<F: Frame<Real = f64>, W: Window>() {
    rests::<F, W>(1e-8);
}

#[test]
fn at_rest_time_is_what_the_intervals_say() {
    for_every_window!(rests_in_double, Local);
    for_every_window!(rests_in_double, Earth);
    rests::<LocalLevel<Pair<f32>>, H0B4A0>(1e-3);
    rests::<LocalLevel<TwoFloat<f32>>, H2B4A2>(1e-4);
}

#[test]
fn a_violent_flight_loses_nothing_to_jitter() {
    fn miss<F: Frame<Real: Scalar>, W: Window>(flight: &Uneven) -> f64 {
        let interval_s = Pair::narrow(flight.interval_s);
        flight.largest_miss(&Strapdown::<F, Unequal<W>>::new(interval_s).unwrap())
    }
    let flight = Uneven::manoeuvre(30.0, jitter(0.2));
    for miss in [
        miss::<Local, H2B4A2>(&flight),
        miss::<Earth, H2B4A2>(&flight),
        miss::<Local, H4B4A4>(&flight),
    ] {
        assert!(miss <= 1e-8, "{miss} m");
    }
    assert!(miss::<Local, H0B4A0>(&flight) <= 1e-4);
    assert!(miss::<LocalLevel<TwoFloat<f32>>, H2B4A2>(&flight) <= 1e-3);
    let textbook = Textbook::<LocalLevelTextbook<f64>>::new(0.01).unwrap();
    let (uneven, even) = (
        flight.largest_miss(&textbook),
        Uneven::manoeuvre(30.0, |_, _| 1.0).largest_miss(&textbook),
    );
    assert!(uneven <= 2.0 * even, "textbook: {uneven} m, {even} m at equal intervals");
    assert!(miss::<Local, H4B4A4>(&Uneven::manoeuvre(30.0, jitter(0.75))) <= 1e-7);
}

#[test]
fn motion_that_is_not_resolved_throws_no_uneven_window_off() {
    // Vibration within the samples: what one has too much, the next has too little.
    for interval in [(4, 1.0, 1.75), (500, 10.0, 1.0), (700, 40.0, 1.0)] {
        let (every, long, short) = interval;
        let mut flight =
            Uneven::at_rest(30.0, |_, n| if n % every == every / 2 { long } else { short });
        let (mut numbers, mut last) = (Numbers(5), Increment::ZERO);
        for sample in &mut flight.samples {
            let next =
                Increment { angle_b: numbers.vector(1e-3), velocity_b: numbers.vector(1e-2) };
            sample.angle_b = sample.angle_b + next.angle_b - last.angle_b;
            sample.velocity_b = sample.velocity_b + next.velocity_b - last.velocity_b;
            last = next;
        }
        let miss = |strapdown: &dyn Fn(&Uneven) -> f64| strapdown(&flight);
        let interval_s = flight.interval_s;
        let windows: [&dyn Fn(&Uneven) -> f64; 4] = [
            &|f| f.largest_miss(&Strapdown::<Local, Unequal<H0B4A0>>::new(interval_s).unwrap()),
            &|f| f.largest_miss(&Strapdown::<Local, Unequal<H4B4A0>>::new(interval_s).unwrap()),
            &|f| f.largest_miss(&Strapdown::<Local, Unequal<H2B4A2>>::new(interval_s).unwrap()),
            &|f| f.largest_miss(&Strapdown::<Local, Unequal<H4B4A4>>::new(interval_s).unwrap()),
        ];
        let misses = windows.map(miss);
        assert!(misses.iter().all(|&miss| miss <= 1.0), "{interval:?}: {misses:?}");
    }
}

/// Whatever is refused leaves the state as it was, and a restored state goes on bit for bit.
fn refuses<M: UnequalIntervals<Real = f64, State: Record>>(mechanization: &M) {
    let flight = Uneven::manoeuvre(1.0, jitter(0.5));
    let mut state = mechanization.start(&flight.initial()).unwrap();
    let other = state;
    for (n, (sample, interval_s)) in flight.stream::<f64>().enumerate() {
        let before = bits(&state);
        for bad in [0.0, -0.0, -0.01, 1.0001, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for bad in [Pair::new(bad), Pair { hi: 0.01, lo: bad - 0.01 }] {
                let refused = mechanization.push_over(&mut state, sample, bad);
                assert_eq!(refused, Err(Rejected::Interval), "{bad:?}");
                assert_eq!(bits(&state), before);
            }
        }
        let mut wrong = sample;
        wrong.angle_b.x = f64::NAN;
        let refused = mechanization.push_over(&mut state, wrong, interval_s);
        assert_eq!(refused, Err(Rejected::Angle));
        // Within 10⁵ m/s² for a second, but not for a hundredth.
        let mut wrong = sample;
        wrong.velocity_b.y = 1.6e3;
        let refused = mechanization.push_over(&mut state, wrong, interval_s);
        assert_eq!(refused, Err(Rejected::Velocity));
        assert_eq!(bits(&state), before, "after {n}");
        assert_eq!(mechanization.push_over(&mut { state }, wrong, Pair::new(0.02)), Ok(()));

        let mut words = before.iter();
        let mut copy = other;
        copy.restore("", &mut |_, _| *words.next().unwrap());
        assert_eq!(bits(&copy), before);
        for state in [&mut state, &mut copy] {
            mechanization.push_over(state, sample, interval_s).unwrap();
        }
        assert_eq!(bits(&copy), bits(&state), "after {n}");
        mechanization.finish(&mut copy);
        assert_eq!(M::integrated(&copy), n as u64 + 1);
    }
}

#[test]
fn a_wrong_interval_is_refused_and_leaves_no_trace() {
    let interval_s = Pair::new(0.01);
    refuses(&Strapdown::<Local, Unequal<H2B4A2>>::new(interval_s).unwrap());
    refuses(&Strapdown::<Earth, Unequal<H0B4A0>>::new(interval_s).unwrap());
    refuses(&Strapdown::<Local, Unequal<Line8>>::new(interval_s).unwrap());
    refuses(&Textbook::<LocalLevelTextbook<f64>>::new(0.01).unwrap());
    refuses(&Textbook::<EarthFixedTextbook<f64>>::new(0.01).unwrap());
    let message = Rejected::Interval.to_string();
    assert!(message.contains("above 0 s and at most 1 s"), "{message}");
}
