# SPDX-License-Identifier: Apache-2.0
"""What the parts of a search cost: krait-bench-core's figures, a scene each."""

import json
import subprocess
from dataclasses import dataclass

from harness.experiments import ROBOT, SCENES
from harness.problems import BIN
from harness.worker import BadInput, isolated

PROGRAM = BIN / "krait-bench-core"
REPETITIONS = 5  # the median counts
NANOSECONDS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}
COUNTERS = ("vertices", "attempts", "expansions", "plan_steps")


@dataclass(frozen=True)
class Parts:
    """Of one scene. Times are processor seconds of all seeds together, counts too."""

    seeds: int
    times: dict[str, float]
    counts: dict[str, float]

    def each(self, name):
        """Microseconds a search."""
        return 1e6 * self.times[name] / self.seeds

    def share(self, *names):
        """Of the search."""
        return sum(self.times[name] for name in names) / self.times["search"]

    @property
    def over_floor(self):
        return self.times["search"] / self.times["floor"]

    @property
    def all_over_floor(self):
        """With opening the scene and setting the planner up."""
        return sum(self.times[name] for name in ("open", "set_up", "search")) / self.times["floor"]


def _medians(report):
    return [entry for entry in report["benchmarks"] if entry.get("aggregate_name") == "median"]


def parts_of(report):
    """From Google Benchmark's report: the medians."""
    medians = _medians(report)
    times = {entry["run_name"]: 1e-9 * NANOSECONDS[entry["time_unit"]] * entry["cpu_time"] for entry in medians}
    times["search"] = times["plan"] - times["set_up"]
    counted = next(entry for entry in medians if "seeds" in entry)
    return Parts(round(counted["seeds"]), times, {name: counted[name] for name in COUNTERS})


def _report(problem, protocol, core):
    command = [PROGRAM, "--scene", problem.scene, "--robot", ROBOT]
    command += ["--seeds", str(protocol.seeds), "--first-seed", str(protocol.first_seed)]
    command += ["--benchmark_format=json", "--benchmark_report_aggregates_only=true", "--benchmark_min_time=0.1"]
    command += [f"--benchmark_repetitions={REPETITIONS}"]
    done = subprocess.run(isolated(core, command), capture_output=True, text=True)
    if done.returncode != 0:
        raise BadInput(done.stderr.strip())
    return json.loads(done.stdout)


def measure_parts(session, progress):
    """Of every scene, as far as the session's journal does not have it."""
    journal = session.journal
    known = {record["scene"] for record in journal.of_kind("parts")}
    for scene in SCENES:
        if scene in known:
            continue
        progress.say(f"parts of a search on {scene}")
        report = _report(session.problem(scene), session.protocol, session.core)
        journal.append({"kind": "parts", "scene": scene, "report": {"benchmarks": _medians(report)}})
