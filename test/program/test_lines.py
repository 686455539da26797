# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""The lines that are found, and every option that has a say in it."""

import csv
import math
import unittest
import xml.etree.ElementTree

import pictures
from case import ProgramTest


class EdgeMap(ProgramTest):
    """A row and a column of an edge map: every number of the answer is known."""

    def setUp(self):
        super().setUp()
        edges = pictures.vertical(pictures.horizontal(pictures.black(96, 64), 20), 30)
        pictures.write_png(self.folder / "edges.png", edges)

    def lines(self, *arguments, threshold=40, selection="peaks"):
        return super().lines("edges.png", "--edge-map", "--threshold", threshold,
                             "--selection", selection, *arguments)

    def assert_line(self, line, rho, degrees, votes, ends):
        # (rho, theta) and (-rho, theta - pi) are the same line.
        if abs(line["theta"] - math.radians(degrees)) > 1:
            line = dict(line, rho=-line["rho"], theta=line["theta"] - math.pi)
        # The refinement sees the other line's pixels at the crossing.
        self.assertAlmostEqual(line["rho"], rho, delta=0.1)
        self.assertAlmostEqual(line["theta"], math.radians(degrees), delta=0.002)
        self.assertEqual(line["votes"], votes)
        for value, expected in zip(line["endPoints"], ends, strict=True):
            self.assertAlmostEqual(value, expected, delta=0.1)

    def assert_both_lines(self, lines):
        self.assertEqual(len(lines), 2)
        self.assert_line(lines[0], 20, 90, 96, (-0.5, 20, 95.5, 20))
        self.assert_line(lines[1], 30, 0, 64, (30, -0.5, 30, 63.5))

    def test_both_lines_by_every_method_cell_size_and_back_end(self):
        for options in ((), ("--method", "exact"), ("--cell-size", "2"), ("--cell-size", "64"),
                        ("--backend", "reference"), ("--backend", "cpu")):
            with self.subTest(options=options):
                self.assert_both_lines(self.lines(*options))

    def test_automatic_threshold(self):
        self.assert_both_lines(self.lines(threshold=0)[:2])

    def test_threshold_is_exceeded_not_reached(self):
        self.assertEqual(len(self.lines(threshold=63)), 2)
        self.assertEqual(len(self.lines(threshold=64)), 1)
        self.assertEqual(len(self.lines(threshold=96)), 0)

    def test_selection(self):
        # The pixel of the crossing votes for both lines, or for the stronger one alone.
        self.assertEqual(len(self.lines(threshold=63, selection="peaks")), 2)
        self.assertEqual(len(self.lines(threshold=63, selection="explain")), 1)
        self.assert_both_lines(self.lines(threshold=50, selection="explain"))

    def test_oriented(self):
        # Strokes of nine pixels: seen together they look like lines along the rows.
        comb = pictures.black(96, 64)
        for x in range(0, 96, 3):
            for y in range(18, 27):
                comb[y][x] = 255
        pictures.write_png(self.folder / "edges.png", pictures.vertical(comb, 30))
        self.assertGreater(len(self.lines(threshold=25)), 1)
        lines = self.lines("--oriented", threshold=25)
        self.assertEqual(len(lines), 1)
        self.assertAlmostEqual(abs(lines[0]["rho"]), 30, delta=0.5)

    def test_min_distance(self):
        pictures.write_png(self.folder / "edges.png", pictures.horizontal(
            pictures.horizontal(pictures.black(96, 64), 20), 25))
        self.assertEqual(len(self.lines("--min-distance", "4")), 2)
        self.assertEqual(len(self.lines("--min-distance", "6")), 1)

    def test_max_lines(self):
        self.assertEqual([line["votes"] for line in self.lines("--max-lines", "1")], [96])
        self.assert_both_lines(self.lines("--max-lines", "0"))

    def test_angle_range(self):
        for interval, votes in ((("80", "100"), [96]), (("-5", "5"), [64]), (("30", "60"), []),
                                (("-90", "90"), [96, 64]), (("175", "185"), [64])):
            with self.subTest(interval=interval):
                lines = self.lines("--angle-range", *interval)
                self.assertEqual([line["votes"] for line in lines], votes)
                for line in lines:
                    self.assertGreaterEqual(math.degrees(line["theta"]), float(interval[0]) - 1e-4)
                    self.assertLessEqual(math.degrees(line["theta"]), float(interval[1]) + 1e-4)

    def test_mask(self):
        left_half = [bytearray(b"\xff" * 48 + b"\0" * 48) for _ in range(64)]
        pictures.write_pgm(self.folder / "mask.pgm", left_half)
        self.assertEqual([line["votes"] for line in self.lines("--mask", "mask.pgm")], [64, 48])

    def test_back_end_that_ran_is_named(self):
        for backend in ("reference", "cpu"):
            result = self.found("edges.png", "--edge-map", "--backend", backend)
            self.assertEqual(result["images"][0]["backend"], backend)


