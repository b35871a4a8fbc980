# SPDX-License-Identifier: Apache-2.0
"""Problems as files: the shipped scenes at any scale, and foreign maps with their queries, read where they lie.

"rooms", "rooms@2" (scale 2), "dynobench/bugtrap_0", "movingai/arena"
"""

import hashlib
import json
import math
import statistics
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path

from harness.worker import BadInput

ROOT = Path(__file__).resolve().parents[2]
BIN = ROOT / "build/host/bin"
SAMPLES = ROOT.parent / "shared/samples"
COMPILED_TIMES = 3  # the median counts
GOAL_RADIUS = 0.5  # m, of a MovingAI query: the goal's cell
MAX_QUERY_LENGTH = 100.0  # m, longest shortest way (8-connected) of the queries that are asked

# dynobench's unicycle1_v0: first order, half a metre long. Speeds in m/s and rad/s, sizes in m.
DYNOBENCH_UNICYCLE = {
    "model": "unicycle",
    "parameters": {
        "body_length": 0.5,
        "body_width": 0.25,
        "max_speed": 0.5,
        "min_speed": -0.5,
        "max_turn_rate": 0.5,
    },
}
ROBOTS = {"unicycle1_v0": DYNOBENCH_UNICYCLE}


@dataclass(frozen=True)
class Problem:
    name: str
    input: Path  # what the verifier reads
    scene: Path  # compiled
    compile_s: float
    queries: list = field(default_factory=list)  # where the trials are queries, not seeds

    def trials(self, seeds, queries):
        """Seeds 1 to `seeds`; where the problem has queries, `queries` of them, evenly spread (0: all)."""
        if not self.queries:
            return [{"trial": seed, "seed": seed} for seed in range(1, seeds + 1)]
        if not 0 < queries < len(self.queries):
            return self.queries
        return [self.queries[i * len(self.queries) // queries] for i in range(queries)]

    @property
    def digest(self):
        return hashlib.sha256(self.scene.read_bytes()).hexdigest()


def foreign_input(name):
    """The map of a foreign problem; None for a shipped scene."""
    if "/" not in name:
        return None
    suffix = ".yaml" if name.startswith("dynobench/") else ".map"
    return SAMPLES / (name + suffix)


def available(name):
    source = foreign_input(name)
    if source is None:
        return True
    return source.exists() and (source.suffix != ".map" or queries_of(source).exists())


def queries_of(path):
    return Path(f"{path}.scen")


def run_krait(*arguments):
    done = subprocess.run([BIN / "krait", *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise BadInput(done.stderr.strip())


def prepare(name, folder):
    """Makes and compiles the problem's files in `folder`."""
    stem = name.replace("/", "-")
    source = foreign_input(name)
    if source is None:
        source = folder / f"{stem}.json"
        scene_name, _, scale = name.partition("@")
        run_krait("scene", scene_name, "--scale", scale or "1", "-o", source)
    scene = folder / f"{stem}.krait"
    seconds = []
    for _ in range(COMPILED_TIMES):
        begin = time.monotonic()
        run_krait("compile", source, "-o", scene)
        seconds.append(time.monotonic() - begin)
    queries = movingai_queries(source) if source.suffix == ".map" else []
    return Problem(name, source, scene, statistics.median(seconds), queries)


def robot_argument(robot, folder):
    """What --robot takes: the name, or the file of one of ROBOTS."""
    return str(folder / f"{robot}.json") if robot in ROBOTS else robot


def write_robots(folder):
    for name, robot in ROBOTS.items():
        (folder / f"{name}.json").write_text(json.dumps(robot))


def read_map(path):
    """Rows of booleans, the top row first: whether a cell is free."""
    lines = path.read_text().splitlines()
    return [[c in ".GS" for c in line] for line in lines[lines.index("map") + 1 :]]


def roomiest_heading(free, column, row):
    """Of the eight compass headings (radians, y up) the one along which most cells are free; the first among equals."""

    def is_free(x, y):
        return 0 <= y < len(free) and 0 <= x < len(free[y]) and free[y][x]

    def cells_ahead(turn):
        right, up = round(math.cos(turn)), round(math.sin(turn))
        count = 0
        while is_free(column + (count + 1) * right, row - (count + 1) * up):
            count += 1
        return count

    turns = [k * math.pi / 4 for k in range(8)]
    return max(turns, key=cells_ahead)


def movingai_queries(path):
    """The trials of MAP.scen up to MAX_QUERY_LENGTH: from the middle of a cell, facing where most room is, to a cell.

    A query names column and row from the top left; cells are 1 m wide and the world's y points up.
    """
    free = read_map(path)
    trials = []
    for number, line in enumerate(queries_of(path).read_text().split("\n")[1:], 1):
        if not line.strip():
            continue
        _, _, _, _, *cells, length = line.split()
        x0, y0, x1, y1 = map(int, cells)
        if float(length) > MAX_QUERY_LENGTH or (x0, y0) == (x1, y1):
            continue
        start = [x0 + 0.5, len(free) - y0 - 0.5, roomiest_heading(free, x0, y0)]
        goal = [x1 + 0.5, len(free) - y1 - 0.5, GOAL_RADIUS]
        trials.append({"trial": number, "seed": 1, "start": start, "goal": goal})
    return trials
