# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""What the report computes, on cases whose answer is known."""

import math
import pathlib
import sys
import types
import unittest
import warnings

import pandas as pd

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "common"))
import measurements  # noqa: E402
import plots  # noqa: E402
import requirements  # noqa: E402
import sections  # noqa: E402
import tables  # noqa: E402


def calls(section, values, image="a.jpg", size=(512, 512), threads=2, pixels=100, lines=3):
    """Rows of times.csv; values: {method: milliseconds of its calls}."""
    return pd.DataFrame([
        {"section": section, "image": image, "width": size[0], "height": size[1],
         "edge_pixels": pixels, "threshold": 9, "threads": threads, "isa": "AVX2",
         "method": method, "turn": turn, "milliseconds": milliseconds, "lines": lines, "valid": 1}
        for method, times in values.items() for turn, milliseconds in enumerate(times)])


def run_of(*tables, memory=None):
    """As measurements.Run, of rows of times.csv."""
    all_calls = pd.concat(tables)
    times = measurements.summary(all_calls)
    return types.SimpleNamespace(
        calls=all_calls, invalid=all_calls[all_calls["valid"] == 0], times=times, memory=memory,
        section=lambda name: times[times["section"] == name],
        section_with_fastest=lambda name: measurements.with_fastest(
            times[times["section"] == name], "4.6"))


def row_of(run, text):
    rows = [row for row in requirements.all_rows(run) if text in row.what]
    assert len(rows) == 1, [row.what for row in rows]
    return rows[0]


class Summary(unittest.TestCase):
    def test_median_and_quartiles(self):
        times = measurements.summary(calls("x", {"m": [5, 1, 2, 4, 3]})).iloc[0]
        self.assertEqual((times["n"], times["median"], times["low"], times["high"]), (5, 3, 2, 4))
        self.assertAlmostEqual(times["density"], 100 / 512 ** 2)

    def test_ratios_are_those_of_each_image(self):
        times = measurements.summary(pd.concat([
            calls("x", {"ours": [1], "peer": [10]}, "a.jpg"),
            calls("x", {"ours": [2], "peer": [8]}, "b.jpg"),
            calls("x", {"ours": [2]}, "c.jpg")]))
        ratios = measurements.ratios(times, "peer", "ours")
        self.assertEqual(ratios.to_dict(), {(512, 512, "a.jpg"): 10, (512, 512, "b.jpg"): 4})
        self.assertTrue(measurements.ratios(times, "nobody", "ours").empty)

    def test_slope_of_a_power(self):
        self.assertAlmostEqual(measurements.slope([64, 256, 512, 1024], [9, 1, 8, 64]), 3)
        self.assertTrue(math.isnan(measurements.slope([64, 256], [1, 2])))

    def test_digits(self):
        self.assertEqual([tables.milliseconds(value) for value in (0.123, 12.34, 1234.5, math.nan)],
                         ["0.12", "12.3", "1234", "-"])


class Fastest(unittest.TestCase):
    def fastest(self, *all_calls):
        """This is {(image, method): (median, version)} of the fastest."""
        times = measurements.with_fastest(measurements.summary(pd.concat(all_calls)), "4.6")
        rows = times[times["method"].str.startswith("fastest")]
        return {(row.image, row.method): (row.median, row.version)
                for row in rows.itertuples(index=False)}

    def test_each_input_and_step_has_its_own(self):
        found = self.fastest(
            calls("x", {"HoughLines 1 deg": [5], "HoughLines 4.14 1 deg": [4, 2, 4],
                        "HoughLines 5.0 1 deg": [6], "HoughLines 0.1 deg": [50],
                        "HoughLines 5.0 0.1 deg": [60], "drop-in 1 deg": [1]}, "a"),
            calls("x", {"HoughLines 1 deg": [5], "HoughLines 4.14 1 deg": [7],
                        "HoughLines 5.0 1 deg": [3]}, "b"))
        self.assertEqual(found, {("a", "fastest HoughLines 1 deg"): (4, "4.14"),
                                 ("a", "fastest HoughLines 0.1 deg"): (50, "4.6"),
                                 ("b", "fastest HoughLines 1 deg"): (3, "5.0")})

    def test_other_methods_and_thresholds_are_not_mixed(self):
        found = self.fastest(calls("x", {
            "HoughLines 1/(2n)": [9], "OpenCL HoughLines 1/(2n)": [1], "HoughLinesP": [1],
            "HoughLines 1 deg low": [8], "HoughLines 4.14 1 deg low": [7],
            "HoughLines 4.14 1 deg": [2]}))
        self.assertEqual(found, {("a.jpg", "fastest HoughLines 1/(2n)"): (9, "4.6"),
                                 ("a.jpg", "fastest HoughLines 1 deg low"): (7, "4.14"),
                                 ("a.jpg", "fastest HoughLines 1 deg"): (2, "4.14")})

    def test_no_cv_hough_lines(self):
        self.assertEqual(self.fastest(calls("x", {"LSD": [1]})), {})

    def test_drawn_beside_each_other(self):
        times = measurements.summary(calls("x", {
            "HoughLines 5.0 1 deg": [1], "HoughLines 4.14 1 deg": [1], "HoughLines 1 deg": [1],
            "HoughLines 0.1 deg": [1], "unknown": [1]}))
        self.assertEqual(list(plots.styles(times)),
                         ["HoughLines 1 deg", "HoughLines 4.14 1 deg", "HoughLines 5.0 1 deg",
                          "HoughLines 0.1 deg"])


