//! Scenes: built-in ones, files, TOML texts and dicts.

use crate::error::Answer;
use crate::log::Logs;
use crate::options::Options;
use crate::toml;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};
use schuler_simulator::input::document::did_you_mean;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::scene::{self, builtin, parse};
use std::path::PathBuf;

/// A scene that has been read and checked.
#[pyclass(frozen, module = "schuler")]
pub struct Scene {
    /// The simulator's.
    pub scene: scene::Scene,
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (source=None, **options))]
    fn new(source: Option<&Bound<'_, PyAny>>, options: Option<&Bound<'_, PyDict>>) -> Answer<Self> {
        Ok(Self { scene: of(source, options)? })
    }

    #[getter]
    fn name(&self) -> &str {
        &self.scene.name
    }

    #[getter]
    fn title(&self) -> &str {
        &self.scene.title
    }

    #[getter]
    fn sha256(&self) -> &str {
        &self.scene.text_sha256
    }

    #[getter]
    fn duration_s(&self) -> f64 {
        self.scene.duration_s
    }

    #[getter]
    fn rate_hz(&self) -> f64 {
        self.scene.rate_hz
    }

    #[getter]
    fn seed(&self) -> u64 {
        self.scene.seed
    }

    #[getter]
    fn samples(&self) -> u64 {
        self.scene.samples()
    }

    fn __repr__(&self) -> String {
        let scene = &self.scene;
        let (seconds, rate_hz) = (scene.duration_s, scene.rate_hz);
        format!("<schuler.Scene {}: {seconds} s at {rate_hz} Hz, {}>", scene.name, scene.title)
    }
}

/// The scene that is meant, with what replaces its values.
pub fn of(
    source: Option<&Bound<'_, PyAny>>,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<scene::Scene> {
    let options = Options::new(options)?;
    let mut scene = match source {
        None => scene::load(builtin::DEFAULT)?,
        Some(source) => read(source)?,
    };
    options.apply(&mut scene)?;
    Ok(scene)
}

fn read(source: &Bound<'_, PyAny>) -> Answer<scene::Scene> {
    if let Ok(scene) = source.cast::<Scene>() {
        return Ok(scene.get().scene.clone());
    }
    if let Ok(text) = source.extract::<String>() {
        let is_text = text.contains(['\n', '=']);
        let scene = if is_text { parse::scene("scene.toml", &text)? } else { scene::load(&text)? };
        return Ok(scene);
    }
    if let Ok(table) = source.cast::<PyMapping>() {
        return of_table(table);
    }
    if let Ok(path) = source.extract::<PathBuf>() {
        // A name without a dot may be a file's, too.
        let path = PathBuf::from(".").join(path);
        return Ok(scene::load(&path.to_string_lossy())?);
    }
    let text = format!(
        "a scene is a name, a path, a TOML text, a dict or a Scene, not a {}",
        source.get_type().name()?
    );
    Err(PyTypeError::new_err(text).into())
}

/// The scene of a dict, whose keys are those of a file. Errors name the key alone.
pub fn of_table(table: &Bound<'_, PyMapping>) -> Answer<scene::Scene> {
    let mut logs = Logs::default();
    let text = toml::document(table, &mut logs)?;
    let file = "scene";
    let mut scene = parse::scene(file, &text).map_err(|mut error| {
        if error.file.as_deref() == Some(file) {
            (error.file, error.line) = (None, None);
        }
        logs.told(error)
    })?;
    logs.rename(&mut scene);
    Ok(scene)
}

/// Every built-in name with a line about it.
#[pyfunction]
pub fn scenes(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let names = PyDict::new(py);
    for (name, title) in builtin::names() {
        names.set_item(name, title)?;
    }
    Ok(names)
}

/// The text of a built-in scene, to start from.
#[pyfunction]
pub fn scene_text(name: &str) -> Answer<&'static str> {
    let text = builtin::text(name).ok_or_else(|| {
        let names: Vec<_> = builtin::names().map(|(name, _)| name).collect();
        let what = format!("there is no such scene{}", did_you_mean(name, &names));
        InputError::option(name, Complaint::new(what, builtin::list()))
    })?;
    Ok(text)
}
