# SPDX-License-Identifier: Apache-2.0
"""What a journal says about cells; its files: JSON, CSV."""

import csv
import io
import json
import math

from harness.journal import of_kind, runs_of
from harness.parts import parts_of
from harness.problems import MOVINGAI
from harness.protocol import disturbed, failures_at_end
from harness.statistics import (
    Figure,
    geometric_mean,
    in_order,
    interval,
    quantile,
    ratio,
    succeeded,
    summarise,
    time_of,
)

FIGURES = ("mean", "median", "p90", "p99")


def time(run, cell):
    """s"""
    return time_of(run, run["limit_s"], cell)


def time_a_step(run, cell):
    """s, a step of the plan."""
    found = time(run, cell)
    return found if found.at_least else Figure(found.value / run["plan_steps"])


def vertices(run, cell):
    """Of a tree; more than any number where there is no plan."""
    return Figure(run["vertices"]) if succeeded(run, run["limit_s"], cell) else Figure(math.inf, True)


class Results:
    def __init__(self, records):
        self.sessions = of_kind(records, "session")
        self.activity = [record for record in records if "load" in record]  # of runs, in older journals of rounds
        self.parts = {}  # blocks of seeds, by scene
        for record in of_kind(records, "parts"):
            self.parts.setdefault(record["scene"], []).append(parts_of(record["report"]))
        self.instructions = {record["cell"]: record["each"] for record in of_kind(records, "instructions")}
        self.compile_s = {record["problem"]: record["compile_s"] for record in of_kind(records, "compiled")}
        self._runs = {key: [runs[trial] for trial in sorted(runs)] for key, runs in runs_of(records).items()}

    @property
    def protocol(self):
        return self.sessions[-1]["protocol"]

    def all_runs(self):
        return [run for runs in self._runs.values() for run in runs]

    def repeated(self):
        """How many runs were made again, and how many of these were disturbed to the last."""
        again = [run for run in self.all_runs() if run.get("repeats")]
        return len(again), sum(disturbed(run) for run in again)

    def runs(self, cell):
        return self._runs.get(cell.key, [])

    def limit(self, cell):
        return self.runs(cell)[0]["limit_s"]

    def summary(self, cell):
        """None where the cell has not been measured."""
        runs = self.runs(cell)
        if not runs:
            return None
        limit = self.limit(cell)
        outcomes = [succeeded(run, limit, cell) for run in runs]
        given_up = cell.problem not in MOVINGAI and failures_at_end(outcomes) >= self.protocol["give_up"]
        return summarise(runs, limit, given_up, cell)

    def _pairs(self, slow, fast, value):
        """Figures of the trials that both cells have had, a list a machine."""
        others = {run["trial"]: run for run in self.runs(fast)}
        found = {}
        for run in self.runs(slow):
            other = others.get(run["trial"])
            if other and "refused" not in (run["status"], other["status"]):
                machine = self.sessions[run["session"]]["machine"]
                found.setdefault(machine, []).append((value(run, slow), value(other, fast)))
        return list(found.values())

    def ratio(self, cells, share=0.5, value=time):
        """How many times a quantile of the one exceeds that of the other, the geometric mean over `cells`, which are
        pairs (slow, fast); with its interval. Formed within each machine, of the same trials. None without runs."""
        samples = [self._pairs(slow, fast, value) for slow, fast in cells]
        if not samples or not all(samples):
            return None
        return interval(
            [sample for machines in samples for sample in machines],
            lambda drawn: geometric_mean([_ratio_of_quantiles(pairs, share) for pairs in drawn]),
        )

    def samples(self, cells, value):
        """Figures of every run, a list a cell; none where a cell has no runs."""
        found = [[value(run, cell) for run in self.runs(cell)] for cell in cells]
        return found if all(found) else []

    def mean_quantile(self, cells, share, value):
        """The geometric mean over the cells of a quantile, with its interval. None without runs."""

        def estimate(drawn):
            return geometric_mean([quantile(in_order(figures), share) for figures in drawn])

        samples = self.samples(cells, value)
        return interval(samples, estimate) if samples else None

    def rows(self, cells):
        """A flat dict a cell, of those that were measured."""
        return [self._row(cell, summary) for cell in cells if (summary := self.summary(cell))]

    def _row(self, cell, summary):
        row = {
            "problem": cell.problem,
            "robot": cell.robot,
            "planner": cell.planner,
            "settings": " ".join(cell.settings),
            "runs": summary.runs,
            "given_up": summary.given_up,
            "solved": summary.solved,
            "verified": summary.verified,
            "limit_s": summary.limit,
        }
        for name in FIGURES:
            figure = getattr(summary, name)
            row |= {f"{name}_s": figure.value, f"{name}_at_least": figure.at_least}
        row["deviation_s"] = summary.deviation
        row |= {f"{name}_median": value for name, value in summary.medians.items()}
        row["vertices_p90"] = summary.vertices_p90
        row["statuses"] = summary.statuses
        row["compile_s"] = self.compile_s.get(cell.problem)
        return row


def _ratio_of_quantiles(pairs, share):
    slow, fast = (quantile(in_order(figures), share) for figures in zip(*pairs))
    return ratio(slow, fast)


def to_json(rows):
    return json.dumps(rows, indent=1) + "\n"


def to_csv(rows):
    names = list(dict.fromkeys(name for row in rows for name in row))
    text = io.StringIO()
    writer = csv.DictWriter(text, names, lineterminator="\n")
    writer.writeheader()
    for row in rows:
        flat = {**row, "statuses": " ".join(f"{name}:{count}" for name, count in row["statuses"].items())}
        writer.writerow(flat)
    return text.getvalue()


def write(path, content):
    """Text or bytes, whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(path.name + ".part")
    if isinstance(content, bytes):
        part.write_bytes(content)
    else:
        part.write_text(content)
    part.replace(path)
