//! What the navigator expects of a measurement, less what is measured, and how it depends on the errors.

use super::locality::Locality;
use super::measured::Measured;
use super::moment::Moment;
use super::settings::Places;
use crate::aiding::gate::Rows;
use crate::aiding::measurement::{self, Turning};
use crate::aiding::model::{FIRST_EXTRA, GYRO_BIAS};
use crate::aiding::states::latency::Latency;
use crate::aiding::states::lever_arm::LeverArm;
use crate::aiding::states::scale::Scale;
use crate::aiding::transition::cross_matrix;
use crate::math::quaternion::Matrix;
use crate::math::real::Scalar;
use crate::math::vector::Vector;

/// A measurement in the light of a moment.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Expected<'a, R> {
    /// The vehicle when it was true.
    pub moment: &'a Moment<R>,
    /// The Earth there.
    pub locality: &'a Locality<R>,
    /// Where the further states are.
    pub places: Places,
    /// Their estimates.
    pub extras: &'a [R],
    /// The lever arms that the settings have.
    pub levers_b: [Vector<R>; 3],
}

impl<R: Scalar> Expected<'_, R> {
    /// An estimate.
    fn estimate(&self, state: Option<usize>) -> R {
        let at = state.and_then(|state| state.checked_sub(FIRST_EXTRA));
        at.and_then(|at| self.extras.get(at)).copied().unwrap_or(R::ZERO)
    }

    /// The antenna's lever arm with its estimated error.
    fn lever(&self) -> Vector<R> {
        let [lever, ..] = self.levers_b;
        let Some(first) = self.places.lever_arm else { return lever };
        let at = |n: usize| self.estimate(Some(first + n));
        lever + Vector::new(at(0), at(1), at(2))
    }

    /// ω_ebᵇ, ω_ieᵇ, rad/s.
    fn rates(&self) -> (Vector<R>, Vector<R>) {
        let earth = self.moment.pose.to_body(self.locality.here.earth_rate_ned);
        (self.moment.rate_ib_b - earth, earth)
    }

    /// Velocity at a lever arm, in body axes, m/s.
    fn velocity_b(&self, lever: Vector<R>) -> Vector<R> {
        let pose = &self.moment.pose;
        pose.to_body(pose.velocity_ned) + self.rates().0.cross(lever)
    }

    /// Rows of body axes turned to north, east and down, each with its own standard deviation.
    fn turned<const N: usize>(&self, rows: &Rows<R, N, 3>, sigma_ned: Vector<R>) -> Rows<R, N, 3> {
        let turned = self.moment.pose.body_to_ned.rows;
        let combined = |axis: Vector<R>| {
            let mut sum = [R::ZERO; N];
            for (k, row) in axis.into_array().into_iter().zip(&rows.rows) {
                for (cell, x) in sum.iter_mut().zip(row) {
                    *cell = *cell + k * *x;
                }
            }
            sum
        };
        let innovation = Vector::from(rows.innovation);
        Rows {
            rows: turned.map(combined),
            innovation: turned.map(|axis| axis.dot(innovation)),
            variance: sigma_ned.map(|sigma| sigma * sigma).into_array(),
        }
    }

    /// With the columns of lever arm and latency.
    fn with_states<const N: usize>(
        &self,
        rows: Rows<R, N, 3>,
        lever: &Matrix<R>,
        change_ned: Vector<R>,
    ) -> Rows<R, N, 3> {
        let mut rows = rows;
        if let Some(first) = self.places.lever_arm {
            rows = rows.with(first, lever);
        }
        if let Some(state) = self.places.latency {
            rows = rows.with_column(state, Latency::column(self.moment.pose.to_body(change_ned)));
        }
        rows
    }

    /// A position of the antenna.
    pub fn position<const N: usize>(&self, measured: &Measured<R>) -> Rows<R, N, 3> {
        let Moment { base, way_ned, pose, .. } = self.moment;
        let lever = self.lever();
        let beyond = *way_ned - self.locality.way(base, &measured.position);
        let rows = measurement::position(pose.to_body(beyond) + lever, lever, R::ONE);
        let rows = self.with_states(rows, &LeverArm::of_position(), pose.velocity_ned);
        self.turned(&rows, measured.position_sigma)
    }

    /// A velocity of the antenna.
    pub fn velocity<const N: usize>(&self, measured: &Measured<R>) -> Rows<R, N, 3> {
        let Moment { pose, rate_ib_b, acceleration_ned, .. } = self.moment;
        let (lever, (rate_eb_b, earth_rate_b)) = (self.lever(), self.rates());
        let innovation = self.velocity_b(lever) - pose.to_body(measured.velocity);
        let turning = Turning { earth_rate_b, rate_ib_b: *rate_ib_b };
        let rows = measurement::velocity(innovation, &turning, lever, R::ONE);
        let rows = self.with_states(rows, &LeverArm::of_velocity(rate_eb_b), *acceleration_ned);
        self.turned(&rows, measured.velocity_sigma)
    }

    /// Both.
    pub fn position_velocity<const N: usize>(&self, measured: &Measured<R>) -> Rows<R, N, 6> {
        let (a, b) = (self.position(measured), self.velocity(measured));
        let joined = |a: [R; 3], b: [R; 3]| {
            let ([a0, a1, a2], [b0, b1, b2]) = (a, b);
            [a0, a1, a2, b0, b1, b2]
        };
        let ([a0, a1, a2], [b0, b1, b2]) = (a.rows, b.rows);
        Rows {
            rows: [a0, a1, a2, b0, b1, b2],
            innovation: joined(a.innovation, b.innovation),
            variance: joined(a.variance, b.variance),
        }
    }

    /// What is expected of position and velocity less what is measured, north, east, down, m and m/s.
    pub fn innovations(&self, measured: &Measured<R>) -> [Vector<R>; 2] {
        let Moment { base, way_ned, pose, .. } = self.moment;
        let lever = self.lever();
        let beyond = *way_ned - self.locality.way(base, &measured.position);
        let faster = pose.body_to_ned * self.velocity_b(lever) - measured.velocity;
        [beyond + pose.body_to_ned * lever, faster]
    }

    /// A barometer's height.
    pub fn height<const N: usize>(&self, measured: &Measured<R>) -> Rows<R, N, 1> {
        let Moment { base, way_ned, pose, .. } = self.moment;
        let [.., lever] = self.levers_b;
        let down_b = pose.to_body(Vector::new(R::ZERO, R::ZERO, R::ONE));
        let above = (base.altitude - measured.position.altitude).hi;
        let bias = self.estimate(self.places.barometer_bias);
        let innovation = above - way_ned.z - down_b.dot(lever) + bias;
        let rows = measurement::height(innovation, down_b, lever, measured.position_sigma.z);
        let [mut row] = rows.rows;
        if let Some(cell) = self.places.barometer_bias.and_then(|state| row.get_mut(state)) {
            *cell = R::ONE;
        }
        Rows { rows: [row], ..rows }
    }

    /// The velocity at the odometer, in body axes.
    fn along_body<const N: usize>(&self) -> (Vector<R>, Rows<R, N, 3>) {
        let [_, lever, _] = self.levers_b;
        let pose = &self.moment.pose;
        let velocity = self.velocity_b(lever);
        let centre = pose.to_body(pose.velocity_ned);
        let rows = measurement::along_body(velocity, centre, self.rates().1, R::ONE)
            .with(GYRO_BIAS, &cross_matrix(-lever));
        (velocity, rows)
    }

    /// An odometer's speed.
    pub fn speed<const N: usize>(&self, measured: &Measured<R>) -> Rows<R, N, 1> {
        // z = (1 + k)v_x
        let (velocity, rows) = self.along_body::<N>();
        let factor = R::ONE + self.estimate(self.places.odometer_scale);
        let [mut row, ..] = rows.rows.map(|row| row.map(|x| x * factor));
        if let Some(cell) = self.places.odometer_scale.and_then(|state| row.get_mut(state)) {
            *cell = Scale::column(velocity.x);
        }
        let sigma = measured.velocity_sigma.x;
        let innovation = velocity.x * factor - measured.velocity.x;
        Rows { rows: [row], innovation: [innovation], variance: [sigma * sigma] }
    }

    /// No speed to the right or downwards.
    pub fn non_holonomic<const N: usize>(&self, measured: &Measured<R>) -> Rows<R, N, 2> {
        let (velocity, rows) = self.along_body();
        let [_, right, down] = rows.rows;
        let Vector { y, z, .. } = measured.velocity_sigma;
        Rows { rows: [right, down], innovation: [velocity.y, velocity.z], variance: [y * y, z * z] }
    }

    /// No velocity.
    pub fn zero_velocity<const N: usize>(&self, measured: &Measured<R>) -> Rows<R, N, 3> {
        let pose = &self.moment.pose;
        let velocity = pose.to_body(pose.velocity_ned);
        measurement::zero_velocity(velocity, self.rates().1, measured.velocity_sigma.x)
    }
}
