//! A window that is chosen at run time: the bits of the same window known to the compiler.

use super::unequal::{Uneven, jitter, same_bits};
use schuler::math::compensated::Pair;
use schuler::record::Record;
use schuler::strapdown::block::any_window::AnyWindow;
use schuler::strapdown::block::unequal::Unequal;
use schuler::strapdown::block::window::Window;
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::UnequalIntervals;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::navigator::selected::Selected;
use schuler_tests::{Course, bits};

type Local = LocalLevel<Pair<f64>>;
type Earth = EarthFixed<Pair<f64>>;

fn even<F: Frame<Real = f64> + Record, W: Window>() {
    let course = Course::new("hard", 1.0, 1.0);
    let interval_s = course.interval_s;
    let plain = Strapdown::<F, W>::new(interval_s).unwrap();
    let selected = Selected::<F>::new(interval_s, AnyWindow::of::<W>()).unwrap();
    same_bits(&course, &plain, &selected, interval_s, &format!("{:?}", W::SHAPE));
}

#[test]
fn even_samples_leave_the_bits_of_the_window_itself() {
    for_every_window!(even, Local);
    for_every_window!(even, Earth);
}

/// The bits after every sample, and at the end.
fn uneven_bits<M>(flight: &Uneven, mechanization: &M) -> Vec<Vec<u64>>
where
    M: UnequalIntervals<Real = f64, Frame: Record>,
{
    let mut state = mechanization.start(&flight.initial()).unwrap();
    let mut after = Vec::new();
    for (sample, interval_s) in flight.stream() {
        mechanization.push_over(&mut state, sample, interval_s).unwrap();
        after.push(bits(M::frame(&state)));
    }
    mechanization.finish(&mut state);
    after.push(bits(M::frame(&state)));
    mechanization.check(&state).unwrap();
    after
}

fn selected<F: Frame<Real = f64> + Record, W: Window>() {
    // Even, then off by up to a fifth.
    let mut jitter = jitter(0.2);
    let interval = |time: f64, n| if time < 1.0 { 1.0 } else { jitter(time, n) };
    let flight = Uneven::new(Course::new("hard", 1.0, 1.0).source, 3.0, interval);
    let known = Strapdown::<F, Unequal<W>>::new(flight.interval_s).unwrap();
    let selected = Selected::<F>::new(flight.interval_s, AnyWindow::of::<W>()).unwrap();
    assert_eq!(uneven_bits(&flight, &selected), uneven_bits(&flight, &known), "{:?}", W::SHAPE);
}

#[test]
fn a_window_chosen_at_run_time_has_the_bits_of_one_that_is_known() {
    for_every_window!(selected, Local);
    for_every_window!(selected, Earth);
}
