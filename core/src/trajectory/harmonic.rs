//! The paper's trajectory, generalised: every channel is offset + rate·t + a sum of harmonics.
//!
//! Equations (1) and (2) of the paper, with more than one harmonic per channel. Harmonics of one
//! frequency are evaluated once for all channels; a channel without harmonics costs a product and a sum.
//!
//! ```
//! use schuler::trajectory::harmonic::{Channel, Channels, Harmonic, HarmonicTrajectory};
//! use schuler::trajectory::Trajectory;
//!
//! let fixed = |offset| Channel { offset, rate: 0.0, harmonics: &[] };
//! let swing = [Harmonic { amplitude: 0.1_f64, angular_rate: 2.0, phase: 0.0 }];
//! let flight = HarmonicTrajectory::<f64, 1>::new(Channels {
//!     roll: Channel { harmonics: &swing, ..fixed(0.0) },
//!     pitch: fixed(0.0),
//!     yaw: Channel { rate: 0.01, ..fixed(0.0) },
//!     latitude: fixed(0.8),
//!     longitude: fixed(0.1),
//!     altitude: fixed(100.0),
//! })?;
//! let motion = flight.at(0.0);
//! assert_eq!((motion.roll.value, motion.yaw.first), (0.1, 0.01));
//! # Ok::<(), schuler::trajectory::harmonic::CourseError>(())
//! ```

use super::{Bound, Jet, Motion, Trajectory};
use crate::earth::SEMI_MAJOR_AXIS;
use crate::math::compensated::{Pair, two_product};
use crate::math::real::{Real, Scalar};
use core::f64::consts::{PI, TAU};
use heapless::Vec;

/// Number of channels that are angles: all but the last, the altitude.
const ANGLES: usize = 5;

/// amplitude · cos(angular_rate · t + phase).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Harmonic<R> {
    /// In the channel's unit: rad, or m.
    pub amplitude: R,
    /// ω = 2π/period, rad/s.
    pub angular_rate: R,
    /// At t = 0, rad.
    pub phase: R,
}

/// One channel: offset + rate·t + Σ harmonics. Angles in rad, altitude in m.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Channel<'a, R> {
    /// The mean value.
    pub offset: R,
    /// A steady rate, per second.
    pub rate: R,
    /// The oscillations about it.
    pub harmonics: &'a [Harmonic<R>],
}

impl<R: Scalar> Channel<'_, R> {
    /// A channel that stays at a value, rad or m.
    ///
    /// ```
    /// use schuler::trajectory::harmonic::Channel;
    ///
    /// let altitude = Channel::constant(120.0);
    /// assert_eq!((altitude.offset, altitude.rate), (120.0, 0.0));
    /// ```
    pub const fn constant(value: R) -> Self {
        Self::steady(value, R::ZERO)
    }

    /// A channel that changes at a steady rate per second.
    pub const fn steady(offset: R, rate: R) -> Self {
        Self { offset, rate, harmonics: &[] }
    }
}

/// The six channels in order.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Channels<'a, R> {
    /// Roll γ, rad.
    pub roll: Channel<'a, R>,
    /// Pitch θ, rad.
    pub pitch: Channel<'a, R>,
    /// Yaw ψ, rad.
    pub yaw: Channel<'a, R>,
    /// Latitude φ, rad.
    pub latitude: Channel<'a, R>,
    /// Longitude λ, rad.
    pub longitude: Channel<'a, R>,
    /// Altitude h, m.
    pub altitude: Channel<'a, R>,
}

/// Why a trajectory cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum CourseError {
    /// More harmonics than the trajectory has room for.
    TooManyHarmonics {
        /// The number of harmonics that there is room for, over all channels.
        room: usize,
    },
    /// A number of this channel is not finite, or too large for a rate to be finite.
    NotFinite {
        /// Its index among the [`Channels`], from 0.
        channel: usize,
    },
}

