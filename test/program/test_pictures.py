# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""The pictures that the program draws."""

import unittest

import pictures
from case import ProgramTest


class Drawn(ProgramTest):
    def setUp(self):
        super().setUp()
        edges = pictures.vertical(pictures.horizontal(pictures.black(64, 48), 20), 30)
        pictures.write_png(self.folder / "edges.png", edges)

    def run_on_edges(self, *arguments):
        return self.run_program("edges.png", "--edge-map", "--threshold", "40", *arguments)[0]

    def read(self, name):
        return pictures.read_png(self.folder / name)

    def pixel(self, rows, x, y):
        blue_last = rows[y][3 * x:3 * x + 3]
        return tuple(blue_last)

    def test_lines_are_drawn_where_they_are(self):
        self.run_on_edges("-o", "out.png")
        width, height, channels, rows = self.read("out.png")
        self.assertEqual((width, height, channels), (64, 48, 3))
        for x, y in ((5, 20), (60, 20), (30, 5), (30, 44)):
            red, green, blue = self.pixel(rows, x, y)
            self.assertGreater(red, 200, (x, y))
            self.assertLess(max(green, blue), 100, (x, y))
        self.assertEqual(self.pixel(rows, 10, 40), (0, 0, 0))

    def test_comparison(self):
        out = self.run_on_edges("--compare", "-o", "both.png", "--max-lines", "2")
        self.assertRegex(out, r"cv::HoughLines, 1 px, 1 deg, above 40 votes: 2 lines, [\d.]+ ms; "
                              r"Line Space, cascaded, cpu: 2 lines, [\d.]+ ms")
        width, height, channels, rows = self.read("both.png")
        factor = 6  # small pictures are enlarged, so that the captions can be read
        self.assertEqual((width, channels), (2 * 64 * factor + 8, 3))
        self.assertGreater(height, 48 * factor + 20)
        right = 64 * factor + 8
        at = (factor * 10, factor * 20 + factor // 2)
        theirs, ours = self.pixel(rows, *at), self.pixel(rows, right + at[0], at[1])
        self.assertGreater(theirs[2], theirs[0])
        self.assertGreater(ours[0], ours[2])
        caption = [self.pixel(rows, x, y) for y in range(48 * factor, height)
                   for x in range(right, width)]
        self.assertIn((255, 255, 255), caption)
        self.assertTrue(any(sum(pixel) < 100 for pixel in caption))

    def test_comparison_lowers_the_threshold_for_cv(self):
        # Two lines have more than half of our votes; its seven strongest have to do with fewer.
        out, _ = self.run_program("edges.png", "--edge-map", "--compare", "--max-lines", "7")
        self.assertRegex(out, r"cv::HoughLines, 1 px, 1 deg, above \d+ votes: 7 lines")

    def test_comparison_of_many_lines_and_steps(self):
        out = self.run_on_edges("--compare", "--hough-step", "0.25", "--max-lines", "0")
        self.assertRegex(out, r"cv::HoughLines, 1 px, 0\.25 deg, above 40 votes: \d+ lines")

    def test_comparison_without_any_line(self):
        pictures.write_pgm(self.folder / "empty.pgm", pictures.black(40, 30))
        out, _ = self.run_program("empty.pgm", "--compare", "-o", "both.png")
        self.assertIn("0 lines", out)

    def test_line_space(self):
        # Border points run clockwise from the top-left corner: the row y = 20 goes from 64 + 20 on
        # the right side to 2 * 64 + 48 + (48 - 1 - 20) on the left, the column x = 30 from 30 on
        # the top to 64 + 48 + (64 - 1 - 30) at the bottom.
        self.run_on_edges("--show-linespace", "table.png")
        width, height, channels, rows = self.read("table.png")
        size, factor = 2 * (64 + 48), 2
        self.assertEqual((width, height, channels), (size * factor, size * factor, 1))
        row, column = (84, 203), (30, 145)
        at = lambda s, e: rows[factor * s][factor * e]
        self.assertEqual((at(*row), at(*row[::-1])), (255, 255))
        self.assertEqual(at(*column), at(*column[::-1]))
        self.assertTrue(200 < at(*column) < 255)
        self.assertEqual(at(5, 60), 0)  # both on the top side
        self.assertEqual(sum(line.count(255) for line in rows), 2 * factor * factor)

    def test_large_line_space_is_reduced_without_losing_peaks(self):
        # 704 x 304 are whole cells, so that the border points are those of the image.
        edges = pictures.horizontal(pictures.black(704, 304), 100)
        pictures.write_pgm(self.folder / "large.pgm", edges)
        self.run_program("large.pgm", "--edge-map", "--show-linespace", "table.png", "-q")
        width, height, _, rows = self.read("table.png")
        step = 2
        self.assertEqual((width, height), (2 * (704 + 304) // step, 2 * (704 + 304) // step))
        s, e = 704 + 100, 2 * 704 + 304 + (304 - 1 - 100)
        self.assertEqual((rows[s // step][e // step], rows[e // step][s // step]), (255, 255))
        self.assertLess(sum(line.count(255) for line in rows), 10)



if __name__ == "__main__":
    unittest.main()
