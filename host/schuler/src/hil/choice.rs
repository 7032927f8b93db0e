//! The configuration that a target is asked to fly: that of the scene, if the target offers it.

use schuler::flight::configuration::Configuration;
use schuler::link::offer::{Offer, Purpose};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::scene::{Navigator, WindowShape};

/// The configuration for a navigator whose window is planned unless the scene names one.
pub fn choose(
    navigator: &Navigator,
    planned: WindowShape,
    offers: &[Offer],
) -> Result<Configuration, InputError> {
    let wanted = navigator.configuration(navigator.window.unwrap_or(planned));
    if offers.contains(&wanted.into()) {
        return Ok(wanted);
    }
    let plain = offers.iter().filter(|offer| offer.purpose == Purpose::Navigation);
    let is_alike =
        |offer: &&Configuration| **offer == Configuration { window: offer.window, ..wanted };
    let alike = plain.map(|offer| &offer.configuration).filter(is_alike);
    let samples = |offer: &&Configuration| offer.window.samples();
    // What a motion needs that is too fast for its own block, the widest window gives; the narrowest, else.
    let WindowShape { history, lookahead, .. } = wanted.window;
    let other =
        if history + lookahead > 0 { alike.max_by_key(samples) } else { alike.min_by_key(samples) };
    match other.filter(|_| navigator.window.is_none()) {
        Some(&other) => Ok(other),
        None => Err(not_offered(wanted.into(), offers)),
    }
}

/// The one that is wanted, and no other.
pub fn exactly(wanted: Offer, offers: &[Offer]) -> Result<(), InputError> {
    if offers.contains(&wanted) { Ok(()) } else { Err(not_offered(wanted, offers)) }
}

fn not_offered(wanted: Offer, offers: &[Offer]) -> InputError {
    let does = match wanted.purpose {
        Purpose::Identification => "do",
        Purpose::Navigation | Purpose::Aiding => "fly",
    };
    let accepted: Vec<_> = offers
        .iter()
        .filter(|offer| offer.purpose == wanted.purpose)
        .map(Offer::to_string)
        .collect();
    let accepted = match accepted.is_empty() {
        true => "a target whose image has it: navigator-aided of tests/firmware".to_owned(),
        false => accepted.join("; "),
    };
    let what = format!("the target does not {does} {wanted}");
    InputError::option("navigator", Complaint::new(what, accepted))
}

#[cfg(test)]
mod tests {
    use super::*;
    use schuler::link::fleet::{Every, Fleet, Single};
    use schuler_simulator::scene::{Algorithm, Precision};

    fn offers<F: Fleet>() -> Vec<Offer> {
        let mut offers = Vec::new();
        F::offers(&mut |offer| offers.push(offer));
        offers
    }

    fn shape(history: usize, block: usize, lookahead: usize) -> WindowShape {
        WindowShape { history, block, lookahead }
    }

    #[test]
    fn a_plan_keeps_to_what_is_offered() {
        let navigator = Navigator::default();
        let chosen = |planned| choose(&navigator, planned, &offers::<Every>()).unwrap().window;
        assert_eq!(chosen(shape(0, 40, 0)), shape(0, 4, 0));
        assert_eq!(chosen(shape(4, 4, 4)), shape(2, 4, 2));
        assert_eq!(chosen(shape(2, 4, 2)), shape(2, 4, 2));
    }

    #[test]
    fn what_is_not_offered_is_refused_with_what_is() {
        let named = Navigator { window: Some(shape(0, 8, 0)), ..Navigator::default() };
        let error = choose(&named, shape(0, 4, 0), &offers::<Every>()).unwrap_err().to_string();
        let begin = "navigator: the target does not fly f64 local-level taylor 0,8,0; accepted: \
                     f64 local-level taylor 0,4,0; f64 local-level taylor 2,4,2; ";
        assert!(error.starts_with(begin), "{error}");
        let double = choose(&Navigator::default(), shape(0, 4, 0), &offers::<Single>());
        assert!(double.unwrap_err().to_string().contains("does not fly f64"));
        let textbook = Navigator {
            algorithm: Algorithm::Textbook,
            precision: Precision::F32,
            ..Navigator::default()
        };
        let chosen = choose(&textbook, shape(0, 4, 0), &offers::<Single>()).unwrap();
        assert_eq!((chosen.algorithm, chosen.window()), (Algorithm::Textbook, None));
    }
}
