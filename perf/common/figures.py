# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""What the plots of all reports share: their look, and files that are the same on every run."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

plt.rcParams.update({"svg.hashsalt": "linespace", "font.size": 10, "axes.grid": True,
                     "grid.alpha": 0.3, "figure.facecolor": "white"})


def save(figure, folder, name, dpi=110):
    """As PNG and SVG, without dates; closes the figure."""
    figure.savefig(folder / f"{name}.png", dpi=dpi, bbox_inches="tight",
                   metadata={"Software": None})
    figure.savefig(folder / f"{name}.svg", bbox_inches="tight",
                   metadata={"Date": None, "Creator": None})
    plt.close(figure)


def legend_below(figure, *panels, columns=3):
    """One legend below all panels, of what the given ones show."""
    handles = {}
    for panel in panels:
        for handle, label in zip(*panel.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    figure.legend(handles.values(), handles.keys(), loc="upper center", bbox_to_anchor=(0.5, 0.0),
                  ncol=columns, frameon=False)
