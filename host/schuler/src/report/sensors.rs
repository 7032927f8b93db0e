//! What the sensors of a run put out, and their errors as emulated, for curves.

use schuler::sample::Increment;
use schuler_report::canvas::Ink;
use schuler_report::envelope::Envelope;
use schuler_report::interactive::{Interactive, Scale};
use schuler_report::layer::{Kind, Layer};
use schuler_simulator::flight::Flight;
use schuler_simulator::source::{Source, SourceError};
use schuler_simulator::units::{DEGREE, DEGREE_PER_HOUR, MICRO_G};

const INKS: [Ink; 3] = [Ink::North, Ink::East, Ink::Down];
const AXES: [&str; 3] = ["x", "y", "z"];

/// Rates of rotation and specific forces over time, s: three gyros, then three accelerometers.
#[derive(Clone, Debug, Default)]
pub struct Sensors {
    /// As they arrive, °/s and m/s².
    output: Envelope<6>,
    /// Less what perfect sensors would put out, °/h and µg.
    error: Envelope<6>,
}

impl Sensors {
    /// Of the run of a number: the samples of a flight, drawn once more.
    pub fn of(flight: &Flight, run: u64) -> Result<Self, SourceError> {
        let source = Source::new(&flight.scene, false)?;
        let mut samples = source.start(run);
        let interval_s = 1.0 / source.rate_hz();
        let mut sensors = Self::default();
        for sample in 1..=flight.samples {
            let (perfect, arrived) = samples.advance_seen();
            let Some(arrived) = arrived else { continue };
            let time_s = source.time_s(sample);
            let output = sensors.row(time_s, &arrived, interval_s);
            let perfect = rates(&perfect, interval_s);
            let units = [DEGREE_PER_HOUR, MICRO_G];
            let error = std::array::from_fn(|i| (output[i] - perfect[i]) / units[i / 3]);
            sensors.error.push(time_s, error);
        }
        Ok(sensors)
    }

    /// Takes a sample that ends at a time, whose errors are not known; rad/s and m/s².
    pub fn row(&mut self, time_s: f64, sample: &Increment<f64>, interval_s: f64) -> [f64; 6] {
        let output = rates(sample, interval_s);
        let shown = std::array::from_fn(|i| if i < 3 { output[i] / DEGREE } else { output[i] });
        self.output.push(time_s, shown);
        output
    }

    /// The charts, in rows of three: the output, and the errors unless the sensors are perfect.
    pub fn charts(&self, time: (&Scale, f64)) -> [Vec<Interactive>; 2] {
        let of = |series: &Envelope<6>, what: &str, units: [&str; 2]| -> Vec<Interactive> {
            let charts = (0..6).map(|i| {
                let sensor = ["Gyro", "Accelerometer"][i / 3];
                let title = format!("{sensor} {}{what}, {}", AXES[i % 3], units[i / 3]);
                let points = series.edges(i).map(|[t, high, low]| [t * time.1, high, low]);
                let layer = Layer::new(AXES[i % 3], INKS[i % 3], Kind::Envelope, points.collect());
                Interactive::new(&title, time.0.clone(), Scale::new("", units[i / 3]))
                    .with(layer)
                    .sharing("time")
            });
            charts.collect()
        };
        let is_perfect = (0..6).all(|i| self.error.extremes(i) == [0.0, 0.0]);
        let output = of(&self.output, "", ["°/s", "m/s²"]);
        let error = of(&self.error, " error", ["°/h", "µg"]);
        [
            if self.output.is_empty() { Vec::new() } else { output },
            if is_perfect || self.error.is_empty() { Vec::new() } else { error },
        ]
    }
}

fn rates(sample: &Increment<f64>, interval_s: f64) -> [f64; 6] {
    let [a, b, c] = sample.angle_b.into_array();
    let [d, e, f] = sample.velocity_b.into_array();
    [a, b, c, d, e, f].map(|increment| increment / interval_s)
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;

    #[test]
    fn errors_are_those_of_the_scene_and_perfect_sensors_have_none() {
        let scale = Scale::new("time", "s");
        let mut flight = sample::flight();
        flight.samples = 400;
        let sensors = Sensors::of(&flight, 0).unwrap();
        let [output, error] = sensors.charts((&scale, 1.0));
        assert_eq!((output.len(), error.len()), (6, 6));
        // 0.1 °/h constant, 0.1 °/h rms, and 0.01 °/√h at 20 Hz: 0.01·√(3600·20) = 2.7 °/h.
        let [low, high] = sensors.error.extremes(0);
        assert!(low > -15.0 && high < 15.0 && high - low > 5.0, "{low} {high}");
        // Gravity, up.
        let [low, high] = sensors.output.extremes(5);
        assert!(low > -10.1 && high < -9.5, "{low} {high}");
        (flight.scene.gyro, flight.scene.accelerometer) = Default::default();
        let [output, error] = Sensors::of(&flight, 0).unwrap().charts((&scale, 1.0));
        assert_eq!((output.len(), error.len()), (6, 0));
    }
}
