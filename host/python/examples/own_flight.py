"""A flight of one's own, from segments: what it is like, and what half an hour of it does to a navigator."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import schuler

scene = {
    "title": "A survey: up, four legs, home",
    "rate_hz": 50,
    "trajectory": {
        "start": {"latitude_deg": 47.3, "longitude_deg": 8.5, "altitude_m": 440, "course_deg": 60, "speed_m_s": 60},
        "segment": [
            {"straight_s": 20},
            {"climb_m": 800, "climb_m_s": 8, "blend_s": 5},
            *[{"straight_s": 60} if leg % 2 else {"turn_deg": 180, "bank_deg": 30, "blend_s": 3} for leg in range(8)],
            {"climb_m": -700, "climb_m_s": 6, "blend_s": 5},
            {"straight_s": 20},
        ],
    },
    "gyro": {"constant_deg_h": 1, "angle_random_walk_deg_sqrt_h": 0.1},
    "accelerometer": {"constant_ug": 200},
}

trajectory = schuler.Trajectory(scene)
for name, extremes in trajectory.extremes().items():
    print(f"{name:20} {np.round(extremes, 2)}")
flight = schuler.run(trajectory.scene, every="1s")
print(flight)

figure, (track, drift) = plt.subplots(1, 2, figsize=(11, 5))
track.plot(flight.truth["longitude_deg"], flight.truth["latitude_deg"], label="true")
track.plot(flight.nav["longitude_deg"], flight.nav["latitude_deg"], label="computed")
track.set(xlabel="longitude, °", ylabel="latitude, °", title="Track")
track.legend()
for name in ("north_m", "east_m", "down_m"):
    drift.plot(flight.drift["time_s"], flight.drift[name], label=name)
drift.set(xlabel="s", ylabel="m", title="Computed minus true")
drift.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "own_flight.png")
