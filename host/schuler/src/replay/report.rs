//! The text after a flight.

use super::fly::Flight;
use super::spans::Spans;
use schuler::drift::compare::drift;
use schuler_simulator::number::counted;
use schuler_simulator::units::ARCSECOND;

/// Where it ends, and what was made up for; for a vehicle that was at rest, how far it seems to have moved.
pub fn text(flight: &Flight, spans: &Spans, at_rest: bool) -> String {
    let (time_s, solution) = &flight.last;
    let mut text = String::new();
    if let (count, Some(first)) = &flight.outside {
        let more =
            if *count > 1 { format!(", and {} more like it", count - 1) } else { String::new() };
        text += &format!("{first}: outside what was flown, passed over{more}\n");
    }
    let bridged = &flight.bridged;
    if bridged.samples > 0 {
        text += &format!(
            "bridged {} of {} s: {} missing, {:.6} s in all, filled along straight lines\n",
            if bridged.gaps == 1 {
                "a gap".to_owned()
            } else {
                format!("{} gaps, the longest", bridged.gaps)
            },
            (bridged.longest_s * 1e6).round() / 1e6,
            counted(bridged.samples, "sample that is", "samples that are"),
            bridged.time_s
        );
    }
    text += &format!("navigated from {} s to {time_s} s\n", spans.navigate_s);
    if let Some(neglected) = &flight.neglected {
        text += &neglected.line();
    }
    if at_rest {
        let moved = drift(solution, &flight.start);
        let [north, east, down] = moved.position_ned.into_array();
        text += &format!(
            "had it stood still: drifted {north:.1} m north, {east:.1} m east, {down:.1} m down,\n"
        );
        let [north, east, down] = moved.velocity_ned.into_array();
        text += &format!("  at {north:.3} m/s north, {east:.3} m/s east, {down:.3} m/s down,\n");
        let [x, y, z] = moved.attitude_ned.map(|a| a / ARCSECOND).into_array();
        text += &format!("  turned {x:.1}″ about north, {y:.1}″ about east, {z:.1}″ about down\n");
    }
    text
}
