//! An excerpt of each known format, written here from the emulator's samples with the digits that format has.

use super::{Sway, alike, forward_up, left_up, nanoseconds, opened, table};
use schuler_simulator::recording::foreign::{Given, known};

const G: f64 = 9.80665;
/// A day of 2025, s since 1970.
const DAY: u64 = 1_756_339_200;

#[test]
fn every_map_of_the_program_reads() {
    let names: Vec<_> = known::all().map(|map| map.name).collect();
    assert_eq!(names.join(", "), known::names());
    for map in known::all() {
        assert!(!map.title.is_empty() && map.gyro.columns.len() == 3, "{}", map.name);
        let there = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
            .join(format!("../simulator/formats/{}.toml", map.name));
        assert!(there.is_file(), "{}", there.display());
    }
}

#[test]
fn our_own_with_columns_of_others_between() {
    let sway = Sway::new();
    let header = "n,time_s,accel_x_m_s2,accel_y_m_s2,accel_z_m_s2,t_c,gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s";
    let line = |[t, x, y, z, u, v, w]: super::Sample| format!("7,{t},{u},{v},{w},20.5,{x},{y},{z}");
    let path = sway.write("a.csv", &table(header, &sway.rates, line));
    alike(&sway, "rates.csv", &path, 0.0, &[], 1e-12);
    let header = "time_s;dvel_x_m_s;dvel_y_m_s;dvel_z_m_s;dtheta_x_rad;dtheta_y_rad;dtheta_z_rad";
    let line = |[t, x, y, z, u, v, w]: super::Sample| format!("{t};{u};{v};{w};{x};{y};{z}");
    let path = sway.write("b.csv", &table(header, &sway.increments, line));
    alike(&sway, "increments.csv", &path, 0.0, &[], 1e-12);
}

#[test]
fn kf_gins() {
    let sway = Sway::new();
    let line = |[t, x, y, z, u, v, w]: super::Sample| {
        format!("{:.6} {x:.12} {y:.12} {z:.12} {u:.12} {v:.12} {w:.12}", 456_300.0 + t)
    };
    let path = sway.write("imu.txt", &table("", &sway.increments, line));
    alike(&sway, "increments.csv", &path, 456_300.0, &[], 1e-7);
    let said = opened(&path, &Given::default()).expect("it is known");
    assert!(said[0].contains("KF-GINS"), "{said:?}");
    // Other axes are not taken for it.
    let line = |sample: super::Sample| line(left_up(sample));
    let path = sway.write("other.txt", &table("", &sway.increments, line));
    let error = opened(&path, &Given::default()).expect_err("z points up");
    assert!(!error.contains("KF-GINS") && error.contains("gyros"), "{error}");
}

#[test]
fn gnss_ins_sim() {
    let sway = Sway::new();
    let time = table("time (sec)", &sway.rates, |sample| format!("{:.18e}", sample[0]));
    let gyro =
        table("gyro_x (deg/s),gyro_y (deg/s),gyro_z (deg/s)", &sway.rates, |[_, x, y, z, ..]| {
            let [x, y, z] = [x, y, z].map(f64::to_degrees);
            format!("{x:.18e},{y:.18e},{z:.18e}")
        });
    let accel =
        table("accel_x (m/s^2),accel_y (m/s^2),accel_z (m/s^2)", &sway.rates, |[.., u, v, w]| {
            format!("{u:.18e},{v:.18e},{w:.18e}")
        });
    let path = sway.write("time.csv", &time);
    let gyro_path = sway.write("gyro-0.csv", &gyro);
    let accel_path = sway.write("accel-0.csv", &accel);
    for imu in [&path, &gyro_path, &accel_path, &sway.path("")] {
        alike(&sway, "rates.csv", imu, 0.0, &[], 1e-10);
    }
    // A file of another run is not exchanged for the first one's.
    let other = sway.write("gyro-1.csv", &gyro);
    let error = opened(&other, &Given::default()).expect_err("it is another run");
    assert!(error.contains("gyro-1.csv: is a part of") && error.contains("--map"), "{error}");
    let short: String = accel.lines().take(500).map(|line| format!("{line}\n")).collect();
    sway.write("accel-0.csv", &short);
    let error = sway.flown(&path, 0.0, &[]).expect_err("it is short");
    assert!(error.contains("accel-0.csv: ends after 499 rows"), "{error}");
}

#[test]
fn euroc() {
    let sway = Sway::new();
    let header = "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],\
        a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]";
    // The unit stands with x up, y right, z forward.
    let line = |[t, x, y, z, u, v, w]: super::Sample| {
        let ns = nanoseconds(1_403_636_579, t);
        format!("{ns},{},{y},{x},{},{v},{u}", -z, -w)
    };
    let path = sway.write("data.csv", &table(header, &sway.rates, line));
    let axes = ["--axes", "up-right-forward"];
    alike(&sway, "rates.csv", &path, 1_403_636_579.0, &axes, 1e-10);
    let error = opened(&path, &Given::default()).expect_err("nothing tells its axes");
    assert!(error.contains("x reads +g") && error.contains("up-right-forward"), "{error}");
}

