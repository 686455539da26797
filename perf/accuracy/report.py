# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Writes the report of the evaluation from what linespace_accuracy wrote: tables as markdown and
CSV, plots as PNG and SVG. See ../accuracy.sh, which runs both."""

import argparse
import os
import pathlib
import shutil
import sys

import matplotlib.image
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "common"))
import geometry  # noqa: E402
import metrics  # noqa: E402
import photographs  # noqa: E402
import plots  # noqa: E402
import results  # noqa: E402
import synthetic  # noqa: E402

INTRODUCTION = """# Accuracy

How many of an image's lines the Line Space finds, how exactly, and what it reports besides, beside other detectors on the
same images. {machine}; {commit}.

Command: `{command}`. It writes this document, and into `build/accuracy/` every line that was found (CSV), the tables (CSV)
and the plots (PNG, SVG). The numbers are the same on every run of one commit with one version of OpenCV.

## What is compared

- **Line Space**: `cv::linespace::LineSpaceDetector`, `METHOD_CASCADED`, everything at its default but: *plain*: as it is;
  *explain*: `SELECT_EXPLAIN`; *oriented*: `SELECT_EXPLAIN` and the gradients. *unrefined*: oriented, `REFINE_NONE`; *exact*:
  oriented, `METHOD_EXACT`.
- **HoughLines**: `cv::HoughLines` at (1 pixel, 1 degree), (0.5 pixel, 0.25 degree) and (1 pixel, 1/(2n) radians), n the longer side of
  the image. *suppressed*: a line whose two ends in the image are both within 3 px of a stronger reported line is dropped, as
  the Line Space does it. The bias of rho by half a step of OpenCV before 4.13 (issue 25038) is taken out first.
- **FastHoughTransform**: `cv::ximgproc::FastHoughTransform`, the maxima of 5 x 5 cells, turned into lines by
  `HoughPoint2Line`, then suppressed the same way.
- **LSD**: `cv::createLineSegmentDetector`, its offset of 0.125 px in x and y put right; **FastLineDetector**: `cv::ximgproc::createFastLineDetector`, on the edge map. Both
  report segments: lines are fitted to them. The longest segment (at least 20 px) begins a line, all segments with both ends
  within 2 px of it join, the line is fitted to them by total least squares, weighted by length; strength is the summed length.

All take the same edge map of `cv::Canny` (aperture 3), the Line Space also the Sobel 3 x 3 gradients of the image that
Canny was given, LSD that image. *Strongest N*: the first N lines of each, above a vote threshold of a twentieth of the shorter side,
the same rule for all, low enough to play no part. Nothing is tuned to an image.

**Line error**: the largest orthogonal distance from the two ends of the true line's chord in the image to the detected line. True and
detected lines are matched one to one (Hungarian method), as many pairs below the tolerance as possible. Recall is the share of
the true lines that are found, precision that of the reported lines that found one; the median error is that of the lines
found within 3 px.
"""

CHESSBOARD = """## Chessboards

{count} photographs, lines known to about 0.13 px. Canny 50/150, no smoothing. Borders of the board and lines of the room are lines
too, and count against precision here. The board covers about half of a line's chord in the image; *on the board* measures the line error at the
first and last corner on the line instead of at the ends of its chord, where nothing of the board's line is seen.
"""

SUDOKU = """## Sudoku

{count} photographs from newspapers; the homography of the grid's corners gives its 20 lines; the error is measured at the ends of the line
inside the outline, the tolerance is 1 % of the shorter side. Gaussian 5 x 5 of sigma 1.2, then Canny. Median error and
lines per image are those of the first edge map.
"""

YORK = """## York

{count} photographs of YorkUrbanDB (Denis, Elder, Estrada, ECCV 2008), Canny 50/150, no smoothing. The true segments are 0.5 to 0.75 px
accurate and not all of the lines in the image, so that there is no precision; the error is measured at the segment's ends. Several
segments can lie on one line, which then finds them all.
"""

STEPS = """## Synthetic step edges