impl core::fmt::Display for CourseError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::TooManyHarmonics { room } => {
                write!(f, "the trajectory has room for {room} harmonics")
            }
            Self::NotFinite { channel } => {
                const NAMES: [&str; 6] =
                    ["roll", "pitch", "yaw", "latitude", "longitude", "altitude"];
                let name = NAMES.get(*channel).unwrap_or(&"");
                write!(f, "the {name} of the trajectory must be finite, its rate too")
            }
        }
    }
}

impl core::error::Error for CourseError {}

/// A channel's share of one tone: cosine·cos ωt + sine·sin ωt.
#[derive(Clone, Copy, Debug)]
struct Share<R> {
    tone: usize,
    channel: usize,
    cosine: R,
    sine: R,
}

/// A trajectory of harmonic channels, with room for `N` harmonics over all of them.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HarmonicTrajectory<R, const N: usize> {
    offset: [R; 6],
    rate: [R; 6],
    tones: Vec<R, N>,
    shares: Vec<Share<R>, N>,
    bound: Bound<R>,
}

impl<R: Scalar, const N: usize> HarmonicTrajectory<R, N> {
    /// From its channels.
    ///
    /// # Errors
    ///
    /// [`CourseError`] if there are more than `N` harmonics, or a number is not finite.
    pub fn new(channels: Channels<'_, R>) -> Result<Self, CourseError> {
        let full = CourseError::TooManyHarmonics { room: N };
        let Channels { roll, pitch, yaw, latitude, longitude, altitude } = channels;
        let channels = [roll, pitch, yaw, latitude, longitude, altitude];
        let mut this = Self {
            offset: channels.map(|c| c.offset),
            rate: channels.map(|c| c.rate),
            tones: Vec::new(),
            shares: Vec::new(),
            bound: Bound::default(),
        };
        for (channel, description) in channels.iter().enumerate() {
            for harmonic in description.harmonics {
                let tone = match this.tones.iter().position(|&w| w == harmonic.angular_rate) {
                    Some(tone) => tone,
                    None => {
                        this.tones.push(harmonic.angular_rate).map_err(|_| full)?;
                        this.tones.len() - 1
                    }
                };
                // A cos(ωt + φ) = A cosφ · cos ωt − A sinφ · sin ωt
                let (s, c) = harmonic.phase.sin_cos();
                let cosine = harmonic.amplitude * c;
                let sine = -(harmonic.amplitude * s);
                this.shares.push(Share { tone, channel, cosine, sine }).map_err(|_| full)?;
            }
        }
        this.bound = bound(&channels)?;
        Ok(this)
    }
}

