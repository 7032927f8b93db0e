//! Level and north from a vehicle that rotates about its place: velocities in two inertial frames.
//!
//! The specific force integrated in body axes of the start is a curve; at rest on the turning Earth the same curve,
//! in local axes of the start, is known. The rotation that lays one on the other is the attitude at the start. Unlike
//! that of two vectors it holds for a vehicle that turns, and it takes no first attitude. A vehicle that is displaced
//! has velocities of its own, and needs minutes; where they are measured, it needs seconds.
//! Source: Wu and Pan, IEEE Trans. Aerospace and Electronic Systems 49 (2013), 1006 (optimization-based alignment);
//! Davenport's q-method (Wertz, *Spacecraft Attitude Determination and Control*, §12.2.3).
//!
//! ```
//! use schuler::alignment::inertial::Inertial;
//! use schuler::alignment::place::Place;
//! use schuler::earth::Geodetic;
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//!
//! // At 45° N, level, the forward axis 30° east of north.
//! let at = Geodetic { latitude: 45_f64.to_radians(), longitude: 0.0, altitude: 0.0 };
//! let (place, yaw) = (Place::new(at), 30_f64.to_radians());
//! let (level, up) = (place.rate_north, place.rate_up);
//! let rate_b = Vector::new(level * yaw.cos(), -level * yaw.sin(), -up);
//! let force_b = Vector::new(0.0, 0.0, -place.gravity);
//! let mut inertial = Inertial::new(&place);
//! for _ in 0..6000 {
//!     inertial.add(&Increment { angle_b: rate_b * 0.01, velocity_b: force_b * 0.01 }, 0.01);
//! }
//! let attitude = inertial.attitude()?;
//! assert!((attitude.yaw - yaw).abs() < 1e-4 && attitude.roll.abs() < 1e-6);
//! # Ok::<(), schuler::alignment::AlignmentError>(())
//! ```

use super::AlignmentError;
use super::place::Place;
use crate::math::quaternion::Quaternion;
use crate::math::real::Scalar;
use crate::math::vector::Vector;
use crate::sample::Increment;
use crate::solution::Euler;

/// Gathers samples.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Inertial<R> {
    /// ω_ieⁿ, rad/s.
    earth_rate_ned: Vector<R>,
    gravity: R,
    /// Body axes → those at the start.
    body: Quaternion<R>,
    /// Local axes → those at the start, which stand still in inertial space.
    local: Quaternion<R>,
    /// ∫f dt in body axes of the start, ∫−g dt in local ones of the start, m/s.
    felt: Vector<R>,
    known: Vector<R>,
    /// Of a vehicle that moves, its velocity at the start and the last one measured, north, east, down, m/s.
    velocity: Option<[Vector<R>; 2]>,
    /// Σ known knownᵀ at measured velocities, by rows, m²/s².
    spread: [Vector<R>; 3],
    /// Σ known feltᵀ by rows, weighted by time.
    outer: [Vector<R>; 3],
    samples: u32,
}

/// Squarings of Davenport's matrix: its largest eigenvalue then leads by far.
const SQUARINGS: usize = 40;

impl<R: Scalar> Inertial<R> {
    /// At a place.
    pub fn new(place: &Place<R>) -> Self {
        Self {
            earth_rate_ned: Vector::new(place.rate_north, R::ZERO, -place.rate_up),
            gravity: place.gravity,
            body: Quaternion::IDENTITY,
            local: Quaternion::IDENTITY,
            felt: Vector::ZERO,
            known: Vector::ZERO,
            velocity: None,
            spread: [Vector::ZERO; 3],
            outer: [Vector::ZERO; 3],
            samples: 0,
        }
    }

    /// At a place, with a velocity relative to the Earth in north, east and down, m/s, that is
    /// [measured](Self::measure_velocity) from time to time.
    pub fn moving(place: &Place<R>, velocity_ned: Vector<R>) -> Self {
        Self { velocity: Some([velocity_ned; 2]), ..Self::new(place) }
    }

    /// Takes the velocity at the last sample, north, east, down, m/s.
    pub fn measure_velocity(&mut self, velocity_ned: Vector<R>) {
        // ∫Cf dt = [Cv] + ∫C(ω_ie × v − g) dt, with C of the local axes against those of the start
        let [first, last] = self.velocity.get_or_insert([velocity_ned; 2]);
        *last = velocity_ned;
        let gained = self.local.matrix(R::ONE) * velocity_ned - *first;
        let known = self.known + gained;
        for (row, x) in self.spread.iter_mut().zip(known.into_array()) {
            *row = *row + known * x;
        }
        self.compare(known, R::ONE);
    }

    /// How far measured velocities leave a straight line, m/s: those that are good to σ leave σ by it of the rotation
    /// about that line, rad. At a steady acceleration nothing is seen of it.
    pub fn velocity_spread(&self) -> R {
        // Of Σ known knownᵀ the trace less its largest eigenvalue
        let whole = trace(&self.spread);
        if whole > R::ZERO {
            let mut unit = self.spread.map(|row| row * (R::ONE / whole));
            for _ in 0..SQUARINGS {
                let [a, b, c] = unit;
                let square = unit.map(|row| Vector::new(row.dot(a), row.dot(b), row.dot(c)));
                let scale = R::ONE / trace(&square);
                unit = square.map(|row| row * scale);
            }
            // It has become vvᵀ of the eigenvector v, whose eigenvalue is tr(S·vvᵀ).
            let most = self.spread.iter().zip(unit).fold(R::ZERO, |sum, (s, v)| sum + s.dot(v));
            let rest = whole - most;
            return if rest > R::ZERO { rest.sqrt() } else { R::ZERO };
        }
        R::ZERO
    }

