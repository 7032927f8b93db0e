//! `schuler allan`: what a sensor at rest is made of, and whether that is what a scene says.

mod csv;
mod page;
mod table;

use crate::cli::AllanArgs;
use schuler::allan::octaves::Point;
use schuler::sensor::Timing;
use schuler_simulator::allan::fit::{Fit, Fitter};
use schuler_simulator::allan::identify::{Identified, identify};
use schuler_simulator::allan::record::{self, Record, SceneError};
use schuler_simulator::allan::section::section;
use schuler_simulator::allan::shape::Shape;
use schuler_simulator::allan::verdict::{Compared, ComparedTime, Verdict, compare, configured};
use schuler_simulator::input::name::name_of;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::{self, OutputFile, say};
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::FlightError;

/// How unlikely the whole may be.
const UNLIKELY: f64 = 1e-3;

/// One axis, measured, identified and compared.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Its points.
    pub points: Vec<Point<f64>>,
    /// The terms that it shows.
    pub identified: Identified,
    /// What it is configured to be: terms with the squares of their magnitudes.
    pub configured: Vec<(Shape, f64)>,
    /// Each of them beside what was found.
    pub compared: Vec<Compared>,
    /// The correlation time.
    pub time: Option<ComparedTime>,
    /// All of them together.
    pub whole: Option<Fit>,
}

impl Axis {
    fn new(
        points: &[Point<f64>],
        timing: Timing<f64>,
        configured: Vec<(Shape, f64)>,
    ) -> Option<Self> {
        let points: Vec<_> = points
            .iter()
            .filter(|point| point.differences > 1 && point.variance > 0.0)
            .copied()
            .collect();
        if points.len() < 3 {
            return None;
        }
        let variances: Vec<f64> = points.iter().map(|point| point.variance).collect();
        let mut fitter = Fitter::new(&points);
        let identified = identify(&mut fitter, &variances, timing);
        let (compared, time, whole) = if configured.is_empty() {
            (Vec::new(), None, None)
        } else {
            let (compared, time, whole) = compare(&mut fitter, &variances, &configured);
            (compared, time, Some(whole))
        };
        Some(Self { points, identified, configured, compared, time, whole })
    }

    /// What is configured at an averaging time, its Allan variance.
    pub fn expected(&self, tau_s: f64) -> f64 {
        self.configured.iter().map(|(shape, square)| square * shape.variance(tau_s)).sum()
    }

    /// The deviation of a point, its 95 % interval, what is fitted and what is configured there.
    pub fn beside(&self, place: usize, point: &Point<f64>) -> [f64; 5] {
        let fit = &self.identified.fit;
        let [lower, upper] = table::bounds(fit.freedom.get(place).copied().unwrap_or(1.0));
        let deviation = point.deviation();
        let fitted = fit.expected.get(place).copied().unwrap_or(0.0).sqrt();
        let configured = self.expected(point.tau_s).sqrt();
        [deviation, deviation * lower, deviation * upper, fitted, configured]
    }

    /// Every verdict.
    pub fn verdicts(&self) -> impl Iterator<Item = Verdict> {
        let whole = self.whole.as_ref().map(whole_verdict);
        let terms = self.compared.iter().map(|compared| compared.verdict);
        terms.chain(self.time.map(|time| time.verdict)).chain(whole)
    }
}

/// Whether all terms together make what was measured.
pub fn whole_verdict(fit: &Fit) -> Verdict {
    if fit.probability() < UNLIKELY { Verdict::Differs } else { Verdict::Agrees }
}

