//! The navigator as a [`Mechanization`].

use crate::sample::Increment;
use crate::solution::Solution;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::block::newton::Edges;
use crate::strapdown::block::window::Window;
use crate::strapdown::correction::{Correction, CorrectionError};
use crate::strapdown::frame::Frame;
use crate::strapdown::gate::admit_held;
use crate::strapdown::limits::{Rejected, StartError};
use crate::strapdown::mechanization::Mechanization;
use crate::strapdown::navigator::{State, Strapdown};
use crate::strapdown::plausible::Damaged;

impl<F: Frame, W: Window> Mechanization for Strapdown<F, W> {
    type Real = F::Real;
    type Frame = F;
    type State = State<F, W>;
    type Output = F::Output;
    type Body = BodyMotion<F::Real>;

    fn start(&self, initial: &Solution<F::Real>) -> Result<State<F, W>, StartError> {
        Strapdown::start(self, initial)
    }
    #[inline]
    fn push(&self, state: &mut State<F, W>, sample: Increment<F::Real>) -> Result<(), Rejected> {
        Strapdown::push(self, state, sample)
    }
    #[inline]
    fn push_rows(
        &self,
        state: &mut State<F, W>,
        sample: Increment<F::Real>,
        read: impl FnMut(u64, F::Output),
    ) -> Result<(), Rejected> {
        Strapdown::push_rows(self, state, sample, read)
    }
    fn finish(&self, state: &mut State<F, W>) {
        Strapdown::finish(self, state);
    }
    fn finish_rows(&self, state: &mut State<F, W>, read: impl FnMut(u64, F::Output)) {
        Strapdown::finish_rows(self, state, read);
    }
    fn push_blocks(
        &self,
        state: &mut State<F, W>,
        sample: Increment<F::Real>,
        see: impl FnMut(u64, &BodyMotion<F::Real>, &F),
    ) -> Result<(), Rejected> {
        Strapdown::push_blocks(self, state, sample, see)
    }
    fn finish_blocks(
        &self,
        state: &mut State<F, W>,
        see: impl FnMut(u64, &BodyMotion<F::Real>, &F),
    ) {
        Strapdown::finish_blocks(self, state, see);
    }
    fn hold_vertical(
        &self,
        state: &mut State<F, W>,
        altitude: F::Real,
        down: F::Real,
    ) -> Result<(), Rejected> {
        admit_held(altitude, down)?;
        state.frame.hold_vertical(altitude, down);
        Ok(())
    }
    fn correct(
        &self,
        state: &mut State<F, W>,
        correction: &Correction<F::Real>,
    ) -> Result<(), CorrectionError> {
        Strapdown::correct(self, state, correction)
    }
    fn check(&self, state: &State<F, W>) -> Result<(), Damaged> {
        Strapdown::check(self, state)
    }
    fn frame(state: &State<F, W>) -> &F {
        &state.frame
    }
    fn integrated(state: &State<F, W>) -> u64 {
        state.progress.integrated
    }
    fn edges(state: &State<F, W>) -> Option<Edges<F::Real>> {
        Some(state.progress.edges)
    }
    fn output(&self, state: &State<F, W>) -> F::Output {
        state.output()
    }
}
