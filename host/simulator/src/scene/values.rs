//! What an error term of a scene takes: a number for each axis, or a matrix with a row for each sensor.

/// Values in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Values {
    /// One for each of x, y, z.
    Axes([f64; 3]),
    /// A row for each sensor, its parts along body x, y, z.
    Rows([[f64; 3]; 3]),
}

impl Values {
    /// For each axis; of a matrix, its diagonal.
    pub fn axes(self) -> [f64; 3] {
        match self {
            Self::Axes(axes) => axes,
            Self::Rows([[x, ..], [_, y, _], [.., z]]) => [x, y, z],
        }
    }

    /// As a matrix: numbers for axes are its diagonal.
    pub fn rows(self) -> [[f64; 3]; 3] {
        match self {
            Self::Axes([x, y, z]) => [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]],
            Self::Rows(rows) => rows,
        }
    }

    /// The same function of each.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::Axes(axes) => Self::Axes(axes.map(f)),
            Self::Rows(rows) => Self::Rows(rows.map(|row| row.map(&f))),
        }
    }

    /// Whether all of them are 0.
    pub fn are_zero(self) -> bool {
        self.rows().as_flattened().iter().all(|x| *x == 0.0)
    }

    /// As a file writes them, given how it writes a number.
    pub fn written(self, number: impl Fn(f64) -> String) -> String {
        let list = |values: [f64; 3]| format!("[{}]", values.map(&number).join(", "));
        match self {
            Self::Axes([x, y, z]) if x == y && y == z => number(x),
            Self::Axes(axes) => list(axes),
            Self::Rows(rows) => format!("[{}]", rows.map(list).join(", ")),
        }
    }
}
