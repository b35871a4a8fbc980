# SPDX-License-Identifier: Apache-2.0
"""The protocol: which seeds, how long a run may take, when a cell is given up, and which runs are made again."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Protocol:
    """Round k is the k-th run of every cell: what is held against each other was measured in one round.

    No setting was chosen on the seeds from `first_seed` on; limits come from a pilot on others.
    """

    seeds: int = 60  # rounds of every cell
    goal_seeds: int = 200  # rounds of the cells that goals are held against
    few_seeds: int = 20  # rounds of peers that are slow by far
    queries: int = 0  # rounds of a problem that has queries instead of seeds; 0: all
    first_seed: int = 50_001
    pilot_seeds: int = 11  # from 1 on
    limit: float | None = None  # s; None: the larger of `least` and `factor` times the adaptive planner's pilot median
    least: float = 1.0
    factor: float = 300.0
    reference_limit: float = 100.0  # of the adaptive planner's own runs, as in the paper
    give_up: int = 10  # failures in a row
    repeats: int = 3  # of a run that was disturbed

    def limit_of(self, cell, pilot_median):
        """Seconds that a run of the cell may take; `pilot_median` is its reference's."""
        if self.limit is not None:
            return self.limit
        return self.reference_limit if cell == cell.reference else max(self.least, self.factor * pilot_median)


@dataclass(frozen=True)
class Shard:
    """The rounds of one machine of several: seeds are dealt out in turn, so that each machine measures every cell."""

    index: int = 1  # from 1 to count
    count: int = 1

    def has(self, round_):
        return round_ % self.count == self.index - 1


def lost(run):
    """Seconds that the run did not have its core for: another program did, or a hypervisor."""
    return run.get("waited_s", 0) + run.get("stolen_s", 0)


def disturbed(run):
    """Whether more was lost than the figures can stand."""
    return lost(run) > 5e-5 + 0.05 * run.get("time_s", 0)


def failures_at_end(outcomes):
    """How many of the last outcomes, in a row, are failures."""
    count = 0
    for succeeded in reversed(outcomes):
        if succeeded:
            break
        count += 1
    return count
