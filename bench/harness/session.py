"""Measures cells: the protocol, with real programs and a real journal."""

from dataclasses import asdict

from harness import machine, problems
from harness.cells import PEER
from harness.problems import BIN
from harness.protocol import measure
from harness.statistics import rounded, summarise
from harness.worker import BadInput, Worker


class Session:
    def __init__(self, folder, journal, protocol, progress, any_build=False):
        self.files = folder / "problems"
        self.journal = journal
        self.protocol = protocol
        self.progress = progress
        self.any_build = any_build
        self._problems = {}
        self._done = {}  # runs by cell
        journal.append({"kind": "session", **machine.describe(), "protocol": asdict(protocol)})

    def measure_all(self, cells):
        for cell in cells:
            if problems.available(cell.problem):
                self.runs_of(cell)
            else:
                self.progress.begin_cell()
                self.progress.end_cell(cell, f"skipped: {problems.foreign_input(cell.problem)} is not there")

    def runs_of(self, cell):
        """The cell's runs, measured now as far as the journal does not have them."""
        if cell not in self._done:
            needs_reference = cell != cell.reference and self.protocol.limit is None
            reference = self.runs_of(cell.reference) if needs_reference else []
            self._done[cell] = self._measure(cell, self.protocol.limit_of(cell, reference))
        return self._done[cell]

    def problem(self, name):
        """Compiled, once a session."""
        if name not in self._problems:
            problem = problems.prepare(name, self.files)
            self.journal.append({"kind": "compiled", "problem": name, "compile_s": problem.compile_s})
            self._problems[name] = problem
        return self._problems[name]

    def _measure(self, cell, limit):
        problem = self.problem(cell.problem)
        program = BIN / ("krait-bench-peers" if cell.peer else "krait-bench-search")
        build = machine.build_of(program, problem)
        known = self.journal.runs(cell.key, None if self.any_build else build)
        trials = problem.trials(self.protocol.seeds, self.protocol.queries)
        give_up = None if problem.queries else self.protocol.give_up
        runs = []
        self.progress.begin_cell()
        with Worker(self._command(program, cell, problem), limit, fresh=cell.peer) as worker:

            def run(trial):
                record = self._record(cell, build, limit, worker.run(trial))
                self._refuse_nonsense(problem, record)
                self.journal.append(record)
                self.progress.made_run(cell, len(runs) + 1, len(trials), limit)
                return record

            for record in measure(trials, limit, give_up, known, run):
                runs.append(record)
        self._finish(cell, runs, len(trials), limit, build)
        return runs

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
        record = {"kind": "cell", "cell": cell.key, "build": build, "limit_s": limit, "asked": asked}
        record |= {"given_up": given_up, "trials": trials}
        if record not in self.journal.records[-1:]:
            self.journal.append(record)
        summary = summarise(runs, asked, limit, given_up)
        note = f"{summary.solved} of {summary.runs} solved, median {summary.median.shown()} s"
        if given_up:
            note += f", given up (limit {rounded(limit)} s)"
        self.progress.end_cell(cell, note)
