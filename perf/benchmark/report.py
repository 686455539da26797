# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Writes the report of the benchmark from what linespace_benchmark wrote: tables as markdown and
CSV, plots as PNG and SVG. See ../run.sh, which runs both."""

import argparse
import datetime
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "common"))
import measurements  # noqa: E402
import sections  # noqa: E402

HEAD = """# Times beside other methods

| | |
| --- | --- |
| machine | {machine} |
| caches | {caches} |
| compiler, instruction set | {compiler}, {instruction_set} |
| other OpenCV | {newer_opencv} |
| OpenCL device | {opencl} |
| OpenGL | {opengl} |
| sources | {commit} |
| date | {date} |
| command | `{command}` |
| threads, where nothing else is said | {threads} |

Every method is called on the same edge maps (Canny 50/150 of OpenCV's sample photographs, scaled to the size), one after the other in
turn, at most {turns} times each, slow ones less often (n tells). The lines of every call of ours are compared with those by
`BACKEND_REFERENCE` in the same process; a time counts only if they are equal. The fastest cv::HoughLines is, on each input, that of
the OpenCV of this machine or of another one, whichever took least; its version follows the time.
"""


class Report:
    """The document and the files beside it."""

    def __init__(self, run, folder):
        self.run, self.folder = run, pathlib.Path(folder)
        self.parts = []

    def text(self, text):
        self.parts.append(text)

    def table(self, table):
        table.write_csv(self.folder)
        self.parts.append(table.markdown())

    def plot(self, name, caption):
        self.parts.append(f"![{caption}]({name}.png)\n")


def head(machine, command):
    caches = ", ".join(f"{name} {cache['bytes'] >> 10} KiB"
                       + (" shared" if cache["shared"] else " per core")
                       for name, cache in machine["caches"].items())
    date = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    values = dict(machine, caches=caches, date=date, command=command)
    for key in ("newer_opencv", "opencl", "opengl"):
        values[key] = values.get(key) or "none in this run"
    text = HEAD.format(**values)
    if machine["quick"]:
        text += ("\n**This is a quick run: it shows that everything works, its times mean "
                 "nothing.**\n")
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", required=True, help="folder that linespace_benchmark wrote to")
    parser.add_argument("--command", default="perf/run.sh", help="as the document names it")
    arguments = parser.parse_args()
    run = measurements.Run(arguments.results)
    report = Report(run, arguments.results)
    report.text(head(run.machine, arguments.command))
    for write in (sections.write_requirements, sections.write_photographs, sections.write_paper,
                  sections.write_opencl, sections.write_opengl,
                  sections.write_sizes, sections.write_densities, sections.write_threads,
                  sections.write_instruction_sets, sections.write_stages, sections.write_memory):
        write(report)
    (report.folder / "results.md").write_text("\n".join(report.parts), "utf-8")
    return 1 if len(run.invalid) else 0


if __name__ == "__main__":
    sys.exit(main())
