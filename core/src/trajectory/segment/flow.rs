//! The path that controls drive, as a Taylor series on the ellipsoid.
//!
//! State: the outward normal n̂, the horizontal direction of travel ĥ, both in Earth-fixed axes, and the
//! height h. With speed V, climb angle g, course rate χ̇, σ = n̂_z, p = ẑ − σn̂, v_h = V cos g:
//!
//! ```text
//! n̂' = v_h [ĥ/(N + h) + (ĥ·p) p K],  K = e²N/(W²(R_M + h)(N + h))
//! ĥ' = −(ĥ·n̂') n̂ + χ̇ (ĥ × n̂)
//! h' = V sin g
//! N = a/W,  R_M = a(1 − e²)/W³,  W² = 1 − e²σ²
//! ```
//!
//! So χ̇ = 0 is a geodesic: the direction is carried along parallel to itself. Nothing is singular at a pole.
//! A rhumb line takes the course rate that keeps the angle to the meridian, −v_h(ĥ·Ê)tanφ/(N + h).
//! Source: v = R_M + h along north, N + h along east (Groves, *Principles of GNSS, Inertial and Multisensor
//! Integrated Navigation Systems*, 2nd ed., §2.4.2) written without the angles: 1/(R_M + h) = 1/(N + h) + K|p|².
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::segment::control::Controls;
//! use schuler::trajectory::segment::flow::Track;
//!
//! // From a degree short of the pole, northwards over it, at 250 m/s.
//! let from = Geodetic { latitude: 89_f64.to_radians(), longitude: 0.5, altitude: 1000.0 };
//! let track = Track::new(from, 0.0).after(&Controls::steady(900.0, 250.0));
//! // Behind the pole the same line leads south on the opposite meridian.
//! assert!((track.course().abs() - core::f64::consts::PI).abs() < 1e-12);
//! assert!((track.position().longitude - (0.5 - core::f64::consts::PI)).abs() < 1e-12);
//! ```

use super::control::{Controls, Drive, Line};
use crate::earth::{ECCENTRICITY_SQUARED, Geodetic, SEMI_MAJOR_AXIS};
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::trajectory::geographic::angles;
use crate::trajectory::series::Series;
use crate::trajectory::wrap;

/// Number of coefficients with which a path is followed: order 16.
pub const FLOW_TERMS: usize = 17;

/// Where a path is and where it leads.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Track {
    /// The outward normal n̂, in Earth-fixed axes.
    pub normal_e: Vector<Pair<f64>>,
    /// The horizontal direction of travel ĥ, in Earth-fixed axes.
    pub along_e: Vector<f64>,
    /// Height above the ellipsoid, m.
    pub altitude: Pair<f64>,
}

impl Track {
    /// At a place, with a course from north to east in rad. At a pole the longitude tells which way is north.
    pub fn new(at: Geodetic<f64>, course: f64) -> Self {
        let (s, c) = Pair::new(at.latitude).sin_cos();
        let (sl, cl) = Pair::new(wrap(at.longitude)).sin_cos();
        let (sine, cosine) = Pair::new(wrap(course)).sin_cos();
        let north = Vector::new(-(s * cl), -(s * sl), c);
        let east = Vector::new(-sl, cl, Pair::default());
        let along = north * cosine + east * sine;
        Self {
            normal_e: Vector::new(c * cl, c * sl, s),
            along_e: along.map(|x| x.hi),
            altitude: Pair::new(at.altitude),
        }
    }

    /// The place, angles in rad; any longitude at a pole.
    pub fn position(&self) -> Geodetic<f64> {
        let (latitude, longitude) = angles(self.normal_e.map(|n| n.hi));
        Geodetic { latitude, longitude, altitude: self.altitude.hi }
    }

    /// The course, from north to east, in (−π, π] rad.
    pub fn course(&self) -> f64 {
        // ĥ·N̂ cosφ = ĥ_z,  ĥ·Ê cosφ = (ẑ × n̂)·ĥ
        let (n, h) = (self.normal_e, self.along_e);
        let east = n.x * Pair::new(h.y) - n.y * Pair::new(h.x);
        Real::atan2(east.hi, h.z)
    }

