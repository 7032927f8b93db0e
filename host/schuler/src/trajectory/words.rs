//! A flight in words.

use schuler_simulator::number;
use schuler_simulator::portrait::{Extremes, Portrait};
use schuler_simulator::scene::Scene;
use schuler_simulator::units::DEGREE;
use std::fmt::Write as _;

/// Everything about it, a line each.
pub fn describe(scene: &Scene, portrait: &Portrait) -> String {
    let mut text = format!("{}: {}, {} s\n", scene.name, scene.title, scene.duration_s);
    let mut line = |name: &str, value: String| {
        // A String takes all that is written.
        let _ = writeln!(text, "{name:22} {value}");
    };
    let range = |of: &Extremes, unit: f64, symbol: &str| {
        let [least, most] = [of.least, of.most].map(|x| number::short(x / unit));
        if least == most {
            format!("{least} {symbol}")
        } else {
            format!("{least} to {most} {symbol}")
        }
    };
    line("length", length(portrait.length_m));
    line("from", place(portrait.start));
    line("to", place(portrait.end));
    line("speed", range(&portrait.speed, 1.0, "m/s"));
    line("vertical speed", range(&portrait.climb, 1.0, "m/s"));
    line("height", range(&portrait.altitude, 1.0, "m"));
    line("acceleration", range(&portrait.acceleration, 1.0, "m/s²"));
    line("load factor", range(&portrait.load, 1.0, "g"));
    line("bank", range(&portrait.roll, DEGREE, "°"));
    line("pitch", range(&portrait.pitch, DEGREE, "°"));
    for (name, rate) in ["roll rate", "pitch rate", "yaw rate"].into_iter().zip(&portrait.rates) {
        line(name, range(rate, DEGREE, "°/s"));
    }
    text
}

fn length(metres: f64) -> String {
    if metres < 10_000.0 {
        format!("{} m", number::short(metres))
    } else {
        format!("{:.3} km", metres / 1000.0)
    }
}

fn place(at: schuler::earth::Geodetic<f64>) -> String {
    let [latitude, longitude] = [at.latitude, at.longitude].map(|angle| angle / DEGREE);
    format!("{latitude:.6}° {longitude:.6}° {:.2} m", at.altitude)
}
