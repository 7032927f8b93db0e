//! The table of what windows make of a cone and of noise, worked out from the windows' definition.

use schuler::strapdown::block::gain::gain_squared;
use schuler::strapdown::block::shape::WindowShape;
use schuler::strapdown::block::window::*;
use std::f64::consts::TAU;

/// The least-squares fit, K rows of weights of the samples in Legendre's polynomials over the window.
fn table(shape: WindowShape, coefficients: usize) -> Vec<Vec<f64>> {
    let WindowShape { history, block, lookahead } = shape;
    let samples = history + block + lookahead;
    let edge = |j: usize| 2.0 * (j as f64 - history as f64) / block as f64 - 1.0;
    // Legendre polynomials over the whole window, whose normal equations are well behaved.
    let centre = 0.5 * (edge(0) + edge(samples));
    let half = 0.5 * (edge(samples) - edge(0));
    let legendre = |k: usize, x: f64| {
        let (mut before, mut now) = (0.0, 1.0);
        for n in 0..k {
            let n = n as f64;
            (before, now) = (now, ((2.0 * n + 1.0) * x * now - n * before) / (n + 1.0));
        }
        now
    };
    // ∫P_k = (P_{k+1} − P_{k−1})/(2k + 1)
    let integral = |k: usize, x: f64| {
        let before = if k == 0 { 0.0 } else { legendre(k - 1, x) };
        half * (legendre(k + 1, x) - before) / (2.0 * k as f64 + 1.0)
    };
    let scaled = |j: usize| (edge(j) - centre) / half;
    let matrix: Vec<Vec<f64>> = (0..samples)
        .map(|j| {
            let all = 0..coefficients;
            all.map(|k| integral(k, scaled(j + 1)) - integral(k, scaled(j))).collect()
        })
        .collect();
    let dot = |a: usize, b: usize| matrix.iter().map(|row| row[a] * row[b]).sum::<f64>();
    let mut system: Vec<Vec<f64>> = (0..coefficients)
        .map(|a| {
            let left = (0..coefficients).map(|b| dot(a, b));
            left.chain(matrix.iter().map(|row| row[a])).collect()
        })
        .collect();
    for i in 0..coefficients {
        let pivot = system[i].clone();
        for (r, row) in system.iter_mut().enumerate() {
            let factor = row[i] / pivot[i];
            for (x, p) in row.iter_mut().zip(&pivot) {
                *x = if r == i { p / pivot[i] } else { *x - factor * p };
            }
        }
    }
    system.into_iter().map(|row| row[coefficients..].to_vec()).collect()
}

/// Points of a fine midpoint rule over the block.
const POINTS: usize = 4000;

/// The weights of the samples in the fitted rate at points over the block, per unit of σ.
fn weights(shape: WindowShape, coefficients: usize) -> Vec<Vec<f64>> {
    weights_at(shape, coefficients, POINTS)
}

/// The same at so many points.
fn weights_at(shape: WindowShape, coefficients: usize, points: usize) -> Vec<Vec<f64>> {
    let WindowShape { history, block, lookahead } = shape;
    let samples = history + block + lookahead;
    let edge = |j: usize| 2.0 * (j as f64 - history as f64) / block as f64 - 1.0;
    let (centre, half) = (0.5 * (edge(0) + edge(samples)), 0.5 * (edge(samples) - edge(0)));
    let table = table(shape, coefficients);
    let point = |i: usize| {
        let x = ((2 * i + 1) as f64 / points as f64 - 1.0 - centre) / half;
        let mut sum = vec![0.0; samples];
        let (mut before, mut now) = (0.0, 1.0);
        for (n, row) in table.iter().enumerate() {
            sum.iter_mut().zip(row).for_each(|(sum, a)| *sum += now * a);
            let n = n as f64;
            (before, now) = (now, ((2.0 * n + 1.0) * x * now - n * before) / (n + 1.0));
        }
        sum
    };
    (0..points).map(point).collect()
}

fn gain(shape: WindowShape, coefficients: usize) -> f64 {
    let weights = weights(shape, coefficients);
    let mean = weights.iter().flatten().map(|a| a * a).sum::<f64>() / POINTS as f64;
    mean.sqrt() * 2.0 / shape.block as f64
}

/// The cone's increments, so many from one on.
fn increments(first: i32, count: usize, beta: f64) -> Vec<(f64, f64)> {
    (0..count)
        .map(|j| {
            let middle = beta * (f64::from(first) + j as f64 + 0.5);
            let length = 2.0 * (0.5 * beta).sin() / beta;
            (length * middle.cos(), length * middle.sin())
        })
        .collect()
}

/// The sum of increments as weighed.
fn weigh(weights: &[f64], increments: &[(f64, f64)]) -> (f64, f64) {
    let terms = weights.iter().zip(increments);
    terms.fold((0.0, 0.0), |sum, (a, x)| (sum.0 + a * x.0, sum.1 + a * x.1))
}

