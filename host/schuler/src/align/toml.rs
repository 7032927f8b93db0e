//! The file that is written: an initial.toml, below it what is known of it.

use schuler::aiding::alignment::aligned::Aligned;
use schuler_simulator::recording::navigation::NavigationRow;
use schuler_simulator::units::{DEGREE, DEGREE_PER_HOUR};

/// An initial.toml, below it what an alignment knows of it.
pub fn initial(row: &NavigationRow, aligned: Option<&Aligned<f64>>) -> String {
    let mut text = row.toml("schuler align: at the end of the stretch");
    if let Some(aligned) = aligned {
        let [north, east] = aligned.level_sigma.map(|x| x / DEGREE);
        let heading = aligned.heading_sigma / DEGREE;
        text += &format!("# 1σ: level {north:.6}°, {east:.6}°, heading {heading:.6}°\n");
        let [bias, sigma] = aligned.gyro_bias.map(|v| v.map(|x| x / DEGREE_PER_HOUR));
        text += &format!(
            "# gyro biases {:.6}, {:.6}, {:.6} °/h, 1σ {:.6}, {:.6}, {:.6}\n",
            bias.x, bias.y, bias.z, sigma.x, sigma.y, sigma.z
        );
        let [bias, sigma] = aligned.accelerometer_bias;
        text += &format!(
            "# accelerometer biases {:.3e}, {:.3e}, {:.3e} m/s², 1σ {:.3e}, {:.3e}, {:.3e}\n",
            bias.x, bias.y, bias.z, sigma.x, sigma.y, sigma.z
        );
    }
    text
}
