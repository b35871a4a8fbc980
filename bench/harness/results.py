"""What the journal says about finished cells, and their files: JSON, CSV."""

import csv
import io
import json

from harness.parts import parts_of
from harness.statistics import summarise


class Results:
    def __init__(self, journal):
        self._runs = {}
        self._cells = {}
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
        if not record or not self.runs(cell):
            return None
        return summarise(self.runs(cell), record["asked"], record["limit_s"], record["given_up"])

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
            "asked": summary.asked,
            "given_up": summary.given_up,
            "solved": summary.solved,
            "unverified": summary.unverified,
            "limit_s": summary.limit,
        }
        for name in ("mean", "median", "p90", "p99"):
            figure = getattr(summary, name)
            row |= {f"{name}_s": figure.value, f"{name}_at_least": figure.at_least}
        row["deviation_s"] = summary.deviation
        row |= {f"{name}_median": value for name, value in summary.medians.items()}
        row["statuses"] = summary.statuses
        row["compile_s"] = self.compile_s.get(cell.problem)
        return row


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
