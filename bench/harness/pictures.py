# SPDX-License-Identifier: Apache-2.0
"""The figures: bars on a logarithmic axis as in the paper's figure 4, growth curves, success over time."""

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "krait", "font.size": 8})
matplotlib.rcParams.update({"axes.spines.top": False, "axes.spines.right": False})

import matplotlib.pyplot as plt  # noqa: E402

from harness.cells import PEER, Cell
from harness.claims import best_peer
from harness.experiments import LINKS, RIVALS, ROBOT, SCALED_SCENE, SCALES, SCENES, scaled
from harness.statistics import times

COLORS = {"adaptive": "#1b6ca8", "prior": "#e08e0b", "rrt": "#7a7a7a", "prior-unpruned": "#c44e52"}
PEER_COLOR = "#2e8b57"


def save(figure, path, below=0.0):
    """`below`: the share of the height to leave free under the panels."""
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.tight_layout(rect=(0, below, 1, 1))
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def _panels(count):
    figure, axes = plt.subplots(1, count, figsize=(2.6 * count, 2.8), sharey=True, squeeze=False)
    return figure, axes[0]


def _legend(axis, **how):
    """Of what was drawn, if anything was."""
    if axis.get_legend_handles_labels()[1]:
        axis.legend(frameon=False, **how)


def _measured(results, cells):
    return {x: summary for x, cell in cells.items() if (summary := results.summary(cell))}


def links_bars(results, path):
    """Mean with a standard deviation; a hatched bar is a bound below the mean."""
    figure, axes = _panels(len(SCENES))
    for axis, scene in zip(axes, SCENES):
        for place, planner in enumerate(RIVALS):
            cells = {i: Cell(scene, f"snake:{n}", planner) for i, n in enumerate(LINKS)}
            for i, summary in _measured(results, cells).items():
                axis.bar(i + 0.27 * (place - 1), summary.mean.value, 0.25, color=COLORS[planner],
                         yerr=summary.deviation, capsize=1.5, error_kw={"lw": 0.7},
                         hatch="////" if summary.mean.at_least else None, edgecolor="white", lw=0.3)
        axis.set(yscale="log", title=scene, xlabel="links", xticks=range(len(LINKS)))
        axis.set_xticklabels(LINKS)
    axes[0].set_ylabel("seconds")
    handles = [plt.Rectangle((0, 0), 1, 1, color=COLORS[planner]) for planner in RIVALS]
    figure.legend(handles, RIVALS, loc="lower center", ncol=len(RIVALS), frameon=False)
    save(figure, path, below=0.07)


def _curve(axis, xs, summaries, label, color):
    medians = [summary.median.value for summary in summaries]
    axis.plot(xs, medians, marker="o", ms=3, label=label, color=color)
    axis.fill_between(xs, medians, [summary.p90.value for summary in summaries], color=color, alpha=0.15)


def links_growth(results, path):
    """Median and, shaded, up to the 90th percentile."""
    figure, axes = _panels(len(SCENES))
    for axis, scene in zip(axes, SCENES):
        for planner in RIVALS:
            found = _measured(results, {n: Cell(scene, f"snake:{n}", planner) for n in LINKS})
            if found:
                _curve(axis, list(found), list(found.values()), planner, COLORS[planner])
        axis.set(yscale="log", title=scene, xlabel="links")
    axes[0].set_ylabel("seconds, median to 90th percentile")
    _legend(axes[-1])
    save(figure, path)


def scale_growth(results, path):
    figure, axes = _panels(1)
    for planner in RIVALS:
        found = _measured(results, {float(s): Cell(scaled(SCALED_SCENE, s), ROBOT, planner) for s in SCALES})
        if found:
            _curve(axes[0], list(found), list(found.values()), planner, COLORS[planner])
    axes[0].set(yscale="log", xlabel=f"scale of {SCALED_SCENE}", ylabel="seconds")
    _legend(axes[0])
    save(figure, path)


def _success_curve(axis, results, cell, label, color):
    figures = times(results.runs(cell), results.limit(cell))
    solved = [figure.value for figure in figures if not figure.at_least]
    xs = [x for x in solved for _ in (0, 1)]
    ys = [100 * (i + after) / len(figures) for i in range(len(solved)) for after in (0, 1)]
    axis.plot([*xs, results.limit(cell)], [*ys, ys[-1] if ys else 0], label=label, color=color, lw=1.2)


def success_over_time(results, path):
    """Share of the runs that were solved within a time, with the best peer of each scene."""
    figure, axes = _panels(len(SCENES))
    for axis, scene in zip(axes, SCENES):
        for planner in COLORS:
            cell = Cell(scene, ROBOT, planner)
            if results.summary(cell):
                _success_curve(axis, results, cell, planner, COLORS[planner])
        if peer := best_peer(results, scene):
            _success_curve(axis, results, peer, peer.planner.removeprefix(PEER), PEER_COLOR)
        axis.set(xscale="log", title=scene, xlabel="seconds", ylim=(0, 103))
        _legend(axis, fontsize=6)
    axes[0].set_ylabel("% solved")
    save(figure, path)


def draw_all(results, folder):
    links_bars(results, folder / "links.svg")
    links_growth(results, folder / "links-growth.svg")
    scale_growth(results, folder / "scale-growth.svg")
    success_over_time(results.of_journal(), folder / "success.svg")
