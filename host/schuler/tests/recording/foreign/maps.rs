//! Maps and options: columns, units, times, axes, known errors, and what they may not say.

use super::{Sample, Sway, alike, left_up, nanoseconds, opened, table};
use schuler_simulator::recording::foreign::Given;
use schuler_simulator::recording::mounting::Mounting;

const G: f64 = 9.80665;
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Seven columns, time first, gyros before accelerometers.
fn plain(samples: &[Sample], time: impl Fn(f64) -> String) -> String {
    table("", samples, |[t, x, y, z, u, v, w]| format!("{},{x},{y},{z},{u},{v},{w}", time(t)))
}

#[test]
fn a_map_says_it_all() {
    let sway = Sway::new();
    // The unit is turned by 30° about its z axis, which points down; it reads too much by known parts.
    let (sine, cosine) = (0.5, 0.75f64.sqrt());
    let line = |[t, x, y, z, u, v, w]: Sample| {
        let turned = |x: f64, y: f64| (cosine * x + sine * y, -sine * x + cosine * y);
        let ((x, y), (u, v)) = (turned(x, y), turned(u, v));
        let gyro = [(x, 20.0, 100.0), (y, -30.0, 200.0), (z, 40.0, -300.0)];
        let gyro = gyro.map(|(x, bias, ppm)| x * (1.0 + 1e-6 * ppm) / DEGREE + bias / 3600.0);
        let force = [(u, 500.0), (v, -600.0), (w, 700.0)];
        let force = force.map(|(f, ug)| (f * (1.0 + 50e-6) / G + 1e-6 * ug) * 1e3);
        let [[x, y, z], [u, v, w]] = [gyro, force];
        let seconds = 40.0 + t;
        format!("2025-08-28T17:30:{seconds:.3}Z;ok;{u};{v};{w};;{z};{y};{x};99")
    };
    let mut text = table("a log\nwhen;state;ax;ay;az;n;gz;gy;gx;tail", &sway.rates, line);
    text = text.replacen("17:30:41.000Z;ok", "! a comment\n2025-08-28T17:30:41.000Z;ok", 1);
    text = text.replacen("2025-08-28T! a", "! a", 1);
    let path = sway.write("log.csv", &text);
    let map = format!(
        "title = \"mine\"\ndelimiter = \";\"\ncomment = \"!\"\nskip_lines = 1\n\
         mounting = [[{cosine}, {}, 0], [{sine}, {cosine}, 0], [0, 0, 1]]\n\
         [time]\ncolumn = \"when\"\nunit = \"iso8601\"\n\
         [gyro]\ncolumns = [9, \"gy\", \"GZ\"]\nunit = \"deg/s\"\n\
         [accelerometer]\ncolumns = [\"ax\", \"ay\", \"az\"]\nunit = \"mg\"\n\
         [sensor.gyro]\nconstant_deg_h = [20, -30, 40]\nscale_factor_ppm = [100, 200, -300]\n\
         [sensor.accelerometer]\nconstant_ug = [500, -600, 700]\nscale_factor_ppm = 50\n",
        -sine
    );
    let map = sway.write("map.toml", &map);
    alike(&sway, "rates.csv", &path, 1_756_402_240.0, &["--map", super::text(&map)], 1e-9);
    let given = Given { map: Some(super::text(&map).to_owned()), ..Given::default() };
    let said = opened(&path, &given).expect("it is right").join("\n");
    assert!(said.contains("gyros 20, -30, 40 °/h and 100, 200, -300 ppm"), "{said}");
}

