//! How a target and its twin went along with each other: the verdict, how long answers took, and faults over time.

use super::figures;
use schuler_report::canvas::Ink;
use schuler_report::interactive::{Interactive, Scale};
use schuler_report::layer::{Kind, Layer};
use schuler_report::page;
use schuler_report::svg::escape;
use serde::Serialize;

/// Spans of a flight in which faults are counted.
const SPANS: usize = 60;
/// Bars of a histogram, at most.
const BARS: f64 = 40.0;

/// The part of a summary that has a target.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Lockstep {
    /// Whether every bit was the same, as far as the flight went.
    equal: bool,
    /// Why not.
    #[serde(skip_serializing_if = "Option::is_none")]
    parted: Option<String>,
    /// What ended an equal flight early; a summary has that by itself.
    #[serde(skip)]
    ended: Option<String>,
    /// The digest of both, where they are equal.
    #[serde(skip)]
    digest: String,
    /// How long answers took, where samples were sent in real time.
    #[serde(skip_serializing_if = "Option::is_none")]
    latency: Option<Latency>,
    /// What happened on the link, in spans of equal length.
    link_over_time: Vec<Span>,
}

/// How long answers took.
#[derive(Clone, Debug, Serialize)]
pub struct Latency {
    answers: u64,
    median_ms: f64,
    percentile_99_ms: f64,
    longest_ms: f64,
    /// Answers that took longer than a sample.
    late: u64,
    histogram: Vec<Bar>,
}

#[derive(Clone, Copy, Debug, Serialize)]
struct Bar {
    from_ms: f64,
    to_ms: f64,
    answers: u64,
}

#[derive(Clone, Copy, Debug, Default, Serialize)]
struct Span {
    from_s: f64,
    to_s: f64,
    faults: u64,
    sent_again: u64,
}

/// What was counted during one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Its end, s.
    pub time_s: f64,
    /// Faults that were put in.
    pub faults: u64,
    /// Requests that were sent again.
    pub sent_again: u64,
}

/// Median, 99th percentile, longest of some times, and how many are longer than a sample.
pub fn latency(times_s: &[f64], rate_hz: f64) -> Option<Latency> {
    let mut sorted: Vec<f64> = times_s.iter().map(|time_s| 1e3 * time_s).collect();
    sorted.sort_by(f64::total_cmp);
    let (&least, &most) = (sorted.first()?, sorted.last()?);
    let at = |part: f64| {
        let index = ((sorted.len() as f64 * part) as usize).min(sorted.len() - 1);
        sorted[index]
    };
    // 2∛n bars (Rice's rule).
    let bars = (2.0 * (sorted.len() as f64).cbrt()).clamp(1.0, BARS).round();
    let width = ((most - least) / bars).max(f64::MIN_POSITIVE);
    let mut histogram: Vec<Bar> = (0..bars as u64)
        .map(|i| {
            let from_ms = least + i as f64 * width;
            Bar { from_ms, to_ms: from_ms + width, answers: 0 }
        })
        .collect();
    let last = histogram.len() - 1;
    for time_ms in &sorted {
        histogram[(((time_ms - least) / width) as usize).min(last)].answers += 1;
    }
    Some(Latency {
        answers: sorted.len() as u64,
        median_ms: at(0.5),
        percentile_99_ms: at(0.99),
        longest_ms: most,
        late: sorted.iter().filter(|&&time_ms| time_ms * rate_hz > 1e3).count() as u64,
        histogram,
    })
}

impl Latency {
    /// In a line.
    pub fn text(&self) -> String {
        let Self { answers, median_ms, percentile_99_ms, longest_ms, late, .. } = self;
        format!(
            "latency: median {median_ms:.3} ms, 99 % within {percentile_99_ms:.3} ms, longest {longest_ms:.3} ms;\n\
             {late} of {answers} answers took longer than a sample\n"
        )
    }
}

impl Lockstep {
    /// Of a flight so long, s: why target and twin part, if they do, and what else ended it early.
    pub fn new(
        [parted, ended]: [Option<String>; 2],
        digest: &str,
        latency: Option<Latency>,
        events: &[Event],
        end_s: f64,
    ) -> Self {
        let length_s = end_s / SPANS as f64;
        let mut spans: Vec<Span> = (0..SPANS)
            .map(|i| {
                let from_s = i as f64 * length_s;
                Span { from_s, to_s: from_s + length_s, ..Span::default() }
            })
            .collect();
        for event in events {
            let span = ((event.time_s / length_s) as usize).min(SPANS - 1);
            spans[span].faults += event.faults;
            spans[span].sent_again += event.sent_again;
        }
        let link_over_time = if events.is_empty() { Vec::new() } else { spans };
        let (equal, digest) = (parted.is_none(), digest.to_owned());
        Self { equal, parted, ended, digest, latency, link_over_time }
    }

