//! What a filter estimates beside the motion, in the units of files: biases of the sensors, and what else it has.

use crate::units::{DEGREE_PER_HOUR, MICRO_G};
use schuler::aiding::aided::settings::States;
use schuler::aiding::filter::Filter;
use schuler::aiding::model::{FIRST_EXTRA, GYRO_BIAS};
use schuler::math::real::{Real, Scalar};

/// Biases of the axes forward, right, down.
const BIASES: [&str; 6] = [
    "gyro_bias_x_deg_h",
    "gyro_bias_y_deg_h",
    "gyro_bias_z_deg_h",
    "accelerometer_bias_x_ug",
    "accelerometer_bias_y_ug",
    "accelerometer_bias_z_ug",
];

/// The further states that there are, in their order.
fn further<R>(states: &States<R>) -> impl Iterator<Item = &'static str> {
    let groups: [(&[&str], bool); 4] = [
        (
            &["lever_arm_error_x_m", "lever_arm_error_y_m", "lever_arm_error_z_m"],
            states.lever_arm.is_some(),
        ),
        (&["latency_s"], states.latency.is_some()),
        (&["barometer_bias_m"], states.barometer_bias.is_some()),
        (&["odometer_scale"], states.odometer_scale.is_some()),
    ];
    let there = groups.into_iter().filter(|(_, is_there)| *is_there);
    there.flat_map(|(names, _)| names.iter().copied())
}

/// What they are called, then the standard deviation of each.
pub fn columns<R>(states: &States<R>) -> Vec<String> {
    let names: Vec<&str> = BIASES.into_iter().chain(further(states)).collect();
    let sigmas = names.iter().map(|name| format!("{name}_sigma"));
    names.iter().map(|name| (*name).to_owned()).chain(sigmas).collect()
}

/// The numbers of these columns, in place of those that were there.
pub fn read<R: Scalar + Real, const N: usize, const P: usize, const E: usize>(
    states: &States<R>,
    filter: &Filter<R, N, P, E>,
    row: &mut Vec<f64>,
) {
    let further = further(states).count();
    let unit = |i: usize| match i {
        0..3 => DEGREE_PER_HOUR,
        3..6 => MICRO_G,
        _ => 1.0,
    };
    row.clear();
    let gyro = filter.gyro_bias().into_array();
    let biases = gyro.into_iter().chain(filter.accelerometer_bias().into_array());
    let numbers = biases.chain(filter.extras().iter().copied().take(further));
    row.extend(numbers.enumerate().map(|(i, number)| number.widen() / unit(i)));
    let covariance = filter.covariance();
    let sigma = |i: usize| covariance.covariance(GYRO_BIAS + i, GYRO_BIAS + i).widen().max(0.0);
    let count = FIRST_EXTRA - GYRO_BIAS + further;
    row.extend((0..count).map(|i| sigma(i).sqrt() / unit(i)));
}
