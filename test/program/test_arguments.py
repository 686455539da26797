# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""What the program says about itself and about wrong arguments."""

import unittest

import pictures
from case import ProgramTest


class Help(ProgramTest):
    def test_help_names_every_option_and_gives_examples(self):
        out, err = self.run_program("--help")
        self.assertEqual(err, "")
        for word in ("--output", "--lines", "--show-linespace", "--compare", "--hough-step",
                     "--quiet", "--canny", "--blur", "--resize", "--edge-map", "--mask",
                     "--threshold", "--max-lines", "--angle-range", "--selection", "--oriented",
                     "--min-distance", "--method", "--cell-size",
                     "--backend", "--version", "Examples:", "Exit status:"):
            self.assertIn(word, out)
        self.assertLessEqual(max(map(len, out.splitlines())), 100)

    def test_version(self):
        out, _ = self.run_program("--version")
        self.assertRegex(out, r"^linespace \d+\.\d+\.\d+ \(OpenCV \d+\.\d+\.\d+\)\n$")


class WrongArguments(ProgramTest):
    def setUp(self):
        super().setUp()
        pictures.write_pgm(self.folder / "a.pgm", pictures.step(32, 24, 10))
        pictures.write_pgm(self.folder / "b.pgm", pictures.step(32, 24, 12))

    def test_no_input(self):
        self.refuse(naming=["INPUT"])

    def test_unknown_option(self):
        self.refuse("a.pgm", "--colour", naming=["--colour"])

    def test_values_out_of_range(self):
        for option, values, allowed in (
                ("--threshold", ["-1"], "from 0"),
                ("--threshold", ["many"], "from 0"),
                ("--threshold", ["1.5"], "a whole number"),
                ("--threshold", ["99999999999999999999"], "2147483647"),
                ("--max-lines", ["-3"], "from 0"),
                ("--cell-size", ["1"], "from 2 to 64"),
                ("--cell-size", ["65"], "from 2 to 64"),
                ("--angle-range", ["nan", "90"], "a number from"),
                ("--angle-range", ["0", "inf"], "a number from"),
                ("--angle-range", ["90", "10"], "larger"),
                ("--canny", ["-1", "50"], "from 0 to 10000"),
                ("--canny", ["nan", "50"], "from 0 to 10000"),
                ("--canny", ["90", "50"], "larger"),
                ("--blur", ["-0.1"], "from 0 to 100"),
                ("--blur", ["nan"], "from 0 to 100"),
                ("--blur", [""], "from 0 to 100"),
                ("--resize", ["0", "10"], "from 1 to 32767"),
                ("--resize", ["10", "40000"], "from 1 to 32767"),
                ("--hough-step", ["0"], "from 0.01 to 90"),
                ("--min-distance", ["-1"], "from 0 to 10000"),
                ("--selection", ["best"], "explain"),
                ("--method", ["fast"], "cascaded"),
                ("--backend", ["gpu"], "opencl"),
                ("--mask", ["none.png"], "none.png"),
        ):
            with self.subTest(option=option, values=values):
                wrong = values[0] if len(values) == 1 or allowed == "larger" else ""
                self.refuse("a.pgm", option, *values, naming=[option, wrong, allowed])

    def test_options_that_exclude_each_other(self):
        for option in (["--canny", "1", "2"], ["--blur", "2"], ["--resize", "9", "9"]):
            self.refuse("a.pgm", "--edge-map", *option, naming=["--edge-map", option[0]])
        self.refuse("a.pgm", "--compare", "--angle-range", "-10", "10", naming=["--angle-range"])

    def test_mask_that_is_no_image(self):
        (self.folder / "mask.png").write_text("not an image")
        self.refuse("a.pgm", "--mask", "mask.png", naming=["--mask", "mask.png"])

    def test_names_that_cannot_be_written(self):
        for option, name, word in (
                ("--output", "out.xyz", "out.xyz"),
                ("--output", "out.mp4", "cannot be made of the image"),
                ("--lines", "lines.txt", ".json"),
                ("--lines", "lines", ".json"),
                ("--show-linespace", "table.mp4", "table.mp4"),
                ("--output", "/proc/none/out.png", "/proc/none"),
        ):
            with self.subTest(option=option, name=name):
                self.refuse("a.pgm", option, name, naming=[option, word])
        self.assertEqual(self.files(), ["a.pgm", "b.pgm"])

    def test_names_that_several_inputs_share(self):
        for option, name in (("--output", "out.png"), ("--lines", "out.svg"),
                             ("--show-linespace", "out.png")):
            self.refuse("a.pgm", "b.pgm", option, name, naming=[option, name, "*"])
        self.refuse("a.pgm", "-o", "*.png", "--show-linespace", "*.png", naming=["a.png"])

    def test_inputs_are_never_overwritten(self):
        self.refuse("a.pgm", "-o", "a.pgm", naming=["a.pgm", "overwrite"])
        self.refuse("a.pgm", "b.pgm", "-o", "./*.pgm", naming=["a.pgm", "overwrite"])
        self.refuse("a.pgm", "--mask", "b.pgm", "-o", "../" + self.folder.name + "/b.pgm",
                    naming=["b.pgm", "overwrite"])

    def test_back_ends_that_are_not_there_say_so(self):
        # Which ones are there depends on the machine: a run either works or is refused by name.
        for backend in ("opencl", "opengl"):
            with self.subTest(backend=backend):
                try:
                    out, _ = self.run_program("a.pgm", "--backend", backend)
                    self.assertIn(f"({backend})", out)
                except AssertionError:
                    self.refuse("a.pgm", "--backend", backend, naming=["--backend", backend])


if __name__ == "__main__":
    unittest.main()
