//! What happened on a link, as its two ends noticed it.

use super::faults::{Fault, Injected};
use schuler::link::counters::Counters;
use schuler::record::Record;

/// Counts of a whole conversation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Frames sent to the target.
    pub sent: u64,
    /// Of them, those that were sent because no answer had come.
    pub resent: u64,
    /// Whole frames received from the target.
    pub received: u64,
    /// Times that no answer came.
    pub timeouts: u64,
    /// Answers to requests that had been sent again, or given up, since.
    pub overdue: u64,
    /// Answers to requests that had been answered.
    pub surplus: u64,
    /// Whole frames that no target of this version sends.
    pub not_understood: u64,
    /// Times that the target was found to have forgotten everything.
    pub reboots: u64,
    /// Requests that were answered in the end, though not at once.
    pub recovered: u64,
    /// Samples given up.
    pub lost: u64,
    /// Of them, those that the target did not have.
    pub bridged: u64,
    /// How often a request was sent until it was answered, at most.
    pub worst_round_trips: u32,
    /// What the host noticed of the target's frames.
    pub host: Counters,
    /// What the target noticed of the host's frames, over all its boots.
    pub target: Counters,
    /// Faults put in on purpose.
    pub injected: Option<Injected>,
}

/// A kind of fault: how often it was put in, and noticed, on either way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Its name.
    pub fault: &'static str,
    /// Put in, to the target and to the host.
    pub injected: [u64; 2],
    /// Noticed, by the target and by the host; `None` where one cannot.
    pub detected: [Option<u64>; 2],
}

impl Tally {
    /// A request was answered at an attempt, from 0.
    pub fn answered(&mut self, attempt: u32, is_overdue: bool) {
        self.recovered += u64::from(attempt > 0);
        self.overdue += u64::from(is_overdue);
        self.worst_round_trips = self.worst_round_trips.max(attempt + 1);
    }

    /// Adds what a target noticed between two boots.
    pub fn add_target(&mut self, noticed: &Counters) {
        let (mut noticed, mut counts) = (*noticed, Vec::new());
        noticed.record("", &mut |_, count| {
            counts.push(count);
            count
        });
        let mut counts = counts.into_iter();
        self.target.record("", &mut |_, sum| sum + counts.next().unwrap_or(0));
    }

    /// The faults by what tells them apart: what was put in, and what was noticed of it.
    pub fn rows(&self) -> Vec<Row> {
        let injected = self.injected.unwrap_or_default();
        let both = |faults: &[Fault]| {
            let sum = |count: &dyn Fn(Fault) -> u64| faults.iter().map(|&f| count(f)).sum();
            [sum(&|f| injected.to_target(f)), sum(&|f| injected.to_host(f))]
        };
        let noticed = |count: fn(&Counters) -> u32| {
            [Some(count(&self.target).into()), Some(count(&self.host).into())]
        };
        let row = |fault, injected, detected| Row { fault, injected, detected };
        let waiting = both(&[Fault::Delay, Fault::Stall]);
        vec![
            row(
                "dropped, truncated or flipped",
                both(&[Fault::Drop, Fault::Truncate, Fault::Flip]),
                // A frame that was overtaken is missing until it comes.
                noticed(|counters| counters.missing.saturating_sub(counters.late)),
            ),
            row("duplicated", both(&[Fault::Duplicate]), noticed(|counters| counters.duplicated)),
            row("reordered", both(&[Fault::Reorder]), noticed(|counters| counters.late)),
            row("delayed or stalled", [waiting[0] + waiting[1], 0], [None, Some(self.overdue)]),
            row("target rebooted", both(&[Fault::Reboot]), [None, Some(self.reboots)]),
        ]
    }

    /// Whether everything that was put in was noticed, and nothing else.
    pub fn is_explained(&self) -> bool {
        self.not_understood == 0
            && self.rows().iter().all(|row| {
                let [to_target, to_host] = row.injected;
                match row.detected {
                    [None, Some(by_host)] => by_host == to_target + to_host,
                    [by_target, by_host] => {
                        by_target.unwrap_or(0) == to_target && by_host.unwrap_or(0) == to_host
                    }
                }
            })
    }
}
