//! Curves with no more points than their pixels can show.

use crate::canvas::Point;

/// Keeps of every run of points in one pixel column the first, lowest, highest and last: the
/// drawn line covers the same pixels. Points that are not finite are left out.
pub fn by_column(points: impl IntoIterator<Item = Point>) -> Vec<Point> {
    let mut kept = Vec::new();
    let mut run: Vec<Point> = Vec::new();
    for point in points.into_iter().filter(|point| point.iter().all(|value| value.is_finite())) {
        if run.first().is_some_and(|first| first[0].floor() != point[0].floor()) {
            keep(&run, &mut kept);
            run.clear();
        }
        run.push(point);
    }
    keep(&run, &mut kept);
    kept
}

fn keep(run: &[Point], kept: &mut Vec<Point>) {
    let extreme = |sign: f32| {
        (0..run.len()).max_by(|&a, &b| (sign * run[a][1]).total_cmp(&(sign * run[b][1])))
    };
    let (Some(high), Some(low)) = (extreme(1.0), extreme(-1.0)) else { return };
    let mut indices = [0, high.min(low), high.max(low), run.len() - 1].to_vec();
    indices.dedup();
    kept.extend(indices.into_iter().map(|index| run[index]));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_the_extremes_of_every_column() {
        let points: Vec<Point> = (0..10_000)
            .map(|i| {
                [i as f32 * 0.01, ((i * 7919) % 1000) as f32 * if i == 5_050 { 9.0 } else { 1.0 }]
            })
            .collect();
        let kept = by_column(points.iter().copied());
        assert!(kept.len() <= 400, "{}", kept.len());
        for column in 0..100 {
            let extremes = |points: &[Point]| {
                let inside = points.iter().filter(|p| p[0].floor() == column as f32);
                inside.fold((f32::MAX, f32::MIN), |(low, high), p| (low.min(p[1]), high.max(p[1])))
            };
            assert_eq!(extremes(&kept), extremes(&points), "column {column}");
        }
        assert_eq!((kept.first(), kept.last()), (points.first(), points.last()));
        assert!(kept.is_sorted_by(|a, b| a[0] <= b[0]));
    }

    #[test]
    fn few_points_stay_as_they_are() {
        let points: Vec<Point> = (0..50).map(|i| [i as f32 * 2.0, (i % 3) as f32]).collect();
        assert_eq!(by_column(points.iter().copied()), points);
        assert_eq!(by_column([[0.0, f32::NAN], [1.0, 2.0]]), [[1.0, 2.0]]);
        assert!(by_column([]).is_empty());
    }
}
