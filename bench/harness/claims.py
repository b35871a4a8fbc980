"""What was promised, held against what was measured."""

from dataclasses import dataclass

from harness import paper
from harness.cells import PEER, Cell
from harness.experiments import (
    IMPASSABLE,
    PARAMETERS,
    PEERS,
    ROBOT,
    SCALED_SCENE,
    SCENES,
    scaled,
    with_setting,
)
from harness.statistics import Figure

SPEED_UP = 20  # times, where passages are too narrow


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
    times = ratio(prior.median, ours.median)
    return [Claim(f"{scene}: not slower than prior", f"{times.shown()} × faster", reaches(times, 1))]


def _growth(results):
    small, large = (results.summary(Cell(scaled(SCALED_SCENE, s), ROBOT, "adaptive")) for s in ("1", "4"))
    if not small or not large:
        return []
    here = ratio(large.mean, small.mean)
    there = paper.SCALE["adaptive"]["4"][0] / paper.SCALE["adaptive"]["1"][0]
    text = f"{SCALED_SCENE}, 4 times as large: the mean grows less than the paper's {there:.0f} ×"
    return [Claim(text, f"{here.shown()} ×", not here.at_least and here.value < there)]


def _flatness(results, name):
    """The paper's means differ by so much over a parameter's values; ours should not differ by more."""
    cells = [with_setting(name, value) for value in PARAMETERS[name]]
    means = [summary.mean for cell in cells if (summary := results.summary(cell))]
    if len(means) < len(cells):
        return []
    lowest, highest = (choose(means, key=lambda figure: figure.value) for choose in (min, max))
    here = ratio(highest, lowest)
    theirs = [value for value, _ in paper.PARAMETERS[name]]
    there = max(theirs) / min(theirs)
    first, *_, last = PARAMETERS[name]
    text = f"{name} from {first} to {last}: means differ by no more than the paper's {there:.2g} ×"
    return [Claim(text, f"{here.shown()} ×", not here.at_least and here.value <= there)]


def claims(results):
    """Those whose cells were measured."""
    found = []
    for scene in IMPASSABLE:
        for ours, rival in (("adaptive", "prior"), ("adaptive-unpruned", "prior-unpruned"), ("adaptive", "rrt")):
            found += _speed_up(results, Cell(scene, ROBOT, ours), Cell(scene, ROBOT, rival))
        if peer := best_peer(results, scene):
            found += _speed_up(results, Cell(scene, ROBOT, "adaptive"), peer)
        found += _success(results, scene)
    for scene in SCENES:
        if scene not in IMPASSABLE:
            found += _success(results, scene) + _where_nothing_is_too_narrow(results, scene)
    found += _growth(results)
    for name in PARAMETERS:
        found += _flatness(results, name)
    return found
