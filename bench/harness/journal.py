# SPDX-License-Identifier: Apache-2.0
"""The journal: a file of JSON lines that is only ever appended to."""

import fcntl
import json
import os
import threading
from pathlib import Path


class JournalError(Exception):
    """The journal cannot be used: one line that says why."""


class Journal:
    """Records are dicts with a "kind". One process writes at a time, any of its threads.

    A last line torn by a crash is cut off.
    """

    def __init__(self, path, writable=True):
        self.path = Path(path)
        self.records = []
        self._lock = threading.Lock()  # for the file and the records
        self._file = None
        if writable:
            self._open()
        elif not self.path.exists():
            raise JournalError(f"{self.path}: nothing has been measured yet")
        self._read()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        if self._file:
            self._file.close()
            self._file = None

    def _open(self):
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self._file = open(self.path, "ab")
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            self.close()
            raise JournalError(f"{self.path}: another bench/run is measuring; two would disturb each other") from None

    def _read(self):
        data = self.path.read_bytes()
        whole = data.rfind(b"\n") + 1
        if whole < len(data) and self._file:
            os.truncate(self.path, whole)
        for number, line in enumerate(data[:whole].splitlines(), 1):
            try:
                self.records.append(json.loads(line))
            except ValueError:
                raise JournalError(f"{self.path}: line {number} is no JSON; remove it") from None

    def append(self, record):
        """On disk when this returns."""
        with self._lock:
            self._file.write(json.dumps(record).encode() + b"\n")
            self._file.flush()
            os.fsync(self._file.fileno())
            self.records.append(record)

    def of_kind(self, kind):
        with self._lock:
            return [record for record in self.records if record["kind"] == kind]

    def runs(self, key, build):
        """A cell's runs of one build (of any, where build is None) by trial; the last one of each trial counts."""
        return {
            record["trial"]: record
            for record in self.of_kind("run")
            if record["cell"] == key and build in (None, record["build"])
        }