Eight half-planes on a background of 128, each 25 grey levels brighter or darker than what it covers, each line at least half the image's
side long inside the image and at least 6 px from every other at one end; edge profile an error function of sigma 0.5 px, white
Gaussian noise, then Gaussian 5 x 5 of sigma 1.2, Canny 30/80. {count} scenes each. *By their own rule*: the Line Space with
threshold 0 (the a-contrario rule), cv::HoughLines above 0.3 of the shorter side, LSD at its defaults.
"""

SCENES = """## Other scenes

As above with noise 8, 256 x 256 and eight lines where nothing else is said; as many strongest lines as there are true ones. Bars
have a contrast of 40 and a width of 3 px where nothing else is said; their centre line is the truth, what is found are their edges, so that
twice as many lines are asked for, within 3 px. *Dashed*: the share of each bar's dashes of 8 px that is drawn. *Edge pixels*: the edge map is
thinned out, or random pixels are added to it. *Pair*: two parallel lines; *crossing*: two lines that cross near the middle; what is nearer
than 3 px at both ends is one line to the suppression. {count} scenes each. s.: suppressed.
"""

ONE_EDGE = """## One edge and the Cramer-Rao bound

256 x 256, one step of 50 grey levels, blurred by sigma 1, Gaussian 5 x 5 of sigma 1.2, Canny 30/80; twelve angles, {count} positions and
noises each; c/n is contrast over noise. The strongest line is compared; further away than 3 px it is missed. The bound, for a
line of L pixels in white noise of sigma: position sigma / sqrt(L J), angle that times sqrt(12) / L, with J = c^2 / (2 sqrt(pi) s) for a
contrast c and a blur s. It is a bound for the image as it is, before any smoothing.
"""

NEGATIVES = """## Images without a line

{count} images of each kind: white noise of sigma 20; a ramp of grey levels; discs; 2 % of the pixels white. Gaussian 5 x 5 of sigma 1.2, Canny 30/80.
The Line Space with threshold 0. The others have no such rule: cv::HoughLines and FastHoughTransform report what is above 0.3 of the shorter
side (154 votes), LSD and FastLineDetector, at their defaults, every line fitted to a segment of at least 20 px.
"""

SCALES = """## Other sizes of the same photograph

