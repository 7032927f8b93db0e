//! Charts and pages: knows nothing of scenes and flights.
//!
//! A [`chart`] with its [`axis`] and [`grid`] is drawn on a [`canvas`], which is an [`svg`] or a [`raster`]
//! image; a logarithmic axis has [`decades`], many dots [`scatter`]; a [`page`] holds figures and tables in one file.

pub mod axis;
pub mod canvas;
pub mod chart;
pub mod decades;
pub mod decimate;
pub mod grid;
pub mod page;
pub mod raster;
pub mod scatter;
pub mod svg;
