//! The spans of a recording for alignment and for navigation.

use crate::cli::ReplayArgs;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::recording::navigation::NavigationRow;
use schuler_simulator::recording::samples::Sample;
use schuler_simulator::recording::survey::Survey;

/// Where a sample lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Before anything is done with it.
    Before,
    /// It is aligned on.
    Still,
    /// It is flown.
    Flown,
    /// Beyond the end.
    After,
}

/// What a command calls its options about times.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Where to begin.
    start: &'static str,
    /// How long to align.
    align: &'static str,
    /// What is done where an alignment ends.
    then: &'static str,
}

impl Options {
    /// Those of `replay`.
    pub const REPLAY: Self =
        Self { start: "--start", align: "--align", then: "navigation would start" };
    /// Those of `align`.
    pub const ALIGN: Self = Self { start: "--from", align: "--for", then: "alignment would end" };
}

/// Times of the recording, s.
#[derive(Clone, Debug)]
pub struct Spans {
    /// Where alignment begins, or the flight if there is none.
    pub begin_s: f64,
    /// Where the flight begins.
    pub navigate_s: f64,
    /// Where it ends.
    pub until_s: f64,
    /// How far a sample's end may be from where it belongs.
    slack_s: f64,
    /// The option that says where to begin.
    begins: &'static str,
    /// For people.
    inside: String,
}

/// About which times are flown, before the recording's own start is known: the option's or the initial
/// state's time, and the end.
pub fn about(args: &ReplayArgs, initial: &NavigationRow) -> (f64, f64) {
    let own_s = args.initial.as_ref().map_or(f64::NEG_INFINITY, |_| initial.time_s);
    let from_s = args.start.unwrap_or(own_s) + args.align.unwrap_or(0.0);
    (from_s, args.until.unwrap_or(f64::INFINITY))
}

impl Spans {
    /// By the options of `replay`, or an error that names the one to blame.
    pub fn new(
        args: &ReplayArgs,
        survey: &Survey,
        initial: &NavigationRow,
    ) -> Result<Self, InputError> {
        Self::named(args, survey, initial, &Options::REPLAY)
    }

    /// The same, the options called otherwise.
    pub fn named(
        args: &ReplayArgs,
        survey: &Survey,
        initial: &NavigationRow,
        options: &Options,
    ) -> Result<Self, InputError> {
        let (first_s, last_s) = (survey.start_s, survey.end_s);
        let own_s = if args.initial.is_some() { initial.time_s } else { first_s };
        let begin_s = args.start.unwrap_or(own_s);
        let navigate_s = begin_s + args.align.unwrap_or(0.0);
        let until_s = args.until.unwrap_or(f64::INFINITY);
        // A sample belongs to where its interval lies, up to the rounding of its time.
        let slack_s = 0.25 * survey.clock.interval_s();
        // A first interval that no stamp bounds may be somewhat longer than most.
        let lies_inside =
            |time_s: f64| time_s >= first_s - 2.0 * slack_s && time_s <= last_s - slack_s;
        let inside = format!("times within the recording, {first_s} to {last_s} s");
        // The recording's own start is always right.
        let begins = match (args.start, &args.initial) {
            (Some(_), _) => options.start,
            (None, Some(_)) => "--initial",
            (None, None) => options.align,
        };
        if !lies_inside(begin_s) || !lies_inside(navigate_s) {
            let (option, what) = if lies_inside(begin_s) {
                (options.align, format!("{} at {navigate_s} s", options.then))
            } else if args.align.is_some() {
                (begins, format!("alignment would begin at {begin_s} s"))
            } else {
                (begins, format!("{} at {navigate_s} s", options.then))
            };
            return Err(InputError::option(option, Complaint::new(what, inside)));
        }
        if args.align.is_none() && (begin_s - own_s).abs() > slack_s {
            let what = format!("the initial state is that of {own_s} s, not of {begin_s} s");
            let accepted = "the time of the initial state, or --align";
            return Err(InputError::option(begins, Complaint::new(what, accepted)));
        }
        let spans = Self { begin_s, navigate_s, until_s, slack_s, begins, inside };
        if until_s - navigate_s < slack_s { Err(spans.empty()) } else { Ok(spans) }
    }

    /// From a time where what aids the flight begins it, s.
    pub fn from_fix(args: &ReplayArgs, survey: &Survey, begin_s: f64) -> Result<Self, InputError> {
        let (first_s, last_s) = (survey.start_s, survey.end_s);
        let spans = Self {
            begin_s,
            navigate_s: begin_s,
            until_s: args.until.unwrap_or(f64::INFINITY),
            slack_s: 0.25 * survey.clock.interval_s(),
            begins: "--gnss",
            inside: format!("times within the recording, {first_s} to {last_s} s"),
        };
        if spans.until_s - begin_s < spans.slack_s { Err(spans.empty()) } else { Ok(spans) }
    }

    /// Where a sample with this end lies.
    pub fn place(&self, end_s: f64) -> Place {
        match end_s - self.slack_s {
            time_s if time_s <= self.begin_s => Place::Before,
            time_s if time_s <= self.navigate_s => Place::Still,
            time_s if time_s <= self.until_s => Place::Flown,
            _ => Place::After,
        }
    }

    /// Whether a sample begins at a time, as near as can be asked.
    pub fn begins_at(&self, sample: &Sample, time_s: f64) -> bool {
        (sample.end_s - sample.interval_s - time_s).abs() <= 2.0 * self.slack_s
    }

    /// Refuses a first sample of the flight that does not begin where the flight does; `begun` says whether
    /// the first sample to be aligned on begins right.
    pub fn check_first(&self, sample: &Sample, begun: bool) -> Result<(), InputError> {
        if self.begins_at(sample, self.navigate_s) {
            return Ok(());
        }
        let what = format!("no sample starts at {} s", self.navigate_s);
        let near = format!("a sample's boundary, {} s", sample.end_s - sample.interval_s);
        let option = if begun { "--align" } else { self.begins };
        Err(InputError::option(option, Complaint::new(what, near)))
    }

    /// There is nothing to fly.
    pub fn empty(&self) -> InputError {
        let what = format!("there is no sample between it and {} s", self.navigate_s);
        InputError::option("--until", Complaint::new(what, self.inside.as_str()))
    }
}
