//! Options of `replay` about what aids it.

use super::{Span, allan, options};
use clap::Args;
use schuler_simulator::aided::fixes::Velocities;
use schuler_simulator::aided::told::Assumed;
use schuler_simulator::input::{Complaint, Range};
use std::path::PathBuf;

/// How late a receiver's stamps may be, s.
pub const GNSS_LAG_S: Range = Range::from_to(-1e10, 1e10, "seconds");

/// What aids the navigation of a recording.
#[derive(Args, Clone, Debug, Default, PartialEq)]
pub struct AidingOptions {
    /// Positions and velocities that aid navigation: a gnss.csv as emulate writes it, an RTKLIB .pos, NMEA, GPX or
    /// KML. nav.csv then has a row at each end of a block, with the filter's standard deviations
    #[arg(long, value_name = "FILE")]
    pub gnss: Option<PathBuf>,
    /// From the inertial unit to the antenna, metres [default: that of --sensors, or 0,0,0]
    #[arg(long, value_name = "F,R,D", requires = "gnss", allow_negative_numbers = true, value_parser = LeverArm::parse)]
    pub lever_arm: Option<LeverArm>,
    /// How late the stamps of --gnss are, seconds
    #[arg(long, value_name = "S", requires = "gnss", default_value = "0", allow_negative_numbers = true, value_parser = lag)]
    pub gnss_lag: f64,
    /// How much later than the positions the velocities of --gnss are, seconds (0.125 of a receiver that tells the
    /// mean over its 0.25 s); or "off", which leaves them out
    #[arg(long, value_name = "S", requires = "gnss", default_value = "0", allow_negative_numbers = true, value_parser = VelocityLag::parse)]
    pub velocity_lag: VelocityLag,
    /// Standard deviations where the file has none: positions level and down, m, velocities, m/s
    #[arg(long, value_name = "L,D,V", requires = "gnss", default_value = "3,5,0.3", value_parser = Sigmas::parse)]
    pub gnss_sigma: Sigmas,
    /// Smooths the flight, too: what all fixes together say of every instant, with its standard deviations, goes to this
    /// file
    #[arg(long, value_name = "FILE", requires = "gnss")]
    pub smooth: Option<PathBuf>,
    /// RTKLIB's time tags of the stream (.tag), which tie its stamps to GPS time
    #[arg(long, value_name = "FILE", requires = "gnss")]
    pub time_tag: Option<PathBuf>,
    /// A scene whose gyro, accelerometer and filter sections say what the sensors are like [default: a MEMS unit, whose
    /// numbers are printed]
    #[arg(long, value_name = "SCENE", requires = "gnss", value_parser = options::name())]
    pub sensors: Option<String>,
    /// Hide the fixes between two times of the recording; how far off the navigator is at the end of that is
    /// printed. May be repeated
    #[arg(long, value_name = "A..B", requires = "gnss", allow_negative_numbers = true, value_parser = allan::span)]
    pub withhold: Vec<Span>,
}

/// The value of `--lever-arm`: forward, right, down, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeverArm(pub [f64; 3]);

/// The value of `--velocity-lag`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VelocityLag(pub Velocities);

impl LeverArm {
    /// From `F,R,D`.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let range = Range::from_to(-50.0, 50.0, "");
        three(text, &range, "forward,right,down in metres, each from -50 to 50").map(Self)
    }
}

impl VelocityLag {
    /// From seconds or `off`.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let range = Range::from_to(-10.0, 10.0, "seconds, or off");
        let velocities = match text {
            "off" => Velocities::Unused,
            _ => Velocities::Late(options::number(text, &range)?),
        };
        Ok(Self(velocities))
    }
}

impl Default for VelocityLag {
    fn default() -> Self {
        Self(Velocities::Late(0.0))
    }
}

/// The value of `--gnss-sigma`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sigmas(pub Assumed);

impl Sigmas {
    /// From `L,D,V`.
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let range = Range::above(0.0, 1e6, "");
        let accepted = "level,down,velocity in m, m and m/s, each above 0";
        let [level_m, down_m, velocity_m_s] = three(text, &range, accepted)?;
        Ok(Self(Assumed { level_m, down_m, velocity_m_s }))
    }
}

impl Default for Sigmas {
    fn default() -> Self {
        Self(Assumed { level_m: 3.0, down_m: 5.0, velocity_m_s: 0.3 })
    }
}

fn three(text: &str, range: &Range, accepted: &'static str) -> Result<[f64; 3], Complaint> {
    let parts: Vec<_> = text.split(',').collect();
    let [a, b, c] = parts[..] else {
        return Err(Complaint::new("is not three numbers", accepted));
    };
    let of = |part: &str| options::number(part.trim(), &Range { accepted, ..*range });
    Ok([of(a)?, of(b)?, of(c)?])
}

fn lag(text: &str) -> Result<f64, Complaint> {
    options::number(text, &GNSS_LAG_S)
}
