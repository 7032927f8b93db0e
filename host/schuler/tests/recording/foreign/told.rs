//! What a header does not say: settled by physics and said, or asked for.

use super::{Sample, Sway, forward_up, left_up, opened, table};
use schuler_simulator::recording::foreign::Given;
use schuler_simulator::recording::mounting::Mounting;

const G: f64 = 9.80665;

/// Time last, accelerometers first, in units.
fn log(samples: &[Sample], force: f64, rate: f64, turned: fn(Sample) -> Sample) -> String {
    table("", samples, |sample| {
        let [t, x, y, z, u, v, w] = turned(sample);
        let ([x, y, z], [u, v, w]) = ([x, y, z].map(|x| x / rate), [u, v, w].map(|f| f / force));
        format!("{u} {v} {w} {x} {y} {z} {t:.3}")
    })
}

/// The same at rest: every row is the first one.
fn resting(samples: &[Sample]) -> Vec<Sample> {
    let [_, x, y, z, u, v, w] = samples[0];
    samples
        .iter()
        .enumerate()
        .map(|(i, s)| [s[0], x, y, z, u, v, w + 1e-6 * (i % 3) as f64])
        .collect()
}

fn down(sample: Sample) -> Sample {
    sample
}

#[test]
fn gravity_tells_the_unit_of_accelerometers_and_the_kind_of_samples() {
    let sway = Sway::new();
    let radians = Given {
        units: schuler_simulator::rest::units::Units::parse("rad/s").expect("it is one"),
        ..Given::default()
    };
    for (samples, force, words) in [
        (&sway.rates, 1.0, "gravity, m/s2"),
        (&sway.rates, G, "gravity, g"),
        (&sway.rates, G * 1e-3, "gravity, mg"),
        (&sway.increments, 1.0, "gravity, increments of m/s2·s"),
    ] {
        let path = sway.write("log.txt", &log(samples, force, 1.0, down));
        let said = opened(&path, &radians).unwrap_or_else(|e| panic!("{e}"));
        assert!(said.iter().any(|line| line.contains(words)), "{said:?}");
        assert!(
            said[0].contains("column 7 is the time, 1 to 3 are accelerometers, 4 to 6 gyros"),
            "{said:?}"
        );
        assert!(said.iter().any(|line| line.contains("axes are forward-right-down")), "{said:?}");
    }
    let path = sway.write("log.txt", &log(&sway.rates, 3.0, 1.0, down));
    let error = opened(&path, &radians).expect_err("no unit");
    assert!(error.contains("log.txt:1: the header is none that is known"), "{error}");
    assert!(error.contains("none of columns 1 to 3 and 4 to 6 read gravity"), "{error}");
    assert!(error.contains("--columns") && error.contains("--map"), "{error}");
}

#[test]
fn the_earths_rate_tells_the_unit_of_gyros() {
    let sway = Sway::new();
    let still: Vec<_> = resting(&sway.rates);
    // At rest a good unit reads 15.04 °/h.
    let earth: Vec<_> = still
        .iter()
        .zip((0..2).cycle())
        .map(|([t, .., u, v, w], i)| {
            // The last digits of every column wander.
            let last = f64::from(i) * 1e-9;
            [*t, 5.156e-5 + last, last, last - 5.156e-5, u + last, v + last, *w]
        })
        .collect();
    for (rate, word) in [
        (1.0, "in rad/s"),
        (1f64.to_radians(), "in deg/s"),
        (1f64.to_radians() / 3600.0, "in deg/h"),
    ] {
        let path = sway.write("log.txt", &log(&earth, 1.0, rate, down));
        let said = opened(&path, &Given::default()).unwrap_or_else(|e| panic!("{e}")).join("\n");
        assert!(said.contains("the Earth's rate, 15.04 °/h") && said.contains(word), "{said}");
    }
    // A bias of 0.3 °/s hides it: only in deg/s it makes sense, and in rad/s nothing tells.
    let poor: Vec<_> = earth
        .iter()
        .map(|[t, x, y, z, u, v, w]| [*t, x + 0.004, y + 0.004, z + 0.004, *u, *v, *w])
        .collect();
    let path = sway.write("log.txt", &log(&poor, 1.0, 1f64.to_radians(), down));
    let said = opened(&path, &Given::default()).unwrap_or_else(|e| panic!("{e}")).join("\n");
    assert!(
        said.contains("gyros read deg/s: in rad/s they would turn by")
            && said.contains("a vertical that stays"),
        "{said}"
    );
    let path = sway.write("log.txt", &log(&sway.rates, G, 1.0, down));
    let error = opened(&path, &Given::default()).expect_err("nothing tells");
    assert!(error.contains("nothing tells the unit of the gyros"), "{error}");
    assert!(error.contains("--units g,rad/s or --units g,deg/s"), "{error}");
}

