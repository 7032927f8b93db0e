//! The catalogue: whoever chooses a navigator at run time has the same ones, by the same words.

use schuler::flight::catalogue::{Audited, Catalogue, Every};
use schuler::flight::configuration::{Algorithm, Axes, Configuration, Precision};
use schuler::link::fleet::{self, Fleet};
use schuler::math::compensated::Pair;
use schuler::solution::{Euler, Solution};
use schuler::strapdown::block::window::NAMED;
use schuler_host::frontier::case::{Case, Method};
use schuler_simulator::navigator;
use schuler_simulator::navigator::compared::Arithmetic;
use schuler_simulator::scene::{Navigator, limits};

fn all<C: Catalogue>() -> Vec<Configuration> {
    let mut all = Vec::new();
    C::each(&mut |one| all.push(one));
    all
}

fn offers<F: Fleet>() -> Vec<Configuration> {
    let mut offers = Vec::new();
    F::offers(&mut |one| offers.push(one.configuration));
    offers
}

#[test]
fn every_named_window_is_there_in_either_precision_and_axes() {
    let all = all::<Every>();
    for &window in NAMED {
        for precision in [Precision::F64, Precision::F32] {
            for &(_, axes) in Axes::NAMES {
                let algorithm = Algorithm::Taylor;
                let one = Configuration { precision, axes, algorithm, window };
                assert!(all.contains(&one) && Every::has(&one), "{one}");
            }
        }
    }
    let mut once = all.clone();
    once.dedup();
    assert_eq!(once, all);
}

#[test]
fn words_and_bytes_lead_back() {
    for one in all::<Every>() {
        assert_eq!(one.to_string().parse(), Ok(one));
        assert_eq!(Configuration::from_bytes(one.to_bytes()), Some(one));
    }
    for text in ["", "f64", "f64 local-level taylor", "f64 local-level textbook 0,4,0", "f16 x y"] {
        assert!(text.parse::<Configuration>().is_err(), "{text}");
    }
    let accepted = "f80".parse::<Precision>().unwrap_err().to_string();
    assert_eq!(accepted, "accepted: f64, f32, f32x2");
}

#[test]
fn audits_targets_and_the_frontier_choose_from_it() {
    let every = all::<Every>();
    let audited = all::<Audited>();
    assert_eq!(audited, schuler_simulator::navigator::stepping::all());
    for one in audited.iter().chain(&offers::<fleet::Every>()).chain(&offers::<fleet::Single>()) {
        assert!(every.contains(one), "{one}");
    }
    let cases = Case::all();
    for one in &every {
        let method = one.window().map_or(Method::Textbook, Method::Taylor);
        let case = Case { method, frame: one.axes, arithmetic: Arithmetic::Named(one.precision) };
        assert!(cases.contains(&case), "{one}");
    }
}

#[test]
fn the_host_starts_every_one_and_says_what_it_has_of_others() {
    let start = |one: &Configuration| {
        let &Configuration { precision, axes: frame, algorithm, window } = one;
        let navigator = Navigator { precision, frame, algorithm, ..Navigator::default() };
        let interval_s = Pair::new(100.0).reciprocal();
        let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
        let initial = Solution::new(Default::default(), Default::default(), level);
        navigator::start(&navigator, window, 10, interval_s, &initial)
    };
    for one in all::<Every>() {
        assert!(start(&one).is_ok(), "{one}");
        if let Some(window) = one.window() {
            let [history, block, lookahead] =
                [window.history, window.block, window.lookahead].map(|n| n as u64);
            assert_eq!(limits::window(history, block, lookahead), Ok(window));
        }
    }
    let other: Configuration = "f32x2 local-level taylor 0,8,0".parse().unwrap();
    let told = start(&other).err().map(|error| error.to_string()).unwrap();
    assert!(told.contains("f32x2 has no window 0,8,0") && told.contains("2,4,2"), "{told}");
}
