# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""The bar with rate and time left, on a pseudo-terminal."""

import fcntl
import os
import pty
import struct
import subprocess
import sys
import termios
import unittest

import pictures
from case import PROGRAM, ProgramTest


class Terminal(ProgramTest):
    COUNT = 30

    def setUp(self):
        super().setUp()
        (self.folder / "in").mkdir()
        for i in range(self.COUNT):
            pictures.write_pgm(self.folder / "in" / f"{i:02d}.pgm", pictures.step(320, 240, 9 * i + 9))

    def on_terminal(self, *arguments, columns=100, term="xterm", status=0):
        """What the program writes on a terminal of this width."""
        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        program = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=slave, stderr=slave, env=dict(os.environ, TERM=term))
        os.close(slave)
        text = b""
        while True:
            try:
                part = os.read(master, 4096)
            except OSError:  # Linux's way to say that the other end is closed
                break
            if not part:
                break
            text += part
        os.close(master)
        self.assertEqual(program.wait(60), status)
        return text.decode()

    def states(self, text):
        """The successive contents of the bar's line."""
        return [state.split("\r")[0] for state in text.split("\r\x1b[K") if state]

    def test_bar_with_rate_and_time_left(self):
        # The bar is drawn ten times a second: pictures that take much longer on any machine.
        for i in range(self.COUNT):
            picture = pictures.step(1600, 1200, 45 * i + 45)
            pictures.write_pgm(self.folder / "in" / f"{i:02d}.pgm", picture)
        text = self.on_terminal("in")
        states = self.states(text)
        self.assertGreaterEqual(len(states), 2)
        self.assertRegex(states[0], r"^  0% \[>? +\] 0/30  in/00\.pgm$")
        self.assertRegex(states[-1], r"^ *\d+% \[=*>? *\] \d+/30  [\d.]+/s  \d:\d\d left  in/\d\d\.pgm$")
        self.assertTrue(text.endswith("\r\x1b[K"), "the bar is removed at the end")
        self.assertNotIn("edge pixels", text)

    def test_it_never_wraps(self):
        for columns in (100, 60, 30, 10):
            for state in self.states(self.on_terminal("in", columns=columns)):
                self.assertLess(len(state), columns)

    def test_errors_stand_on_lines_of_their_own(self):
        (self.folder / "in" / "15.pgm").write_text("P5 broken")
        text = self.on_terminal("in", status=1)
        self.assertRegex(text, r"\r\x1b\[Klinespace: in/15\.pgm: [^\r\n\x1b]+\r\n")

    def test_no_bar_when_quiet_or_dumb(self):
        self.assertEqual(self.on_terminal("in", "-q"), "")
        text = self.on_terminal("in", term="dumb")
        self.assertNotIn("\x1b", text)
        self.assertEqual(text.count("edge pixels"), self.COUNT)

    def test_one_video_counts_frames(self):
        frames = [pictures.step(320, 240, 20 + 4 * i) for i in range(40)]
        pictures.write_y4m(self.folder / "move.y4m", frames)
        text = self.on_terminal("move.y4m")
        self.assertRegex(text, r"\d+/40  [\d.]+/s  \d:\d\d left  move\.y4m")
        self.assertIn("move.y4m: 40 frames", text)


if __name__ == "__main__":
    try:
        for end in pty.openpty():
            os.close(end)
    except OSError as error:
        print("skipped: no pseudo-terminal here:", error)
        sys.exit(77)  # what CMakeLists.txt tells ctest to take for a skipped test
    unittest.main()
