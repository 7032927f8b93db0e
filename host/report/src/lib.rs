//! Charts and pages: knows nothing of scenes and flights.
//!
//! A [`chart`] with its [`axis`] is drawn on a [`canvas`], which is an [`svg`] or a [`raster`] image; a
//! [`page`] holds figures and tables in one file.

pub mod axis;
pub mod canvas;
pub mod chart;
pub mod decimate;
pub mod page;
pub mod raster;
pub mod svg;
