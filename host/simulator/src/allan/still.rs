//! Whether a unit stood still, and where it did not.
//!
//! The means of pieces of a second hardly differ from piece to piece at rest, whatever the sensor's errors. A
//! step far beyond the usual one is motion, and so is a piece that scatters far more within.

use crate::quartile::quartile;
use schuler::sample::Increment;

/// Length of the pieces, s, and their fewest samples.
const PIECE_S: f64 = 1.0;
const FEWEST: u32 = 8;
/// A step so many usual ones long is motion: of a million normal deviates none is.
const STEP: f64 = 8.0;
/// A piece that scatters so many times as much as usual is motion.
const SCATTER: f64 = 4.0;

/// What a piece reads: mean and scatter of six axes.
#[derive(Clone, Copy, Debug, Default)]
struct Piece {
    mean: [f64; 6],
    scatter: [f64; 6],
}

/// Gathers pieces.
#[derive(Clone, Debug)]
pub struct Stillness {
    start_s: f64,
    interval_s: f64,
    per_piece: u32,
    count: u32,
    first: [f64; 6],
    sum: [f64; 6],
    squares: [f64; 6],
    pieces: Vec<Piece>,
}

impl Stillness {
    /// Of samples from a time on, s.
    pub fn new(start_s: f64, interval_s: f64) -> Self {
        let per_piece = ((PIECE_S / interval_s).round() as u32).max(FEWEST);
        let none = [0.0; 6];
        let (first, sum, squares) = (none, none, none);
        Self { start_s, interval_s, per_piece, count: 0, first, sum, squares, pieces: Vec::new() }
    }

    /// Takes a sample.
    pub fn add(&mut self, increment: &Increment<f64>) {
        let values = six(increment);
        if self.count == 0 {
            self.first = values;
        }
        let sums = self.sum.iter_mut().zip(&mut self.squares);
        for ((sum, squares), (value, first)) in sums.zip(values.iter().zip(&self.first)) {
            let off = value - first;
            *sum += off;
            *squares += off * off;
        }
        self.count += 1;
        if self.count == self.per_piece {
            let n = f64::from(self.count);
            let mean = std::array::from_fn(|i| self.first[i] + self.sum[i] / n);
            let scatter = std::array::from_fn(|i| {
                (self.squares[i] - self.sum[i].powi(2) / n).max(0.0).sqrt()
            });
            self.pieces.push(Piece { mean, scatter });
            (self.count, self.sum, self.squares) = (0, [0.0; 6], [0.0; 6]);
        }
    }

    /// When it moved, from and to in s, with the axis that shows it first.
    pub fn motion(&self) -> Vec<([f64; 2], &'static str)> {
        let mut moved: Vec<Option<usize>> = vec![None; self.pieces.len()];
        for axis in 0..6 {
            let steps: Vec<f64> = self
                .pieces
                .windows(2)
                .map(|pair| (pair[1].mean[axis] - pair[0].mean[axis]).abs())
                .collect();
            // The median of |x| is 0.6745 σ of normal deviates.
            let usual = quartile(&steps, 2) / 0.6745;
            let scatter: Vec<f64> = self.pieces.iter().map(|piece| piece.scatter[axis]).collect();
            let usual_scatter = quartile(&scatter, 2);
            for (i, step) in steps.iter().enumerate() {
                if usual > 0.0 && *step > STEP * usual {
                    moved[i].get_or_insert(axis);
                    moved[i + 1].get_or_insert(axis);
                }
            }
            for (i, scatter) in scatter.iter().enumerate() {
                if usual_scatter > 0.0 && *scatter > SCATTER * usual_scatter {
                    moved[i].get_or_insert(axis);
                }
            }
        }
        let piece_s = f64::from(self.per_piece) * self.interval_s;
        let mut found: Vec<([f64; 2], &'static str)> = Vec::new();
        for (i, axis) in moved.iter().enumerate().filter_map(|(i, axis)| Some((i, (*axis)?))) {
            let from_s = self.start_s + i as f64 * piece_s;
            match found.last_mut() {
                // Shorter rests than this are none.
                Some(([_, to_s], _)) if from_s - *to_s < 10.0 * piece_s => *to_s = from_s + piece_s,
                _ => found.push(([from_s, from_s + piece_s], AXES[axis])),
            }
        }
        found
    }

    /// The longest stretch between motions, s.
    pub fn longest_rest(&self, end_s: f64) -> [f64; 2] {
        let motion = self.motion();
        let begins = std::iter::once(self.start_s).chain(motion.iter().map(|([_, to_s], _)| *to_s));
        let ends = motion.iter().map(|([from_s, _], _)| *from_s).chain(std::iter::once(end_s));
        let rests = begins.zip(ends).map(|(from_s, to_s)| [from_s, to_s]);
        rests
            .max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))
            .unwrap_or([self.start_s, end_s])
    }
}

/// The axes in the order of [`six`].
pub const AXES: [&str; 6] =
    ["gyro x", "gyro y", "gyro z", "accelerometer x", "accelerometer y", "accelerometer z"];

/// The numbers of a sample: gyros, then accelerometers.
pub fn six(increment: &Increment<f64>) -> [f64; 6] {
    let [a, b, c] = increment.angle_b.into_array();
    let [x, y, z] = increment.velocity_b.into_array();
    [a, b, c, x, y, z]
}
