"""Allan deviation: what a gyro's record at rest tells of its errors."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import schuler

RATE = 20
sensor = {"angle_random_walk_deg_sqrt_h": 0.02, "bias_instability_deg_h": 0.3, "rate_random_walk_deg_h_sqrt_h": 0.5}
scene = {"rate_hz": RATE, "duration_s": 4 * 3600, "trajectory": {"latitude_deg": {"offset": 45}}, "gyro": sensor}
angle = np.concatenate([[0.0], np.cumsum(schuler.emulate(scene).imu["dtheta_x_rad"])])

# σ²(τ) = ⟨(θ(t + 2τ) − 2θ(t + τ) + θ(t))²⟩ / 2τ², over all overlapping stretches.
lengths = np.unique(np.geomspace(1, len(angle) // 8, 60).astype(int))
tau_s = lengths / RATE
second = [angle[2 * n :] - 2 * angle[n:-n] + angle[: -2 * n] for n in lengths]
deviation = np.array([np.sqrt(np.mean(d**2) / 2) for d in second]) / tau_s * np.degrees(1) * 3600

walk = 0.02 * 60 / np.sqrt(tau_s)
assert abs(deviation[0] / walk[0] - 1) < 0.05
figure, axis = plt.subplots(figsize=(8, 5))
axis.loglog(tau_s, deviation, label="emulated gyro")
axis.loglog(tau_s, walk, "--", label="0.02 °/√h of its data sheet")
axis.axhline(0.664 * 0.3, color="0.6", linestyle=":", label="0.664 × 0.3 °/h, its bias instability")
axis.set(xlabel="averaging time, s", ylabel="Allan deviation, °/h", title="Four hours at rest")
axis.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "allan.png")
