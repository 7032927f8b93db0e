//! How a unit sits in its vehicle: from the unit's own axes to forward, right, down.

use crate::input::Complaint;
use schuler::math::vector::Vector;

/// How far from a rotation a mounting may be, as the largest element of MᵀM − 1.
const ROTATION: f64 = 1e-6;
/// What `--axes` takes, for people.
const ACCEPTED: &str = "where x, y and z of the unit point, as in forward-right-down, forward-left-up or \
    right-forward-up: one each of forward or backward, right or left, down or up, right-handed";

/// A rotation from a unit's axes to forward, right, down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mounting {
    /// The rows of the matrix M of x_b = M x_unit.
    rows: [Vector<f64>; 3],
}

impl Mounting {
    /// Axes that are forward, right, down already.
    pub const FORWARD_RIGHT_DOWN: Self = Self {
        rows: [
            Vector { x: 1.0, y: 0.0, z: 0.0 },
            Vector { x: 0.0, y: 1.0, z: 0.0 },
            Vector { x: 0.0, y: 0.0, z: 1.0 },
        ],
    };

    /// From where x, y and z of the unit point: words with hyphens between, or their three initials.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let wrong = |what: String| Complaint::new(what, ACCEPTED);
        let lower = text.to_ascii_lowercase();
        let letters = || lower.char_indices().map(|(i, c)| &lower[i..i + c.len_utf8()]).collect();
        let words: Vec<&str> =
            if lower.contains('-') { lower.split('-').collect() } else { letters() };
        let [x, y, z] = words[..] else {
            return Err(wrong(format!("\"{text}\" does not name three axes")));
        };
        let axis = |word: &str| -> Result<[f64; 3], Complaint> {
            match word {
                "forward" | "f" => Ok([1.0, 0.0, 0.0]),
                "backward" | "back" | "b" => Ok([-1.0, 0.0, 0.0]),
                "right" | "r" => Ok([0.0, 1.0, 0.0]),
                "left" | "l" => Ok([0.0, -1.0, 0.0]),
                "down" | "d" => Ok([0.0, 0.0, 1.0]),
                "up" | "u" => Ok([0.0, 0.0, -1.0]),
                _ => Err(wrong(format!("\"{word}\" is no direction"))),
            }
        };
        // What x, y, z point at are the matrix's columns.
        let columns = [axis(x)?, axis(y)?, axis(z)?];
        let row = |i: usize| columns.map(|column| column[i]);
        Self::new([row(0), row(1), row(2)]).map_err(|_| {
            let [a, b, c] = columns.map(|[x, y, z]| Vector::new(x, y, z));
            let what = if a.cross(b).dot(c) == 0.0 {
                format!("\"{text}\" names a direction twice")
            } else {
                format!("\"{text}\" is left-handed")
            };
            wrong(what)
        })
    }

    /// From the rows of its matrix.
    pub fn new(rows: [[f64; 3]; 3]) -> Result<Self, Complaint> {
        let rows = rows.map(|[x, y, z]| Vector::new(x, y, z));
        let [a, b, c] = rows;
        let accepted = "three rows of a rotation to forward, right, down, good to 1e-6";
        let products =
            [a.dot(a) - 1.0, b.dot(b) - 1.0, c.dot(c) - 1.0, a.dot(b), b.dot(c), c.dot(a)];
        let off = products.into_iter().fold(0.0, |most: f64, product| most.max(product.abs()));
        if off.is_nan() || off > ROTATION {
            let what =
                format!("is no rotation: its rows are off from unit and upright by {off:.1e}");
            return Err(Complaint::new(what, accepted));
        }
        if a.cross(b).dot(c) < 0.0 {
            return Err(Complaint::new("is a reflection, not a rotation", accepted));
        }
        Ok(Self { rows })
    }

    /// A vector in forward, right, down.
    pub fn turn(&self, vector: Vector<f64>) -> Vector<f64> {
        let [x, y, z] = self.rows.map(|row| row.dot(vector));
        Vector::new(x, y, z)
    }
}