    /// How long answers took.
    pub fn latency(&self) -> Option<&Latency> {
        self.latency.as_ref()
    }

    /// In a line, above everything else.
    pub fn verdict(&self) -> String {
        match (&self.parted, &self.ended) {
            (None, Some(why)) => {
                let text =
                    format!("The flight ended early, target and twin equal until then: {why}");
                page::verdict(false, &text)
            }
            (None, None) => {
                let text =
                    format!("Target and twin are equal in every bit: digest {}", self.digest);
                page::verdict(true, &text)
            }
            (Some(why), _) => page::verdict(false, &format!("Target and twin part: {why}")),
        }
    }

    /// The histogram, and what happened over time.
    pub fn charts(&self) -> String {
        let latency = self.latency.iter().map(|latency| {
            let points = latency
                .histogram
                .iter()
                .flat_map(|bar| [bar.from_ms, bar.to_ms].map(|ms| [ms, bar.answers as f64, 0.0]));
            let layer = Layer::new("answers", Ink::North, Kind::Band(0.6), points.collect());
            let count = Scale::new("", "").from_zero();
            Interactive::new("Time to an answer: how many", Scale::new("time", "ms"), count)
                .with(layer)
        });
        let end_s = self.link_over_time.last().map_or(0.0, |span| span.to_s);
        let (scale, per_second) = figures::time(end_s);
        let over_time = (!self.link_over_time.is_empty()).then(|| {
            let steps = |count: fn(&Span) -> u64| {
                let spans = self.link_over_time.iter();
                let points = spans.flat_map(move |span| {
                    [span.from_s, span.to_s].map(|t| [t * per_second, count(span) as f64])
                });
                points.collect::<Vec<_>>()
            };
            let faults = steps(|span| span.faults).into_iter().map(|[t, n]| [t, n, 0.0]);
            let faults = Layer::new("faults put in", Ink::East, Kind::Band(0.6), faults.collect());
            let again = Layer::line("sent again", Ink::North, steps(|span| span.sent_again));
            Interactive::new("On the link over time", scale, Scale::new("", "").from_zero())
                .with(faults)
                .with(again)
        });
        let words = self
            .latency
            .as_ref()
            .map_or(String::new(), |latency| format!("<p>{}</p>\n", escape(&latency.text())));
        words + &figures::grid(latency.chain(over_time))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_of_a_ramp() {
        let times_s: Vec<f64> = (1..=1000).rev().map(|k| f64::from(k) * 1e-6).collect();
        let found = latency(&times_s, 2000.0).unwrap();
        assert!((found.median_ms - 0.501).abs() < 1e-9 && (found.longest_ms - 1.0).abs() < 1e-9);
        let text = "median 0.501 ms, 99 % within 0.991 ms, longest 1.000 ms;\n500 of 1000 answers";
        assert!(found.text().contains(text), "{}", found.text());
        assert!((found.percentile_99_ms - 0.991).abs() < 1e-9);
        assert_eq!((found.late, found.answers, found.histogram.len()), (500, 1000, 20));
        assert_eq!(found.histogram.iter().map(|bar| bar.answers).sum::<u64>(), 1000);
        assert!(found.histogram.iter().all(|bar| (45..=55).contains(&bar.answers)));
        assert!(latency(&[], 1.0).is_none());
        assert_eq!(latency(&[0.5], 1.0).unwrap().histogram.len(), 2);
    }

    #[test]
    fn events_fall_into_their_spans() {
        let event = |time_s, faults, sent_again| Event { time_s, faults, sent_again };
        let events = [event(0.5, 1, 0), event(59.9, 2, 1), event(60.0, 4, 4)];
        let lockstep = Lockstep::new([None, None], "0f", None, &events, 60.0);
        let counts: Vec<u64> = lockstep.link_over_time.iter().map(|span| span.faults).collect();
        assert_eq!((counts[0], counts[59], counts.iter().sum::<u64>()), (1, 6, 7));
        assert_eq!(lockstep.link_over_time[59].sent_again, 5);
        assert!(lockstep.verdict().contains("class=\"verdict good\""));
        let parted = Lockstep::new([Some("sample 3: <it>".to_owned()), None], "", None, &[], 60.0);
        assert!(parted.verdict().contains("bad\">Target and twin part: sample 3: &lt;it&gt;"));
        assert!(parted.charts().is_empty());
        let ended = Lockstep::new([None, Some("lost".to_owned())], "0f", None, &[], 60.0);
        assert!(ended.equal && ended.verdict().contains("bad\">The flight ended early"));
    }
}
