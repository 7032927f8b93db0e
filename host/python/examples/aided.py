"""An aided flight: how far off it is beside what its filter says, the verdicts on its fixes, and the smoothed track.

A MEMS unit in a car with a satellite receiver that is silent for a minute. What the receiver delivers goes into a replay
of the same samples, too, which hides half a minute more of it.
"""

import sys
import tomllib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import schuler

scene = tomllib.loads(schuler.scene_text("aided-drive"))
scene["filter"] = {"smoother": True}
flight = schuler.run(scene)
aided = flight.aided
assert aided is not None and aided.smoothed is not None
drift, verdicts, found = flight.drift, aided.judged["position-velocity"], aided.estimates
print(aided)

data = schuler.emulate(scene)
replay = schuler.replay(data.imu, data.initial, gnss=data.gnss, sensors=scene, lever_arm=(0.5, -0.3, -1), withhold=[(200, 230)])
assert replay.aided is not None and replay.aided.withheld is not None
off = np.linalg.norm(replay.aided.withheld.array[0, 3:6])
print(f"after half a minute without fixes: {off:.1f} m off")

figure, axes = plt.subplots(3, figsize=(9, 9), sharex=True)
for name, colour in (("north_m", "tab:blue"), ("east_m", "tab:orange")):
    axes[0].plot(drift["time_s"], drift[name], colour, label=name)
    for sign in (-2, 2):
        axes[0].plot(drift["time_s"], sign * drift[f"{name}_sigma"], colour, linestyle=":")
smoothed, truth = aided.smoothed, flight.truth
true_deg = np.interp(smoothed["time_s"], truth["time_s"], truth["latitude_deg"])
axes[0].plot(smoothed["time_s"], (smoothed["latitude_deg"] - true_deg) * 6.37e6 * np.pi / 180, "k", label="north_m, smoothed")
axes[0].set(ylabel="error and 2σ, m", ylim=(-10, 10), title="A drive with fixes, and a minute without them")
taken = verdicts["accepted"] == 1
axes[1].semilogy(verdicts["time_s"][taken], (verdicts["nis"] / verdicts["degrees"])[taken], ".", label="taken")
axes[1].semilogy(verdicts["time_s"][~taken], (verdicts["nis"] / verdicts["degrees"])[~taken], "rx", label="refused")
axes[1].set(ylabel="NIS by its mean")
for axis in "xyz":
    axes[2].errorbar(
        found["time_s"][::500], found[f"gyro_bias_{axis}_deg_h"][::500], found[f"gyro_bias_{axis}_deg_h_sigma"][::500], label=f"gyro {axis}"
    )
axes[2].set(xlabel="s", ylabel="bias found, °/h")
for plot in axes:
    plot.legend(loc="upper left")
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "aided.png")
