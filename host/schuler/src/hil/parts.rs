//! What a flight in step with a target is made of, for a scene.

use super::Manner;
use super::choice;
use super::conversation::Conversation;
use super::lockstep::{Aiding, Parts};
use super::pace::Pace;
use schuler::flight::configuration::Configuration;
use schuler::link::offer::{Offer, Purpose};
use schuler::link::refusal::Refusal;
use schuler::math::compensated::Pair;
use schuler::solution::Solution;
use schuler::strapdown::block::window::{H0B4A0, Window as _};
use schuler_simulator::aided::measurements::Arrivals;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::navigator::{self, Navigate};
use schuler_simulator::plan::Plan;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::{Claims, FlightError};
use schuler_simulator::source::Source;
use schuler_simulator::twin::{Beginning, Twin};

/// What an aided scene flies: there is one window, and a series as long as that has.
pub(super) fn aided(scene: &Scene, offers: &[Offer]) -> Result<Configuration, FlightError> {
    let configuration = scene.navigator.configuration(H0B4A0::SHAPE);
    choice::exactly(Offer { purpose: Purpose::Aiding, configuration }, offers)?;
    Ok(configuration)
}

/// Both sides, and a navigator of the same kind whose time is taken.
pub(super) fn of(
    scene: &Scene,
    plan: &Plan,
    initial: &Solution<f64>,
    conversation: Conversation,
    (configuration, claims): (Configuration, Option<Claims>),
    manner: &Manner,
) -> Result<(Parts, Box<dyn Navigate>), FlightError> {
    let (rate_hz, navigator) = (scene.rate_hz, &scene.navigator);
    let interval_s = Pair::new(rate_hz).reciprocal();
    let gap = navigator.gap.into();
    let order = if claims.is_some() { usize::MAX } else { plan.order };
    let mut beginning = Beginning::new(configuration, order, gap, interval_s, initial);
    if claims.is_some() {
        beginning = beginning.aided(scene);
    }
    let twin = twin(&beginning)?;
    let navigator = navigator::start(navigator, plan.window, plan.order, interval_s, initial)?;
    let aiding = match claims {
        Some(claims) => {
            let arrivals = Arrivals::new(scene, &Source::new(scene, false)?, 0);
            Some(Aiding { arrivals, sent: 0, claims })
        }
        None => None,
    };
    let pace = manner.stream.then(|| Pace::new(rate_hz));
    Ok((Parts { conversation, beginning, twin, rate_hz, pace, aiding }, navigator))
}

/// The host's side, with the settings of its filter.
pub(super) fn twin(beginning: &Beginning) -> Result<Twin, FlightError> {
    let refused = |key: &'static str| {
        move |refusal: Refusal| {
            let complaint = Complaint::new(refusal.to_string(), "");
            FlightError::Input(InputError::option(key, complaint))
        }
    };
    let mut twin = Twin::start(beginning).map_err(refused("navigator"))?;
    if let Some(settings) = beginning.settings() {
        twin.aid(settings).map_err(refused("filter"))?;
    }
    Ok(twin)
}