#[test]
fn what_points_up_leaves_forward_open() {
    let sway = Sway::new();
    let units = schuler_simulator::rest::units::Units::parse("rad/s").expect("it is one");
    let given = Given { units, ..Given::default() };
    let on_side = |[t, x, y, z, u, v, w]: Sample| [t, -z, y, x, -w, v, u];
    let leaning = |[t, x, y, z, u, v, w]: Sample| [t, y, -x, z, -w, -u, v];
    for (turned, words) in [
        (left_up as fn(Sample) -> Sample, "z reads +g, so it points up"),
        (forward_up, "z reads +g, so it points up"),
        (on_side, "x reads +g, so it points up"),
        (leaning, "x reads +g, so it points up"),
    ] {
        let path = sway.write("log.txt", &log(&sway.rates, 1.0, 1.0, turned));
        let error = opened(&path, &given).expect_err("nothing tells");
        assert!(error.contains(words), "{error}");
        // What is proposed is accepted, and settles it.
        let accepted = error.split("accepted: ").nth(1).expect("something is");
        let words = accepted
            .split([' ', ','])
            .filter(|word| word.matches('-').count() == 2 && word.len() > 6);
        let axes: Vec<_> = words.map(|word| Mounting::parse(word).expect(word)).collect();
        assert!(axes.len() >= 2, "{accepted}");
        for axes in axes {
            let said = opened(&path, &Given { axes: Some(axes), ..given.clone() });
            assert!(said.is_ok(), "{said:?}");
        }
    }
}

#[test]
fn a_header_that_nobody_knows_and_numbers_that_do_not_tell() {
    let sway = Sway::new();
    let twice = table("", &sway.rates, |[t, x, y, z, u, v, w]| {
        format!("{t:.3},{:.4},{x},{y},{z},{u},{v},{w}", t + 7.0)
    });
    let path = sway.write("log.csv", &twice);
    let error = opened(&path, &Given::default()).expect_err("two times");
    assert!(error.contains("columns 1, 2 all grow as a time does"), "{error}");
    // A counter of rows is no time beside one.
    let mut row = 0;
    let mut counted = String::new();
    for [t, x, y, z, u, v, w] in &sway.rates {
        row += 1;
        counted += &format!("{row},{t:.3},{x},{y},{z},{u},{v},{w}\n");
    }
    let path = sway.write("log.csv", &counted);
    let units = schuler_simulator::rest::units::Units::parse("rad/s").expect("it is one");
    let said =
        opened(&path, &Given { units, ..Given::default() }).unwrap_or_else(|e| panic!("{e}"));
    assert!(said[0].contains("column 2 is the time, 6 to 8 are accelerometers"), "{said:?}");
    let many = table("a,b,c,d,e,f,g,h", &sway.rates, |[t, x, y, z, u, v, w]| {
        format!("{t:.3},{x},{y},{z},{u},{v},{w},{}", x * y)
    });
    let path = sway.write("log.csv", &many);
    let error = opened(&path, &Given::default()).expect_err("seven vary");
    assert!(
        error.contains("log.csv:1: the header is none") && error.contains("not six in a row"),
        "{error}"
    );
    let error = opened(&sway.path(""), &Given::default()).expect_err("a folder of nothing known");
    assert!(error.contains("is a folder") && error.contains("gnss-ins-sim"), "{error}");
}

#[test]
fn names_speak_for_themselves() {
    let sway = Sway::new();
    let line = |[t, x, y, z, u, v, w]: Sample| {
        let [x, y, z] = [x, y, z].map(f64::to_degrees);
        format!("{:.0},20.5,{u},{v},{w},{x},{y},{z},30,31,{}", 1e3 * t, x * y)
    };
    for header in [
        "timestamp_ms,temp_x,acc_x,acc_y,acc_z,gyro_x_deg_s,gyro_y_deg_s,gyro_z_deg_s,mag_x,mag_y,mag_z",
        "Time (ms),T,Accel X (m/s^2),Accel Y (m/s^2),Accel Z (m/s^2),Gyro X [deg/sec],Gyro Y [deg/sec],Gyro Z [deg/sec],a,b,c",
        "timeMs (ms),T,accX,accY,accZ,gyrX (dps),gyrY (dps),gyrZ (dps),magX,magY,magZ",
        "time [ms],T,ax,ay,az,wx [deg s^-1],wy [deg s^-1],wz [deg s^-1],mx,my,mz",
    ] {
        let path = sway.write("log.csv", &table(header, &sway.rates, line));
        let said = opened(&path, &Given::default()).unwrap_or_else(|e| panic!("{header}: {e}"));
        assert!(said[0].contains("by the names"), "{said:?}");
        super::alike(&sway, "rates.csv", &path, 0.0, &[], 1e-9);
    }
    // What is named twice is not told by its name.
    let header = "time,T,ax,ay,az,wx,wy,wz,ax,ay,az";
    let path = sway.write("log.csv", &table(header, &sway.rates, line));
    let error = opened(&path, &Given::default()).expect_err("two of them");
    assert!(error.contains("the header is none that is known"), "{error}");
}
