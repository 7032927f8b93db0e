//! Paths for other tools.
//!
//! | file | what |
//! |---|---|
//! | [`track`] | a path as maps take it: degrees, cut at the antimeridian |
//! | [`kml`], [`gpx`], [`geojson`] | maps |
//! | [`mcap`] | ROS 2 messages |

pub mod geojson;
pub mod gpx;
pub mod kml;
pub mod mcap;
pub mod track;
