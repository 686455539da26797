# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""The sections of the report on photographs: chessboards, sudokus, York, three scales."""

import numpy as np

import geometry
import metrics
import results
from tables import Table, number

OURS = "Line Space oriented"
HOUGH = ("HoughLines 1 px 1 deg", "HoughLines 0.5 px 0.25 deg", "HoughLines 1 px 1/(2n)")


def detectors_of(images):
    return list(next(iter(images.values())).lines)


def strongest_errors(ends, image, detector, count):
    return geometry.line_errors(ends, image.lines[detector][:count])


def chessboards(groups, data):
    """One table for each number of lines, and the recall at 1 px over that number."""
    (images,) = groups.values()
    ends = {name: results.chessboard_ends(data, name, image.size)
            for name, image in images.items()}
    tables = []
    for count in (20, 25, 40):
        table = Table(f"chessboard-{count}", f"Chessboards, strongest {count}",
                      ["detector", "recall 1 px", "recall 2 px", "recall 3 px", "median error, px",
                       "precision 1 px", "on the board: recall 1 px", "median error, px",
                       "lines per image"])
        for detector in detectors_of(images):
            counts, on_board = metrics.Counts((1, 2, 3), 3), metrics.Counts((1,), 3)
            for name, image in images.items():
                counts.add(strongest_errors(ends[name], image, detector, count))
                on_board.add(strongest_errors(results.chessboard_corners(data, name), image,
                                              detector, count))
            table.add(detector, *(number(counts.recall(t), 3) for t in (1, 2, 3)),
                      number(counts.median_error(), 3), number(counts.precision(1), 3),
                      number(on_board.recall(1), 3), number(on_board.median_error(), 3),
                      number(counts.lines_per_image(), 1))
        tables.append(table)
    return tables, recall_curves(images, ends, lambda image: 1, range(5, 101, 5))


def chessboard_errors(groups, data, detectors, count=40):
    """{detector: errors in pixels of the lines found within 3 px}, for the histogram."""
    (images,) = groups.values()
    errors = {}
    for detector in detectors:
        counts = metrics.Counts((3,), 3)
        for name, image in images.items():
            ends = results.chessboard_ends(data, name, image.size)
            counts.add(strongest_errors(ends, image, detector, count))
        errors[detector] = counts.errors
    return errors


def sudoku(groups, data):
    """Recall of the grid lines of each edge map, ours beside the best cv::HoughLines; the recall
    over the number of lines is that of the last edge map."""
    table = Table("sudoku", "Sudoku, strongest 60: recall of the 20 grid lines within 1 % of the "
                  "shorter side", ["detector", *groups, "median error, px", "lines per image"])
    ratios = Table("sudoku-ratio", "Sudoku: oriented beside the best cv::HoughLines of each "
                   "edge map", ["", *groups])
    every = {group: {detector: _sudoku_counts(images, data, detector)
                     for detector in detectors_of(images)}
             for group, images in groups.items()}
    first = next(iter(groups))
    for detector in every[first]:
        table.add(detector,
                  *(number(counts[detector][0], 3) for counts in every.values()),
                  number(every[first][detector][1], 2), number(every[first][detector][2], 1))
    best = [max(value[0] for name, value in counts.items() if name.startswith("HoughLines"))
            for counts in every.values()]
    ours = [counts[OURS][0] for counts in every.values()]
    ratios.add(OURS, *(number(value, 3) for value in ours))
    ratios.add("best HoughLines", *(number(value, 3) for value in best))
    ratios.add("ratio", *(number(a / b, 2) for a, b in zip(ours, best)))
    images = list(groups.values())[-1]
    ends = {name: results.sudoku_ends(data, name) for name in images}
    return [table, ratios], recall_curves(images, ends, sudoku_tolerance, range(10, 101, 10))


def sudoku_tolerance(image):
    return 0.01 * min(image.size)


