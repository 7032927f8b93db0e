//! ROS 2 messages of `run`, `emulate` and `replay`, read back: the numbers of the tables beside them.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

fn schuler(folder: &Path, line: &str) -> (bool, String) {
    let mut program = Command::new(env!("CARGO_BIN_EXE_schuler"));
    let out = program.current_dir(folder).args(line.split_whitespace()).output();
    let out = out.expect("the program starts");
    let text = [out.stdout, out.stderr].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
    (out.status.success(), text.concat())
}

fn done(folder: &Path, line: &str) {
    let (done, text) = schuler(folder, line);
    assert!(done, "{line}: {text}");
}

fn table(folder: &Path, name: &str) -> Vec<Vec<f64>> {
    let text = std::fs::read_to_string(folder.join(name)).expect("it was written");
    let row = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    text.lines().skip(1).map(row).collect()
}

/// Times, s, and data of the messages of each topic.
type Messages = BTreeMap<String, Vec<(f64, Vec<u8>)>>;

fn messages(folder: &Path, name: &str) -> Messages {
    let bytes = std::fs::read(folder.join(name)).expect("it was written");
    let mut messages = Messages::new();
    for message in mcap::MessageStream::new(&bytes).expect("an MCAP file") {
        let message = message.expect("a message");
        let time_s = message.log_time as f64 / 1e9;
        let topic = messages.entry(message.channel.topic.clone()).or_default();
        assert_eq!(message.sequence as usize, topic.len());
        topic.push((time_s, message.data.to_vec()));
    }
    let summary = mcap::Summary::read(&bytes).expect("an index").expect("an index");
    let counted = summary.stats.expect("statistics").message_count;
    assert_eq!(counted as usize, messages.values().map(Vec::len).sum::<usize>());
    messages
}

fn numbers<const N: usize>(data: &[u8], from: usize) -> [f64; N] {
    std::array::from_fn(|i| {
        let at = from + 8 * i;
        f64::from_le_bytes(data[at..at + 8].try_into().expect("eight bytes"))
    })
}

/// The places of a topic are those of a table with the columns of nav.csv.
fn check_fixes(messages: &Messages, topic: &str, rows: &[Vec<f64>]) {
    let fixes = &messages[topic];
    assert_eq!(fixes.len(), rows.len(), "{topic}");
    for ((time_s, data), row) in fixes.iter().zip(rows) {
        assert!((time_s - row[0]).abs() < 1e-9, "{topic}: {time_s} {}", row[0]);
        // Behind the head, the stamp, "base_link", status and service.
        assert_eq!(numbers(data, 36), [row[1], row[2], row[3]], "{topic} at {time_s}");
    }
    assert_eq!(messages[&topic.replace("fix", "pose")].len(), rows.len());
}

/// The means over samples of a length, s, are the increments of imu.csv.
fn check_samples(messages: &Messages, rows: &[Vec<f64>], interval_s: f64) {
    let samples = &messages["/imu"];
    assert_eq!(samples.len(), rows.len());
    for ((time_s, data), row) in samples.iter().zip(rows) {
        assert!((time_s - row[0]).abs() < 1e-9);
        // Behind the orientation and its covariance, which says that it is not known.
        let [unknown] = numbers(data, 28 + 8 * 4);
        assert_eq!(unknown, -1.0);
        let ([a, b, c], [d, e, f]) = (numbers(data, 28 + 8 * 13), numbers(data, 28 + 8 * 25));
        for (mean, whole) in [a, -b, -c, d, -e, -f].into_iter().zip(&row[1..]) {
            assert!((mean * interval_s - whole).abs() <= 1e-15 * whole.abs(), "{mean} {whole}");
        }
    }
}

#[test]
fn messages_have_the_numbers_of_the_tables() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    // Across the antimeridian, with every tenth row.
    let flight = "drive --rate 100 --duration 20";
    let line = format!("run {flight} --out o --no-report --rows --every 10 --mcap o/run.mcap");
    done(folder, &line);
    done(folder, &format!("emulate {flight} --out imu.csv --truth truth.csv --mcap emulate.mcap"));
    let replay = "replay --imu imu.csv --initial initial.toml --out again.csv --mcap again.mcap";
    done(folder, replay);

    let run = messages(folder, "o/run.mcap");
    assert_eq!(run.len(), 5);
    check_fixes(&run, "/truth/fix", &table(folder, "o/truth.csv"));
    check_fixes(&run, "/computed/fix", &table(folder, "o/nav.csv"));
    check_samples(&run, &table(folder, "imu.csv"), 0.01);
    let emulate = messages(folder, "emulate.mcap");
    assert_eq!(emulate.len(), 3);
    check_fixes(&emulate, "/truth/fix", &table(folder, "truth.csv"));
    assert_eq!(emulate["/imu"], run["/imu"]);
    let again = messages(folder, "again.mcap");
    assert_eq!(again.len(), 2);
    check_fixes(&again, "/computed/fix", &table(folder, "again.csv"));
}

#[test]
fn samples_that_the_link_loses_have_no_message() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = "duration_s = 5\nrate_hz = 100\n[trajectory]\n[link]\nloss = 0.1\n";
    std::fs::write(folder.path().join("lossy.toml"), scene).expect("it can be written");
    done(folder.path(), "emulate lossy.toml --out imu.csv --mcap emulate.mcap");
    done(folder.path(), "run lossy.toml --gap bridge --no-report --out o --mcap run.mcap");
    let [emulate, run] = ["emulate.mcap", "run.mcap"].map(|name| messages(folder.path(), name));
    let rows = table(folder.path(), "imu.csv").len();
    assert!((400..490).contains(&rows), "{rows}");
    assert_eq!([emulate["/imu"].len(), run["/imu"].len()], [rows; 2]);
    assert_eq!(run["/truth/fix"].len(), 501);
}

#[test]
fn no_messages_are_written_over_another_file() {
    let folder = tempfile::tempdir().expect("a folder");
    for (line, expected) in [
        ("run --duration 1 --out o --mcap o/drift.csv", "--out writes"),
        ("emulate --duration 1 --out imu.csv --mcap imu.csv", "--out writes"),
        ("emulate --duration 1 --out imu.csv --mcap initial.toml", "initial.toml"),
        ("replay --imu a.csv --out nav.csv --mcap a.csv", "--imu reads"),
    ] {
        let (done, text) = schuler(folder.path(), line);
        assert!(!done && text.contains("--mcap") && text.contains(expected), "{line}: {text}");
        assert!(text.contains("is the file that"), "{line}: {text}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 0);
}
