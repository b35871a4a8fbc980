# SPDX-License-Identifier: Apache-2.0
"""Goals that were set before measuring, held against what was measured."""

import math
from dataclasses import dataclass

from harness import paper
from harness.cells import PEER, Cell
from harness.experiments import (
    IMPASSABLE,
    LONG_CHAIN,
    PARAMETERS,
    PEERS,
    REPAIR_KAPPAS,
    ROBOT,
    SCALED_SCENE,
    SCENES,
    scaled,
    with_setting,
)
from harness.statistics import Figure, succeeded

SPEED_UP = 20  # times, where passages are too narrow
PAIRS = (  # the paper's comparison: what ships with [18] as published; then with our pruning, and both without
    ("adaptive", "prior-unpruned"),
    ("adaptive", "prior"),
    ("adaptive-unpruned", "prior-unpruned"),
    ("adaptive", "rrt"),
)


@dataclass(frozen=True)
class Claim:
    text: str
    found: str
    holds: bool | None  # None: the bound that was measured does not decide it


def ratio(slow, fast):
    """How many times slower; a bound where the slow one is censored."""
    return Figure(slow.value / fast.value, slow.at_least)


def reaches(figure, least):
    """Whether it is that large; None where a bound leaves it open."""
    if figure.value >= least:
        return True
    return None if figure.at_least else False


def stays(figure, most):
    """Whether it is no more than that; None where a bound leaves it open."""
    if figure.value > most:
        return False
    return None if figure.at_least else True


def geometric_mean(figures):
    mean = math.exp(math.fsum(math.log(figure.value) for figure in figures) / len(figures))
    return Figure(mean, any(figure.at_least for figure in figures))


def best_peer(results, scene):
    """The fastest peer's cell in the median, of the censored the one that solved most; None without any."""
    measured = [
        (summary.median.at_least, summary.median.value, -summary.success, peer)
        for peer in PEERS
        if (summary := results.summary(Cell(scene, ROBOT, peer)))
    ]
    return Cell(scene, ROBOT, min(measured)[-1]) if measured else None


def _speed_up(results, ours, rival):
    fast, slow = results.summary(ours), results.summary(rival)
    if not fast or not slow:
        return []
    times = ratio(slow.median, fast.median)
    text = f"{ours.problem}: {ours.planner} {SPEED_UP} × faster than {rival.planner.removeprefix(PEER)} in the median"
    return [Claim(text, f"{times.shown()} ×", reaches(times, SPEED_UP))]


def _success(results, scene):
    ours = results.summary(Cell(scene, ROBOT, "adaptive"))
    if not ours:
        return []
    return [Claim(f"{scene}: every run solved", f"{ours.solved} of {ours.runs}", ours.solved == ours.runs)]


def _where_nothing_is_too_narrow(results, scene):
    ours, prior = (results.summary(Cell(scene, ROBOT, planner)) for planner in ("adaptive", "prior"))
    if not ours or not prior:
        return []
    found = []
    for name, ratio_ in (
        ("median", ratio(prior.median, ours.median)),
        ("90th percentile", ratio(prior.p90, ours.p90)),
    ):
        text = f"{scene}: not slower than prior in the {name}"
        found.append(Claim(text, f"{ratio_.shown()} × faster", reaches(ratio_, 1)))
    return found


def _growth(results):
    small, large = (results.summary(Cell(scaled(SCALED_SCENE, s), ROBOT, "adaptive")) for s in ("1", "4"))
    if not small or not large:
        return []
    here = ratio(large.mean, small.mean)
    there = paper.SCALE["adaptive"]["4"][0] / paper.SCALE["adaptive"]["1"][0]
    text = f"{SCALED_SCENE}, 4 times as large: the mean grows less than the paper's {there:.0f} ×"
    return [Claim(text, f"{here.shown()} ×", not here.at_least and here.value < there)]


def _same_at_any_scale(results, name, scenes):
    measured = [[results.summary(Cell(scaled(scene, s), ROBOT, "adaptive")) for s in ("1", "4")] for scene in scenes]
    if not all(small and large for small, large in measured):
        return []
    times = geometric_mean([ratio(large.median, small.median) for small, large in measured])
    text = f"{name}, 4 times as large: at most 1.5 × in the median"
    return [Claim(text, f"{times.shown()} ×", stays(times, 1.5))]


