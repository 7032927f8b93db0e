"""A sensor from its data sheet: the values as they stand there, and the drift that they mean."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import schuler

# A tactical unit: what the sheet says, in its own units.
gyro = {
    "turn_on_bias_deg_h": 0.5,
    "bias_instability_deg_h": 0.1,
    "angle_random_walk_deg_sqrt_h": 0.02,
}
geometry = {"scale_factor_ppm": [100, -50, 80], "misalignment_arcsec": [10, -10, 5]}
accelerometer = {"turn_on_bias_ug": 200, "velocity_random_walk_m_s_sqrt_h": 0.01, "scale_factor_ppm": 100}
flights = {}
for title, factor in (("as on the sheet", 1.0), ("gyros ten times better", 0.1)):
    scene = {
        "title": title,
        "rate_hz": 100,
        "duration_s": 600,
        "trajectory": {
            "yaw_deg": {"offset": 30, "harmonics": [{"amplitude": 40, "period_s": 90}]},
            "roll_deg": {"harmonics": [{"amplitude": 10, "period_s": 20}]},
            "latitude_deg": {"offset": 48, "rate": 0.0009},
            "longitude_deg": {"offset": 11},
            "altitude_m": {"offset": 1000},
        },
        "gyro": {key: factor * value for key, value in gyro.items()} | geometry,
        "accelerometer": accelerometer,
    }
    flights[title] = schuler.run(scene, every="1s", vertical="held")

figure, axes = plt.subplots(1, 2, figsize=(11, 5), sharey=True)
for axis, (title, flight) in zip(axes, flights.items(), strict=True):
    drift = flight.drift
    for name in ("north_m", "east_m"):
        (line,) = axis.plot(drift["time_s"], drift[name], label=name)
        mean, sigma = drift[f"{name}_mean"], drift[f"{name}_sigma"]
        axis.fill_between(drift["time_s"], mean - 3 * sigma, mean + 3 * sigma, color=line.get_color(), alpha=0.15)
    axis.set(xlabel="s", ylabel="m", title=f"{title}: drift and theory’s 3σ")
    axis.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "own_sensor.png")
