//! Every kernel against high precision: the worst error of a thousand tries or so, in ulps of its result.
//!
//! One table of bounds for all. A bound that is exceeded fails, and so does one that is more than four
//! times the worst there is: it would hide a loss of two bits.

mod big;
mod block;
mod day;
mod earth;
mod elementary;
mod rotation;

use std::collections::BTreeMap;

/// Kernel, and its worst error in ulps of the type it computes in; pairs in ulps of a pair, 2⁻⁵³ of a
/// double's or 2⁻²⁴ of a single's. 0 is exact.
const BOUNDS: &[(&str, f64)] = &[
    // Correctly rounded would be 0.5.
    ("atan2 f32", 1.5),
    ("atan2 f64", 1.5),
    ("cos f32", 0.65),
    ("cos f64", 0.85),
    ("expm1 f32", 1.0),
    ("expm1 f64", 0.95),
    ("ln f32", 0.85),
    ("ln f64", 0.95),
    ("sin f32", 0.65),
    ("sin f64", 0.9),
    ("sqrt f32", 0.5),
    ("sqrt f64", 0.5),
    // Exact, but for the product of the lower halves, which has 54 bits in double precision.
    ("Pair + f32", 1.5),
    ("Pair + f64", 1.5),
    ("Pair cos, of 1, f32", 5.0),
    ("Pair cos, of 1, f64", 7.5),
    ("Pair reciprocal f32", 3.5),
    ("Pair reciprocal f64", 3.0),
    ("Pair sin, of 1, f32", 6.5),
    ("Pair sin, of 1, f64", 8.5),
    ("Pair × f32", 2.5),
    ("Pair × f64", 4.0),
    ("Pair √ f32", 2.0),
    ("Pair √ f64", 2.0),
    ("two_product f32", 0.0),
    ("two_product f64", 3.0),
    ("two_sum f32", 0.0),
    ("two_sum f64", 0.0),
    // Of the length of the result.
    ("Euler to quaternion f32", 1.5),
    ("Euler to quaternion f64", 1.5),
    ("Euler to quaternion pair f32", 2.0),
    ("Euler to quaternion pair f64", 3.5),
    ("normalised less one f32", 0.2),
    ("normalised less one f64", 1.5),
    ("quaternion product f32", 1.5),
    ("quaternion product f64", 1.5),
    ("rotation by matrix f32", 3.0),
    ("rotation by matrix f64", 3.0),
    ("rotation vector f32", 2.0),
    ("rotation vector f64", 2.5),
    ("turn less one f32", 15.0),
    ("turn less one f64", 7.0),
    // Meridian steps are of up to 100 m.
    ("1/W − 1 f32", 3.0),
    ("1/W − 1 f64", 3.0),
    ("R_M f32", 2.5),
    ("R_M f64", 3.0),
    ("R_N f32", 1.5),
    ("R_N f64", 1.5),
    ("dR_M/dφ f32", 5.5),
    ("dR_M/dφ f64", 5.0),
    ("dR_N/dφ f32", 4.0),
    ("dR_N/dφ f64", 4.0),
    ("from Earth-fixed: h, of R", 3.0),
    ("from Earth-fixed: λ", 1.5),
    ("from Earth-fixed: φ, of 1", 0.85),
    ("gravitation cold, of g f32", 6.5),
    ("gravitation cold, of g f64", 6.0),
    ("gravitation predicted, of g f32", 6.5),
    ("gravitation predicted, of g f64", 6.5),
    ("gravity f32", 3.5),
    ("gravity f64", 3.0),
    ("meridian step: Δh f32", 1.5),
    ("meridian step: Δh f64", 3.5),
    ("meridian step: Δλ f32", 4.0),
    ("meridian step: Δλ f64", 3.5),
    ("meridian step: Δφ f32", 4.5),
    ("meridian step: Δφ f64", 7.0),
    ("to Earth-fixed, of R", 3.0),
    // 0.1 rad/s at 128 Hz.
    ("H0B4A0 position f32", 2.5),
    ("H0B4A0 position f64", 4.5),
    ("H0B4A0 rotation f32", 2.0),
    ("H0B4A0 rotation f64", 3.0),
    ("H0B4A0 rotation's scalar f32", 3.5),
    ("H0B4A0 rotation's scalar f64", 4.5),
    ("H0B4A0 velocity f32", 2.0),
    ("H0B4A0 velocity f64", 2.0),
    ("H2B4A2 position f32", 5.5),
    ("H2B4A2 position f64", 4.5),
    ("H2B4A2 rotation f32", 1.5),
    ("H2B4A2 rotation f64", 1.5),
    ("H2B4A2 rotation's scalar f32", 3.0),
    ("H2B4A2 rotation's scalar f64", 4.0),
    ("H2B4A2 velocity f32", 1.5),
    ("H2B4A2 velocity f64", 1.5),
    ("H4B4A4 position f64", 6.0),
    ("H4B4A4 rotation f64", 2.0),
    ("H4B4A4 rotation's scalar f64", 3.5),
    ("H4B4A4 velocity f64", 1.5),
];

/// How many times the worst a bound may be.
const SLACK: f64 = 4.0;

/// The worst errors, by kernel.
#[derive(Default)]
pub struct Worst(BTreeMap<String, f64>);

impl Worst {
    /// Takes in an error.
    pub fn add(&mut self, kernel: impl Into<String>, ulps: f64) {
        let worst = self.0.entry(kernel.into()).or_default();
        assert!(ulps.is_finite());
        *worst = worst.max(ulps);
    }
}

/// The unit in the last place of a double near x.
pub fn ulp(x: f64) -> f64 {
    assert!(x != 0.0 && x.is_finite());
    2.0_f64.powi(x.abs().log2().floor() as i32 - 52)
}

/// How many of a type's ulps a double's ulp is.
pub trait Precision {
    /// As kernels are called.
    const NAME: &'static str;
    /// The ratio.
    const ULP: f64;
}

impl Precision for f64 {
    const NAME: &'static str = "f64";
    const ULP: f64 = 1.0;
}

impl Precision for f32 {
    const NAME: &'static str = "f32";
    const ULP: f64 = 536_870_912.0;
}

#[test]
fn every_kernel_keeps_its_bound_and_no_bound_is_loose() {
    let mut worst = Worst::default();
    elementary::measure(&mut worst);
    rotation::measure(&mut worst);
    earth::measure(&mut worst);
    block::measure(&mut worst);
    let mut faults = String::new();
    for (kernel, &measured) in &worst.0 {
        let Some(&(_, bound)) = BOUNDS.iter().find(|(name, _)| name == kernel) else {
            faults += &format!("    (\"{kernel}\", {measured:.3}),\n");
            continue;
        };
        if measured > bound {
            faults += &format!("{kernel}: {measured} ulps, over {bound}\n");
        }
        if bound > SLACK * measured {
            faults += &format!("{kernel}: {measured} ulps, so that {bound} is too loose\n");
        }
    }
    for (kernel, _) in BOUNDS {
        if !worst.0.contains_key(*kernel) {
            faults += &format!("{kernel} is not measured\n");
        }
    }
    assert!(faults.is_empty(), "\n{faults}");
}
