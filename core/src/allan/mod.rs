//! Allan deviation of a sensor, sample by sample in fixed memory, and its closed form for each error term.
//!
//! The deviation at an averaging time τ is the rms difference of neighbouring means over τ, over √2. Each error
//! term has a slope of its own, so a unit that stands still shows what it is made of.
//!
//! | file | what it has |
//! |---|---|
//! | [`octaves`] | the deviation at τ = Δt, 2Δt, 4Δt …, in 2.3 KB per axis, some ten additions per sample |
//! | `restored` | the sums as words, and whether words can be sums |
//! | [`term`] | the Allan variance of each error term |
//! | [`freedom`] | how many independent differences a point is worth, and with it how well it is known |
//!
//! Source: IEEE Std 952-2020, annex C; Riley & Howe, *Handbook of Frequency Stability Analysis* (NIST SP 1065).
//!
//! ```
//! use schuler::allan::octaves::Octaves;
//! use schuler::allan::term::Term;
//! use schuler::noise::Streams;
//!
//! // A gyro of 0.01 °/√h that stands still, 100 samples a second.
//! let (interval_s, root_s, density) = (0.01_f64, 0.1, 0.01 / 60.0_f64);
//! let mut axis: Octaves<f64> = Octaves::new(interval_s)?;
//! let mut noise = Streams::new(1, 0).open();
//! for _ in 0..100_000 {
//!     axis.add(density * root_s * noise.normal::<f64>())?;
//! }
//! // At 2.56 s the closed form is N/√τ.
//! let point = axis.points().find(|point| point.samples == 256).unwrap();
//! let expected = Term::White(density).variance(point.tau_s).sqrt();
//! // Of that many degrees of freedom the deviation is good to 1/√(2 edf) of itself.
//! let edf = point.freedom(Term::White(density));
//! assert!((point.deviation() / expected - 1.0).abs() < 3.0 / (2.0 * edf).sqrt());
//! # Ok::<(), schuler::allan::octaves::Refused>(())
//! ```

pub mod freedom;
pub mod octaves;
mod restored;
pub mod term;
