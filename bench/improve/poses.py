# SPDX-License-Identifier: Apache-2.0
"""How much longer plans to a pose are than the shortest way that is wide enough, and how much longer they take than
that way at the top speed, before and after they are improved: the table of bench/ABLATIONS.md. Median and 90th
percentile over the shipped scenes, four headings in the middle of each goal, and seeds from 10,001. The working folder
is the project's; build krait before. Usage: poses.py [SEEDS] [ROBOT…]"""
import json
import math
import re
import subprocess
import sys
from pathlib import Path

KRAIT = "build/host/bin/krait"
WORK = Path("build/bench/improve")
SCENES = ["openings", "gates", "rooms", "comb", "corridors"]
ROBOTS = ["car", "truck:1", "truck:2", "diff_drive", "unicycle", "snake:5"]
FIRST_SEED = 10_001
TIMES = [1, 3, 10]  # the first plan's collision checks


def run(*arguments):
    return subprocess.run([KRAIT, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


# Metres a second, of the robot of a plan.
def top_speed(robot):
    parameters = robot["parameters"]
    if "max_speed" in parameters:
        return parameters["max_speed"]
    return parameters["wheel_radius"] * parameters["max_wheel_speed"]


def middle(scene):
    polygon = json.loads((WORK / f"{scene}.json").read_text())["goals"][0]["polygon"]
    return [(min(values) + max(values)) / 2 for values in zip(*polygon)]


# Length and duration of the first plan and of the improved one, both over those of the shortest way.
def plan(scene, robot, heading, seed, times):
    x, y = middle(scene)
    told = run("plan", WORK / f"{scene}.krait", "--robot", robot, "--goal", f"{x},{y},0.1", "--heading", heading,
               "--seed", seed, "--improve", times, "-o", WORK / "plan.json")
    shortest = float(re.search(r"wide enough \(([\d.]+) m\)", told).group(1))
    found = json.loads((WORK / "plan.json").read_text())
    statistics, fastest = found["statistics"], shortest / top_speed(found["robot"])
    return [(statistics[f"{which}plan_length_m"] / shortest, statistics[f"{which}plan_duration_s"] / fastest)
            for which in ("first_", "")]


def shown(values):
    values = sorted(values)
    return f"{values[len(values) // 2]:.2f} [{values[int(0.9 * (len(values) - 1))]:.2f}]"


def row(robot, seeds):
    cases = [(scene, robot, f"{quarter * math.pi / 2:.4f}", seed) for scene in SCENES for quarter in range(4)
             for seed in range(FIRST_SEED, FIRST_SEED + seeds)]
    by_times = [[plan(*case, times) for case in cases] for times in TIMES]
    lengths = [[improved[0] for _, improved in plans] for plans in by_times]
    first = [before for before, _ in by_times[-1]]
    columns = [[length for length, _ in first], *lengths, [duration for _, duration in first],
               [improved[1] for _, improved in by_times[-1]]]
    return f"| {robot} | " + " | ".join(shown(column) for column in columns) + " |"


def main(arguments):
    seeds = int(arguments.pop(0)) if arguments and arguments[0].isdigit() else 8
    WORK.mkdir(parents=True, exist_ok=True)
    for scene in SCENES:
        run("scene", scene, "-o", WORK / f"{scene}.json")
        run("compile", WORK / f"{scene}.json", "-o", WORK / f"{scene}.krait")
    times = " | ".join(f"{each} ×" for each in TIMES)
    print(f"| robot | first plan | {times} | duration × top speed: first | {TIMES[-1]} × |")
    print("|---" * (len(TIMES) + 4) + "|")
    for robot in arguments or ROBOTS:
        print(row(robot, seeds), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
