# SPDX-License-Identifier: Apache-2.0
"""Statistics of runs. Runs without an accepted plan are censored: their time is at least the limit."""

import math
import random
import sys
from collections import Counter
from dataclasses import dataclass

TRIMMED = 12  # a twelfth of the runs is discarded at each end: the paper's 5 of 60
RESAMPLED = 1000  # times, for an interval
COVERED = 0.95  # of an interval
NOTHING = 1e-9  # a bound below it says nothing


@dataclass(frozen=True)
class Figure:
    """A number, or a bound below it."""

    value: float
    at_least: bool = False

    def shown(self, digits=3):
        return ("≥ " if self.at_least else "") + rounded(self.value, digits)


def rounded(value, digits=3):
    """To significant digits, without an exponent."""
    if value == 0:
        return "0"
    places = digits - 1 - math.floor(math.log10(abs(value)))
    return f"{round(value, places):.{max(places, 0)}f}"


def succeeded(run, limit, cell):
    """In time, with a plan that the verifier accepts; where the cell only checks states, that the planner accepts."""
    return run["status"] == "solved" and (run["verified"] or cell.checks_states) and run["time_s"] <= limit


def time_of(run, limit, cell):
    return Figure(run["time_s"]) if succeeded(run, limit, cell) else Figure(limit, True)


def in_order(figures):
    """The smallest first; bounds, of which nothing is known but that they are larger, come last."""
    return sorted(figures, key=lambda figure: (figure.at_least, figure.value))


def times(runs, limit, cell):
    """Seconds of each run, in order."""
    return in_order(time_of(run, limit, cell) for run in runs)


def trimmed(figures):
    """Without the best and worst twelfth."""
    cut = len(figures) // TRIMMED
    return figures[cut : len(figures) - cut]


def mean(figures):
    return Figure(math.fsum(f.value for f in figures) / len(figures), any(f.at_least for f in figures))


def deviation(figures):
    """The sample's standard deviation; None where it is not known: censored figures, or fewer than two."""
    if len(figures) < 2 or any(f.at_least for f in figures):
        return None
    center = mean(figures).value
    return math.sqrt(math.fsum((f.value - center) ** 2 for f in figures) / (len(figures) - 1))


def rank(share, count):
    """The place, from 0, of the smallest of `count` sorted values that is not below a share of them."""
    return max(math.ceil(share * count), 1) - 1


def quantile(figures, share):
    """Of sorted figures, by nearest rank."""
    return figures[rank(share, len(figures))]


def quantile_of(runs, name, share):
    """Of a statistic over the runs that have it; None where none has."""
    values = sorted(run[name] for run in runs if run.get(name) is not None)
    return quantile(values, share) if values else None


def geometric_mean(figures):
    """A bound where one of them is."""
    value = math.exp(math.fsum(math.log(figure.value) for figure in figures) / len(figures))
    return Figure(value, any(figure.at_least for figure in figures))


def ratio(slow, fast):
    """How many times slower: a bound where the slow one is; where the fast one is, nothing but that it is above 0."""
    return Figure(sys.float_info.min, True) if fast.at_least else Figure(slow.value / fast.value, slow.at_least)


def _end(value):
    return "0" if value < NOTHING else "∞" if math.isinf(value) else rounded(value, 2)


@dataclass(frozen=True)
class Interval:
    """An estimate, and the ends that it is between with a probability of COVERED."""

    estimate: Figure
    low: float
    high: float  # infinite where censored runs leave it without a bound

    def shown(self):
        if self.estimate.at_least and self.estimate.value < NOTHING:
            return "not known"
        return f"{self.estimate.shown()} [{_end(self.low)}, {_end(self.high)}]"

    def reaches(self, least):
        """Whether it is that large; None where the interval has it between its ends."""
        return True if self.low >= least else False if self.high < least else None

    def stays(self, most):
        return True if self.high <= most else False if self.low > most else None


def interval(samples, estimate):
    """Bootstrap by percentiles: each of the samples is drawn again, with replacement, and the figure formed of them."""
    dice = random.Random(1)
    drawn = [estimate([dice.choices(sample, k=len(sample)) for sample in samples]) for _ in range(RESAMPLED)]
    tail = (1 - COVERED) / 2
    low = sorted(figure.value for figure in drawn)[rank(tail, RESAMPLED)]
    high = sorted(math.inf if figure.at_least else figure.value for figure in drawn)[rank(1 - tail, RESAMPLED)]
    return Interval(estimate(samples), low, high)


@dataclass(frozen=True)
class Summary:
    """A cell in numbers. Times are seconds over all runs made; mean and deviation leave out the trimmed ones."""

    runs: int
    given_up: bool
    solved: int  # accepted within the limit
    verified: int  # of these, by the verifier
    refused: int  # queries whose start or goal is blocked
    limit: float
    mean: Figure
    deviation: float | None
    median: Figure
    p90: Figure
    p99: Figure
    medians: dict[str, float]  # over the solved runs, of MEDIANS
    vertices_p90: float | None
    statuses: dict[str, int]

    @property
    def success(self):
        return self.solved / self.runs


MEDIANS = ("vertices", "collision_checks", "plan_steps", "plan_duration_s", "plan_length_m")


def summarise(runs, limit, given_up, cell):
    """Of at least one run."""
    figures = times(runs, limit, cell)
    kept = trimmed(figures)
    solved = [run for run in runs if succeeded(run, limit, cell)]
    return Summary(
        runs=len(runs),
        given_up=given_up,
        solved=len(solved),
        verified=sum(bool(run["verified"]) for run in solved),
        refused=sum(run["status"] == "refused" for run in runs),
        limit=limit,
        mean=mean(kept),
        deviation=deviation(kept),
        median=quantile(figures, 0.5),
        p90=quantile(figures, 0.9),
        p99=quantile(figures, 0.99),
        medians={name: value for name in MEDIANS if (value := quantile_of(solved, name, 0.5)) is not None},
        vertices_p90=quantile_of(solved, "vertices", 0.9),
        statuses=dict(Counter(run["status"] for run in runs)),
    )
