//! Fixes that are hidden from the navigator, and how far off it is at the last of them.

use schuler::aiding::surroundings::Pose;
use schuler::drift::compare::drift;
use schuler::math::vector::Vector;
use schuler::solution::Solution;
use schuler_simulator::aided::told::Told;
use schuler_simulator::number::rounded;
use schuler_simulator::output::NumberRows;
use schuler_simulator::quadratic::quadratic;
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// One span without fixes.
#[derive(Clone, Copy, Debug)]
pub struct Withheld {
    /// From and to, s.
    pub span_s: [f64; 2],
    /// The last position in it, if there is any.
    last: Option<Told>,
    hidden: usize,
    found: Option<Off>,
}

/// Columns of their table.
const COLUMNS: [&str; 10] = [
    "from_s",
    "to_s",
    "measurements",
    "north_m",
    "east_m",
    "down_m",
    "north_m_sigma",
    "east_m_sigma",
    "down_m_sigma",
    "nees",
];

/// How far off a navigator is from a fix: north, east, down, m.
#[derive(Clone, Copy, Debug)]
struct Off {
    error: [f64; 3],
    /// Standard deviations that the filter and the fix say together.
    sigma: [f64; 3],
    /// eᵀP⁻¹e.
    nees: f64,
}

/// Takes the fixes of spans out of a list.
pub fn hide(rows: &mut Vec<Told>, spans: &[[f64; 2]]) -> Vec<Withheld> {
    let within = |[from_s, to_s]: [f64; 2], row: &Told| {
        let is_fix = row.has_position() || row.north_east().is_some();
        is_fix && (from_s..to_s).contains(&row.time_s)
    };
    let withheld = spans.iter().map(|&span_s| {
        let hidden = rows.iter().filter(|row| within(span_s, row));
        let positions = hidden.clone().filter(|row| row.has_position());
        let last = positions.max_by(|a, b| a.time_s.total_cmp(&b.time_s)).copied();
        Withheld { span_s, last, hidden: hidden.count(), found: None }
    });
    let withheld = withheld.collect();
    rows.retain(|row| !spans.iter().any(|&span_s| within(span_s, row)));
    withheld
}

impl Withheld {
    /// A block of navigation ended; before it the velocity was another, so long ago.
    pub fn look(
        &mut self,
        time_s: f64,
        state: &Solution<f64>,
        (before, block_s): (Vector<f64>, f64),
        covariance: &dyn Fn() -> [[f64; 9]; 9],
        lever_b: Vector<f64>,
    ) {
        let Some(told) = self.last.filter(|told| self.found.is_none() && told.time_s <= time_s)
        else {
            return;
        };
        let since_s = time_s - told.time_s;
        if since_s > 2.0 * block_s {
            return;
        }
        let measured = &told.measured;
        let pose = Pose::of(state);
        let lever_ned = pose.body_to_ned * lever_b;
        let velocity = state.velocity_ned.map(|v| v.hi);
        let acceleration = (velocity - before) * (1.0 / block_s);
        let then = velocity * -since_s + acceleration * (0.5 * since_s * since_s);
        let mut truth = *state;
        truth.position = measured.position;
        let error = drift(state, &truth).position_ned + then + lever_ned;
        let p = covariance();
        // D_antenna = D_r + D_ψ × l
        let [x, y, z] = lever_ned.into_array();
        let across = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]];
        let row = |i: usize| -> [f64; 9] {
            std::array::from_fn(|j| match j {
                0..3 => f64::from(u8::from(i == j)),
                6..9 => across[i][j - 6],
                _ => 0.0,
            })
        };
        let sigma = measured.position_sigma.into_array();
        let whole: [[f64; 3]; 3] = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let (a, b) = (row(i), row(j));
                let sum: f64 =
                    (0..9).map(|m| (0..9).map(|n| a[m] * p[m][n] * b[n]).sum::<f64>()).sum();
                sum + if i == j { sigma[i] * sigma[i] } else { 0.0 }
            })
        });
        let error = error.into_array();
        let nees = quadratic(&whole, &error);
        self.found = Some(Off { error, sigma: std::array::from_fn(|i| whole[i][i].sqrt()), nees });
    }

    fn line(&self) -> String {
        let [from_s, to_s] = self.span_s;
        let span = format!("withheld {from_s} to {to_s} s, {} measurements", self.hidden);
        match &self.found {
            None => format!("{span}: no position there to compare with\n"),
            Some(Off { error, sigma, nees }) => {
                let three = |v: &[f64; 3]| v.map(|x| rounded(x, 3)).join(", ");
                format!(
                    "{span}: at the last {} m off ({} north, east, down; 1σ {}), NEES {} of 1\n",
                    rounded(norm(error), 3),
                    three(error),
                    three(sigma),
                    rounded(nees / 3.0, 3)
                )
            }
        }
    }
}

fn norm(v: &[f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// What came of each, a row of numbers; there are none of a span without a position.
pub fn table(all: &[Withheld]) -> NumberRows {
    let mut rows = NumberRows::new(&COLUMNS);
    for Withheld { span_s, hidden, found, .. } in all {
        let none = Off { error: [f64::NAN; 3], sigma: [f64::NAN; 3], nees: f64::NAN };
        let Off { error, sigma, nees } = found.unwrap_or(none);
        rows.add(span_s);
        rows.add(&[*hidden as f64]);
        rows.add(&error);
        rows.add(&sigma);
        rows.add(&[nees]);
    }
    rows
}

/// What came of all, a line each, and together.
pub fn lines(all: &[Withheld]) -> String {
    let mut text: String = all.iter().map(Withheld::line).collect();
    let found: Vec<_> = all.iter().filter_map(|one| one.found).collect();
    if found.len() < 2 {
        return text;
    }
    let rms = |of: &dyn Fn(&Off) -> f64| {
        (found.iter().map(|one| of(one).powi(2)).sum::<f64>() / found.len() as f64).sqrt()
    };
    let freedom = 3.0 * found.len() as f64;
    let nees = found.iter().map(|one| one.nees).sum::<f64>() / freedom;
    let expected = ChiSquared::new(freedom)
        .map_or([f64::NAN; 2], |law| [0.025, 0.975].map(|part| law.inverse_cdf(part) / freedom));
    let [least, most] = expected;
    let verdict = if nees < least {
        ": the filter doubts itself too much"
    } else if nees > most {
        ": the filter trusts itself too much"
    } else {
        ": error and claim agree"
    };
    text += &format!(
        "{} spans together: {} m off (rms), where {} m is claimed; NEES {} of 1 ({} to {} in 95 %){verdict}\n",
        found.len(),
        rounded(rms(&|one| norm(&one.error)), 3),
        rounded(rms(&|one| norm(&one.sigma)), 3),
        rounded(nees, 3),
        rounded(least, 3),
        rounded(most, 3)
    );
    text
}
