//! Every error term of a sensor is the core's: the same parameters give the same bits, and none of them is lost.

#![allow(unsafe_code, reason = "the functions are C's")]

use schuler::math::quaternion::Matrix;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::sensor::Timing;
use schuler::sensor::bandwidth::Bandwidth;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::g_sensitivity_matrix::GSensitivityMatrix;
use schuler::sensor::latency::Latency;
use schuler::sensor::misalignment_matrix::MisalignmentMatrix;
use schuler::sensor::temperature::Ramp;
use schuler::sensor::temperature_bias::TemperatureBias;
use schuler::sensor::temperature_scale::TemperatureScale;
use schuler::sensor::triad::Triad;
use schuler_c::*;

const INTERVAL_S: f64 = 0.01;
const SAMPLES: u64 = 200;

/// A motion that turns and shakes.
fn perfect(sample: u64) -> [[f64; 3]; 2] {
    let wave = |k: f64| 0.01 * (0.1 * k * sample as f64).sin();
    [[wave(1.0), wave(2.0), 0.002 - wave(3.0)], [wave(4.0), 0.01 + wave(1.5), -0.098 + wave(2.5)]]
}

/// What the library reads.
fn read(gyros: &schuler_triad_f64, accelerometers: &schuler_triad_f64) -> Vec<[[f64; 3]; 2]> {
    // SAFETY: every pointer leads to a variable of this function.
    unsafe {
        let mut unit: schuler_emulator_f64 = std::mem::zeroed();
        let started = schuler_emulator_f64_start(
            &mut unit,
            SCHULER_ABI,
            INTERVAL_S,
            SAMPLES,
            gyros,
            accelerometers,
            7,
            2,
        );
        assert_eq!(started, SCHULER_OK);
        let one = |sample| {
            let [angle_b, velocity_b] = perfect(sample);
            let mut it = schuler_increment_f64 { angle_b, velocity_b };
            assert_eq!(schuler_emulator_f64_read(&mut unit, &it.clone(), &mut it), SCHULER_OK);
            [it.angle_b, it.velocity_b]
        };
        (0..SAMPLES).map(one).collect()
    }
}

/// What the core reads.
fn expected(gyros: Triad<f64>, accelerometers: Triad<f64>) -> Vec<[[f64; 3]; 2]> {
    let timing = Timing::new(INTERVAL_S, SAMPLES).unwrap();
    let emulator = Emulator::new(gyros, accelerometers, timing);
    let mut state = emulator.start(7, 2);
    let one = |sample| {
        let [angle_b, velocity_b] = perfect(sample).map(Vector::from);
        let it = emulator.emulate(&mut state, &Increment { angle_b, velocity_b });
        [it.angle_b.into_array(), it.velocity_b.into_array()]
    };
    (0..SAMPLES).map(one).collect()
}

const ROWS: [[f64; 3]; 3] = [[1e-4, 2e-4, -3e-4], [4e-4, -5e-4, 6e-4], [-7e-4, 8e-4, 9e-4]];
const THREE: [f64; 3] = [1e-3, -2e-3, 3e-3];
const RAMP: [f64; 3] = [-20.0, 15.0, 1.5];