    /// Where controls lead in the end: the same as of the last piece that is made of them.
    pub fn after(&self, controls: &Controls) -> Self {
        let (mut track, mut time_s) = (*self, 0.0);
        if controls.is_still() {
            return track;
        }
        while controls.duration_s - time_s > super::control::LEAST_SPAN_S {
            let joint = controls.joint_after(time_s);
            let inside = 0.5 * (time_s + joint);
            let count = track.pieces(controls, inside, joint - time_s);
            let span = (joint - time_s) / count;
            let mut index = 0.0;
            while index < count {
                track = track.along(controls, time_s + span * index, span, inside);
                index += 1.0;
            }
            time_s = joint;
        }
        track
    }

    /// Where controls lead from a time on within a span of a piece, both in s.
    pub(super) fn along(
        &self,
        controls: &Controls,
        from_s: f64,
        span_s: f64,
        inside_s: f64,
    ) -> Self {
        // A step of the seventh order bends so much that one series does not reach across a piece.
        let (count, span_s) =
            if controls.steps_at(inside_s) { (3, span_s / 3.0) } else { (1, span_s) };
        (0..count).fold(*self, |track, part| {
            let from_s = from_s + f64::from(part) * span_s;
            let flow = Flow::<FLOW_TERMS>::new(&track, &controls.drive(from_s, inside_s));
            flow.after(&track, span_s)
        })
    }

    /// Into how many pieces a span, s, goes between two joints.
    pub(super) fn pieces(&self, controls: &Controls, inside_s: f64, span_s: f64) -> f64 {
        let mut longest = controls.longest_span_s(inside_s);
        if controls.line == Line::Rhumb {
            // The course rate grows as 1/cosφ.
            longest = longest
                .min(0.1 * SEMI_MAJOR_AXIS * self.cosine() / controls.speed.largest(inside_s));
        }
        let least = span_s / longest * (1.0 - 1e-12);
        // Rounded up.
        let near = Real::round(least);
        let count = if near < least { near + 1.0 } else { near };
        count.max(1.0)
    }

    /// cosφ.
    pub(super) fn cosine(&self) -> f64 {
        let n = self.normal_e.map(|n| n.hi);
        Real::sqrt(n.x * n.x + n.y * n.y)
    }
}

/// A path about an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Flow<const N: usize> {
    /// n̂.
    pub normal_e: Vector<Series<N>>,
    /// ĥ.
    pub along_e: Vector<Series<N>>,
    /// h, m.
    pub altitude: Series<N>,
}

impl<const N: usize> Flow<N> {
    /// From the state at the instant and what drives it, coefficient by coefficient.
    pub fn new(track: &Track, drive: &Drive<N>) -> Self {
        const E2: f64 = ECCENTRICITY_SQUARED;
        let mut n = track.normal_e.map(|n| Series::constant(n.hi));
        let mut h = track.along_e.map(Series::constant);
        let mut altitude = drive.climb_speed().integral();
        altitude.set(0, track.altitude.hi);
        let speed = drive.level_speed();

        let zero = Series::ZERO;
        let (mut w2, mut inverse_w, mut inverse_w2) = (zero, zero, zero);
        // N + h and R_M + h, the inverse of their product, 1/(N + h), N/W², K
        let (mut east, mut north, mut both, mut inverse) = (zero, zero, zero, zero);
        let (mut inverse_east, mut curved, mut k_factor) = (zero, zero, zero);
        // α = v_h/(N + h), β = v_h ĥ_z K, so that n̂' = αĥ + β(ẑ − σn̂)
        let (mut slope, mut alpha, mut beta, mut beta_sine, mut carried) =
            (zero, zero, zero, zero, zero);
        let mut rate = drive.course_rate;
        let mut rhumb = Rhumb::default();
        let mut cross = Vector::new(zero, zero, zero);
        for k in 0..N.saturating_sub(1) {
            let unit = if k == 0 { 1.0 } else { 0.0 };
            w2.set(k, unit - E2 * n.z.product_term(&n.z, k));
            inverse_w.set(k, w2.root_term(&inverse_w, k));
            inverse_w2.set(k, inverse_w.product_term(&inverse_w, k));
            curved.set(k, SEMI_MAJOR_AXIS * inverse_w.product_term(&inverse_w2, k));
            let height = altitude.coefficient(k);
            east.set(k, SEMI_MAJOR_AXIS * inverse_w.coefficient(k) + height);
            north.set(k, (1.0 - E2) * curved.coefficient(k) + height);
            both.set(k, east.product_term(&north, k));
            inverse.set(k, both.inverse_term(&inverse, k));
            inverse_east.set(k, north.product_term(&inverse, k));
            k_factor.set(k, E2 * curved.product_term(&inverse, k));

            alpha.set(k, speed.product_term(&inverse_east, k));
            slope.set(k, h.z.product_term(&k_factor, k));
            beta.set(k, speed.product_term(&slope, k));
            beta_sine.set(k, beta.product_term(&n.z, k));
            // ĥ·n̂' = α + β ĥ_z
            carried.set(k, alpha.coefficient(k) + beta.product_term(&h.z, k));
            let product = |a: &Series<N>, b: &Series<N>| a.product_term(b, k);
            cross.x.set(k, product(&h.y, &n.z) - product(&h.z, &n.y));
            cross.y.set(k, product(&h.z, &n.x) - product(&h.x, &n.z));
            cross.z.set(k, product(&h.x, &n.y) - product(&h.y, &n.x));
            if drive.line == Line::Rhumb {
                let turn = rhumb.term(&n, &h, &alpha, k);
                rate.set(k, rate.coefficient(k) + turn);
            }

            let next = 1.0 / (k + 1) as f64;
            let towards = [0.0, 0.0, beta.coefficient(k)];
            let axes = n.each_mut().into_iter().zip(h.each_mut()).zip(cross.each_mut());
            for (((n, h), cross), towards) in axes.zip(towards) {
                let normal = alpha.product_term(h, k) - beta_sine.product_term(n, k) + towards;
                let along = rate.product_term(cross, k) - carried.product_term(n, k);
                n.set(k + 1, normal * next);
                h.set(k + 1, along * next);
            }
        }
        Self { normal_e: n, along_e: h, altitude }
    }

