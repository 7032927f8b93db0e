//! All points as `frontier.csv`.

use super::Point;
use schuler_simulator::number::exact;
use schuler_simulator::output;

/// The columns of `frontier.csv`. `window` is history,block,look-ahead, empty without one; `on_front`
/// is per scene, by `ns_per_sample` × `rate_hz` and `max_position_m`.
pub const COLUMNS: [&str; 13] = [
    "scene",
    "rate_hz",
    "algorithm",
    "window",
    "frame",
    "precision",
    "math",
    "ns_per_sample",
    "ns_spread",
    "max_position_m",
    "max_velocity_m_s",
    "max_attitude_arcsec",
    "on_front",
];

/// All points, one a line; numbers round-trip.
pub fn bytes(points: &[Point]) -> Vec<u8> {
    let rows = points.iter().map(|p| {
        [
            p.scene.clone(),
            p.rate_hz.to_string(),
            p.case.algorithm().to_owned(),
            p.case.window(),
            p.case.frame.name().to_owned(),
            p.case.arithmetic.name().to_owned(),
            p.case.arithmetic.math().to_owned(),
            exact(p.ns_per_sample),
            exact(p.ns_spread),
            exact(p.max_position_m),
            exact(p.max_velocity_m_s),
            exact(p.max_attitude_arcsec),
            p.on_front.to_string(),
        ]
    });
    output::csv(COLUMNS, rows)
}

#[cfg(test)]
mod tests {
    use super::super::sample::points;
    use super::*;

    #[test]
    fn the_csv_is_as_promised() {
        let text = String::from_utf8(bytes(&points())).expect("text");
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(
            lines[0],
            "scene,rate_hz,algorithm,window,frame,precision,math,ns_per_sample,ns_spread,\
             max_position_m,max_velocity_m_s,max_attitude_arcsec,on_front"
        );
        assert_eq!(lines.len(), 6);
        assert!(lines[1].starts_with("slow,20,textbook,,local-level,f64,libm,"), "{}", lines[1]);
        assert!(lines[1].ends_with(",false"), "{}", lines[1]);
        assert!(lines[2].starts_with("slow,20,taylor,\"0,4,0\",earth-fixed,f64,libm,"));
        assert!(lines[4].starts_with("slow,20,rk4,,earth-fixed,f64,libm,"), "{}", lines[4]);
        assert!(lines[4].contains(",NaN,NaN,NaN,false"), "{}", lines[4]);
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        for (row, point) in reader.records().zip(points()) {
            let row = row.expect("a row of 13");
            for (column, value) in [
                (1, point.rate_hz),
                (7, point.ns_per_sample),
                (8, point.ns_spread),
                (9, point.max_position_m),
                (10, point.max_velocity_m_s),
                (11, point.max_attitude_arcsec),
            ] {
                let read: f64 = row[column].parse().expect(&row[column]);
                assert!(read == value || (read.is_nan() && value.is_nan()), "{}", &row[column]);
            }
        }
    }
}
