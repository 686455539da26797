# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Lines, their ends and their errors, in OpenCV's pixel coordinates: centres at integers.

A line is (rho, theta): x cos(theta) + y sin(theta) = rho; theta in radians, any real number.
"""

import numpy as np


def chord_ends(line, size):
    """Where a line enters and leaves the image, (2, 2) points in pixels; None if it misses it.

    size: (width, height); the image is the rectangle [-0.5, width - 0.5] x [-0.5, height - 0.5].
    """
    rho, theta = line
    normal = np.array([np.cos(theta), np.sin(theta)])
    direction = np.array([-normal[1], normal[0]])
    first, last = -np.inf, np.inf
    for axis in range(2):
        low, high = -0.5 - rho * normal[axis], size[axis] - 0.5 - rho * normal[axis]
        if abs(direction[axis]) < 1e-15:
            if low > 0 or high < 0:
                return None
            continue
        cuts = sorted((low / direction[axis], high / direction[axis]))
        first, last = max(first, cuts[0]), min(last, cuts[1])
    if first > last:
        return None
    return np.array([rho * normal + first * direction, rho * normal + last * direction])


def line_errors(ends, lines):
    """Largest distance from the two ends of each true line to each detected line, in pixels.

    ends: (t, 2, 2), the ends of t true lines; lines: (d, 2) or more columns, rho and theta first.
    Returns (t, d). No angle is compared, so that (rho, theta) and (-rho, theta + pi) are the same.
    """
    ends = np.reshape(ends, (-1, 2, 2))
    lines = np.asarray(lines, float)
    normals = np.stack([np.cos(lines[:, 1]), np.sin(lines[:, 1])])
    return np.abs(ends @ normals - lines[:, 0]).max(axis=1)


def line_through(first, last):
    """(rho, theta) of the line through two points, theta in [0, pi)."""
    dx, dy = np.subtract(last, first)
    theta = np.arctan2(dx, -dy) % np.pi
    return first[0] * np.cos(theta) + first[1] * np.sin(theta), theta


def homography(corners):
    """The 3 x 3 matrix that maps the unit square's corners (0, 0), (1, 0), (1, 1), (0, 1) to four
    points in pixels, by the eight linear equations of the four pairs."""
    rows = []
    for (u, v), (x, y) in zip([(0, 0), (1, 0), (1, 1), (0, 1)], corners):
        rows.append([u, v, 1, 0, 0, 0, -x * u, -x * v])
        rows.append([0, 0, 0, u, v, 1, -y * u, -y * v])
    solution = np.linalg.solve(np.array(rows, float), np.ravel(corners).astype(float))
    return np.append(solution, 1).reshape(3, 3)


def grid_line_ends(corners, cells=9):
    """Ends of the 2 (cells + 1) lines of a square grid seen in perspective, inside its outline.

    corners: (4, 2) pixels, clockwise from the top left. Returns (2 (cells + 1), 2, 2).
    """
    matrix = homography(corners)
    ends = []
    for k in range(cells + 1):
        for square in ([(k / cells, 0), (k / cells, 1)], [(0, k / cells), (1, k / cells)]):
            points = [matrix @ (u, v, 1) for u, v in square]
            ends.append([point[:2] / point[2] for point in points])
    return np.array(ends)
