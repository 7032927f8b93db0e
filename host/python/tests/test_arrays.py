"""Tables, threads and what a notebook shows."""

from __future__ import annotations

import _thread
import signal
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import schuler


class Arrays(unittest.TestCase):
    def test_columns_share_the_numbers(self) -> None:
        table = schuler.emulate("paper", duration=2).imu
        self.assertEqual(table.array.shape, (40, 7))
        self.assertTrue(np.shares_memory(table["dvel_z_m_s"], table.array))
        self.assertTrue(np.shares_memory(np.asarray(table), table.array))
        self.assertFalse(np.shares_memory(np.array(table), table.array))
        self.assertEqual(np.asarray(table, dtype=np.float32).dtype, np.float32)
        self.assertEqual((len(table), list(table), "time_s" in table), (40, list(table.columns), True))
        self.assertEqual(set(dict(table)), set(table.columns))
        with self.assertRaisesRegex(KeyError, "did you mean"):
            table["dvel_z"]

    def test_pandas(self) -> None:
        table = schuler.run("paper", duration=2).drift
        frame = table.frame()
        self.assertEqual(tuple(frame.columns), table.columns)
        np.testing.assert_array_equal(frame["north_m"], table["north_m"])

    def test_samples_are_read_where_they_lie(self) -> None:
        data = schuler.emulate("manoeuvre", duration=4)
        six = data.imu.array[:, 1:]
        self.assertFalse(six.flags.c_contiguous)
        forms = [data.imu, six, np.ascontiguousarray(six), np.asfortranarray(six), six.tolist()]
        reverse = np.ascontiguousarray(six[::-1])[::-1]
        digests = set()
        for form in [*forms, reverse]:
            navigator = schuler.Navigator(data.initial, 100)
            navigator.fly(form)
            digests.add(navigator.digest)
        self.assertEqual(len(digests), 1)

    def test_samples_are_not_copied(self) -> None:
        # Of the same row so often that a copy would take 48 TB.
        endless = np.broadcast_to(np.full(6, np.nan), (10**12, 6))
        navigator = schuler.Navigator({"latitude_deg": 45, "longitude_deg": 10}, 100)
        with self.assertRaisesRegex(schuler.FlightError, "^sample 1 at 0.01 s: "):
            navigator.fly(endless)

    def test_threads_have_the_bits_of_one(self) -> None:
        def fly(seed: int) -> tuple[str, bytes]:
            flight = schuler.run("paper", duration=120, seed=seed)
            return flight.digest, flight.nav.array.tobytes()

        seeds = [1, 2, 3, 4] * 2
        alone = [fly(seed) for seed in seeds[:4]]
        with ThreadPoolExecutor(4) as pool:
            together = list(pool.map(fly, seeds))
        self.assertEqual(together, alone * 2)
        self.assertEqual(len(set(alone)), 4)

    def test_one_navigator_in_several_threads(self) -> None:
        data = schuler.emulate("paper", duration=60)
        chunks = [data.imu.array[place : place + 100, 1:] for place in range(0, 1200, 100)]
        navigator = schuler.Navigator(data.initial, 20)
        with ThreadPoolExecutor(4) as pool:
            rows = sum(len(table) for table in pool.map(navigator.fly, [chunks[0]] * 12))
        self.assertEqual(navigator.taken, 1200)
        self.assertLessEqual(rows, 1200)

    def test_python_goes_on_meanwhile(self) -> None:
        seen: list[float] = []
        stop = threading.Event()

        def watch() -> None:
            while not stop.is_set():
                seen.append(time.perf_counter())
                time.sleep(1e-4)

        watcher = threading.Thread(target=watch)
        watcher.start()
        start = time.perf_counter()
        schuler.run("paper", rate=100, rows=False)
        end = time.perf_counter()
        stop.set()
        watcher.join()
        middle = [t for t in seen if start + 0.25 * (end - start) < t < start + 0.75 * (end - start)]
        self.assertTrue(middle)

    def test_ctrl_c_ends_a_flight(self) -> None:
        # A program in the background may have been told to ignore it.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        timer = threading.Timer(0.2, _thread.interrupt_main)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            # A day, in which there is time for it.
            schuler.run("paper", rate=1000, duration=86_400, rows=False)
        timer.join()

    def test_trajectories(self) -> None:
        path = schuler.Trajectory("waypoints")
        self.assertEqual(path.duration_s, 1800)
        table = path.at([0, 92, 1800])
        np.testing.assert_allclose(table["latitude_deg"], [45, 45.0661, 44.9178], atol=1e-9)
        np.testing.assert_allclose(table["altitude_m"], [450, 850, 700], atol=1e-6)
        self.assertEqual(path.state(92).as_dict()["time_s"], 92)
        still = schuler.Trajectory({"latitude_deg": {"offset": 45}}, duration=10)
        rates = still.rates([1.0, 2.0])
        # The Earth's rate and gravity of 45° N.
        np.testing.assert_allclose(rates["gyro_x_rad_s"], 7.292115e-5 * np.cos(np.pi / 4), rtol=1e-9)
        np.testing.assert_allclose(rates["accel_z_m_s2"], -9.806197769, rtol=1e-8)
        self.assertAlmostEqual(still.extremes()["length_m"], 0)
        with self.assertRaises(schuler.InputError):
            path.at([np.inf])
        by_points = schuler.Trajectory(
            {
                "waypoints": {
                    "mode": "through",
                    "points": [
                        {"time_s": 30 * i, "latitude_deg": 45 + 0.01 * i, "longitude_deg": 10, "altitude_m": 500}
                        for i in range(5)
                    ],
                }
            }
        )
        self.assertEqual(by_points.duration_s, 120)

    def test_what_a_notebook_shows(self) -> None:
        flight = schuler.run("paper", duration=10)
        html = flight._repr_html_()
        self.assertTrue(html.startswith("<iframe srcdoc=") and html.count("class=&quot;plot") > 3, html[:200])
        self.assertEqual(html.count("<"), 2)
        self.assertIn(flight.digest, flight.report())
        self.assertTrue(flight.picture().startswith(b"\x89PNG"))
        self.assertIn("Theory: ", str(flight))
        table = flight.drift._repr_html_()
        self.assertTrue("north_m" in table and "201 rows" in table)
        runs = schuler.ensemble("paper", runs=8, duration=60, at=2)
        self.assertIn("class=&quot;plot", runs._repr_html_())
        self.assertIn("class=&quot;plot", schuler.allan("paper", duration=600)._repr_html_())
        with self.assertRaisesRegex(schuler.InputError, "rows: were not kept"):
            _ = schuler.run("paper", duration=1, rows=False).nav


if __name__ == "__main__":
    unittest.main()
