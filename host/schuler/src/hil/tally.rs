//! Errors on a link, as its two ends counted them.

use super::faults::{Fault, Injected};
use schuler::link::counters::Counters;
use schuler::record::Record;
use schuler_simulator::flight::{FaultCount, LinkReport, TraceCount};

/// Counts of a whole conversation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Frames sent to the target.
    pub sent: u64,
    /// Of them, those that were sent because no answer had come.
    pub resent: u64,
    /// Whole frames received from the target.
    pub received: u64,
    /// Answers to requests that had been sent again, or given up, since.
    pub overdue: u64,
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

impl Tally {
    /// A request was answered at an attempt, from 0.
    pub fn answered(&mut self, attempt: u32, is_overdue: bool) {
        self.recovered += u64::from(attempt > 0);
        self.overdue += u64::from(is_overdue);
        self.worst_round_trips = self.worst_round_trips.max(attempt + 1);
    }

    /// Adds what a target noticed between two boots.
    pub fn add_target(&mut self, noticed: &Counters) {
        let mut counts = Vec::new();
        noticed.record("", &mut |_, count| counts.push(count));
        let mut counts = counts.into_iter();
        self.target.restore("", &mut |_, sum| sum + counts.next().unwrap_or(0));
    }

    /// What was noticed, beside what was put in and is noticed so.
    pub fn traces(&self) -> Vec<TraceCount> {
        let Self { target, host, .. } = self;
        let injected = self.injected.unwrap_or_default();
        let trace = |trace, faults: &[Fault], noticed_by_target: Option<u32>, by_host: u64| {
            let sum = |count: &dyn Fn(Fault) -> u64| faults.iter().map(|&f| count(f)).sum();
            TraceCount {
                trace,
                injected_to_target: sum(&|fault| injected.to_target(fault)),
                injected_to_host: sum(&|fault| injected.to_host(fault)),
                noticed_by_target: noticed_by_target.map(u64::from),
                noticed_by_host: by_host,
            }
        };
        // A frame that was overtaken is missing until it comes.
        let never_came = |counters: &Counters| counters.missing.saturating_sub(counters.late);
        vec![
            trace(
                "never came, or broken",
                &[Fault::Drop, Fault::Truncate, Fault::Flip],
                Some(never_came(target)),
                never_came(host).into(),
            ),
            trace(
                "came twice",
                &[Fault::Duplicate],
                Some(target.duplicated),
                host.duplicated.into(),
            ),
            trace("overtaken", &[Fault::Reorder], Some(target.late), host.late.into()),
            trace("answered too late", &[Fault::Delay, Fault::Stall], None, self.overdue),
            trace("memory lost", &[Fault::Reboot], None, self.reboots),
        ]
    }

    /// The report of a flight.
    pub fn report(&self, device: String) -> LinkReport {
        let injected = self.injected.unwrap_or_default();
        let fault = |fault: Fault| FaultCount {
            fault: fault.name(),
            to_target: injected.to_target(fault),
            to_host: injected.to_host(fault),
        };
        LinkReport {
            device,
            frames_sent: self.sent,
            frames_received: self.received,
            broken_at_target: self.target.dropped.total().into(),
            broken_at_host: self.host.dropped.total().into(),
            not_understood: self.not_understood,
            faults: self.injected.map(|_| Fault::ALL.map(fault).to_vec()).unwrap_or_default(),
            traces: self.traces(),
            resent: self.resent,
            recovered: self.recovered,
            lost: self.lost,
            bridged: self.bridged,
            worst_round_trips: self.worst_round_trips,
            planned_window: None,
        }
    }
}
