//! Rows of states with their standard deviations, as in an aided `nav.csv`.

use super::smoother::Smoothed;
use crate::flight::Nine;
use crate::output::NumberRows;
use crate::recording::navigation::{COLUMNS, NavigationRow};
use schuler::solution::Solution;

/// Columns of a row.
pub const WIDTH: usize = COLUMNS.len() + Nine::SIGMAS.len();

/// Their names.
pub fn columns() -> Vec<&'static str> {
    COLUMNS.into_iter().chain(Nine::SIGMAS).collect()
}

/// A row: the state, and standard deviations, those of attitude in seconds of arc.
pub fn numbers(time_s: f64, state: &Solution<f64>, covariance: &[[f64; 9]; 9]) -> [f64; WIDTH] {
    let columns = NavigationRow::new(time_s, state).columns();
    let mut row = [0.0; WIDTH];
    for (cell, number) in
        row.iter_mut().zip(columns.into_iter().chain(Nine::of_covariance(covariance).numbers()))
    {
        *cell = number;
    }
    row
}

/// Smoothed states, each at a time that is a function of its samples.
pub fn smoothed(states: &[Smoothed], time_s: impl Fn(u64) -> f64) -> NumberRows {
    let mut rows = NumberRows::new(&columns());
    for Smoothed { samples, solution, covariance, .. } in states {
        rows.add(&numbers(time_s(*samples), solution, covariance));
    }
    rows
}