/// Measures, prints, and writes where it is asked to.
pub fn allan(args: &AllanArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    let files = args.files()?;
    let (title, record) = measure(args, scene.as_ref())?;
    let files = files.map(|files| -> Result<_, InputError> {
        let [csv, page, toml] = files.map(OutputFile::create);
        Ok([csv?, page?, toml?])
    });
    let files = files.transpose()?;
    let findings = Findings::new(title, record, scene.as_ref(), args.imu.is_some())?;
    let mut text = findings.text.clone();
    if let (Some([mut csv, mut page, mut toml]), Some(folder)) = (files, &args.out) {
        csv.put(csv::bytes(&findings.axes))?;
        page.put(findings.page())?;
        toml.put(&findings.sections)?;
        output::place(vec![csv, page, toml], &[])?;
        text += &format!("\nwritten to {}\n", folder.display());
    }
    say(&text)?;
    let verdicts: Vec<_> = findings.axes.iter().flatten().flat_map(Axis::verdicts).collect();
    match verdicts.iter().filter(|verdict| **verdict == Verdict::Differs).count() {
        0 => Ok(()),
        failed => Err(FlightError::Failed { failed, checks: verdicts.len() }),
    }
}

/// All that is found out.
#[derive(Clone, Debug)]
pub struct Findings {
    /// What was measured, by its name.
    pub title: String,
    /// Gyros x, y, z, then accelerometers; none of an axis that shows nothing.
    pub axes: [Option<Axis>; 6],
    /// The sections of a scene that stand for it.
    pub sections: String,
    /// What is said of it.
    pub text: String,
}

impl Findings {
    /// Of a record, and of the scene that it is compared with; whether it is a recording or the scene's own.
    pub fn new(
        title: String,
        record: Record,
        scene: Option<&Scene>,
        is_recorded: bool,
    ) -> Result<Self, FlightError> {
        let axes: [Option<Axis>; 6] = std::array::from_fn(|i| {
            let errors = scene.map(|s| if i < 3 { &s.gyro } else { &s.accelerometer });
            let terms = errors.map(|errors| configured(errors, i % 3, record.timing));
            // A perfect sensor leaves rounding alone.
            let perfect = !is_recorded && terms.as_ref().is_some_and(Vec::is_empty);
            if perfect {
                None
            } else {
                Axis::new(&record.axes[i], record.timing, terms.unwrap_or_default())
            }
        });
        if axes.iter().all(Option::is_none) {
            let complaint = Complaint::new(
                "no sensor has an error that an Allan deviation shows",
                "random walk, flicker, Gauss-Markov or quantization in [gyro] or [accelerometer]",
            );
            return Err(InputError::option(&title, complaint).into());
        }
        let sections = sections(&title, &axes);
        let mut text = table::text(&title, &record, &axes);
        text += &format!("\n{sections}");
        Ok(Self { title, axes, sections, text })
    }

    /// The page.
    pub fn page(&self) -> String {
        page::page(&self.title, &self.text, &self.axes)
    }
}

/// What is measured, and what it is called.
fn measure(args: &AllanArgs, scene: Option<&Scene>) -> Result<(String, Record), FlightError> {
    if let Some(imu) = &args.imu {
        let name = name_of(imu);
        let recording = Recording::open_in(&name, args.units.unwrap_or_default())?;
        let span = args.span.map(|span| span.0);
        return Ok((name, record::of_recording(&recording, args.flight.rate, span)?));
    }
    let Some(scene) = scene else {
        let complaint = Complaint::new("is missing", "a scene, or --imu FILE");
        return Err(InputError::option("SCENE", complaint).into());
    };
    let record = record::of_scene(scene).map_err(|error| match error {
        SceneError::Source(error) => FlightError::from(error),
        SceneError::Complaint(complaint) => InputError::option(&scene.name, complaint).into(),
    })?;
    Ok((scene.name.clone(), record))
}

/// Both sections, ready to paste.
fn sections(title: &str, axes: &[Option<Axis>; 6]) -> String {
    let [gx, gy, gz, ax, ay, az] = axes;
    let terms = |axis: &Option<Axis>| -> Vec<_> {
        axis.as_ref().map_or(Vec::new(), |axis| axis.identified.fit.terms.clone())
    };
    let mut text = format!("# What {title} shows: a section of a scene\n");
    for (triad, three) in [[gx, gy, gz], [ax, ay, az]].into_iter().enumerate() {
        if three.iter().all(|axis| axis.is_none()) {
            continue;
        }
        let [x, y, z] = three.map(terms);
        text += &section(triad, [&x, &y, &z]);
    }
    text
}
