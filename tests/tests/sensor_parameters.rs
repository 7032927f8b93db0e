//! Every parameter of a sensor that cannot be comes back as the error that names it.

use schuler::math::vector::Vector;
use schuler::sensor::Timing;
use schuler::sensor::bandwidth::Bandwidth;
use schuler::sensor::constant::Constant;
use schuler::sensor::flicker::Flicker;
use schuler::sensor::g_sensitivity::GSensitivity;
use schuler::sensor::gauss_markov::GaussMarkov;
use schuler::sensor::latency::Latency;
use schuler::sensor::misalignment::Misalignment;
use schuler::sensor::parameter::{Fault, Parameter, ParameterError};
use schuler::sensor::quantization::Quantization;
use schuler::sensor::random_walk::RandomWalk;
use schuler::sensor::saturation::Saturation;
use schuler::sensor::scale_factor::ScaleFactor;
use schuler::sensor::temperature::Ramp;
use schuler::sensor::temperature_bias::TemperatureBias;
use schuler::sensor::temperature_scale::TemperatureScale;
use schuler::sensor::turn_on::TurnOn;
use schuler::sensor::white::White;

/// What a parameter may be.
#[derive(PartialEq, PartialOrd)]
enum Range {
    Any,
    NotNegative,
    Positive,
}

fn check<T>(
    parameter: Parameter,
    range: Range,
    make: impl Fn(Vector<f64>) -> Result<T, ParameterError>,
) {
    let good = [0.5, 0.25, 2.0];
    assert!(make(good.into()).is_ok(), "{parameter}");
    for axis in 0..3u8 {
        let with = |x: f64| {
            let mut value = good;
            value[usize::from(axis)] = x;
            make(value.into()).err()
        };
        let error = |fault| Some(ParameterError { parameter, axis: Some(axis), fault });
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(with(x), error(Fault::NotFinite), "{parameter} {x}");
        }
        let (negative, zero) = match range {
            Range::Any => (None, None),
            Range::NotNegative => (error(Fault::Negative), None),
            Range::Positive => (error(Fault::NotPositive), error(Fault::NotPositive)),
        };
        assert_eq!(with(-1e-9), negative, "{parameter}");
        assert_eq!(with(0.0), zero, "{parameter}");
    }
}

#[test]
fn a_parameter_out_of_its_range_is_named() {
    let timing = Timing::new(0.05, 1000).unwrap();
    let one = Vector::new(1.0, 1.0, 1.0);
    check(Parameter::Constant, Range::Any, |v| Constant::new(v, timing));
    check(Parameter::ScaleFactor, Range::Any, ScaleFactor::new);
    check(Parameter::Misalignment, Range::Any, Misalignment::new);
    check(Parameter::GSensitivity, Range::Any, GSensitivity::new);
    check(Parameter::TurnOnRms, Range::NotNegative, |v| TurnOn::new(v, timing));
    check(Parameter::GaussMarkovRms, Range::NotNegative, |v| GaussMarkov::new(v, one, timing));
    check(Parameter::WhiteNoise, Range::NotNegative, |v| White::new(v, timing));
    check(Parameter::RandomWalk, Range::NotNegative, |v| RandomWalk::new(v, timing));
    check(Parameter::BiasInstability, Range::NotNegative, |v| Flicker::new(v, timing));
    check(Parameter::Quantization, Range::NotNegative, Quantization::new);
    check(Parameter::CorrelationTime, Range::Positive, |v| GaussMarkov::new(one, v, timing));
    check(Parameter::Saturation, Range::Positive, |v| Saturation::new(v, timing));
    let ramp = Ramp::new(1.0, 1.0, 1.0, timing).unwrap();
    check(Parameter::TemperatureBias, Range::Any, |v| TemperatureBias::new(v, ramp, timing));
    check(Parameter::TemperatureScale, Range::Any, |v| TemperatureScale::new(v, ramp));
    check(Parameter::Bandwidth, Range::Positive, |v| Bandwidth::new(v, timing));
    check(Parameter::Latency, Range::NotNegative, |v| Latency::new(v * 0.1, timing));
}

#[test]
fn a_timing_out_of_its_range_is_named() {
    let error = |parameter, fault| Some(ParameterError { parameter, axis: None, fault });
    for (interval_s, fault) in [
        (0.0, Fault::NotPositive),
        (-0.05, Fault::NotPositive),
        (f64::NAN, Fault::NotFinite),
        (f64::INFINITY, Fault::NotFinite),
    ] {
        assert_eq!(Timing::new(interval_s, 1).err(), error(Parameter::Interval, fault));
    }
    assert_eq!(Timing::new(0.05, 0).err(), error(Parameter::Samples, Fault::NotPositive));
}

#[test]
fn a_parameter_whose_coefficients_overflow_is_named() {
    let long = Timing::new(1e300, 10).unwrap();
    let (one, huge) = (Vector::new(1.0, 1.0, 1.0), Vector::new(1e300, 1.0, 1.0));
    let error = |parameter, axis| {
        Some(ParameterError { parameter, axis: Some(axis), fault: Fault::OutOfRange })
    };
    assert_eq!(Constant::new(huge, long).err(), error(Parameter::Constant, 0));
    assert_eq!(TurnOn::new(huge, long).err(), error(Parameter::TurnOnRms, 0));
    assert_eq!(White::new(huge, long).err(), error(Parameter::WhiteNoise, 0));
    assert_eq!(RandomWalk::new(one, long).err(), error(Parameter::RandomWalk, 0));
    assert_eq!(Flicker::new(huge, long).err(), error(Parameter::BiasInstability, 0));
    assert_eq!(Saturation::new(huge, long).err(), error(Parameter::Saturation, 0));
    let short = Vector::new(1.0, 1.0, 1e-300);
    assert_eq!(GaussMarkov::new(one, short, long).err(), error(Parameter::CorrelationTime, 2));
    let lasting = Vector::new(1.0, 720.0, 1.0);
    let large = Vector::new(1.0, 1e307, 1.0);
    let timing = Timing::new(0.05, 10).unwrap();
    let found = GaussMarkov::new(large, lasting, timing).err();
    assert_eq!(found, error(Parameter::GaussMarkovRms, 1));
    let tiny = Vector::new(1.0, 1e-310, 1.0);
    assert_eq!(Quantization::new(tiny).err(), error(Parameter::Quantization, 1));
}

#[test]
fn an_error_says_what_and_where_and_why() {
    let timing = Timing::new(0.05, 1000).unwrap();
    let rms = Vector::new(1.0, 1.0, 1.0);
    let error = GaussMarkov::new(rms, Vector::new(1.0, 0.0, 1.0), timing).err().unwrap();
    let expected = "correlation time of the Gauss-Markov bias, axis y, must be positive";
    assert_eq!(error.to_string(), expected);
    let error = Timing::new(f64::NAN, 1).err().unwrap();
    assert_eq!(error.to_string(), "sample interval must be finite");
}
