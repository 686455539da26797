# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""The sections of the report on synthetic images: step edges, other scenes, one edge, negatives."""

import numpy as np

import geometry
import metrics
import results
from photographs import detectors_of
from tables import Table, number

CONTRAST, BLUR = 50, 1  # of the one edge, grey levels and pixels


def truth_ends(image):
    return results.chord_ends_of(image.truth, image.size)


def counts_of(images, detector, tolerances):
    counts = metrics.Counts(tolerances, 3)
    for image in images.values():
        # Where one line is asked for, suppression changes nothing and is not written.
        written = detector if detector in image.lines else detector.removesuffix(" suppressed")
        counts.add(geometry.line_errors(truth_ends(image), image.lines[written]))
    return counts


def steps(groups):
    """Eight step edges: the strongest eight, then what each detector's own rule reports."""
    tables = []
    for rule, title in (("strongest", "the strongest 8"), ("own rule", "by their own rule")):
        chosen = {group.split("|", 1)[1]: images for group, images in groups.items()
                  if group.startswith(rule)}
        for group, images in chosen.items():
            side, noise = group.split("|")
            table = Table(f"steps-{rule.replace(' ', '-')}-{side}-{noise}",
                          f"Eight step edges, {side} x {side}, noise {noise}, {title}",
                          ["detector", "recall 3 px", "precision 3 px", "recall 1 px",
                           "median error, px", "lines per image"])
            for detector in detectors_of(images):
                counts = counts_of(images, detector, (1, 3))
                table.add(detector, number(counts.recall(3), 4), number(counts.precision(3), 4),
                          number(counts.recall(1), 4), number(counts.median_error(), 3),
                          number(counts.lines_per_image(), 2))
            tables.append(table)
    return tables


def scenes(groups):
    """Recall of other scenes, one row for each kind; as many strongest lines as there are true."""
    short = {"Line Space plain": "plain", "Line Space explain": "explain",
             "Line Space oriented": "oriented",
             "HoughLines 1 px 1 deg suppressed": "HL 1 px 1° s.",
             "HoughLines 0.5 px 0.25 deg suppressed": "HL 0.5 px 0.25° s.",
             "HoughLines 1 px 1/(2n) suppressed": "HL 1 px 1/(2n) s.",
             "FastHoughTransform": "FHT", "LSD": "LSD", "FastLineDetector": "FLD"}
    tables = []
    for tolerance in (3, 1):
        table = Table(f"scenes-{tolerance}", f"Other scenes: recall at {tolerance} px",
                      ["scene", *short.values()])
        for group, images in groups.items():
            if tolerance == 1 and group.startswith("bars"):
                continue  # what is found are a bar's edges
            table.add(group.replace("|", ", "),
                      *(number(counts_of(images, detector, (tolerance,)).recall(tolerance), 3)
                        for detector in short))
        tables.append(table)
    return tables


class EdgeErrors:
    """Errors of one detector on the one edge: in pixels at mid-chord and in radians, and their
    bounds for the edge's length; edges that are further away than 3 px at an end are missed."""

    def __init__(self):
        self.positions, self.angles = [], []
        self.position_bounds, self.angle_bounds = [], []
        self.missed = 0

    def add(self, image, detector, noise):
        (ends,) = truth_ends(image)
        lines = image.lines[detector]
        if not len(lines) or geometry.line_errors([ends], lines[:1])[0, 0] >= 3:
            self.missed += 1
            return
        rho, theta = lines[0, :2]
        middle = ends.mean(axis=0)
        self.positions.append(middle @ (np.cos(theta), np.sin(theta)) - rho)
        turn = (theta - image.truth[0, 1] + np.pi / 2) % np.pi - np.pi / 2
        self.angles.append(turn)
        length = np.linalg.norm(ends[1] - ends[0])
        self.position_bounds.append(metrics.position_bound(noise, CONTRAST, BLUR, length))
        self.angle_bounds.append(metrics.angle_bound(noise, CONTRAST, BLUR, length))

    def join(self, other):
        for name in ("positions", "angles", "position_bounds", "angle_bounds", "missed"):
            setattr(self, name, getattr(self, name) + getattr(other, name))

    def position_ratio(self):
        return metrics.root_mean_square(np.divide(self.positions, self.position_bounds))

    def angle_ratio(self):
        return metrics.root_mean_square(np.divide(self.angles, self.angle_bounds))


def edge_errors(groups):
    """{contrast / noise (0: no noise): {detector: {angle: EdgeErrors}}}"""
    every = {}
    for group, images in groups.items():
        angle, ratio = group.split("|")
        noise = CONTRAST / float(ratio) if float(ratio) else 0
        for detector in detectors_of(images):
            errors = EdgeErrors()
            for image in images.values():
                errors.add(image, detector, noise)
            every.setdefault(float(ratio), {}).setdefault(detector, {})[angle] = errors
    return every


def joined(by_angle, angles=None):
    every = EdgeErrors()
    for angle, errors in by_angle.items():
        if angles is None or angle in angles:
            every.join(errors)
    return every


def one_edge(groups):
    every = edge_errors(groups)
    ratios = [ratio for ratio in every if ratio]
    tables = []
    for what, unit in (("position", "px"), ("angle", "mrad")):
        table = Table(f"one-edge-{what}",
                      f"One edge, {what}: RMS error without noise in {unit}, then over the "
                      "Cramer-Rao bound, all angles (in brackets the worst angle)",
                      ["detector", "no noise", *(f"c/n {ratio:g}" for ratio in ratios), "missed"])
        for detector, by_angle in every[0].items():
            clean = [rms(errors, what) for errors in by_angle.values()]
            missed = sum(joined(every[ratio][detector]).missed for ratio in every)
            table.add(detector, f"{rms(joined(by_angle), what):.3f} ({np.nanmax(clean):.3f})",
                      *(_ratio_cell(every[ratio][detector], what) for ratio in ratios), missed)
        tables.append(table)
    for what in ("position", "angle"):
        table = Table(f"one-edge-{what}-angles", f"One edge, {what}, Line Space oriented: RMS error "
                      "over the Cramer-Rao bound by angle of the normal",
                      ["angle, degrees", *(f"c/n {ratio:g}" for ratio in ratios)])
        for angle in every[0]["Line Space oriented"]:
            table.add(angle, *(number(_ratio(every[ratio]["Line Space oriented"][angle], what), 2)
                               for ratio in ratios))
        tables.append(table)
    return tables, every


def rms(errors, what):
    """In pixels or milliradians."""
    if what == "position":
        return metrics.root_mean_square(errors.positions)
    return 1000 * metrics.root_mean_square(errors.angles)


def _ratio(errors, what):
    return errors.position_ratio() if what == "position" else errors.angle_ratio()


def _ratio_cell(by_angle, what):
    worst = np.nanmax([_ratio(errors, what) for errors in by_angle.values()])
    return f"{_ratio(joined(by_angle), what):.2f} ({worst:.2f})"


def negatives(groups):
    table = Table("negatives", "Lines on ten images without any, 512 x 512",
                  ["detector", *groups])
    every = {}
    for detector in detectors_of(next(iter(groups.values()))):
        every[detector] = [10 * float(np.mean([len(image.lines[detector])
                                               for image in images.values()]))
                           for images in groups.values()]
        table.add(detector, *(number(value, 1) for value in every[detector]))
    return [table], every
