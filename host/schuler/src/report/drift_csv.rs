//! `drift.csv`: a row per sample, or fewer, written as the run goes.

use super::every::Every;
use super::thinned::Thinned;
use schuler_simulator::flight::{Instant, Nine};
use schuler_simulator::input::InputError;
use schuler_simulator::output::{NumberTable, OutputFile};
use std::path::Path;

/// The file's name.
pub const NAME: &str = "drift.csv";

/// A `drift.csv` being written.
#[derive(Debug)]
pub struct DriftCsv {
    table: NumberTable,
    kept: Thinned,
}

impl DriftCsv {
    /// With its header: the time, nine numbers of drift, the standard deviation of each.
    pub fn create(path: &Path, every: Option<Every>) -> Result<Self, InputError> {
        let sigma = Nine::NAMES.map(|name| format!("{name}_sigma"));
        let mut columns = vec!["time_s"];
        columns.extend(Nine::NAMES);
        columns.extend(sigma.iter().map(String::as_str));
        let table = NumberTable::create(path, &columns)?;
        Ok(Self { table, kept: Thinned::new(every, 0.0) })
    }

    /// How many numbers there are in a row, those apart that are zero throughout.
    pub fn columns(is_random: bool) -> usize {
        // Zeros take a fifth of other numbers' room.
        if is_random { 19 } else { 12 }
    }

    /// Takes the next instant: the first is written, the last, and those in between that are wanted.
    pub fn row(&mut self, instant: &Instant) -> Result<(), InputError> {
        if self.kept.keeps(instant) { self.write(instant) } else { Ok(()) }
    }

    /// Time, drift and standard deviations.
    fn write(&mut self, instant: &Instant) -> Result<(), InputError> {
        let Instant { time_s, drift, sigma, .. } = instant;
        self.table.row(&[&[*time_s][..], &drift.numbers(), &sigma.numbers()].concat())
    }

    /// The file, whole, but not in its place yet.
    pub fn into_file(mut self) -> Result<OutputFile, InputError> {
        if let Some(last) = self.kept.last() {
            self.write(&last)?;
        }
        Ok(self.table.into_file())
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
        let mut file = DriftCsv::create(&path, None).unwrap();
        for instant in &written {
            file.row(instant).unwrap();
        }
        file.into_file().unwrap().finish().unwrap();

        let mut reader = csv::Reader::from_path(&path).unwrap();
        let names = "north_m east_m down_m north_m_s east_m_s down_m_s attitude_north_arcsec \
             attitude_east_arcsec attitude_down_arcsec";
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
    fn the_first_and_the_last_row_are_always_there() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("drift.csv");
        // Ten samples a second.
        let times_s = |every, samples: u32| -> Vec<f64> {
            let mut file = DriftCsv::create(&path, every).unwrap();
            for k in 0..=samples {
                let time_s = f64::from(k) / 10.0;
                file.row(&Instant { time_s, ..Instant::default() }).unwrap();
            }
            file.into_file().unwrap().finish().unwrap();
            let text = std::fs::read_to_string(&path).unwrap();
            let time_s = |line: &str| line.split(',').next().unwrap().parse().unwrap();
            text.lines().skip(1).map(time_s).collect()
        };
        assert_eq!(times_s(None, 3), [0.0, 0.1, 0.2, 0.3]);
        assert_eq!(times_s(Some(Every::Rows(4)), 10), [0.0, 0.4, 0.8, 1.0]);
        assert_eq!(times_s(Some(Every::Rows(4)), 8), [0.0, 0.4, 0.8]);
        assert_eq!(times_s(Some(Every::Rows(100)), 8), [0.0, 0.8]);
        assert_eq!(times_s(Some(Every::Seconds(0.5)), 12), [0.0, 0.5, 1.0, 1.2]);
        assert_eq!(times_s(Some(Every::Seconds(0.25)), 6), [0.0, 0.3, 0.5, 0.6]);
        assert_eq!(times_s(Some(Every::Rows(4)), 0), [0.0]);
    }

    #[test]
    fn says_which_file_it_cannot_write() {
        let directory = tempfile::tempdir().unwrap();
        let error = DriftCsv::create(directory.path(), None).unwrap_err();
        assert!(error.to_string().contains(&directory.path().display().to_string()));
    }
}
