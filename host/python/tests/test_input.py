"""Scenes in every form, and what is wrong with them."""

from __future__ import annotations

import copy
import pickle
import tempfile
import tomllib
import unittest
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from program import complaint

import schuler

CAR: dict[str, Any] = {
    "rate_hz": 50,
    "trajectory": {
        "attitude": "upright",
        "start": {"latitude_deg": 45, "longitude_deg": 179.97, "altitude_m": 100, "course_deg": 80},
        "segment": [{"hold_s": 5}, {"accelerate_to_m_s": 14, "blend_s": 8}, {"straight_s": np.int64(10)}],
    },
    "gyro": {"constant_deg_h": [1, np.float32(0.5), 0.1], "gauss_markov": None},
}


class Input(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def refused(self, *arguments: Any, **options: Any) -> schuler.InputError:
        with self.assertRaises(schuler.InputError) as raised:
            schuler.run(*arguments, **options)
        self.assertIsInstance(raised.exception, ValueError)
        return raised.exception

    def test_every_form_of_a_scene_is_the_same(self) -> None:
        text = schuler.scene_text("circuit")
        file = self.folder / "mine.toml"
        file.write_text(text)
        forms: list[Any] = ["circuit", text, str(file), file, tomllib.loads(text), schuler.Scene(text)]
        digests = {schuler.run(form, duration=5, rows=False).digest for form in forms}
        self.assertEqual(len(digests), 1)
        scenes = [schuler.Scene(form) for form in forms]
        self.assertEqual({(s.duration_s, s.rate_hz, s.seed, s.samples) for s in scenes}, {(1800, 100, 1, 180_000)})
        self.assertEqual([scene.name for scene in scenes], ["circuit", "scene", "mine", "mine", "scene", "scene"])
        self.assertIn("circuit", schuler.scenes())

    def test_errors_have_the_texts_of_the_program(self) -> None:
        file = self.folder / "mine.toml"
        file.write_text("rate_hz = 20\nduration_s = 60\n\n[gyro]\nconstant_deg = 1\n")
        for arguments in ([file], ["papre"], ["nowhere/mine.toml"], [file.with_name("none.toml")]):
            told = complaint("run", *arguments, "--out", self.folder)
            self.assertEqual(str(self.refused(*arguments)), told)
        error = self.refused(file)
        self.assertEqual((error.file, error.line, error.key), (str(file), 5, "gyro.constant_deg"))
        self.assertIn("constant_deg_h", error.accepted)
        told = complaint("run", "paper", "--duration", 1e-3, "--out", self.folder)
        self.assertEqual(str(self.refused("paper", duration=1e-3)), told)
        told = complaint("run", "paper", "--precision", "f32x2", "--window", "0,40,0", "--out", self.folder)
        self.assertEqual(str(self.refused("paper", precision="f32x2", window="0,40,0")), told)
        told = complaint("ensemble", "hard", "--out", self.folder)
        with self.assertRaises(schuler.InputError) as raised:
            schuler.ensemble("hard")
        self.assertEqual(str(raised.exception), told)

    def test_errors_of_dicts_name_the_key(self) -> None:
        wrong = copy.deepcopy(CAR)
        wrong["trajectory"]["segment"][1]["blend"] = 3
        error = self.refused(wrong)
        self.assertEqual((error.file, error.line, error.key), (None, None, "trajectory.segment[1].blend"))
        self.assertTrue(str(error).startswith("trajectory.segment[1].blend: is not a key of"))
        self.assertEqual(self.refused({**CAR, "rate_hz": np.nan}).key, "rate_hz")
        self.assertEqual(self.refused({**CAR, "title": object()}).key, "title")
        self.assertEqual(self.refused({**CAR, "seed": [None]}).key, "seed[0]")
        # An error is itself in another process.
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.key), (str(error), error.key))

    def test_options_are_checked(self) -> None:
        for options in ({"seed": -1}, {"rate": 0.5}, {"frame": "level"}, {"window": (1, 2, 3)}, {"every": "0s"}):
            error = self.refused("paper", **options)
            self.assertEqual(error.key, f"--{next(iter(options))}")
        with self.assertRaisesRegex(TypeError, "did you mean `?duration"):
            schuler.run("paper", duratoin=3)  # type: ignore[call-arg]
        with self.assertRaisesRegex(TypeError, "seed"):
            schuler.Navigator({"latitude_deg": 1, "longitude_deg": 2}, 100, seed=3)  # type: ignore[call-arg]
        with self.assertRaises(TypeError):
            schuler.run(3)  # type: ignore[arg-type]
        with self.assertRaisesRegex(schuler.InputError, "latitude_deg: 91 is out of range"):
            schuler.State(latitude_deg=91, longitude_deg=0)

    def test_a_log_in_arrays_is_a_log_in_a_file(self) -> None:
        start = {**CAR["trajectory"]["start"], "speed_m_s": 14}
        segments = [{"straight_s": 8}, {"accelerate_to_m_s": 20, "blend_s": 8}, {"straight_s": 10}]
        path = schuler.Trajectory({"attitude": "upright", "start": start, "segment": segments}, rate=50)
        times = np.arange(0, 20, 0.5)
        rows = path.at(times)
        names = ["time_s", "latitude_deg", "longitude_deg", "altitude_m"]
        file = self.folder / "log.csv"
        lines = [",".join(names), *(",".join(repr(float(rows[name][i])) for name in names) for i in range(len(rows)))]
        file.write_text("\n".join(lines) + "\n")
        motions: list[dict[str, Any]] = [{"log": {"file": str(file)}}, {"log": {name: rows[name] for name in names}}]
        digests = {schuler.run({"rate_hz": 50, "trajectory": motion}, rows=False).digest for motion in motions}
        self.assertEqual(len(digests), 1)
        again = schuler.Trajectory(motions[1]).at(times)
        np.testing.assert_allclose(again["latitude_deg"], rows["latitude_deg"], atol=1e-9)
        log = {name: rows[name].copy() for name in names}
        log["time_s"][3] = 0.0
        with self.assertRaises(schuler.InputError) as raised:
            schuler.Trajectory({"log": log})
        self.assertEqual(raised.exception.key, "trajectory.log.time_s[3]")
        self.assertNotIn(tempfile.gettempdir(), str(raised.exception))
        log["time_s"] = log["time_s"][:-1]
        with self.assertRaisesRegex(schuler.InputError, "has 40 values; accepted: 39 of them"):
            schuler.Trajectory({"log": log})

    def test_a_flight_that_ends_early_is_kept(self) -> None:
        lossy = {**tomllib.loads(schuler.scene_text("paper")), "link": {"loss": 0.01}}
        with self.assertRaises(schuler.FlightError) as raised:
            schuler.run(lossy)
        flight = raised.exception.flown
        assert isinstance(flight, schuler.Flight)
        self.assertEqual(flight.ended, str(raised.exception))
        self.assertIn("was lost on the link", str(raised.exception))
        self.assertEqual(len(flight.nav), flight.samples + 1)
        self.assertGreater(schuler.emulate(lossy, duration=60).lost, 0)
        bridged = schuler.run(lossy, gap="bridge", duration=60)
        self.assertIsNone(bridged.ended)

    def test_a_navigator_refuses_and_goes_on(self) -> None:
        start = {"latitude_deg": 45, "longitude_deg": 10, "altitude_m": 100}
        navigator = schuler.Navigator(start, 100, window="0,4,0")
        still = np.tile([0, 0, 0, 0, 0, -0.0980665], (8, 1))
        broken = still.copy()
        broken[5, 0] = np.nan
        with self.assertRaisesRegex(schuler.FlightError, "^sample 6 at 0.06 s: ") as raised:
            navigator.fly(broken)
        flown = raised.exception.flown
        assert isinstance(flown, schuler.Table)
        self.assertEqual((len(flown), navigator.taken, navigator.integrated), (4, 5, 4))
        navigator.fly(still[5:])
        whole = schuler.Navigator(start, 100, window="0,4,0")
        whole.fly(still)
        self.assertEqual((navigator.digest, navigator.state), (whole.digest, whole.state))
        with self.assertRaisesRegex(schuler.FlightError, "the correction must be finite"):
            whole.correct(position_ned_m=(np.inf, 0, 0))
        before = whole.state
        whole.correct(position_ned_m=(0, 0, -2), velocity_ned_m_s=np.array([1.0, 0, 0]))
        self.assertAlmostEqual(whole.state.altitude_m, before.altitude_m + 2, 9)
        self.assertAlmostEqual(whole.state.north_m_s, before.north_m_s + 1, 9)
        whole.hold_vertical(55, 0)
        self.assertAlmostEqual(whole.state.altitude_m, 55, 9)
        with self.assertRaisesRegex(schuler.InputError, "are rates"):
            whole.fly(schuler.emulate("paper", duration=1, rates=True).imu)
        with self.assertRaisesRegex(schuler.InputError, "has 7 columns"):
            whole.fly(np.zeros((3, 7)))
        with self.assertRaisesRegex(schuler.InputError, "name: .* is no navigator"):
            schuler.Navigator(start, 100, name="fast")
        for name in schuler.navigators():
            self.assertEqual(schuler.Navigator(start, 100, name=name).name, name)

    def test_warnings_are_pythons(self) -> None:
        scene = {**tomllib.loads(schuler.scene_text("stationary")), "accelerometer": {"constant_ug": 2500}}
        data = schuler.emulate(scene, duration=120)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            schuler.align(data.imu, 20, data.initial)
        self.assertTrue(any("specific force" in str(warning.message) for warning in caught), caught)


if __name__ == "__main__":
    unittest.main()
