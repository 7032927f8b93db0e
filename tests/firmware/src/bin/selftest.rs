//! Flies the paper's scene on the target alone: truth and sensors in f64, navigators in f32, f32x2 and
//! f64. Reports `key = value` lines, and ends with 0 if everything keeps its bounds.

#![no_std]
#![no_main]

use core::hint::black_box;
use schuler::drift::compare::drift;
use schuler::imu::Quadrature;
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::flight::configuration::Precision;
use schuler::strapdown::block::window::{H0B4A0, Window as _};
use schuler::trajectory::Trajectory as _;
use schuler_firmware::board::{self, Counter, entry, stack::Painted};
use schuler_firmware::fault::Fault;
use schuler_firmware::navigation::{Navigation, larger, planned};
use schuler_firmware::paper::{self, RATE_HZ, SEED, time_s};

// What a test may set otherwise in the image: the runner's `--set`.

/// Length of the flight, s.
static FLIGHT_S: u32 = 1800;
/// The largest distance in m that f32 may be from the truth on perfect samples, and from f64 on the
/// same samples.
static SINGLE_BOUND_M: f32 = 0.15;
/// The same for f32x2.
static TWO_FLOAT_BOUND_M: f32 = 5e-3;

#[entry]
fn main() -> ! {
    let stack = Painted::below();
    let passed = match fly() {
        Ok(passed) => passed,
        Err(fault) => {
            defmt::println!("fault = {}", fault);
            false
        }
    };
    defmt::println!("stack_bytes = {=usize}", stack.used());
    defmt::println!("verdict = {=str}", if passed { "passed" } else { "failed" });
    board::exit(passed)
}

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    defmt::println!("fault = panic");
    board::exit(false)
}

#[inline(never)]
fn fly() -> Result<bool, Fault> {
    let counter = Counter::start().ok_or(Fault::Counter)?;
    let mut checks = Checks { passed: true };
    defmt::println!("board = {=str}", board::NAME);
    defmt::println!("unit = {=str}", board::UNIT);
    checks.that("subnormals are kept", keeps_subnormals());

    let samples = *black_box(&FLIGHT_S) * RATE_HZ as u32;
    let course = paper::course()?;
    let bound = course.bound();
    let quadrature = Quadrature::plan(bound.bandwidth, 1.0 / RATE_HZ);
    let sensors = paper::sensors::<f64>(samples.into())?;
    let mut sensor_state = sensors.start(SEED, 0);
    let initial = course.at(0.0).initial();

    type Single = LocalLevel<Pair<f32>>;
    type Double = LocalLevel<Pair<f64>>;
    type Precise = LocalLevel<TwoFloat<f32>>;
    let single = planned::<Single, H0B4A0>(Precision::F32, bound)?;
    let double = planned::<Double, H0B4A0>(Precision::F64, bound)?;
    let precise = planned::<Precise, H0B4A0>(Precision::F32x2, bound)?;
    let mut perfect_single = Navigation::new(single, &initial)?;
    let mut perfect_precise = Navigation::new(precise, &initial)?;
    let mut paper_single = Navigation::new(single, &initial)?;
    let mut paper_double = Navigation::new(double, &initial)?;
    let mut apart_m = 0.0;

    for sample in 1..=samples {
        let perfect = quadrature.sample(&course, sample.into(), RATE_HZ);
        let sensed = sensors.emulate(&mut sensor_state, &perfect);
        perfect_single.push(&counter, &perfect)?;
        perfect_precise.push(&counter, &perfect)?;
        paper_single.push(&counter, &sensed)?;
        paper_double.push(&counter, &sensed)?;
        if (sample as usize).is_multiple_of(H0B4A0::BLOCK) {
            let truth = course.at(time_s(sample)).solution();
            perfect_single.compare(&truth);
            perfect_precise.compare(&truth);
            paper_single.compare(&truth);
            paper_double.compare(&truth);
            let between = drift(&paper_single.solution(), &paper_double.solution());
            let between_m = between.position_ned.norm();
            apart_m = larger(between_m, apart_m);
        }
    }
    defmt::println!("samples = {=u32}", samples);
    report("paper-perfect f32", &mut perfect_single, &counter);
    report("paper-perfect f32x2", &mut perfect_precise, &counter);
    report("paper f32", &mut paper_single, &counter);
    report("paper f64", &mut paper_double, &counter);
    defmt::println!("f32 from f64, largest, m = {=f64}", apart_m);

    let single_m = f64::from(*black_box(&SINGLE_BOUND_M));
    let precise_m = f64::from(*black_box(&TWO_FLOAT_BOUND_M));
    checks.that("f32 keeps its bound", perfect_single.largest_m <= single_m);
    checks.that("f32x2 keeps its bound", perfect_precise.largest_m <= precise_m);
    checks.that("f32 stays with f64", apart_m <= single_m);
    Ok(checks.passed)
}

/// What the flight of a navigator came to.
fn report<M>(flight: &str, navigation: &mut Navigation<M>, counter: &Counter)
where
    M: Mechanization<Real: Scalar, Frame: Record>,
{
    defmt::println!("{=str}, digest = {=u64:016x}", flight, navigation.finish());
    defmt::println!("{=str}, final, m = {=f64}", flight, navigation.final_m);
    defmt::println!("{=str}, largest, m = {=f64}", flight, navigation.largest_m);
    defmt::println!("{=str}, per sample = {=f64}", flight, navigation.cost(counter));
}

/// What was checked so far.
struct Checks {
    passed: bool,
}

impl Checks {
    fn that(&mut self, what: &str, holds: bool) {
        if !holds {
            defmt::println!("failed = {=str}", what);
            self.passed = false;
        }
    }
}

/// Whether the processor keeps numbers below the smallest normal one, as IEEE 754 wants.
fn keeps_subnormals() -> bool {
    let single = black_box(f32::MIN_POSITIVE) * black_box(0.5);
    let double = black_box(f64::MIN_POSITIVE) * black_box(0.5);
    single.to_bits() == 1 << 22 && double.to_bits() == 1 << 51
}
