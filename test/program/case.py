# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""The base of the tests of the program: it runs it as a process, in a folder of its own."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["LINESPACE_PROGRAM"]


class ProgramTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *arguments, status=0, **options):
        """Runs the program in the test's folder; returns (stdout, stderr)."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, timeout=300,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, errors="replace", **options)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done.stdout, done.stderr

    def refuse(self, *arguments, naming=()):
        """The program must end with status 2 and one line that names what is wrong."""
        out, err = self.run_program(*arguments, status=2)
        self.assertEqual(out, "")
        self.assertEqual(err.count("\n"), 1, err)
        for word in naming:
            self.assertIn(str(word), err)

    def found(self, *arguments, status=0):
        """Runs with --lines and returns what stands in the JSON file."""
        self.run_program(*arguments, "--lines", "found.json", "-q", status=status)
        return self.json("found.json")

    def lines(self, *arguments):
        return self.found(*arguments)["images"][0]["lines"]

    def json(self, name):
        return json.loads((self.folder / name).read_text("utf-8"))

    def files(self, pattern="**/*"):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.glob(pattern)
                      if path.is_file())
