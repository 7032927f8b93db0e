"""Flies the files of a folder with the feedback filter of pyins: pyins.csv, and pyins.cost in µs per sample.

fly_pyins.py FOLDER …
"""

import math
import pathlib
import sys
import time
import tomllib

import numpy
import pandas
from pyins import filters, inertial_sensor, measurements, strapdown, util

PLACE = ["latitude_deg", "longitude_deg", "altitude_m"]
VELOCITY = ["north_m_s", "east_m_s", "down_m_s"]
ATTITUDE = ["roll_deg", "pitch_deg", "yaw_deg"]
SAMPLE = ["dtheta_x_rad", "dtheta_y_rad", "dtheta_z_rad", "dvel_x_m_s", "dvel_y_m_s", "dvel_z_m_s"]


def flat(name):
    return tomllib.loads(name.read_text())


def increments(table):
    """With the coning and sculling of pyins, which wants a sample from before the first one."""
    samples = table[SAMPLE].set_axis(util.GYRO_COLS + util.ACCEL_COLS, axis=1)
    before = samples.iloc[:1].set_axis([0.0])
    return strapdown.compute_increments_from_imu(pandas.concat([before, samples]), "increment")


def fixes(table, settings):
    """Positions and, where there are any, velocities; both know the lever arm."""
    lever = [settings[key] for key in ("lever_forward_m", "lever_right_m", "lever_down_m")]
    columns = [(PLACE, util.LLA_COLS, measurements.Position), (VELOCITY, util.VEL_COLS, measurements.NedVelocity)]
    sigmas = [settings["fix_position_m"], settings["fix_velocity_m_s"]]
    told = []
    for (names, called, kind), sigma in zip(columns, sigmas):
        rows = table[names].dropna().set_axis(called, axis=1)
        if len(rows):
            told.append(kind(rows, sigma, lever))
    return told


def fly(folder, seconds=math.inf):
    """The filter's answer, and the CPU time of it alone, µs per sample."""
    settings, initial = flat(folder / "settings.toml"), flat(folder / "initial.toml")
    table = pandas.read_csv(folder / "imu.csv", index_col="time_s")
    samples = increments(table[table.index <= seconds])
    told = fixes(pandas.read_csv(folder / "gnss.csv", index_col="time_s"), settings)
    start = pandas.Series(
        [initial[key] for key in PLACE + VELOCITY + ATTITUDE], index=util.TRAJECTORY_COLS, name=0.0
    )
    gyro, accelerometer = (
        inertial_sensor.EstimationModel(bias_sd=settings[bias], noise=settings[noise])
        for bias, noise in (
            ("gyro_bias_rad_s", "gyro_noise_rad_root_s"),
            ("accelerometer_bias_m_s2", "accelerometer_noise_m_s_root_s"),
        )
    )
    begun = time.process_time()
    answer = filters.run_feedback_filter(
        start,
        settings["position_m"],
        settings["velocity_m_s"],
        math.degrees(settings["level_rad"]),
        math.degrees(settings["heading_rad"]),
        samples,
        gyro,
        accelerometer,
        told,
    )
    return answer, (time.process_time() - begun) / len(samples) * 1e6


def write(folder, answer, cost):
    """A row wherever pyins tells a standard deviation."""
    sigma = answer.trajectory_sd[util.NED_COLS].add_suffix("_m_sigma")
    rows = answer.trajectory.loc[sigma.index, util.TRAJECTORY_COLS].set_axis(PLACE + VELOCITY + ATTITUDE, axis=1)
    table = pandas.concat([rows, sigma], axis=1).rename_axis("time_s")
    table.iloc[1:].to_csv(folder / "pyins.csv")
    (folder / "pyins.cost").write_text(f"{cost}\n")


folders = [pathlib.Path(name) for name in sys.argv[1:]]
# What numba compiles is compiled before anything is timed.
fly(folders[0], 5.0)
for folder in folders:
    write(folder, *fly(folder))