def _sudoku_counts(images, data, detector, count=60):
    found = true = reported = 0
    errors = []
    for name, image in images.items():
        matrix = strongest_errors(results.sudoku_ends(data, name), image, detector, count)
        pairs = metrics.match(matrix, sudoku_tolerance(image))
        found, true = found + len(pairs[0]), true + matrix.shape[0]
        reported += matrix.shape[1]
        errors.extend(matrix[pairs])
    return found / true, float(np.median(errors)), reported / len(images)


def york(groups, data):
    """Recall of long segments over the number of lines. Several segments can lie on one line, so
    that a line may find more than one."""
    (images,) = groups.values()
    sizes = (25, 50, 100, 200)
    table = Table("york", "York: recall at 2 px of the true segments of at least 60 px, by number "
                  "of strongest lines", ["detector", *(f"strongest {n}" for n in sizes),
                                         "lines per image at 200"])
    ends = {name: results.york_ends(data, name) for name in images}
    curves = {}
    for detector in detectors_of(images):
        curves[detector] = [(n, york_recall(images, ends, detector, n))
                            for n in range(20, 201, 20)]
        reported = np.mean([min(len(image.lines[detector]), 200) for image in images.values()])
        table.add(detector, *(number(york_recall(images, ends, detector, n), 3) for n in sizes),
                  number(reported, 1))
    return [table], curves


def york_recall(images, ends, detector, count, tolerance=2):
    found = true = 0
    for name, image in images.items():
        errors = strongest_errors(ends[name], image, detector, count)
        true += errors.shape[0]
        if errors.shape[1]:
            found += int(np.sum(errors.min(axis=1) < tolerance))
    return found / true


def recall_curves(images, ends, tolerance_of, numbers):
    """{detector: [(number of lines, recall)]}, one to one."""
    curves = {}
    for detector in detectors_of(images):
        curves[detector] = []
        for n in numbers:
            found = true = 0
            for name, image in images.items():
                errors = strongest_errors(ends[name], image, detector, n)
                found += len(metrics.match(errors, tolerance_of(image))[0])
                true += errors.shape[0]
            curves[detector].append((n, found / true))
    return curves


def scales(groups):
    """Share of the lines that have a counterpart at another size of the photograph."""
    table = Table("scales", "Lines of each detector's own rule at half and double size: share with "
                  "a counterpart within 3 px (of the photograph's own size), one to one",
                  ["photographs and detector", "lines, half", "lines, whole", "lines, double",
                   "whole in half", "half in whole", "whole in double", "double in whole"])
    for folder in dict.fromkeys(group.split("|")[0] for group in groups):
        whole = groups[f"{folder}|whole"]
        for detector in detectors_of(whole):
            lines, shares = {}, []
            for scale, factor in (("half", 2), ("double", 0.5)):
                other = groups[f"{folder}|{scale}"]
                pairs = 0
                for name, image in whole.items():
                    there = scaled_lines(other[name].lines[detector], factor)
                    ends = results.chord_ends_of(image.lines[detector][:, :2], image.size)
                    pairs += len(metrics.match(geometry.line_errors(ends, there), 3)[0])
                total = sum(len(image.lines[detector]) for image in other.values())
                here = sum(len(image.lines[detector]) for image in whole.values())
                lines[scale] = total / len(whole)
                shares += [pairs / max(here, 1), pairs / max(total, 1)]
            table.add(f"{folder}, {detector}", number(lines["half"], 1),
                      number(here / len(whole), 1), number(lines["double"], 1),
                      *(number(share, 3) for share in shares))
    return [table]


def scaled_lines(lines, factor):
    """Lines of an image in the coordinates of one that is factor times as large.

    Pixel centres: x of one is factor (x + 0.5) - 0.5 of the other.
    """
    result = lines[:, :2].copy()
    shift = 0.5 * (factor - 1) * (np.cos(lines[:, 1]) + np.sin(lines[:, 1]))
    result[:, 0] = factor * lines[:, 0] + shift
    return result
