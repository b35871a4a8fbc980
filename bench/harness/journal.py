# SPDX-License-Identifier: Apache-2.0
"""The journal: a file of JSON lines that is only ever appended to. A finished one may be compressed (.xz)."""

import fcntl
import json
import lzma
import os
from pathlib import Path


class JournalError(Exception):
    """The journal cannot be used: one line that says why."""


class Journal:
    """Records are dicts with a "kind". One process writes at a time. A last line torn by a crash is cut off.

    Each run belongs to the session before it: "session" is that session's number, from 0.
    """

    def __init__(self, path, writable=True):
        self.path = Path(path)
        self.records = []
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
        if self.path.suffix == ".xz":
            raise JournalError(f"{self.path}: is a compressed journal, to which nothing can be added")
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self._file = open(self.path, "ab")
        except OSError as error:
            raise JournalError(f"{self.path}: cannot be written: {error.strerror}") from None
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            self.close()
            raise JournalError(f"{self.path}: another bench/run is measuring; two would disturb each other") from None

    def _read(self):
        try:
            data = self.path.read_bytes()
            if self.path.suffix == ".xz":
                data = lzma.decompress(data)
        except (OSError, lzma.LZMAError) as error:
            raise JournalError(f"{self.path}: cannot be read: {error}") from None
        whole = data.rfind(b"\n") + 1
        if whole < len(data) and self._file:
            os.truncate(self.path, whole)
        for number, line in enumerate(data[:whole].splitlines(), 1):
            try:
                record = json.loads(line)
            except ValueError:
                raise JournalError(f"{self.path}: line {number} is no JSON; remove it") from None
            if not isinstance(record, dict) or "kind" not in record:
                raise JournalError(f"{self.path}: line {number} is no record of a journal; remove it")
            self.records.append(record)

    def append(self, record):
        """On disk when this returns."""
        self._file.write(json.dumps(record).encode() + b"\n")
        self._file.flush()
        os.fsync(self._file.fileno())
        self.records.append(record)

    def of_kind(self, kind):
        return of_kind(self.records, kind)

    @property
    def sessions(self):
        return self.of_kind("session")

    def runs(self):
        return runs_of(self.records)


def of_kind(records, kind):
    return [record for record in records if record["kind"] == kind]


def runs_of(records):
    """By cell's key, then by trial; the last run of each trial counts."""
    found = {}
    for record in of_kind(records, "run"):
        found.setdefault(record["cell"], {})[record["trial"]] = record
    return found


def merged(journals):
    """The records of several journals, of shards on several machines, as if one had been written."""
    records = []
    for journal in journals:
        before = sum(record["kind"] == "session" for record in records)
        for record in journal.records:
            records.append(record | {"session": record["session"] + before} if "session" in record else record)
    return records


def compressed(records):
    return lzma.compress("".join(json.dumps(record) + "\n" for record in records).encode(), preset=9)
