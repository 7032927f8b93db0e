//! `drift.csv`: a row per sample, written as the run goes.

use crate::flight::{Instant, Nine};
use crate::input::InputError;
use crate::output::NumberTable;
use std::path::Path;

/// A `drift.csv` being written.
#[derive(Debug)]
pub struct DriftCsv {
    table: NumberTable,
}

impl DriftCsv {
    /// With its header: the time, nine numbers of drift, the standard deviation of each.
    pub fn create(path: &Path) -> Result<Self, InputError> {
        let sigma = Nine::NAMES.map(|name| format!("{name}_sigma"));
        let mut columns = vec!["time_s"];
        columns.extend(Nine::NAMES);
        columns.extend(sigma.iter().map(String::as_str));
        Ok(Self { table: NumberTable::create(path, &columns)? })
    }

    /// Adds a row: time, drift and standard deviations.
    pub fn row(&mut self, instant: &Instant) -> Result<(), InputError> {
        let Instant { time_s, drift, sigma, .. } = instant;
        self.table.row(&[&[*time_s][..], &drift.numbers(), &sigma.numbers()].concat())
    }

    /// Puts the file in its place.
    pub fn finish(self) -> Result<(), InputError> {
        self.table.finish()
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
