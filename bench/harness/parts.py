# SPDX-License-Identifier: Apache-2.0
"""What the parts of a search cost: krait-bench-core's figures, of each scene by blocks of seeds."""

import json
import math
import subprocess
from dataclasses import dataclass

from harness.experiments import ROBOT, SCENES
from harness.problems import BIN
from harness.statistics import Figure, geometric_mean, interval
from harness.worker import BadInput, isolated

PROGRAM = BIN / "krait-bench-core"
REPETITIONS = 3  # the median counts
BLOCKS = 12  # of seeds, as many of each scene: what an interval is drawn from
NANOSECONDS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}
COUNTERS = ("vertices", "attempts", "expansions", "plan_steps")


@dataclass(frozen=True)
class Parts:
    """Of one scene over some seeds. Times are processor seconds of all seeds together, counts too."""

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


def _sum(dicts):
    return {name: math.fsum(each[name] for each in dicts) for name in dicts[0]}


def together(blocks):
    """Of all the blocks' seeds."""
    times, counts = _sum([block.times for block in blocks]), _sum([block.counts for block in blocks])
    return Parts(sum(block.seeds for block in blocks), times, counts)


def all_over_floor(scenes):
    """The geometric mean over scenes, each a list of blocks, with its interval."""
    return interval(
        scenes, lambda drawn: geometric_mean([Figure(together(blocks).all_over_floor) for blocks in drawn])
    )


def _medians(report):
    return [entry for entry in report["benchmarks"] if entry.get("aggregate_name") == "median"]


def parts_of(report):
    """From Google Benchmark's report: the medians."""
    medians = _medians(report)
    times = {entry["run_name"]: 1e-9 * NANOSECONDS[entry["time_unit"]] * entry["cpu_time"] for entry in medians}
    times["search"] = times["plan"] - times["set_up"]
    counted = next(entry for entry in medians if "seeds" in entry)
    return Parts(round(counted["seeds"]), times, {name: counted[name] for name in COUNTERS})


def blocks_of(protocol):
    """The first seed of each block, and how many it has."""
    count = min(BLOCKS, protocol.seeds)
    ends = [protocol.first_seed + number * protocol.seeds // count for number in range(count + 1)]
    return [(first, end - first) for first, end in zip(ends, ends[1:])]


def _report(problem, first_seed, seeds, core):
    command = [PROGRAM, "--scene", problem.scene, "--robot", ROBOT]
    command += ["--seeds", str(seeds), "--first-seed", str(first_seed)]
    command += ["--benchmark_format=json", "--benchmark_report_aggregates_only=true", "--benchmark_min_time=0.05"]
    command += [f"--benchmark_repetitions={REPETITIONS}"]
    done = subprocess.run(isolated(core, command), capture_output=True, text=True)
    if done.returncode != 0:
        raise BadInput(done.stderr.strip())
    return json.loads(done.stdout)


def measure_parts(session, progress):
    """A block of every scene and then the next, as far as the session's journal does not have them."""
    journal = session.journal
    known = {(record["scene"], record["first_seed"]) for record in journal.of_kind("parts")}
    for first_seed, seeds in blocks_of(session.protocol):
        for scene in SCENES:
            if (scene, first_seed) in known:
                continue
            progress.say(f"parts of a search on {scene}, from seed {first_seed} on")
            report = _report(session.problem(scene), first_seed, seeds, session.core)
            entries = {"benchmarks": _medians(report)}
            journal.append({"kind": "parts", "scene": scene, "first_seed": first_seed, "report": entries})
