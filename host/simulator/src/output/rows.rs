//! Rows of numbers in memory, as a table's file would have them.

/// Rows under names of columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NumberRows {
    /// The names.
    pub names: Vec<String>,
    /// A number for each column, row by row.
    pub numbers: Vec<f64>,
}

impl NumberRows {
    /// None yet.
    pub fn new<S: AsRef<str>>(names: &[S]) -> Self {
        let names = names.iter().map(|name| name.as_ref().to_owned()).collect();
        Self { names, numbers: Vec::new() }
    }

    /// The next row; it may come in parts.
    pub fn add(&mut self, numbers: &[f64]) {
        self.numbers.extend_from_slice(numbers);
    }

    /// Each row.
    pub fn iter(&self) -> impl Iterator<Item = &[f64]> {
        self.numbers.chunks_exact(self.names.len().max(1))
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.numbers.len() / self.names.len().max(1)
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
