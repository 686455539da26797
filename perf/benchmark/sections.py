# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""The sections of the report: tables and plots from a measurements.Run."""

import math

import measurements
import plots
import requirements
from tables import Table, milliseconds, number

VOTES = ("edge map", "level ")
# Each of ours is compared with the fastest cv::HoughLines of an angle step.
BESIDE = [("drop-in 1 deg", "1 deg"), ("drop-in 1 deg low", "1 deg low"),
          ("drop-in 0.1 deg", "0.1 deg"), ("drop-in 0.1 deg low", "0.1 deg low"),
          (requirements.OURS, "1 deg"), (requirements.OURS, "1/(2n)")]


def spread(row):
    """Median, quartiles and number of calls of a row of measurements.summary."""
    version = f", {row['version']}" if isinstance(row.get("version"), str) else ""
    return (f"{milliseconds(row['median'])} ({milliseconds(row['low'])} to "
            f"{milliseconds(row['high'])}, n {row['n']}{version})")


def median_at(rows, key):
    """This is the median of one of the rows, with the version of OpenCV where the row tells it."""
    if key not in rows.index:
        return "-"
    row = rows.loc[key]
    version = f" ({row['version']})" if isinstance(row.get("version"), str) else ""
    return milliseconds(row["median"]) + version


def size_text(width, height):
    return f"{width} x {height}"


def write_requirements(report):
    report.text("## Requirements\n\nOf the times below: this run, the threads named at the head. A dash: "
                "this run did not measure it.\n")
    table = Table("requirements", "What is wanted, and what was measured",
                  ["", "wanted", "measured", "holds"])
    for row in requirements.all_rows(report.run):
        holds = "-" if row.holds is None else "yes" if row.holds else "**no**"
        table.add(row.what, row.wanted, row.measured or "-", holds)
    report.table(table)
    if len(report.run.invalid):
        wrong = report.run.invalid[["section", "method", "image", "width"]].drop_duplicates()
        report.text("Calls whose lines are **not the reference's**; their times are left out: "
                    + "; ".join(f"{row.section}: {row.method} on {row.image}, {row.width}"
                                for row in wrong.itertuples()) + "\n")


def write_photographs(report):
    times = report.run.section("photographs")
    if times.empty:
        return
    report.text("""## Photographs

*Line Space*: `detect` for the 100 strongest lines above a fifth of the shorter side, refined, by a detector that is kept; *unpruned*: with
`setPruning(false)`; *first call*: a new detector each time. *Drop-in*: `cv::linespace::HoughLines`, all lines; *low*: above a tenth of
the shorter side instead of a fifth, some thousands of lines. HoughLines: `cv::HoughLines(1, theta)` of OpenCV {installed}; with a version:
that of a newer OpenCV ({newer}), called from Python. LSD and EdgeDrawing look for edges themselves, on the grey image, so that their times
contain what *Canny* costs the others. FastHoughTransform is the transform alone. Milliseconds: medians (quartiles, n calls).
""".format(installed=report.run.installed,
           newer=report.run.machine["newer_opencv"] or "none in this run"))
    for (width, height), here in times.groupby(["width", "height"], sort=False):
        images = list(dict.fromkeys(here["image"]))
        table = Table(f"photographs-{width}x{height}", size_text(width, height),
                      ["method", *images, "over Line Space (median)"])
        for method in dict.fromkeys(here["method"]):
            rows = here[here["method"] == method].set_index("image")
            ratio = measurements.ratios(here, method, requirements.OURS).median()
            table.add(plots.label(method),
                      *(spread(rows.loc[image]) if image in rows.index else "-"
                        for image in images), number(ratio, 2))
        report.table(table)
        table = Table(f"lines-{width}x{height}", f"Edge pixels and lines, {size_text(width, height)}",
                      ["", *images])
        first = here.drop_duplicates("image").set_index("image")
        table.add("edge pixels", *(f"{first.loc[image, 'edge_pixels']} "
                                   f"({100 * first.loc[image, 'density']:.1f} %)"
                                   for image in images))
        for method in dict.fromkeys(here[here["lines"] > 0]["method"]):
            rows = here[here["method"] == method].set_index("image")["lines"]
            table.add(method, *(str(rows.get(image, "-")) for image in images))
        report.table(table)
        _write_beside_fastest(report, here, images)
    plots.photographs(times, report.folder)
    report.plot("photographs", "Times on photographs")


