# SPDX-License-Identifier: Apache-2.0
"""Problems as files: the shipped scenes at any scale, and foreign maps with their queries, read where they lie.

"rooms", "rooms@2" (scale 2), "dynobench/bugtrap_0", "movingai/arena", "own:path/of/a/map.png"
"""

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
OWN = "own:"
MAX_QUERY_LENGTH = 100.0  # m, longest shortest way (8-connected) of the queries that are used

DYNOBENCH = ("dynobench/bugtrap_0", "dynobench/parallelpark_0")
MOVINGAI = ("movingai/arena", "movingai/den312d")

# From one end of a map of 512 cells to the other: x, y, heading to x, y, radius.
FAR = {
    "movingai/maze512-32-0:a": ([300.5, 1.5, 0.0], [71.5, 480.5, 0.25]),
    "movingai/maze512-32-0:b": ([377.5, 447.5, 2.356], [232.5, 43.5, 0.25]),
    "movingai/brc202d:a": ([247.5, 344.5, 0.0], [271.5, 248.5, 0.25]),
    "movingai/brc202d:b": ([114.5, 247.5, -3.1412], [466.5, 294.5, 0.25]),
}

# Robots that problems name, as ROBOT.json: sizes in m, speeds in m/s and rad/s.
ROBOTS = {
    # dynobench's: first order, half a metre long
    "unicycle1_v0": {
        "model": "unicycle",
        "parameters": {
            "body_length": 0.5,
            "body_width": 0.25,
            "max_speed": 0.5,
            "min_speed": -0.5,
            "max_turn_rate": 0.5,
        },
    },
    # of a TurtleBot's size
    "turtle_diff_drive": {
        "model": "diff_drive",
        "parameters": {
            "body_length": 0.5,
            "body_width": 0.4,
            "wheel_radius": 0.08,
            "track_width": 0.36,
            "max_wheel_speed": 12,
            "max_wheel_acceleration": 24,
        },
    },
    "turtle_unicycle": {
        "model": "unicycle",
        "parameters": {"body_length": 0.5, "body_width": 0.4, "max_speed": 0.96, "max_turn_rate": 2.0},
    },
}


@dataclass(frozen=True)
class Problem:
    name: str
    input: Path  # what the verifier reads
    scene: Path  # compiled
    compile_s: float
    queries: list = field(default_factory=list)  # where the trials are queries, not seeds
    ends: dict = field(default_factory=dict)  # "start" and "goal" of every trial; empty: the scene's
    warnings: str = ""  # of the compiler, about a user's map

    def trial(self, round_, first_seed):
        """Of a round, from 0."""
        if self.queries:
            return self.queries[round_]
        return {"trial": first_seed + round_, "seed": first_seed + round_, **self.ends}


def foreign_input(name):
    """The map of a problem that is not ours; None for a shipped scene."""
    if name.startswith(OWN):
        return Path(name.removeprefix(OWN))
    if "/" not in name:
        return None
    suffix = ".yaml" if name.startswith("dynobench/") else ".map"
    return SAMPLES / (name.partition(":")[0] + suffix)


def available(name):
    source = foreign_input(name)
    if source is None:
        return True
    return source.exists() and (name not in MOVINGAI or queries_of(source).exists())


def queries_of(path):
    return Path(f"{path}.scen")


def run_krait(*arguments):
    """What it warned of."""
    done = subprocess.run([BIN / "krait", *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise BadInput(done.stderr.strip())
    return done.stderr.strip()


def prepare(name, folder):
    """Makes and compiles the problem's files in `folder`."""
    source = foreign_input(name)
    stem = source.stem if name.startswith(OWN) else name.replace("/", "-").replace(":", "-")
    if source is None:
        source = folder / f"{stem}.json"
        scene_name, _, scale = name.partition("@")
        run_krait("scene", scene_name, "--scale", scale or "1", "-o", source)
    scene = folder / f"{stem}.krait"
    seconds = []
    for _ in range(COMPILED_TIMES):
        begin = time.monotonic()
        warnings = run_krait("compile", source, "-o", scene)
        seconds.append(time.monotonic() - begin)
    queries = movingai_queries(source) if name in MOVINGAI else []
    ends = dict(zip(("start", "goal"), FAR[name])) if name in FAR else {}
    warnings = warnings if name.startswith(OWN) else ""
    return Problem(name, source, scene, statistics.median(seconds), queries, ends, warnings)


def robot_argument(robot, folder):
    """The value of --robot: the name, or the file of one of ROBOTS."""
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
