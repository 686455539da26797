# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Reads what linespace_accuracy wrote, and the ground truth of the photographs."""

import csv
import pathlib

import numpy as np

import geometry


class Image:
    """One image: its size (width, height) and what each detector found, strongest first."""

    def __init__(self, size):
        self.size = size
        self.lines = {}  # detector -> (d, 3) rho, theta, votes
        self.truth = np.zeros((0, 2))  # rho, theta; of synthetic images


def read(folder, section):
    """{group: {image name: Image}}, in the order of the file; None if the section was not run."""
    path = pathlib.Path(folder) / f"{section}-runs.csv"
    if not path.exists():
        return None
    groups, rows = {}, {}
    for row in _rows(path):
        images = groups.setdefault(row["group"], {})
        size = int(row["width"]), int(row["height"])
        image = images.setdefault(row["image"], Image(size))
        rows[row["group"], row["image"], row["detector"]] = []
        image.lines[row["detector"]] = np.zeros((0, 3))
    for row in _rows(path.with_name(f"{section}-lines.csv")):
        rows[row["group"], row["image"], row["detector"]].append(
            (float(row["rho"]), float(row["theta"]), float(row["votes"])))
    for (group, name, detector), lines in rows.items():
        if lines:
            groups[group][name].lines[detector] = np.array(lines)
    truth = {}
    for row in _rows(path.with_name(f"{section}-truth.csv")):
        truth.setdefault((row["group"], row["image"]), []).append(
            (float(row["rho"]), float(row["theta"])))
    for (group, name), lines in truth.items():
        groups[group][name].truth = np.array(lines)
    return groups


def chord_ends_of(lines, size):
    """(n, 2, 2): ends of the lines that meet the image."""
    ends = [geometry.chord_ends(line, size) for line in lines]
    return np.reshape([end for end in ends if end is not None], (-1, 2, 2))


def chessboard_ends(data, name, size):
    """Where the lines of a board enter and leave the image."""
    return chord_ends_of([(float(row["rho"]), float(row["theta"]))
                          for row in _chessboard_rows(data, name)], size)


def chessboard_corners(data, name):
    """The first and last corner of the board on each of its lines."""
    return np.reshape([[float(row[key]) for key in ("x1", "y1", "x2", "y2")]
                       for row in _chessboard_rows(data, name)], (-1, 2, 2))


def _chessboard_rows(data, name):
    return _rows(pathlib.Path(data) / "chessboard" / (pathlib.Path(name).stem + ".csv"))


def sudoku_ends(data, name):
    for row in _rows(pathlib.Path(data) / "sudoku" / "outlines.csv"):
        if row["image"] == name:
            corners = [(float(row[f"x{i}"]), float(row[f"y{i}"])) for i in (1, 2, 3, 4)]
            return geometry.grid_line_ends(corners)
    raise KeyError(f"sudoku/outlines.csv has no {name}")


def york_ends(data, name, shortest=60):
    """The ends of the true segments that are at least so many pixels long."""
    rows = _rows(pathlib.Path(data) / "york" / (pathlib.Path(name).stem + ".manhattan.csv"))
    ends = np.reshape([[float(row[key]) for key in ("x1", "y1", "x2", "y2")] for row in rows],
                      (-1, 2, 2))
    return ends[np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) >= shortest]


def _rows(path):
    with open(path, encoding="utf-8", newline="") as file:
        yield from csv.DictReader(file)