def _write_beside_fastest(report, times, images):
    """This compares ours with the fastest cv::HoughLines, at one size."""
    width, height = times[["width", "height"]].iloc[0]
    times = measurements.with_fastest(times, report.run.installed)
    table = Table(f"fastest-{width}x{height}",
                  "How many times as long as ours the fastest cv::HoughLines takes: its "
                  f"milliseconds, {size_text(width, height)}",
                  ["ours", "fastest cv::HoughLines", *images, "least", "median"])
    for ours, step in BESIDE:
        peer = f"fastest HoughLines {step}"
        ratios = measurements.ratios(times, peer, ours).droplevel(["width", "height"])
        rows = times[times["method"] == peer].set_index("image")
        table.add(plots.label(ours), plots.label(" " + step).strip(),
                  *(f"{number(ratios[image], 2)}: {median_at(rows, image)}"
                    if image in ratios else "-" for image in images),
                  number(ratios.min(), 2), number(ratios.median(), 2))
    report.table(table)


def write_paper(report):
    times = report.run.section_with_fastest("paper")
    if times.empty:
        return
    device = report.run.machine["opencl"] or "none"
    report.text(f"""## Table 1 of the paper

Times over the side n for two images of different density p of edge pixels, k = 8, milliseconds (medians). *Hough*: `cv::HoughLines` at
(1, 1/(2n)), the angle step that samples as finely as the Line Space; *OpenCL*: the same on cv::UMat (device: {device}), at most 4096 lines.
*Line Space*: `METHOD_EXACT`. *Cascaded*: `METHOD_CASCADED` with `setPruning(false)`: first cells (with the copy of the edge map), merges, both; *lines*: all of
`detect`; *pruned*: all of `detect` as it is by default. FHT: FastHoughTransform.
""")
    table = Table("paper", "Table 1 with our columns",
                  ["n", "image", "p", "Hough CPU", "fastest cv::HoughLines", "Hough OpenCL",
                   "Line Space", "first cells", "merges", "total", "lines", "pruned", "FHT"])
    stages = report.run.stages[(report.run.stages["section"] == "paper")
                               & (report.run.stages["method"] == requirements.UNPRUNED)]
    for (width, image), here in times.groupby(["width", "image"], sort=False):
        rows = here.set_index("method")
        value = rows["median"]
        counted = stages[(stages["width"] == width) & (stages["image"] == image)]
        cells = counted[counted["stage"].isin(["edge map", "level 0"])]["median"].sum()
        total = counted[counted["stage"].str.startswith(VOTES)]["median"].sum()
        table.add(width, image, number(here["density"].iloc[0], 3),
                  *(median_at(rows, method) for method in
                    ("HoughLines 1/(2n)", "fastest HoughLines 1/(2n)",
                     "OpenCL HoughLines 1/(2n)", "Line Space exact")),
                  milliseconds(cells), milliseconds(total - cells), milliseconds(total),
                  *(milliseconds(value.get(method, math.nan)) for method in
                    (requirements.UNPRUNED, requirements.OURS, "FastHoughTransform")))
    report.table(table)


def write_opencl(report):
    times = report.run.section_with_fastest("opencl")
    if times.empty:
        return
    report.text("""## OpenCL

*OpenCL Line Space*: `detect` of a cv::UMat for the 100 strongest lines, by a detector that is kept; *first call*: a new detector each time, its
kernels compiled before. *Drop-in*: `cv::linespace::HoughLines` on the UMat; *HoughLines*: `cv::HoughLines` on it, at most 4096 lines.
*Edge map in*: from a cv::Mat to the UMat, which no other row contains; *lines out*: 100 lines from a UMat to a Mat. Without *OpenCL*: on cv::Mat. Device: {device}.
Milliseconds: medians (quartiles, n calls).
""".format(device=report.run.machine["opencl"]))
    for (width, height), here in times.groupby(["width", "height"], sort=False):
        images = list(dict.fromkeys(here["image"]))
        table = Table(f"opencl-{width}x{height}", size_text(width, height),
                      ["method", *images, "over OpenCL Line Space (median)"])
        for method in dict.fromkeys(here["method"]):
            rows = here[here["method"] == method].set_index("image")
            ratio = measurements.ratios(here, method, "OpenCL Line Space").median()
            table.add(plots.label(method),
                      *(spread(rows.loc[image]) if image in rows.index else "-"
                        for image in images), number(ratio, 2))
        report.table(table)


