//! Core's aided navigator, local-level, blocks of four samples: what `schuler replay` flies.

use crate::Failed;
use crate::flight::{Filter, Fix, Flight, Row, Sample, Told};
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::Measured;
use schuler::aiding::aided::navigator::Aided15;
use schuler::aiding::aided::settings::{Settings, Start, States};
use schuler::aiding::aided::state::AidedState;
use schuler::aiding::states::Process;
use schuler::earth::Geodetic;
use schuler::flight::carried::Carried;
use schuler::math::compensated::Pair;
use schuler::math::real::{Real, Scalar};
use schuler::math::vector::Vector;
use schuler::navigators::Navigator4;
use schuler::sample::Increment;
use schuler::solution::{Euler, Solution};
use schuler::strapdown::block::body::BodyMotion;
use schuler::strapdown::mechanization::Mechanization;

/// One in flight.
pub struct BySchuler<M: Mechanization> {
    told: Told,
    aided: Aided15<M>,
    state: AidedState<M, 15, 120, 0, 32, 16>,
    carried: Carried,
}

/// In double precision.
pub fn start_f64(flight: &Flight) -> Result<BySchuler<Navigator4<f64>>, Failed> {
    start(&flight.told, Navigator4::from_rate_hz(flight.told.rate_hz)?)
}

/// In single precision.
pub fn start_f32(flight: &Flight) -> Result<BySchuler<Navigator4<f32>>, Failed> {
    start(&flight.told, Navigator4::from_rate_hz(flight.told.rate_hz)?)
}

fn start<R, M>(told: &Told, mechanization: M) -> Result<BySchuler<M>, Failed>
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    let of = R::narrow;
    let states = States::new(
        of(told.gyro_noise),
        of(told.accelerometer_noise),
        Process::constant(of(told.gyro_bias)),
        Process::constant(of(told.accelerometer_bias)),
    );
    let start = Start {
        position_m: of(told.position_m),
        velocity_m_s: of(told.velocity_m_s),
        level_rad: of(told.level_rad),
        heading_rad: of(told.heading_rad),
    };
    let mut settings = Settings::new(states, start);
    settings.lever_b = vector(told.lever);
    let interval = Pair::narrow(Pair::new(told.rate_hz).reciprocal());
    let aided = Aided15::new(mechanization, interval, settings)?;
    let [latitude, longitude, altitude, north, east, down, roll, pitch, yaw] = told.initial;
    let [roll, pitch, yaw] = [roll, pitch, yaw].map(f64::to_radians);
    let first = Solution::new(
        place([latitude, longitude, altitude]),
        Vector::new(north, east, down),
        Euler { roll, pitch, yaw },
    );
    let state = aided.start(&Solution::narrow(&first))?;
    Ok(BySchuler { told: *told, aided, state, carried: Carried::default() })
}

impl<R, M> Filter for BySchuler<M>
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    fn sample(&mut self, sample: &Sample, fix: Option<&Fix>) -> Result<(), Failed> {
        if let Some(fix) = fix {
            self.aided.measure(&mut self.state, &Measured::narrow(&measured(fix, &self.told)))?;
        }
        let Sample { angle, velocity } = *sample;
        let sample = Increment { angle_b: wide(angle), velocity_b: wide(velocity) };
        Ok(self.aided.push(&mut self.state, self.carried.narrow(&sample))?)
    }

    fn finish(&mut self) {
        self.aided.finish(&mut self.state, &mut ());
    }

    fn row(&self, time_s: f64) -> Result<Row, Failed> {
        let solution = self.aided.solution(&self.state).widen();
        let Euler { roll, pitch, yaw } = solution.euler();
        let Geodetic { latitude, longitude, altitude } =
            solution.position.map(|pair| pair.hi + pair.lo);
        let [north, east, down] = solution.velocity_ned.map(|pair| pair.hi + pair.lo).into_array();
        let [n, e, d, ..] = self.aided.sigma_ned(&self.state).map(Scalar::widen);
        let [latitude, longitude, roll, pitch, yaw] =
            [latitude, longitude, roll, pitch, yaw].map(f64::to_degrees);
        Ok([time_s, latitude, longitude, altitude, north, east, down, roll, pitch, yaw, n, e, d])
    }
}

fn measured(fix: &Fix, told: &Told) -> Measured<f64> {
    let at = Instant::of_sample(fix.samples as u64);
    let place = place(fix.place).map(Pair::new);
    let [position, velocity] =
        [told.fix_position_m, told.fix_velocity_m_s].map(|sigma| wide([sigma; 3]));
    match fix.velocity {
        Some(ned) => Measured::position_velocity(at, place, position, wide(ned), velocity),
        None => Measured::position(at, place, position),
    }
}

/// Of degrees, degrees and m.
fn place([latitude, longitude, altitude]: [f64; 3]) -> Geodetic<f64> {
    Geodetic { latitude: latitude.to_radians(), longitude: longitude.to_radians(), altitude }
}

fn wide([x, y, z]: [f64; 3]) -> Vector<f64> {
    Vector::new(x, y, z)
}

fn vector<R: Scalar>(numbers: [f64; 3]) -> Vector<R> {
    wide(numbers).map(R::narrow)
}
