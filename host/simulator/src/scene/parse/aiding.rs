//! Sensors that aid a navigator, and its filter.

use crate::input::document::{Section, Value};
use crate::input::key::{Key, Table};
use crate::input::{Complaint, InputError, Range};
use crate::scene::aiding::{Aiding, Filtering};
use crate::scene::keys::aiding as keys;
use crate::units::DEGREE;
use schuler::aiding::aided::measured::Kind;
use schuler::aiding::aided::settings::Lockout;
use schuler::math::vector::Vector;
use schuler::sensor::aiding::barometer::Barometer;
use schuler::sensor::aiding::fault::{Outliers, Spoofing};
use schuler::sensor::aiding::gnss::Gnss;
use schuler::sensor::aiding::line::{Line, MOST_OUTAGES, Outage};
use schuler::sensor::aiding::noise::VectorNoise;
use schuler::sensor::aiding::odometer::Odometer;
use schuler::sensor::aiding::still::Still;
use schuler::sensor::aiding::wheels::Wheels;

const REPORTS: &[(&str, Kind)] = &[
    ("position", Kind::Position),
    ("velocity", Kind::Velocity),
    ("position-velocity", Kind::PositionVelocity),
];
const LOCKOUTS: &[(&str, Lockout)] = &[("inflate", Lockout::Inflate), ("keep", Lockout::Keep)];

/// What aids the navigator of a scene; `until_s` is its end.
pub fn read(root: &Section<'_>, until_s: f64) -> Result<Aiding, InputError> {
    let aiding = given(root, until_s)?;
    match root.table("filter", &keys::FILTER)? {
        Some(section) if !aiding.is_there() => {
            let accepted = "[gnss], [barometer], [odometer], [zero_velocity] or [non_holonomic]";
            Err(section.error(Complaint::new("has nothing to filter", accepted)))
        }
        _ => Ok(aiding),
    }
}

/// The same where measurements come from elsewhere: a filter needs no sensor beside it.
pub fn given(root: &Section<'_>, until_s: f64) -> Result<Aiding, InputError> {
    let gnss =
        root.table("gnss", &keys::GNSS)?.map(|section| gnss(&section, until_s)).transpose()?;
    let antenna = gnss.map_or(Vector::ZERO, |gnss| gnss.lever_b);
    let lined = |name: &str, table: &Table| -> Result<_, InputError> {
        let known: Vec<&str> = keys::LINE.into_iter().chain(table.names()).collect();
        root.section(name, &known)
    };
    let barometer =
        lined("barometer", &keys::BAROMETER)?.map(|section| barometer(&section, antenna));
    let odometer = lined("odometer", &keys::ODOMETER)?.map(|section| odometer(&section));
    let still = lined("zero_velocity", &keys::ZERO_VELOCITY)?.map(|section| still(&section));
    let wheels = lined("non_holonomic", &keys::NON_HOLONOMIC)?.map(|section| wheels(&section));
    let filter = root.table("filter", &keys::FILTER)?;
    Ok(Aiding {
        gnss,
        barometer: barometer.transpose()?,
        odometer: odometer.transpose()?,
        still: still.transpose()?,
        wheels: wheels.transpose()?,
        filter: filter.as_ref().map(filtering).transpose()?.unwrap_or_default(),
    })
}

/// When a sensor measures, and when that arrives.
fn line(section: &Section<'_>, usual_hz: f64) -> Result<Line<f64>, InputError> {
    let read = |key: &Key| section.read(key);
    let interval_s = 1.0 / read(&keys::RATE)?.unwrap_or(usual_hz);
    let mut line = Line {
        latency_s: read(&keys::LATENCY)?.unwrap_or(0.0),
        jitter_s: read(&keys::JITTER)?.unwrap_or(0.0),
        loss: read(&keys::LOSS)?.unwrap_or(0.0),
        repetition: read(&keys::REPETITION)?.unwrap_or(0.0),
        ..Line::every(interval_s)
    };
    let Some(value) = section.get(keys::OUTAGES.name) else { return Ok(line) };
    for pair in value.items(keys::OUTAGES.accepted())? {
        let [from_s, until_s] = span(&pair)?;
        line = line.with_outage(Outage { from_s, until_s }).ok_or_else(|| {
            let what = format!("has more than {MOST_OUTAGES}");
            value.error(Complaint::new(what, keys::OUTAGES.accepted()))
        })?;
    }
    Ok(line)
}

/// [from, until], seconds.
fn span(value: &Value<'_>) -> Result<[f64; 2], InputError> {
    let accepted = "[from, until] in seconds, the first below the second";
    let items = value.items(accepted)?;
    let [from, until] = items.as_slice() else {
        return Err(value.error(Complaint::new("is not two times", accepted)));
    };
    let (from_s, until_s) = (from.number(&Range::FINITE)?, until.number(&Range::FINITE)?);
    if from_s < until_s {
        return Ok([from_s, until_s]);
    }
    Err(value.error(Complaint::new("ends before it begins", accepted)))
}

/// One number for all axes, or [x, y, z], or what it is when absent.
fn axes(
    section: &Section<'_>,
    key: &Key,
    range: &Range,
    absent: f64,
) -> Result<Vector<f64>, InputError> {
    let value = section.get(key.name).map(|value| value.axes(range)).transpose()?;
    Ok(value.unwrap_or([absent; 3]).into())
}

