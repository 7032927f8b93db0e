//! Charts and pages: knows nothing of scenes and flights.
//!
//! For documents, a [`chart`] with its [`axis`] and [`grid`] is drawn on a [`canvas`], which is an [`svg`] or a [`raster`]
//! image; a logarithmic axis has [`decades`]. For people who work with it, an [`interactive`] chart of [`layer`]s stands in a [`page`], which holds
//! figures and tables in one file: its numbers are [`packed`], and what is dense is an [`envelope`].

pub mod axis;
pub mod canvas;
pub mod chart;
pub mod decades;
pub mod decimate;
pub mod ellipse;
pub mod envelope;
pub mod grid;
pub mod interactive;
pub mod layer;
pub mod packed;
pub mod page;
pub mod raster;
pub mod svg;