    /// The state after a time, s, brought back to directions of unit length at right angles.
    pub fn after(&self, from: &Track, time_s: f64) -> Track {
        let growth = self.normal_e.map(|n| n.growth(time_s));
        let mut normal_e = from.normal_e;
        // What stands keeps its place to the last bit.
        if growth != Vector::ZERO {
            let normal = normal_e.zip(growth, |n, d| Pair::sum(n.hi, n.lo + d));
            // n̂ ← n̂ − ½n̂(|n̂|² − 1), |n̂|² to twice the digits
            let excess = (normal.dot(normal) - Pair::new(1.0)).hi;
            normal_e = normal.map(|n| Pair::sum(n.hi, n.lo - 0.5 * excess * n.hi));
        }
        // ĥ ← ĥ − n̂(ĥ·n̂), then the same
        let along = self.along_e.map(|h| h.after(time_s));
        let n = normal_e.map(|n| n.hi);
        let along = along - n * n.dot(along);
        let along_e = along * (1.5 - 0.5 * along.dot(along));
        let altitude = from.altitude + Pair::new(self.altitude.growth(time_s));
        Track { normal_e, along_e, altitude }
    }
}

/// The course rate that keeps the angle to the meridian.
#[derive(Clone, Copy, Debug, Default)]
struct Rhumb<const N: usize> {
    cosine2: Series<N>,
    inverse: Series<N>,
    east: Series<N>,
    ratio: Series<N>,
    tangent: Series<N>,
}

impl<const N: usize> Rhumb<N> {
    /// Coefficient `k` of −v_h(ĥ·Ê)tanφ/(N + h).
    fn term(
        &mut self,
        n: &Vector<Series<N>>,
        h: &Vector<Series<N>>,
        alpha: &Series<N>,
        k: usize,
    ) -> f64 {
        // (ĥ·Ê)tanφ = σ(n̂_x ĥ_y − n̂_y ĥ_x)/cos²φ,  cos²φ = n̂_x² + n̂_y²
        self.cosine2.set(k, n.x.product_term(&n.x, k) + n.y.product_term(&n.y, k));
        self.inverse.set(k, self.cosine2.inverse_term(&self.inverse, k));
        self.east.set(k, n.x.product_term(&h.y, k) - n.y.product_term(&h.x, k));
        self.ratio.set(k, self.east.product_term(&self.inverse, k));
        self.tangent.set(k, self.ratio.product_term(&n.z, k));
        -alpha.product_term(&self.tangent, k)
    }
}
