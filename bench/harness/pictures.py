# SPDX-License-Identifier: Apache-2.0
"""The figures: bars on a logarithmic axis as in the paper's figure 4, growth curves, success over time."""

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "krait", "font.size": 8})
matplotlib.rcParams.update({"axes.spines.top": False, "axes.spines.right": False})

import matplotlib.pyplot as plt  # noqa: E402

from harness.cells import PEER, Cell
from harness.claims import best_peer
from harness.experiments import FOREIGN, LINKS, ROBOT, SCALED_SCENE, SCALES, SCENES, scaled
from harness.statistics import times

COLORS = {"adaptive": "#1b6ca8", "prior": "#e08e0b", "rrt": "#7a7a7a", "prior-unpruned": "#c44e52"}
PAPERS = {"paper": "#1b6ca8", "paper-prior": "#e08e0b", "paper-rrt": "#7a7a7a"}
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
    """As the paper's figure 4: mean with a standard deviation; a hatched bar is a bound below the mean."""
    planners = ("paper", "paper-prior")
    figure, axes = _panels(len(SCENES))
    for axis, scene in zip(axes, SCENES):
        for place, planner in enumerate(planners):
            cells = {i: Cell(scene, f"snake:{n}", planner) for i, n in enumerate(LINKS)}
            for i, summary in _measured(results, cells).items():
                axis.bar(i + 0.4 * (place - 0.5), summary.mean.value, 0.38, color=PAPERS[planner],
                         yerr=summary.deviation, capsize=1.5, error_kw={"lw": 0.7},
                         hatch="////" if summary.mean.at_least else None, edgecolor="white", lw=0.3)
        axis.set(yscale="log", title=scene, xlabel="links", xticks=range(len(LINKS)))
        axis.set_xticklabels(LINKS)
    axes[0].set_ylabel("seconds")
    handles = [plt.Rectangle((0, 0), 1, 1, color=PAPERS[planner]) for planner in planners]
    figure.legend(handles, planners, loc="lower center", ncol=len(planners), frameon=False)
    save(figure, path, below=0.07)


def _curve(axis, xs, summaries, label, color):
    medians = [summary.median.value for summary in summaries]
    axis.plot(xs, medians, marker="o", ms=3, label=label, color=color)
    axis.fill_between(xs, medians, [summary.p90.value for summary in summaries], color=color, alpha=0.15)


def links_growth(results, path):
    """Median and, shaded, up to the 90th percentile."""
    figure, axes = _panels(len(SCENES))
    for axis, scene in zip(axes, SCENES):
        for planner in ("adaptive", "prior"):
            found = _measured(results, {n: Cell(scene, f"snake:{n}", planner) for n in LINKS})
            if found:
                _curve(axis, list(found), list(found.values()), planner, COLORS[planner])
        axis.set(yscale="log", title=scene, xlabel="links")
    axes[0].set_ylabel("seconds, median to 90th percentile")
    _legend(axes[-1])
    save(figure, path)


def scale_growth(results, path):
    """krait's own, and under the paper's conditions."""
    figure, axes = _panels(2)
    ours = {planner: COLORS[planner] for planner in ("adaptive", "prior")}
    for axis, colors, title in zip(axes, (ours, PAPERS), ("", "the paper's conditions")):
        for planner, color in colors.items():
            found = _measured(results, {float(s): Cell(scaled(SCALED_SCENE, s), ROBOT, planner) for s in SCALES})
            if found:
                _curve(axis, list(found), list(found.values()), planner, color)
        axis.set(yscale="log", xlabel=f"scale of {SCALED_SCENE}", title=title)
        _legend(axis, fontsize=7, loc="center left")
    axes[0].set_ylabel("seconds")
    save(figure, path)


def ratios(results, path):
    """Times of the others over ours with their intervals: a row a problem, foreign ones first."""
    problems = [*FOREIGN, *((scene, ROBOT) for scene in SCENES)]
    figure, axis = plt.subplots(figsize=(8.5, 0.34 * len(problems) + 0.9))
    colors = {"prior": COLORS["prior"], "rrt": COLORS["rrt"], "the best of OMPL's": PEER_COLOR}
    for row, (problem, robot) in enumerate(reversed(problems)):
        ours = Cell(problem, robot, "adaptive")
        rivals = {planner: Cell(problem, robot, planner) for planner in ("prior", "rrt")}
        if robot == ROBOT and (peer := best_peer(results, problem)):
            rivals["the best of OMPL's"] = peer
        for place, (name, rival) in enumerate(rivals.items()):
            if found := results.ratio([(rival, ours)]):
                _ratio(axis, found, row + 0.2 * (1 - place), name, colors[name])
    axis.axvline(1, color="black", lw=0.6)
    axis.set(xscale="log", xlabel="times as long as krait", yticks=range(len(problems)))
    axis.set_yticklabels([f"{problem}, {robot}" for problem, robot in reversed(problems)])
    handles = [plt.Line2D([], [], color=color, marker="o", ms=4, lw=0) for color in colors.values()]
    axis.legend(handles, colors, frameon=False, fontsize=7, loc="center right")
    save(figure, path)


def _ratio(axis, found, y, name, color):
    """A dot with its interval; an arrow where it is a bound."""
    x = found.estimate.value
    high = found.high if found.high < float("inf") else x
    axis.plot([found.low, high], [y, y], color=color, lw=1)
    axis.plot([x], [y], color=color, marker=">" if found.estimate.at_least else "o", ms=4)


def _success_curve(axis, results, cell, label, color):
    figures = times(results.runs(cell), results.limit(cell), cell)
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
    ratios(results, folder / "ratios.svg")
    success_over_time(results, folder / "success.svg")
    links_bars(results, folder / "links.svg")
    links_growth(results, folder / "links-growth.svg")
    scale_growth(results, folder / "scale-growth.svg")
