//! When a sensor measures, when it does not, and how late its measurements arrive.
//!
//! ```
//! use schuler::sensor::aiding::line::{Line, Outage};
//!
//! let tunnel = Outage { from_s: 400.0_f64, until_s: 460.0 };
//! let line = Line { latency_s: 0.2, jitter_s: 0.1, ..Line::every(1.0) }.with_outage(tunnel).unwrap();
//! let mut state = line.checked()?.start(schuler::noise::Streams::new(1, 0));
//! let (at_s, arrives_s) = line.next(&mut state).unwrap();
//! assert!(at_s == 1.0 && (1.2..1.3).contains(&arrives_s.0));
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use crate::aiding::aided::measured::Measured;
use crate::math::real::Scalar;
use crate::noise::{Deviate, Stream, Streams};
use crate::record::{Record, record};
use crate::sensor::parameter::{Fault, Parameter, ParameterError};

/// Outages at most.
pub const MOST_OUTAGES: usize = 8;

/// A time without measurements: after `from_s`, up to `until_s`, seconds since the start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Outage<R> {
    /// The last instant with a measurement, s.
    pub from_s: R,
    /// The last instant without one, s.
    pub until_s: R,
}

impl<R: Scalar> Outage<R> {
    /// Whether a time is in it.
    pub fn contains(&self, time_s: R) -> bool {
        time_s > self.from_s && time_s <= self.until_s
    }
}

/// How a sensor's measurements come.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Line<R> {
    /// The first measurement, seconds after the start.
    pub first_s: R,
    /// From one to the next, s.
    pub interval_s: R,
    /// How much later than it was true each arrives at least, s.
    pub latency_s: R,
    /// How much later than that at most, s; evenly distributed.
    pub jitter_s: R,
    /// How probably one never arrives.
    pub loss: R,
    /// How probably one arrives twice.
    pub repetition: R,
    /// When there are none.
    pub outages: [Option<Outage<R>>; MOST_OUTAGES],
}

/// The state of a line.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LineState {
    /// Epochs so far.
    pub epochs: u32,
    stream: Stream,
}

/// A measurement on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Delivered<R> {
    /// The measurement.
    pub measured: Measured<R>,
    /// When it arrives, seconds since the start.
    pub arrives_s: R,
    /// When it arrives again, if it does, s.
    pub again_s: Option<R>,
}

impl<R: Scalar> Line<R> {
    /// Every so many seconds, the first after as many, at once and without loss.
    pub fn every(interval_s: R) -> Self {
        Self {
            first_s: interval_s,
            interval_s,
            latency_s: R::ZERO,
            jitter_s: R::ZERO,
            loss: R::ZERO,
            repetition: R::ZERO,
            outages: [None; MOST_OUTAGES],
        }
    }

    /// With another outage; `None` if there are [`MOST_OUTAGES`] already.
    pub fn with_outage(mut self, outage: Outage<R>) -> Option<Self> {
        *self.outages.iter_mut().find(|slot| slot.is_none())? = Some(outage);
        Some(self)
    }

    /// The outages.
    pub fn outages(&self) -> impl Iterator<Item = &Outage<R>> {
        self.outages.iter().flatten()
    }

    /// When the next measurement is true, seconds since the start.
    pub fn epoch_s(&self, state: &LineState) -> R {
        self.first_s + self.interval_s * R::count(state.epochs)
    }
}

impl<R: Deviate> Line<R> {
    /// The same, checked.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if a time is not finite or negative, the interval is 0, a probability is above 1, or an
    /// outage ends before it begins.
    pub fn checked(self) -> Result<Self, ParameterError> {
        Parameter::FirstTime.size(self.first_s)?;
        Parameter::Interval.single(self.interval_s)?;
        Parameter::Latency.size(self.latency_s)?;
        Parameter::Jitter.size(self.jitter_s)?;
        Parameter::Probability.share(self.loss)?;
        Parameter::Probability.share(self.repetition)?;
        for outage in self.outages() {
            Parameter::FaultTimes.number(outage.from_s)?;
            Parameter::FaultTimes.number(outage.until_s)?;
            if outage.until_s < outage.from_s {
                return Err(Parameter::FaultTimes.fault(Fault::OutOfRange));
            }
        }
        Ok(self)
    }

    /// Before the first measurement.
    pub fn start(&self, streams: Streams) -> LineState {
        LineState { epochs: 0, stream: streams.open() }
    }

    /// The next measurement: when it is true, when it arrives, and when again. Nothing in an outage, or if it gets
    /// lost.
    pub fn next(&self, state: &mut LineState) -> Option<(R, (R, Option<R>))> {
        let at_s = self.epoch_s(state);
        state.epochs = state.epochs.saturating_add(1);
        // The same words in every epoch.
        let mut draw = || state.stream.uniform::<R>();
        let [jitter, lost, again, later] = [draw(), draw(), draw(), draw()];
        if lost < self.loss || self.outages().any(|outage| outage.contains(at_s)) {
            return None;
        }
        let arrives = |jitter: R| at_s + self.latency_s + self.jitter_s * jitter;
        let again_s = (again < self.repetition).then(|| arrives(R::ONE + later));
        Some((at_s, (arrives(jitter), again_s)))
    }
}

impl Record for LineState {
    record!(epochs, stream);
}
