//! Faults that are injected on purpose: their kinds, probabilities and counts.

use schuler_simulator::input::{Complaint, Range};

/// What can happen to a frame on its way, or to the target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// It never arrives.
    Drop,
    /// It arrives twice.
    Duplicate,
    /// It arrives after the next one.
    Reorder,
    /// It arrives when it is not waited for any more.
    Delay,
    /// Its end is missing.
    Truncate,
    /// One of its bits is another.
    Flip,
    /// The target does nothing for a while, and then everything at once.
    Stall,
    /// The target forgets everything.
    Reboot,
}

impl Fault {
    /// Every kind.
    pub const ALL: [Self; 8] = [
        Self::Drop,
        Self::Duplicate,
        Self::Reorder,
        Self::Delay,
        Self::Truncate,
        Self::Flip,
        Self::Stall,
        Self::Reboot,
    ];
    /// How many of them happen to answers, too: the first ones.
    pub const OF_ANSWERS: usize = 6;

    /// The name in `--faults` and in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Drop => "drop",
            Self::Duplicate => "duplicate",
            Self::Reorder => "reorder",
            Self::Delay => "delay",
            Self::Truncate => "truncate",
            Self::Flip => "flip",
            Self::Stall => "stall",
            Self::Reboot => "reboot",
        }
    }
}

/// How many frames in one a fault happens to, for each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates([f64; Fault::ALL.len()]);

impl Rates {
    /// As `--faults` gives them: `drop=0.01,flip=0.002`, or `all=0.01` for every kind's equal share.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let mut rates = Self::default();
        let mut named: Vec<&str> = Vec::new();
        for item in text.split(',') {
            let wrong = |what: String| Complaint::new(what, Self::accepted());
            let (name, rate) =
                item.split_once('=').ok_or_else(|| wrong(format!("{item} is not NAME=RATE")))?;
            let (name, rate) = (name.trim(), rate.trim());
            let range = Range::from_to(0.0, 1.0, "a rate from 0 to 1");
            let rate = rate.parse().map_err(|_| wrong(format!("{rate} is not a number")))?;
            let rate = range.check(rate)?;
            if named.contains(&name) || !named.is_empty() && (name == "all" || named[0] == "all") {
                let what = format!("{name}={rate} comes after {}", named.join(", "));
                return Err(Complaint::new(what, "each name once, all by itself"));
            }
            named.push(name);
            if name == "all" {
                rates.0 = [rate / Fault::ALL.len() as f64; Fault::ALL.len()];
            } else {
                let kind = Fault::ALL.iter().position(|kind| kind.name() == name);
                let kind = kind.ok_or_else(|| wrong(format!("{name} is no fault")))?;
                rates.0[kind] = rate;
            }
        }
        let total: f64 = rates.0.iter().sum();
        if total > 1.0 {
            let what = format!("the rates add up to {total}");
            return Err(Complaint::new(what, "rates that add up to at most 1"));
        }
        Ok(rates)
    }

    fn accepted() -> String {
        let names = Fault::ALL.map(Fault::name).join(", ");
        format!("NAME=RATE, more of them after commas; the names are {names}, and all")
    }

    /// The fault of a frame by a number from 0 to 1, among the first `kinds`.
    pub fn pick(&self, number: f64, kinds: usize) -> Option<Fault> {
        let mut below = 0.0;
        Fault::ALL.iter().zip(self.0).take(kinds).find_map(|(&fault, rate)| {
            below += rate;
            (number < below).then_some(fault)
        })
    }
}

/// How many faults of each kind were put in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Injected {
    to_target: [u64; Fault::ALL.len()],
    to_host: [u64; Fault::ALL.len()],
}

impl Injected {
    /// One more, in a frame to the target or in one to the host.
    pub fn count(&mut self, fault: Fault, to_target: bool) {
        let counts = if to_target { &mut self.to_target } else { &mut self.to_host };
        counts[fault as usize] += 1;
    }

    /// How many in all.
    pub fn total(&self) -> u64 {
        self.to_target.iter().chain(&self.to_host).sum()
    }

    /// How many in frames to the target.
    pub fn to_target(&self, fault: Fault) -> u64 {
        self.to_target[fault as usize]
    }

    /// How many in frames to the host.
    pub fn to_host(&self, fault: Fault) -> u64 {
        self.to_host[fault as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_read_and_refused_with_what_would_be_accepted() {
        let rates = Rates::parse("drop=0.25, flip=0.5").unwrap();
        let at = |x| rates.pick(x, Fault::ALL.len());
        assert_eq!([0.2, 0.3, 0.8].map(at), [Some(Fault::Drop), Some(Fault::Flip), None]);
        let all = Rates::parse("all=0.8").unwrap();
        let at = |x| all.pick(x, Fault::OF_ANSWERS);
        assert_eq!([0.55, 0.65].map(at), [Some(Fault::Flip), None]);
        for (text, part) in [
            ("drop", "drop is not NAME=RATE"),
            ("melt=0.1", "melt is no fault; accepted: NAME=RATE"),
            ("drop=x", "x is not a number"),
            ("drop=1.5", "1.5 is out of range; accepted: a rate from 0 to 1"),
            ("drop=0.5,all=0.1", "all=0.1 comes after drop; accepted: each name once"),
            ("all=0.1,drop=0.5", "drop=0.5 comes after all; accepted: each name once"),
            ("drop=0.5,drop=0.5", "drop=0.5 comes after drop; accepted: each name once"),
            ("drop=0.6,flip=0.6", "the rates add up to 1.2"),
        ] {
            let complaint = Rates::parse(text).unwrap_err().to_string();
            assert!(complaint.contains(part), "{complaint}");
        }
    }
}
