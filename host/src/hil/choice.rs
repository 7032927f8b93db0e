//! The configuration that a target is asked to fly: that of the scene, if the target offers it.

use crate::input::{Complaint, InputError};
use crate::scene::{Algorithm, Frame, Navigator, Precision, WindowShape};
use schuler::link::configuration::{Axes, Configuration, Method};
use schuler::strapdown::plan::Digits;

/// The configuration for a navigator whose window is planned unless the scene names one.
pub fn choose(
    navigator: &Navigator,
    planned: WindowShape,
    offers: &[Configuration],
) -> Result<Configuration, InputError> {
    let textbook = navigator.algorithm == Algorithm::Textbook;
    let asked = |window| Configuration {
        digits: match navigator.precision {
            Precision::F64 => Digits::Double,
            Precision::F32 => Digits::Single,
            Precision::F32x2 => Digits::TwoFloat,
        },
        axes: match navigator.frame {
            Frame::LocalLevel => Axes::LocalLevel,
            Frame::EarthFixed => Axes::EarthFixed,
        },
        method: if textbook { Method::Textbook } else { Method::Taylor },
        window,
    };
    let window = if textbook {
        [0, 1, 0]
    } else {
        let WindowShape { history, block, lookahead } = navigator.window.unwrap_or(planned);
        [history, block, lookahead].map(|samples| samples as u8)
    };
    let wanted = asked(window);
    if offers.contains(&wanted) {
        return Ok(wanted);
    }
    let alike = offers.iter().filter(|offer| **offer == asked(offer.window));
    let samples = |offer: &&Configuration| offer.window.iter().map(|&n| u32::from(n)).sum::<u32>();
    // What a motion needs that is too fast for its own block, the widest window gives; the narrowest, else.
    let [history, _, lookahead] = window;
    let other =
        if history + lookahead > 0 { alike.max_by_key(samples) } else { alike.min_by_key(samples) };
    match other.filter(|_| navigator.window.is_none()) {
        Some(&other) => Ok(other),
        None => {
            let accepted: Vec<_> = offers.iter().map(name).collect();
            let what = format!("the target does not fly {}", name(&wanted));
            Err(InputError::option("navigator", Complaint::new(what, accepted.join("; "))))
        }
    }
}

/// The window of a configuration, if it has one.
pub fn window(configuration: &Configuration) -> Option<WindowShape> {
    let [history, block, lookahead] = configuration.window.map(usize::from);
    (configuration.method == Method::Taylor).then_some(WindowShape { history, block, lookahead })
}

/// A configuration in the words of scenes and options.
fn name(configuration: &Configuration) -> String {
    let precision = match configuration.digits {
        Digits::Double => Precision::F64,
        Digits::Single => Precision::F32,
        Digits::TwoFloat => Precision::F32x2,
    };
    let frame = match configuration.axes {
        Axes::LocalLevel => Frame::LocalLevel,
        Axes::EarthFixed => Frame::EarthFixed,
    };
    let algorithm = match window(configuration) {
        Some(window) => format!("{} {window}", Algorithm::Taylor.name()),
        None => Algorithm::Textbook.name().to_owned(),
    };
    format!("{} {algorithm} {}", precision.name(), frame.name())
}

#[cfg(test)]
mod tests {
    use super::*;
    use schuler::link::fleet::{Every, Fleet, Single};

    fn offers<F: Fleet>() -> Vec<Configuration> {
        let mut offers = Vec::new();
        F::offers(|offer| offers.push(offer));
        offers
    }

    fn shape(history: usize, block: usize, lookahead: usize) -> WindowShape {
        WindowShape { history, block, lookahead }
    }

    #[test]
    fn a_plan_keeps_to_what_is_offered() {
        let navigator = Navigator::default();
        let chosen = |planned| choose(&navigator, planned, &offers::<Every>()).unwrap().window;
        assert_eq!(chosen(shape(0, 40, 0)), [0, 4, 0]);
        assert_eq!(chosen(shape(4, 4, 4)), [2, 4, 2]);
        assert_eq!(chosen(shape(2, 4, 2)), [2, 4, 2]);
    }

    #[test]
    fn what_is_not_offered_is_refused_with_what_is() {
        let named = Navigator { window: Some(shape(0, 8, 0)), ..Navigator::default() };
        let error = choose(&named, shape(0, 4, 0), &offers::<Every>()).unwrap_err().to_string();
        let begin = "navigator: the target does not fly f64 taylor 0,8,0 local-level; accepted: \
                     f64 taylor 0,4,0 local-level; f64 taylor 2,4,2 local-level; ";
        assert!(error.starts_with(begin), "{error}");
        let double = choose(&Navigator::default(), shape(0, 4, 0), &offers::<Single>());
        assert!(double.unwrap_err().to_string().contains("does not fly f64"));
        let textbook = Navigator {
            algorithm: Algorithm::Textbook,
            precision: Precision::F32,
            ..Navigator::default()
        };
        let chosen = choose(&textbook, shape(0, 4, 0), &offers::<Single>()).unwrap();
        assert_eq!((chosen.method, window(&chosen)), (Method::Textbook, None));
    }
}
