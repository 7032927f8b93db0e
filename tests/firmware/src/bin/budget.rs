//! What the core costs on the target: instructions (or cycles), stack and state, as `key = value` lines.

#![no_std]
#![no_main]

use core::hint::black_box;
use schuler::imu::Quadrature;
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::noise::{Deviate, Stream};
use schuler::sample::Increment;
use schuler::flight::carried::Carried;
use schuler::solution::Solution;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::limits::Rejected;
use schuler::strapdown::navigator::Strapdown;
use schuler::flight::configuration::Precision;
use schuler::strapdown::reference::textbook::{LocalLevelTextbook, Textbook};
use schuler::strapdown::block::window::{H0B4A0, Window as _};
use schuler::trajectory::Trajectory as _;
use schuler_firmware::board::{self, Counter, stack::Painted};
use schuler_firmware::fault::Fault;
use schuler_firmware::navigation::planned;
use schuler_firmware::paper::{self, Course, RATE_HZ, SEED};

/// Samples that a mean is taken over: whole blocks.
const SAMPLES: usize = 64;
/// Samples before them: past the first block, which is unlike the others.
const BEFORE: u32 = 40;
/// Rounds over the samples that the sensors' mean is taken over, since noise is cheap or dear by chance.
const SENSOR_ROUNDS: usize = 64;
/// Samples between two readings of the counter. Where QEMU counts instructions, whole flights, since a count
/// is many of them; on a board one, or 24 bits would turn over.
const AT_ONCE: usize = if cfg!(feature = "semihosting") { SAMPLES } else { 1 };
/// Random blocks whose worst is compared with their mean; without hardware for f32, a tenth of them.
const BLOCKS: usize = if cfg!(target_abi = "eabihf") { 10_000 } else { 1000 };
/// Times that each is flown, to see a fraction of a count.
const REPEATS: u32 = 8;

schuler_firmware::measuring!(measure);

#[inline(never)]
fn measure() -> Result<(), Fault> {
    let counter = Counter::start().ok_or(Fault::Counter)?;
    defmt::println!("board = {=str}", board::NAME);
    defmt::println!("unit = {=str}", board::UNIT);
    let motion = Motion::new()?;
    let bound = motion.course.bound();

    let single: Strapdown<LocalLevel<Pair<f32>>, H0B4A0> = planned(Precision::F32, bound)?;
    mechanization("f32", &single, &motion, &counter)?;
    spread(&single, &motion, &counter)?;
    let precise: Strapdown<LocalLevel<TwoFloat<f32>>, H0B4A0> = planned(Precision::F32x2, bound)?;
    mechanization("f32x2", &precise, &motion, &counter)?;
    let textbook = Textbook::<LocalLevelTextbook<f32>>::new(1.0 / RATE_HZ as f32)?;
    mechanization("f32 textbook", &textbook, &motion, &counter)?;
    let double: Strapdown<LocalLevel<Pair<f64>>, H0B4A0> = planned(Precision::F64, bound)?;
    mechanization("f64", &double, &motion, &counter)?;

    error_terms::<f32>("f32 error terms", &motion, &counter)?;
    error_terms::<f64>("f64 error terms", &motion, &counter)?;
    let from = counter.now();
    for n in 1..=8 {
        black_box(motion.sample(BEFORE + n));
    }
    let counts = counter.between(from, counter.now());
    defmt::println!(
        "f64 perfect increments, per sample = {=f64}",
        counter.worth(counts.into()) / 8.0
    );
    Ok(())
}

/// A navigator in the middle of the flight, and the samples that come next.
struct UnderWay<M: Mechanization> {
    state: M::State,
    samples: [Increment<M::Real>; SAMPLES],
}

/// The paper's motion.
struct Motion {
    course: Course,
    quadrature: Quadrature,
}

impl Motion {
    fn new() -> Result<Self, Fault> {
        let course = paper::course()?;
        let quadrature = Quadrature::plan(course.bound().bandwidth, 1.0 / RATE_HZ);
        Ok(Self { course, quadrature })
    }

    #[inline(never)]
    fn sample(&self, sample: u32) -> Increment<f64> {
        self.quadrature.sample(&self.course, sample.into(), RATE_HZ)
    }

