//! The Pareto front: the points that no other point dominates.

use super::Point;

/// Marks the points of one scene that are on its front: time per second of flight against the largest
/// position error. Micromath's tier is there to be compared with, and never on it: its attitude is wrong by
/// tenths of a degree where its position may pass.
pub fn mark(points: &mut [Point]) {
    let cost = |p: &Point| if p.case.is_coarse() { f64::INFINITY } else { p.cost_us_per_s() };
    let measured: Vec<_> = points.iter().map(|p| (cost(p), p.max_position_m)).collect();
    for (point, on_front) in points.iter_mut().zip(front(&measured)) {
        point.on_front = on_front;
    }
}

/// Which of some (cost, error) are on the front: anything cheaper has a larger error. Of equals the
/// first is taken; what is not finite never is.
pub fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let mut order: Vec<usize> =
        (0..points.len()).filter(|&i| points[i].0.is_finite() && points[i].1.is_finite()).collect();
    order.sort_by(|&a, &b| {
        let ((cost_a, error_a), (cost_b, error_b)) = (points[a], points[b]);
        cost_a.total_cmp(&cost_b).then(error_a.total_cmp(&error_b))
    });
    let mut on_front = vec![false; points.len()];
    let mut least = f64::INFINITY;
    for i in order {
        if points[i].1 < least {
            least = points[i].1;
            on_front[i] = true;
        }
    }
    on_front
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_unbeaten_are_on_the_front() {
        let points = [
            (1.0, 9.0),
            (2.0, 9.0), // as wrong as the first, and dearer
            (2.0, 3.0),
            (2.0, 3.0), // equal to the one before
            (2.0, 4.0), // as dear, and more wrong
            (5.0, 3.5), // beaten on both counts
            (8.0, 1.0),
            (0.5, f64::NAN), // cheapest, but flew into nowhere
            (f64::INFINITY, 0.0),
            (9.0, 0.0),
        ];
        let names: Vec<usize> =
            front(&points).iter().enumerate().filter(|(_, on)| **on).map(|(i, _)| i).collect();
        assert_eq!(names, [0, 2, 6, 9]);
    }

    #[test]
    fn the_front_is_what_comparing_all_pairs_finds() {
        // A linear congruential sequence on a coarse grid, so that ties occur.
        let mut word = 1u32;
        let mut next = || {
            word = word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(word >> 27)
        };
        let points: Vec<(f64, f64)> = (0..200).map(|_| (next(), next())).collect();
        let beats = |a: (f64, f64), b: (f64, f64)| a.0 <= b.0 && a.1 <= b.1;
        for (i, &on_front) in front(&points).iter().enumerate() {
            let unbeaten = points.iter().enumerate().all(|(j, &other)| {
                let equal = other == points[i];
                !beats(other, points[i]) || (equal && j >= i)
            });
            assert_eq!(on_front, unbeaten, "{i}: {:?}", points[i]);
        }
        assert_eq!(front(&[]), Vec::<bool>::new());
    }
}
