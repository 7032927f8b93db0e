//! `tests/golden/functions`: the values of the functions that a port needs. With SCHULER_WRITE=1 they are written.

use schuler::earth::{Radii, gravity};
use schuler::flight::carried::Carried;
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::noise::Streams;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::strapdown::block::fit::{table_f32, table_f64};
use schuler::strapdown::reference::textbook::body::Compensated;
use std::fmt::Write as _;
use std::path::Path;

/// Rows of a function with random arguments.
const ROWS: usize = 32;

/// A row: the function, its type, and words as hexadecimal bits.
fn row<R: Scalar>(text: &mut String, name: &str, words: &[R]) {
    let digits = 2 * size_of::<R>();
    let precision = if digits == 8 { "f32" } else { "f64" };
    let _ = write!(text, "{name} {precision}");
    for word in words {
        let _ = write!(text, " {:0digits$x}", word.to_bits());
    }
    text.push('\n');
}

/// Numbers evenly spread over ±bound, rounded to the type.
fn drawn<R: Scalar, const N: usize>(run: u64, bounds: [f64; N]) -> Vec<[R; N]> {
    let mut stream = Streams::new(16, run).open();
    let mut one = |bound: f64| R::narrow(bound * (2.0 * stream.uniform::<f64>() - 1.0));
    (0..ROWS).map(|_| bounds.map(&mut one)).collect()
}

fn of_latitudes<R: Scalar>(gravities: &mut String, radii: &mut String) {
    for [sine, altitude] in [[0.0, 0.0], [1.0, 0.0], [-1.0, 9000.0], [0.5, -400.0]] {
        let (sine, altitude) = (R::narrow(sine), R::narrow(altitude));
        row(gravities, "gravity", &[sine, altitude, gravity(sine, altitude)]);
    }
    for [sine, altitude] in drawn::<R, 2>(0, [1.0, 20_000.0]) {
        row(gravities, "gravity", &[sine, altitude, gravity(sine, altitude)]);
        let cosine = (R::ONE - sine * sine).sqrt();
        let Radii { meridian, prime_vertical, .. } = Radii::at(sine, cosine);
        row(radii, "radii", &[sine, cosine, meridian, prime_vertical]);
    }
}

fn sample<R: Scalar>([ax, ay, az, vx, vy, vz]: [R; 6]) -> Increment<R> {
    Increment { angle_b: Vector::new(ax, ay, az), velocity_b: Vector::new(vx, vy, vz) }
}

fn of_samples<R: Scalar + Record>(text: &mut String) {
    let bounds = [0.1, 0.1, 0.1, 2.0, 2.0, 2.0];
    let all = drawn::<R, 6>(1, bounds);
    for (now, before) in all.iter().zip(all.iter().skip(1)) {
        let mut words = [now.as_slice(), before.as_slice()].concat();
        Compensated::from_samples(&sample(*now), &sample(*before))
            .record("", &mut |_, bits| words.push(R::from_bits(bits)));
        row(text, "textbook", &words);
    }
}

/// The rows of a window's table, a coefficient each.
fn table<const P: usize>(text: &mut String, name: &str, history: usize, block: usize) {
    table_f64::<P>(history, block).iter().for_each(|k| row(text, name, k));
    table_f32::<P>(history, block).iter().for_each(|k| row(text, name, k));
}

/// Each of a stream of samples in double precision, then what is handed on in single.
fn of_carried(text: &mut String) {
    let mut carried = Carried::default();
    for words in drawn::<f64, 6>(2, [1e-3, 1e-3, 1e-3, 0.2, 0.2, 0.2]) {
        let narrow: Increment<f32> = carried.narrow(&sample(words));
        row(text, "wide", &words);
        let [angle, velocity] = [narrow.angle_b, narrow.velocity_b].map(Vector::into_array);
        row(text, "narrow", &[angle, velocity].concat());
        let [angle, velocity] = [carried.angle_b, carried.velocity_b].map(Vector::into_array);
        row(text, "rest", &[angle, velocity].concat());
    }
}

/// Every file with its text.
fn files() -> [(&'static str, String); 5] {
    let [mut gravities, mut radii, mut textbook, mut fit, mut carried] =
        [const { String::new() }; 5];
    of_latitudes::<f64>(&mut gravities, &mut radii);
    of_latitudes::<f32>(&mut gravities, &mut radii);
    of_samples::<f64>(&mut textbook);
    of_samples::<f32>(&mut textbook);
    table::<2>(&mut fit, "fit-0-2-0", 0, 2);
    table::<4>(&mut fit, "fit-0-4-0", 0, 4);
    table::<8>(&mut fit, "fit-2-4-2", 2, 4);
    of_carried(&mut carried);
    [
        ("gravity.txt", gravities),
        ("radii.txt", radii),
        ("textbook.txt", textbook),
        ("fit.txt", fit),
        ("carried.txt", carried),
    ]
}

#[test]
fn the_functions_have_their_golden_values() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/golden/functions");
    for (name, text) in files() {
        let path = folder.join(name);
        if std::env::var_os("SCHULER_WRITE").is_some() {
            std::fs::create_dir_all(&folder).unwrap();
            std::fs::write(&path, &text).unwrap();
        }
        let stored = std::fs::read_to_string(&path).unwrap();
        let differs = stored.lines().zip(text.lines()).position(|(a, b)| a != b);
        assert!(stored == text, "{name} differs from line {differs:?} on");
    }
}

/// The integral of the fitted polynomial over each sample is that sample: another way to the table.
#[test]
fn a_fit_gives_back_its_samples() {
    fn residual<const P: usize>(history: usize, block: usize) -> f64 {
        let table = table_f64::<P>(history, block);
        let mut worst: f64 = 0.0;
        for (j, i) in (0..P).flat_map(|j| (0..P).map(move |i| (j, i))) {
            let edge = |m: usize| 2.0 * (m as f64 - history as f64) / block as f64 - 1.0;
            let over = |k: usize| {
                let n = k as i32 + 1;
                (edge(i + 1).powi(n) - edge(i).powi(n)) / f64::from(n)
            };
            let given: f64 = (0..P).map(|k| table[k][j] * over(k)).sum();
            worst = worst.max((given - f64::from(i == j)).abs());
        }
        worst
    }
    assert!(
        residual::<2>(0, 2) < 1e-14 && residual::<4>(0, 4) < 1e-14 && residual::<8>(2, 4) < 1e-12
    );
}
