# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""The plots of the benchmark, each as PNG and SVG."""

import itertools

import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy as np

import measurements
from figures import legend_below, save
from tables import milliseconds

# Colours that colour-blind readers can tell apart (Okabe and Ito); ours are drawn thicker.
STYLE = {
    "Line Space": ("#0072b2", "-", "o"),
    "Line Space unpruned": ("#0072b2", "--", "o"),
    "drop-in 1 deg": ("#56b4e9", "-", "s"),
    "drop-in 0.1 deg": ("#56b4e9", "--", "s"),
    "HoughLines 1 deg": ("#d55e00", "-", "^"),
    "HoughLines 0.1 deg": ("#e69f00", "-", "^"),
    "HoughLines 1/(2n)": ("#8c510a", "-", "^"),
    "FastHoughTransform": ("#999999", "-", "D"),
    "HoughLinesP": ("#000000", ":", "v"),
    "LSD": ("#009e73", "-", "v"),
    "FastLineDetector": ("#cc79a7", "-", "v"),
    "EdgeDrawing": ("#882255", "--", "v"),
}
# Newer versions of cv::HoughLines have the colour of the installed one.
NEWER = [(":", "x"), ("-.", "+"), ("--", "*")]


def styles(times):
    """This is {method: style} of what is drawn of these times, in the order of drawing."""
    methods = set(times["method"])
    versions = {match[1] for match in map(measurements.HOUGH.fullmatch, methods) if match} - {None}
    versions = sorted(versions, key=lambda version: [int(part) for part in version.split(".")])
    found = {}
    for method, style in STYLE.items():
        found[method] = style
        hough = measurements.HOUGH.fullmatch(method)
        for version, look in zip(versions if hough else [], itertools.cycle(NEWER)):
            found[f"HoughLines {version} {hough[2]}"] = (style[0], *look)
    return {method: style for method, style in found.items() if method in methods}


def label(method):
    """A method's name for readers."""
    return method.replace(" 1 deg", " 1°").replace(" 0.1 deg", " 0.1°")


def _milliseconds(axis):
    """Plain numbers on a logarithmic axis."""
    axis.set_major_formatter(matplotlib.ticker.StrMethodFormatter("{x:g}"))
    axis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def _curve(panel, method, style, x, rows, text):
    """Medians as a line, quartiles as a band."""
    colour, line, marker = style
    ours = method.startswith(("Line Space", "drop-in"))
    panel.plot(x, rows["median"], color=colour, linestyle=line, marker=marker, markersize=4,
               linewidth=2.2 if ours else 1.3, label=text, zorder=3 if ours else 2)
    panel.fill_between(x, rows["low"], rows["high"], color=colour, alpha=0.15, linewidth=0)


def photographs(times, folder):
    """Every method at each size: a dot for each photograph, a larger one for their median."""
    methods = styles(times)
    sizes = list(times.groupby(["width", "height"], sort=False).groups)
    figure, panels = plt.subplots(1, len(sizes), sharey=True, squeeze=False, layout="constrained",
                                  figsize=(4.2 * len(sizes) + 2, 1 + 0.27 * len(methods)))
    for panel, (width, height) in zip(panels[0], sizes):
        here = times[(times["width"] == width) & (times["height"] == height)]
        for row, (method, (colour, *_)) in enumerate(methods.items()):
            values = here[here["method"] == method]["median"]
            if values.empty:
                continue
            middle, ours = values.median(), method.startswith(("Line Space", "drop-in"))
            panel.plot([values.min(), values.max()], [row, row], color=colour)
            panel.plot(middle, row, "o", color=colour, markersize=9 if ours else 7)
            panel.plot(values, [row] * len(values), ".", color="black", markersize=3)
            panel.annotate(milliseconds(middle), (values.max(), row), xytext=(8, 0), fontsize=8,
                           textcoords="offset points", verticalalignment="center",
                           fontweight="bold" if ours else "normal")
        panel.set(xscale="log", title=f"{width} x {height}", xlabel="milliseconds")
        panel.set_xlim(right=4 * here[here["method"].isin(methods)]["median"].max())
        _milliseconds(panel.xaxis)
    panels[0][0].set_yticks(range(len(methods)), [label(method) for method in methods])
    panels[0][0].invert_yaxis()
    figure.suptitle("Time of a call: each photograph, and their median in colour")
    save(figure, folder, "photographs")


def over_size(times, folder):
    """Log-log, with the slope of each method in the legend."""
    figure, panel = plt.subplots(figsize=(8, 5.5))
    for method, style in styles(times).items():
        rows = times[times["method"] == method].sort_values("width")
        slope = measurements.slope(rows["width"], rows["median"])
        text = label(method) + ("" if np.isnan(slope) else f", n^{slope:.1f}")
        _curve(panel, method, style, rows["width"], rows, text)
    panel.set(xscale="log", yscale="log", xlabel="n, pixels (n x n, building.jpg)",
              ylabel="milliseconds",
              title="Time over size; the slope is fitted from n = 256 on")
    panel.set_xticks(sorted(set(times["width"])))
    _milliseconds(panel.xaxis)
    _milliseconds(panel.yaxis)
    legend_below(figure, panel)
    save(figure, folder, "size")


