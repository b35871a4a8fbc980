"""How far a measurement is and how long it will still take: a line that is rewritten on a terminal, else one a cell."""

import sys
import time


def shown_duration(seconds):
    if seconds < 90:
        return f"{seconds:.0f} s"
    minutes = seconds / 60
    return f"{minutes:.0f} min" if minutes < 90 else f"{minutes / 60:.1f} h"


class Progress:
    """Time left is estimated from the cells of this session that were not there before."""

    def __init__(self, cells, stream=sys.stderr):
        self.cells = cells
        self.stream = stream
        self.finished = 0
        self.measured = 0  # cells that took time
        self.spent = 0.0  # s, on those
        self._begin = None

    def begin_cell(self):
        self._begin = time.monotonic()
        self._made = 0

    def made_run(self, cell, runs, asked, limit):
        self._made += 1
        if self.stream.isatty():
            self._write(f"{cell.key}: {runs} of {asked}, limit {limit:.3g} s", "\r")

    def end_cell(self, cell, note):
        self.finished += 1
        if self._made:
            self.measured += 1
            self.spent += time.monotonic() - self._begin
        self._write(f"{cell.key}: {note}", "\n")

    def _write(self, text, end):
        left = ""
        if self.measured:
            left = ", about " + shown_duration(self.spent / self.measured * (self.cells - self.finished)) + " left"
        clear = "\r\033[K" if self.stream.isatty() else ""
        self.stream.write(f"{clear}[{self.finished}/{self.cells}{left}] {text}{end if end == chr(10) else ''}")
        self.stream.flush()
