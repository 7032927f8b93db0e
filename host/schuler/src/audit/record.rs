//! Recording: a scene's stages, and every navigator's, into chains.

use super::chain::{Chain, Checkpoint, Row, Stage, Width};
use super::configuration::Named as _;
use schuler::digest;
use schuler::flight::configuration::Configuration;
use schuler::link::gap::Bridge;
use schuler::math::compensated::Pair;
use schuler::solution::Solution;
use schuler_simulator::navigator::stepping::{self, Words, words};
use schuler_simulator::scene::{Scene, Vertical};
use schuler_simulator::simulate::{FlightError, Refused, offset};
use schuler_simulator::source::Source;

/// How much of a flight is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cadence {
    /// Samples from checkpoint to checkpoint.
    pub checkpoint: u64,
    /// Samples up to which every row is kept; later only those at checkpoints.
    pub rows: u64,
}

/// A chain with the name of its file, less the ending.
pub type Named = (String, Chain);

/// The stages that every navigator of a scene shares, one chain for each.
pub const SHARED: [&str; 3] = ["trajectory", "increments", "noise"];

/// Flies a scene once for all the navigators: its shared stages, and the body and nav steps of each.
pub fn record(
    scene: &Scene,
    configurations: &[Configuration],
    cadence: Cadence,
    provenance: &str,
) -> Result<Vec<Named>, FlightError> {
    let source = Source::new(scene, false)?;
    let initial = offset(&source.initial(0), scene);
    let interval_s = Pair::new(scene.rate_hz).reciprocal();
    let about = about(scene, cadence, provenance);
    let mut shared = SHARED.map(|stage| Recording::new(&[stage], Width::Double, cadence));
    let mut flights = Vec::new();
    for configuration in configurations {
        let steps = stepping::start(configuration, interval_s, &initial)?;
        let recording = Recording::new(&["body", "nav"], configuration.width(), cadence);
        flights.push((configuration, steps, recording));
    }
    let hold = scene.navigator.vertical == Vertical::Held;
    let [trajectory, increments, noise] = &mut shared;
    let mut stream = source.start(0);
    let mut bridge = Bridge::new(scene.navigator.gap.into());
    let mut fly = |increment: &_| -> Result<(), Refused> {
        for (_, steps, recording) in &mut flights {
            let mut last = None;
            steps.push(increment, &mut |n, body, nav| {
                recording.row(0, n, body);
                recording.row(1, n, nav);
                last = Some(n);
            })?;
            if let Some(truth) = last.filter(|_| hold).map(|n| source.truth(n)) {
                steps.hold_vertical(truth.position.altitude.hi, truth.velocity_ned.z.hi)?;
            }
        }
        Ok(())
    };
    for sample in 1..=scene.samples() {
        let (perfect, measured) = stream.advance_seen();
        trajectory.row(0, sample, &words(&source.motion(sample)));
        increments.row(0, sample, &words(&perfect));
        if let Some(measured) = &measured {
            noise.row(0, sample, &words(measured));
        }
        bridge
            .take(measured, &mut fly)
            .map_err(|refused| refused.at(sample, &source, scene.navigator.gap))?;
    }
    bridge
        .finish(&mut fly)
        .map_err(|refused| refused.at(scene.samples(), &source, scene.navigator.gap))?;

    let mut chains: Vec<Named> = SHARED
        .iter()
        .zip(shared)
        .map(|(stage, recording)| (stage.to_string(), recording.chain(about.clone())))
        .collect();
    for (configuration, mut steps, mut recording) in flights {
        steps.finish(&mut |n, body, nav| {
            recording.row(0, n, body);
            recording.row(1, n, nav);
        });
        let mut about = about.clone();
        about.insert(4, ("configuration".to_owned(), configuration.title()));
        about.insert(5, ("initial".to_owned(), start(&initial)));
        chains.push((configuration.stem(), recording.chain(about)));
    }
    Ok(chains)
}

fn about(scene: &Scene, cadence: Cadence, provenance: &str) -> Vec<(String, String)> {
    [
        ("scene", scene.name.clone()),
        ("duration_s", scene.duration_s.to_string()),
        ("rate_hz", scene.rate_hz.to_string()),
        ("seed", scene.seed.to_string()),
        ("checkpoint", cadence.checkpoint.to_string()),
        ("rows", cadence.rows.to_string()),
        ("provenance", provenance.to_owned()),
    ]
    .map(|(key, value)| (key.to_owned(), value))
    .into()
}

/// The state to start from, as words of f64, hi and lo: latitude, longitude, altitude, velocity north,
/// east, down, attitude w, x, y, z.
fn start(initial: &Solution<f64>) -> String {
    let Solution { position: p, velocity_ned: v, attitude: q } = initial;
    let numbers = [p.latitude, p.longitude, p.altitude, v.x, v.y, v.z, q.w, q.v.x, q.v.y, q.v.z];
    let words = numbers.iter().flat_map(|n| [n.hi, n.lo]);
    let words: Vec<_> = words.map(|word| format!("{:016x}", word.to_bits())).collect();
    words.join(" ")
}

/// Stages while they are recorded.
struct Recording {
    stages: Vec<(Stage, digest::Chain)>,
    rows: u64,
}

impl Recording {
    fn new(names: &[&str], width: Width, cadence: Cadence) -> Self {
        let stage = |name: &&str| (Stage::new(name, width), digest::Chain::new(cadence.checkpoint));
        Self { stages: names.iter().map(stage).collect(), rows: cadence.rows }
    }

    fn row(&mut self, stage: usize, sample: u64, words: &Words) {
        let (stage, digest) = &mut self.stages[stage];
        if stage.fields.is_empty() {
            stage.fields = words.iter().map(|(name, _)| name.to_string()).collect();
        }
        let words: Vec<u64> = words.iter().map(|&(_, bits)| bits).collect();
        let checkpoint = digest.add_words(sample, words.iter().copied());
        stage.end = Some(Checkpoint { sample, digest: digest.value() });
        if sample <= self.rows || checkpoint.is_some() {
            stage.rows.push(Row { sample, words });
        }
        if let Some(digest::Checkpoint { sample, digest }) = checkpoint {
            stage.checkpoints.push(Checkpoint { sample, digest });
        }
    }

    fn chain(self, about: Vec<(String, String)>) -> Chain {
        Chain { about, stages: self.stages.into_iter().map(|(stage, _)| stage).collect() }
    }
}