    /// A navigator under way, and the samples that come next.
    fn under_way<M: Mechanization<Real: Scalar>>(
        &self,
        mechanization: &M,
    ) -> Result<UnderWay<M>, Fault> {
        let initial = Solution::narrow(&self.course.at(0.0).initial());
        let mut state = mechanization.start(&initial)?;
        let mut carried = Carried::default();
        for n in 1..=BEFORE {
            mechanization.push(&mut state, carried.narrow(&self.sample(n)))?;
        }
        let mut samples = [Increment::ZERO; SAMPLES];
        for (sample, n) in samples.iter_mut().zip(BEFORE + 1..) {
            *sample = carried.narrow(&self.sample(n));
        }
        Ok(UnderWay { state, samples })
    }
}

/// Flies samples, block ends only.
#[inline(never)]
fn fly<M: Mechanization>(
    mechanization: &M,
    state: &mut M::State,
    samples: &[Increment<M::Real>],
) -> Result<(), Rejected> {
    for &sample in samples {
        mechanization.push(state, sample)?;
    }
    Ok(())
}

/// Cost per sample, stack and state of a mechanization.
#[inline(never)]
fn mechanization<M: Mechanization<Real: Scalar>>(
    name: &str,
    mechanization: &M,
    motion: &Motion,
    counter: &Counter,
) -> Result<(), Fault> {
    let UnderWay { state: under_way, samples } = motion.under_way(mechanization)?;
    let mut state = under_way;
    let mut counts = 0;
    for samples in samples.chunks(AT_ONCE) {
        let from = counter.now();
        fly(mechanization, &mut state, samples)?;
        counts += u64::from(counter.between(from, counter.now()));
    }
    let each = counter.worth(counts) / SAMPLES as f64;
    defmt::println!("{=str}, per sample = {=f64}", name, each);

    let mut state = under_way;
    let stack = Painted::below();
    fly(mechanization, &mut state, &samples)?;
    defmt::println!("{=str}, stack, bytes = {=usize}", name, stack.used());
    defmt::println!("{=str}, state, bytes = {=usize}", name, size_of::<M::State>());
    black_box(&state);
    Ok(())
}

/// The dearest of many random blocks over their mean.
#[inline(never)]
fn spread<M: Mechanization<Real = f32>>(
    mechanization: &M,
    motion: &Motion,
    counter: &Counter,
) -> Result<(), Fault> {
    let under_way = motion.under_way(mechanization)?.state;
    let mut stream = Stream::new(SEED, 0, 0);
    let (mut sum, mut worst) = (0u64, 0u32);
    for _ in 0..BLOCKS {
        // Up to 0.2 rad and 5 m/s in a sample: 230 °/s and 10 g.
        let mut within = |bound: f32| bound * (2.0 * stream.uniform::<f32>() - 1.0);
        let mut samples = [Increment::ZERO; H0B4A0::BLOCK];
        for sample in &mut samples {
            sample.angle_b = Vector::new((), (), ()).map(|()| within(0.2));
            sample.velocity_b = Vector::new((), (), ()).map(|()| within(5.0));
        }
        let mut counts = 0;
        for _ in 0..REPEATS {
            let mut state = under_way;
            let from = counter.now();
            fly(mechanization, &mut state, &samples)?;
            counts += counter.between(from, counter.now());
        }
        sum += u64::from(counts);
        worst = worst.max(counts);
    }
    let mean = sum as f64 / BLOCKS as f64;
    defmt::println!("f32, worst block over mean = {=f64}", f64::from(worst) / mean);
    Ok(())
}

/// Cost per sample of the paper's error terms, given perfect samples.
#[inline(never)]
fn error_terms<R: Deviate>(name: &str, motion: &Motion, counter: &Counter) -> Result<(), Fault> {
    let sensors = paper::sensors::<R>(SAMPLES as u64)?;
    let mut state = sensors.start(SEED, 0);
    let perfect = motion.sample(BEFORE);
    let perfect = Carried::default().narrow::<R>(&perfect);
    let mut counts = 0;
    for _ in 0..SENSOR_ROUNDS * SAMPLES / AT_ONCE {
        let from = counter.now();
        for _ in 0..AT_ONCE {
            black_box(&sensors.emulate(&mut state, black_box(&perfect)));
        }
        counts += u64::from(counter.between(from, counter.now()));
    }
    let each = counter.worth(counts) / (SAMPLES * SENSOR_ROUNDS) as f64;
    defmt::println!("{=str}, per sample = {=f64}", name, each);
    Ok(())
}
