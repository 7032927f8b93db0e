"""Aided flights: their bits are those of the program, their verdicts what its counts count."""

from __future__ import annotations

import json
import re
import tempfile
import tomllib
import unittest
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from program import assert_same, columns, complaint, done, summary

import schuler
from schuler.types import Array

#: A drive with a barometer beside the receiver, which is silent for twenty seconds.
DRIVE = """rate_hz = 50
duration_s = 90
[filter]
smoother = true
[gnss]
rate_hz = 2
position_m = 1
velocity_m_s = 0.05
lever_arm_m = [0.5, -0.3, -1]
outages_s = [[40, 60]]
[barometer]
rate_hz = 1
"""


def drive() -> dict[str, Any]:
    """The built-in drive with what `DRIVE` says."""
    scene = tomllib.loads(schuler.scene_text("aided-drive"))
    return {**scene, **tomllib.loads(DRIVE)}


class Aiding(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def scene(self) -> Path:
        """The same as a file, in which the program finds it."""
        ours = tomllib.loads(DRIVE)
        kept = [
            part
            for part in re.split(r"\n(?=\[)", schuler.scene_text("aided-drive"))
            if part.partition("]")[0].removeprefix("[") not in ours
        ]
        head, *sections = kept
        lines = [line for line in head.splitlines() if line.partition(" ")[0] not in ours]
        file = self.folder / "mine.toml"
        own_head, own_sections = DRIVE.split("[", 1)
        file.write_text("\n".join([own_head, *lines, *sections, f"[{own_sections}"]))
        return file

    def test_a_flight_is_the_programs(self) -> None:
        scene = self.scene()
        printed = done("run", scene, "--rows", "--no-report", "--every", 3, "--out", self.folder)
        flight = schuler.run(scene, every=3)
        self.assertEqual(f"{flight}written to {self.folder}\n", printed)
        self.assertEqual(flight.digest, summary(self.folder)["digest"])
        self.assertEqual(schuler.run(drive(), rows=False).digest, flight.digest)
        assert_same(flight.nav, self.folder / "nav.csv")
        assert_same(flight.truth, self.folder / "truth.csv")
        # With the filter's standard deviations.
        assert_same(flight.drift, self.folder / "drift.csv")
        self.assertGreater(flight.drift["north_m_sigma"][1:].min(), 0)
        aided = flight.aided
        assert aided is not None
        self.assertIn(str(aided), printed)
        self.assertEqual(aided.smoothed is not None, "smoothed, " in printed)

    def test_verdicts_are_what_the_counts_count(self) -> None:
        flight = schuler.run(drive())
        aided = flight.aided
        assert aided is not None
        counts = {count["sensor"]: count for count in aided.summary["sensors"]}
        self.assertEqual(set(counts), {"gnss", "barometer"})
        for sensor, kind in {"gnss": "position-velocity", "barometer": "height"}.items():
            count, verdicts = counts[sensor], aided.judged[kind]
            accepted = verdicts["accepted"] == 1
            self.assertEqual((accepted.sum(), (~accepted).sum()), (count["accepted"], count["refused"]))
            self.assertGreater(accepted.sum(), 50)
            np.testing.assert_array_equal(accepted, verdicts["nis"] < verdicts["limit"])
            since = max(aided.summary["restarts_s"], default=-np.inf)
            settled = verdicts.array[accepted & (verdicts["time_s"] > since)]
            self.assertEqual(settled[:, 2].sum(), count["degrees"])
            np.testing.assert_allclose(settled[:, 3].sum(), count["nis"], rtol=1e-12)
            # What was delivered is what was judged.
            delivered = schuler.emulate(drive()).gnss[kind]
            np.testing.assert_allclose(verdicts["time_s"], delivered["time_s"][: len(verdicts)], rtol=1e-12)
        times = aided.judged["position-velocity"]["time_s"]
        self.assertFalse(np.any((times > 40) & (times <= 60)))

    def test_estimates_come_near_what_they_estimate(self) -> None:
        scene = drive()
        scene["gyro"] = {"constant_deg_h": [40, -30, 0], "angle_random_walk_deg_sqrt_h": 0.1}
        scene["accelerometer"] = {"constant_ug": [0, 0, 3000], "velocity_random_walk_m_s_sqrt_h": 0.05}
        flight = schuler.run(scene, rate=50, duration=300)
        aided = flight.aided
        assert aided is not None
        estimates = aided.estimates
        np.testing.assert_array_equal(estimates["time_s"], flight.nav["time_s"])
        truth = {"gyro_bias_x_deg_h": 40, "gyro_bias_y_deg_h": -30, "accelerometer_bias_z_ug": 3000}
        for name, true in truth.items():
            off, sigma = estimates[name] - true, estimates[f"{name}_sigma"]
            # Five standard deviations, which must have become less than half of what is found.
            self.assertLess(abs(off[-1]), 5 * sigma[-1], name)
            self.assertLess(sigma[-1], 0.5 * abs(true), name)
            self.assertLess(sigma[-1], sigma[0], name)
        self.assertIn("barometer_bias_m", estimates)
        last = schuler.run(scene, rate=50, duration=300, rows=False).aided
        assert last is not None
        np.testing.assert_array_equal(last.estimates.array, estimates.array[-1:])

    def test_a_replay_with_fixes_is_the_programs(self) -> None:
        scene = self.scene()
        names = ("imu.csv", "gnss.csv", "truth.csv", "initial.toml", "nav.csv", "smooth.csv")
        imu, gnss, truth, initial, nav, smooth = (self.folder / name for name in names)
        done("emulate", scene, "--out", imu, "--gnss", gnss, "--truth", truth)
        data = schuler.emulate(scene)
        self.assertEqual(set(data.gnss), {"position-velocity", "height"})
        lines = [line.split(",") for line in gnss.read_text().splitlines()]
        for kind, table in data.gnss.items():
            rows = [line for line in lines[1:] if line[2] == kind]
            for name in table.columns:
                written = [float(row[lines[0].index(name)]) for row in rows]
                np.testing.assert_array_equal(table[name], written)
        options = ("--sensors", scene, "--lever-arm", "0.5,-0.3,-1", "--withhold", "70..80", "--withhold", "20..30")
        printed = done(
            "replay", "--imu", imu, "--initial", initial, "--gnss", gnss, "--smooth", smooth, "--out", nav,
            "--reference", truth, *options,
        )  # fmt: skip
        given: tuple[Any, ...] = (gnss, data.gnss, {kind: dict(table) for kind, table in data.gnss.items()})
        digests = set()
        for fixes in given:
            replay = schuler.replay(
                imu, initial, gnss=fixes, sensors=scene, lever_arm=(0.5, -0.3, -1), smooth=True,
                withhold=[(70, 80), (20, 30)], reference=truth,
            )  # fmt: skip
            digests.add(replay.digest)
            assert_same(replay.nav, nav)
            aided = replay.aided
            assert aided is not None and aided.smoothed is not None and aided.withheld is not None
            assert_same(aided.smoothed, smooth)
            told = re.sub(", written to .*", "", printed)
            self.assertEqual(str(replay), re.sub("written to .*\n$", "", told))
            np.testing.assert_array_equal(aided.estimates["time_s"], replay.nav["time_s"])
            withheld = aided.withheld
            np.testing.assert_array_equal(withheld.array[:, :3], [[70, 80, 20], [20, 30, 20]])
            off = re.findall(r"withheld .* at the last ([-.\de]+) m off .* NEES ([-.\de]+) of 1", printed)
            norms = np.linalg.norm(withheld.array[:, 3:6], axis=1)
            np.testing.assert_allclose(norms, [float(m) for m, _ in off], rtol=5e-3)
            np.testing.assert_allclose(withheld["nees"] / 3, [float(nees) for _, nees in off], rtol=5e-3, atol=5e-3)
            times = aided.judged["position-velocity"]["time_s"]
            self.assertFalse(np.any((times >= 20) & (times < 30)))
        self.assertEqual(len(digests), 1)
        self.assertIsNone(schuler.replay(imu, initial).aided)

    def test_fixes_in_arrays(self) -> None:
        data = schuler.emulate(drive(), duration=30)
        table = data.gnss["position-velocity"]
        place = {name: table[name] for name in ("time_s", "latitude_deg", "longitude_deg", "altitude_m")}
        sigma = {f"{axis}_m_sigma": np.ones(len(table)) for axis in ("north", "east", "down")}
        aided = schuler.replay(data.imu, data.initial, gnss={**place, **sigma}).aided
        assert aided is not None
        self.assertEqual({kind: len(rows) for kind, rows in aided.judged.items()}, {"position": len(table)})

    def refused(self, **options: Any) -> schuler.InputError:
        with self.assertRaises(schuler.InputError) as raised:
            schuler.replay(self.data.imu, self.data.initial, **options)
        self.assertNotIn(tempfile.gettempdir(), str(raised.exception))
        return raised.exception

    def test_what_cannot_be(self) -> None:
        self.data = schuler.emulate(drive(), duration=10)
        gnss = self.data.gnss
        self.assertEqual(self.refused(lever_arm=(1, 2, 3)).accepted, "--gnss")
        self.assertEqual(self.refused(gnss=gnss, withhold=[(3, 1)]).key, "--withhold")
        self.assertEqual(self.refused(gnss=gnss, sensors={"gyro": {"noise": 3}}).key, "sensors.gyro.noise")
        self.assertEqual(self.refused(gnss={"time": [1]}).key, "gnss.time")
        self.assertEqual(self.refused(gnss={"time_s": [1, 2], "altitude_m": [3]}).key, "gnss.altitude_m")
        self.assertEqual(self.refused(gnss={"height": 3}).key, "gnss.height")
        broken = {kind: {name: table[name].copy() for name in table} for kind, table in gnss.items()}
        broken["height"]["down_m_sigma"][4] = -1
        self.assertEqual(self.refused(gnss=broken).key, "gnss.height.down_m_sigma[4]")
        files = {name: self.folder / name for name in ("imu.csv", "gnss.csv", "initial.toml", "nav.csv")}
        done("emulate", self.scene(), "--duration", 10, "--out", files["imu.csv"], "--gnss", files["gnss.csv"])
        wrong: tuple[tuple[str, str, Any], ...] = (
            ("--lever-arm", "lever_arm", "1,2"),
            ("--gnss-sigma", "gnss_sigma", "1,2,0"),
            ("--velocity-lag", "velocity_lag", "never"),
            ("--gnss-lag", "gnss_lag", 1e11),
            ("--vertical", "vertical", "held"),
            ("--algorithm", "algorithm", "textbook"),
        )
        for option, name, value in wrong:
            told = complaint(
                "replay", "--imu", files["imu.csv"], "--initial", files["initial.toml"], "--gnss", files["gnss.csv"],
                option, value, "--out", files["nav.csv"],
            )  # fmt: skip
            error = self.refused(gnss=gnss, **{name: value})
            self.assertEqual(error.key, option)
            self.assertIn(str(error).removeprefix(f"{option}: "), told)

    def assert_told(self, told: Mapping[str, Array], groups: list[str], names: list[str], file: str) -> None:
        """What is told of the instants is a file of them, bit for bit."""
        mine = {"time_s": told["time_s"]}
        for kind in ("rms", "sigma"):
            mine |= {f"{name}_{kind}": told[kind][:, i] for i, name in enumerate(names)}
        for i, name in enumerate(groups):
            mine[f"nees_{name}"] = told["nees"][:, i]
            mine |= {f"nees_{name}_{end}": told["nees_expected"][:, i, j] for j, end in enumerate(("least", "most"))}
        written = columns(self.folder / file)
        self.assertEqual(list(mine), list(written))
        for name, numbers in written.items():
            self.assertGreater(len(numbers), 1)
            np.testing.assert_array_equal(mine[name], numbers, err_msg=f"{file}: {name}")

    def test_an_ensemble_is_the_programs(self) -> None:
        scene = self.scene()
        printed = done(
            "ensemble", scene, "--runs", 6, "--duration", 80, "--at", "30s,55s", "--budget", 4, "--keep", "--out", self.folder
        )  # fmt: skip
        runs = schuler.aided_ensemble(scene, 6, at=[30, 55], budget=4, duration=80)
        self.assertIsInstance(runs, schuler.AidedEnsemble)
        self.assertIn("What each term contributes", runs.text)
        self.assertTrue(printed.startswith(f"{runs.text}6 runs in "), printed)
        self.assertEqual((str(runs), runs.runs, runs.failed), (runs.text, 6, []))
        self.assertEqual((runs.drift.shape, runs.nees_expected.shape), ((3, 6, 9), (3, 4, 2)))
        # Blocks of some samples end soon after.
        np.testing.assert_allclose(runs.time_s, [30, 55, 80], atol=0.2)
        told = {name: getattr(runs, name) for name in ("time_s", "rms", "sigma", "nees", "nees_expected")}
        self.assert_told(told, runs.groups, runs.names, "aided.csv")
        assert runs.smoothed is not None
        self.assert_told(runs.smoothed, runs.groups, runs.names, "smoothed.csv")
        every = columns(self.folder / "runs.csv")
        np.testing.assert_array_equal(every["run"], np.repeat(np.arange(6), 3))
        np.testing.assert_array_equal(every["time_s"], np.tile(runs.time_s, 6))
        for i, name in enumerate(runs.names):
            np.testing.assert_array_equal(runs.drift[:, :, i].T.ravel(), every[name], err_msg=name)
        written = json.loads((self.folder / "ensemble.json").read_text())
        for key in ("command", "files"):
            written.pop(key)
        self.assertEqual(runs.summary, written)
        self.assertEqual((runs.verdict, runs.tests[0]), (written["verdict"], 12))
        # Each names the command line that it was made by.
        pages = (runs.report(), (self.folder / "ensemble.html").read_text())
        own, programs = (re.sub("<code>schuler .*?</code>", "", page) for page in pages)
        self.assertEqual(own, programs)
        self.assertIn("<iframe", runs._repr_html_())
        single = schuler.aided_ensemble(scene, runs=6, at="30s,55s", threads=1, duration=80)
        np.testing.assert_array_equal(single.drift, runs.drift)

    def test_an_ensemble_is_its_flights(self) -> None:
        runs = schuler.aided_ensemble(drive(), runs=4, at=1, duration=40)
        flights = [schuler.run(drive(), run=number, duration=40).drift for number in range(4)]
        last = {name: np.array([flight[name][-1] for flight in flights]) for name in flights[0]}
        for i, name in enumerate(runs.names):
            np.testing.assert_allclose(runs.drift[-1, :, i], last[name], rtol=1e-12, err_msg=name)
            np.testing.assert_allclose(runs.rms[-1, i], np.sqrt(np.mean(last[name] ** 2)), rtol=1e-12)
            np.testing.assert_allclose(runs.sigma[-1, i], np.sqrt(np.mean(last[f"{name}_sigma"] ** 2)), rtol=1e-12)
        self.assertIsNone(schuler.aided_ensemble("aided-drive", runs=4, at=1, duration=5).smoothed)

    def test_each_ensemble_refuses_the_others_scenes(self) -> None:
        with self.assertRaises(schuler.InputError) as raised:
            schuler.ensemble("aided-drive", runs=4)
        told = "scene: is aided; accepted: aided_ensemble(), or a scene that is not"
        self.assertEqual((str(raised.exception), raised.exception.key), (told, "scene"))
        with self.assertRaises(schuler.InputError) as raised:
            schuler.aided_ensemble("paper", runs=4)
        told = "scene: is not aided; accepted: a scene with [gnss] or the like; ensemble() flies others"
        self.assertEqual((str(raised.exception), raised.exception.key), (told, "scene"))
        told = complaint("ensemble", "aided-drive", "--at", "700s", "--out", self.folder)
        with self.assertRaises(schuler.InputError) as raised:
            schuler.aided_ensemble("aided-drive", at="700s")
        self.assertEqual(str(raised.exception), told)

    def test_a_page_is_made_once(self) -> None:
        flight = schuler.run("paper", duration=10)
        self.assertIs(type(flight.report()), str)
        self.assertEqual(flight.report(), flight.report())


if __name__ == "__main__":
    unittest.main()
