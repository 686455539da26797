# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Times cv2.HoughLines of whatever OpenCV its Python has: answers questions on standard input, one
line each, fields separated by tabs, until it ends.

version                                      version of cv2
HoughLines FILE THETA THRESHOLD THREADS      milliseconds, lines, 1
"""

import sys
import time

import cv2


def time_hough_lines(edges, theta, threshold):
    start = time.perf_counter()
    lines = cv2.HoughLines(edges, 1, theta, threshold)
    milliseconds = 1000 * (time.perf_counter() - start)
    # A line is two numbers, in whatever shape a version returns them; None is no line at all.
    return milliseconds, 0 if lines is None else lines.size // 2


def main():
    images = {}
    for question in sys.stdin:
        what, *arguments = question.rstrip("\n").split("\t")
        if what == "version":
            print(cv2.__version__, flush=True)
            continue
        name, theta, threshold, threads = arguments
        if name not in images:
            images = {name: cv2.imread(name, cv2.IMREAD_GRAYSCALE)}
        cv2.setNumThreads(int(threads))
        milliseconds, lines = time_hough_lines(images[name], float(theta), int(threshold))
        print(milliseconds, lines, 1, sep="\t", flush=True)


if __name__ == "__main__":
    main()
