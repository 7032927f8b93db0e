//! Independent runs side by side on one core: each lane of a vector register flies one.
//!
//! The core's generic code is compiled for packs of runs, four in AVX2 registers and eight in AVX-512
//! registers; the processor decides at run time. Each lane has the bits of its run flown alone.

pub mod abreast;
mod circle;
pub mod drawn;
mod joined;
mod logarithm;
pub mod normal;
pub mod one;
pub mod pack;
mod samples;
pub mod sensors;
mod stream;
pub mod truth;
pub mod words;
#[cfg(target_arch = "x86_64")]
mod x86;

use pack::Lanes;

/// Keeps [`Lanes`] in this house.
mod sealed {
    pub trait Sealed {}
}

/// Vector registers that runs can fly in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Registers {
    /// Eight runs.
    Avx512,
    /// Four runs.
    Avx2,
}

impl Registers {
    /// How many runs fly in one.
    pub fn runs(self) -> usize {
        match self {
            Self::Avx512 => 8,
            Self::Avx2 => 4,
        }
    }

    /// Whether this processor has them: all the features that `x86` compiles for.
    pub fn are_there(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        return match self {
            Self::Avx512 => {
                is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512vl")
            }
            Self::Avx2 => is_x86_feature_detected!("avx2"),
        };
        #[cfg(not(target_arch = "x86_64"))]
        return false;
    }
}

/// What can be done in lanes of any kind.
pub trait InLanes {
    /// What comes of it.
    type Output;
    /// Does it in lanes of this kind.
    fn run<P: Lanes<N>, const N: usize>(self) -> Self::Output;
}

/// Does it in such registers, if the processor has them.
pub fn in_registers<T: InLanes>(registers: Registers, task: T) -> Option<T::Output> {
    if !registers.are_there() {
        return None;
    }
    #[cfg(target_arch = "x86_64")]
    return Some(match registers {
        Registers::Avx512 => task.run::<x86::Avx512, 8>(),
        Registers::Avx2 => task.run::<x86::Avx2, 4>(),
    });
    #[cfg(not(target_arch = "x86_64"))]
    return {
        drop(task);
        None
    };
}
