//! `--units`: the units of a recording, if they are not rad/s, m/s² and s.

use crate::input::Complaint;
use schuler::alignment::units::{ForceUnit, Kind, RateUnit};
use schuler::sample::Increment;

/// How times are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeUnit {
    /// A number of s.
    Seconds,
    /// A number of ms.
    Milliseconds,
    /// A number of µs.
    Microseconds,
    /// A number of ns.
    Nanoseconds,
    /// A date and a time.
    Iso8601,
    /// A GPS week and the seconds in it.
    GpsWeek,
}

impl TimeUnit {
    /// Its name in the plural, and how many seconds its number counts.
    pub fn counted(self) -> (&'static str, f64) {
        match self {
            Self::Milliseconds => ("milliseconds", 1e-3),
            Self::Microseconds => ("microseconds", 1e-6),
            Self::Nanoseconds => ("nanoseconds", 1e-9),
            Self::Seconds | Self::Iso8601 | Self::GpsWeek => ("seconds", 1.0),
        }
    }
}

/// What a word of `--units` says.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Word {
    Force(ForceUnit),
    Rate(RateUnit),
    Time(TimeUnit),
    Kind(Kind),
}

/// The words, those that are listed first of each meaning; increments have a unit times a second.
const WORDS: [(&str, Word); 54] = {
    use ForceUnit::{
        CentimetrePerSecondSquared as Gal, FootPerSecondSquared as Foot, G, MetrePerSecondSquared,
        MicroG, MilliG,
    };
    use RateUnit::{
        DegreePerHour, DegreePerMinute, DegreePerSecond, MicroradianPerSecond,
        MilliradianPerSecond, RadianPerSecond, TurnPerMinute, TurnPerSecond,
    };
    use TimeUnit::{GpsWeek, Iso8601, Microseconds, Milliseconds, Nanoseconds, Seconds};
    use Word::{Force, Rate, Time};
    [
        ("m/s2", Force(MetrePerSecondSquared)),
        ("g", Force(G)),
        ("mg", Force(MilliG)),
        ("ug", Force(MicroG)),
        ("ft/s2", Force(Foot)),
        ("cm/s2", Force(Gal)),
        ("rad/s", Rate(RadianPerSecond)),
        ("mrad/s", Rate(MilliradianPerSecond)),
        ("urad/s", Rate(MicroradianPerSecond)),
        ("deg/s", Rate(DegreePerSecond)),
        ("deg/min", Rate(DegreePerMinute)),
        ("deg/h", Rate(DegreePerHour)),
        ("arcsec/s", Rate(DegreePerHour)),
        ("rev/s", Rate(TurnPerSecond)),
        ("rpm", Rate(TurnPerMinute)),
        ("rad", Rate(RadianPerSecond)),
        ("mrad", Rate(MilliradianPerSecond)),
        ("urad", Rate(MicroradianPerSecond)),
        ("deg", Rate(DegreePerSecond)),
        ("arcmin", Rate(DegreePerMinute)),
        ("arcsec", Rate(DegreePerHour)),
        ("rev", Rate(TurnPerSecond)),
        ("m/s", Force(MetrePerSecondSquared)),
        ("g*s", Force(G)),
        ("mg*s", Force(MilliG)),
        ("ug*s", Force(MicroG)),
        ("ft/s", Force(Foot)),
        ("cm/s", Force(Gal)),
        ("increments", Word::Kind(Kind::Increments)),
        ("rates", Word::Kind(Kind::Rates)),
        ("s", Time(Seconds)),
        ("ms", Time(Milliseconds)),
        ("us", Time(Microseconds)),
        ("ns", Time(Nanoseconds)),
        ("iso8601", Time(Iso8601)),
        ("gps-week", Time(GpsWeek)),
        ("µs", Time(Microseconds)),
        ("m/s²", Force(MetrePerSecondSquared)),
        ("m/s^2", Force(MetrePerSecondSquared)),
        ("µg", Force(MicroG)),
        ("µg*s", Force(MicroG)),
        ("ft/s²", Force(Foot)),
        ("ft/s^2", Force(Foot)),
        ("cm/s²", Force(Gal)),
        ("cm/s^2", Force(Gal)),
        ("gal", Force(Gal)),
        ("µrad/s", Rate(MicroradianPerSecond)),
        ("µrad", Rate(MicroradianPerSecond)),
        ("°/s", Rate(DegreePerSecond)),
        ("dps", Rate(DegreePerSecond)),
        ("°/min", Rate(DegreePerMinute)),
        ("arcmin/s", Rate(DegreePerMinute)),
        ("°/h", Rate(DegreePerHour)),
        ("rev/min", Rate(TurnPerMinute)),
    ]
};
/// How many of them are listed where one is asked for.
const LISTED: usize = 36;

