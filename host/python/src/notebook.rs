//! Pages in a notebook, and summaries as dicts.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use schuler_report::svg::escape;

/// A page as the content of a cell: in a frame of its own, so that neither's style or script reaches the other.
pub fn framed(page: &str) -> String {
    format!(
        "<iframe srcdoc=\"{}\" style=\"width: 100%; height: 52rem; border: 0\"></iframe>",
        escape(page)
    )
}

/// A summary as a dict, without the command line and the files of the program.
pub fn summary<'py>(py: Python<'py>, json: &str) -> PyResult<Bound<'py, PyDict>> {
    let tree = py.import("json")?.call_method1("loads", (json,))?;
    let tree = tree.cast_into::<PyDict>()?;
    for key in ["command", "files"] {
        if tree.contains(key)? {
            tree.del_item(key)?;
        }
    }
    Ok(tree)
}
