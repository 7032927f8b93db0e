//! `imu.csv`: increments or instantaneous rates, a row per sample, its time the interval's end.

use super::Unread;
use crate::input::{Complaint, InputError};
use schuler::math::vector::Vector;
use schuler::sample::Increment;

/// Columns of a file of increments.
pub const INCREMENTS: [&str; 7] = [
    "time_s",
    "dtheta_x_rad",
    "dtheta_y_rad",
    "dtheta_z_rad",
    "dvel_x_m_s",
    "dvel_y_m_s",
    "dvel_z_m_s",
];
/// Columns of a file of instantaneous rates.
pub const RATES: [&str; 7] = [
    "time_s",
    "gyro_x_rad_s",
    "gyro_y_rad_s",
    "gyro_z_rad_s",
    "accel_x_m_s2",
    "accel_y_m_s2",
    "accel_z_m_s2",
];

/// The headers that are accepted.
pub(super) fn accepted() -> String {
    format!("{} or {}", INCREMENTS.join(","), RATES.join(","))
}

/// The columns that a header names, if it is one of these.
pub(super) fn columns(header: &[u8]) -> Option<&'static [&'static str; 7]> {
    let is = |columns: &[&str]| fields(header).eq(columns.iter().map(|column| column.as_bytes()));
    [&INCREMENTS, &RATES].into_iter().find(|columns| is(&columns[..]))
}

/// A row's stamp and values, or the stamp alone.
pub(super) fn row(
    name: &str,
    line: u64,
    columns: &[&str; 7],
    text: &[u8],
    whole: bool,
) -> Result<(f64, Increment<f64>), Unread> {
    let mut values = [0.0; 7];
    let mut stamp = None;
    let wanted = if whole { columns.len() } else { 1 };
    let mut found = 0;
    for (field, (value, column)) in fields(text).zip(values.iter_mut().zip(columns)).take(wanted) {
        match number(field) {
            Some(number) if number.is_finite() => *value = number,
            _ => {
                let count = fields(text).count();
                if count != columns.len() {
                    return Err(Unread {
                        stamp,
                        error: Box::new(miscounted(name, line, columns, count)),
                    });
                }
                let what = format!("\"{}\" is not a finite number", String::from_utf8_lossy(field));
                let complaint = Complaint::new(what, "a finite number");
                return Err(Unread {
                    stamp,
                    error: Box::new(InputError::key(name, line, column, complaint)),
                });
            }
        }
        stamp = stamp.or(Some(*value));
        found += 1;
    }
    if found < wanted || (whole && text.iter().filter(|&&b| b == b',').count() != 6) {
        let error = Box::new(miscounted(name, line, columns, fields(text).count()));
        return Err(Unread { stamp, error });
    }
    let [time, x, y, z, u, v, w] = values;
    Ok((time, Increment { angle_b: Vector::new(x, y, z), velocity_b: Vector::new(u, v, w) }))
}

/// Fields of a line, without spaces and quotes around them.
fn fields(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(|&byte| byte == b',').map(|field| {
        let field = field.trim_ascii();
        field.strip_prefix(b"\"").and_then(|f| f.strip_suffix(b"\"")).unwrap_or(field)
    })
}

fn number(field: &[u8]) -> Option<f64> {
    std::str::from_utf8(field).ok()?.parse().ok()
}

fn miscounted(name: &str, line: u64, columns: &[&str; 7], count: usize) -> InputError {
    let what = format!("the row has {count} values");
    let accepted = format!("{}: {}", columns.len(), columns.join(","));
    InputError::line(name, line, Complaint::new(what, accepted))
}
