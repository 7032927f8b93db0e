//! A vehicle that moves, whose velocity is measured: its attitude by the curves of its velocity first, then by a filter.

use super::aligner::Aligns;
use schuler::aiding::alignment::aligned::Aligned;
use schuler::aiding::alignment::fine::{Fine, FineState};
use schuler::aiding::alignment::settings::Settings;
use schuler::aiding::alignment::verdict::AlignmentFault;
use schuler::alignment::inertial::Inertial;
use schuler::alignment::place::Place;
use schuler::earth::{Geodetic, Radii};
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::navigators::Navigator4;
use schuler::sample::Increment;
use schuler::solution::{Euler, Solution};
use schuler::units::DEGREE;

/// A heading by velocities that is good to this is good enough to start a filter, rad.
const STARTS: f64 = 2.0 * DEGREE;
/// What a filter takes it to be good to, of its standard deviation: the level that is found with it is not perfect.
const MARGIN: f64 = 3.0;
/// Velocities until then, at least.
const FEWEST: u32 = 10;

type Filter = Fine<Navigator4<f64>, 15, 120, 0>;
type FilterState = FineState<Navigator4<f64>, 15, 120, 0>;

/// A vehicle that moves.
pub(super) struct UnderWay {
    navigator: Navigator4<f64>,
    interval: Pair<f64>,
    settings: Settings<f64>,
    /// Where it is by its velocities.
    place: Geodetic<f64>,
    velocity: Vector<f64>,
    /// Seconds since that velocity.
    since_s: f64,
    inertial: Inertial<f64>,
    velocities: u32,
    fine: Option<(Filter, FilterState)>,
}

impl UnderWay {
    /// From a place and a velocity in north, east and down, m/s.
    pub fn new(
        navigator: Navigator4<f64>,
        interval: Pair<f64>,
        place: Geodetic<f64>,
        settings: Settings<f64>,
        velocity: Vector<f64>,
    ) -> Self {
        let inertial = Inertial::moving(&Place::new(place), velocity);
        let (since_s, velocities, fine) = (0.0, 0, None);
        Self { navigator, interval, settings, place, velocity, since_s, inertial, velocities, fine }
    }

    /// On to a velocity, half the way at each.
    fn go_on(&mut self, velocity: Vector<f64>) {
        let way = (self.velocity + velocity) * (0.5 * self.since_s);
        let (sine, cosine) = self.place.latitude.sin_cos();
        let radii = Radii::at(sine, cosine);
        self.place.latitude += way.x / (radii.meridian + self.place.altitude);
        self.place.longitude += way.y / ((radii.prime_vertical + self.place.altitude) * cosine);
        self.place.altitude -= way.z;
        (self.velocity, self.since_s) = (velocity, 0.0);
    }

    /// Starts the filter if the attitude is good enough.
    fn try_to_start(&mut self, sigma_m_s: f64) -> Result<(), AlignmentFault> {
        let heading = MARGIN * sigma_m_s / self.inertial.velocity_spread();
        let enough = self.velocities >= FEWEST && heading < STARTS;
        let Some(attitude) = self.inertial.attitude().ok().filter(|_| enough) else {
            return Ok(());
        };
        let settings = Settings { heading_rad: heading, ..self.settings };
        let fine = Fine::new(self.navigator, self.interval, &self.place, settings)?;
        let state = fine.start_moving(attitude, self.velocity)?;
        self.fine = Some((fine, state));
        Ok(())
    }
}

impl Aligns for UnderWay {
    fn push(&mut self, sample: &Increment<f64>) -> Result<(), AlignmentFault> {
        match &mut self.fine {
            Some((fine, state)) => fine.push(state, *sample),
            None => {
                self.since_s += self.interval.hi;
                self.inertial.add(sample, self.interval.hi);
                Ok(())
            }
        }
    }

    fn measure_velocity(
        &mut self,
        ned: Vector<f64>,
        sigma_m_s: f64,
    ) -> Result<bool, AlignmentFault> {
        if let Some((fine, state)) = &mut self.fine {
            return fine.measure_velocity(state, ned, sigma_m_s);
        }
        self.go_on(ned);
        self.inertial.measure_velocity(ned);
        self.velocities += 1;
        self.try_to_start(sigma_m_s)?;
        Ok(true)
    }

    fn aligned(&self) -> Option<Aligned<f64>> {
        self.fine.as_ref().map(|(fine, state)| fine.aligned(state))
    }

    fn covariance(&self) -> [[f64; 3]; 3] {
        let none = [[f64::NAN; 3]; 3];
        self.fine.as_ref().map_or(none, |(fine, state)| fine.attitude_covariance(state))
    }

    fn solution(&self) -> Solution<f64> {
        match &self.fine {
            Some((fine, state)) => fine.solution(state),
            None => Solution::new(self.place, self.velocity, Euler::default()),
        }
    }
}