class Photograph(ProgramTest):
    """A step edge: found through blur and Canny."""

    def setUp(self):
        super().setUp()
        pictures.write_pgm(self.folder / "step.pgm", pictures.step(120, 80, 50))

    def test_the_edge(self):
        lines = self.lines("step.pgm")
        self.assertGreaterEqual(len(lines), 1)
        self.assertAlmostEqual(abs(lines[0]["rho"]), 49.5, delta=1)
        self.assertAlmostEqual(math.cos(2 * lines[0]["theta"]), 1, delta=0.01)
        self.assertGreaterEqual(lines[0]["votes"], 75)

    def test_canny_and_blur(self):
        self.assertEqual(self.lines("step.pgm", "--canny", "5000", "9000"), [])
        self.assertEqual(self.lines("step.pgm", "--blur", "30"), [])
        self.assertNotEqual(self.lines("step.pgm", "--blur", "0", "--canny", "10", "20"), [])

    def test_resize(self):
        found = self.found("step.pgm", "--resize", "240", "40")["images"][0]
        self.assertEqual((found["width"], found["height"]), (240, 40))
        self.assertAlmostEqual(abs(found["lines"][0]["rho"]), 99.5, delta=1.5)

    def test_kinds_of_images(self):
        pictures.write_png(self.folder / "deep.png", pictures.step(60, 50, 20), bits=16)
        self.assertNotEqual(self.lines("deep.png"), [])
        pictures.write_pgm(self.folder / "dot.pgm", pictures.black(1, 1))
        self.assertEqual(self.lines("dot.pgm"), [])
        pictures.write_pgm(self.folder / "white.pgm", [bytearray(b"\xff" * 9)] * 9)
        self.assertEqual(self.lines("white.pgm"), [])


class LineFiles(ProgramTest):
    def setUp(self):
        super().setUp()
        for name, row in (("a, \"b\" & <c>.png", 10), ("d.png", 40)):
            edges = pictures.horizontal(pictures.black(80, 60), row)
            pictures.write_png(self.folder / name, edges)
        self.inputs = ["a, \"b\" & <c>.png", "d.png"]

    def test_json(self):
        found = self.found(*self.inputs, "--edge-map", "--threshold", "50", "--max-lines", "3")
        self.assertRegex(found["program"], r"^linespace \d")
        self.assertEqual(found["parameters"], {
            "threshold": 50, "maxLines": 3, "angleRange": [0, 180], "selection": "explain",
            "oriented": False, "minDistance": 3, "method": "cascaded", "cellSize": 8, "backend": "auto",
            "edges": {"edgeMap": True}, "mask": None})
        self.assertEqual([image["image"] for image in found["images"]], self.inputs)
        for image in found["images"]:
            self.assertEqual((image["width"], image["height"]), (80, 60))
            self.assertEqual(image["edgePixels"], 80)
            self.assertGreater(image["milliseconds"], 0)
            for line in image["lines"]:
                self.assertEqual(set(line), {"rho", "theta", "votes", "endPoints"})

    def test_json_of_a_photograph_tells_canny(self):
        found = self.found("d.png", "--canny", "20", "60", "--blur", "0.5")
        self.assertEqual(found["parameters"]["edges"], {"canny": [20, 60], "blur": 0.5})

    def test_csv(self):
        self.run_program(*self.inputs, "--edge-map", "--threshold", "50", "--lines", "all.csv")
        with open(self.folder / "all.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["image"] for row in rows], self.inputs)
        self.assertEqual([row["frame"] for row in rows], ["", ""])
        self.assertEqual([row["votes"] for row in rows], ["80", "80"])
        self.assertAlmostEqual(float(rows[1]["rho"]), 40, delta=0.01)
        self.assertAlmostEqual(float(rows[1]["y2"]), 40, delta=0.01)

    def test_svg(self):
        self.run_program(*self.inputs, "--edge-map", "--threshold", "50", "--lines", "out/*.svg")
        self.assertEqual(self.files("out/*"), [f"out/{name[:-4]}.svg" for name in self.inputs])
        root = xml.etree.ElementTree.parse(self.folder / "out" / "d.svg").getroot()
        space = "{http://www.w3.org/2000/svg}"
        self.assertEqual(root.get("viewBox"), "-0.5 -0.5 80 60")
        self.assertTrue(root.find(f"{space}image").get("href").startswith("data:image/jpeg;base64,"))
        line, = root.iter(f"{space}line")
        self.assertEqual([float(line.get(key)) for key in ("x1", "y1", "x2", "y2")],
                         [-0.5, 40, 79.5, 40])

    def test_one_file_for_each_input_and_several_formats_at_once(self):
        self.run_program(*self.inputs, "--edge-map", "--lines", "*.json", "--lines", "all.csv",
                         "--lines", "*.svg", "-q")
        self.assertEqual(len(self.json("d.json")["images"]), 1)
        self.assertEqual(len(self.files("*.svg")), 2)
        self.assertEqual(self.files("*.csv"), ["all.csv"])

    def test_a_name_that_is_not_utf8(self):
        name = b"\xff\xfe.png"
        (self.folder / "d.png").rename(self.folder / name.decode("utf-8", "surrogateescape"))
        found = self.found("?" * 2 + ".png", "--edge-map")
        self.assertEqual(len(found["images"]), 1)
        self.assertNotIn("error", found["images"][0])


if __name__ == "__main__":
    unittest.main()
