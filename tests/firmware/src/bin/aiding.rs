//! What aiding costs on the target: instructions (or cycles) of a step of the filter, of a scalar measurement and of an
//! aided flight, as `key = value` lines.

#![no_std]
#![no_main]

use core::hint::black_box;
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::Measured;
use schuler::aiding::aided::navigator::Aided;
use schuler::aiding::aided::settings::{Settings, Start, States};
use schuler::aiding::aided::state::AidedState;
use schuler::aiding::filter::Filter15;
use schuler::aiding::measurement;
use schuler::aiding::states::Process;
use schuler::aiding::surroundings::{Pose, Surroundings};
use schuler::aiding::transition::{Stretch, Transition};
use schuler::prelude::*;
use schuler_firmware::board::{Counter, stack::Painted};
use schuler_firmware::fault::Fault;

/// Steps and measurements that a mean is taken over.
const TIMES: u32 = 64;
/// Samples of a flight, at 100 Hz, with a position every second.
const SAMPLES: u64 = 1000;
/// A short memory: what is late by half a second is taken.
type Flight = Aided<Navigator4<f32>, 15, 120, 0, 8, 4>;
type Flying = AidedState<Navigator4<f32>, 15, 120, 0, 8, 4>;

schuler_firmware::measuring!(measure);

/// A MEMS unit whose biases walk.
fn states() -> States<f32> {
    let walk = Process::random_walk;
    States::new(3e-5, 8e-4, walk(5e-5, 1e-7), walk(1e-3, 1e-6))
}

fn three(x: f32) -> Vector<f32> {
    Vector::new(x, x, x)
}

#[inline(never)]
fn measure() -> Result<(), Fault> {
    let counter = Counter::start().ok_or(Fault::Counter)?;
    let attitude = Euler { roll: 0.1, pitch: -0.1, yaw: 1.0 };
    let at = Geodetic { latitude: 0.8, longitude: 0.1, altitude: 200.0 };
    let start = Solution::new(at, Vector::ZERO, attitude);
    let (pose, here) = (Pose::of(&start), Surroundings::at(&at));
    let model = states().model();
    let mut filter = Filter15::<f32>::new(&model);
    filter.add_uncertainty(0, three(1.0), &pose);
    filter.add_uncertainty(3, three(0.1), &pose);
    filter.add_uncertainty(6, three(0.01), &pose);
    let stretch = Stretch {
        time_s: 0.1,
        rotation: Quaternion::new(0.0, Vector::new(3e-3, -2e-3, 5e-3)).normalised_less_one(),
        velocity: Vector::new(0.1, 0.05, -0.98),
        position: Vector::new(5e-3, 2.5e-3, -0.049),
    };

    let from = counter.now();
    for _ in 0..TIMES {
        let gradient = here.gradient_b(&pose);
        let transition = Transition::new(black_box(&stretch)).with_gradient(&gradient);
        black_box(filter.advance(&model, &transition));
    }
    let counts = counter.between(from, counter.now());
    let each = counter.worth(counts.into()) / f64::from(TIMES);
    defmt::println!("f32 covariance step, bias noise each second = {=f64}", each);

    let long = Stretch { time_s: 1.0, ..stretch };
    let from = counter.now();
    for _ in 0..TIMES {
        let transition = Transition::new(black_box(&long));
        black_box(filter.advance(&model, &transition));
    }
    let counts = counter.between(from, counter.now());
    let each = counter.worth(counts.into()) / f64::from(TIMES);
    defmt::println!("f32 covariance step with bias noise = {=f64}", each);

    let lever = Vector::new(0.5, -0.3, -1.0);
    let rows = measurement::position::<f32, 15>(three(0.0), lever, 1.0);
    let from = counter.now();
    for _ in 0..TIMES {
        black_box(filter.measure(black_box(&rows), 1e9));
    }
    let counts = counter.between(from, counter.now());
    let each = counter.worth(counts.into()) / f64::from(3 * TIMES);
    defmt::println!("f32 scalar measurement with its gate = {=f64}", each);
    let from = counter.now();
    let [row, ..] = rows.rows;
    for _ in 0..TIMES {
        black_box(filter.covariance_mut().measure(black_box(&row), 1.0));
    }
    let counts = counter.between(from, counter.now());
    let each = counter.worth(counts.into()) / f64::from(TIMES);
    defmt::println!("f32 scalar measurement, covariance alone = {=f64}", each);
    defmt::println!("f32 filter, bytes = {=usize}", size_of::<Filter15<f32>>());
    defmt::println!("f32 aided state, bytes = {=usize}", size_of::<Flying>());
    fly(&start, &counter)
}

/// An aided flight at rest.
#[inline(never)]
fn fly(start: &Solution<f32>, counter: &Counter) -> Result<(), Fault> {
    let first = Start { position_m: 1.0, velocity_m_s: 0.1, level_rad: 3e-3, heading_rad: 0.03 };
    let settings =
        Settings { lever_b: Vector::new(0.5, -0.3, -1.0), ..Settings::new(states(), first) };
    let navigator = Navigator4::from_rate_hz(100.0)?;
    let aided = Flight::new(navigator, Pair::of(0.01), settings)?;
    let mut state = aided.start(start)?;
    let up = Pose::of(start).to_body(Vector::new(0.0, 0.0, -9.81));
    let sample = Increment { angle_b: Vector::ZERO, velocity_b: up * 0.01 };
    let stack = Painted::below();
    let mut counts = 0;
    for k in 1..=SAMPLES {
        let from = counter.now();
        if k % 100 == 0 {
            let sigma = three(1.0);
            let fix = Measured::position(Instant::of_sample(k), start.position, sigma);
            aided.measure(&mut state, &fix)?;
        }
        aided.push(&mut state, sample)?;
        counts += u64::from(counter.between(from, counter.now()));
    }
    let each = counter.worth(counts) / SAMPLES as f64;
    defmt::println!("f32 aided, per sample = {=f64}", each);
    defmt::println!("f32 aided, stack, bytes = {=usize}", stack.used());
    black_box(&state);
    Ok(())
}