/// Bounds from the channels' amplitudes and frequencies.
fn bound<R: Scalar>(channels: &[Channel<'_, R>; 6]) -> Result<Bound<R>, CourseError> {
    let mut fastest = R::ZERO;
    let mut greatest_rate = [R::ZERO; 6];
    for ((index, channel), rate) in channels.iter().enumerate().zip(&mut greatest_rate) {
        *rate = channel.rate.abs();
        // Infinity and NaN times zero are NaN.
        let mut zero = channel.offset * R::ZERO;
        for h in channel.harmonics {
            zero = zero + (h.amplitude + h.angular_rate + h.phase) * R::ZERO;
            *rate = *rate + (h.amplitude * h.angular_rate).abs();
            let w = if h.amplitude == R::ZERO { R::ZERO } else { h.angular_rate.abs() };
            fastest = if fastest < w { w } else { fastest };
        }
        if zero + *rate * R::ZERO != R::ZERO {
            return Err(CourseError::NotFinite { channel: index });
        }
    }
    let [roll, pitch, yaw, latitude, longitude, altitude] = greatest_rate;
    let turning = roll + pitch + yaw;
    let earth = R::of(crate::earth::ROTATION_RATE);
    Ok(Bound {
        // Products of two harmonics reach twice the highest frequency, rotated by the attitude; gravity and the
        // transport rate contain sines of up to four times the latitude, and powers of the
        // altitude over the Earth's radius: dᵏγ/dtᵏ = (k + 1)!(−ḣ/a)ᵏ γ < (4ḣ/a)ᵏ γ, k < 6.
        bandwidth: fastest
            + fastest
            + turning
            + R::of(4.0) * (latitude + altitude / R::of(SEMI_MAJOR_AXIS)),
        angular_rate: turning + earth + latitude + longitude,
    })
}

/// rate·t wrapped to ±π, rad, correct to the last digit of its size.
#[inline(always)]
fn turned<R: Real>(rate: R, time_s: Pair<R>) -> R {
    let (steady, rest) = two_product(rate, time_s.hi);
    let turns = (steady / R::of(TAU)).round();
    // 2π as a rounded number and its remainder: for many turns, both count.
    let (whole, dropped) = two_product(turns, R::of(TAU));
    let low = turns * R::entry(-1.748_455_6e-7, 2.449_293_598_294_706_4e-16);
    (steady - whole) + (rest + rate * time_s.lo - dropped - low)
}

impl<R: Scalar, const N: usize> HarmonicTrajectory<R, N> {
    /// The motion at several times, one in each lane of a pack; `number` makes a pack of a number.
    #[inline(always)]
    pub fn at_instants<P: Real>(&self, time_s: Pair<P>, number: impl Fn(R) -> P) -> Motion<P> {
        let (mut value, mut first, mut second) = ([P::ZERO; 6], [P::ZERO; 6], [P::ZERO; 6]);
        let channels = value.iter_mut().zip(&mut first).zip(self.offset.iter().zip(&self.rate));
        for (channel, ((value, first), (&offset, &rate))) in channels.enumerate() {
            let (offset, rate) = (number(offset), number(rate));
            let steady = rate * time_s.hi;
            let far = P::of(PI).less(steady.abs());
            let plain = steady + rate * time_s.lo;
            let turned = channel < ANGLES && P::any(far);
            *value = offset
                + if turned { P::select(far, self::turned(rate, time_s), plain) } else { plain };
            *first = rate;
        }
        for (tone, &w) in self.tones.iter().enumerate() {
            // The remainder of the phase, which after a day of vibration is a millionth of a
            // turn: sin(x + e) = sin x + e cos x
            let w = number(w);
            let (phase, rest) = two_product(w, time_s.hi);
            let rest = rest + w * time_s.lo;
            let (s, c) = phase.sin_cos();
            let (s, c) = (s + rest * c, c - rest * s);
            for share in self.shares.iter().filter(|share| share.tone == tone) {
                let (cosine, sine) = (number(share.cosine), number(share.sine));
                let in_phase = cosine * c + sine * s;
                let quadrature = sine * c - cosine * s;
                // x = a cos ωt + b sin ωt,  ẋ = ω(b cos ωt − a sin ωt),  ẍ = −ω²x
                if let (Some(x), Some(xd), Some(xdd)) = (
                    value.get_mut(share.channel),
                    first.get_mut(share.channel),
                    second.get_mut(share.channel),
                ) {
                    *x = *x + in_phase;
                    *xd = *xd + w * quadrature;
                    *xdd = *xdd - w * w * in_phase;
                }
            }
        }
        Motion {
            roll: Jet { value: value[0], first: first[0], second: second[0] },
            pitch: Jet { value: value[1], first: first[1], second: second[1] },
            yaw: Jet { value: value[2], first: first[2], second: second[2] },
            latitude: Jet { value: value[3], first: first[3], second: second[3] },
            longitude: Jet { value: value[4], first: first[4], second: second[4] },
            altitude: Jet { value: value[5], first: first[5], second: second[5] },
        }
    }
}

impl<R: Scalar, const N: usize> Trajectory<R> for HarmonicTrajectory<R, N> {
    #[inline]
    fn at_instant(&self, time_s: Pair<R>) -> Motion<R> {
        self.at_instants(time_s, |x| x)
    }

    fn bound(&self) -> Bound<R> {
        self.bound
    }
}