/// ∫χ × ω over the two samples before a block and its first two, χ the angle by the polynomial centred on
/// each sample less that by the polynomial it was integrated by, ω by the cubic through the four.
fn lacking(WindowShape { history, block, lookahead }: WindowShape, beta: f64) -> f64 {
    let samples = history + block + lookahead;
    let points = POINTS / block;
    let own = weights(WindowShape { history, block, lookahead }, samples);
    let centred = weights_at(WindowShape::new(samples / 2, 1, samples / 2), samples + 1, points);
    let cubic = weights(WindowShape::new(0, block, 0), block);
    let of_block = 2.0 / block as f64;
    let (near, step) = (increments(-2, 4, beta), 1.0 / points as f64);
    let mut lacking = 0.0;
    for j in -2..2 {
        let begun = if j < 0 { -(block as i32) } else { 0 };
        let seen = increments(begun - history as i32, samples, beta);
        let about = increments(j - samples as i32 / 2, samples + 1, beta);
        let mut angle = (0.0, 0.0);
        for (point, centred) in centred.iter().enumerate().take(points) {
            let of = |start: i32| (j - start) as usize * points + point;
            // Per sample: a block of one is two units of σ, one of four likewise.
            let a = weigh(centred, &about);
            let b = weigh(&own[of(begun)], &seen);
            let rate = (2.0 * a.0 - of_block * b.0, 2.0 * a.1 - of_block * b.1);
            let half = (angle.0 + 0.5 * step * rate.0, angle.1 + 0.5 * step * rate.1);
            let turning = weigh(&cubic[of(-2)], &near);
            lacking += step * of_block * (half.0 * turning.1 - half.1 * turning.0);
            angle = (angle.0 + step * rate.0, angle.1 + step * rate.1);
        }
    }
    lacking
}

/// (computed − true)/true of a cone's drift, where the correction is what is computed.
fn response(shape: WindowShape, coefficients: usize, samples_per_cycle: f64) -> f64 {
    let WindowShape { history, block, lookahead } = shape;
    let beta = TAU / samples_per_cycle;
    let increments = increments(-(history as i32), history + block + lookahead, beta);
    let step = 2.0 / POINTS as f64;
    // ½Im ∫α*ω over the block, of the fit and of the rotation itself
    let (mut angle, mut drift) = ((0.0, 0.0), 0.0);
    for weights in weights(shape, coefficients) {
        let rate = weigh(&weights, &increments);
        let half = (angle.0 + 0.5 * step * rate.0, angle.1 + 0.5 * step * rate.1);
        drift += 0.5 * step * (half.0 * rate.1 - half.1 * rate.0);
        angle = (angle.0 + step * rate.0, angle.1 + step * rate.1);
    }
    if matches!(shape, H2B4A2::SHAPE | H4B4A4::SHAPE) {
        drift += lacking(shape, beta);
    }
    let phase = beta * block as f64;
    let exact = 0.5 * (phase - phase.sin()) / (beta * beta);
    (drift - exact) / (0.5 * phase / (beta * beta))
}

/// Each named window with the number of its coefficients.
fn windows() -> Vec<(WindowShape, usize)> {
    macro_rules! list {
        ($($window:ident),+) => { vec![$(($window::SHAPE, $window::COEFFICIENTS)),+] };
    }
    schuler::strapdown::block::window::every_window! { list! }
}

/// Whether a number has the digits that are printed of it.
fn is_printed(x: f64, cell: &str) -> bool {
    let cell = cell.replace('−', "-");
    let (digits, exponent) = cell.split_once('e').unwrap_or((&cell, "0"));
    let places = digits.split_once('.').map_or(0, |(_, after)| after.len()) as i32;
    let last = 10.0_f64.powi(exponent.parse::<i32>().unwrap() - places);
    (x - cell.parse::<f64>().unwrap()).abs() <= 0.55 * last
}

#[test]
fn the_table_of_windows_says_what_they_do() {
    let text = include_str!("../../../core/src/strapdown/block/WINDOWS.md");
    let rows: Vec<Vec<&str>> = text
        .lines()
        .filter(|line| line.starts_with("| `"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    assert_eq!(rows.len(), windows().len());
    for (shape, coefficients) in windows() {
        let name = format!("`{shape}`");
        let row = rows.iter().find(|row| row[0] == name).unwrap_or_else(|| panic!("{name}"));
        for (cell, samples) in row[1..8].iter().zip([2.2, 2.5, 3.0, 4.0, 5.0, 8.0, 20.0]) {
            let x = response(shape, coefficients, samples);
            // The midpoint rule is good to about 1e-7 of the whole.
            assert!(is_printed(x, cell) || x.abs() < 1e-6, "{name} at {samples}: {x:e} {cell}");
        }
        let x = gain(shape, coefficients);
        assert!(is_printed(x, row[8]), "{name}: {x} {}", row[8]);
    }
}

#[test]
fn gains_of_interpolating_windows() {
    for (block, history, lookahead) in (1..=4)
        .flat_map(|b| (0..=10).map(move |h| (b, h)))
        .flat_map(|(b, h)| (0..=10).map(move |a| (b, h, a)))
        .filter(|(b, h, a)| b + h + a <= 11)
    {
        let shape = WindowShape { history, block, lookahead };
        let [own, other] = [gain_squared(shape).sqrt(), gain(shape, history + block + lookahead)];
        assert!((own / other - 1.0).abs() < 1e-3, "{shape:?}: {own} {other}");
    }
}
