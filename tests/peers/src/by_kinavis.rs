//! kinavis-ins. It has no lever arm for velocities: those of the antenna are taken to the inertial unit here, by its own
//! attitude and gyros. Its biases walk: as little as it admits.

use crate::Failed;
use crate::flight::{Filter, Fix, Flight, Row, Sample, Told};
use kinavis_ins::{ImuNoise, ImuSample, InsFilter, InsPriors, Quaternion, Strapdown};
use kinavis_kernel::estimation::GatingPolicy;
use kinavis_kernel::geodesy::{GeodeticPoint, Height};
use kinavis_kernel::local::{Body, Ned, Vector3};
use kinavis_kernel::time::{Instant, Utc};
use kinavis_kernel::{Angle, Distance, Position, Speed, TrueCourse};
use std::time::Duration;

/// A bias that does not walk, rad/s/√s and m/s²/√s.
const STANDS: f64 = 1e-15;

/// One in flight.
pub struct ByKinavis {
    told: Told,
    filter: InsFilter,
    interval: Duration,
    lever: Vector3<Body, Distance>,
}

/// At the start of a flight.
pub fn start(flight: &Flight) -> Result<ByKinavis, Failed> {
    let told = flight.told;
    let [latitude, longitude, altitude, north, east, down, roll, pitch, yaw] = told.initial;
    let attitude = Quaternion::from_euler(
        Angle::from_degrees(roll)?,
        Angle::from_degrees(pitch)?,
        course(yaw),
    );
    let strapdown = Strapdown::new(
        Instant::<Utc>::from_unix_seconds(0),
        point([latitude, longitude, altitude])?,
        velocity([north, east, down])?,
        attitude,
    )?;
    let noise = ImuNoise::new(told.gyro_noise, told.accelerometer_noise, STANDS, STANDS)?;
    let position = Distance::from_metres(told.position_m)?;
    let priors = InsPriors::new(
        position,
        position,
        Speed::from_metres_per_second(told.velocity_m_s)?,
        Angle::from_radians(told.level_rad)?,
        Angle::from_radians(told.heading_rad)?,
        told.gyro_bias,
        told.accelerometer_bias,
    )?;
    let [forward, right, down] = told.lever;
    let metres = Distance::from_metres;
    Ok(ByKinavis {
        told,
        filter: InsFilter::new(strapdown, noise, &priors),
        interval: Duration::from_secs_f64(1.0 / told.rate_hz),
        lever: Vector3::new(metres(forward)?, metres(right)?, metres(down)?),
    })
}

impl Filter for ByKinavis {
    fn sample(&mut self, sample: &Sample, fix: Option<&Fix>) -> Result<(), Failed> {
        let rate = |increment: [f64; 3]| increment.map(|x| x * self.told.rate_hz);
        let turn = rate(sample.angle);
        self.filter.predict(&ImuSample::new(turn, rate(sample.velocity), self.interval)?)?;
        let Some(fix) = fix else { return Ok(()) };
        let sigma = Distance::from_metres(self.told.fix_position_m)?;
        let place = point(fix.place)?;
        self.filter.update_antenna_point(place, self.lever, sigma, sigma, GatingPolicy::none())?;
        if let Some(antenna) = fix.velocity {
            let sigma = Speed::from_metres_per_second(self.told.fix_velocity_m_s)?;
            let unit = velocity(self.of_the_unit(antenna, turn))?;
            self.filter.update_velocity(unit, sigma, GatingPolicy::none())?;
        }
        Ok(())
    }

    fn finish(&mut self) {}

    fn row(&self, time_s: f64) -> Result<Row, Failed> {
        let point = self.filter.nominal().point()?;
        let [latitude, longitude] =
            [point.position().latitude().degrees(), point.position().longitude().degrees()];
        let altitude = point.height().value().metres();
        let [north, east, down] = self.filter.velocity().components().map(Speed::metres_per_second);
        let attitude = self.filter.attitude();
        let [roll, pitch, yaw] =
            [attitude.roll.degrees(), attitude.pitch.degrees(), attitude.yaw.degrees()];
        let covariance = self.filter.covariance();
        let sigma = |i| covariance.get(i, i).map_or(f64::NAN, f64::sqrt);
        let [n, e, d] = [sigma(0), sigma(1), sigma(2)];
        Ok([time_s, latitude, longitude, altitude, north, east, down, roll, pitch, yaw, n, e, d])
    }
}

impl ByKinavis {
    /// The unit's velocity by that of the antenna, which turns about it. The Earth's rate is 0.1 mm/s at the antenna.
    fn of_the_unit(&self, [north, east, down]: [f64; 3], turn: [f64; 3]) -> [f64; 3] {
        let bias = self.filter.nominal().gyro_bias();
        let [x, y, z] = [turn[0] - bias[0], turn[1] - bias[1], turn[2] - bias[2]];
        let [a, b, c] = self.told.lever;
        let swept = [y * c - z * b, z * a - x * c, x * b - y * a];
        let [n, e, d] = self.filter.quaternion().rotate(swept);
        [north - n, east - e, down - d]
    }
}

fn point([latitude, longitude, altitude]: [f64; 3]) -> Result<GeodeticPoint, Failed> {
    let height = Height::above_ellipsoid(Distance::from_metres(altitude)?);
    Ok(GeodeticPoint::new(Position::from_degrees(latitude, longitude)?, height))
}

fn velocity([north, east, down]: [f64; 3]) -> Result<Vector3<Ned, Speed>, Failed> {
    let speed = Speed::from_metres_per_second;
    Ok(Vector3::new(speed(north)?, speed(east)?, speed(down)?))
}

fn course(yaw_deg: f64) -> TrueCourse {
    TrueCourse::from_degrees_wrapped(yaw_deg)
}
