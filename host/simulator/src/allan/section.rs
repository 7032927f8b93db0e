//! What was found, as a section of a scene.

use super::TRIADS;
use super::fit::Found;
use super::shape::Shape;
use crate::number::parameter;
use crate::scene::terms::{Key, TERMS};
use crate::units::{DEGREE_PER_HOUR, MICRO_G};

/// A key of a term with the unit of a magnitude of 1.
pub struct Name {
    /// The key; none of a ramp, which a scene has no term for.
    pub key: Option<&'static str>,
    /// What people call it.
    pub name: &'static str,
    /// The unit, in SI, and for people.
    pub unit: f64,
    /// The unit's symbol.
    pub symbol: &'static str,
    /// The factor from the magnitude to what the key takes.
    pub factor: f64,
}

/// How a scene calls a term of gyros (0) or accelerometers (1).
pub fn name(shape: Shape, triad: usize) -> Name {
    let of = |key: &'static str, factor: f64| -> Name {
        let keys =
            TERMS.iter().filter_map(|term| Some((term, [term.gyro, term.accelerometer][triad]?)));
        let found = keys.into_iter().find(|(_, known)| known.key == key);
        let (name, Key { unit, symbol, .. }) =
            found.map_or(("", Key { key, unit: 1.0, symbol: "" }), |(term, key)| (term.name, key));
        Name { key: Some(key), name, unit, symbol, factor }
    };
    let gyro = triad == 0;
    let rate = if gyro { (DEGREE_PER_HOUR, "°/h") } else { (MICRO_G, "µg") };
    match shape {
        // The key takes the step, √12 Q.
        Shape::Quantization => {
            of(if gyro { "quantization_arcsec" } else { "quantization_m_s" }, 12f64.sqrt())
        }
        Shape::White if gyro => of("angle_random_walk_deg_sqrt_h", 1.0),
        Shape::White => of("velocity_random_walk_m_s_sqrt_h", 1.0),
        Shape::Flicker(_) => {
            of(if gyro { "bias_instability_deg_h" } else { "bias_instability_ug" }, 1.0)
        }
        Shape::RandomWalk if gyro => of("rate_random_walk_deg_h_sqrt_h", 1.0),
        Shape::RandomWalk => of("acceleration_random_walk_ug_sqrt_h", 1.0),
        Shape::Ramp => {
            let symbol = if gyro { "°/h/h" } else { "µg/h" };
            Name { key: None, name: "ramp", unit: rate.0 / 3600.0, symbol, factor: 1.0 }
        }
        Shape::GaussMarkov(_) => {
            let key = Some(if gyro { "rms_deg_h" } else { "rms_ug" });
            Name { key, name: "Gauss-Markov, rms", unit: rate.0, symbol: rate.1, factor: 1.0 }
        }
    }
}

/// The section of a triad, from what each of its axes shows. A term that an axis does not show is 0 there.
pub fn section(triad: usize, axes: [&[Found]; 3]) -> String {
    let mut text = format!("[{}]\n", TRIADS[triad]);
    // A term is a line, whichever axes have it.
    let same = |a: Shape, b: Shape| std::mem::discriminant(&a) == std::mem::discriminant(&b);
    let mut shapes: Vec<Shape> = Vec::new();
    for found in axes.iter().flat_map(|axis| axis.iter()) {
        if !shapes.iter().any(|shape| same(*shape, found.shape)) {
            shapes.push(found.shape);
        }
    }
    for shape in shapes {
        let Name { key, unit, symbol, factor, .. } = name(shape, triad);
        let on = |axis: &[Found]| axis.iter().find(|found| same(found.shape, shape)).copied();
        let found = axes.map(on);
        let value = |found: Option<Found>| found.map_or(0.0, |f| f.magnitude() * factor / unit);
        let values = list(found.map(value));
        match (shape, key) {
            (Shape::GaussMarkov(shared_s), Some(key)) => {
                let time = |found: Option<Found>| match found.map(|f| f.shape) {
                    Some(Shape::GaussMarkov(correlation_s)) => correlation_s,
                    _ => shared_s,
                };
                let times = list(found.map(time));
                text +=
                    &format!("gauss_markov = {{ {key} = {values}, correlation_s = {times} }}\n");
            }
            // A step of 0 is none, and no key takes it.
            (Shape::Quantization, Some(key)) if found.iter().any(Option::is_none) => {
                text += &format!("# {key} = {values}, but a step is above 0 on every axis\n");
            }
            (_, Some(key)) => text += &format!("{key} = {values}\n"),
            (_, None) => {
                text += &format!("# a ramp of {values} {symbol}, which a scene has no term for\n")
            }
        }
    }
    text
}

/// One number where all are the same, else a list.
fn list(values: [f64; 3]) -> String {
    let [x, y, z] = values.map(parameter);
    if x == y && y == z { x } else { format!("[{x}, {y}, {z}]") }
}