def write_opengl(report):
    times = report.run.section_with_fastest("opengl")
    if times.empty:
        return
    report.text("""## OpenGL

The columns of Table 1 of the paper by `BACKEND_OPENGL`, over the side n, k = 8, milliseconds (medians). *Line Space*: `METHOD_EXACT`, all of `detect`. *Cascaded*: first
cells, merges and both by the device's own clock; *lines*: all of `detect`. *CPU*: the same two by `BACKEND_CPU`, the cascaded one with `setPruning(false)`. *Hough*: `cv::HoughLines` at
(1, 1/(2n)) on the CPU.
""")
    table = Table("opengl", "Table 1 by OpenGL",
                  ["n", "image", "p", "Hough CPU", "fastest cv::HoughLines", "Line Space",
                   "first cells", "merges", "total", "lines", "Line Space over lines",
                   "CPU Line Space", "CPU lines"])
    stages = report.run.stages[(report.run.stages["section"] == "opengl")
                               & (report.run.stages["method"] == "OpenGL Line Space")]
    for (width, image), here in times.groupby(["width", "image"], sort=False):
        rows = here.set_index("method")
        value = rows["median"]
        counted = stages[(stages["width"] == width) & (stages["image"] == image)]
        cells = counted[counted["stage"] == "level 0"]["median"].sum()
        total = counted[counted["stage"].str.startswith("level ")]["median"].sum()
        exact, lines = (value.get(method, math.nan)
                        for method in ("OpenGL Line Space exact", "OpenGL Line Space"))
        table.add(width, image, number(here["density"].iloc[0], 3),
                  *(median_at(rows, method)
                    for method in ("HoughLines 1/(2n)", "fastest HoughLines 1/(2n)")),
                  milliseconds(exact),
                  milliseconds(cells), milliseconds(total - cells), milliseconds(total),
                  milliseconds(lines), number(exact / lines, 1),
                  *(milliseconds(value.get(method, math.nan))
                    for method in ("Line Space exact", requirements.UNPRUNED)))
    report.table(table)
    _write_words(report)


def _write_words(report):
    """What BACKEND_OPENGL has to do, and what other ways of merging would."""
    words = report.run.opengl_work
    if words is None:
        return
    table = Table("opengl-work", "Words of 32 bits, 10^6: what OpenGL loads, stores and adds; what tiles of 8 x 8 chords would load that "
                  "share their parts in the memory of their group; what steps of 2 x 2 cells would load (l), and store",
                  ["n", "exact, adds", "first cells, adds", "merges, loads", "stores", "adds",
                   "exact over cascade, adds", "loads with shared memory", "loads of 2 x 2 steps",
                   "stores of 2 x 2 steps"])
    for n, here in words.groupby("n", sort=False):
        exact = here[here["stage"] == "exact"]["adds"].sum()
        cells = here[here["stage"] == "level 0"]["adds"].sum()
        merges = here[here["shared_loads"] > 0]
        # The upper ones of pairs from the last level down, and a lower one that has no partner.
        upper = merges.iloc[::-1].iloc[::2]
        alone = upper[upper["fused_loads"] == 0]
        fused = upper["fused_loads"].sum() + alone["loads"].sum()
        table.add(n, *(number(value / 1e6, 2) for value in
                       (exact, cells, merges["loads"].sum(), merges["stores"].sum(),
                        merges["adds"].sum())),
                  number(exact / (cells + merges["adds"].sum()), 1),
                  *(number(value / 1e6, 2) for value in
                    (merges["shared_loads"].sum(), fused, upper["stores"].sum())))
    report.table(table)


