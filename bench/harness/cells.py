# SPDX-License-Identifier: Apache-2.0
"""Cells: what is measured."""

from dataclasses import dataclass

PEER = "ompl:"  # prefix of the planners that krait-bench-peers has
FRESH = "fresh:"  # prefix of a planner of krait's that gets a new process for each run, as the peers do
PAPER = "paper"  # prefix of planners under the paper's conditions


@dataclass(frozen=True)
class Cell:
    """All runs of a cell differ in nothing but the seed or the query."""

    problem: str  # a name that problems.prepare knows
    robot: str  # as krait plan has it, or a robot of problems.ROBOTS
    planner: str  # "adaptive", "ompl:SyclopEST", "fresh:adaptive"
    settings: tuple[str, ...] = ()  # "alpha=4"

    @property
    def key(self):
        return " ".join((self.problem, self.robot, self.planner, *self.settings))

    @property
    def peer(self):
        return self.planner.startswith(PEER)

    @property
    def fresh(self):
        """Whether each run is a process of its own: OMPL seeds its random numbers once a process."""
        return self.peer or self.planner.startswith(FRESH)

    @property
    def name(self):
        """As the program has it."""
        return self.planner.removeprefix(PEER).removeprefix(FRESH)

    @property
    def checks_states(self):
        """Whether a run counts by the paper's criterion: the planner's states are free, whatever lies between them."""
        return self.planner.startswith(PAPER) or "continuous=0" in self.settings

    @property
    def reference(self):
        """The cell whose median sets this one's time limit: the adaptive planner with its defaults."""
        return Cell(self.problem, self.robot, "adaptive")

    @property
    def set(self):
        """What a trial sets, by name."""
        return {name: float(value) for name, value in (setting.split("=") for setting in self.settings)}
