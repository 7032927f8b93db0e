"""A filter of one's own on emulated data: a position fix each second keeps a tactical unit in place.

Fifteen states: errors of position, velocity and attitude in north, east, down, and biases of gyros and accelerometers.
The filter is numpy's and the navigator Schuler's: what the filter finds goes back by `correct`.
"""

import sys
import tomllib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import schuler
from schuler.types import Array

RATE, SECONDS, FIX_M = 100, 300, 2.0
HOUR, DEGREE, MICRO_G = 3600.0, np.pi / 180, 9.80665e-6
EARTH_M = np.array([6.37e6, 6.39e6])

# The car of a built-in scene, with a unit of 20 °/h and 2 mg.
scene = tomllib.loads(schuler.scene_text("drive"))
scene["gyro"] = {"turn_on_bias_deg_h": 20, "angle_random_walk_deg_sqrt_h": 0.2}
scene["accelerometer"] = {"turn_on_bias_ug": 2000, "velocity_random_walk_m_s_sqrt_h": 0.06}
data = schuler.emulate(scene, rate=RATE, duration=SECONDS)
increments, truth = data.imu.array[:, 1:], data.truth.array[::RATE]
fixes = np.random.default_rng(1).normal(0, FIX_M, (SECONDS + 1, 3))


def difference(state: schuler.State, true: Array) -> Array:
    """North, east, down from a true position to a state, m."""
    latitude, longitude = state.latitude_deg - true[1], (state.longitude_deg - true[2] + 180) % 360 - 180
    north, east = np.array([latitude, longitude * np.cos(true[1] * DEGREE)]) * DEGREE * EARTH_M
    return np.array([north, east, true[3] - state.altitude_m])


def body_to_ned(state: schuler.State) -> Array:
    angles = np.array([state.roll_deg, state.pitch_deg, state.yaw_deg]) * DEGREE
    (sr, sp, sy), (cr, cp, cy) = np.sin(angles), np.cos(angles)
    return np.array(
        [
            [cp * cy, sr * sp * cy - cr * sy, cr * sp * cy + sr * sy],
            [cp * sy, sr * sp * sy + cr * cy, cr * sp * sy - sr * cy],
            [-sp, sr * cp, cr * cp],
        ]
    )


def cross(v: Array) -> Array:
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


free, aided = (schuler.Navigator(data.initial, RATE, window="0,4,0") for _ in range(2))
sigma = np.repeat([1.0, 0.1, 0.2 * DEGREE, 20 * DEGREE / HOUR, 2000 * MICRO_G], 3)
covariance, bias, errors = np.diag(sigma**2), np.zeros(6), np.zeros((SECONDS, 2))
noise = np.repeat([0, 0.06**2 / HOUR, (0.2 * DEGREE) ** 2 / HOUR, 0, 0], 3)
for second in range(1, SECONDS + 1):
    samples = increments[(second - 1) * RATE : second * RATE]
    free.fly(samples)
    aided.fly(samples - bias / RATE)
    # Over a second: ṗ = v, v̇ = −f × ψ + C b_a, ψ̇ = C b_g, for errors computed less true.
    attitude = body_to_ned(aided.state)
    f = np.zeros((15, 15))
    f[0:3, 3:6] = np.eye(3)
    f[3:6, 6:9] = -cross(attitude @ samples[:, 3:].sum(axis=0))
    f[3:6, 12:15] = f[6:9, 9:12] = attitude
    transition = np.eye(15) + f + f @ f / 2
    covariance = transition @ covariance @ transition.T + np.diag(noise)
    # The fix, and what it tells.
    gain = covariance[:, :3] @ np.linalg.inv(covariance[:3, :3] + FIX_M**2 * np.eye(3))
    found = gain @ (difference(aided.state, truth[second]) - fixes[second])
    covariance -= gain @ covariance[:3]
    aided.correct(position_ned_m=-found[:3], velocity_ned_m_s=-found[3:6], attitude_ned_rad=-found[6:9])
    bias += found[9:]
    errors[second - 1] = [np.linalg.norm(difference(navigator.state, truth[second])) for navigator in (free, aided)]

print(f"after {SECONDS} s: {errors[-1, 0]:.0f} m alone, {errors[-1, 1]:.1f} m with fixes of {FIX_M} m")
assert errors[SECONDS // 2 :, 1].max() < 3 * FIX_M < errors[-1, 0]
figure, axis = plt.subplots(figsize=(9, 5))
axis.semilogy(errors, label=["alone", f"with a fix of {FIX_M} m each second"])
axis.set(xlabel="s", ylabel="position error, m", title="A tactical unit in a car, alone and with fixes")
axis.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "own_filter.png")
