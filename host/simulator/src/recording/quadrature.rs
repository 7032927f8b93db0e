//! Increments from instantaneous rates at the samples' ends.
//!
//! A sample's increment is the integral of the cubic through the rates at four neighbouring instants: two
//! before and two after, or the nearest four at the end of a stretch. With even steps h that is
//! h/24·(−f₋₂ + 13f₋₁ + 13f₀ − f₁); its error is 11/720·h⁵f⁗ per sample (19/720 for the second and the last
//! sample). A stretch of fewer rates uses the polynomial through them.
//!
//! The first sample of a stretch starts where no rate is known. It is extrapolated from one to four
//! rates, as many as have the least estimated error by the measure of [`support`](schuler::strapdown::block::support), gain ·
//! rms(∇ᵏf)/√C(2k, k). Smooth rates get a cubic (251/720·h⁵f⁗), noise the first rate alone: a cubic would
//! amplify it six times.

use schuler::math::vector::Vector;
use schuler::sample::Increment;
use std::collections::VecDeque;

/// Instants that a polynomial goes through.
const POINTS: usize = 4;
/// Rates that the choice of the first sample's polynomial looks at.
const AHEAD: usize = 12;
/// √Σw² of the weights that integrate the sample before 1, 2, 3, 4 even rates.
const GAINS: [f64; POINTS] = [1.0, 1.581_138_830_1, 2.371_356_854_9, 3.719_823_024_7];

/// Rates at an instant.
#[derive(Clone, Copy, Debug)]
struct Node {
    time_s: f64,
    rates: Increment<f64>,
}

/// Rates of a stretch on their way to increments. Each carries something along.
#[derive(Debug)]
pub struct Quadrature<T> {
    nodes: VecDeque<Node>,
    /// What goes with the nodes that have no increment yet: those at the end.
    waiting: VecDeque<T>,
    first_interval_s: f64,
    begun: bool,
    ended: bool,
}

impl<T> Quadrature<T> {
    /// Of a stretch whose first sample has this length, s.
    pub fn new(first_interval_s: f64) -> Self {
        Self {
            nodes: VecDeque::new(),
            waiting: VecDeque::new(),
            first_interval_s,
            begun: false,
            ended: false,
        }
    }

    /// Takes the rates at an instant, s.
    pub fn push(&mut self, time_s: f64, rates: Increment<f64>, with: T) {
        self.nodes.push_back(Node { time_s, rates });
        self.waiting.push_back(with);
    }

    /// No more rates come.
    pub fn end(&mut self) {
        self.ended = true;
    }

    /// The next increment, as soon as the rates around it are there.
    pub fn pop(&mut self) -> Option<(Increment<f64>, T)> {
        let needed = if self.begun { 2 } else { AHEAD };
        if self.waiting.is_empty() || (!self.ended && self.waiting.len() < needed) {
            return None;
        }
        let nodes = self.nodes.make_contiguous();
        let at = nodes.len() - self.waiting.len();
        let increment = if self.begun {
            let points = POINTS.min(nodes.len());
            let first = at.saturating_sub(POINTS / 2).min(nodes.len() - points);
            integral(&nodes[first..first + points], nodes[at - 1].time_s, nodes[at].time_s)
        } else {
            let points = supported(nodes);
            let to_s = nodes[0].time_s;
            integral(&nodes[..points], to_s - self.first_interval_s, to_s)
        };
        self.begun = true;
        // The next one may need this and two before.
        while self.nodes.len() > self.waiting.len() + 2 {
            self.nodes.pop_front();
        }
        Some((increment, self.waiting.pop_front()?))
    }
}

/// How many of the first rates the sample before them is extrapolated from.
fn supported(nodes: &[Node]) -> usize {
    let nodes = &nodes[..AHEAD.min(nodes.len())];
    // Without a rate beyond them, points are all that is known.
    let most = POINTS.min(nodes.len());
    let (Some(first), Some(last)) = (nodes.first(), nodes.last()) else { return most };
    if nodes.len() <= POINTS {
        return most;
    }
    let step_s = (last.time_s - first.time_s) / (nodes.len() - 1) as f64;
    let powers = |values: &[Increment<f64>]| {
        let count = values.len() as f64;
        let sum = |part: fn(&Increment<f64>) -> Vector<f64>| {
            values.iter().map(|value| part(value).dot(part(value))).sum::<f64>() / count
        };
        [sum(|value| value.angle_b), sum(|value| value.velocity_b)]
    };
    // Divided differences, k! hᵏ f[t₀ … tₖ]: those of even steps are ∇ᵏf.
    let mut values: Vec<_> = nodes.iter().map(|node| node.rates).collect();
    let references = powers(&values);
    let (mut least, mut found, mut of_noise) = (f64::INFINITY, 1, 1.0);
    for points in 1..=most {
        for i in 0..values.len() - 1 {
            let span_s = nodes[i + points].time_s - nodes[i].time_s;
            let scale = points as f64 * step_s / span_s;
            let (a, b) = (values[i], values[i + 1]);
            values[i] = Increment {
                angle_b: (b.angle_b - a.angle_b) * scale,
                velocity_b: (b.velocity_b - a.velocity_b) * scale,
            };
        }
        values.pop();
        // C(2k, k)
        of_noise *= (4 * points - 2) as f64 / points as f64;
        let parts = powers(&values).into_iter().zip(references);
        let parts = parts.filter(|(_, reference)| *reference > 0.0);
        let power: f64 = parts.map(|(power, reference)| power / reference).sum();
        let error = GAINS[points - 1].powi(2) * power / of_noise;
        if error < least {
            (least, found) = (error, points);
        }
    }
    found
}

/// The integral of the polynomial through some rates.
fn integral(nodes: &[Node], from_s: f64, to_s: f64) -> Increment<f64> {
    // Gauss-Legendre with two nodes, ±1/√3, is exact for a cubic.
    let (centre, half) = (0.5 * (from_s + to_s), 0.5 * (to_s - from_s));
    let offset = half / 3f64.sqrt();
    let mut sum = Increment { angle_b: Vector::ZERO, velocity_b: Vector::ZERO };
    for (j, node) in nodes.iter().enumerate() {
        // Lagrange: ℓⱼ(t) = Π (t − tₖ)/(tⱼ − tₖ)
        let basis = |t: f64| -> f64 {
            let others = nodes.iter().enumerate().filter(|(k, _)| *k != j);
            others.map(|(_, other)| (t - other.time_s) / (node.time_s - other.time_s)).product()
        };
        let weight = half * (basis(centre - offset) + basis(centre + offset));
        sum.angle_b = sum.angle_b + node.rates.angle_b * weight;
        sum.velocity_b = sum.velocity_b + node.rates.velocity_b * weight;
    }
    sum
}