#[test]
fn a_map_without_columns_adds_to_a_known_format() {
    let sway = Sway::new();
    let bias = |samples: &[Sample], h: f64| -> Vec<Sample> {
        let biased =
            |[t, x, y, z, u, v, w]: Sample| [t, x + 1e-4 * h, y, z, u, v, w * 1.001 + 0.02 * h];
        samples.iter().map(|&sample| biased(sample)).collect()
    };
    let deg_h = 1e-4 / DEGREE * 3600.0;
    let ug = 0.02 / G * 1e6;
    let map = format!(
        "[sensor.gyro]\nconstant_deg_h = [{deg_h}, 0, 0]\n\
         [sensor.accelerometer]\nconstant_ug = [0, 0, {ug}]\nscale_factor_ppm = [0, 0, 1000]\n"
    );
    let map = sway.write("map.toml", &map);
    let line = |[t, x, y, z, u, v, w]: Sample| format!("{t},{x},{y},{z},{u},{v},{w}");
    use schuler_simulator::recording::csv::{INCREMENTS, RATES};
    for (own, header, samples) in [
        ("rates.csv", RATES, bias(&sway.rates, 1.0)),
        ("increments.csv", INCREMENTS, bias(&sway.increments, 0.01)),
    ] {
        let path = sway.write("log.csv", &table(&header.join(","), &samples, line));
        alike(&sway, own, &path, 0.0, &["--map", super::text(&map)], 1e-9);
    }
}

#[test]
fn accelerometers_may_read_gravity_itself() {
    let sway = Sway::new();
    let time = |t: f64| format!("{t:.3}");
    let turned: Vec<_> =
        sway.rates.iter().map(|[t, x, y, z, u, v, w]| [*t, *x, *y, *z, -u, -v, -w]).collect();
    let path = sway.write("log.csv", &plain(&turned, time));
    let map = "[time]\ncolumn = 1\n[gyro]\ncolumns = [2, 3, 4]\nunit = \"rad/s\"\n[accelerometer]\n\
        columns = [5, 6, 7]\nunit = \"m/s2\"\nreads = \"gravity\"\n";
    let map_path = sway.write("map.toml", map);
    alike(&sway, "rates.csv", &path, 0.0, &["--map", super::text(&map_path)], 1e-10);
    // Times of two columns are checked against their unit.
    for (columns, words) in [
        ("column = 1\nunit = \"gps-week\"", "time.columns: has no column of seconds"),
        ("columns = [1, 2]\nunit = \"ms\"", "time.columns: has two columns of one unit"),
    ] {
        let map = sway.write("map.toml", &map.replace("column = 1", columns));
        let error = sway.flown(&path, 0.0, &["--map", super::text(&map)]).expect_err(words);
        assert!(error.contains(words), "{error}");
    }
}

#[test]
fn options_do_without_a_map() {
    let sway = Sway::new();
    let line = |sample: Sample| {
        let [t, x, y, z, u, v, w] = left_up(sample);
        let ([x, y, z], [u, v, w]) = ([x, y, z].map(f64::to_degrees), [u / G, v / G, w / G]);
        format!("{u},{v},{w},{x},{y},{z},{:.0}", 261_906.0 + 1e3 * t)
    };
    let path = sway.write("log.csv", &table("", &sway.rates, line));
    let axes = ["--axes", "forward-left-up"];
    // All said, and all found.
    let columns = ["--columns", "7,4,5,6,1,2,3", "--units", "g,deg/s,ms,rates"];
    alike(&sway, "rates.csv", &path, 261.906, &[&columns[..], &axes].concat(), 1e-7);
    alike(&sway, "rates.csv", &path, 261.906, &[&["--units", "deg/s"][..], &axes].concat(), 1e-7);
    // A header that nobody knows has names.
    let text = format!("u,v,w,x,y,z,count\n{}", table("", &sway.rates, line));
    let path = sway.write("named.csv", &text);
    let columns = ["--columns", "count,x,y,z,u,v,w", "--units", "g,deg/s,ms"];
    alike(&sway, "rates.csv", &path, 261.906, &[&columns[..], &axes].concat(), 1e-7);
}

/// How a time is written.
type Stamp<'a> = &'a dyn Fn(f64) -> String;

