//! Aided flights as fleets: what crosses the link, read and written.
//!
//! ```
//! use schuler::link::aided_fleet::EveryAided;
//! use schuler::link::fleet::Fleet;
//!
//! let mut offers = Vec::new();
//! EveryAided::offers(&mut |one| offers.push(one.to_string()));
//! assert!(offers.contains(&"aided f32 local-level taylor 0,4,0".to_string()));
//! ```

use super::aided::{Linked, LinkedAided, Stage};
use super::bytes::Bytes;
use super::fleet::{Fleet, Visitor};
use super::flight::{MOST_WAITING, Taken};
use super::frame::Writer;
use super::gap::MOST_BRIDGED;
use super::message::Start;
use super::offer::{Offer, Purpose};
use super::refusal::Refusal;
use crate::aiding::aided::instant::Instant;
use crate::aiding::aided::measured::Measured;
use crate::aiding::aided::settings::{self, Settings, States};
use crate::aiding::states::Process;
use crate::flight::catalogue::Entry;
use crate::math::real::{Real, Scalar};
use crate::navigators::{EarthFixedNavigator4, Navigator4};
use crate::record::Record;
use crate::strapdown::block::body::BodyMotion;

/// Settings to be written over.
fn nothing<R: Real>() -> Settings<R> {
    let (zero, none) = (R::ZERO, Process::constant(R::ZERO));
    let start = settings::Start {
        position_m: zero,
        velocity_m_s: zero,
        level_rad: zero,
        heading_rad: zero,
    };
    Settings::new(States::new(zero, zero, none, none), start)
}

impl<R, M, const N: usize, const P: usize, const E: usize, const L: usize, const Q: usize> Fleet
    for LinkedAided<M, N, P, E, L, Q>
where
    R: Scalar + Real<Mask = bool> + Record,
    M: Entry<Real = R, Body = BodyMotion<R>>,
{
    fn offers(offer: &mut impl FnMut(Offer)) {
        offer(Offer { purpose: Purpose::Aiding, configuration: M::CONFIGURATION });
    }

    fn start(start: &Start) -> Result<Self, Refusal> {
        let own = Offer { purpose: Purpose::Aiding, configuration: M::CONFIGURATION };
        if start.offer != own {
            return Err(Refusal::Configuration);
        }
        let (interval_s, initial) = start.beginning()?;
        let mechanization = M::configured(interval_s, start.order.into())?;
        Self::new(mechanization, interval_s, initial, start.gap)
    }

    fn take(&mut self, number: u32, mut increment: Bytes) -> Result<Taken, Refusal> {
        let sample = increment.increment().ok_or(Refusal::Malformed)?;
        increment.end().ok_or(Refusal::Malformed)?;
        LinkedAided::take(self, number, sample, &mut ())
    }

    fn hold(&mut self, _: Bytes) -> Result<(), Refusal> {
        // Who is aided holds nothing.
        Err(Refusal::Malformed)
    }

    fn finish(&mut self, samples: u32) -> Result<Taken, Refusal> {
        LinkedAided::finish(self, samples, &mut ())
    }

    fn taken(&self) -> u32 {
        LinkedAided::taken(self)
    }

    fn bridged(&self) -> u32 {
        self.bridge.lost()
    }

    fn write(&self, to: &mut Writer) {
        self.count.write(self.integrated(), to);
        to.u64(self.digest());
        self.output().record("", &mut |_, bits| to.bits::<R>(bits));
    }

    fn words(&self, read: &mut dyn FnMut(u64)) {
        self.record("", &mut |_, bits| read(bits));
    }

    fn restore(&mut self, write: &mut dyn FnMut(u64) -> u64) {
        Record::restore(self, "", &mut |_, bits| write(bits));
    }

    fn check(&self) -> Result<(), Refusal> {
        let Stage::Flying { aided, state } = &self.stage else { return Err(Refusal::Damaged) };
        aided.check(state)?;
        let waiting = u64::from(self.count.taken()).checked_sub(self.integrated());
        let sound = waiting.is_some_and(|samples| samples <= MOST_WAITING)
            && self.digest.is_plausible()
            && self.bridge.is_plausible(self.count.taken(), MOST_BRIDGED)
            && self.count.is_plausible();
        if sound { Ok(()) } else { Err(Refusal::Damaged) }
    }

    fn aid(&mut self, mut settings: Bytes) -> Result<(), Refusal> {
        let known = settings.record(nothing()).ok_or(Refusal::Malformed)?;
        settings.end().ok_or(Refusal::Malformed)?;
        LinkedAided::aid(self, &known)
    }

    fn measure(&mut self, number: u32, mut measured: Bytes) -> Result<Taken, Refusal> {
        let none = Measured::zero_velocity(Instant::of_sample(0), R::ONE);
        let known = measured.record(none).ok_or(Refusal::Malformed)?;
        measured.end().ok_or(Refusal::Malformed)?;
        LinkedAided::measure(self, number, &known)
    }

    fn visit<V: Visitor>(&mut self, _: V) -> Option<V::Result> {
        None
    }
}

/// The whole state, without configuration, settings and policy; nothing while it waits for settings.
impl<R, M, const N: usize, const P: usize, const E: usize, const L: usize, const Q: usize> Record
    for LinkedAided<M, N, P, E, L, Q>
where
    R: Scalar + Real<Mask = bool> + Record,
    M: Entry<Real = R, Body = BodyMotion<R>>,
{
    fn record(&self, _: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        let Stage::Flying { state, .. } = &self.stage else { return };
        state.record("state", read);
        self.digest.record("digest", read);
        self.bridge.record("bridge", read);
        self.count.record("count", read);
        self.measured.record("measured", read);
    }

    fn restore(&mut self, _: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        let Stage::Flying { state, .. } = &mut self.stage else { return };
        state.restore("state", write);
        self.digest.restore("digest", write);
        self.bridge.restore("bridge", write);
        self.count.restore("count", write);
        self.measured.restore("measured", write);
    }
}

crate::fleet! {
    /// Aided navigators in both precisions and axes.
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    pub EveryAided {
        F64LocalLevel: Linked<Navigator4<f64>>,
        F64EarthFixed: Linked<EarthFixedNavigator4<f64>>,
        F32LocalLevel: Linked<Navigator4<f32>>,
        F32EarthFixed: Linked<EarthFixedNavigator4<f32>>,
    }
}