def over_density(times, folder):
    """A panel for each size and kind of image."""
    groups = list(times.groupby(["width", "image"], sort=True))
    columns = len(set(times["image"]))
    figure, panels = plt.subplots(-(-len(groups) // columns), columns, squeeze=False, sharex=True,
                                  figsize=(5.5 * columns, 3.6 * -(-len(groups) // columns)),
                                  layout="constrained")
    for panel, ((width, image), here) in zip(panels.flat, groups):
        for method, style in styles(here).items():
            rows = here[here["method"] == method].sort_values("density")
            _curve(panel, method, style, 100 * rows["density"], rows, label(method))
        kind = "random maps" if image == "random" else f"{image}, thresholds of Canny"
        panel.set(yscale="log", title=f"{width} x {width}, {kind}")
        panel.set_xlim(left=0)
        _milliseconds(panel.yaxis)
    for panel in panels[-1]:
        panel.set_xlabel("edge pixels, %")
    for row in panels:
        row[0].set_ylabel("milliseconds")
    legend_below(figure, *panels.flat, columns=4)
    save(figure, folder, "density")


def _grouped_bars(times, by, values, folder, name, title):
    """Median over the photographs, for each method and value of a column, a panel for each size."""
    sizes = list(times.groupby(["width", "height"], sort=False).groups)
    methods = list(dict.fromkeys(times["method"]))
    figure, panels = plt.subplots(1, len(sizes), squeeze=False, layout="constrained",
                                  figsize=(3.4 * len(sizes) + 1.5, 0.8 + 0.75 * len(methods)))
    colours = ["#999999", "#56b4e9", "#0072b2", "#009e73", "#000000"]
    for panel, (width, height) in zip(panels[0], sizes):
        here = times[(times["width"] == width) & (times["height"] == height)]
        for i, value in enumerate(values):
            bars = [here[(here["method"] == method) & (here[by] == value)]["median"].median()
                    for method in methods]
            rows = np.arange(len(methods)) + (i - (len(values) - 1) / 2) * 0.8 / len(values)
            drawn = panel.barh(rows, bars, 0.8 / len(values), color=colours[i % len(colours)],
                               label=value if by == "isa" else f"threads: {value}")
            panel.bar_label(drawn, [milliseconds(bar) for bar in bars], padding=3, fontsize=8)
        panel.set(title=f"{width} x {height}", xlabel="milliseconds")
        panel.set_yticks(range(len(methods)),
                         [label(method) for method in methods] if panel is panels[0][0] else [])
        panel.margins(x=0.25)
        panel.invert_yaxis()
        panel.grid(axis="y", visible=False)
    legend_below(figure, panels[0][0], columns=len(values))
    figure.suptitle(title)
    save(figure, folder, name)


def threads(times, folder):
    _grouped_bars(times, "threads", sorted(set(times["threads"])), folder, "threads",
                  "Threads: median over the photographs")


def instruction_sets(times, folder):
    _grouped_bars(times, "isa", list(dict.fromkeys(times["isa"]))[::-1], folder,
                  "instruction-sets", "Instruction sets: median over the photographs")


def roofline(tables, folder):
    """tables: {title: measurements.roofline}; the time of each stage and what the limits allow."""
    figure, panels = plt.subplots(1, len(tables), squeeze=False, layout="constrained",
                                  figsize=(4.4 * len(tables), 5.2))
    for panel, (title, table) in zip(panels[0], tables.items()):
        rows = np.arange(len(table))
        if "least" in table:
            panel.hlines(rows, table["least"], table["milliseconds"], color="#bbbbbb", linewidth=3,
                         zorder=1)
            panel.plot(table["least"], rows, "|", color="#d55e00", markersize=14,
                       markeredgewidth=2.5, label="least by this machine's limits")
            for row, fraction in zip(rows, table["fraction"]):
                if not np.isnan(fraction):
                    panel.annotate(f"{100 * fraction:.0f} %", fontsize=8, xytext=(8, 0),
                                   xy=(table["milliseconds"][row], row),
                                   textcoords="offset points", verticalalignment="center")
        panel.plot(table["milliseconds"], rows, "o", color="#0072b2", label="measured")
        panel.set_yticks(rows, table["stage"])
        panel.set(title=title, xlabel="milliseconds", xscale="log")
        panel.set_xlim(right=4 * table["milliseconds"].max())
        _milliseconds(panel.xaxis)
        panel.invert_yaxis()
    legend_below(figure, panels[0][0], columns=2)
    figure.suptitle("Stages without pruning, and the fraction of the limit that they reach")
    save(figure, folder, "roofline")
