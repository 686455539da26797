# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""What the device does, by its own account: PoCL tells of every command (POCL_TRACING) and of every
call (POCL_DEBUG). Kernels are compiled as OpenCL C 1.2, warnings are errors."""

import collections
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["LINESPACE_DEVICE_CALLS"]
PHOTOGRAPH = Path(os.environ["LINESPACE_SAMPLES_DATA"]) / "building.jpg"

CALLS = 2  # of the program, of which the second one is warm
CASCADE = ["gatherPixels", "firstCells"]
SEARCH = ["resetSearch", "searchMaxima", "chooseLeast", "countTiles", "scanTiles", "writeMaxima"]
PRUNED_LEVELS = 3
PRUNING = PRUNED_LEVELS * ["boundBlocks", "mergeBlocks"] + (PRUNED_LEVELS - 1) * ["requireBlocks"]
SAMPLE = ["resetSearch", "searchMaxima", "chooseLeast"]  # of the first image
PACKING = ["packColumns", "packRows"]
ROUND = ["wantNeighbours", "countWanted", "markCounted", "takeSteps"]
ASCENT = PACKING + ["clearMarks"] + 4 * ROUND + ["climbOn"]
# Blocking reads of a warm call. With `explained`, `greedy` and `blocks` the host has the edge map.
READS = {"compute": 0, "detect": 2, "estimated": 2, "oriented": 2, "recount": 2, "exact": 2,
         "explained": 2, "significant": 2, "significant-masked": 2, "significant-oriented": 2,
         "interval": 2, "greedy": 2, "blocks": 2, "sizes": 2, "houghlines": 2,
         "houghlines-dense": 2}
COUNTED_LINES = ["countPixels", "writePixels", "countVotes", "writeLines"] + 2 * ["scanCounts"]


class Account:
    """One run of the program."""

    def __init__(self, function, caches):
        with tempfile.TemporaryDirectory() as folder:
            trace = Path(folder) / "trace"
            environment = dict(os.environ, POCL_TRACING="text", POCL_TRACING_OPT=str(trace),
                               POCL_DEBUG="all", POCL_CACHE_DIR=str(Path(caches) / "pocl"),
                               OPENCV_OPENCL_CACHE_DIR=str(Path(caches) / "opencv"),
                               OPENCV_OPENCL_BUILD_EXTRA_OPTIONS="-cl-std=CL1.2 -Werror")
            for folder in ("pocl", "opencv"):
                (Path(caches) / folder).mkdir(exist_ok=True)
            done = subprocess.run([PROGRAM, function, str(PHOTOGRAPH)], env=environment,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                  errors="replace", check=False)
            self.out = done.stdout.strip()
            if done.returncode != 0:
                raise RuntimeError(f"{function}: status {done.returncode}: {done.stdout}")
            self.log = re.sub(r"\x1b\[[0-9;]*m", "", done.stderr)
            self.trace = trace.read_text()
        self.launches = collections.Counter(
            re.findall(r"ndrange_kernel \| complete \|.*name=(\w+)", self.trace))
        self.warm = re.search(r"(?s)warm call begins(.*)warm call ends", self.log).group(1)
        print(f"{function}: {self.out.splitlines()[0]}: " +
              ", ".join(f"{name} {count}" for name, count in sorted(self.launches.items())))

    def levels(self):
        return int(re.search(r"(\d+) levels", self.out).group(1))

    @staticmethod
    def builds(log):
        return log.count("building from sources")

    @staticmethod
    def blocking_reads(log):
        return len(re.findall(r"Created event \d+ \(\w+\) Command (?:read_buffer|map_buffer)", log))

    @staticmethod
    def largest_buffer(log):
        sizes = re.findall(r"Created Buffer .*SIZE (\d+)", log)
        return max(map(int, sizes), default=0)


class Launches(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.caches = tempfile.TemporaryDirectory()
        cls.accounts = {function: Account(function, cls.caches.name)
                        for function in READS}

    @classmethod
    def tearDownClass(cls):
        cls.caches.cleanup()

    def expect(self, function, kernels, merges=0, once=()):
        """Kernels of each call, with merges that many times mergeCells; and of the first call."""
        expected = collections.Counter(CALLS * kernels + CALLS * merges * ["mergeCells"] +
                                       list(once))
        found = {name: count for name, count in self.accounts[function].launches.items()
                 if name in expected}
        self.assertEqual(found, expected)

    def test_compute(self):
        merges = self.accounts["compute"].levels() - 1
        self.assertGreater(merges, 8)
        self.expect("compute", CASCADE + ["writeTable"], merges)

    def test_detect(self):
        def blocks(kernels):
            return ["searchBlocks" if kernel == "searchMaxima" else kernel for kernel in kernels]

        self.expect("detect", CASCADE + ["poolBlocks"] + PRUNING + blocks(SEARCH) + ASCENT,
                    self.accounts["detect"].levels() - 1 - PRUNED_LEVELS,
                    PRUNING + blocks(SAMPLE))

    def test_detect_with_gradients(self):
        self.expect("oriented", CASCADE + ["findDirections", "gatherDirections"] + ASCENT,
                    self.accounts["oriented"].levels() - 1 - PRUNED_LEVELS)

    def test_candidates_that_are_counted_again(self):
        self.expect("recount", CASCADE + SEARCH + PACKING + ["countCandidates"],
                    self.accounts["recount"].levels() - 1, SAMPLE)

    def test_the_exact_method(self):
        self.expect("exact", ["exactVotes", "resetSearch", "searchMaxima", "chooseLeast",
                              "countTiles", "scanTiles", "writeMaxima"] + PACKING)

    def test_the_drop_in(self):
        self.expect("houghlines", COUNTED_LINES)
        self.assertEqual(len(self.accounts["houghlines"].launches), len(set(COUNTED_LINES)))

    def test_the_drop_in_of_a_dense_map(self):
        self.expect("houghlines-dense", CASCADE + ["findSupported"] + COUNTED_LINES)
        merges = self.accounts["houghlines-dense"].launches["mergeCells"]
        self.assertGreater(merges, 8)
        self.assertEqual(merges % CALLS, 0)

    def test_a_warm_call_builds_and_allocates_nothing(self):
        first = self.accounts["compute"]
        self.assertGreater(first.builds(first.log), 0)
        for function, account in self.accounts.items():
            with self.subTest(function):
                self.assertGreater(account.largest_buffer(account.log), 10000)
                self.assertEqual(account.builds(account.warm), 0)
                self.assertLess(account.largest_buffer(account.warm), 10000)

    def test_a_warm_call_reads_twice_at_most(self):
        reads = {function: account.blocking_reads(account.warm)
                 for function, account in self.accounts.items()}
        print("blocking reads of a warm call:", reads)
        self.assertEqual(reads, READS)

    def test_the_second_start_builds_nothing(self):
        for function in ("compute", "detect"):
            account = Account(function, self.caches.name)
            self.assertEqual(account.builds(account.log), 0, function)


if __name__ == "__main__":
    probe = subprocess.run([PROGRAM, "compute", str(PHOTOGRAPH)], stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, text=True, check=False)
    if probe.returncode == 77 or not probe.stdout.startswith(("pthread", "basic", "cpu")):
        print("SKIPPED: OpenCV uses no PoCL device: " + probe.stdout.strip())
        sys.exit(1 if os.environ.get("LINESPACE_REQUIRE_BACKENDS") == "1" else 77)
    unittest.main()