#[test]
fn ros_topics() {
    let sway = Sway::new();
    let nine = |name: &str| (0..9).map(|i| format!(",field.{name}{i}")).collect::<String>();
    let three = |name: &str| ["x", "y", "z"].map(|axis| format!(",field.{name}.{axis}")).concat();
    let header = format!(
        "%time,field.header.seq,field.header.stamp,field.header.frame_id{},field.orientation.w{}{}{}{}{}",
        three("orientation"),
        nine("orientation_covariance"),
        three("angular_velocity"),
        nine("angular_velocity_covariance"),
        three("linear_acceleration"),
        nine("linear_acceleration_covariance"),
    );
    let zeros = ",0.0".repeat(9);
    let body = |sample: super::Sample| {
        let [_, x, y, z, u, v, w] = left_up(sample);
        format!(",0.0,0.0,0.0,1.0{zeros},{x},{y},{z}{zeros},{u},{v},{w}{zeros}")
    };
    // The bag's time comes later than the stamp, by some scatter.
    let line = |sample: super::Sample| {
        let ns = nanoseconds(DAY, sample[0]);
        format!("{},1,{ns},imu_link{}", ns + ns % 977, body(sample))
    };
    let path = sway.write("one.csv", &table(&header, &sway.rates, line));
    alike(&sway, "rates.csv", &path, DAY as f64, &[], 1e-10);

    let line = |sample: super::Sample| {
        let ns = nanoseconds(DAY, sample[0]);
        let (sec, nanosec) = (ns / 1_000_000_000, ns % 1_000_000_000);
        format!("{sec},{nanosec},imu_link{}", body(sample))
    };
    let path = sway.write("two.csv", &table("", &sway.rates, line));
    alike(&sway, "rates.csv", &path, DAY as f64, &[], 1e-10);

    let header = "Time,header.seq,header.stamp.secs,header.stamp.nsecs,header.frame_id,angular_velocity.x,\
        angular_velocity.y,angular_velocity.z,linear_acceleration.x,linear_acceleration.y,linear_acceleration.z";
    let line = |sample: super::Sample| {
        let ns = nanoseconds(DAY, sample[0]);
        let [_, x, y, z, u, v, w] = left_up(sample);
        let (sec, nanosec) = (ns / 1_000_000_000, ns % 1_000_000_000);
        format!("{sec}.5,3,{sec},{nanosec},\"imu, left\",{x},{y},{z},{u},{v},{w}")
    };
    let path = sway.write("bag.csv", &table(header, &sway.rates, line));
    alike(&sway, "rates.csv", &path, DAY as f64, &[], 1e-10);
}

#[test]
fn navego() {
    let sway = Sway::new();
    let line = |[t, x, y, z, u, v, w]: super::Sample| format!("{t},{u},{v},{w},{x},{y},{z}");
    let text = table("t,fb_1,fb_2,fb_3,wb_1,wb_2,wb_3", &sway.rates, line);
    let path = sway.write("imu.csv", &text);
    alike(&sway, "rates.csv", &path, 0.0, &[], 1e-12);
}

#[test]
fn x_io() {
    let sway = Sway::new();
    let names = |head: &str| {
        format!(
            "{head},Gyroscope X (deg/s),Gyroscope Y (deg/s),Gyroscope Z (deg/s),\
             Accelerometer X (g),Accelerometer Y (g),Accelerometer Z (g),Magnetometer X (uT)"
        )
    };
    let values = |sample: super::Sample| {
        let [_, x, y, z, u, v, w] = left_up(sample);
        let ([x, y, z], [u, v, w]) = ([x, y, z].map(f64::to_degrees), [u / G, v / G, w / G]);
        format!("{x:.10},{y:.10},{z:.10},{u:.10},{v:.10},{w:.10},21.5")
    };
    let line = |sample: super::Sample| format!("{:.6},{}", sample[0], values(sample));
    let path = sway.write("sensor_data.csv", &table(&names("Time (s)"), &sway.rates, line));
    alike(&sway, "rates.csv", &path, 0.0, &[], 1e-7);
    let line = |sample: super::Sample| {
        format!("{},{}", 5_000_000 + (sample[0] * 1e6).round() as u64, values(sample))
    };
    let path = sway.write("Inertial.csv", &table(&names("Timestamp (us)"), &sway.rates, line));
    alike(&sway, "rates.csv", &path, 5.0, &[], 1e-7);
}

