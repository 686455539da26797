# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""What is required of the times, and whether the measured ones hold it."""

import dataclasses

import numpy as np

import measurements

OURS, UNPRUNED = "Line Space", "Line Space unpruned"
SIZES = [(512, 512), (1024, 1024), (1920, 1080)]


@dataclasses.dataclass
class Row:
    """One requirement. measured: None where this run has no such times."""

    what: str
    wanted: str
    measured: str | None
    holds: bool | None


def all_rows(run):
    times = run.section_with_fastest("photographs")
    rows = _beside(times, "fastest HoughLines 1 deg", "the fastest cv::HoughLines(1, 1°)",
                   (5, 4, 4), never_slower=True)
    rows += _beside(times, "fastest HoughLines 1/(2n)", "the fastest cv::HoughLines(1, 1/(2n))",
                    (100, 200, 200))
    rows += _beside(times, "FastHoughTransform", "FastHoughTransform", (4, 3, 3))
    rows += _beside(times, "FastHoughTransform", "FastHoughTransform", (2, 2), ours=UNPRUNED)
    rows += [row for size in SIZES[:2] for row in _flat(run.section("densities"), size)]
    rows += _drop_in(times)
    rows.append(_threads(run.section("threads")))
    rows += _memory(run.memory)
    ours = run.calls["method"].str.startswith(("Line Space", "drop-in")).sum()
    invalid = len(run.invalid)
    rows.append(Row("lines of every timed call of ours are BACKEND_REFERENCE's", "all",
                    f"{ours - invalid} of {ours} calls", invalid == 0))
    return rows


def _missing(what, wanted):
    return Row(what, wanted, None, None)


def _at_least(what, wanted, choose, values, factor):
    """A row on how many times faster; choose: of the values of the photographs."""
    if values is None:
        return _missing(what, wanted)
    value = float(choose(values))
    return Row(what, wanted, f"{value:.2f} times", value >= factor)


def _beside(times, peer, title, factors, ours=OURS, never_slower=False):
    """`detect` beside a peer: the median over the photographs, for each size."""
    groups = measurements.by_size(measurements.ratios(times, peer, ours))
    rows = []
    for size, factor in zip(SIZES, factors):
        name = "detect" if ours == OURS else "detect, setPruning(false),"
        what = f"{name} beside {title}, {size[0]} x {size[1]}, "
        rows.append(_at_least(what + "median of photographs", f"{factor} times faster",
                              np.median, groups.get(size), factor))
        if never_slower:
            rows.append(_at_least(what + "worst photograph", "never slower", min,
                                  groups.get(size), 1))
    return rows


def _flat(times, size):
    rows = []
    for image in ("random", "board.jpg"):
        here = times[(times["width"] == size[0]) & (times["height"] == size[1])
                     & (times["method"] == UNPRUNED) & (times["image"] == image)]
        what = (f"detect, setPruning(false), 1 % to 30 % edge pixels, {size[0]} x {size[1]}, "
                f"{'random maps' if image == 'random' else image + ' by thresholds of Canny'}")
        if len(here) < 2:
            rows.append(_missing(what, "varies by at most 15 %"))
            continue
        value = measurements.variation(here["median"])
        rows.append(Row(what, "varies by at most 15 %", f"{100 * value:.0f} %", value <= 0.15))
    return rows


def _drop_in(times):
    """The least of all photographs, of both thresholds."""
    rows = []
    for step, factor, wanted in (("1 deg", 1, "never slower"),
                                 ("0.1 deg", 10, "10 times faster")):
        both = [measurements.by_size(measurements.ratios(
            times, f"fastest HoughLines {step}{mark}", f"drop-in {step}{mark}"))
                for mark in ("", " low")]
        for size in SIZES:
            what = (f"drop-in HoughLines(1, {step.replace(' deg', '°')}) beside the fastest "
                    f"cv::HoughLines, {size[0]} x {size[1]}, worst photograph and threshold")
            values = (np.concatenate([groups[size] for groups in both])
                      if all(size in groups for groups in both) else None)
            rows.append(_at_least(what, wanted, min, values, factor))
    return rows


def _threads(times):
    """Two cores against one at 1024 x 1024."""
    what, wanted = "detect, two threads against one, 1024 x 1024, median of photographs", "1.7"
    here = times[(times["width"] == 1024) & (times["height"] == 1024) & (times["method"] == OURS)]
    table = here.pivot_table(index="image", columns="threads", values="median")
    if 1 not in table or 2 not in table:
        return _missing(what, wanted)
    value = float((table[1] / table[2]).median())
    return Row(what, wanted, f"{value:.2f}", value >= 1.7)


def _memory(table):
    rows = []
    for size in ((1920, 1080), (4096, 4096)):
        what = f"peak memory of detect, {size[0]} x {size[1]}"
        here = None if table is None else table[(table["width"] == size[0])
                                                & (table["height"] == size[1])]
        if here is None or here.empty:
            rows.append(_missing(what, "48 bytes per pixel"))
            continue
        value = float(here["bytes"].iloc[0]) / (size[0] * size[1])
        rows.append(Row(what, "48 bytes per pixel", f"{value:.1f}", value <= 48))
    return rows
