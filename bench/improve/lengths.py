# SPDX-License-Identifier: Apache-2.0
"""How much longer plans are than the shortest way that is wide enough, and how much longer they take than that way at
the top speed, before and after they are improved: the tables of bench/ABLATIONS.md. Median and 90th percentile over the
shipped scenes but streets, and seeds from 10,001: to each scene's goal, or, with --poses, to poses in its middle in
four directions. The working folder is the project's; build krait before."""
import argparse
import json
import math
import re
import subprocess
from pathlib import Path

KRAIT = "build/host/bin/krait"
WORK = Path("build/bench/improve")
SCENES = ["openings", "gates", "rooms", "comb", "corridors"]
ROBOTS = ["car", "truck:1", "truck:2", "diff_drive", "unicycle", "snake:5", "snake:15"]
FIRST_SEED = 10_001


def run(*arguments):
    return subprocess.run([KRAIT, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


# Metres a second, of the robot of a plan.
def top_speed(robot):
    parameters = robot["parameters"]
    if "max_speed" in parameters:
        return parameters["max_speed"]
    return parameters["wheel_radius"] * parameters["max_wheel_speed"]


# The options for the pose in the middle of the scene's goal that faces in the direction, of four.
def pose(scene, quarter):
    polygon = json.loads((WORK / f"{scene}.json").read_text())["goals"][0]["polygon"]
    x, y = ((min(values) + max(values)) / 2 for values in zip(*polygon))
    return "--goal", f"{x},{y},0.1", "--heading", f"{quarter * math.pi / 2:.4f}"


# Length and duration of the first plan and of the improved one, both over those of the shortest way.
def plan(scene, goal, robot, seed, times):
    output = run("plan", WORK / f"{scene}.krait", "--robot", robot, *goal, "--seed", seed, "--improve", times,
               "-o", WORK / "plan.json")
    shortest = float(re.search(r"wide enough \(([\d.]+) m\)", output).group(1))
    found = json.loads((WORK / "plan.json").read_text())
    statistics, fastest = found["statistics"], shortest / top_speed(found["robot"])
    return [(statistics[f"{which}plan_length_m"] / shortest, statistics[f"{which}plan_duration_s"] / fastest)
            for which in ("first_", "")]


def shown(values):
    values = sorted(values)
    return f"{values[len(values) // 2]:.2f} [{values[int(0.9 * (len(values) - 1))]:.2f}]"


def row(robot, goals, seeds, all_times):
    cases = [(scene, goal, robot, seed) for scene in SCENES for goal in goals(scene)
             for seed in range(FIRST_SEED, FIRST_SEED + seeds)]
    by_times = [[plan(*case, times) for case in cases] for times in all_times]
    first = [before for before, _ in by_times[-1]]
    columns = []
    for which in (0, 1):
        columns.append([measures[which] for measures in first])
        columns += [[improved[which] for _, improved in plans] for plans in by_times]
    return f"| {robot} | " + " | ".join(shown(column) for column in columns) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--poses", action="store_true", help="to poses")
    parser.add_argument("--seeds", type=int, default=20, help="of each scene and goal (default: 20)")
    parser.add_argument("--times", type=float, nargs="+", default=[1, 3, 10], metavar="N", help="as krait plan's --improve")
    parser.add_argument("robots", nargs="*", default=ROBOTS)
    options = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    for scene in SCENES:
        run("scene", scene, "-o", WORK / f"{scene}.json")
        run("compile", WORK / f"{scene}.json", "-o", WORK / f"{scene}.krait")
    times = " | ".join(f"{each:g} ×" for each in options.times)
    print(f"| robot | length: first plan | {times} | duration × top speed: first plan | {times} |")
    print("|---" * (2 * len(options.times) + 3) + "|")
    for robot in options.robots:
        goals = (lambda scene: [pose(scene, quarter) for quarter in range(4)]) if options.poses else lambda _: [()]
        print(row(robot, goals, options.seeds, options.times), flush=True)


if __name__ == "__main__":
    main()
