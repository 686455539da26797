# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Every shader that the accuracy tests make the library compile, and those of the ways that are timed
beside it, if they were built, as Mesa writes them down (MESA_SHADER_CAPTURE_PATH), are valid for
glslangValidator, as GLSL 4.30 and as GLSL ES 3.10."""

import collections
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

FILTER = "*_Devices.*/1:*_OpenGl_Context.textures/*:*_Backends.medium_sizes/3"
ACCURACY = [os.environ["LINESPACE_ACCURACY"], "--gtest_color=no", "--gtest_filter=" + FILTER]
WAYS = os.environ.get("LINESPACE_OPENGL_WAYS")
# With windows, which small blocks make: the searches, and merges of the same depths.
SMALL_BLOCKS = {"LINESPACE_OPENGL_LIMITS": "262144"}

# What each program of src/glsl is known by, and how many variants there are at least.
PROGRAMS = {"Planes { uint planes": 3, "buffer Parent": 8, "Votes { uint votes": 4,
            "buffer State": 12, "highp usampler2D texels": 6, "writeonly buffer Bits": 1,
            "buffer Listed": 6, "buffer Candidates": 10}
if WAYS:
    PROGRAMS["buffer Parent"] += 3
    PROGRAMS.update({"partsS[ROOM]": 2, "struct Between": 1, "buffer Left": 6, "buffer List {": 3,
                     "buffer Counts": 3})


def sources(command, **variables):
    """Of all compute shaders of a run of a program."""
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, MESA_SHADER_CAPTURE_PATH=folder, **variables)
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        if "Tests on OpenGL are skipped" in done.stdout:
            return None
        if done.returncode != 0:
            raise RuntimeError(done.stdout[-2000:])
        return {re.search(r"(?s)\[compute shader\]\n(.*)", path.read_text()).group(1)
                for path in Path(folder).glob("*.shader_test")
                if "[compute shader]" in path.read_text()}


class Shaders(unittest.TestCase):
    captured = set()

    def check(self, version):
        shaders = sorted(source for source in self.captured if source.startswith(version))
        counts = collections.Counter(
            name for source in shaders for name in PROGRAMS if name in source)
        print(f"{version}: {len(shaders)} shaders")
        for name, least in PROGRAMS.items():
            self.assertGreaterEqual(counts[name], least, f"{name} in {counts}")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "shader.comp"
            for source in shaders:
                path.write_text(source)
                done = subprocess.run(["glslangValidator", "-S", "comp", str(path)],
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                      check=False)
                self.assertEqual(done.returncode, 0, done.stdout + source[:800])
                self.assertNotIn("WARNING", done.stdout)

    def test_glsl(self):
        self.check("#version 430 core")

    def test_glsl_es(self):
        self.check("#version 310 es")


if __name__ == "__main__":
    REQUIRED = os.environ.get("LINESPACE_REQUIRE_BACKENDS") == "1"
    if not shutil.which("glslangValidator"):
        print("SKIPPED: there is no glslangValidator")
        sys.exit(1 if REQUIRED else 77)
    ES = {"LINESPACE_OPENGL_API": "es"}
    RUNS = [(ACCURACY, {}), (ACCURACY, ES), (ACCURACY, SMALL_BLOCKS)]
    if WAYS:
        RUNS += [([WAYS, "--sides", "32", "--most", "1", "1500", "--turns", "0"], variables)
                 for variables in ({}, ES)]
    for program, settings in RUNS:
        found = sources(program, **settings)
        if found is None:
            print("SKIPPED: there is no OpenGL")
            sys.exit(1 if REQUIRED else 77)
        Shaders.captured |= found
    unittest.main()
