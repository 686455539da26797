# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Folders, patterns, videos and files that cannot be read."""

import subprocess
import unittest

import pictures
from case import PROGRAM, ProgramTest


class ManyInputs(ProgramTest):
    def setUp(self):
        super().setUp()
        for name in ("shots/b.png", "shots/a.png", "shots/deep/c.png", "more/a.png"):
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            pictures.write_png(path, pictures.horizontal(pictures.black(48, 32), 12))
        (self.folder / "shots" / "notes.txt").write_text("no image")

    def inputs(self, *arguments, status=0):
        found = self.found(*arguments, "--edge-map", status=status)
        return [image["image"] for image in found["images"]]

    def test_a_folder_is_sorted_and_flat(self):
        self.assertEqual(self.inputs("shots"), ["shots/a.png", "shots/b.png"])

    def test_patterns(self):
        self.assertEqual(self.inputs("shots/*.png"), ["shots/a.png", "shots/b.png"])
        self.assertEqual(self.inputs("*/a.png"), ["more/a.png", "shots/a.png"])
        self.assertEqual(self.inputs("shots/[b-z].p?g"), ["shots/b.png"])

    def test_arguments_keep_their_order(self):
        self.assertEqual(self.inputs("shots/b.png", "more"), ["shots/b.png", "more/a.png"])

    def test_a_file_with_a_star_in_its_name(self):
        (self.folder / "more" / "a.png").rename(self.folder / "a*.png")
        self.assertEqual(self.inputs("a*.png"), ["a*.png"])

    def test_one_plain_line_for_each_input(self):
        out, err = self.run_program("shots", "--edge-map")
        self.assertEqual(err, "")
        self.assertEqual(len(out.splitlines()), 2)
        self.assertRegex(out, r"(?m)^shots/a\.png: 48 x 32, 48 edge pixels, 1 line in [\d.]+ ms \(")

    def test_one_input_gives_a_table(self):
        out, _ = self.run_program("shots/a.png", "--edge-map")
        self.assertRegex(out, r"(?m)^ +1 +48 +12\.00 +90\.000 +\(-0\.5, 12\.0\) +\(47\.5, 12\.0\)$")

    def test_quiet(self):
        self.assertEqual(self.run_program("shots", "--edge-map", "-q"), ("", ""))

    def test_names_in_a_folder(self):
        self.run_program("shots", "more", "--edge-map", "-q", "-o", "new/out", "--show-linespace",
                         "new/tables/")
        self.assertEqual(self.files("new/**/*"), [
            "new/out/a-2.lines.png", "new/out/a.lines.png", "new/out/b.lines.png",
            "new/tables/a-2.linespace.png", "new/tables/a.linespace.png",
            "new/tables/b.linespace.png"])

    def test_no_match_and_empty_folder(self):
        (self.folder / "empty").mkdir()
        out, err = self.run_program("*.tif", "empty", "more/a.png", "--edge-map", status=1)
        self.assertEqual(len(out.splitlines()), 1)
        self.assertEqual(err, "linespace: *.tif: no file matches this pattern\n"
                              "linespace: empty: no image in this folder\n")

    def test_output_that_cannot_be_written(self):
        (self.folder / "dangling.json").symlink_to("none/x.json")
        _, err = self.run_program("more/a.png", "--lines", "dangling.json", status=1)
        self.assertIn("dangling.json cannot be written", err)
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([PROGRAM, "more/a.png"], cwd=self.folder, stdout=full,
                                  stderr=subprocess.PIPE, timeout=300)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"standard output", done.stderr)


