//! The straight lines that pass all stamps within their rounding.
//!
//! Stamps tₙ of a constant rate, rounded by a quantum q, lie within a strip of height q along the line
//! a + h n. Only the corners of their convex hull matter for that, and these are few as long
//! as there is such a line. So a recording of any length is examined exactly, in one pass and in little memory.
//! There is also a straight line by least squares.

/// Corners of a hull beyond which no line of a constant rate can be meant.
const MOST_CORNERS: usize = 4096;

/// One side of the convex hull of points with a growing abscissa.
#[derive(Clone, Debug, Default)]
struct Side {
    corners: Vec<[f64; 2]>,
    given_up: bool,
}

impl Side {
    /// Takes a point; `turn` is 1 for the lower side, −1 for the upper one.
    fn add(&mut self, n: f64, t: f64, turn: f64) {
        if self.given_up {
            return;
        }
        while let [.., a, b] = self.corners[..] {
            // (b − a) × (p − b)
            let cross = (b[0] - a[0]) * (t - b[1]) - (b[1] - a[1]) * (n - b[0]);
            if turn * cross > 0.0 {
                break;
            }
            self.corners.pop();
        }
        self.corners.push([n, t]);
        if self.corners.len() > MOST_CORNERS {
            self.given_up = true;
            self.corners = Vec::new();
        }
    }

    /// t − h n of every corner.
    fn offsets(&self, slope: f64) -> impl Iterator<Item = f64> {
        self.corners.iter().map(move |[n, t]| t - slope * n)
    }
}

/// What all stamps so far allow.
#[derive(Clone, Debug, Default)]
pub struct Strip {
    upper: Side,
    lower: Side,
}

impl Strip {
    /// Takes a stamp: the line may pass `half` above and below it.
    pub fn add(&mut self, n: f64, t: f64, half: f64) {
        self.upper.add(n, t - half, -1.0);
        self.lower.add(n, t + half, 1.0);
    }

    /// How much higher a strip of a slope must be than the halves allow; negative where there is room.
    pub fn excess(&self, slope: f64) -> f64 {
        if self.upper.given_up || self.lower.given_up {
            return f64::INFINITY;
        }
        let most = self.upper.offsets(slope).fold(f64::NEG_INFINITY, f64::max);
        let least = self.lower.offsets(slope).fold(f64::INFINITY, f64::min);
        most - least
    }

    /// Where a line of a slope runs in the middle of its strip, at n = 0.
    pub fn offset(&self, slope: f64) -> f64 {
        let most = self.upper.offsets(slope).fold(f64::NEG_INFINITY, f64::max);
        let least = self.lower.offsets(slope).fold(f64::INFINITY, f64::min);
        0.5 * (most + least)
    }

    /// The least and the greatest slope of a line that passes within half of `quantum` beyond the halves.
    pub fn slopes(&self, quantum: f64) -> Option<(f64, f64)> {
        let fits = |slope: f64| self.excess(slope) <= quantum;
        let best = self.narrowest()?;
        if !fits(best) {
            return None;
        }
        // The excess is a convex function of the slope: its level is met once on either side.
        let edge = |sign: f64| {
            let mut step = (1e-15 * best.abs()).max(f64::MIN_POSITIVE);
            while fits(best + sign * step) && step < 1e9 {
                step *= 2.0;
            }
            let (mut inside, mut outside) = (0.0, step);
            for _ in 0..60 {
                let middle = 0.5 * (inside + outside);
                if fits(best + sign * middle) { inside = middle } else { outside = middle }
            }
            best + sign * inside
        };
        Some((edge(-1.0), edge(1.0)))
    }

    /// The slope of the narrowest strip: that of a side of the hull.
    fn narrowest(&self) -> Option<f64> {
        let sides = [&self.upper, &self.lower];
        let slopes = || {
            sides.into_iter().flat_map(|side| {
                side.corners.windows(2).map(|pair| {
                    let ([n, t], [m, u]) = (pair[0], pair[1]);
                    (u - t) / (m - n)
                })
            })
        };
        // By halves: left of the best slope the excess falls.
        let mut slopes: Vec<f64> = slopes().collect();
        slopes.sort_unstable_by(f64::total_cmp);
        let (mut low, mut high) = (0, slopes.len().checked_sub(1)?);
        while low < high {
            let middle = (low + high) / 2;
            if self.excess(slopes[middle]) <= self.excess(slopes[middle + 1]) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        slopes.get(low).copied()
    }
}

/// A straight line by least squares, of any number of points.
#[derive(Clone, Copy, Debug, Default)]
pub struct LeastSquares {
    count: f64,
    mean: [f64; 2],
    /// Σ(n − n̄)², Σ(n − n̄)(t − t̄)
    squares: f64,
    products: f64,
}

impl LeastSquares {
    /// Takes a point.
    pub fn add(&mut self, n: f64, t: f64) {
        self.count += 1.0;
        let (dn, dt) = (n - self.mean[0], t - self.mean[1]);
        self.mean[0] += dn / self.count;
        self.mean[1] += dt / self.count;
        self.squares += dn * (n - self.mean[0]);
        self.products += dn * (t - self.mean[1]);
    }

    /// The line's slope.
    pub fn slope(&self) -> f64 {
        self.products / self.squares
    }

    /// Where it passes n = 0 with a given slope.
    pub fn offset(&self, slope: f64) -> f64 {
        self.mean[1] - slope * self.mean[0]
    }
}