/// What the numbers of a recording are in.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Units {
    /// Of accelerometers.
    pub force: Option<ForceUnit>,
    /// Of gyros.
    pub rate: Option<RateUnit>,
    /// Of time stamps.
    pub time: Option<TimeUnit>,
    /// What the samples are, whatever the header says.
    pub kind: Option<Kind>,
}

impl Units {
    /// From words with commas between, at most one for each sensor and one for the kind of samples.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let mut units = Self::default();
        for word in text.split(',').map(str::trim) {
            let found = WORDS.iter().find(|(name, _)| name.eq_ignore_ascii_case(word));
            let twice = match found.map(|(_, meaning)| *meaning) {
                Some(Word::Force(unit)) => units.force.replace(unit).is_some(),
                Some(Word::Rate(unit)) => units.rate.replace(unit).is_some(),
                Some(Word::Time(unit)) => units.time.replace(unit).is_some(),
                Some(Word::Kind(kind)) => units.kind.replace(kind).is_some(),
                None => {
                    let what = format!("\"{word}\" is no unit");
                    return Err(Complaint::new(what, Self::accepted()));
                }
            };
            if twice {
                let what = format!("\"{word}\" contradicts a word before it");
                return Err(Complaint::new(what, Self::accepted()));
            }
        }
        Ok(units)
    }

    /// These where they are stated, else others.
    pub fn or(self, other: Self) -> Self {
        Self {
            force: self.force.or(other.force),
            rate: self.rate.or(other.rate),
            time: self.time.or(other.time),
            kind: self.kind.or(other.kind),
        }
    }

    /// What [`Units::parse`] takes, for people.
    pub fn accepted() -> String {
        let list = |want: fn(&Word) -> bool| {
            let listed = WORDS.iter().take(LISTED).filter(|(_, word)| want(word));
            listed.map(|(name, _)| *name).collect::<Vec<_>>().join(" ")
        };
        format!(
            "one of {}, one of {}, one of {}, one of {}, with commas between",
            list(|word| matches!(word, Word::Force(_))),
            list(|word| matches!(word, Word::Rate(_))),
            list(|word| matches!(word, Word::Time(_))),
            list(|word| matches!(word, Word::Kind(_))),
        )
    }

    /// A sample in rad and m/s, or rad/s and m/s².
    pub fn apply(&self, sample: &Increment<f64>) -> Increment<f64> {
        Increment {
            angle_b: sample.angle_b * self.rate.map_or(1.0, RateUnit::si),
            velocity_b: sample.velocity_b * self.force.map_or(1.0, ForceUnit::si),
        }
    }
}

/// The kind of samples that a unit's word is one of, such as increments for `rad`.
pub fn kind_of(word: &str) -> Kind {
    let per_second = ["/s", "/h", "/min", "dps", "rpm", "s2", "s²", "s^2"];
    let increment = matches!(word, "m/s" | "ft/s" | "cm/s") || word.ends_with("*s");
    let force = matches!(word, "g" | "mg" | "ug" | "µg" | "gal");
    if !increment && (force || per_second.iter().any(|end| word.ends_with(end))) {
        Kind::Rates
    } else {
        Kind::Increments
    }
}

/// What `--units` calls a unit of specific force.
pub fn force_name(unit: ForceUnit) -> &'static str {
    let of = |word: &Word| *word == Word::Force(unit);
    WORDS.iter().find(|(_, word)| of(word)).map_or("m/s2", |(name, _)| name)
}

/// What `--units` calls a unit of angular rate.
pub fn rate_name(unit: RateUnit) -> &'static str {
    let of = |word: &Word| *word == Word::Rate(unit);
    WORDS.iter().find(|(_, word)| of(word)).map_or("rad/s", |(name, _)| name)
}
