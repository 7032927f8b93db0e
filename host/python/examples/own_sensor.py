"""A sensor from its data sheet: the values as they stand there, and the drift that they mean."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import schuler

# A tactical unit: what its sheet says, in the sheet's own units.
sheet = {
    "sample_rate_hz": 100,
    "gyro": {
        "noise_density_deg_s_sqrt_hz": 0.0003,
        "in_run_bias_stability_deg_h": 0.1,
        "bias_repeatability_deg_h": 0.5,
        "scale_factor_ppm": [100, -50, 80],
    },
    "accelerometer": {"noise_density_ug_sqrt_hz": 20, "bias_repeatability_mg": 0.2, "scale_factor_ppm": 100},
}
sensors = schuler.datasheet(sheet)
print(sensors)
turns = {
    "yaw_deg": {"offset": 30, "harmonics": [{"amplitude": 40, "period_s": 90}]},
    "roll_deg": {"harmonics": [{"amplitude": 10, "period_s": 20}]},
    "latitude_deg": {"offset": 48, "rate": 0.0009},
    "longitude_deg": {"offset": 11},
    "altitude_m": {"offset": 1000},
}
scene = {"rate_hz": 100, "duration_s": 600, "trajectory": turns, **sensors}
repeatable = {**scene, "gyro": {**sensors["gyro"], "turn_on_bias_deg_h": 0}}
flights = {}
for title, one in (("as on the sheet", scene), ("gyros calibrated at each start", repeatable)):
    flights[title] = schuler.run(one, every="1s", vertical="held")

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
