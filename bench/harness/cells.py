# SPDX-License-Identifier: Apache-2.0
"""Cells: what is measured."""

from dataclasses import dataclass

PEER = "ompl:"  # prefix of the planners that krait-bench-peers has


@dataclass(frozen=True)
class Cell:
    """All trials of a cell differ in nothing but the seed or the query."""

    problem: str  # a name that problems.prepare knows
    robot: str  # as krait plan has it, or a robot of problems.ROBOTS
    planner: str  # "adaptive", "ompl:SyclopEST"
    settings: tuple[str, ...] = ()  # "alpha=4"

    @property
    def key(self):
        return " ".join((self.problem, self.robot, self.planner, *self.settings))

    @property
    def peer(self):
        return self.planner.startswith(PEER)

    @property
    def reference(self):
        """The cell whose median sets this one's time limit: the adaptive planner with its defaults."""
        return Cell(self.problem, self.robot, "adaptive")
