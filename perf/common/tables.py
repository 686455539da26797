# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Tables, as markdown for the document and as CSV files."""

import csv
import math


class Table:
    def __init__(self, name, title, columns):
        """name: of the CSV file; columns: the first one is text, the others are numbers."""
        self.name, self.title, self.columns, self.rows = name, title, columns, []

    def add(self, *cells):
        assert len(cells) == len(self.columns), (self.name, cells)
        self.rows.append([str(cell) for cell in cells])

    def markdown(self):
        lines = [f"**{self.title}**", "",
                 "| " + " | ".join(self.columns) + " |",
                 "| " + " | ".join(["---"] + ["---:"] * (len(self.columns) - 1)) + " |"]
        lines += ["| " + " | ".join(row) + " |" for row in self.rows]
        return "\n".join(lines) + "\n"

    def write_csv(self, folder):
        with open(folder / f"table-{self.name}.csv", "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.columns)
            writer.writerows(self.rows)


def number(value, digits):
    """A number with so many digits after the point; a dash for none."""
    return "-" if value is None or math.isnan(value) else f"{value:.{digits}f}"


def milliseconds(value):
    """Three digits, as times differ by a factor of ten thousand."""
    if value is None or math.isnan(value):
        return "-"
    return number(value, 0 if value >= 99.95 else 1 if value >= 9.995 else 2)
