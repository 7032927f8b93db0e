//! Flies the built-in `circuit` and `waypoints` at 100 Hz in both frames by perfect samples, and prints how far a
//! navigator gets from the path at any of them. Ends with 1 where that is beyond what rounding leaves.

use schuler::drift::compare::drift;
use schuler::flight::catalogue::Entry;
use schuler::flight::from_double::FromDouble;
use schuler::flight::plan::HIGHEST_ORDER;
use schuler::imu::{Quadrature, instant};
use schuler::math::compensated::Pair;
use schuler::output::Output as _;
use schuler::strapdown::block::window::H4B4A4;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::navigator::Strapdown;
use schuler::trajectory::Trajectory;
use schuler::trajectory::piecewise::piece::Piece;
use schuler::trajectory::piecewise::{Attitude, Piecewise};
use schuler::trajectory::spline::EXTRA;
use schuler_scenes::{circuit, waypoints};
use std::error::Error;
use std::process::ExitCode;

/// The largest distance from the path, m.
const FLOOR_M: f64 = 1e-8;
/// The largest difference of a sample across a joint from its two parts, rad.
const JOINT_RAD: f64 = 1e-16;
const RATE_HZ: f64 = 100.0;
const SAMPLES: u64 = 180_000;
/// Evaluations in each part of a sample.
const NODES: usize = 4;

type Earth = Strapdown<EarthFixed<Pair<f64>>, H4B4A4>;
type Level = Strapdown<LocalLevel<Pair<f64>>, H4B4A4>;

fn main() -> ExitCode {
    let mut well = true;
    let mut show = |what: &str, unit: &str, most: f64, found: Result<f64, Box<dyn Error>>| {
        let kept = matches!(found, Ok(size) if size <= most);
        match found {
            Ok(size) => {
                println!("{what:24} {size:8.1e} {unit}{}", if kept { "" } else { ", too far" })
            }
            Err(error) => println!("{what:24} refused: {error}"),
        }
        well &= kept;
    };
    for (name, path) in [("circuit", segments as fn(bool) -> _), ("waypoints", points)] {
        show(&format!("{name}, earth-fixed"), "m", FLOOR_M, path(true));
        show(&format!("{name}, local-level"), "m", FLOOR_M, path(false));
    }
    show("across a joint", "rad", JOINT_RAD, joint());
    if well { ExitCode::SUCCESS } else { ExitCode::from(1) }
}

/// `circuit` in either frame.
fn segments(earth_fixed: bool) -> Result<f64, Box<dyn Error>> {
    let pieces: Vec<_> = circuit::compiler()?.collect::<Result<_, _>>()?;
    farthest(&Piecewise::new(pieces, Attitude::Stored)?, earth_fixed)
}

/// `waypoints` in either frame.
fn points(earth_fixed: bool) -> Result<f64, Box<dyn Error>> {
    let mut control = [[0.0; 4]; waypoints::POINTS + EXTRA];
    let path = waypoints::path(&waypoints::TIMES_S, &mut control)?;
    let pieces: Vec<_> = (0..path.pieces()).filter_map(|index| path.piece(index)).collect();
    farthest(&Piecewise::new(pieces, waypoints::ATTITUDE)?, earth_fixed)
}

fn farthest(course: &impl Trajectory<f64>, earth_fixed: bool) -> Result<f64, Box<dyn Error>> {
    if earth_fixed { fly::<Earth>(course) } else { fly::<Level>(course) }
}

/// The largest distance from a motion at any sample.
fn fly<M: Entry>(course: &impl Trajectory<f64>) -> Result<f64, Box<dyn Error>> {
    let interval_s = Pair::new(RATE_HZ).reciprocal();
    let initial = course.initial_at(Pair::new(0.0));
    let mut flying = FromDouble::<M>::start(interval_s, HIGHEST_ORDER, &initial)?;
    let mut largest_m = 0.0;
    let mut see = |sample: u64, output: M::Output| {
        let truth = course.solution_at(instant(sample as f64, RATE_HZ));
        let apart_m = drift(&output.wide(), &truth).position_ned.norm();
        // Not a number stays.
        largest_m = if apart_m <= largest_m { largest_m } else { apart_m };
    };
    let quadrature = Quadrature::of_nodes(NODES);
    for sample in 1..=SAMPLES {
        let increment = quadrature.sample(course, sample, RATE_HZ);
        flying.push_by(&increment, &mut |m, state, sample| m.push_rows(state, sample, &mut see))?;
    }
    flying.flight.finish_by(|m, state| m.finish_rows(state, &mut see));
    Ok(largest_m)
}

/// How far the rotation of a sample across a joint, where the third derivative of the attitude jumps, is from the
/// sum of its parts.
fn joint() -> Result<f64, Box<dyn Error>> {
    let mut pieces = [Piece::<8>::new(0.0, 0.995), Piece::<8>::new(0.995, 2.0)];
    for piece in &mut pieces {
        piece.coefficients[0] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    }
    // 10(t − t₀)³, u = t − t₀ − h
    let h = pieces[1].middle_s - 0.995;
    for (row, c) in pieces[1].coefficients.iter_mut().zip([h * h * h, 3.0 * h * h, 3.0 * h, 1.0]) {
        row[5] += 10.0 * c;
    }
    let course = Piecewise::new(pieces, Attitude::Stored)?;
    let rotation =
        |from_s, to_s| Quadrature::of_nodes(NODES).increment(&course, from_s, to_s).angle_b;
    Ok((rotation(0.99, 0.995) + rotation(0.995, 1.0) - rotation(0.99, 1.0)).norm())
}
