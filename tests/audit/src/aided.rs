//! Aided flights: a navigator with its filter, in both precisions, and measurements that come late, twice or never.
//!
//! Nothing is kept but what is on its way, so the flight may be as long as it likes.

use crate::recording::{Reader, Stage};
use crate::scene::{RUN, SEED, Scene, aided};
use crate::truth::Refused;
use schuler::aiding::aided::fault::AidedFault;
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::Measured;
use schuler::aiding::aided::navigator::Aided;
use schuler::digest::{Checkpoint, Digest};
use schuler::flight::carried::Carried;
use schuler::flight::configuration::{Algorithm, Axes, Configuration, Precision};
use schuler::imu::instant;
use schuler::math::compensated::Pair;
use schuler::math::real::{Real, Scalar};
use schuler::navigators::Navigator4;
use schuler::record::Record;
use schuler::sensor::aiding::gnss::Gnss;
use schuler::sensor::aiding::truth::Truth;
use schuler::solution::Solution;
use schuler::strapdown::block::body::BodyMotion;
use schuler::strapdown::block::window::{H0B4A0, Window as _};
use schuler::strapdown::limits::StartError;
use schuler::strapdown::mechanization::Mechanization;
use schuler::trajectory::Trajectory as _;

/// The scene.
pub const SCENE: &Scene = &aided::SCENE;
/// Samples between two rows of the filter.
const FILTER: u64 = 100;
/// Measurements on their way at once, at most.
const UNDER_WAY: usize = 16;

/// Visits every configuration that is flown.
pub fn each(mut visit: impl FnMut(&Configuration)) {
    for precision in [Precision::F64, Precision::F32] {
        let (axes, algorithm, window) = (Axes::LocalLevel, Algorithm::Taylor, H0B4A0::SHAPE);
        visit(&Configuration { precision, axes, algorithm, window });
    }
}

/// Flies one of them.
pub fn fly(configuration: &Configuration, reader: &mut dyn Reader) -> Result<(), Refused> {
    match configuration.precision {
        Precision::F64 => flown(Navigator4::<f64>::new, reader),
        Precision::F32 => flown(Navigator4::<f32>::new, reader),
        Precision::F32x2 => Err(Refused),
    }
}

/// Measurements on their way, in the order in which they set out.
struct UnderWay {
    gnss: Gnss<f64>,
    all: [Option<(f64, Measured<f64>)>; UNDER_WAY],
}

impl UnderWay {
    fn put(&mut self, arrives_s: f64, measured: Measured<f64>) -> Result<(), Refused> {
        // The free places are at the end.
        let free = self.all.iter_mut().find(|place| place.is_none()).ok_or(Refused)?;
        *free = Some((arrives_s, measured));
        Ok(())
    }

    /// The first that has arrived by a time; of the same time the one that set out first.
    fn take(&mut self, until_s: f64) -> Option<Measured<f64>> {
        let arrived = |(_, place): &(usize, &Option<(f64, Measured<f64>)>)| {
            place.is_some_and(|(arrives_s, _)| arrives_s <= until_s)
        };
        let time = |place: &Option<(f64, Measured<f64>)>| place.map_or(f64::INFINITY, |p| p.0);
        let (first, _) = self
            .all
            .iter()
            .enumerate()
            .filter(arrived)
            .min_by(|(_, a), (_, b)| time(a).total_cmp(&time(b)))?;
        self.all.get_mut(first..)?.rotate_left(1);
        self.all.last_mut()?.take().map(|(_, measured)| measured)
    }
}

fn flown<R, M>(
    mechanization: impl FnOnce(Pair<R>) -> Result<M, StartError>,
    reader: &mut dyn Reader,
) -> Result<(), Refused>
where
    R: Scalar + Real<Mask = bool> + Record,
    M: Mechanization<Real = R, Body = BodyMotion<R>, Frame: Record>,
{
    let course = SCENE.course().ok_or(Refused)?;
    let quadrature = SCENE.quadrature(&course);
    let emulator = SCENE.emulator().map_err(|_| Refused)?;
    let mut sensors = emulator.start(SEED, RUN);
    let gnss = aided::gnss().ok_or(Refused)?.checked().map_err(|_| Refused)?;
    let mut receiver = gnss.start(SEED, RUN);
    let mut under_way = UnderWay { gnss, all: [None; UNDER_WAY] };

    let interval_s = Pair::narrow(SCENE.interval_s());
    let mechanization = mechanization(interval_s).map_err(|_| Refused)?;
    type One<M> = Aided<M, 21, 231, 6, 64, 32>;
    let aided: One<M> =
        Aided::new(mechanization, interval_s, aided::settings()).map_err(|_| Refused)?;
    let initial = course.at(0.0).initial();
    let mut state = aided.start(&Solution::narrow(&initial)).map_err(|_| Refused)?;
    let (mut carried, mut digest) = (Carried::default(), Digest::default());
    let [mut nav, mut filter] = ["nav", "filter"].map(Stage::new);

    let rate_hz = f64::from(SCENE.rate_hz);
    for sample in 1..=u64::from(SCENE.samples()) {
        let now_s = sample as f64 / rate_hz;
        while under_way.gnss.line.epoch_s(&receiver.line) <= now_s {
            let time_s = under_way.gnss.line.epoch_s(&receiver.line);
            let at = Instant::from_seconds(time_s, rate_hz).ok_or(Refused)?;
            let end_s = instant(at.samples as f64, rate_hz);
            let truth = Truth::of(&course.solution_at(end_s), course.rates_at(end_s).rate_ib_b);
            if let Some(delivered) = under_way.gnss.measure(&mut receiver, &truth, at) {
                under_way.put(delivered.arrives_s, delivered.measured)?;
                if let Some(again_s) = delivered.again_s {
                    under_way.put(again_s, delivered.measured)?;
                }
            }
        }
        // As the host has it: a millionth of a sample for times that are no whole numbers.
        while let Some(measured) = under_way.take(now_s + 1e-6 / rate_hz) {
            match aided.measure(&mut state, &Measured::narrow(&measured)) {
                Ok(()) | Err(AidedFault::Late | AidedFault::Again | AidedFault::Full) => {}
                Err(_) => return Err(Refused),
            }
        }
        let perfect = quadrature.sample(&course, sample, rate_hz);
        let measured = emulator.emulate(&mut sensors, &perfect);
        let before = state.integrated();
        aided.push(&mut state, carried.narrow(&measured)).map_err(|_| Refused)?;
        if state.integrated() != before {
            nav.row(state.integrated(), M::frame(state.navigator()), reader);
            digest.add(M::frame(state.navigator()));
            if state.integrated() % FILTER == 0 && sample < u64::from(SCENE.samples()) {
                filter.row(state.integrated(), state.filter(), reader);
            }
        }
    }
    aided.finish(&mut state, &mut ());
    digest.add(M::frame(state.navigator()));
    digest.add(state.filter());
    filter.row(state.integrated(), state.filter(), reader);
    nav.end(reader);
    filter.end(reader);
    // What `schuler run` says of the same flight.
    reader.end("run", Checkpoint { sample: state.integrated(), digest: digest.value() });
    Ok(())
}