def write_sizes(report):
    times = report.run.section_with_fastest("sizes")
    if times.empty:
        return
    report.text("## Time over size\n\nbuilding.jpg at n x n, milliseconds (medians). The slope is the exponent of n from "
                "n = 256 on; the edge pixels of a photograph grow less than n².\n")
    sides = sorted(set(times["width"]))
    table = Table("sizes", "Time over n", ["method", *map(str, sides), "slope"])
    for method in dict.fromkeys(times["method"]):
        rows = times[times["method"] == method].set_index("width")
        table.add(plots.label(method), *(median_at(rows, n) for n in sides),
                  number(measurements.slope(rows.index, rows["median"]), 2))
    report.table(table)
    plots.over_size(times, report.folder)
    report.plot("size", "Time over size")


def write_densities(report):
    times = report.run.section_with_fastest("densities")
    if times.empty:
        return
    report.text("## Time over the share of edge pixels\n\nRandom maps of independent edge pixels, and the edges of board.jpg by other "
                "thresholds of Canny (in a ratio of 1 to 3), milliseconds (medians). *Votes*: of the unpruned cascade, before the search for lines.\n")
    for (image, width), here in times.groupby(["image", "width"], sort=False):
        shares = sorted(set(here["density"]))
        table = Table(f"densities-{image.split('.')[0]}-{width}", f"{image}, {width} x {width}",
                      ["method", *(f"{100 * share:.1f} %" for share in shares), "varies by"])
        for method in dict.fromkeys(here["method"]):
            rows = here[here["method"] == method].set_index("density")
            _add_over(table, plots.label(method), rows, shares)
            if method == requirements.UNPRUNED:
                _add_over(table, "votes", _votes(report.run.stages, image, width), shares)
        report.table(table)
    plots.over_density(times, report.folder)
    report.plot("density", "Time over the share of edge pixels")


def _votes(stages, image, width):
    here = stages[(stages["section"] == "densities") & (stages["image"] == image)
                  & (stages["width"] == width) & (stages["method"] == requirements.UNPRUNED)
                  & stages["stage"].str.startswith(VOTES)]
    sums = here.groupby("edge_pixels")[["median"]].sum()
    sums.index = sums.index / width ** 2
    return sums


def _add_over(table, name, rows, shares):
    table.add(name, *(median_at(rows, share) for share in shares),
              f"{100 * measurements.variation(rows['median']):.0f} %")


def write_threads(report):
    times = report.run.section("threads")
    if times.empty:
        return
    report.text("## Threads\n\nMilliseconds, medians over the photographs of the medians of calls; the speed-up is the median of the "
                "photographs' own.\n")
    counts = sorted(set(times["threads"]))
    table = Table("threads", "Threads", ["size and method", *(f"{count}" for count in counts),
                                         "speed-up"])
    for (width, height, method), here in times.groupby(["width", "height", "method"], sort=False):
        by_image = here.pivot_table(index="image", columns="threads", values="median")
        table.add(f"{size_text(width, height)}, {plots.label(method)}",
                  *(milliseconds(by_image[count].median()) for count in counts),
                  number((by_image[counts[0]] / by_image[counts[-1]]).median(), 2))
    report.table(table)
    plots.threads(times, report.folder)
    report.plot("threads", "Threads")


def write_instruction_sets(report):
    times = report.run.section("instruction-sets")
    if times.empty:
        return
    report.text("## Instruction sets\n\nProcesses with `OPENCV_CPU_DISABLE`, called in turn, each asked which set it really uses. "
                "Milliseconds, medians over the photographs.\n")
    sets = list(dict.fromkeys(times["isa"]))[::-1]
    table = Table("instruction-sets", "Instruction sets", ["size and method", *sets])
    for (width, height, method), here in times.groupby(["width", "height", "method"], sort=False):
        value = here.groupby("isa")["median"].median()
        table.add(f"{size_text(width, height)}, {method}",
                  *(milliseconds(value.get(name, math.nan)) for name in sets))
    report.table(table)
    plots.instruction_sets(times, report.folder)
    report.plot("instruction-sets", "Instruction sets")


