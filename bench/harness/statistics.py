# SPDX-License-Identifier: Apache-2.0
"""What the runs of a cell amount to. Runs without a verified plan are censored: their time is at least the limit."""

import math
from collections import Counter
from dataclasses import dataclass

TRIMMED = 12  # a twelfth of the runs is discarded at each end: the paper's 5 of 60


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


def succeeded(run, limit):
    return run["status"] == "solved" and run["verified"] and run["time_s"] <= limit


def times(runs, limit):
    """Seconds of each run as figures, the shortest first; censored ones come last."""
    figures = [Figure(run["time_s"]) if succeeded(run, limit) else Figure(limit, True) for run in runs]
    return sorted(figures, key=lambda figure: (figure.at_least, figure.value))


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


def quantile(figures, share):
    """The smallest of the sorted figures that is not below a share of them (nearest rank)."""
    return figures[max(math.ceil(share * len(figures)), 1) - 1]


def median_of(runs, name):
    """Median of a statistic over the runs that have it; None where none has."""
    values = sorted(run[name] for run in runs if run.get(name) is not None)
    return values[math.ceil(len(values) / 2) - 1] if values else None


@dataclass(frozen=True)
class Summary:
    """A cell in numbers. Times are seconds over all runs made; mean and deviation leave out the trimmed ones."""

    runs: int
    asked: int  # fewer were made where the cell was given up or is not finished
    given_up: bool
    solved: int  # with a verified plan within the limit
    unverified: int
    limit: float
    mean: Figure
    deviation: float | None
    median: Figure
    p90: Figure
    p99: Figure
    statuses: dict[str, int]
    medians: dict[str, float]  # over the solved runs: vertices, collision_checks, plan_duration_s, plan_length_m
    earlier: bool = False  # known from an earlier table only, perhaps of another machine

    @property
    def success(self):
        return self.solved / self.runs


MEDIANS = ("vertices", "collision_checks", "plan_duration_s", "plan_length_m")


def summarise(runs, asked, limit, given_up):
    """Of at least one run."""
    figures = times(runs, limit)
    kept = trimmed(figures)
    solved = [run for run in runs if succeeded(run, limit)]
    return Summary(
        runs=len(runs),
        asked=asked,
        given_up=given_up,
        solved=len(solved),
        unverified=sum(run["status"] == "solved" and not run["verified"] for run in runs),
        limit=limit,
        mean=mean(kept),
        deviation=deviation(kept),
        median=quantile(figures, 0.5),
        p90=quantile(figures, 0.9),
        p99=quantile(figures, 0.99),
        statuses=dict(Counter(run["status"] for run in runs)),
        medians={name: value for name in MEDIANS if (value := median_of(solved, name)) is not None},
    )
