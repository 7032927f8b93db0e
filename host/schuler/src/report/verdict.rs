//! What the error of a run came to, and what theory says of it.

use super::norm;
use schuler_simulator::flight::{Flight, Instant, Nine};
use schuler_simulator::number::{Quantity, counted};
use schuler_simulator::theory::Outside;

/// How far each component lies from theory's mean in its standard deviations; `None` where
/// theory expects no scatter.
pub fn z_scores(last: &Instant) -> [Option<f64>; 3] {
    std::array::from_fn(|axis| {
        let sigma = last.sigma.position_m[axis];
        let deviation = last.drift.position_m[axis] - last.mean.position_m[axis];
        (sigma > 0.0).then(|| deviation / sigma)
    })
}

/// The run in two lines: what the error came to, and what theory says of it.
pub fn verdict(flight: &Flight) -> [String; 2] {
    let last = &flight.last;
    let position = |nine: &Nine| Quantity::Position.show(norm(nine.position_m));
    let outcome = format!(
        "Position error {} at {} s, {} at its largest; velocity {}, attitude {} at the end.",
        position(&last.drift),
        schuler_simulator::number::parameter(last.time_s),
        Quantity::Position.show(flight.max.norms[0]),
        Quantity::Velocity.show(norm(last.drift.velocity_m_s)),
        Quantity::Attitude.show(norm(last.drift.attitude_arcsec)),
    );
    let scores = z_scores(last);
    let theory = if scores.iter().any(Option::is_some) {
        match flight.aided {
            Some(_) => claimed(last),
            None => {
                let [mean, sigma] = [&last.mean, &last.sigma].map(position);
                format!("Theory: mean {mean}, 1σ {sigma}; {} of the mean.", lies(last))
            }
        }
    } else if norm(last.mean.position_m) > 0.0 {
        let rest: [f64; 3] =
            std::array::from_fn(|axis| last.drift.position_m[axis] - last.mean.position_m[axis]);
        format!(
            "Theory: mean {}, nothing random; the error differs from it by {}.",
            position(&last.mean),
            Quantity::Position.show(norm(rest)),
        )
    } else {
        "Theory: no drift to expect; the error is the navigator's own.".to_owned()
    };
    [outcome, outside_theory(flight).unwrap_or(theory)]
}

/// What a filter says of the last error, in a line.
pub fn claimed(last: &Instant) -> String {
    let sigma = Quantity::Position.show(norm(last.sigma.position_m));
    format!("The filter says: 1σ {sigma}; {}.", lies(last))
}

/// Where the last error lies, in standard deviations.
fn lies(last: &Instant) -> String {
    let [north, east, down] = z_scores(last).map(|score| match score {
        Some(z) => format!("{z:+.2}σ"),
        None => "no scatter".to_owned(),
    });
    format!("the error lies {north} north, {east} east, {down} down")
}

/// What happened that the linear error model does not know, if anything.
fn outside_theory(flight: &Flight) -> Option<String> {
    let mut reasons = Vec::new();
    if flight.saturated > 0 {
        reasons.push(counted(flight.saturated, "sample was", "samples were") + " saturated");
    }
    if flight.lost > 0 {
        reasons.push(counted(flight.lost, "sample was", "samples were") + " lost");
    }
    match flight.outside {
        Some(Outside::Samples) | None => {}
        Some(outside) => reasons.push(outside.to_string()),
    }
    let what = reasons.join(", ");
    (!what.is_empty())
        .then(|| format!("Theory: not comparable, the linear model ends where {what}."))
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;

    #[test]
    fn verdict_counts_standard_deviations() {
        let mut flight = sample::flight();
        flight.last.drift.position_m = [5.0, -1.0, 2.0];
        flight.last.mean.position_m = [1.0, 1.0, 2.0];
        flight.last.sigma.position_m = [2.0, 4.0, 0.0];
        assert_eq!(z_scores(&flight.last), [Some(2.0), Some(-0.5), None]);
        let [_, theory] = verdict(&flight);
        assert!(theory.contains("+2.00σ north, -0.50σ east, no scatter down"), "{theory}");
        flight.last.sigma.position_m = [0.0; 3];
        assert!(verdict(&flight)[1].contains("differs from it by 4.472 m"));
        assert!(verdict(&sample::perfect())[1].contains("navigator's own"));
    }
}
