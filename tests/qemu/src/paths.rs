//! Paths that a target compiles while it flies them, and the same flights on this machine.

use super::image::Image;
use super::machine::Machine;
use super::qemu;
use schuler_scenes::stretch::{Flown, Refused};
use schuler_scenes::target::{POINTS, STEEP, WHOLE, points, segments};
use std::fmt::Debug;

/// How far from the truth a flight ends at most where every sample is followed, m.
const FLOOR_M: f64 = 1e-8;

/// Flies the image `circuit`: what does not agree with this machine.
pub fn fly(machine: &Machine, image: &Image) -> Result<Vec<String>, String> {
    let there = qemu::fly(machine, image, &mut |_| ())?;
    let mut faults = Vec::new();
    if !there.passed {
        faults.push(format!("the image `circuit` failed: {:?}", there.values));
    }
    let flights = [
        ("circuit", flown(segments(WHOLE))?, f64::INFINITY),
        ("steep turn", flown(segments(STEEP))?, FLOOR_M),
        ("waypoints", flown(points(POINTS))?, FLOOR_M),
    ];
    for (flight, here, most_m) in flights {
        let digest = |value: u64| format!("{value:016x}");
        let same = [
            ("pieces", here.pieces.to_string()),
            ("path", digest(here.path)),
            ("increments", digest(here.increments)),
            ("states", digest(here.states)),
        ];
        for (key, here) in same {
            let there = there.text(&format!("{flight}, {key}"))?;
            if there != here {
                faults.push(format!("{flight}: {key} {there}, but {here} on this machine"));
            }
        }
        let final_m = there.number(&format!("{flight}, final, m"))?;
        // Not a number is too far.
        if final_m.is_nan() || final_m > most_m {
            faults.push(format!("{flight} ends {final_m:e} m from the truth"));
        }
    }
    Ok(faults)
}

fn flown<E: Debug>(flight: Result<Flown, Refused<E>>) -> Result<Flown, String> {
    flight.map_err(|refused| format!("this machine does not fly: {refused:?}"))
}
