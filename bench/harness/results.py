# SPDX-License-Identifier: Apache-2.0
"""What the journal says about finished cells, and an earlier table about others; their files: JSON, CSV."""

import copy
import csv
import io
import json

from harness.cells import Cell
from harness.parts import parts_of
from harness.statistics import MEDIANS, Figure, Summary, summarise

FIGURES = ("mean", "median", "p90", "p99")


class Results:
    """`table`: rows() of an earlier journal, perhaps another machine's, for cells that this one does not have."""

    def __init__(self, journal, table=()):
        self._runs = {}
        self._cells = {}
        self._table = {_cell_of(row).key: row for row in table}
        for record in journal.of_kind("cell"):
            self._cells[record["cell"]] = record
        for key, cell in self._cells.items():
            runs = journal.runs(key, cell["build"]) | {}
            self._runs[key] = [runs[trial] for trial in cell["trials"] if trial in runs]
        self.sessions = journal.of_kind("session")
        self.parts = {record["scene"]: parts_of(record["report"]) for record in journal.of_kind("parts")}
        self.compile_s = {record["problem"]: record["compile_s"] for record in journal.of_kind("compiled")}

    def runs(self, cell):
        return self._runs.get(cell.key, [])

    def limit(self, cell):
        return self._cells[cell.key]["limit_s"]

    def summary(self, cell):
        """None where the cell has not been measured."""
        record = self._cells.get(cell.key)
        if record and self.runs(cell):
            return summarise(self.runs(cell), record["asked"], record["limit_s"], record["given_up"])
        row = self._table.get(cell.key)
        return _summary_of(row) if row else None

    def of_journal(self):
        """Without the earlier table: what may be held against each other."""
        alone = copy.copy(self)
        alone._table = {}
        return alone

    def rows(self, cells):
        """A flat dict a cell, of those that were measured."""
        return [self._row(cell, summary) for cell in cells if (summary := self.summary(cell))]

    def _row(self, cell, summary):
        if summary.earlier:
            return self._table[cell.key]
        row = {
            "problem": cell.problem,
            "robot": cell.robot,
            "planner": cell.planner,
            "settings": " ".join(cell.settings),
            "runs": summary.runs,
            "asked": summary.asked,
            "given_up": summary.given_up,
            "solved": summary.solved,
            "unverified": summary.unverified,
            "limit_s": summary.limit,
        }
        for name in FIGURES:
            figure = getattr(summary, name)
            row |= {f"{name}_s": figure.value, f"{name}_at_least": figure.at_least}
        row["deviation_s"] = summary.deviation
        row |= {f"{name}_median": value for name, value in summary.medians.items()}
        row["statuses"] = summary.statuses
        row["compile_s"] = self.compile_s.get(cell.problem)
        row["commit"] = self._cells[cell.key].get("commit")
        return row


def _cell_of(row):
    return Cell(row["problem"], row["robot"], row["planner"], tuple(row["settings"].split()))


def _summary_of(row):
    figures = {name: Figure(row[f"{name}_s"], row[f"{name}_at_least"]) for name in FIGURES}
    return Summary(
        runs=row["runs"],
        asked=row["asked"],
        given_up=row["given_up"],
        solved=row["solved"],
        unverified=row["unverified"],
        limit=row["limit_s"],
        deviation=row["deviation_s"],
        statuses=row["statuses"],
        medians={name: row[f"{name}_median"] for name in MEDIANS if f"{name}_median" in row},
        earlier=True,
        **figures,
    )


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


def write(path, text):
    """Whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(path.name + ".part")
    part.write_text(text)
    part.replace(path)