def _repairs_are_cheap(results):
    one, usual = (results.summary(with_setting("kappa", value)) for value in REPAIR_KAPPAS)
    if not one or not usual:
        return []
    times = ratio(one.median, usual.median)
    return [Claim("kappa 1: at most 1.1 × kappa 20 in the median", f"{times.shown()} ×", stays(times, 1.1))]


def _over_the_scenes(results):
    """Geometric means over all scenes."""
    ours = [results.summary(Cell(scene, ROBOT, "adaptive")) for scene in SCENES]
    if not all(ours):
        return []
    found = []

    def faster_than(name, cells, least):
        rivals = [results.summary(cell) for cell in cells if cell]
        if len(rivals) == len(ours) and all(rivals):
            mean = geometric_mean([ratio(rival.median, our.median) for rival, our in zip(rivals, ours)])
            text = f"all scenes: {least} × faster than {name} in the median"
            found.append(Claim(text, f"{mean.shown()} ×", reaches(mean, least)))

    def at_most(text, figures, most):
        mean = geometric_mean(figures)
        found.append(Claim(f"all scenes: {text} at most {most}", mean.shown(), stays(mean, most)))

    faster_than("plain", [Cell(scene, ROBOT, "plain") for scene in SCENES], 5)
    faster_than("the best peer of each", [best_peer(results, scene) for scene in SCENES], 60)
    at_most("90th percentile over median", [ratio(our.p90, our.median) for our in ours], 2.5)
    if all(our.solved for our in ours):
        at_most("median vertices", [Figure(our.medians["vertices"]) for our in ours], 2500)
    if all(scene in results.parts for scene in SCENES):
        at_most("everything over the floor", [Figure(results.parts[scene].all_over_floor) for scene in SCENES], 1.6)
    return found


def _long_chains(results, scene):
    summary = results.summary(Cell(scene, LONG_CHAIN, "adaptive"))
    if not summary:
        return []
    within = sum(succeeded(run, 1.0) for run in results.runs(Cell(scene, LONG_CHAIN, "adaptive")))
    text = f"{scene}, {LONG_CHAIN}: 95 % of the runs solved within 1 s"
    return [Claim(text, f"{within} of {summary.runs}", within >= 0.95 * summary.runs)]


def _flatness(results, name):
    """The paper's means differ by so much over a parameter's values; ours should not differ by more."""
    cells = [with_setting(name, value) for value in PARAMETERS[name]]
    means = [summary.mean for cell in cells if (summary := results.summary(cell))]
    if len(means) < len(cells):
        return []
    lowest, highest = (choose(means, key=lambda figure: figure.value) for choose in (min, max))
    here = ratio(highest, lowest)
    theirs = [mean for mean, _ in paper.PARAMETERS[name].values()]
    there = max(theirs) / min(theirs)
    first, *_, last = PARAMETERS[name]
    text = f"{name} from {first} to {last}: means differ by no more than the paper's {there:.2g} ×"
    return [Claim(text, f"{here.shown()} ×", not here.at_least and here.value <= there)]


def claims(results):
    """Those whose cells were measured."""
    found = []
    for scene in IMPASSABLE:
        for ours, rival in PAIRS:
            found += _speed_up(results, Cell(scene, ROBOT, ours), Cell(scene, ROBOT, rival))
        if peer := best_peer(results, scene):
            found += _speed_up(results, Cell(scene, ROBOT, "adaptive"), peer)
        found += _success(results, scene)
    for scene in SCENES:
        if scene not in IMPASSABLE:
            found += _success(results, scene) + _where_nothing_is_too_narrow(results, scene)
    for scene in SCENES:
        found += _long_chains(results, scene)
    found += _over_the_scenes(results)
    found += _growth(results) + _same_at_any_scale(results, SCALED_SCENE, [SCALED_SCENE])
    found += _same_at_any_scale(results, "all scenes", SCENES)
    for name in PARAMETERS:
        found += _flatness(results, name)
    return found + _repairs_are_cheap(results)
