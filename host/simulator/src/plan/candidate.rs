//! The windows that a plan chooses from, the cheapest first.

use crate::scene::WindowShape;
use schuler::sample::Increment;
use schuler::strapdown::block::body::BodyMotion;
use schuler::strapdown::block::window::*;

/// Integrates a block within its window's samples, given half its duration, s, and the order of its series.
pub type Integrate = fn(&[Increment<f64>], f64, usize) -> Option<BodyMotion<f64>>;

/// A named window.
#[derive(Clone, Copy)]
pub struct Candidate {
    /// History, block, look-ahead.
    pub shape: WindowShape,
    /// Coefficients of its fit.
    pub coefficients: usize,
    /// Order of its series at most.
    pub terms: usize,
    /// Integrates a block by a series of some order, with what rounding drops.
    pub integrate: Integrate,
}

fn integrate<W: Window>(
    samples: &[Increment<f64>],
    half_time_s: f64,
    order: usize,
) -> Option<BodyMotion<f64>> {
    W::integrate::<f64>(samples, half_time_s, order, true).map(|(body, _)| body)
}

const fn of<W: Window>() -> Candidate {
    Candidate {
        shape: W::SHAPE,
        coefficients: W::COEFFICIENTS,
        terms: W::TERMS,
        integrate: integrate::<W>,
    }
}

macro_rules! all {
    ($($window:ident),+) => {
        [$(of::<$window>()),+]
    };
}

/// Every named window.
const ALL: &[Candidate] = &schuler::strapdown::block::window::every_window! { all! };

/// Time per sample at block ends, the cheapest first, as `schuler frontier` measures it: long blocks of
/// slow motion, no neighbours, neighbours on both sides, and last those that look one way, which take the
/// sensors' noise along.
const CHEAPEST: &[WindowShape] = &[
    WindowShape::new(0, 40, 0),
    WindowShape::new(0, 20, 0),
    WindowShape::new(0, 12, 0),
    WindowShape::new(0, 8, 0),
    WindowShape::new(0, 6, 0),
    WindowShape::new(0, 4, 0),
    WindowShape::new(0, 3, 0),
    WindowShape::new(2, 4, 2),
    WindowShape::new(0, 2, 0),
    WindowShape::new(4, 4, 4),
    WindowShape::new(2, 2, 2),
    WindowShape::new(2, 4, 0),
    WindowShape::new(4, 4, 0),
    WindowShape::new(2, 2, 0),
];

impl Candidate {
    /// Of a shape.
    pub fn find(shape: WindowShape) -> Option<Self> {
        ALL.iter().copied().find(|candidate| candidate.shape == shape)
    }

    /// All, the cheapest first.
    pub fn all() -> impl Iterator<Item = Self> {
        let rank = |one: &Self| CHEAPEST.iter().position(|&shape| shape == one.shape);
        let mut all = ALL.to_vec();
        // Those without a rank are tried last.
        all.sort_by_key(|one| rank(one).unwrap_or(CHEAPEST.len()));
        all.into_iter()
    }

    /// Whether it weighs both sides of its block alike, or its block alone.
    pub fn is_symmetric(&self) -> bool {
        self.shape.history == self.shape.lookahead
    }

    /// Orders to try below the highest: the lowest there is, and that of its fit's last coefficient.
    pub fn orders(&self) -> [usize; 3] {
        let whole = (self.coefficients + 1).min(self.terms);
        [whole.min(3), whole, self.terms]
    }
}
