//! `drift.csv`: a row per sample, written as the run goes.

use super::WriteError;
use crate::flight::{Instant, Nine};
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

const HEADER: &str = "time_s,north_m,east_m,down_m,north_m_s,east_m_s,down_m_s,\
    roll_arcsec,pitch_arcsec,yaw_arcsec,north_m_sigma,east_m_sigma,down_m_sigma,\
    north_m_s_sigma,east_m_s_sigma,down_m_s_sigma,\
    roll_arcsec_sigma,pitch_arcsec_sigma,yaw_arcsec_sigma\n";

/// Rows wait here until there are this many bytes.
const BUFFER: usize = 1 << 17;
/// More than a row's 19 numbers of at most 24 characters.
const ROW: usize = 512;

/// A `drift.csv` being written. Numbers are the shortest that read back to the same bits.
#[derive(Debug)]
pub struct DriftCsv {
    path: PathBuf,
    file: File,
    rows: Vec<u8>,
}

impl DriftCsv {
    /// Starts the file with its header; an older one is replaced.
    pub fn create(path: &Path) -> Result<Self, WriteError> {
        let file = File::create(path).map_err(|source| WriteError::new(path, source))?;
        let mut rows = Vec::with_capacity(BUFFER + ROW);
        rows.extend_from_slice(HEADER.as_bytes());
        Ok(Self { path: path.to_owned(), file, rows })
    }

    /// Adds a row: time, drift and standard deviations.
    pub fn row(&mut self, instant: &Instant) -> Result<(), WriteError> {
        let mut digits = zmij::Buffer::new();
        self.rows.extend_from_slice(digits.format(instant.time_s).as_bytes());
        for nine in [&instant.drift, &instant.sigma] {
            let Nine { position_m, velocity_m_s, attitude_arcsec } = nine;
            for value in position_m.iter().chain(velocity_m_s).chain(attitude_arcsec) {
                self.rows.push(b',');
                self.rows.extend_from_slice(digits.format(*value).as_bytes());
            }
        }
        self.rows.push(b'\n');
        if self.rows.len() >= BUFFER { self.flush() } else { Ok(()) }
    }

    /// Writes what is left. A file that is dropped unfinished lacks its last rows.
    pub fn finish(mut self) -> Result<(), WriteError> {
        self.flush()
    }

    fn flush(&mut self) -> Result<(), WriteError> {
        self.file.write_all(&self.rows).map_err(|source| WriteError::new(&self.path, source))?;
        self.rows.clear();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;

    #[test]
    fn reads_back_bit_for_bit() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("drift.csv");
        let mut written = sample::flight().overview;
        written[7].drift.velocity_m_s[1] = -1.234_567_890_123_456_7e-300;
        let mut file = DriftCsv::create(&path).unwrap();
        for instant in &written {
            file.row(instant).unwrap();
        }
        file.finish().unwrap();

        let mut reader = csv::Reader::from_path(&path).unwrap();
        let names =
            "north_m east_m down_m north_m_s east_m_s down_m_s roll_arcsec pitch_arcsec yaw_arcsec";
        let names: Vec<&str> = names.split(' ').collect();
        let header: Vec<String> = ["time_s".to_owned()]
            .into_iter()
            .chain(names.iter().map(|name| (*name).to_owned()))
            .chain(names.iter().map(|name| format!("{name}_sigma")))
            .collect();
        assert_eq!(reader.headers().unwrap().iter().collect::<Vec<_>>(), header);

        let rows: Vec<Vec<f64>> = reader
            .records()
            .map(|row| row.unwrap().iter().map(|cell| cell.parse().unwrap()).collect())
            .collect();
        assert_eq!(rows.len(), written.len());
        for (row, instant) in rows.iter().zip(&written) {
            let Instant { time_s, drift: d, sigma: s, .. } = instant;
            let expected = [
                &[*time_s],
                &d.position_m[..],
                &d.velocity_m_s,
                &d.attitude_arcsec,
                &s.position_m,
                &s.velocity_m_s,
                &s.attitude_arcsec,
            ]
            .concat();
            assert!(row.iter().map(|x| x.to_bits()).eq(expected.iter().map(|x| x.to_bits())));
        }
    }

    #[test]
    fn says_which_file_it_cannot_write() {
        let directory = tempfile::tempdir().unwrap();
        let error = DriftCsv::create(directory.path()).unwrap_err();
        assert!(error.to_string().contains(&directory.path().display().to_string()));
    }
}
