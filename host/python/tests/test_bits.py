"""The bits of the package are those of the program."""

from __future__ import annotations

import json
import os
import re
import tempfile
import tomllib
import unittest
from pathlib import Path
from typing import Any

import numpy as np
from program import GOLDEN, TURNS, assert_same, complaint, done, summary

import schuler


def digest(rows: np.ndarray[Any, np.dtype[np.uint64]]) -> str:
    """The core's, over again: four lanes, each state from the first."""

    def mix(total: int, word: int) -> int:
        product = (total ^ word) * 0x9E37_79B9_7F4A_7C15 & 0xFFFF_FFFF_FFFF_FFFF
        return product ^ product >> 32

    lanes = [1, 2, 3, 4]
    for row in rows.tolist():
        for place, word in enumerate(row):
            lanes[place % 4] = mix(lanes[place % 4], word)
    total = mix(0, rows.size)
    for lane in lanes:
        total = mix(total, lane)
    return f"{total:016x}"


class Bits(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_digests_of_the_golden_chains(self) -> None:
        chains = [chain for scene in ("paper", "turns") for chain in sorted((GOLDEN / scene).glob("f*.chain"))]
        self.assertEqual(len(chains), 36)
        for chain in chains:
            text = chain.read_text()
            head = dict(re.findall(r"^(scene|configuration|duration_s): (.*)$", text, re.MULTILINE))
            golden = {stage: (int(n), told) for stage, n, told in re.findall(r"^(\w+) = (\d+) ([0-9a-f]+)$", text, re.MULTILINE)}
            scene = TURNS if head["scene"] == "turns" else head["scene"]
            data = schuler.emulate(scene, duration=float(head["duration_s"]))
            flown = schuler.steps(data.initial, data.scene.rate_hz, data.imu, name=head["configuration"])
            last = int(flown.sample[-1])
            self.assertEqual({"body": (last, flown.body_digest), "nav": (last, flown.nav_digest)}, golden, chain)
            self.assertEqual(flown.nav_digest, digest(flown.nav))
            # The navigator of the same name has been in the same states.
            navigator = schuler.Navigator(data.initial, data.scene.rate_hz, name=head["configuration"])
            navigator.fly(data.imu)
            navigator.finish()
            self.assertEqual(navigator.integrated, last)

    def test_digests_and_summaries_of_the_program(self) -> None:
        for scene in ("paper", TURNS):
            for options in ({}, {"precision": "f32", "window": "0,4,0"}, {"algorithm": "textbook"}):
                given = [x for name, value in options.items() for x in (f"--{name}", value)]
                printed = done("run", scene, "--no-report", "--out", self.folder, *given)
                told = summary(self.folder)
                flight = schuler.run(scene, rows=False, **options)  # type: ignore[arg-type]
                self.assertEqual(f"{flight}written to {self.folder}\n", printed)
                self.assertEqual(flight.digest, told["digest"], (scene, options))
                for key in ("time", "command", "files"):
                    told.pop(key)
                mine = flight.summary
                mine.pop("time")
                # What the program measures with a clock.
                for skipped in (*told.get("skipped", []), *mine.get("skipped", [])):
                    skipped.pop("saved")
                self.assertEqual(mine, told)

    def test_rows_of_a_run(self) -> None:
        done("run", "paper", "--duration", 60, "--rows", "--no-report", "--every", 7, "--out", self.folder)
        flight = schuler.run("paper", duration=60, every=7)
        assert_same(flight.nav, self.folder / "nav.csv")
        assert_same(flight.truth, self.folder / "truth.csv")
        assert_same(flight.drift, self.folder / "drift.csv")

    def test_emulated_samples_and_their_replay(self) -> None:
        imu, nav, truth = (self.folder / name for name in ("imu.csv", "nav.csv", "truth.csv"))
        done("emulate", "drive", "--duration", 30, "--out", imu, "--truth", truth)
        data = schuler.emulate("drive", duration=30)
        assert_same(data.imu, imu)
        assert_same(data.truth, truth)
        initial = self.folder / "initial.toml"
        self.assertEqual(schuler.State.read(initial).as_dict(), data.initial.as_dict())
        done("replay", "--imu", imu, "--initial", initial, "--reference", truth, "--out", f"{self.folder}/again/")
        told = summary(self.folder / "again")
        for source in (imu, data.imu, data.imu.array):
            for start in (initial, data.initial, data.initial.as_dict()):
                replay = schuler.replay(source, start, reference=truth)
                self.assertEqual(replay.digest, told["digest"])
                assert_same(replay.nav, self.folder / "again/nav.csv")
        told_of_array = replay.summary
        assert told_of_array is not None
        self.assertEqual(told_of_array["error"], told["error"])
        self.assertIn("<svg", replay.report() or "")

    def test_a_navigator_fed_by_hand(self) -> None:
        data = schuler.emulate("manoeuvre", duration=10)
        start = data.initial.as_dict()
        for name in ("f64 local-level taylor 2,4,2", "f32 earth-fixed taylor 0,4,0", "f32x2 local-level taylor 2,4,2"):
            precision, frame, algorithm, window = name.split()
            whole = schuler.Navigator(start, 100, name=name)
            rows = whole.fly(data.imu)
            last = whole.finish()
            by_program = schuler.replay(
                data.imu, start, precision=precision, frame=frame, algorithm=algorithm, window=window  # type: ignore[arg-type]
            )
            self.assertEqual(whole.digest, by_program.digest)
            flown = [dict(zip(rows.columns, row, strict=True)) for row in rows.array.tolist()]
            flown += [row.as_dict() for row in last]
            told = by_program.nav
            self.assertEqual(flown, [dict(zip(told.columns, row, strict=True)) for row in told.array.tolist()])
            single = schuler.Navigator(start, 100, name=name)
            by_hand = [row for sample in data.imu.array[:, 1:] for row in single.push(sample[:3], sample[3:])]
            single.finish()
            self.assertEqual((single.digest, single.state, len(by_hand)), (whole.digest, whole.state, len(rows)))

    def test_intervals_of_their_own(self) -> None:
        data = schuler.emulate("manoeuvre", duration=5, perfect=True)
        samples, nominal = data.imu.array[:, 1:], np.full(500, 0.01)
        even, told = (schuler.Navigator(data.initial, 100, window=(2, 4, 2)) for _ in range(2))
        even.fly(samples)
        told.fly(samples, nominal)
        self.assertEqual(even.digest, told.digest)
        # Every second sample and the one after it in one.
        merged = schuler.Navigator(data.initial, 100, window="2,4,2")
        pairs = np.concatenate([samples[:100], samples[100:].reshape(-1, 2, 6).sum(axis=1)])
        rows = merged.fly(pairs, np.repeat([0.01, 0.02], [100, 200]))
        at = np.rint(rows["time_s"] * 100).astype(int)
        np.testing.assert_allclose(rows["time_s"], at / 100, rtol=1e-12)
        np.testing.assert_allclose(rows["altitude_m"], data.truth["altitude_m"][at], atol=1e-3)

    def test_an_ensemble(self) -> None:
        runs = schuler.ensemble("paper", runs=8, duration=120, threads=2, at=4)
        flight = schuler.run("paper", duration=120)
        self.assertEqual(runs.drift.shape, (4, 8, 9))
        np.testing.assert_array_equal(runs.drift[-1, 0], flight.drift.array[-1, 1:10])
        np.testing.assert_allclose(runs.mean, runs.drift.mean(axis=1), rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(runs.sigma, runs.drift.std(axis=1, ddof=1), rtol=1e-9, atol=1e-12)
        last = flight.drift.array[-1]
        np.testing.assert_allclose(runs.sigma_theory[-1], last[19:28], rtol=1e-9)
        np.testing.assert_allclose(runs.sigma**2, np.diagonal(runs.covariance, axis1=1, axis2=2), rtol=1e-9)
        np.testing.assert_allclose(np.cov(runs.drift[-1].T), runs.covariance[-1], rtol=1e-6, atol=1e-12)
        done("ensemble", "paper", "--runs", 8, "--duration", 120, "--at", 4, "--out", self.folder)
        told = json.loads((self.folder / "ensemble.json").read_text())
        mine = runs.summary
        self.assertEqual((mine["final"], mine["tests"], mine["verdict"]), (told["final"], told["tests"], told["verdict"]))
        self.assertEqual(runs.report(), (self.folder / "ensemble.html").read_text())
        assert_same(runs.accuracy, self.folder / "accuracy.csv")
        times = schuler.ensemble("paper", runs=4, duration=120, at=[30, 60]).time_s
        np.testing.assert_allclose(times, [30, 60, 120], atol=0.2)
        single = schuler.ensemble("paper", runs=8, duration=120, threads=1, at=4)
        np.testing.assert_array_equal(single.drift, runs.drift)

    def test_allan_deviation_and_data_sheets(self) -> None:
        printed = done("allan", "paper", "--duration", 3600, "--out", self.folder)
        found = schuler.allan("paper", duration=3600)
        self.assertEqual(printed, f"{found}\nwritten to {self.folder}\n")
        # Each names the command line that it was made by.
        pages = (found.report(), (self.folder / "allan.html").read_text())
        mine, written = (re.sub("<code>.*?</code>", "", page, count=1) for page in pages)
        self.assertEqual(mine, written)
        self.assertEqual(found.sections, tomllib.loads((self.folder / "sensors.toml").read_text()))
        lines = [line.split(",") for line in (self.folder / "allan.csv").read_text().splitlines()[1:]]
        for name, table in found.axes.items():
            told = np.array([line[1:] for line in lines if line[0] == name], dtype=float)
            np.testing.assert_array_equal(table.array, told)
        imu = self.folder / "imu.csv"
        still = {"gyro": {"angle_random_walk_deg_sqrt_h": 0.1}, "rate_hz": 10, "duration_s": 1000}
        data = schuler.emulate(still)
        rows = [data.imu.columns, *data.imu.array.tolist()]
        imu.write_text("".join(",".join(map(str, row)) + "\n" for row in rows))
        by_program = done("allan", "--imu", imu)
        self.assertEqual(str(schuler.allan(imu=imu)), by_program)
        self.assertEqual(str(schuler.allan(imu=data.imu)), by_program.replace(str(imu), "imu"))
        sheet = {"gyro": {"noise_density_deg_h_sqrt_hz": 6}, "accelerometer": {"bias_repeatability_mg": [1, 2, 3]}}
        sections = schuler.datasheet(sheet)
        self.assertAlmostEqual(sections["gyro"]["angle_random_walk_deg_sqrt_h"], 0.1, 12)
        schuler.Scene({**still, **sections})
        with self.assertRaises(schuler.InputError) as raised:
            schuler.datasheet({"gyro": {"noise": 3}})
        self.assertEqual(raised.exception.key, "gyro.noise")

    def test_alignment(self) -> None:
        data = schuler.emulate("stationary", duration=120)
        aligned = schuler.align(data.imu, 20, data.initial)
        found, true = aligned.state, data.initial
        self.assertAlmostEqual(found.roll_deg, true.roll_deg, 5)
        self.assertAlmostEqual(found.pitch_deg, true.pitch_deg, 5)
        self.assertAlmostEqual(found.yaw_deg, true.yaw_deg, 4)
        self.assertIn("aligned on 2400 samples", aligned.text)
        given = schuler.align(data.imu, 20, data.initial, heading=12)
        self.assertEqual((round(given.state.yaw_deg, 9), given.heading_sigma_deg), (12, None))
        text = self.folder / "imu.csv"
        done("emulate", "stationary", "--duration", 120, "--out", text)
        told = complaint(
            "replay", "--imu", text, "--initial", self.folder / "initial.toml", "--align", 60, "--units", "g", "--out", self.folder / "nav.csv"
        )
        with self.assertRaises(schuler.InputError) as raised:
            schuler.replay(text, self.folder / "initial.toml", align=60, units="g")
        self.assertEqual(str(raised.exception), told)


if __name__ == "__main__":
    os.environ.setdefault("SCHULER_ROOT", ".")
    unittest.main()