#[test]
fn sensor_logger() {
    let sway = Sway::new();
    let header = "time,seconds_elapsed,z,y,x";
    let line = |t: f64, [x, y, z]: [f64; 3]| format!("{},{t},{z},{y},{x}", nanoseconds(DAY, t));
    let gyro = table(header, &sway.rates, |sample| {
        let [t, x, y, z, ..] = forward_up(sample);
        line(t, [x, y, z])
    });
    let path = sway.write("Gyroscope.csv", &gyro);
    // Accelerometers are interpolated to gyros; their unit is that of the phone.
    for (unit, word) in [(1.0, "m/s2"), (G, "g")] {
        let accelerometer = table(header, &sway.others, |sample| {
            let [t, .., u, v, w] = forward_up(sample);
            line(t, [u / unit, v / unit, w / unit])
        });
        let other = sway.write("TotalAcceleration.csv", &accelerometer);
        for imu in [&path, &other] {
            let said = opened(imu, &Given::default()).expect("it is known").join("\n");
            assert!(said.contains(&format!("gravity, {word}")), "{said}");
            assert!(said.contains("gyros (about 100.0 Hz) are interpolated by cubics"), "{said}");
        }
    }
}

#[test]
fn the_slower_sensor_is_interpolated() {
    let sway = Sway::new();
    let header = "time,seconds_elapsed,z,y,x";
    let line = |t: f64, [x, y, z]: [f64; 3]| format!("{},{t},{z},{y},{x}", nanoseconds(DAY, t));
    let gyro = |samples: &[super::Sample]| {
        table(header, samples, |sample| {
            let [t, x, y, z, ..] = forward_up(sample);
            line(t, [x, y, z])
        })
    };
    let accelerometer = |samples: &[super::Sample]| {
        table(header, samples, |sample| {
            let [t, .., u, v, w] = forward_up(sample);
            line(t, [u, v, w])
        })
    };
    // Gyros at 100 Hz, accelerometers at every other of their instants, or between them.
    let halves: Vec<_> = sway.rates.iter().skip(1).step_by(2).copied().collect();
    let path = sway.write("Gyroscope.csv", &gyro(&sway.rates));
    sway.write("TotalAcceleration.csv", &accelerometer(&[&sway.rates[..1], &halves].concat()));
    alike(&sway, "rates.csv", &path, DAY as f64, &[], 3e-7);
    sway.write("Gyroscope.csv", &gyro(&[&sway.rates[..1], &halves].concat()));
    sway.write("TotalAcceleration.csv", &accelerometer(&sway.rates));
    alike(&sway, "rates.csv", &path, DAY as f64, &[], 3e-7);
    // A gap is named where it matters.
    let holed: Vec<_> = [&sway.rates[..200], &sway.rates[230..]].concat();
    sway.write("Gyroscope.csv", &gyro(&sway.rates));
    sway.write("TotalAcceleration.csv", &accelerometer(&holed));
    let error = sway.flown(&path, DAY as f64, &[]).expect_err("there is a gap");
    assert!(
        error.contains("Gyroscope.csv:202: ") && error.contains("TotalAcceleration.csv has no"),
        "{error}"
    );
}

#[test]
fn gnss_logger() {
    let sway = Sway::new();
    let mut text = "# Header Description:\n#\n# UncalAccel,utcTimeMillis,elapsedRealtimeNanos,UncalAccelXMps2,\
        UncalAccelYMps2,UncalAccelZMps2,BiasXMps2,BiasYMps2,BiasZMps2\n# UncalGyro,utcTimeMillis,\
        elapsedRealtimeNanos,UncalGyroXRadPerSec,UncalGyroYRadPerSec,UncalGyroZRadPerSec,DriftXRadPerSec,\
        DriftYRadPerSec,DriftZRadPerSec\n"
        .to_owned();
    for sample in &sway.rates {
        let [t, x, y, z, u, v, w] = forward_up(*sample);
        let (ms, ns) = (DAY * 1000, nanoseconds(7, t));
        text += &format!("UncalAccel,{ms},{ns},{u},{v},{w},0,0,0\nFix,GPS,45.0,10.0\n");
        text += &format!("UncalGyro,{ms},{ns},{x},{y},{z},0,0,0\n");
    }
    let path = sway.write("gnss_log.txt", &text);
    alike(&sway, "rates.csv", &path, 7.0, &[], 1e-10);
}

#[test]
fn phyphox() {
    let sway = Sway::new();
    let gyro = table(
        "\"Time (s)\",\"Gyroscope x (rad/s)\",\"Gyroscope y (rad/s)\",\"Gyroscope z (rad/s)\",\"Absolute (rad/s)\"",
        &sway.rates,
        |sample| {
            let [t, x, y, z, ..] = forward_up(sample);
            format!("{t:.9e},{x:.9e},{y:.9e},{z:.9e},0")
        },
    );
    let accelerometer = table(
        "\"Time (s)\",\"Acceleration x (m/s^2)\",\"Acceleration y (m/s^2)\",\"Acceleration z (m/s^2)\"",
        &sway.rates,
        |sample| {
            let [t, .., u, v, w] = forward_up(sample);
            format!("{t:.9e},{u:.9e},{v:.9e},{w:.9e}")
        },
    );
    let path = sway.write("Gyroscope.csv", &gyro);
    sway.write("Accelerometer.csv", &accelerometer);
    alike(&sway, "rates.csv", &path, 0.0, &[], 1e-6);
}
