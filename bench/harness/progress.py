# SPDX-License-Identifier: Apache-2.0
"""How far a measurement is and how long it will still take: a line that is rewritten on a terminal, else one a cell."""

import sys
import threading
import time


def shown_duration(seconds):
    if seconds < 90:
        return f"{seconds:.0f} s"
    minutes = seconds / 60
    return f"{minutes:.0f} min" if minutes < 90 else f"{minutes / 60:.1f} h"


class Progress:
    """Of several cells at once. Time left is estimated from the cells of this session that were not there before."""

    def __init__(self, stream=sys.stderr):
        self.stream = stream
        self.cells = 0
        self.finished = 0
        self.measured = 0  # cells that took time
        self.spent = 0.0  # s, on those: from the first one's begin to the last one's end
        self._begins = {}  # by cell
        self._took_time = set()  # cells
        self._first = None  # begin of the first cell that took time
        self._lock = threading.Lock()

    def expect(self, cells):
        self.cells += cells

    def begin_cell(self, cell):
        with self._lock:
            self._begins[cell] = time.monotonic()

    def made_run(self, cell, runs, asked, limit):
        with self._lock:
            self._took_time.add(cell)
            if self._first is None:
                self._first = self._begins[cell]
            if self.stream.isatty():
                self._write(f"{cell.key}: {runs} of {asked}, limit {limit:.3g} s", "")

    def end_cell(self, cell, note):
        with self._lock:
            self.finished += 1
            if cell in self._took_time:
                self.measured += 1
                self.spent = time.monotonic() - self._first
            self._write(f"{cell.key}: {note}", "\n")

    def _write(self, text, end):
        left = ""
        if self.measured:
            left = ", about " + shown_duration(self.spent / self.measured * (self.cells - self.finished)) + " left"
        clear = "\r\033[K" if self.stream.isatty() else ""
        self.stream.write(f"{clear}[{self.finished}/{self.cells}{left}] {text}{end}")
        self.stream.flush()
