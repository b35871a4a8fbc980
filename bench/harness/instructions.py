# SPDX-License-Identifier: Apache-2.0
"""Instructions of a search, from opening the scene to the plan, counted by Valgrind: no clock, no noise."""

import json
import re
import subprocess

from harness.cells import Cell
from harness.experiments import FOREIGN, ROBOT, SCENES
from harness.problems import BIN, robot_argument
from harness.worker import BadInput

SEEDS = 11
COUNTED = "krait::host::run_search*"
TIME_LIMIT = 1e6  # s: of a search under Valgrind nothing is said by its time


def cells():
    found = [Cell(scene, ROBOT, planner) for scene in SCENES for planner in ("adaptive", "plain", "prior")]
    return found + [Cell(problem, robot, planner) for problem, robot in FOREIGN for planner in ("adaptive", "prior")]


def _count(trials):
    """Of all trials together, however they end; their seeds are among those that the tables have verified."""
    command = ["valgrind", "--tool=callgrind", f"--toggle-collect={COUNTED}", "--callgrind-out-file=/dev/null"]
    command += [BIN / "krait-bench-search", "trials", "--memory", "64", "--unverified"]
    lines = "".join(json.dumps(trial) + "\n" for trial in trials)
    done = subprocess.run(command, input=lines, capture_output=True, text=True)
    counted = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or not counted:
        raise BadInput(f"valgrind: exit code {done.returncode}: {done.stderr.strip()[-200:]}")
    return int(counted.group(1))


def measure_instructions(session, progress):
    """Of what the session's journal does not have."""
    journal = session.journal
    known = {record["cell"] for record in journal.of_kind("instructions")}
    for cell in cells():
        if cell.key in known or not session.is_there(cell):
            continue
        progress.say(f"instructions of {cell.key}")
        trials = [session.trial(cell, round_) for round_ in range(min(SEEDS, session.protocol.seeds))]
        request = {"limit_s": TIME_LIMIT, "planner": cell.name, "robot": robot_argument(cell.robot, session.files)}
        problem = session.problem(cell.problem)
        request |= {"scene": str(problem.scene), "input": str(problem.input)}
        count = _count([{**trial, **request} for trial in trials])
        journal.append({"kind": "instructions", "cell": cell.key, "seeds": len(trials), "each": count / len(trials)})
