//! Maps and rows that are refused, with their place.

use super::{Sway, table};
use schuler_simulator::recording::foreign::{Columns, parse};

#[test]
fn maps_are_refused_with_their_line_and_key() {
    let whole = "[time]\ncolumn = 1\n[gyro]\ncolumns = [2, 3, 4]\nunit = \"deg/s\"\n[accelerometer]\ncolumns = [5, 6, 7]\nunit = \"g\"\n";
    assert!(parse("map.toml", whole).is_ok());
    for (from, to, start, words) in [
        ("[2, 3, 4]", "[2, 3]", "map.toml:4: gyro.columns: has 2 columns", "three"),
        ("[2, 3, 4]", "[2, 3, 0]", "map.toml:4: gyro.columns[2]: 0 is out of range", "from 1"),
        ("deg/s", "furlong", "map.toml:5: gyro.unit: \"furlong\" is no unit", "deg/s"),
        ("deg/s", "g", "map.toml:5: gyro.unit: \"g\" is no unit of a gyro", "deg/s"),
        (
            "deg/s",
            "deg",
            "map.toml:8: accelerometer.unit: is no unit of such samples",
            "increments",
        ),
        ("column = 1", "colum = 1", "map.toml:2: time.colum: is not a key", "column"),
        ("column = 1", "column = 1\nunit = \"h\"", "map.toml:3: time.unit: \"h\"", "iso8601"),
        ("column = 1", "", "map.toml:1: time.column: is missing", "name"),
        ("[time]\ncolumn = 1\n", "", "map.toml:1: time: is missing", "rate_hz"),
        (
            "[time]",
            "axes = \"forward-left-down\"\n[time]",
            "map.toml:1: axes: \"forward-left-down\" is left-handed",
            "right-forward-up",
        ),
        (
            "[time]",
            "mounting = [[1,0,0],[0,1,0],[0,0,1.001]]\n[time]",
            "map.toml:1: mounting: is no rotation",
            "1e-6",
        ),
        (
            "[time]",
            "mounting = [[1,0,0],[0,1,0],[0,0,-1]]\n[time]",
            "map.toml:1: mounting: is a reflection",
            "rotation",
        ),
        (
            "[time]",
            "delimiter = \"/\"\n[time]",
            "map.toml:1: delimiter: there is no \"/\"",
            "\"tab\"",
        ),
        (
            "[time]",
            "samples = \"increments\"\n[time]",
            "map.toml:6: gyro.unit",
            "per second for rates",
        ),
    ] {
        let message = parse("map.toml", &whole.replacen(from, to, 1)).expect_err(start).to_string();
        assert!(message.starts_with(start), "{message}\nnot {start}");
        assert!(message.contains(words), "{message}\nwithout {words}");
    }
    for wrong in ["1,2,3", "1,2,3,4,5,6,7,8"] {
        assert!(Columns::parse(wrong).expect_err(wrong).to_string().contains("seven"));
    }
}

#[test]
fn rows_are_refused_with_their_line_and_column() {
    let sway = Sway::new();
    let header = "when,gx,gy,gz,ax,ay,az";
    let good = table(header, &sway.rates, |sample| sample.map(|value| value.to_string()).join(","));
    let map = "[time]\ncolumn = \"when\"\nunit = \"s\"\n[gyro]\ncolumns = [\"gx\", \"gy\", \"gz\"]\nunit = \"rad/s\"\n[accelerometer]\ncolumns = [\"ax\", \"ay\", \"az\"]\nunit = \"m/s2\"\n";
    let map_path = sway.write("map.toml", map);
    let lines: Vec<_> = good.lines().collect();
    let with = |change: &dyn Fn(&mut Vec<&str>)| {
        let mut fields: Vec<_> = lines[100].split(',').collect();
        change(&mut fields);
        let row = fields.join(",");
        let mut lines = lines.clone();
        lines[100] = &row;
        lines.join("\n")
    };
    for (text, start, words) in [
        (with(&|row| row[2] = "x"), "log.csv:101: gy: \"x\" is not a finite number", "number"),
        (with(&|row| row[6] = "nan"), "log.csv:101: az: \"nan\"", "finite"),
        (with(&|row| row[0] = ""), "log.csv:101: when: \"\"", "finite"),
        (
            with(&|row| row.truncate(5)),
            "log.csv:101: the row has 5 values",
            "7 or more, for when, gx",
        ),
        (
            good.replace("gy,", "gyro,"),
            "log.csv:1: gy: is no column of the header",
            "when, gx, gyro",
        ),
        (good.replace("gy,", "gx,"), "log.csv:1: gx: is there twice", "a number from 1"),
        (good.replace(header, ""), "log.csv: when: has no header", "number from 1"),
    ] {
        let path = sway.write("log.csv", &text);
        let error = sway.flown(&path, 0.0, &["--map", super::text(&map_path)]).expect_err(start);
        assert!(error.contains(start), "{error}\nnot {start}");
        assert!(error.contains(words), "{error}\nwithout {words}");
    }
    let error = sway.flown(&sway.path("log.csv"), 0.0, &["--map", "euro"]).expect_err("no map");
    assert!(error.contains("--map: there is no \"euro\"") && error.contains("euroc"), "{error}");
}