#[test]
fn matrices_temperature_bandwidth_and_latency_are_the_cores() {
    let timing = Timing::new(INTERVAL_S, SAMPLES).unwrap();
    let matrix = Matrix::from(ROWS);
    let ramp = Ramp::new(RAMP[0], RAMP[1], RAMP[2], timing).unwrap();
    let (none, perfect) = (schuler_triad_f64::default(), Triad::PERFECT);
    let cases = [
        (
            schuler_triad_f64 { misalignment_matrix: ROWS, ..none },
            Triad {
                misalignment_matrix: Some(MisalignmentMatrix::new(matrix).unwrap()),
                ..perfect
            },
        ),
        (
            schuler_triad_f64 { g_sensitivity_matrix: ROWS, ..none },
            Triad {
                g_sensitivity_matrix: Some(GSensitivityMatrix::new(matrix).unwrap()),
                ..perfect
            },
        ),
        (
            schuler_triad_f64 { temperature_ramp: RAMP, temperature_bias: THREE, ..none },
            Triad {
                temperature_bias: Some(TemperatureBias::new(THREE.into(), ramp, timing).unwrap()),
                ..perfect
            },
        ),
        (
            schuler_triad_f64 { temperature_ramp: RAMP, temperature_scale: THREE, ..none },
            Triad {
                temperature_scale: Some(TemperatureScale::new(THREE.into(), ramp).unwrap()),
                ..perfect
            },
        ),
        (
            schuler_triad_f64 { bandwidth: [20.0, 30.0, 40.0], ..none },
            Triad {
                bandwidth: Some(Bandwidth::new([20.0, 30.0, 40.0].into(), timing).unwrap()),
                ..perfect
            },
        ),
        (
            schuler_triad_f64 { latency: [0.004, 0.02, 0.0], ..none },
            Triad {
                latency: Some(Latency::new([0.004, 0.02, 0.0].into(), timing).unwrap()),
                ..perfect
            },
        ),
    ];
    let untouched = read(&none, &none);
    assert_eq!(untouched, expected(perfect, perfect));
    let (mut all, mut all_cores) = (none, perfect);
    for (place, (triad, core)) in cases.iter().enumerate() {
        let found = read(triad, &none);
        assert_eq!(found, expected(*core, perfect), "gyros, case {place}");
        assert_ne!(found, untouched, "gyros, case {place}");
        let found = read(&none, triad);
        assert_eq!(found, expected(perfect, *core), "accelerometers, case {place}");
        match place {
            0 => {
                all.misalignment_matrix = ROWS;
                all_cores.misalignment_matrix = core.misalignment_matrix;
            }
            1 => {
                all.g_sensitivity_matrix = ROWS;
                all_cores.g_sensitivity_matrix = core.g_sensitivity_matrix;
            }
            _ => {}
        }
    }
    assert_eq!(read(&all, &none), expected(all_cores, perfect));
}

#[test]
fn what_is_wrong_with_them_has_a_name() {
    let none = schuler_triad_f64::default();
    let mut bad_matrix = ROWS;
    bad_matrix[1][2] = f64::NAN;
    let cases = [
        (
            schuler_triad_f64 { misalignment_matrix: bad_matrix, ..none },
            SCHULER_PARAMETER_MISALIGNMENT_MATRIX,
        ),
        (
            schuler_triad_f64 { g_sensitivity_matrix: bad_matrix, ..none },
            SCHULER_PARAMETER_G_SENSITIVITY_MATRIX,
        ),
        (
            schuler_triad_f64 {
                temperature_ramp: [f64::INFINITY, 0.0, 1.0],
                temperature_bias: THREE,
                ..none
            },
            SCHULER_PARAMETER_TEMPERATURE,
        ),
        (schuler_triad_f64 { temperature_bias: THREE, ..none }, SCHULER_PARAMETER_RAMP_TIME),
        (
            schuler_triad_f64 { temperature_ramp: RAMP, temperature_bias: [f64::NAN; 3], ..none },
            SCHULER_PARAMETER_TEMPERATURE_BIAS,
        ),
        (
            schuler_triad_f64 { temperature_ramp: RAMP, temperature_scale: [f64::NAN; 3], ..none },
            SCHULER_PARAMETER_TEMPERATURE_SCALE,
        ),
        (schuler_triad_f64 { bandwidth: [1.0, 0.0, 1.0], ..none }, SCHULER_PARAMETER_BANDWIDTH),
        (schuler_triad_f64 { latency: [0.0, 0.09, 0.0], ..none }, SCHULER_PARAMETER_LATENCY),
    ];
    for (bad, code) in cases {
        // SAFETY: every pointer leads to a variable of this function.
        let started = unsafe {
            let mut unit: schuler_emulator_f64 = std::mem::zeroed();
            schuler_emulator_f64_start(&mut unit, SCHULER_ABI, INTERVAL_S, 9, &bad, &none, 1, 0)
        };
        assert_eq!(started, code);
    }
}
