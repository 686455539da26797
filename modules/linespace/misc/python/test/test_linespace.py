#!/usr/bin/env python3
# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""cv2.linespace: the same lines from numpy arrays and UMats, errors as cv2.error."""

import unittest

import cv2
import numpy as np


def to_numpy(array):
    return array.get() if isinstance(array, cv2.UMat) else array


class LineSpaceTest(unittest.TestCase):
    def setUp(self):
        self.edges = np.zeros((120, 160), np.uint8)
        cv2.line(self.edges, (0, 10), (159, 100), 255)
        cv2.line(self.edges, (30, 0), (30, 119), 255)

    def inputs(self):
        return (("numpy", self.edges), ("UMat", cv2.UMat(self.edges)))

    def test_detector_finds_both_lines(self):
        detector = cv2.linespace.LineSpaceDetector_create(threshold=80)
        results = {}
        for name, edges in self.inputs():
            with self.subTest(name):
                lines = to_numpy(detector.detect(edges))
                self.assertEqual((2, 1, 3), lines.shape)
                self.assertEqual(np.float32, lines.dtype)
                self.assertTrue((lines[:, 0, 2] > 80).all())
                vertical = lines[np.abs(np.sin(lines[:, 0, 1])) < 0.01]
                self.assertAlmostEqual(30, abs(float(vertical[0, 0, 0])), delta=0.5)
                results[name] = lines
        np.testing.assert_array_equal(results["numpy"], results["UMat"])

    def test_oriented_voting(self):
        detector = cv2.linespace.LineSpaceDetector_create(threshold=80)
        blurred = cv2.GaussianBlur(self.edges, (5, 5), 0)
        for depth in (cv2.CV_16S, cv2.CV_32F):
            dx, dy = cv2.Sobel(blurred, depth, 1, 0), cv2.Sobel(blurred, depth, 0, 1)
            # Wherever the gradient has a direction, it is that of the vertical line.
            dy[:] = 0
            for name, edges in self.inputs():
                with self.subTest(name, depth=depth):
                    wrap = cv2.UMat if name == "UMat" else np.asarray
                    lines = to_numpy(detector.detect(edges, wrap(dx), wrap(dy)))
                    self.assertEqual((1, 1, 3), lines.shape)
                    self.assertAlmostEqual(30, abs(float(lines[0, 0, 0])), delta=0.5)
        estimated = detector.detect(self.edges, None, None)
        self.assertEqual(2, len(estimated))
        with self.assertRaises(cv2.error):
            detector.detect(self.edges, dx, dy[1:])

    def test_compute_is_symmetric_and_counts_the_line(self):
        detector = cv2.linespace.LineSpaceDetector_create()
        tables = [to_numpy(detector.compute(edges)) for _, edges in self.inputs()]
        width, height = detector.getFrameSize()
        border = 2 * (width + height)
        self.assertEqual((border, border), tables[0].shape)
        np.testing.assert_array_equal(tables[0], tables[0].T)
        np.testing.assert_array_equal(tables[0], tables[1])
        self.assertGreaterEqual(tables[0].max(), 110)
        top = to_numpy(detector.computeLevel(self.edges, detector.getLevelCount() - 1))
        np.testing.assert_array_equal(tables[0], top)

    def test_hough_lines_takes_what_cv2_takes(self):
        expected = cv2.HoughLines(self.edges, 1, np.pi / 180, 100)
        for name, edges in self.inputs():
            with self.subTest(name):
                lines = to_numpy(cv2.linespace.HoughLines(edges, 1, np.pi / 180, 100))
                self.assertEqual((1, 2), lines.shape[1:])
                for rho, theta in expected[:, 0]:
                    distance = np.abs(lines[:, 0] - (rho, theta)) / (1, np.pi / 180)
                    # OpenCV before 4.13 has a bias of rho of up to one step.
                    self.assertTrue((distance.max(axis=1) <= 2).any())

    def test_parameters_are_those_of_an_algorithm(self):
        detector = cv2.linespace.LineSpaceDetector_create()
        self.assertIsInstance(detector, cv2.Algorithm)
        detector.setThreshold(42)
        self.assertEqual(42, detector.getThreshold())
        detector.setAngleRange(0.5, 1.5)
        np.testing.assert_allclose((0.5, 1.5), detector.getAngleRange())

    def test_draws_lines(self):
        lines = cv2.linespace.LineSpaceDetector_create(80).detect(self.edges)
        ends = cv2.linespace.lineEndPoints(lines, (160, 120))
        self.assertEqual((len(lines), 1, 4), ends.shape)
        image = cv2.linespace.drawLines(np.zeros((120, 160, 3), np.uint8), lines, (0, 255, 0))
        self.assertTrue(image[:, :, 1].any())

    def test_bad_input_raises(self):
        create = cv2.linespace.LineSpaceDetector_create
        detector = create(80)
        for bad in (np.zeros((0, 0), np.uint8), np.zeros((9, 9), np.float32),
                    np.zeros((9, 9, 3), np.uint8)):
            with self.subTest(str(bad.shape)), self.assertRaises(cv2.error):
                detector.detect(bad)
        with self.assertRaises(cv2.error):
            create(threshold=-1)
        with self.assertRaises(cv2.error):
            create(cellSize=1)
        with self.assertRaises(cv2.error):
            cv2.linespace.HoughLines(self.edges, 0, np.pi / 180, 100)
        self.assertEqual(2, len(detector.detect(self.edges)), "works on after an error")


if __name__ == "__main__":
    unittest.main()
