"""Allan deviation: what a gyro's record at rest tells of its errors, as a section of a scene."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import schuler

# Four hours at rest of a gyro that is known, as if it were recorded.
sensor = {"angle_random_walk_deg_sqrt_h": 0.02, "rate_random_walk_deg_h_sqrt_h": 0.5}
scene = {"rate_hz": 20, "duration_s": 4 * 3600, "trajectory": {"latitude_deg": {"offset": 45}}, "gyro": sensor}
data = schuler.emulate(scene)
found = schuler.allan(imu=data.imu)
print(found)
walk = found.sections["gyro"]["angle_random_walk_deg_sqrt_h"]
assert np.allclose(walk, 0.02, rtol=0.05), walk

degree_per_hour = np.pi / 180 / 3600
figure, axis = plt.subplots(figsize=(8, 5))
for letter, colour in zip("xyz", ("tab:blue", "tab:orange", "tab:green"), strict=True):
    table = found.axes[f"gyro {letter}"]
    tau_s, deviation = table["tau_s"], table["deviation"] / degree_per_hour
    bounds = np.abs(np.array([table["lower_95"], table["upper_95"]]) / degree_per_hour - deviation)
    axis.errorbar(tau_s, deviation, bounds, fmt=".", color=colour, label=f"gyro {letter}")
    axis.loglog(tau_s, table["fitted"] / degree_per_hour, color=colour)
axis.set(xlabel="averaging time, s", ylabel="Allan deviation, °/h", title="Four hours at rest, and what fits them")
axis.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "allan.png")
