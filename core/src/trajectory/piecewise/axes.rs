//! Attitude by a rule: body axes from the path alone, without stored angles.
//!
//! Forward lies along the velocity, and down lies in the plane of forward and a vector that the rule names.
//! Source: the frame of a coordinated turn, Stevens & Lewis, Aircraft Control and Simulation, §3.6.

use super::place::Place;
use crate::earth::ROTATION_RATE;
use crate::math::quaternion::Quaternion;
use crate::math::vector::Vector;
use crate::trajectory::columns::quaternion;
use crate::trajectory::series::Series;

/// Where the attitude of a path comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Attitude {
    /// The pieces' own quaternions.
    Stored,
    /// Forward along the velocity, no lateral specific force: an aircraft's banked turns.
    Coordinated,
    /// Forward along the velocity, no roll: a vehicle on its road.
    Upright,
    /// Forward along the course, no roll and no pitch.
    Level,
}

/// Forward, right and down at an instant, in Earth-fixed axes, and their rate: [`Axes`] in closed form, at half the cost,
/// for what every sample asks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turning {
    axes: [Vector<f64>; 3],
    /// ω_ebᵇ, rad/s.
    pub rate_eb_b: Vector<f64>,
}

impl Turning {
    /// Of a velocity and a vector that down points away from, each with its derivative.
    #[inline(always)]
    fn new([v, v1]: [Vector<f64>; 2], [w, w1]: [Vector<f64>; 2]) -> Self {
        // x = v/|v|,  ẋ = (v̇ − x(x·v̇))/|v|,  z = −(w − x(x·w))/|…|,  y = z × x
        let per_speed = 1.0 / v.norm();
        let x = v * per_speed;
        let x1 = (v1 - x * x.dot(v1)) * per_speed;
        let along = x.dot(w);
        let across = w - x * along;
        let per_length = 1.0 / across.norm();
        let z = across * -per_length;
        let y = z.cross(x);
        // p = (ẇ·y − (ẋ·y)(x·w))/|w − x(x·w)|,  q = −ẋ·z,  r = ẋ·y
        let yaw_rate = x1.dot(y);
        let roll_rate = (w1.dot(y) - yaw_rate * along) * per_length;
        Self { axes: [x, y, z], rate_eb_b: Vector::new(roll_rate, -x1.dot(z), yaw_rate) }
    }

    /// Of a path by a rule.
    #[inline(always)]
    pub fn by_rule<const N: usize>(
        rule: Attitude,
        place: &Place<N>,
        velocity: Vector<Series<2>>,
        force: Vector<Series<2>>,
    ) -> Self {
        let both = |a: Vector<Series<2>>| [0, 1].map(|k| a.map(|c| c.coefficient(k)));
        let normal = || both(place.normal());
        match rule {
            Attitude::Coordinated | Attitude::Stored => Self::new(both(velocity), both(force)),
            Attitude::Upright => Self::new(both(velocity), normal()),
            Attitude::Level => {
                // v − n̂(v·n̂), and its derivative
                let ([v, v1], [n, n1]) = (both(velocity), normal());
                let climb = v.dot(n);
                let level = v - n * climb;
                let change = v1 - n1 * climb - n * (v1.dot(n) + v.dot(n1));
                Self::new([level, change], [n, n1])
            }
        }
    }

    /// A vector of the Earth's axes in these.
    #[inline(always)]
    pub fn to_body(self, a: Vector<f64>) -> Vector<f64> {
        let [x, y, z] = self.axes;
        Vector::new(x.dot(a), y.dot(a), z.dot(a))
    }

    /// The quaternion body → Earth-fixed axes.
    pub fn quaternion(&self) -> Quaternion<f64> {
        let [x, y, z] = self.axes.map(|axis| axis.map(Series::<1>::constant));
        value(quaternion(x, y, z))
    }
}

/// Forward, right and down as series, in Earth-fixed axes; and fᵉ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axes<const M: usize> {
    axes: [Vector<Series<M>>; 3],
}

/// v = ṙ and fᵉ = r̈ + 2Ω × ṙ + γn̂ as series.
#[inline(always)]
pub(super) fn motion<const N: usize, const M: usize>(
    place: &Place<N>,
) -> (Vector<Series<M>>, Vector<Series<M>>) {
    let velocity = place.position.map(|r| r.derivative());
    let v = velocity.map(|v| v.first::<M>());
    let acceleration = velocity.map(|v| v.derivative().first::<M>());
    let normal = place.normal::<M>();
    let mut force = acceleration + normal * place.gravity();
    force.x = force.x - v.y.scaled(2.0 * ROTATION_RATE);
    force.y = force.y + v.x.scaled(2.0 * ROTATION_RATE);
    (v, force)
}

impl<const M: usize> Axes<M> {
    /// Of a place whose series has two more coefficients. Not a number at rest.
    #[inline(always)]
    pub fn new<const N: usize>(
        rule: Attitude,
        place: &Place<N>,
        velocity: Vector<Series<M>>,
        force: Vector<Series<M>>,
    ) -> Self {
        // x = v/|v|,  z = −(w − x(x·w))/|…|,  y = z × x
        let normal = place.normal::<M>();
        let unit = |a: Vector<Series<M>>| a * a.dot(a).reciprocal_root();
        let (x, w) = match rule {
            Attitude::Coordinated | Attitude::Stored => (unit(velocity), force),
            Attitude::Upright => (unit(velocity), normal),
            Attitude::Level => (unit(velocity - normal * velocity.dot(normal)), normal),
        };
        let z = -unit(w - x * x.dot(w));
        Self { axes: [x, z.cross(x), z] }
    }

    /// ω_ebᵇ with `M − 1` coefficients.
    #[inline(always)]
    pub fn rate(&self) -> Vector<Series<M>> {
        // Ċ_bᵉ = C_bᵉ[ω×]:  ω = (z·ẏ, x·ż, y·ẋ)
        let [x, y, z] = self.axes;
        let rate = |a: Vector<Series<M>>, b: Vector<Series<M>>| a.dot(b.map(|c| c.derivative()));
        Vector::new(rate(z, y), rate(x, z), rate(y, x))
    }

    /// The quaternion body → Earth-fixed axes.
    pub fn quaternion(&self) -> Quaternion<f64> {
        let [x, y, z] = self.axes.map(|axis| axis.map(|c| c.first::<1>()));
        value(quaternion(x, y, z))
    }
}

/// At the instant itself.
fn value(q: Quaternion<Series<1>>) -> Quaternion<f64> {
    q.map(|c| c.value())
}
