# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""What is computed from errors: one-to-one matching, recall, precision, the Cramer-Rao bound."""

import math

import numpy as np
from scipy.optimize import linear_sum_assignment


def match(errors, tolerance):
    """Pairs true with detected lines one to one: as many pairs below the tolerance as possible, and
    of all such pairings the one of the smallest summed error (Hungarian method).

    errors: (t, d) pixels. Returns (true indices, detected indices).
    """
    if errors.size == 0:
        return np.zeros(0, int), np.zeros(0, int)
    refused = (tolerance + 1.0) * (min(errors.shape) + 1)
    cost = np.where(errors < tolerance, errors, refused)
    true, detected = linear_sum_assignment(cost)
    below = errors[true, detected] < tolerance
    return true[below], detected[below]


class Counts:
    """Sums over images: true lines, reported lines, found lines at each tolerance, errors."""

    def __init__(self, tolerances, error_tolerance):
        """tolerances: pixels, one for each recall; errors are those of pairs below
        error_tolerance."""
        self.tolerances, self.error_tolerance = tolerances, error_tolerance
        self.images = self.true = self.reported = 0
        self.found = {tolerance: 0 for tolerance in tolerances}
        self.errors = []

    def add(self, errors):
        """errors: (t, d) of one image."""
        self.images += 1
        self.true += errors.shape[0]
        self.reported += errors.shape[1]
        for tolerance in self.tolerances:
            self.found[tolerance] += len(match(errors, tolerance)[0])
        self.errors.extend(errors[match(errors, self.error_tolerance)])

    def recall(self, tolerance):
        return self.found[tolerance] / self.true

    def precision(self, tolerance):
        """nan where nothing was reported."""
        return self.found[tolerance] / self.reported if self.reported else math.nan

    def median_error(self):
        return float(np.median(self.errors)) if self.errors else math.nan

    def lines_per_image(self):
        return self.reported / self.images


def position_bound(noise, contrast, blur, length):
    """Cramer-Rao bound of the deviation of an edge's position, in pixels.

    For a step of the contrast, blurred by a Gaussian of sigma blur pixels, over a length in pixels,
    in white noise of the given sigma; J is the information on one pixel of length.
    """
    information = contrast ** 2 / (2 * math.sqrt(math.pi) * blur)
    return noise / math.sqrt(length * information)


def angle_bound(noise, contrast, blur, length):
    """The same of its angle, in radians."""
    return position_bound(noise, contrast, blur, length) * math.sqrt(12) / length


def root_mean_square(values):
    return math.sqrt(np.mean(np.square(values))) if len(values) else math.nan
