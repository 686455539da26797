# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Reads what linespace_benchmark wrote and sums it up: medians and quartiles of the calls of a
method on an input, ratios between methods, slopes over the image size, and what fraction of the
machine's limits a stage reaches."""

import json
import pathlib
import re

import numpy as np
import pandas as pd

INPUT = ["section", "image", "width", "height", "edge_pixels", "threshold", "threads", "isa"]
CALL = INPUT + ["method"]
# This matches a call of cv::HoughLines: the version, none for the installed OpenCV, and the angle
# step.
HOUGH = re.compile(r"HoughLines (?:(\d+\.\d+) )?((?:1 deg|0\.1 deg|1/\(2n\))(?: low)?)")


class Run:
    """One run of linespace_benchmark. Tables that its sections did not write are None."""

    def __init__(self, folder):
        folder = pathlib.Path(folder)
        self.machine = json.loads((folder / "machine.json").read_text("utf-8"))
        self.installed = ".".join(self.machine["opencv"].split(".")[:2])
        calls = pd.read_csv(folder / "times.csv")
        self.invalid = calls[calls["valid"] == 0]
        self.calls = calls
        # A call that did not find the reference's lines does not count, nor does its method there.
        self.times = summary(calls.groupby(CALL).filter(lambda rows: rows["valid"].all()))
        self.stages = stage_summary(pd.read_csv(folder / "stages.csv"))
        self.work = _read(folder / "stage-work.csv")
        self.limits = _read(folder / "limits.csv")
        self.memory = _read(folder / "memory.csv")
        self.opengl_work = _read(folder / "opengl-work.csv")

    def section(self, name):
        return self.times[self.times["section"] == name]

    def section_with_fastest(self, name):
        return with_fastest(self.section(name), self.installed)


def _read(path):
    return pd.read_csv(path) if path.exists() else None


def summary(calls):
    """One row for each method and input: how many calls (n), their median and quartiles."""
    if calls.empty:
        return pd.DataFrame(columns=CALL + ["n", "median", "low", "high", "lines", "density"],
                            dtype=float)
    grouped = calls.groupby(CALL, sort=False)
    times = grouped["milliseconds"].agg(
        n="count", median="median", low=lambda values: values.quantile(0.25),
        high=lambda values: values.quantile(0.75))
    times["lines"] = grouped["lines"].last()
    times = times.reset_index()
    times["density"] = times["edge_pixels"] / (times["width"] * times["height"])
    return times


def with_fastest(times, installed):
    """This adds the method "fastest HoughLines STEP": for each input and angle step the times of
    that OpenCV whose cv::HoughLines was fastest, which "version" tells. installed: the version of
    the calls without one."""
    found = [HOUGH.fullmatch(method) for method in times["method"]]
    calls = times.assign(step=[match and match[2] for match in found],
                         version=[match and (match[1] or installed) for match in found])
    calls = calls[calls["step"].notna()].sort_values("median", kind="stable")
    fastest = calls.drop_duplicates(INPUT + ["step"]).sort_index()
    fastest["method"] = [f"fastest HoughLines {step}" for step in fastest["step"]]
    return pd.concat([times, fastest.drop(columns="step")], ignore_index=True)


def stage_summary(stages):
    """One row for each stage: its median over the calls, and its place in their order."""
    grouped = stages.groupby(CALL + ["stage"], sort=False)
    result = grouped["milliseconds"].agg(
        median="median", low=lambda values: values.quantile(0.25),
        high=lambda values: values.quantile(0.75))
    result["order"] = grouped["order"].first()
    return result.reset_index()


def medians(times, methods=None):
    """A table with a row for each input and a column for each method."""
    if methods is not None:
        times = times[times["method"].isin(methods)]
    return times.pivot_table(index=["width", "height", "image"], columns="method",
                             values="median", sort=False)


def ratios(times, peer, ours):
    """How many times as long as ours the peer takes, by size and image; those without both left
    out."""
    table = medians(times, [peer, ours]).reindex(columns=list({peer, ours}))
    return (table[peer] / table[ours]).dropna()


def by_size(series):
    """{(width, height): values of all images}."""
    sizes = {}
    for (width, height, _), value in series.items():
        sizes.setdefault((width, height), []).append(value)
    return {size: np.array(values) for size, values in sizes.items()}


def slope(sides, milliseconds, smallest=256):
    """The exponent of time over side, by least squares in logarithms, from a size on at which what
    a call costs anyway no longer matters; nan for fewer than two sizes."""
    sides, milliseconds = np.asarray(sides, float), np.asarray(milliseconds, float)
    used = sides >= smallest
    if np.count_nonzero(used) < 2:
        return float("nan")
    return float(np.polyfit(np.log(sides[used]), np.log(milliseconds[used]), 1)[0])


def variation(milliseconds):
    """By how much the longest time exceeds the shortest, as a share."""
    return max(milliseconds) / min(milliseconds) - 1


class Limits:
    """The measured limits with one number of threads."""

    def __init__(self, table, threads):
        self.table = table[table["threads"] == threads]

    def place(self, size):
        """The smallest cache that holds so many bytes, or memory."""
        caches = self.table[self.table["capacity"] > 0].sort_values("capacity")
        holds = caches[caches["capacity"] >= size]
        return holds["place"].iloc[0] if len(holds) else "memory"

    def rate(self, place, what):
        rows = self.table[(self.table["place"] == place) & (self.table["what"] == what)]
        return float(rows["per_second"].iloc[0])

    def least_milliseconds(self, work):
        """{limit: milliseconds} that a stage takes at least, by each of the limits: to move what it
        must through the smallest place that holds all of it, to load and store what it does
        through the first cache, to add."""
        moved = work["bytes_read"] + work["bytes_written"]
        place = self.place(moved)
        what = "copy" if work["bytes_written"] else "read"
        touched = work["bytes_loaded"] + work["bytes_stored"]
        first = max(self.rate("L1", kind)
                    for kind in (("copy", "add") if work["bytes_stored"] else ("read",)))
        adds = work["adds"] * work["bytes_per_vote"]
        return {f"{place} {what}": 1e3 * moved / self.rate(place, what),
                "L1 load/store": 1e3 * touched / first,
                "adds": 1e3 * adds / self.rate("registers", "adds")}


def roofline(run, width, height, threads):
    """The stages of `detect` without pruning beside the machine's limits, a row each, medians over
    the images: milliseconds, work, the limit that binds, its time, and the fraction reached."""
    limits = Limits(run.limits, threads)
    stages = run.stages[(run.stages["section"] == "stages") & (run.stages["width"] == width)
                        & (run.stages["height"] == height) & (run.stages["threads"] == threads)
                        & (run.stages["method"] == "Line Space unpruned")]
    times = stages.groupby("stage", sort=False)[["median", "order"]].median().sort_values("order")
    work = run.work[(run.work["width"] == width) & (run.work["height"] == height)]
    work = work.set_index("stage")
    rows = []
    for stage, time in times["median"].items():
        if stage not in work.index:
            rows.append({"stage": stage, "milliseconds": time})
            continue
        what = work.loc[stage]
        least = limits.least_milliseconds(what)
        binding = max(least, key=least.get)
        rows.append({"stage": stage, "milliseconds": time,
                     "moved": what["bytes_read"] + what["bytes_written"],
                     "touched": what["bytes_loaded"] + what["bytes_stored"],
                     "adds": what["adds"], "limit": binding, "least": least[binding],
                     "fraction": least[binding] / time})
    return pd.DataFrame(rows)