fn gnss(section: &Section<'_>, end_s: f64) -> Result<Gnss<f64>, InputError> {
    let noise =
        |white: (&Key, &Range, f64), wanders: &Key| -> Result<VectorNoise<f64>, InputError> {
            Ok(VectorNoise {
                white: axes(section, white.0, white.1, white.2)?,
                correlated: axes(section, wanders, white.1, 0.0)?,
                correlation_s: section.read(&keys::WANDERS)?.unwrap_or(100.0),
            })
        };
    let position = noise((&keys::POSITION, &keys::METRES, 1.0), &keys::POSITION_WANDERS)?;
    let velocity = noise((&keys::VELOCITY, &keys::SPEED, 0.05), &keys::VELOCITY_WANDERS)?;
    let claimed = |key: &Key, noise: &VectorNoise<f64>| -> Result<Vector<f64>, InputError> {
        let rms = noise.white.zip(noise.correlated, f64::hypot);
        let value = section.get(key.name).map(|value| value.axes(&keys::CLAIMED)).transpose()?;
        let claimed = value.map_or(rms, Vector::from);
        if claimed.into_array().into_iter().all(|x| x > 0.0) {
            return Ok(claimed);
        }
        let complaint =
            Complaint::new("must be there where the noise is 0", keys::CLAIMED.accepted);
        Err(section.blame(key.name, complaint))
    };
    let outliers = section.read(&keys::OUTLIERS)?.filter(|&probability| probability > 0.0);
    let size_m = section.read(&keys::OUTLIER_SIZE)?.unwrap_or(100.0);
    let spoofing = section.section("spoofing", &keys::FORGERY.names())?;
    Ok(Gnss {
        line: line(section, 1.0)?,
        kind: section
            .get("reports")
            .map_or(Ok(Kind::PositionVelocity), |value| value.choice(REPORTS))?,
        lever_b: axes(section, &keys::ANTENNA, &keys::LEVER, 0.0)?,
        position_sigma: claimed(&keys::CLAIMED_POSITION, &position)?,
        velocity_sigma: claimed(&keys::CLAIMED_VELOCITY, &velocity)?,
        position,
        velocity,
        outliers: outliers.map(|probability| Outliers { probability, size_m }),
        spoofing: spoofing.map(|section| forged(&section, end_s)).transpose()?,
    })
}

fn forged(section: &Section<'_>, end_s: f64) -> Result<Spoofing<f64>, InputError> {
    let from_s = section.need(&keys::FROM)?;
    let until_s = section.read(&keys::UNTIL)?.unwrap_or(end_s);
    if until_s < from_s {
        let complaint = Complaint::new("is before from_s", format!("seconds, from {from_s} on"));
        return Err(section.blame("until_s", complaint));
    }
    Ok(Spoofing {
        from_s,
        until_s,
        jump_ned: axes(section, &keys::JUMP, &keys::FORGED, 0.0)?,
        ramp_ned: axes(section, &keys::RAMP, &keys::FORGED, 0.0)?,
    })
}

fn barometer(section: &Section<'_>, antenna: Vector<f64>) -> Result<Barometer<f64>, InputError> {
    let read = |key: &Key, absent: f64| section.read(key).map(|x| x.unwrap_or(absent));
    let (noise, bias) = (read(&keys::HEIGHT, 0.5)?, read(&keys::HEIGHT_BIAS, 5.0)?);
    let barometer =
        Barometer::new(line(section, 1.0)?, noise, bias, read(&keys::HEIGHT_TIME, 1000.0)?);
    let lever_b = match section.get(keys::PORT.name) {
        Some(value) => value.axes(&keys::LEVER)?.into(),
        None => antenna,
    };
    Ok(Barometer { lever_b, ..barometer })
}

fn odometer(section: &Section<'_>) -> Result<Odometer<f64>, InputError> {
    let read = |key: &Key, absent: f64| section.read(key).map(|x| x.unwrap_or(absent));
    Ok(Odometer {
        scale_rms: 0.01 * read(&keys::WHEEL_SCALE, 1.0)?,
        quantum: read(&keys::WHEEL_STEP, 0.0)?,
        lever_b: axes(section, &keys::WHEEL, &keys::LEVER, 0.0)?,
        ..Odometer::new(line(section, 10.0)?, read(&keys::WHEEL_NOISE, 0.05)?)
    })
}

fn still(section: &Section<'_>) -> Result<Still<f64>, InputError> {
    let sigma = section.read(&keys::STILL_SIGMA)?.unwrap_or(0.01);
    let still = Still::new(line(section, 1.0)?, sigma);
    Ok(Still { limit: section.read(&keys::STILL_LIMIT)?.unwrap_or(still.limit), ..still })
}

fn wheels(section: &Section<'_>) -> Result<Wheels<f64>, InputError> {
    Ok(Wheels::new(line(section, 10.0)?, section.read(&keys::SLIP)?.unwrap_or(0.1)))
}

fn filtering(section: &Section<'_>) -> Result<Filtering, InputError> {
    let usual = Filtering::default();
    let read = |key: &Key| section.read(key);
    let degrees = |key: &Key| read(key).map(|angle| angle.map(|x| x * DEGREE));
    let patience =
        section.get(keys::PATIENCE.name).map(|value| value.integer(1, 1000)).transpose()?;
    Ok(Filtering {
        lever_arm_m: read(&keys::LEVER_SIGMA)?,
        latency_s: read(&keys::LATENCY_SIGMA)?,
        false_refusal: read(&keys::GATE)?.unwrap_or(usual.false_refusal),
        patience: patience.map_or(usual.patience, |n| n as u32),
        lockout: section
            .get("lockout")
            .map_or(Ok(usual.lockout), |value| value.choice(LOCKOUTS))?,
        horizon_s: read(&keys::HORIZON)?,
        smoother: section.get("smoother").map_or(Ok(false), |value| value.truth("true, false"))?,
        start: [
            read(&keys::START_POSITION)?,
            read(&keys::START_VELOCITY)?,
            degrees(&keys::START_LEVEL)?,
            degrees(&keys::START_HEADING)?,
        ],
    })
}
