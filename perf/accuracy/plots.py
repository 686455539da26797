# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""The plots of the report, each as PNG and SVG, the same bytes on every run."""

import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy as np

import metrics
import synthetic
from figures import legend_below, save

# Colours that colour-blind readers can tell apart (Okabe and Ito); ours are drawn thicker.
STYLE = {
    "Line Space plain": ("#56b4e9", "-"),
    "Line Space explain": ("#0072b2", "--"),
    "Line Space oriented": ("#0072b2", "-"),
    "Line Space oriented unrefined": ("#56b4e9", ":"),
    "Line Space oriented exact": ("#000000", ":"),
    "HoughLines 1 px 1 deg": ("#d55e00", "-"),
    "HoughLines 1 px 1 deg suppressed": ("#d55e00", "--"),
    "HoughLines 0.5 px 0.25 deg": ("#e69f00", "-"),
    "HoughLines 0.5 px 0.25 deg suppressed": ("#e69f00", "--"),
    "HoughLines 1 px 1/(2n)": ("#8c510a", "-"),
    "HoughLines 1 px 1/(2n) suppressed": ("#8c510a", "--"),
    "FastHoughTransform": ("#999999", "-"),
    "LSD": ("#009e73", "-"),
    "FastLineDetector": ("#cc79a7", "-"),
}
FOUND, FALSE, MISSED = "#0072b2", "#e69f00", "#d55e00"


def recall_over_lines(curves, folder):
    """curves: {title: {detector: [(number of lines, recall)]}}, a panel each."""
    figure, panels = plt.subplots(1, len(curves), figsize=(5 * len(curves), 4.4), sharey=True,
                                  squeeze=False)
    for panel, (title, detectors) in zip(panels[0], curves.items()):
        for detector, points in detectors.items():
            if detector.endswith(("unrefined", "exact")):
                continue
            _draw(panel, detector, *zip(*points))
        panel.set(title=title, xlabel="strongest lines per image", ylim=(0, 1.03))
    panels[0][0].set_ylabel("recall")
    legend_below(figure, panels[0][0])
    save(figure, folder, "recall-over-lines")


def error_over_noise(every, folder):
    """every: as of synthetic.edge_errors."""
    ratios = [ratio for ratio in every if ratio]
    noise = [synthetic.CONTRAST / ratio for ratio in ratios]
    figure, panels = plt.subplots(1, 2, figsize=(12, 4.4))
    for panel, what, unit in zip(panels, ("position", "angle"), ("pixels", "mrad")):
        for detector in every[0]:
            errors = [synthetic.rms(synthetic.joined(every[ratio][detector]), what)
                      for ratio in ratios]
            _draw(panel, detector, noise, errors, marker="o")
        panel.plot(noise, _bounds(every, ratios, what), color="black", linewidth=2.5,
                   label="Cramer-Rao bound")
        panel.set(yscale="log", xlabel="sigma of the noise, grey levels (contrast 50)",
                  ylabel=f"RMS error of the {what}, {unit}", title=f"One edge: {what}")
        panel.yaxis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
        panel.yaxis.set_major_formatter(matplotlib.ticker.StrMethodFormatter("{x:g}"))
        panel.yaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    legend_below(figure, panels[0])
    save(figure, folder, "error-over-noise")


def _bounds(every, ratios, what):
    """RMS over all edges of the bound for each edge's length, in pixels or milliradians."""
    values = []
    for ratio in ratios:
        errors = synthetic.joined(every[ratio]["Line Space oriented"])
        values.append(metrics.root_mean_square(errors.position_bounds) if what == "position"
                      else 1000 * metrics.root_mean_square(errors.angle_bounds))
    return values


def false_lines(every, kinds, folder):
    """every: {detector: lines on ten images of each kind}."""
    figure, panel = plt.subplots(figsize=(10, 4.6))
    width = 0.8 / len(every)
    for i, (detector, values) in enumerate(every.items()):
        colour, line = STYLE[detector]
        panel.bar(np.arange(len(kinds)) + (i - len(every) / 2 + 0.5) * width, values, width,
                  color=colour, label=detector, edgecolor="black", linewidth=0.4,
                  hatch="///" if line == "--" else None)
    panel.axhline(1, color="black", linewidth=1, linestyle=":")
    panel.set_yscale("symlog", linthresh=1)
    highest = max(max(values) for values in every.values())
    panel.set(xticks=range(len(kinds)), xticklabels=kinds, ylim=(0, 2 * max(highest, 2)),
              ylabel="false lines in ten images", title="Images without any line, 512 x 512")
    legend_below(figure, panel)
    save(figure, folder, "false-lines")


def error_histogram(errors, folder):
    """errors: {detector: pixels}; a panel each, so that none hides another."""
    figure, panels = plt.subplots(len(errors), 1, figsize=(8, 1.5 * len(errors) + 0.6),
                                  sharex=True, sharey=True)
    bins = np.arange(0, 3.01, 0.05)
    for panel, (detector, values) in zip(panels, errors.items()):
        panel.hist(values, bins, color=STYLE[detector][0])
        panel.axvline(np.median(values), color="black", linestyle=":")
        panel.set_title(f"{detector}: {len(values)} lines, median {np.median(values):.3f} px",
                        loc="right", fontsize=10, pad=3)
        panel.set_ylabel("lines")
    figure.suptitle("Chessboards, strongest 40: error of the lines found within 3 px")
    figure.tight_layout()
    panels[-1].set_xlabel("line error, pixels")
    save(figure, folder, "error-histogram")


def picture(photograph, truth, results, size, title, folder, name):
    """truth: (t, 2, 2) ends; results: {detector: (ends of lines, are they found, true lines that
    are missed)}. The photograph beside what each detector made of it."""
    width = 5.2
    figure, panels = plt.subplots(1, 1 + len(results), layout="constrained",
                                  figsize=(width * (1 + len(results)),
                                           width * size[1] / size[0] + 0.6))
    for panel in panels:
        panel.imshow(photograph, cmap="gray", vmin=0, vmax=255)
        panel.set(xlim=(-0.5, size[0] - 0.5), ylim=(size[1] - 0.5, -0.5), xticks=[], yticks=[])
        panel.grid(False)
    panels[0].set_title(f"{title}: truth, {len(truth)} lines")
    _segments(panels[0], truth, "#009e73", "-")
    for panel, (detector, (ends, found, missed)) in zip(panels[1:], results.items()):
        panel.set_title(f"{detector}:\n{len(truth) - len(missed)} of {len(truth)} found, "
                        f"{len(ends)} lines reported")
        _segments(panel, ends[~found], FALSE, "-", 0.8)
        _segments(panel, ends[found], FOUND, "-")
        _segments(panel, missed, MISSED, "--", 2)
    handles = [plt.Line2D([], [], color=colour, linestyle=line, label=label)
               for colour, line, label in (("#009e73", "-", "true"), (FOUND, "-", "found"),
                                           (FALSE, "-", "not among the true lines"),
                                           (MISSED, "--", "true, but missed"))]
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0), ncol=4)
    save(figure, folder, name, dpi=75)


def _segments(panel, ends, colour, line, width=1.4):
    for first, last in ends:
        panel.plot([first[0], last[0]], [first[1], last[1]], color=colour, linestyle=line,
                   linewidth=width)


def _draw(panel, detector, x, y, marker=None):
    colour, line = STYLE[detector]
    ours = detector.startswith("Line Space")
    panel.plot(x, y, color=colour, linestyle=line, linewidth=2.2 if ours else 1.3, marker=marker,
               markersize=4, label=detector, zorder=3 if ours else 2)