class BadFiles(ProgramTest):
    """One bad file is one line on the standard error output, and the rest goes on."""

    def setUp(self):
        super().setUp()
        pictures.write_png(self.folder / "good.png", pictures.step(200, 150, 70))
        self.run_program("good.png", "-q", "-o", "good.jpg")
        self.run_program("good.png", "-q", "-o", "good.bmp")
        self.run_program("good.png", "-q", "-o", "good.tif")

    def cut(self, source, target, share):
        data = (self.folder / source).read_bytes()
        (self.folder / target).write_bytes(data[:int(len(data) * share)])

    def assert_only_this_fails(self, bad, word):
        out, err = self.run_program("good.png", bad, "good.jpg", "--lines", "found.json", status=1)
        self.assertEqual([line.split(":")[0] for line in out.splitlines()],
                         ["good.png", "good.jpg"])
        self.assertEqual(err.count("\n"), 1, err)
        self.assertTrue(err.startswith(f"linespace: {bad}: "), err)
        self.assertIn(word, err)
        images = self.json("found.json")["images"]
        self.assertEqual([image["image"] for image in images], ["good.png", bad, "good.jpg"])
        self.assertIn(word, images[1]["error"])
        self.assertNotEqual(images[2]["lines"], [])

    def test_missing(self):
        self.assert_only_this_fails("none.png", "no such file")

    def test_empty(self):
        (self.folder / "empty.png").touch()
        self.assert_only_this_fails("empty.png", "empty")

    def test_no_image(self):
        (self.folder / "text.png").write_text("This is no image.")
        self.assert_only_this_fails("text.png", "not an image")

    def test_neither_image_nor_video(self):
        (self.folder / "text.avi").write_text("This is no video.")
        self.assert_only_this_fails("text.avi", "neither an image nor a video")

    def test_truncated_at_many_places(self):
        for name in ("good.png", "good.jpg", "good.bmp", "good.tif"):
            for share in (0.05, 0.3, 0.6, 0.9, 0.999):
                with self.subTest(name=name, share=share):
                    bad = "cut." + name.split(".")[1]
                    self.cut(name, bad, share)
                    self.assert_only_this_fails(bad, "truncated")

    def test_mask_of_another_size(self):
        pictures.write_pgm(self.folder / "mask.pgm", pictures.black(20, 10))
        _, err = self.run_program("good.png", "--mask", "mask.pgm", status=1)
        self.assertEqual(err, "linespace: good.png: its size 200 x 150 differs from the mask's "
                              "20 x 10\n")

    def test_table_too_large(self):
        # The lines of such an image are fine; its table of votes is beyond what compute allows.
        pictures.write_pgm(self.folder / "wide.pgm", pictures.vertical(pictures.black(12000, 64), 9))
        _, err = self.run_program("wide.pgm", "--edge-map", "--lines", "found.json",
                                  "--show-linespace", "table.png", status=1)
        self.assertEqual(err.count("\n"), 1, err)
        self.assertNotEqual(self.json("found.json")["images"][0]["lines"], [])
        self.assertNotIn("table.png", self.files())


class Videos(ProgramTest):
    FRAMES = 12

    def setUp(self):
        super().setUp()
        frames = [pictures.step(96, 64, 20 + 4 * i) for i in range(self.FRAMES)]
        pictures.write_y4m(self.folder / "move.y4m", frames)

    def frames_of(self, name, status=0):
        return [image for image in self.found(name, status=status)["images"] if "frame" in image]

    def test_lines_of_each_frame(self):
        frames = self.frames_of("move.y4m")
        self.assertEqual([frame["frame"] for frame in frames], list(range(self.FRAMES)))
        self.assertAlmostEqual(frames[5]["seconds"], 5 / 25, delta=1e-6)
        for i, frame in enumerate(frames):
            self.assertAlmostEqual(abs(frame["lines"][0]["rho"]), 19.5 + 4 * i, delta=1)

    def test_annotated_video(self):
        for name in ("out.mp4", "out.avi", "out.mkv"):
            with self.subTest(name=name):
                out, _ = self.run_program("move.y4m", "-o", name)
                self.assertRegex(out, r"^move\.y4m: 12 frames, \d+ lines, [\d.]+ ms a frame\n$")
                self.assertEqual(len(self.frames_of(name)), self.FRAMES)

    def test_annotated_video_in_a_folder(self):
        self.run_program("move.y4m", "-q", "-o", "out/")
        self.assertEqual(self.files("out/*"), ["out/move.lines.mp4"])

    def test_frames_as_images(self):
        self.run_program("move.y4m", "-q", "-o", "out/*.png", "--lines", "out/*.svg",
                         "--show-linespace", "out/table.png")
        names = [f"-{i:06d}" for i in range(self.FRAMES)]
        self.assertEqual(self.files("out/*.png"), [f"out/move{name}.png" for name in names]
                         + [f"out/table{name}.png" for name in names])
        self.assertEqual(self.files("out/*.svg"), [f"out/move{name}.svg" for name in names])

    def test_beside_an_image(self):
        pictures.write_png(self.folder / "still.png", pictures.step(96, 64, 40))
        found = self.found("still.png", "move.y4m", "-o", "out")
        self.assertEqual(len(found["images"]), 1 + self.FRAMES)
        self.assertEqual(self.files("out/*"), ["out/move.lines.mp4", "out/still.lines.png"])

    def test_truncated_video_keeps_what_was_read(self):
        self.run_program("move.y4m", "-q", "-o", "whole.avi")
        data = (self.folder / "whole.avi").read_bytes()
        (self.folder / "cut.avi").write_bytes(data[:len(data) * 6 // 10])
        _, err = self.run_program("cut.avi", "--lines", "found.json", status=1)
        self.assertEqual(err.count("\n"), 1, err)
        self.assertIn("truncated", err)
        images = self.json("found.json")["images"]
        self.assertGreater(len(images), 3)
        self.assertIn("truncated", images[-1]["error"])


if __name__ == "__main__":
    unittest.main()
