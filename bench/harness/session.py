# SPDX-License-Identifier: Apache-2.0
"""Measures cells: the protocol, with real programs and a real journal."""

from dataclasses import asdict

from harness import machine, problems
from harness.cells import PEER
from harness.pool import Pool
from harness.problems import BIN
from harness.protocol import measure
from harness.statistics import rounded, summarise
from harness.worker import BadInput, Worker


def in_phases(cells, all_references):
    """Those that are references, and those that are not; with references that nobody asked for if `all_references`."""
    references = [cell.reference for cell in cells if all_references or cell == cell.reference]
    others = [cell for cell in cells if cell != cell.reference]
    return list(dict.fromkeys(references)), list(dict.fromkeys(others))


class Session:
    """On each of `cores` one program at a time."""

    def __init__(self, folder, journal, protocol, progress, cores, any_build=False):
        self.files = folder / "problems"
        self.journal = journal
        self.protocol = protocol
        self.progress = progress
        self.cores = cores
        self.any_build = any_build
        self._problems = {}
        self._runs = {}  # by cell
        self._pool = Pool(cores)
        described = machine.describe(cores)
        self._commit = described["commit"]
        journal.append({"kind": "session", **described, "protocol": asdict(protocol)})
        self.files.mkdir(parents=True, exist_ok=True)
        problems.write_robots(self.files)

    def measure_all(self, cells):
        """As far as the journal does not have them: all references first, since they set the others' time limits."""
        there = [cell for cell in cells if problems.available(cell.problem)]
        skipped = [cell for cell in cells if cell not in there]
        phases = in_phases(there, self.protocol.limit is None)
        self.progress.expect(len(skipped) + sum(map(len, phases)))
        for cell in skipped:
            self.progress.end_cell(cell, f"skipped: {problems.foreign_input(cell.problem)} is not there")
        for cell in there:
            self.problem(cell.problem)
        for phase in phases:
            self._pool.each(phase, self._measure)

    def problem(self, name):
        """Compiled, once a session; not while timed programs run."""
        if name not in self._problems:
            problem = problems.prepare(name, self.files)
            self.journal.append({"kind": "compiled", "problem": name, "compile_s": problem.compile_s})
            self._problems[name] = problem
        return self._problems[name]

    def _measure(self, cell, core):
        limit = self.protocol.limit_of(cell, self._runs.get(cell.reference))
        problem = self.problem(cell.problem)
        program = BIN / ("krait-bench-peers" if cell.peer else "krait-bench-search")
        build = machine.build_of(program, problem)
        known = self.journal.runs(cell.key, None if self.any_build else build)
        trials = problem.trials(self.protocol.seeds, self.protocol.queries)
        give_up = None if problem.queries else self.protocol.give_up
        runs = []
        self.progress.begin_cell(cell)
        with Worker(self._command(program, cell, problem), limit, cell.peer, core, self._pool.stop) as worker:

            def run(trial):
                record = self._record(cell, build, limit, worker.run(trial))
                self._refuse_nonsense(problem, record)
                self.journal.append(record)
                self.progress.made_run(cell, len(runs) + 1, len(trials), limit)
                return record

            for record in measure(trials, limit, give_up, known, run):
                runs.append(record)
        self._runs[cell] = runs
        self._finish(cell, runs, len(trials), limit, build)

    def _command(self, program, cell, problem):
        command = [program, "trials", "--scene", problem.scene, "--input", problem.input]
        command += ["--robot", problems.robot_argument(cell.robot, self.files)]
        command += ["--planner", cell.planner.removeprefix(PEER)]
        for setting in cell.settings:
            command += ["--set", setting]
        return command

    @staticmethod
    def _record(cell, build, limit, answer):
        return {"kind": "run", "cell": cell.key, "build": build, "limit_s": limit, **answer}

    @staticmethod
    def _refuse_nonsense(problem, record):
        """A foreign query may ask the impossible; our own scenes may not."""
        if record["status"] == "refused" and not problem.queries:
            raise BadInput(f"{record['cell']}: {record['complaint']}")

    def _finish(self, cell, runs, asked, limit, build):
        given_up = len(runs) < asked
        trials = [run["trial"] for run in runs]
        record = {"kind": "cell", "cell": cell.key, "build": build, "commit": self._commit}
        record |= {"limit_s": limit, "asked": asked}
        self.journal.append(record | {"given_up": given_up, "trials": trials})
        summary = summarise(runs, asked, limit, given_up)
        note = f"{summary.solved} of {summary.runs} solved, median {summary.median.shown()} s"
        if given_up:
            note += f", given up (limit {rounded(limit)} s)"
        self.progress.end_cell(cell, note)
