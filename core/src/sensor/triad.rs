//! A triad of gyros or of accelerometers with every error term, each present or absent at run time.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sensor::{Timing, emulator::Emulator, triad::Triad, white::White};
//!
//! let timing = Timing::new(0.01_f64, 1000)?;
//! let white = White::new(Vector::new(3e-6, 3e-6, 3e-6), timing)?;
//! let gyro = Triad { white: Some(white), ..Triad::PERFECT };
//! let emulator = Emulator::new(gyro, Triad::PERFECT, timing);
//! # let _ = emulator;
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::bandwidth::Bandwidth;
use super::constant::Constant;
use super::flicker::Flicker;
use super::g_sensitivity::GSensitivity;
use super::g_sensitivity_matrix::GSensitivityMatrix;
use super::gauss_markov::GaussMarkov;
use super::latency::Latency;
use super::misalignment::Misalignment;
use super::misalignment_matrix::MisalignmentMatrix;
use super::quantization::Quantization;
use super::random_walk::RandomWalk;
use super::saturation::Saturation;
use super::scale_factor::ScaleFactor;
use super::temperature_bias::TemperatureBias;
use super::temperature_scale::TemperatureScale;
use super::turn_on::TurnOn;
use super::white::White;
use super::{ErrorTerm, Reading, Stimulus};
use crate::noise::Streams;
use crate::noise::random::Random;
use crate::record::{Record, record};

macro_rules! triad {
    ($($(#[$doc:meta])* $name:ident: $term:ident = $branch:literal,)+) => {
        /// The terms of a triad, in the order in which they act; with `None` for all it is perfect.
        ///
        /// A term's random numbers do not depend on which other terms are present.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct Triad<R> {
            $($(#[$doc])* pub $name: Option<$term<R>>,)+
        }

        /// The states of the terms.
        #[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct TriadState<R: Random> {
            $($name: <Option<$term<R>> as ErrorTerm<R>>::State,)+
        }

        impl<R> Triad<R> {
            /// Sensors without error.
            pub const PERFECT: Self = Self { $($name: None,)+ };
        }

        impl<R: Copy> Triad<R> {
            /// The same terms in numbers of another type, as `number` makes them from these.
            pub fn map<T>(&self, number: impl Fn(R) -> T) -> Triad<T> {
                Triad { $($name: self.$name.as_ref().map(|term| term.map(&number)),)+ }
            }
        }

        impl<R: Random> ErrorTerm<R> for Triad<R> {
            type State = TriadState<R>;

            fn start(&self, streams: Streams) -> TriadState<R> {
                TriadState { $($name: self.$name.start(streams.branch($branch)),)+ }
            }

            #[inline(always)]
            fn apply(
                &self,
                state: &mut TriadState<R>,
                stimulus: &Stimulus<R>,
                reading: &mut Reading<R>,
            ) {
                $(self.$name.apply(&mut state.$name, stimulus, reading);)+
            }
        }

        impl<R: Random> Record for TriadState<R> {
            record!($($name),+);
        }
    };
}

triad! {
    /// Latency.
    latency: Latency = 11,
    /// Constant bias.
    constant: Constant = 0,
    /// Bias drawn for each run.
    turn_on: TurnOn = 1,
    /// First-order Gauss-Markov bias.
    gauss_markov: GaussMarkov = 2,
    /// Angle or velocity random walk.
    white: White = 3,
    /// Rate or acceleration random walk.
    random_walk: RandomWalk = 4,
    /// Bias instability.
    flicker: Flicker = 5,
    /// Scale factor error.
    scale_factor: ScaleFactor = 6,
    /// Misalignment.
    misalignment: Misalignment = 7,
    /// g-sensitivity.
    g_sensitivity: GSensitivity = 8,
    /// Misalignment of each axis.
    misalignment_matrix: MisalignmentMatrix = 12,
    /// g-sensitivity across axes.
    g_sensitivity_matrix: GSensitivityMatrix = 13,
    /// Bias by temperature.
    temperature_bias: TemperatureBias = 14,
    /// Scale factor by temperature.
    temperature_scale: TemperatureScale = 15,
    /// Bandwidth.
    bandwidth: Bandwidth = 16,
    /// Limits.
    saturation: Saturation = 9,
    /// Quantization.
    quantization: Quantization = 10,
}

impl<R> Default for Triad<R> {
    fn default() -> Self {
        Self::PERFECT
    }
}