Each photograph at half and double size, Canny 50/150, 25/75 at double size (interpolated grey levels change half as fast), no smoothing;
the Line Space with threshold 0, cv::HoughLines above 0.3 of the shorter side, LSD at its defaults. *Whole in half*: share of the lines of
the photograph that have a counterpart among those of the half. A larger image shows more pixels of a line, so that shorter lines become
significant: the lines of the smaller image should be among those of the larger one.
"""


class Report:
    def __init__(self, arguments):
        self.data = arguments.data
        self.folder = pathlib.Path(arguments.lines)
        self.parts, self.plots = [], []
        self.curves = {}

    def add(self, text, tables, count):
        self.parts.append(text.format(count=count))
        for table in tables:
            table.write_csv(self.folder)
            self.parts.append(table.markdown())

    def plot(self, name, caption):
        """A plot that also stands in the document."""
        self.plots.append(name)
        self.parts.append(f"![{caption}](figures/accuracy-{name}.png)\n\n*{caption}*\n")

    def read(self, section):
        groups = results.read(self.folder, section)
        if groups is None:
            self.parts.append(f"## Left out: {section}\n\nIts photographs are not in this "
                              "repository; `--data` or `LINESPACE_EVAL_DATA` names their folder.\n")
        return groups

    def picture(self, folder, groups, ends_of, count, tolerance_of):
        """The first photograph of a folder with its truth and what ours and a peer find."""
        edges, images = next(iter(groups.items()))
        name, image = next(iter(images.items()))
        photograph = _grey(pathlib.Path(self.data) / folder / name)
        _picture(photograph, ends_of(name, image), image, count, tolerance_of(image),
                 f"{name}, {edges}", self.folder, f"picture-{folder}")


def write_photographs(report):
    data = report.data
    groups = report.read("chessboard")
    if groups:
        tables, report.curves["Chessboards, 1 px"] = photographs.chessboards(groups, data)
        report.add(CHESSBOARD, tables, _count(groups))
        shown = ["Line Space oriented", "Line Space oriented unrefined", "LSD",
                 *(f"{name} suppressed" for name in photographs.HOUGH)]
        plots.error_histogram(photographs.chessboard_errors(groups, data, shown), report.folder)
        report.plot("error-histogram", "Errors of the lines found on the chessboards")
        report.picture("chessboard", groups, lambda name, image: results.chessboard_ends(
            data, name, image.size), 25, lambda image: 1)
    groups = report.read("sudoku")
    if groups:
        tables, curves = photographs.sudoku(groups, data)
        report.curves[f"Sudoku, {list(groups)[-1]}, 1 % of the side"] = curves
        report.add(SUDOKU, tables, _count(groups))
        report.picture("sudoku", groups, lambda name, image: results.sudoku_ends(data, name), 60,
                       photographs.sudoku_tolerance)
    groups = report.read("york")
    if groups:
        tables, report.curves["York, 2 px"] = photographs.york(groups, data)
        report.add(YORK, tables, _count(groups))
        report.picture("york", groups, lambda name, image: results.york_ends(data, name), 100,
                       lambda image: 2)
    if report.curves:
        plots.recall_over_lines(report.curves, report.folder)
        report.plot("recall-over-lines", "Recall over the number of lines")


def write_synthetic(report):
    groups = report.read("steps")
    report.add(STEPS, synthetic.steps(groups), _count(groups))
    image = groups["strongest|512|20"]["scene 0"]
    _picture(_grey(report.folder / "steps-20.png"), synthetic.truth_ends(image), image, 8, 3,
             "Noise 20", report.folder, "picture-steps")
    report.plot("picture-steps", "One of the scenes with noise 20")
    groups = report.read("scenes")
    report.add(SCENES, synthetic.scenes(groups), _count(groups))
    groups = report.read("one-edge")
    tables, every = synthetic.one_edge(groups)
    report.add(ONE_EDGE, tables, _count(groups))
    plots.error_over_noise(every, report.folder)
    report.plot("error-over-noise", "Error over noise, all angles, and the Cramer-Rao bound")
    groups = report.read("negatives")
    tables, every = synthetic.negatives(groups)
    report.add(NEGATIVES, tables, _count(groups))
    plots.false_lines(every, list(groups), report.folder)
    report.plot("false-lines", "Lines on images without any")


def write_scales(report):
    groups = report.read("scales")
    if groups:
        report.add(SCALES, photographs.scales(groups), _count(groups))


def _count(groups):
    """Images of the first group."""
    return len(next(iter(groups.values())))


def _grey(path):
    image = matplotlib.image.imread(path)
    if image.dtype.kind == "f":
        image = image * 255
    return image[..., :3] @ (0.299, 0.587, 0.114) if image.ndim == 3 else image


def _picture(photograph, truth, image, count, tolerance, title, folder, name):
    shown = {}
    for detector in ("Line Space oriented", "HoughLines 1 px 1 deg suppressed"):
        lines = image.lines[detector][:count, :2]
        lines = lines[[geometry.chord_ends(line, image.size) is not None for line in lines]]
        true, found = metrics.match(geometry.line_errors(truth, lines), tolerance)
        missed = np.delete(truth, true, axis=0)
        shown[detector] = (results.chord_ends_of(lines, image.size),
                           np.isin(np.arange(len(lines)), found), missed)
    plots.picture(photograph, truth, shown, image.size, title, folder, name)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--lines", required=True, help="folder that linespace_accuracy wrote to")
    parser.add_argument("--data", default=os.environ.get("LINESPACE_EVAL_DATA"),
                        help="folder with the ground truth of the photographs")
    parser.add_argument("--document", required=True, help="markdown file to write")
    parser.add_argument("--command", default="perf/accuracy.sh", help="as the document names it")
    arguments = parser.parse_args()
    report = Report(arguments)
    machine, commit = (report.folder / "origin.txt").read_text("utf-8").splitlines()
    report.parts.append(INTRODUCTION.format(machine=machine, commit=commit,
                                            command=arguments.command))
    write_photographs(report)
    write_synthetic(report)
    write_scales(report)
    document = pathlib.Path(arguments.document)
    figures = document.parent / "figures"
    figures.mkdir(parents=True, exist_ok=True)
    for name in report.plots:
        shutil.copyfile(report.folder / f"{name}.png", figures / f"accuracy-{name}.png")
    document.write_text("\n".join(report.parts), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