#[test]
fn times_are_read_in_every_form() {
    let sway = Sway::new();
    let week_s = 604_800.0;
    let sow = |t: f64| (week_s - 3.0 + t) % week_s;
    let forms: [(&str, f64, Stamp); 7] = [
        ("s", 5.0, &|t| format!("{:.3}", 5.0 + t)),
        ("ms", 5.0, &|t| format!("{:.0}", 5e3 + 1e3 * t)),
        ("us", 5.0, &|t| format!("{:.0}", 5e6 + 1e6 * t)),
        ("ns", 1_700_000_000.0, &|t| nanoseconds(1_700_000_000, t).to_string()),
        ("s", week_s - 3.0, &|t| format!("{:.3}", sow(t))),
        ("iso8601", 1_735_689_597.0, &|t| {
            let (date, seconds) = if t < 2.9999 {
                ("2024-12-31 23:59:", 57.0 + t)
            } else {
                ("2025-01-01 00:00:", t - 3.0)
            };
            format!("{date}{seconds:06.3}")
        }),
        ("ms", 4_294_964.296, &|t| format!("{:.0}", (4_294_964_296.0 + 1e3 * t) % 4_294_967_296.0)),
    ];
    let rest = "[gyro]\ncolumns = [2, 3, 4]\nunit = \"rad/s\"\n[accelerometer]\ncolumns = [5, 6, 7]\nunit = \"m/s2\"\n";
    for (unit, origin_s, time) in forms {
        let path = sway.write("log.csv", &plain(&sway.rates, time));
        let map = sway.write("map.toml", &format!("[time]\ncolumn = 1\nunit = \"{unit}\"\n{rest}"));
        alike(&sway, "rates.csv", &path, origin_s, &["--map", super::text(&map)], 1e-6);
    }
    // A GPS week and its seconds: into the next week, and over the end of ten bits.
    for (first, rollovers) in [(2329.0, 0), (1023.0, 1)] {
        let time = |t: f64| {
            let week = if t < 2.9999 {
                first
            } else {
                (first + 1.0) % if rollovers > 0 { 1024.0 } else { 1e9 }
            };
            format!("{week},{:.3}", sow(t))
        };
        let path = sway.write("log.csv", &plain(&sway.rates, time));
        let shifted = rest.replace("[2, 3, 4]", "[3, 4, 5]").replace("[5, 6, 7]", "[6, 7, 8]");
        let map = format!(
            "[time]\ncolumns = [1, 2]\nunit = \"gps-week\"\nrollovers = {rollovers}\n{shifted}"
        );
        let map = sway.write("map.toml", &map);
        let origin_s = (first + 1024.0 * f64::from(rollovers) + 1.0) * week_s - 3.0;
        alike(&sway, "rates.csv", &path, origin_s, &["--map", super::text(&map)], 1e-6);
    }
    // Rows without a time are counted.
    let text = table("", &sway.rates, |[_, x, y, z, u, v, w]| format!("{x} {y}\t{z} {u} {v}  {w}"));
    let path = sway.write("log.txt", &text);
    let rest = rest.replace("[5, 6, 7]", "[4, 5, 6]").replace("[2, 3, 4]", "[1, 2, 3]");
    let map =
        sway.write("map.toml", &format!("delimiter = \"blanks\"\n[time]\nrate_hz = 100\n{rest}"));
    alike(&sway, "rates.csv", &path, 0.0, &["--map", super::text(&map)], 1e-12);
}

#[test]
fn axes_are_words_or_initials_or_a_rotation() {
    for (axes, vector) in [
        ("forward-right-down", [1.0, 2.0, 3.0]),
        ("forward-left-up", [1.0, -2.0, -3.0]),
        ("RFU", [2.0, 1.0, -3.0]),
        ("up-right-forward", [3.0, 2.0, -1.0]),
        ("back-left-down", [-1.0, -2.0, 3.0]),
    ] {
        let mounting = Mounting::parse(axes).unwrap_or_else(|e| panic!("{axes}: {e}"));
        let turned = mounting.turn(schuler::math::vector::Vector::new(1.0, 2.0, 3.0));
        assert_eq!(turned.into_array(), vector, "{axes}");
    }
    for (axes, words) in [
        ("forward-left-down", "left-handed"),
        ("forward-forward-up", "twice"),
        ("forward-up", "three axes"),
        ("north-east-down", "\"north\" is no direction"),
    ] {
        let message = Mounting::parse(axes).expect_err(axes).to_string();
        assert!(message.contains(words) && message.contains("forward-left-up"), "{message}");
    }
}
