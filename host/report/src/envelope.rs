//! The extremes of long series in few spans: what is dense is drawn as the area that it fills.

/// Spans at most.
const MOST: usize = 1000;

/// One span.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Span<const N: usize> {
    from: f64,
    to: f64,
    low: [f64; N],
    high: [f64; N],
}

impl<const N: usize> Span<N> {
    fn join(self, next: Self) -> Self {
        let each = |f: fn(f64, f64) -> f64, a: [f64; N], b: [f64; N]| {
            std::array::from_fn(|i| f(a[i], b[i]))
        };
        Self {
            from: self.from,
            to: next.to,
            // Of a number and what is none, `min` and `max` take the number.
            low: each(f64::min, self.low, next.low),
            high: each(f64::max, self.high, next.high),
        }
    }
}

/// The least and the greatest of N series in spans of equally many points, of which there are from 500 to 1000 once the
/// series are that long. However long they get, what is kept is bounded.
#[derive(Clone, Debug)]
pub struct Envelope<const N: usize> {
    spans: Vec<Span<N>>,
    /// Points of a span.
    each: u64,
    /// Points of the last one.
    filled: u64,
}

impl<const N: usize> Default for Envelope<N> {
    fn default() -> Self {
        Self { spans: Vec::new(), each: 1, filled: 1 }
    }
}

impl<const N: usize> Envelope<N> {
    /// Takes the values of the next x.
    pub fn push(&mut self, x: f64, values: [f64; N]) {
        let point = Span { from: x, to: x, low: values, high: values };
        if self.filled < self.each
            && let Some(last) = self.spans.last_mut()
        {
            *last = last.join(point);
            self.filled += 1;
            return;
        }
        if self.spans.len() == MOST {
            let pairs = self.spans.chunks(2).map(|pair| pair[0].join(pair[pair.len() - 1]));
            self.spans = pairs.collect();
            self.each *= 2;
        }
        self.spans.push(point);
        self.filled = 1;
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.spans.is_empty()
    }

    /// Whether a series has a number anywhere.
    pub fn is_known(&self, series: usize) -> bool {
        self.spans.iter().any(|span| span.low[series].is_finite())
    }

    /// The extremes of a series over the whole; not finite where it has no number.
    pub fn extremes(&self, series: usize) -> [f64; 2] {
        let spans = || self.spans.iter();
        [
            spans().map(|span| span.low[series]).fold(f64::INFINITY, f64::min),
            spans().map(|span| span.high[series]).fold(f64::NEG_INFINITY, f64::max),
        ]
    }

    /// x, the greatest and the least of a series; x is the middle of a span, at the ends the end.
    pub fn edges(&self, series: usize) -> impl Iterator<Item = [f64; 3]> {
        let last = self.spans.len().saturating_sub(1);
        self.spans.iter().enumerate().map(move |(i, span)| {
            let x = match i {
                0 => span.from,
                i if i == last => span.to,
                _ => 0.5 * (span.from + span.to),
            };
            [x, span.high[series], span.low[series]]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wave far faster than the spans, and one spike.
    fn wave(k: u64) -> f64 {
        if k == 77_777 { 9.0 } else { (0.9 * k as f64).sin() }
    }

    #[test]
    fn keeps_the_extremes_of_every_span() {
        for points in [1, 5, 1000, 1001, 2000, 2001, 100_001] {
            let mut envelope = Envelope::default();
            (0..points).for_each(|k| envelope.push(k as f64, [wave(k), -wave(k)]));
            let edges: Vec<[f64; 3]> = envelope.edges(0).collect();
            assert!(edges.len() <= MOST && edges.len() >= (points as usize).min(MOST / 2));
            assert_eq!((edges[0][0], edges[edges.len() - 1][0]), (0.0, (points - 1) as f64));
            assert!(edges.is_sorted_by(|a, b| a[0] < b[0]));
            let each = (points as usize).div_ceil(edges.len()).next_power_of_two() as u64;
            for (span, edge) in edges.iter().enumerate() {
                let of_span = (span as u64 * each..points.min((span as u64 + 1) * each)).map(wave);
                let [high, low] =
                    [of_span.clone().fold(f64::MIN, f64::max), of_span.fold(f64::MAX, f64::min)];
                assert_eq!(edge[1..], [high, low], "span {span} of {points} points");
            }
            let [low, high] = envelope.extremes(0);
            assert_eq!(envelope.extremes(1), [-high, -low]);
        }
    }

    #[test]
    fn what_is_no_number_is_passed_over() {
        let mut envelope = Envelope::default();
        for k in 0..5000 {
            let x = f64::from(k);
            envelope.push(x, [f64::NAN, if k % 2 == 0 { f64::NAN } else { x }]);
        }
        assert!(!envelope.is_known(0) && envelope.is_known(1));
        assert_eq!(envelope.extremes(1), [1.0, 4999.0]);
        assert!(envelope.edges(0).all(|edge| edge[1].is_nan()));
        assert!(Envelope::<1>::default().is_empty());
    }
}
