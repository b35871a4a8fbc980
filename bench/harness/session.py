# SPDX-License-Identifier: Apache-2.0
"""Measures cells round by round, with real programs and a real journal."""

import hashlib
from dataclasses import asdict
from pathlib import Path

from harness import machine, problems
from harness.journal import JournalError
from harness.problems import BIN
from harness.protocol import Shard, disturbed, failures_at_end, lost
from harness.statistics import quantile, succeeded, times
from harness.worker import BadInput, Worker

# Of a program's answer, what a figure is made of, and the digits that it needs; None: all.
KEPT = {
    "status": None, "verified": None, "complaint": None, "hash": None,
    "time_s": 6, "waited_s": 2, "vertices": None, "collision_checks": None, "plan_steps": None,
    "plan_length_m": 5, "plan_duration_s": 5, "step_error": 2, "drift_m": 3, "clearance_m": 3, "goal_depth_m": 3,
    "load": None, "stolen_s": None,
}


def kept(answer):
    def short(value, digits):
        return float(f"{value:.{digits}g}") if digits and isinstance(value, float) else value

    return {name: short(answer[name], digits) for name, digits in KEPT.items() if answer.get(name) is not None}


class Session:
    """One timed program at a time, on one core."""

    def __init__(self, folder, journal, protocol, progress, core, shard=Shard()):
        self.files = folder / "problems"
        self.journal = journal
        self.protocol = protocol
        self.progress = progress
        self.core = core
        self.shard = shard
        self._number = len(journal.sessions)
        self._problems = {}
        self._krait = Worker([BIN / "krait-bench-search", "trials"], False, core)  # for all cells: one block of memory
        described = machine.describe(core)
        self._refuse_another_build(described)
        journal.append({"kind": "session", **described, "shard": asdict(shard), "protocol": asdict(protocol)})
        self.files.mkdir(parents=True, exist_ok=True)
        problems.write_robots(self.files)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._krait.stop()

    def _refuse_another_build(self, described):
        for earlier in self.journal.sessions:
            if any(earlier[name] != described[name] for name in ("commit", "programs", "machine")):
                raise JournalError(
                    f"{self.journal.path}: was measured of commit {earlier['commit']} or on another machine, and "
                    "figures of two builds are not held against each other; move it away to measure again"
                )

    def measure_all(self, cells, rounds_of=None):
        """`rounds_of` has those of cells that do not have the protocol's. What the journal has is not made again."""
        there = [cell for cell in cells if self.is_there(cell)]
        for cell in there:
            self.problem(cell.problem)
        self._refuse_other_inputs([cell for cell in there if cell.problem.startswith(problems.OWN)])
        limits = self._limits(there)
        rounds = self._rounds(there, rounds_of or {})
        known = self.journal.runs()
        mine = [round_ for round_ in range(len(rounds)) if self.shard.has(round_)]
        self.progress.expect(sum(self._is_new(cell, round_, known) for round_ in mine for cell in rounds.due(round_)))
        for round_ in mine:
            if self._measure_round(round_, rounds, known, limits):
                self.progress.end_round(round_ + 1)

    def _refuse_other_inputs(self, own):
        """A user's map, by what it compiles to, and robot may be others now than those of the runs that are there."""
        files = {cell.problem.removeprefix(problems.OWN): self.problem(cell.problem).scene for cell in own}
        files |= {cell.robot: Path(cell.robot) for cell in own if Path(cell.robot).is_file()}
        known = {record["name"]: record["sha256"] for record in self.journal.of_kind("input")}
        for name, path in files.items():
            digest = hashlib.sha256(path.read_bytes()).hexdigest()
            if name not in known:
                self.journal.append({"kind": "input", "name": name, "sha256": digest})
            elif known[name] != digest:
                raise JournalError(
                    f"{self.journal.path}: was measured before {name} was changed; move it away to measure again"
                )

    def is_there(self, cell):
        if problems.available(cell.problem):
            return True
        self.progress.say(f"{cell.key}: skipped, {problems.foreign_input(cell.problem)} is not there")
        return False

    def _rounds(self, cells, rounds_of):
        """A cell whose runs are different queries has them all, and is not given up."""
        counts, give_up = {}, {}
        for cell in cells:
            queries = self.problem(cell.problem).queries
            used = min(len(queries), self.protocol.queries or len(queries))
            counts[cell] = used if queries else rounds_of.get(cell, self.protocol.seeds)
            give_up[cell] = None if queries else self.protocol.give_up
        return Rounds(counts, give_up)

    def problem(self, name):
        """Compiled, once a session; not while timed programs run."""
        if name not in self._problems:
            problem = problems.prepare(name, self.files)
            self.journal.append({"kind": "compiled", "problem": name, "compile_s": problem.compile_s})
            self._problems[name] = problem
            if problem.warnings:
                self.progress.say(problem.warnings)
        return self._problems[name]

    def _limits(self, cells):
        """Seconds by cell, from a pilot of their references on other seeds."""
        if self.protocol.limit is not None:
            return {cell: self.protocol.limit for cell in cells}
        medians = {record["cell"]: record["median_s"] for record in self.journal.of_kind("pilot")}
        for reference in dict.fromkeys(cell.reference for cell in cells):
            if reference.key not in medians:
                medians[reference.key] = self._pilot(reference)
        return {cell: self.protocol.limit_of(cell, medians[cell.reference.key]) for cell in cells}

    def _pilot(self, reference):
        problem = self.problem(reference.problem)
        limit = self.protocol.reference_limit
        count = self.protocol.pilot_seeds
        trials = problem.queries[:count] or [problem.trial(round_, 1) for round_ in range(count)]
        runs = [self._run(reference, trial, limit) for trial in trials]
        median = quantile(times(runs, limit, reference), 0.5).value
        self.journal.append({"kind": "pilot", "cell": reference.key, "median_s": median})
        self.progress.say(f"pilot of {reference.key}: {1e3 * median:.3g} ms")
        return median

    def _measure_round(self, round_, rounds, known, limits):
        """How many runs were made."""
        made = 0
        for cell in rounds.due(round_):
            trial = self.trial(cell, round_)
            run = known.get(cell.key, {}).get(trial["trial"])
            if not run:
                run = self._run(cell, trial, limits[cell])
                self.journal.append(run)
                made += 1
                self.progress.made(cell.key)
            rounds.add(cell, run)
        return made

    def trial(self, cell, round_):
        return self.problem(cell.problem).trial(round_, self.protocol.first_seed)

    def _is_new(self, cell, round_, known):
        return self.trial(cell, round_)["trial"] not in known.get(cell.key, {})

    def _run(self, cell, trial, limit):
        """The run of several that was disturbed least, where the first was."""
        problem = self.problem(cell.problem)
        request = {**trial, "scene": str(problem.scene), "input": str(problem.input), "limit_s": limit}
        request |= {"robot": problems.robot_argument(cell.robot, self.files), "planner": cell.name}
        if cell.settings:
            request["set"] = cell.set
        answers = []
        for _ in range(1 + self.protocol.repeats):
            activity = machine.Activity(self.core)
            answers.append(self._answer(cell, request) | activity.seen())
            self._refuse_nonsense(cell, problem, answers[-1])
            if not disturbed(answers[-1]):
                break
        best = min(answers, key=lost)
        record = {"kind": "run", "session": self._number, "cell": cell.key, "trial": trial["trial"], "limit_s": limit}
        record |= kept(best)
        return record | ({"repeats": len(answers) - 1} if len(answers) > 1 else {})

    def _answer(self, cell, request):
        if not cell.fresh:
            return self._krait.run(request)
        command = [BIN / ("krait-bench-peers" if cell.peer else "krait-bench-search"), "trials"]
        with Worker(command, True, self.core) as worker:
            return worker.run(request)

    @staticmethod
    def _refuse_nonsense(cell, problem, answer):
        """A foreign query may ask the impossible; our own scenes may not."""
        if answer["status"] == "refused" and not problem.queries:
            ends = "; own plans from the map's first start to its first goal"
            raise BadInput(f"{cell.key}: {answer['complaint']}{ends if cell.problem.startswith(problems.OWN) else ''}")


class Rounds:
    """Which cells still have a run in a round: not those that have had all of theirs, or that were given up."""

    def __init__(self, counts, give_up):
        self._counts = counts  # rounds by cell
        self._give_up = give_up  # failures in a row, by cell; None: never
        self._outcomes = {cell: [] for cell in counts}

    def __len__(self):
        return max(self._counts.values(), default=0)

    def due(self, round_):
        return [cell for cell, count in self._counts.items() if round_ < count and not self._is_given_up(cell)]

    def _is_given_up(self, cell):
        most = self._give_up[cell]
        return most is not None and failures_at_end(self._outcomes[cell]) >= most

    def add(self, cell, run):
        self._outcomes[cell].append(succeeded(run, run["limit_s"], cell))
