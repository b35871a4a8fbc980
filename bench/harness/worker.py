# SPDX-License-Identifier: Apache-2.0
"""A benchmark program that answers trials, alone on one core."""

import json
import os
import select
import subprocess
import tempfile

from harness.stop import Stopped

MEMORY = 12 << 30  # bytes a program may map
PATIENCE = 120.0  # s beyond the limit, for set-up and for verifying, until a program counts as hung


class BadInput(Exception):
    """The program refused its input: one line that says why."""


def timing_cores(count):
    """The cores that timed programs are pinned to: the last, since interrupts tend to go to the first."""
    return sorted(os.sched_getaffinity(0))[-count:]


def isolated(core, command):
    """The command, on that core and within MEMORY, without core files."""
    return ["taskset", "--cpu-list", str(core), "prlimit", f"--as={MEMORY}", "--core=0", *map(str, command)]


class Worker:
    """Answers one trial at a time. `fresh`: by a new process each (OMPL seeds its random numbers once a process).

    Raises Stopped instead of waiting once `stop` is said; no process is left behind where this is a context.
    """

    def __init__(self, command, limit, fresh, core, stop):
        self.command = isolated(core, [*command, "--time-limit", limit])
        self.patience = limit + PATIENCE
        self.fresh = fresh
        self.until = stop
        self._process = None
        self._errors = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def stop(self):
        if self._process:
            self._process.kill()
            self._forget()

    def _forget(self):
        self._process.communicate()
        self._errors.close()
        self._process = None

    def _start(self):
        self._errors = tempfile.TemporaryFile()
        self._process = subprocess.Popen(
            self.command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._errors,
            start_new_session=True,  # a terminal's Ctrl-C is for the driver
        )

    def run(self, trial):
        """The program's answer; where it prints none, one whose status is "hung" or "crashed"."""
        if not self._process:
            self._start()
        try:
            self._process.stdin.write(json.dumps(trial).encode() + b"\n")
            self._process.stdin.flush()
            answer = self._answer(trial)
        except BrokenPipeError:
            answer = self._ended(trial)
        if self.fresh:
            self.stop()
        return answer

    def _answer(self, trial):
        ready, _, _ = select.select([self._process.stdout, self.until], [], [], self.patience)
        if self.until in ready:
            raise Stopped
        if not ready:
            self.stop()
            return {"trial": trial["trial"], "status": "hung"}
        line = self._process.stdout.readline()
        return json.loads(line) if line.endswith(b"\n") else self._ended(trial)

    def _ended(self, trial):
        code = self._process.wait()
        self._errors.seek(0)
        text = self._errors.read().decode(errors="replace").strip()
        self._forget()
        if code == 2:
            raise BadInput(text)
        return {"trial": trial["trial"], "status": "crashed", "complaint": f"exit code {code}: {text[-200:]}"}
