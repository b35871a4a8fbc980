# SPDX-License-Identifier: Apache-2.0
"""The paper's protocol: how long a run may take, when a cell is given up, and what need not be measured again."""

from dataclasses import dataclass

from harness.statistics import quantile, succeeded, times

PAPER_LIMIT = 100.0  # s


@dataclass(frozen=True)
class Protocol:
    seeds: int = 60
    queries: int = 0  # of a problem that has them; 0: all
    limit: float | None = None  # s; None: the larger of `least` and `factor` times the adaptive planner's median
    least: float = 5.0
    factor: float = 1000.0
    reference_limit: float = PAPER_LIMIT  # of the adaptive planner's own runs
    give_up: int = 10  # failures in a row

    def limit_of(self, cell, reference_runs):
        """Seconds that a run of the cell may take, given the runs of its reference."""
        if self.limit is not None:
            return self.limit
        if cell == cell.reference:
            return self.reference_limit
        median = quantile(times(reference_runs, self.reference_limit), 0.5).value
        return max(self.least, self.factor * median)


def usable(run, limit):
    """Whether a run says what a run with this limit would have said."""
    return run["status"] != "time_used" or run["limit_s"] >= limit


def failures_at_end(outcomes):
    """How many of the last outcomes, in a row, are failures."""
    count = 0
    for succeeded_ in reversed(outcomes):
        if succeeded_:
            break
        count += 1
    return count


def measure(trials, limit, give_up, known, run):
    """Yields a run for each trial, in order, until all are done or `give_up` (None: never) failed in a row.

    `known` has earlier runs by trial; those that are usable are taken, the others are made by run(trial).
    """
    outcomes = []
    for trial in trials:
        earlier = known.get(trial["trial"])
        record = earlier if earlier and usable(earlier, limit) else run(trial)
        outcomes.append(succeeded(record, limit))
        yield record
        if give_up is not None and failures_at_end(outcomes) >= give_up:
            return
