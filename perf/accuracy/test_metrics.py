# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""The metrics on cases whose answer is known."""

import math
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import geometry  # noqa: E402
import metrics  # noqa: E402


class Geometry(unittest.TestCase):
    def test_ends_of_a_horizontal_and_a_diagonal_line(self):
        ends = geometry.chord_ends((3, math.pi / 2), (10, 20))
        np.testing.assert_allclose(sorted(ends[:, 0]), [-0.5, 9.5], atol=1e-12)
        np.testing.assert_allclose(ends[:, 1], [3, 3], atol=1e-12)
        ends = geometry.chord_ends((0, 3 * math.pi / 4), (10, 20))  # y = x
        np.testing.assert_allclose(sorted(ends.tolist()), [[-0.5, -0.5], [9.5, 9.5]], atol=1e-9)

    def test_a_line_beside_the_image_has_no_ends(self):
        self.assertIsNone(geometry.chord_ends((-1, 0), (10, 20)))
        self.assertIsNone(geometry.chord_ends((100, 1), (10, 20)))

    def test_a_line_has_no_error_however_it_is_written(self):
        rho, theta = 12.25, 0.7
        ends = geometry.chord_ends((rho, theta), (64, 48))
        same = [(rho, theta), (-rho, theta + math.pi), (-rho, theta - math.pi),
                (rho, theta + 2 * math.pi)]
        np.testing.assert_allclose(geometry.line_errors([ends], same), 0, atol=1e-9)

    def test_the_error_is_that_of_the_worse_end(self):
        ends = [[(0, 5), (10, 5)], [(0, 5), (10, 6)]]
        lines = [(5, math.pi / 2), (7, math.pi / 2)]
        np.testing.assert_allclose(geometry.line_errors(ends, lines), [[0, 2], [1, 2]], atol=1e-12)

    def test_a_line_through_two_points_has_no_error_there(self):
        for first, last in [((1, 2), (8, 5)), ((3, 9), (3, 1)), ((7, 4), (2, 4))]:
            line = geometry.line_through(first, last)
            self.assertTrue(0 <= line[1] < math.pi)
            self.assertAlmostEqual(geometry.line_errors([[first, last]], [line])[0, 0], 0)

    def test_the_grid_of_a_square_is_regular(self):
        ends = geometry.grid_line_ends([(10, 20), (100, 20), (100, 110), (10, 110)])
        self.assertEqual(ends.shape, (20, 2, 2))
        np.testing.assert_allclose(ends[2], [(20, 20), (20, 110)], atol=1e-9)
        np.testing.assert_allclose(ends[19], [(10, 110), (100, 110)], atol=1e-9)

    def test_in_perspective_the_diagonals_still_meet_on_grid_lines(self):
        corners = np.array([(12, 9), (90, 17), (101, 88), (5, 120)], float)
        ends = geometry.grid_line_ends(corners, cells=2)
        diagonals = [np.cross([*corners[i], 1], [*corners[i + 2], 1]) for i in (0, 1)]
        centre = np.cross(*diagonals)
        centre = centre[:2] / centre[2]
        for middle in (ends[2], ends[3]):
            line = geometry.line_through(*middle)
            self.assertAlmostEqual(geometry.line_errors([[centre, centre]], [line])[0, 0], 0)


class Matching(unittest.TestCase):
    def test_one_detected_line_finds_one_true_line(self):
        true, detected = metrics.match(np.array([[0.1], [0.2]]), 1)
        self.assertEqual((list(true), list(detected)), ([0], [0]))

    def test_as_many_pairs_as_possible_before_the_nearest(self):
        # The nearest pair (0, 0) first would leave the second true line without one.
        true, detected = metrics.match(np.array([[0.1, 0.9], [0.8, 5.0]]), 1)
        self.assertEqual(sorted(zip(true, detected)), [(0, 1), (1, 0)])

    def test_far_errors_do_not_outvote_a_pair(self):
        # One pair below the tolerance, however large the errors of the rest.
        true, detected = metrics.match(np.array([[0.9, 1e6], [1.1, 1e9]]), 1)
        self.assertEqual(list(zip(true, detected)), [(0, 0)])

    def test_the_tolerance_itself_is_not_found(self):
        self.assertEqual(len(metrics.match(np.array([[1.0]]), 1)[0]), 0)

    def test_nothing_reported(self):
        counts = metrics.Counts([1], 3)
        counts.add(np.zeros((4, 0)))
        self.assertEqual(counts.recall(1), 0)
        self.assertTrue(math.isnan(counts.precision(1)))
        self.assertTrue(math.isnan(counts.median_error()))

    def test_counts_of_two_images(self):
        counts = metrics.Counts([1, 2], 3)
        counts.add(np.array([[0.5, 9.0, 9.0], [9.0, 1.5, 9.0]]))
        counts.add(np.array([[2.5]]))
        self.assertAlmostEqual(counts.recall(1), 1 / 3)
        self.assertAlmostEqual(counts.recall(2), 2 / 3)
        self.assertAlmostEqual(counts.precision(1), 1 / 4)
        self.assertAlmostEqual(counts.median_error(), 1.5)
        self.assertAlmostEqual(counts.lines_per_image(), 2)


class CramerRao(unittest.TestCase):
    def test_position_by_the_information_of_sampled_pixels(self):
        # Information of independent pixels: the sum of (d value / d position)^2 / sigma^2.
        contrast, blur, noise, length = 50, 1.0, 10, 256
        slope = [contrast / (blur * math.sqrt(2 * math.pi)) * math.exp(-d * d / (2 * blur ** 2))
                 for d in np.arange(-20, 21)]
        information = length * sum(s * s for s in slope) / noise ** 2
        self.assertAlmostEqual(metrics.position_bound(noise, contrast, blur, length),
                               1 / math.sqrt(information), delta=1e-5)

    def test_angle_by_the_information_along_the_edge(self):
        contrast, blur, noise, length = 50, 1.0, 10, 256
        per_pixel = contrast ** 2 / (2 * math.sqrt(math.pi) * blur) / noise ** 2
        along = np.arange(length) - (length - 1) / 2
        self.assertAlmostEqual(metrics.angle_bound(noise, contrast, blur, length),
                               1 / math.sqrt(per_pixel * np.sum(along ** 2)), delta=1e-7)


if __name__ == "__main__":
    unittest.main()