    /// Lays the known curve beside the felt one.
    fn compare(&mut self, known: Vector<R>, weight: R) {
        for (row, known) in self.outer.iter_mut().zip(known.into_array()) {
            *row = *row + self.felt * (known * weight);
        }
    }

    /// Adds a sample with its interval in seconds.
    pub fn add(&mut self, sample: &Increment<R>, interval_s: R) {
        // The force turns with the body within the sample: Δv + ½Δθ × Δv.
        let Increment { angle_b, velocity_b } = *sample;
        let force = velocity_b + angle_b.cross(velocity_b) * R::HALF;
        self.felt = self.felt + self.body.matrix(R::ONE) * force;
        self.body = turned(self.body, angle_b);
        let turn = self.earth_rate_ned * interval_s;
        let middle = turned(self.local, turn * R::HALF);
        let up = Vector::new(R::ZERO, R::ZERO, -(self.gravity * interval_s));
        let carried = self.velocity.map_or(Vector::ZERO, |[_, last]| turn.cross(last));
        self.known = self.known + middle.matrix(R::ONE) * (up + carried);
        self.local = turned(self.local, turn);
        if self.velocity.is_none() {
            self.compare(self.known, interval_s);
        }
        self.samples = self.samples.saturating_add(1);
    }

    /// The attitude at the last sample, rad.
    ///
    /// # Errors
    ///
    /// [`AlignmentError`] without samples, or where the curves are straight lines.
    pub fn attitude(&self) -> Result<Euler<R>, AlignmentError> {
        if self.samples == 0 {
            return Err(AlignmentError::Empty);
        }
        let q = self.rotation().ok_or(AlignmentError::Undetermined)?;
        // C_bⁿ = (n → n₀)ᵀ (b₀ → n₀) (b → b₀)
        let attitude = (self.local.conjugate() * (q * self.body)).normalised();
        Ok(Euler::from_quaternion(attitude))
    }

    /// Body axes of the start → local axes of the start: the eigenvector of Davenport's matrix for its largest value.
    fn rotation(&self) -> Option<Quaternion<R>> {
        // K = [tr B, zᵀ; z, B + Bᵀ − tr B·I],  z_i = Σ known × felt by components
        let [a, b, c] = self.outer;
        let trace = a.x + b.y + c.z;
        let (zx, zy, zz) = (c.y - b.z, a.z - c.x, b.x - a.y);
        let (xy, xz, yz) = (a.y + b.x, a.z + c.x, b.z + c.y);
        let two = |x: R| x + x - trace;
        let mut k = [
            [trace, zx, zy, zz],
            [zx, two(a.x), xy, xz],
            [zy, xy, two(b.y), yz],
            [zz, xz, yz, two(c.z)],
        ];
        // Shifted so that the largest eigenvalue is also the largest in magnitude.
        let size = |k: &[[R; 4]; 4]| {
            k.iter().flatten().fold(R::ZERO, |most, x| if x.abs() > most { x.abs() } else { most })
        };
        let most = size(&k);
        if !(most > R::ZERO && most.is_within(R::of(1e30))) {
            return None;
        }
        let shift = most * R::of(4.0);
        for (n, row) in k.iter_mut().enumerate() {
            if let Some(cell) = row.get_mut(n) {
                *cell = *cell + shift;
            }
        }
        for _ in 0..SQUARINGS {
            let scale = R::ONE / size(&k);
            let unit = k.map(|row| row.map(|x| x * scale));
            // A symmetric matrix: its columns are its rows.
            k = unit.map(|row| {
                unit.map(|other| row.iter().zip(&other).fold(R::ZERO, |sum, (x, y)| sum + *x * *y))
            });
        }
        // Every row is along the eigenvector; the longest is taken.
        let length = |row: &[R; 4]| row.iter().fold(R::ZERO, |sum, x| sum + *x * *x);
        let longest = k
            .iter()
            .fold([R::ZERO; 4], |best, row| if length(row) > length(&best) { *row } else { best });
        let norm = length(&longest).sqrt();
        let [w, x, y, z] = longest.map(|component| component / norm);
        norm.is_within(R::of(1e30)).then_some(Quaternion::new(w, Vector::new(x, y, z)))
    }
}

/// q ⊗ (rotation by a small vector).
fn turned<R: Scalar>(q: Quaternion<R>, by: Vector<R>) -> Quaternion<R> {
    // cos ½θ − 1 ≈ −θ²/8 + θ⁴/384,  sin ½θ/θ ≈ ½ − θ²/48
    let square = by.dot(by);
    let w = -(square * R::of(0.125)) + square * square * R::ratio(1, 384);
    let v = by * (R::HALF - square * R::ratio(1, 48));
    (q + q * Quaternion::new(w, v)).normalised()
}

/// The trace of a matrix by rows.
fn trace<R: Scalar>([a, b, c]: &[Vector<R>; 3]) -> R {
    a.x + b.y + c.z
}
