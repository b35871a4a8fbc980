# SPDX-License-Identifier: Apache-2.0
"""Goals that were set before measuring, held against what was measured."""

from dataclasses import dataclass

from harness import paper
from harness.cells import FRESH, Cell
from harness.experiments import (
    FAR_ONES,
    FOREIGN,
    IMPASSABLE,
    LONG_CHAIN,
    PEERS,
    ROBOT,
    SCALED_SCENE,
    SCALES,
    SCENES,
    STREETS,
    scaled,
)
from harness.parts import all_over_floor
from harness.results import time, time_a_step, vertices
from harness.statistics import geometric_mean, in_order, interval, quantile, ratio, succeeded

RIVAL = 0.91  # never slower than 1.1 times the fastest of our own rivals
SECOND = 1.0


@dataclass(frozen=True)
class Claim:
    text: str
    found: str
    holds: bool | None  # None: the interval has the goal between its ends


def adaptive(scene, scale="1", robot=ROBOT):
    return Cell(scaled(scene, scale), robot, "adaptive")


def best_peer(results, scene):
    """The fastest peer's cell in the median, of the censored the one that solved most; None without any."""
    measured = [
        (summary.median.at_least, summary.median.value, -summary.success, peer)
        for peer in PEERS
        if (summary := results.summary(Cell(scene, ROBOT, peer)))
    ]
    return Cell(scene, ROBOT, min(measured)[-1]) if measured else None


def _at_most(text, found, most):
    return [Claim(f"{text}: at most {most:g}", found.shown(), found.stays(most))] if found else []


def _at_least(text, found, least):
    return [Claim(f"{text}: at least {least:g}", found.shown(), found.reaches(least))] if found else []


def _never_slower(results, ours, rival):
    text = f"{ours.problem}, {ours.robot}: time of `{rival.planner}` over ours"
    return _at_least(text, results.ratio([(rival, ours)]), RIVAL)


def _against_rivals(results):
    found = []
    for problem, robot in (*FOREIGN, *((scene, ROBOT) for scene in SCENES)):
        found += _never_slower(results, Cell(problem, robot, "adaptive"), Cell(problem, robot, "prior"))
    return found


def _far(results):
    found = []
    for problem, robot in FAR_ONES:
        found += _within_a_second(results, Cell(problem, robot, "adaptive"))
    return found


def _within_a_second(results, cell):
    runs = results.runs(cell)
    if not runs:
        return []
    within = sum(succeeded(run, SECOND, cell) for run in runs)
    text = f"{cell.problem}, {cell.robot}: every run within 1 s"
    return [Claim(text, f"{within} of {len(runs)}", within == len(runs))]


def _over_the_scenes(results):
    """Geometric means over all scenes."""
    ours = [adaptive(scene) for scene in SCENES]
    found = _at_most("all scenes: median vertices", results.mean_quantile(ours, 0.5, vertices), 600)
    found += _at_most("all scenes: 90th percentile of vertices", results.mean_quantile(ours, 0.9, vertices), 1000)
    peers = [best_peer(results, scene) for scene in SCENES]
    if all(peers):
        fresh = [Cell(scene, ROBOT, FRESH + "adaptive") for scene in SCENES]
        text = "all scenes: time of the best peer of each over ours"
        found += _at_least(text, results.ratio(list(zip(peers, ours))), 60)
        found += _at_least(f"{text} in a new process", results.ratio(list(zip(peers, fresh))), 60)
    large = [(adaptive(scene, SCALES[-1]), adaptive(scene)) for scene in SCENES]
    growth = results.ratio(large, value=time_a_step)
    found += _at_most("all scenes: time a plan's step at scale 4 over that at 1", growth, 1.5)
    found += _spread(results, ours)
    if all(scene in results.parts for scene in SCENES):
        over = all_over_floor([results.parts[scene] for scene in SCENES])
        found += _at_most("all scenes: everything over the floor", over, 1.6)
    return found


def _spread(results, cells):
    """90th percentile over median."""

    def spread(drawn):
        ordered = [in_order(figures) for figures in drawn]
        return geometric_mean([ratio(quantile(figures, 0.9), quantile(figures, 0.5)) for figures in ordered])

    samples = results.samples(cells, time)
    found = interval(samples, spread) if samples else None
    return _at_most("all scenes: 90th percentile of time over its median", found, 2.5)


def _solved(results):
    found = []
    for scene in (*SCENES, STREETS):
        for robot in (ROBOT, LONG_CHAIN):
            found += _within_a_second(results, Cell(scene, robot, "adaptive"))
    return found


def _papers(results):
    """The paper's comparison, under the paper's conditions."""
    found = []
    for scene in IMPASSABLE:
        cells = [(Cell(scene, ROBOT, "paper-prior"), Cell(scene, ROBOT, "paper"))]
        found += _at_least(f"{scene}, the paper's conditions: time of [18] over the method's", results.ratio(cells), 1)
    one = paper.SCALE["prior"]["1"][0] / paper.SCALE["adaptive"]["1"][0]
    cells = [(Cell(SCALED_SCENE, ROBOT, "paper-prior"), Cell(SCALED_SCENE, ROBOT, "paper"))]
    return found + _at_least(f"{SCALED_SCENE}: as many times as in the paper's table 1", results.ratio(cells), one)


GROUPS = {
    "Foreign problems and our scenes": _against_rivals,
    "Far goals": _far,
    "Over our scenes": _over_the_scenes,
    "Every run": _solved,
    "The paper's comparison": _papers,
}


def claims(results):
    """Those whose cells were measured, by group."""
    return {name: found for name, group in GROUPS.items() if (found := group(results))}

