//! How the files of an audit name the navigators that it flies.

use super::chain::Width;
use schuler::flight::configuration::{Configuration, Precision};

/// How the files of an audit name a navigator.
pub trait Named {
    /// As people read it: `f32 local-level taylor 0,4,0`.
    fn title(&self) -> String;
    /// As files are named: `f32-local-level-taylor-0-4-0`.
    fn stem(&self) -> String;
    /// The type of its words.
    fn width(&self) -> Width;
}

impl Named for Configuration {
    fn title(&self) -> String {
        self.to_string()
    }

    fn stem(&self) -> String {
        self.to_string().replace([' ', ','], "-")
    }

    fn width(&self) -> Width {
        match self.precision {
            Precision::F64 => Width::Double,
            Precision::F32 | Precision::F32x2 => Width::Single,
        }
    }
}
