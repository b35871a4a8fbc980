# SPDX-License-Identifier: Apache-2.0
"""The table of scenes in README.md."""

from harness.cells import Cell
from harness.experiments import ROBOT, SCENES
from harness.results import write
from harness.statistics import quantile, succeeded

BEGIN, END = "<!-- scenes -->", "<!-- end of scenes -->"
HEADER = (
    "| scene | solved | verified | time, median | 90th percentile | vertices, median |\n|---|---|---|---|---|---|\n"
)


def cells():
    return [Cell(scene, ROBOT, "adaptive") for scene in SCENES]


def missing(results):
    """The scenes without a solved run, of which the table has no row."""
    return [cell.problem for cell in cells() if all(run["status"] != "solved" for run in results.runs(cell))]


def _row(results, cell):
    runs = results.runs(cell)
    solved = [run for run in runs if run["status"] == "solved"]
    verified = [run for run in solved if succeeded(run, run["limit_s"], cell)]
    summary = results.summary(cell)
    vertices = sorted(run["vertices"] for run in runs)
    figures = [
        cell.problem,
        str(len(solved)),
        str(len(verified)),
        f"{1e3 * summary.median.value:.1f} ms",
        f"{1e3 * summary.p90.value:.1f} ms",
        str(quantile(vertices, 0.5)),
    ]
    return "| " + " | ".join(figures) + " |\n"


def table(results):
    seeds = len(results.runs(cells()[0]))
    return f"{ROBOT}, {seeds} seeds\n\n" + HEADER + "".join(_row(results, cell) for cell in cells())


def write_table(results, path):
    """Puts the table between the two marks of the page."""
    text = path.read_text()
    head, rest = text.split(BEGIN + "\n")
    _, tail = rest.split(END)
    write(path, head + BEGIN + "\n" + table(results) + END + tail)