class Stages(unittest.TestCase):
    def test_order_over_images_with_more_and_fewer_levels(self):
        short = ["edge map", "level 0", "level 1", "bounds", "selection"]
        long = ["edge map", "level 0", "level 1", "level 2", "bounds", "selection"]
        table = pd.DataFrame([{"stage": stage, "order": order}
                              for stages in (long, short) for order, stage in enumerate(stages)])
        self.assertEqual(sections.stages_in_order(table), long)


class Requirements(unittest.TestCase):
    def test_the_median_photograph_decides_and_the_slowest_must_not_be_slower(self):
        run = run_of(*(calls("photographs", {"Line Space": [10], "HoughLines 1 deg": [peer]}, name)
                       for name, peer in (("a", 8), ("b", 60), ("c", 70))))
        row = row_of(run, "detect beside the fastest cv::HoughLines(1, 1°), 512 x 512, median")
        self.assertEqual((row.measured, row.holds), ("6.00 times", True))
        row = row_of(run, "detect beside the fastest cv::HoughLines(1, 1°), 512 x 512, worst")
        self.assertEqual((row.measured, row.holds), ("0.80 times", False))

    def test_what_was_not_measured_neither_holds_nor_fails(self):
        run = run_of(calls("photographs", {"Line Space": [10]}))
        row = row_of(run, "detect beside FastHoughTransform, 1920")
        self.assertEqual((row.measured, row.holds), (None, None))

    def test_a_run_without_times_has_rows_without_values(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            run = run_of(calls("photographs", {"Line Space": [1]}).iloc[:0])
            rows = requirements.all_rows(run)
        self.assertTrue(all(row.holds is None for row in rows[:-1]))

    def test_the_worse_threshold_of_the_drop_in_counts(self):
        run = run_of(calls("photographs", {
            "HoughLines 0.1 deg": [110], "drop-in 0.1 deg": [10],
            "HoughLines 0.1 deg low": [90], "drop-in 0.1 deg low": [10]}))
        row = row_of(run, "HoughLines(1, 0.1°) beside the fastest cv::HoughLines, 512")
        self.assertEqual((row.measured, row.holds), ("9.00 times", False))

    def test_the_fastest_version_counts(self):
        run = run_of(calls("photographs", {
            "Line Space": [10], "HoughLines 1 deg": [60], "HoughLines 4.14 1 deg": [30],
            "HoughLines 5.0 1 deg": [70]}))
        row = row_of(run, "detect beside the fastest cv::HoughLines(1, 1°), 512 x 512, median")
        self.assertEqual((row.measured, row.holds), ("3.00 times", False))

    def test_flat_over_density(self):
        run = run_of(*(calls("densities", {"Line Space unpruned": [time]}, "random", pixels=pixels)
                       for time, pixels in ((10, 100), (11.4, 500), (10.5, 900))))
        row = row_of(run, "512 x 512, random maps")
        self.assertEqual((row.measured, row.holds), ("14 %", True))

    def test_threads_and_memory(self):
        memory = pd.DataFrame([{"image": "a", "width": 1920, "height": 1080,
                                "bytes": 49 * 1920 * 1080}])
        run = run_of(*(calls("threads", {"Line Space": [time]}, size=(1024, 1024), threads=threads)
                       for threads, time in ((1, 18), (2, 10))), memory=memory)
        self.assertEqual(row_of(run, "two threads against one").measured, "1.80")
        self.assertTrue(row_of(run, "two threads against one").holds)
        self.assertFalse(row_of(run, "peak memory of detect, 1920").holds)

    def test_a_call_with_other_lines_breaks_the_last_requirement(self):
        wrong = calls("photographs", {"Line Space": [10, 10], "LSD": [1]})
        wrong.loc[0, "valid"] = 0
        row = row_of(run_of(wrong), "BACKEND_REFERENCE")
        self.assertEqual((row.measured, row.holds), ("1 of 2 calls", False))


class Roofline(unittest.TestCase):
    def setUp(self):
        rows = [("L1", 1000, "read", 100e6), ("L1", 1000, "copy", 100e6), ("L1", 1000, "add", 100e6),
                ("L2", 9000, "read", 50e6), ("L2", 9000, "copy", 40e6), ("L2", 9000, "add", 40e6),
                ("memory", 0, "read", 10e6), ("memory", 0, "copy", 5e6), ("memory", 0, "add", 5e6),
                ("registers", 0, "adds", 1e9)]
        self.limits = measurements.Limits(pd.DataFrame(
            [{"threads": 1, "place": place, "capacity": capacity, "what": what, "per_second": rate}
             for place, capacity, what, rate in rows]), 1)

    def test_the_smallest_place_that_holds_it(self):
        self.assertEqual([self.limits.place(size) for size in (1000, 1001, 9001)],
                         ["L1", "L2", "memory"])

    def test_each_limit(self):
        work = {"bytes_read": 2000, "bytes_written": 2000, "bytes_loaded": 6000,
                "bytes_stored": 2000, "adds": 1000, "bytes_per_vote": 2}
        least = self.limits.least_milliseconds(work)
        self.assertEqual(set(least), {"L2 copy", "L1 load/store", "adds"})
        self.assertAlmostEqual(least["L2 copy"], 0.1)
        self.assertAlmostEqual(least["L1 load/store"], 0.08)
        self.assertAlmostEqual(least["adds"], 0.002)

    def test_what_only_reads_is_limited_by_reading(self):
        work = {"bytes_read": 20000, "bytes_written": 0, "bytes_loaded": 20000, "bytes_stored": 0,
                "adds": 0, "bytes_per_vote": 1}
        self.assertAlmostEqual(self.limits.least_milliseconds(work)["memory read"], 2)


if __name__ == "__main__":
    unittest.main()
