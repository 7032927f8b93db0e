//! Every row compared with the first and with what is stored.

use super::golden::Golden;
use super::output::Output;
use super::verdict::{Flight, Matrix, Row, Verdict};

/// Compares every row with the first and with what is stored.
pub fn judged(flown: Vec<(Row, Option<Output>)>, stored: &Golden) -> Matrix {
    let first = flown.iter().find_map(|(_, output)| output.clone());
    let mut rows = Vec::new();
    for (mut row, output) in flown {
        if let (Some(first), Some(output)) = (&first, &output) {
            let is_first = rows.iter().all(|row: &Row| row.digest.is_none());
            row.digest = Some(output.digest());
            row.verdict = Some(match (first.parts(output), stored.parts(output)) {
                (Some(place), _) => Verdict::Parts(place),
                (None, Some(place)) => Verdict::PartsFromGolden(place),
                (None, None) if is_first => Verdict::First,
                (None, None) => Verdict::Equal,
            });
        }
        rows.push(row);
    }
    let ends = first.iter().flat_map(Output::lines).filter(|line| line.sample.starts_with('='));
    let flights = ends.map(|line| Flight {
        flight: line.flight.to_owned(),
        stage: line.stage.to_owned(),
        samples: line.sample.trim_start_matches('=').to_owned(),
        digest: line.digest.to_owned(),
    });
    let flights = flights.collect();
    let digests = first.as_ref().map_or(0, |first| first.lines().count());
    let golden = first.map_or(0, |first| stored.held(&first));
    Matrix { rows, flights, digests, golden }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str =
        "paper/noise noise 64 0000000000000001\npaper/noise noise =70 00000000000000ff\n";

    fn row(target: &'static str, output: Result<&str, Verdict>) -> (Row, Option<Output>) {
        let (text, verdict) = match output {
            Ok(text) => (Some(text), None),
            Err(verdict) => (None, Some(verdict)),
        };
        let row = Row {
            target,
            triple: target.to_owned(),
            compiler: String::new(),
            flags: String::new(),
            runner: String::new(),
            time_s: 0.0,
            digest: None,
            verdict,
        };
        (row, text.map(|text| Output::parse(text.to_owned()).unwrap()))
    }

    #[test]
    fn every_row_is_compared_with_the_first_that_ran() {
        let missing = Verdict::Missing("no qemu".to_owned());
        let other = TEXT.replace("0001", "0002");
        let rows = vec![
            row("a", Err(missing.clone())),
            row("b", Ok(TEXT)),
            row("c", Ok(TEXT)),
            row("d", Ok(&other)),
        ];
        let matrix = judged(rows, &Golden::default());
        let place = "paper/noise, stage noise, by sample 64".to_owned();
        let verdicts: Vec<_> = matrix.rows.iter().map(|row| row.verdict.clone()).collect();
        let expected = [missing, Verdict::First, Verdict::Equal, Verdict::Parts(place)];
        assert_eq!(verdicts, expected.map(Some));
        assert_eq!(matrix.rows[1].digest, matrix.rows[2].digest);
        assert_ne!(matrix.rows[1].digest, matrix.rows[3].digest);
        // One parts, one is missing, and nothing is golden.
        assert_eq!((matrix.equal(), matrix.failed(false), matrix.failed(true)), (2, 1, 3));
        let [flight] = matrix.flights.as_slice() else { panic!("one flight has an end") };
        assert_eq!((flight.samples.as_str(), flight.digest.as_str()), ("70", "00000000000000ff"));
    }

    #[test]
    fn golden_digests_hold_all_rows() {
        let folder = tempfile::tempdir().unwrap();
        let scene = folder.path().join("paper");
        std::fs::create_dir(&scene).unwrap();
        let other = TEXT.replace("00ff", "00fe");
        let write = |at: &str, digest: &str| {
            let text = format!(
                "schuler chain 1\nstage: noise f64 angle\n\nnoise # {at} {digest}\n\
                 noise = 70 00000000000000ff\n"
            );
            std::fs::write(scene.join("noise.chain"), text).unwrap();
            judged(
                vec![row("a", Ok(TEXT)), row("b", Ok(TEXT)), row("c", Ok(&other))],
                &Golden::read(folder.path()).unwrap(),
            )
        };
        let matrix = write("64", "0000000000000001");
        assert_eq!((matrix.golden, matrix.failed(true)), (2, 1));
        // Another spacing: the digest at 64 is not compared with anything.
        let matrix = write("32", "0000000000000001");
        assert_eq!((matrix.golden, matrix.failed(false), matrix.failed(true)), (1, 1, 2));
        let matrix = write("64", "0000000000000003");
        assert_eq!((matrix.golden, matrix.failed(true)), (2, 3));
        let place = "paper/noise, stage noise, by sample 64".to_owned();
        assert_eq!(matrix.rows[1].verdict, Some(Verdict::PartsFromGolden(place)));
        // What parts from the first row is known by that, golden or not.
        let place = "paper/noise, stage noise, by sample 70".to_owned();
        assert_eq!(matrix.rows[2].verdict, Some(Verdict::Parts(place)));
    }

    #[test]
    fn without_golden_chains_not_all_is_there() {
        let folder = tempfile::tempdir().unwrap();
        let stored = Golden::read(&folder.path().join("none")).unwrap();
        let matrix = judged(vec![row("a", Ok(TEXT)), row("b", Ok(TEXT))], &stored);
        assert_eq!((matrix.digests, matrix.golden), (2, 0));
        assert_eq!((matrix.failed(false), matrix.failed(true)), (0, 1));
    }
}
