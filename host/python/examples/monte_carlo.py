"""Monte Carlo: 128 runs of the paper's flight, and whether they scatter as theory says."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import schuler

runs = schuler.ensemble("paper", runs=128, duration=900, at=30)
print(runs)
print(f"{runs.tests[1]} of {runs.tests[0]} tests against theory fail")

figure, axes = plt.subplots(1, 2, figsize=(11, 5))
for axis, number in zip(axes, (0, 6), strict=True):
    axis.plot(runs.time_s, runs.drift[:, :, number], color="0.8", linewidth=0.5)
    mean, sigma = runs.mean_theory[:, number], runs.sigma_theory[:, number]
    axis.fill_between(runs.time_s, mean - 2 * sigma, mean + 2 * sigma, alpha=0.2, label="theory, 2σ")
    for sign in (-2, 2):
        axis.plot(runs.time_s, runs.mean[:, number] + sign * runs.sigma[:, number], "k--")
    axis.set(xlabel="s", ylabel=runs.names[number], title="128 runs, their 2σ dashed")
    axis.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "monte_carlo.png")
