//! The Python package `schuler`: the commands of the program as functions, with numpy arrays in and out.
//!
//! | file | what it has |
//! |---|---|
//! | `run`, `emulate`, `replay`, `ensemble`, `allan`, `align` | the commands, each a function |
//! | `aided_ensemble` | what `ensemble` is of an aided scene |
//! | `scene`, `options`, `toml`, `log` | scenes: names, files, texts, dicts; what replaces their values |
//! | `trajectory`, `navigator`, `flying`, `state` | a motion, a navigator sample by sample, where it starts and is |
//! | `steps` | every step of a navigator, in bits |
//! | `table`, `arrays`, `recorded`, `fixes` | numbers by rows and columns, samples in arrays, a recorded stream, what aids it |
//! | `aiding`, `aided` | options about measurements, and what becomes of those |
//! | `error`, `interrupt`, `notebook` | exceptions, Ctrl-C, pages in a notebook |
//!
//! The interpreter is released while anything is flown, and no state is shared between calls.
#![cfg(feature = "module")]

mod aided;
mod aided_ensemble;
mod aiding;
mod align;
mod allan;
mod arrays;
mod emulate;
mod ensemble;
mod error;
mod fixes;
mod flying;
mod interrupt;
mod log;
mod navigator;
mod notebook;
mod options;
mod recorded;
mod replay;
mod run;
mod scene;
mod state;
mod steps;
mod table;
mod toml;
mod trajectory;

use pyo3::prelude::*;

/// What `schuler` re-exports.
#[pymodule(gil_used = false)]
mod _schuler {
    use super::*;

    #[pymodule_export]
    use super::aided::Aided;
    #[pymodule_export]
    use super::aided_ensemble::{AidedEnsemble, aided_ensemble};
    #[pymodule_export]
    use super::align::{Aligned, align};
    #[pymodule_export]
    use super::allan::{Allan, allan, datasheet};
    #[pymodule_export]
    use super::emulate::{Emulation, emulate};
    #[pymodule_export]
    use super::ensemble::{Ensemble, ensemble};
    #[pymodule_export]
    use super::navigator::{Navigator, navigators};
    #[pymodule_export]
    use super::replay::{Replay, replay};
    #[pymodule_export]
    use super::run::{Flight, run};
    #[pymodule_export]
    use super::scene::{Scene, scene_text, scenes};
    #[pymodule_export]
    use super::state::State;
    #[pymodule_export]
    use super::steps::{Steps, steps};
    #[pymodule_export]
    use super::table::Table;
    #[pymodule_export]
    use super::trajectory::Trajectory;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