def write_stages(report):
    run = report.run
    if run.limits is None or run.work is None:
        return
    report.text("""## Stages beside this machine's limits

`detect` with `setPruning(false)`, medians over the photographs. *Moved*: what a stage must read and write once, from the plan's tables
(child table, parent table); *touched*: what its instructions load and store (two loads for a sum of two). The *limit* is the
largest of: moved bytes at the measured rate of the smallest place that holds them (copying; reading, where nothing is written); touched
bytes at the measured rate of the first cache; adds at the rate measured in registers. The *fraction* is limit over measured time; stages whose work depends on the image have none. A store's fetch of its
cache line is not counted, in the limits as in the work. Counters are taken to be as
wide as a level's longest chord may need: where an image's votes fit a byte all the same (one level or two around 256 pixels), less is moved. A fraction above 1 is possible where the stage before left its table in a nearer cache.
""")
    drawn = {}
    for threads in sorted(set(run.limits["threads"])):
        _write_limits(report, threads)
        for width, height in dict.fromkeys(zip(run.work["width"], run.work["height"])):
            rows = measurements.roofline(run, width, height, threads)
            if rows.empty:
                continue
            title = f"{size_text(width, height)}, {threads} thread{'s' * (threads > 1)}"
            if threads == max(run.limits["threads"]):
                drawn[title] = rows
            _write_roofline(report, f"roofline-{width}x{height}-{threads}", title, rows)
    if drawn:
        plots.roofline(drawn, report.folder)
        report.plot("roofline", "Stages beside the limits")
    _write_pruned(report)


def _write_limits(report, threads):
    table = Table(f"limits-{threads}", f"Measured limits, {threads} thread{'s' * (threads > 1)}: "
                  "10^9 bytes (adds: of one byte) per second",
                  ["place", "read", "copy", "add two to a third"])
    limits = measurements.Limits(report.run.limits, threads)
    for place in dict.fromkeys(limits.table["place"]):
        if place == "registers":
            table.add("registers, adds", "-", "-", number(limits.rate(place, "adds") / 1e9, 0))
        else:
            table.add(place, *(number(limits.rate(place, what) / 1e9, 1)
                               for what in ("read", "copy", "add")))
    report.table(table)


def _write_roofline(report, name, title, rows):
    table = Table(name, title, ["stage", "ms", "MiB moved", "MiB touched", "10^6 adds", "limit",
                                "ms by the limit", "fraction"])
    for row in rows.to_dict("records"):
        if not isinstance(row.get("limit"), str):
            table.add(row["stage"], milliseconds(row["milliseconds"]), *["-"] * 6)
            continue
        table.add(row["stage"], number(row["milliseconds"], 3), number(row["moved"] / 2**20, 2),
                  number(row["touched"] / 2**20, 2), number(row["adds"] / 1e6, 2), row["limit"],
                  number(row["least"], 3), number(row["fraction"], 2))
    report.table(table)


def _write_pruned(report):
    """Where the time of the default goes, whose stages are others."""
    stages = report.run.stages[(report.run.stages["section"] == "stages")
                               & (report.run.stages["method"] == requirements.OURS)]
    sizes = list(dict.fromkeys(zip(stages["width"], stages["height"], stages["threads"])))
    columns = [f"{size_text(width, height)}, {threads}" for width, height, threads in sizes]
    table = Table("stages", "Stages of `detect` as it is by default: size and threads, milliseconds, "
                  "medians over the photographs", ["stage", *columns])
    values = stages.groupby(["stage", "width", "height", "threads"])["median"].median()
    for stage in stages_in_order(stages):
        table.add(stage, *(number(values.get((stage, *size), math.nan), 3) for size in sizes))
    report.table(table)


def stages_in_order(stages):
    """The names of the stages of images of any size: an image has more levels than another, and
    what follows the levels comes later there."""
    last = stages.groupby("stage")["order"].max()

    def place(stage):
        level = stage.startswith("level ")
        after = last[stage] if level or stage == "edge map" else last.max() + last[stage]
        return int(stage.split()[1]) + 1 if level else after

    return sorted(last.index, key=place)


def write_memory(report):
    memory = report.run.memory
    if memory is None:
        return
    report.text("## Memory\n\nRise of the peak of resident memory by the first `detect` of a process, one thread.\n")
    table = Table("memory", "Memory", ["image", "MiB", "bytes per pixel"])
    for row in memory.itertuples():
        table.add(f"{row.image}, {size_text(row.width, row.height)}", number(row.bytes / 2**20, 1),
                  number(row.bytes / (row.width * row.height), 1))
    report.table(table)
