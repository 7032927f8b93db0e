//! The paper's flight, its first minute.

use super::Scene;
use schuler_scenes::paper;

pub const SCENE: Scene = Scene {
    name: "paper",
    duration_s: 60,
    rate_hz: paper::RATE_HZ as u32,
    channels: paper::CHANNELS,
    gyro: |timing| paper::gyro(timing).map(Into::into),
    accelerometer: |timing| paper::accelerometer(timing).map(Into::into),
};
