//! How long to wait for an answer, from the times that the line and the target have needed so far.

use std::time::Duration;

/// Before anything is known, and at most: far longer than any answer takes.
pub const PATIENCE: Duration = Duration::from_secs(5);

/// At least: a process that has to wait for its turn on a busy machine is not silent.
const LEAST: Duration = Duration::from_millis(250);

/// How long answers are waited for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Patience {
    /// Always so long.
    Fixed(Duration),
    /// By the round trips so far, s: smoothed, and their smoothed deviation; nothing before the first.
    Measured(Option<[f64; 2]>),
}

impl Default for Patience {
    fn default() -> Self {
        Self::Measured(None)
    }
}

impl Patience {
    /// For the answer to a request that was sent again so many times: each time twice as long.
    pub fn at(&self, attempt: u32) -> Duration {
        match *self {
            Self::Fixed(patience) => patience,
            Self::Measured(None) => PATIENCE,
            Self::Measured(Some([smoothed, deviation])) => {
                // RTO = SRTT + 4·RTTVAR, doubled at each retransmission (RFC 6298, 2.3 and 5.5)
                let once = Duration::from_secs_f64(smoothed + 4.0 * deviation).max(LEAST);
                once.saturating_mul(1 << attempt.min(16)).min(PATIENCE)
            }
        }
    }

    /// A request was answered after so long, without being sent again: of others it is not known which
    /// sending was answered.
    pub fn learn(&mut self, took: Duration) {
        let took = took.min(PATIENCE).as_secs_f64();
        if let Self::Measured(trips) = self {
            *trips = Some(match *trips {
                None => [took, 0.5 * took],
                // RTTVAR ← ¾ RTTVAR + ¼ |SRTT − R|,  SRTT ← ⅞ SRTT + ⅛ R (RFC 6298, 2.3)
                Some([smoothed, deviation]) => [
                    0.875 * smoothed + 0.125 * took,
                    0.75 * deviation + 0.25 * (smoothed - took).abs(),
                ],
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    #[test]
    fn a_quick_line_is_not_waited_for_long_and_a_slow_one_is() {
        let mut patience = Patience::default();
        assert_eq!([0, 7].map(|attempt| patience.at(attempt)), [PATIENCE; 2]);
        patience.learn(ms(1));
        assert_eq!([0, 1, 2].map(|attempt| patience.at(attempt)), [250, 500, 1000].map(ms));
        assert_eq!(patience.at(u32::MAX), PATIENCE);

        let mut patience = Patience::default();
        // 400 + 4·200 ms; by and by the deviation of a steady line goes.
        patience.learn(ms(400));
        assert_eq!(patience.at(0), ms(1200));
        (0..100).for_each(|_| patience.learn(ms(400)));
        assert_eq!(patience.at(0).as_millis(), 400);
        patience.learn(ms(60_000));
        assert_eq!(patience.at(0), PATIENCE);
    }

    #[test]
    fn what_is_fixed_stays() {
        let mut patience = Patience::Fixed(ms(30));
        patience.learn(ms(400));
        assert_eq!([0, 3].map(|attempt| patience.at(attempt)), [ms(30); 2]);
    }
}
