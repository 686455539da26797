# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""What OpenGL does, by the account of the driver: Mesa's llvmpipe writes down every call of its own
interface (GALLIUM_TRACE). What a warm call does is the difference between runs of three and of two
calls."""

import collections
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["LINESPACE_GL_CALLS"]
PHOTOGRAPH = Path(os.environ["LINESPACE_SAMPLES_DATA"]) / "building.jpg"
FUNCTIONS = ("compute", "detect", "recount", "exact", "oriented", "weighted", "houghlines",
             "texture", "significant")
PIXELS = 640 * 480

# Mesa 22.3 crashes while it writes down if a context is asked whether it was lost, which these are not.
OF_OLD = {"MESA_GL_VERSION_OVERRIDE": "4.3", "MESA_GLES_VERSION_OVERRIDE": "3.1"}

SEARCH = 10      # launches: reset, three searches, two cuts, choose, count, scan, write
SHORT_SEARCH = 6  # of a table so small that no sample is taken
BITS = 1         # a launch packs the pixels
ASCENT = 19      # launches: clear, four rounds of list, count, step, six of those left


def launches_of_merge(width, height, horizontal):
    """A launch for all rectangles of chords of one shape that cross, or do not: sides of either
    child along the border of the two, in its order, and which side of the whole they are on."""
    parts = ([(width, 0, "T"), (width, 1, "T"), (height, 1, "R"), (width, 1, "B"), (width, 0, "B"),
              (height, 0, "L")] if horizontal else
             [(width, 0, "T"), (height, 0, "R"), (height, 1, "R"), (width, 1, "B"), (height, 1, "L"),
              (height, 0, "L")])
    pairs = [(s, e) for i, s in enumerate(parts) for e in parts[i + 1:] if s[2] != e[2]]
    assert len(pairs) == 13
    return len({(s[1] != e[1], s[0], e[0]) for s, e in pairs})


def launches_of_merges(cell, grid):
    """Of all levels: alternately along and down, while both axes have pairs."""
    (width, height), (columns, rows) = cell, grid
    count, horizontal = 0, False
    while columns * rows > 1:
        horizontal = columns > 1 and (rows == 1 or not horizontal)
        count += launches_of_merge(width, height, horizontal)
        if horizontal:
            width, columns = 2 * width, columns // 2
        else:
            height, rows = 2 * height, rows // 2
    return count


MERGES = launches_of_merges((10, 15), (64, 32))  # of 640 x 480


def run(function, calls, *more, **variables):
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("LINESPACE_OPENGL", "GALLIUM"))}
    environment.update(variables)
    return subprocess.run([PROGRAM, function, str(PHOTOGRAPH), str(calls), *more], env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False,
                          timeout=600)


class Account:
    """One run of the program."""

    def __init__(self, function, calls, **variables):
        with tempfile.TemporaryDirectory() as folder:
            trace = Path(folder) / "trace.xml"
            done = run(function, calls, GALLIUM_TRACE=str(trace), **OF_OLD, **variables)
            if done.returncode != 0:
                raise RuntimeError(f"{function}: status {done.returncode}: {done.stdout}")
            self.levels = int(re.search(r"(\d+) levels", done.stdout).group(1))
            text = trace.read_text(errors="replace")
            self.calls = collections.Counter(re.findall(r"method='(\w+)'", text))
            # Bytes of each.
            self.reads = [int(re.search(r"name='width'><int>(\d+)", read).group(1)) for read in
                          re.findall(r"(?s)method='buffer_map'>(.*?)</call>", text)]


class Launches(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.accounts, cls.reads = {}, {}
        for function in FUNCTIONS:
            two, three = Account(function, 2), Account(function, 3)
            warm = three.calls - two.calls
            warm_reads = three.reads[len(two.reads):]
            cls.accounts[function] = (two, warm)
            cls.reads[function] = warm_reads
            print(f"{function}: warm call: {warm['launch_grid']} launches, "
                  f"{warm['create_compute_state']} shaders, {warm['resource_create']} buffers, "
                  f"{warm['fence_finish']} fences, reads of {warm_reads} bytes")

    def launches(self, function):
        two, warm = self.accounts[function]
        self.assertEqual(two.calls["launch_grid"], 2 * warm["launch_grid"], function)
        return warm["launch_grid"], two.levels - 1

    def test_compute(self):
        launches, merges = self.launches("compute")
        self.assertEqual(merges, 11)
        self.assertEqual(launches, 2 + MERGES)

    def test_detect(self):
        for function in ("detect", "weighted"):
            self.assertEqual(self.launches(function)[0], 2 + MERGES + SEARCH + BITS + ASCENT,
                             function)

    def test_directions_have_planes_of_their_own(self):
        self.assertEqual(self.launches("oriented")[0], 3 + MERGES + SEARCH + ASCENT)

    def test_candidates_that_are_counted_where_they_are(self):
        self.assertEqual(self.launches("recount")[0], 2 + MERGES + SEARCH + BITS + 1)

    def test_the_exact_method(self):
        self.assertEqual(self.launches("exact")[0], 1 + SHORT_SEARCH + BITS)

    def test_the_drop_in(self):
        # Of 400 x 300: cells of 25 x 19 or the like.
        self.assertGreater(self.launches("houghlines")[0], 2 + 2 * 8)

    def test_a_warm_call_compiles_and_allocates_nothing(self):
        for function in FUNCTIONS:
            with self.subTest(function):
                two, warm = self.accounts[function]
                self.assertGreater(two.calls["create_compute_state"], 1)
                self.assertEqual(warm["create_compute_state"], 0)
                self.assertGreater(two.calls["resource_create"], 2)
                self.assertEqual(warm["resource_create"], 0)
                self.assertEqual(warm["context_create"], 0)

    def test_a_warm_call_waits_once(self):
        for function in FUNCTIONS:
            with self.subTest(function):
                # The statistical rule needs to know how many pixels vote.
                self.assertEqual(self.accounts[function][1]["fence_finish"],
                                 2 if function == "significant" else 1)

    def test_a_warm_detect_reads_candidates_and_bits(self):
        # How many candidates there are, those, and the pixels as bits, but of a map with directions,
        # which the host has.
        for function in ("detect", "recount", "exact", "weighted"):
            self.assertEqual(len(self.reads[function]), 3, function)
        self.assertEqual(len(self.reads["oriented"]), 2)

    def test_the_pixels_of_a_texture_stay_where_they_are(self):
        for function in ("texture", "significant"):
            self.assertEqual(self.launches(function)[0],
                             1 + 2 + MERGES + SEARCH + BITS + ASCENT)
            # Small ones are numbers, and what the library has put into the context, by which it
            # knows it again.
            reads = [read for read in self.reads[function] if read > 100]
            self.assertEqual(len(reads), 2, function)
            self.assertLess(max(reads), PIXELS / 3)

    def test_opengl_es_launches_the_same(self):
        es = Account("detect", 2, LINESPACE_OPENGL_API="es")
        self.assertEqual(es.calls["launch_grid"],
                         self.accounts["detect"][0].calls["launch_grid"])


@unittest.skipUnless("LINESPACE_LOST_CONTEXT" in os.environ, "no library of EGL to build with")
class LostContext(unittest.TestCase):
    """A reset loses the context in the second of three calls, which says so; the third one, of the
    same detector or without one, has another context."""

    def test_a_lost_context(self):
        for function in ("detect", "houghlines"):
            for by in ("error", "status"):
                with self.subTest(f"{function}, {by}"):
                    done = run(function, 3, "1", LINESPACE_LOST_BY=by, LINESPACE_LOST_LAUNCH="120",
                               LINESPACE_EGL_LIBRARY=os.environ["LINESPACE_LOST_CONTEXT"])
                    print(done.stdout.strip())
                    self.assertEqual(done.returncode, 0, done.stdout)
                    self.assertRegex(done.stdout, "BACKEND_OPENGL: the context is lost")


class WithoutOpenGl(unittest.TestCase):
    LIBRARY = "libEGL-that-is-not-there.so.1"

    def test_a_named_back_end_says_what_is_missing(self):
        done = run("detect", 1, LINESPACE_EGL_LIBRARY=self.LIBRARY)
        print(done.stdout.strip())
        self.assertEqual(done.returncode, 77, done.stdout)
        self.assertIn("BACKEND_OPENGL", done.stdout)
        self.assertIn(self.LIBRARY, done.stdout)

    def test_the_default_back_end_gives_way(self):
        done = run("houghlines", 1, LINESPACE_EGL_LIBRARY=self.LIBRARY)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(done.stdout, run("houghlines", 1).stdout)

    def test_the_library_needs_no_opengl(self):
        """The library itself: OpenCV's may."""
        maps = subprocess.run(["ldd", PROGRAM], stdout=subprocess.PIPE, text=True, check=True).stdout
        library = re.search(r"libopencv_linespace\.so\S* => (\S+)", maps).group(1)
        needed = subprocess.run(["readelf", "-d", library], stdout=subprocess.PIPE, text=True,
                                check=True).stdout
        print(re.findall(r"NEEDED.*\[(.*)\]", needed))
        self.assertNotRegex(needed, r"NEEDED.*\[lib(E?GL|GLES|epoxy|OpenGL)")


if __name__ == "__main__":
    probe = run("compute", 1)
    if probe.returncode == 77:
        print("SKIPPED: " + probe.stdout.strip())
        sys.exit(1 if os.environ.get("LINESPACE_REQUIRE_BACKENDS") == "1" else 77)
    unittest.main()
