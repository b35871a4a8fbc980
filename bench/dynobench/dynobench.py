# SPDX-License-Identifier: Apache-2.0
"""dynobench's problems with their own robots, beside the published results: writes bench/DYNOBENCH.md. One program at a
time; the working folder is the project's; build krait before."""
import argparse
import csv
import json
import math
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from harness import machine  # noqa: E402
from harness.statistics import Figure, interval, quantile  # noqa: E402

KRAIT = "build/host/bin/krait"
WORK = Path("build/bench/dynobench")
ROBOT = WORK / "robot.json"
PAGE = Path("bench/DYNOBENCH.md")
FIRST_SEED = 50_001  # by which nothing was chosen
SHORT, LONG = 0.05, 1.0  # seconds of one core, first plan included
STEP = 0.1  # seconds, of dynobench's robots
CONTROLS = 2  # of every robot of these

# Seconds, medians: the time and the cost of iDb-A*'s first solution, and the least final cost after 120 s of iDb-A*,
# RRT* with trajectory optimisation, and SST*, from the table to: J. Ortiz-Haro, W. Hoenig, V. Hartmann, M. Toussaint,
# iDb-A*: Iterative Search and Optimization for Optimal Kinodynamic Motion Planning, IEEE T-RO 2024.
PUBLISHED = {
    ("unicycle1_v0", "bugtrap_0"): (0.3, 22.2, 20.9),
    ("unicycle1_v0", "kink_0"): (0.2, 21.5, 13.2),
    ("unicycle1_v0", "parallelpark_0"): (0.1, 3.1, 3.0),
    ("unicycle2_v0", "bugtrap_0"): (0.8, 25.3, 25.0),
    ("unicycle2_v0", "kink_0"): (0.3, 17.7, 17.7),
    ("unicycle2_v0", "parallelpark_0"): (0.1, 5.8, 5.6),
    ("car1_v0", "bugtrap_0"): (0.5, 19.3, 19.0),
    ("car1_v0", "kink_0"): (0.8, 23.0, 15.5),
    ("car1_v0", "parallelpark_0"): (0.1, 3.4, 3.2),
}


def scalar(text):
    return [float(part) for part in text.strip("[]").split(",")] if text.startswith("[") else text.strip('"')


def read_model(path):
    lines = (line.split("#")[0].strip() for line in path.read_text().splitlines())
    return {key: scalar(value.strip()) for key, value in (line.split(":", 1) for line in lines if line)}


def box(size):
    x, y = size[0] / 2, size[1] / 2
    return {"polygon": [[-x, -y], [x, -y], [x, y], [-x, y]]}


# krait's robot of dynobench's model: its ROBOT.json.
def robot_of(model):
    parameters = {"body_length": model["size"][0], "body_width": model["size"][1],
                  "max_speed": float(model["max_vel"]), "min_speed": float(model["min_vel"])}
    kind = model["dynamics"]
    if kind == "car_with_trailers":
        parameters |= {"wheelbase": float(model["l"]), "hitch_length": model["hitch_lengths"][0],
                       "max_steering": float(model["max_steering_abs"])}
        trailers = int(model["num_trailers"])
        return {"model": "kinematic_truck", "links": trailers, "parameters": parameters,
                "bodies": [box(model["size"])] + trailers * [box(model["size_trailer"])]}
    parameters["max_turn_rate"] = float(model["max_angular_vel"])
    if kind == "unicycle2":
        parameters |= {"max_acceleration": float(model["max_acc_abs"]),
                       "max_turn_acceleration": float(model["max_angular_acc"])}
    return {"model": {"unicycle1": "unicycle", "unicycle2": "unicycle2"}[kind], "parameters": parameters}


# One explicit Euler step of a plan's control, as dynobench integrates.
def euler(robot, state, control):
    p = robot["parameters"]
    if robot["model"] == "kinematic_truck":
        x, y, theta, trailer = state
        speed, steering = control
        rates = (speed * math.cos(theta), speed * math.sin(theta), speed / p["wheelbase"] * math.tan(steering),
                 speed / p["hitch_length"] * math.sin(theta - trailer))
    elif robot["model"] == "unicycle2":
        rates = (state[3] * math.cos(state[2]), state[3] * math.sin(state[2]), state[4], *control)
    else:
        rates = (control[0] * math.cos(state[2]), control[0] * math.sin(state[2]), control[1])
    return [value + STEP * rate for value, rate in zip(state, rates)]


# Metres between the plan's states and those by Euler's steps, at most.
def apart_by_euler(robot, table):
    rows = list(csv.reader(table.read_text().splitlines()))
    states = [[float(value) for value in row[1:-CONTROLS]] for row in rows[1:]]
    state, apart = states[0], 0.0
    for row, planned in zip(rows[1:], states[1:]):
        state = euler(robot, state, [float(value) for value in row[-CONTROLS:]])
        apart = max(apart, math.dist(state[:2], planned[:2]))
    return apart


# Seconds: the search's, the first plan's and the returned one's; and metres apart by Euler. None: not solved.
def plan(problem, robot, seed, *options):
    table, result = WORK / "plan.csv", WORK / "plan.json"
    hitches = ["--hitch-tolerance", "0.1"] if robot["model"] == "kinematic_truck" else []
    answer = subprocess.run([KRAIT, "plan", problem, "--robot", ROBOT, "--seed", str(seed), "--csv", table, "-o",
                             result, *hitches, *options], capture_output=True, text=True)
    if answer.returncode == 1:
        return None
    if answer.returncode != 0:
        sys.exit(f"{problem}, seed {seed}: {answer.stderr}")
    took = float(re.search(r"seed \d+: ([\d.]+) s", answer.stdout).group(1))
    duration = json.loads(result.read_text())["statistics"]["plan_duration_s"]
    return took, duration, apart_by_euler(robot, table)


def middle(values, share=0.5):
    return quantile(sorted(values), share)


# The ratio of medians, with its 95 % interval by bootstrap over the seeds.
def ratio(values, of_median, form):
    found = interval([values], lambda samples: Figure(of_median(middle(samples[0])), False))
    return f"{found.estimate.value:{form}} ({found.low:{form}}–{found.high:{form}})"


# Of the runs that found a plan.
def shown(runs, best):
    costs = [found[1] for found in runs if found]
    if not costs:
        return "–"
    few = "" if len(costs) == len(runs) else f", {len(costs)} of {len(runs)}"
    return (f"{middle(costs):.1f} [{middle(costs, 0.9):.1f}], "
            f"{ratio(costs, lambda cost: cost / best, '.2f')}{few}")


def row(samples, name, problem, seeds, long_seeds):
    robot = robot_of(read_model(samples / name / "model.yaml"))
    ROBOT.write_text(json.dumps(robot))
    file = samples / name / f"{problem}.yaml"
    firsts, shorts, longs = ([plan(file, robot, seed, *options) for seed in range(FIRST_SEED, FIRST_SEED + count)]
                             for count, options in ((seeds, ["--improve", "0"]),
                                                    (seeds, ["--improve", "1e6", "--time-limit", str(SHORT)]),
                                                    (long_seeds, ["--improve", "1e6", "--time-limit", str(LONG)])))
    solved = [found for found in firsts if found]
    if not solved:
        return f"| {name} | {problem} | 0 of {seeds} |" + 6 * " – |"
    first_time, first_cost, best = PUBLISHED[name, problem]
    took = [found[0] for found in solved]
    apart = max(found[2] for runs in (firsts, shorts, longs) for found in runs if found)
    return (f"| {name} | {problem} | {len(solved)} of {seeds} | {1e3 * middle(took):.1f} [{1e3 * first_time:.0f}], "
            f"{ratio(took, lambda seconds: first_time / seconds, '.0f')} | {middle([found[1] for found in solved]):.1f} [{first_cost}] | {best} | "
            f"{shown(shorts, best)} | {shown(longs, best)} | {100 * apart:.1f} |")


def page(commit, rows, seeds, long_seeds):
    return f"""# dynobench's problems with their own robots
Written by `python3 bench/dynobench/dynobench.py SAMPLES` at commit {commit}, on one core of {machine.processor()}.

The goals are full states: within 0.1 m of the position and 0.1 rad of the heading, at rest, and the trailer of `car1`
within 0.1 rad of straight. Every plan was proven, and verified in double precision; it keeps the clearance that
`krait plan` has when none is asked for, 2 % of the robot's width.
There are {seeds} seeds from {FIRST_SEED:,}, {long_seeds} for the plans of {LONG:g} s. What steers these robots and improves their
plans was chosen on these problems, with other seeds. Costs are durations in seconds, medians with the 90th percentile
in brackets; ratios are those of medians, with 95 % intervals over the seeds. Published are the time and cost of
iDb-A*'s first plan, and the best final cost of iDb-A*, RRT* with trajectory optimisation, and SST*, in medians
(Ortiz-Haro, Hönig, Hartmann and Toussaint, iDb-A*, IEEE T-RO 2024; one core of an EPYC 7502, 120 s).

| robot | problem | solved | first plan: ms [published], times as fast | its cost [published] | best final cost \
| after {1e3 * SHORT:g} ms: median [90th], of the best | after {LONG:g} s | cm apart by Euler |
|---|---|---|---|---|---|---|---|---|
""" + "\n".join(rows) + """

**What is not alike.** dynobench integrates by Euler's steps of 0.1 s, krait by Runge-Kutta: the last column says how
far a plan's positions are apart, at most over all plans, if its controls are integrated by Euler. krait ends anywhere
within the tolerances above, which is a little less way than to the goal itself. Its times are those of a search in a
program that has compiled the map. The machines differ.

**Where krait is no better.** `unicycle2` drives as its steering lets it, which brakes to turn in narrow corners: 50 ms
are too short for as good plans through `kink_0`. First plans through it go around the outside, and in 50 ms nine of ten
searches for `unicycle2` and half of those for `car1` find a way through the kink, in 1 s all of them. A plan of `car1`
that ends in a push at a fifth of its speed, as some first plans through `bugtrap_0` do, takes three times as long, and
50 ms are not always enough to replace it; nor, on the side of the trap that is shorter but asks for a loop before the
goal, to find the other side.
"""


def count(text):
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"'{text}' is no number of seeds from 1")
    return int(text)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("samples", type=Path, help="folder with a folder for each robot: its model.yaml, its problems")
    parser.add_argument("seeds", type=count, nargs="?", default=100, help="of first plans and of the shorter time")
    parser.add_argument("long_seeds", type=count, nargs="?", default=20, help="of the longer time")
    options = parser.parse_args()
    files = [options.samples / name / file for name, problem in PUBLISHED for file in ("model.yaml", f"{problem}.yaml")]
    for file in [Path(KRAIT), *files]:
        if not file.is_file():
            parser.error(f"{file} is missing")
    return options


def main():
    options = parse_arguments()
    commit = machine.commit()
    if commit.endswith("-dirty"):
        sys.exit("dynobench: the working tree has changes: commit them, so that the page names what was measured")
    WORK.mkdir(parents=True, exist_ok=True)
    rows = []
    for name, problem in PUBLISHED:
        rows.append(row(options.samples, name, problem, options.seeds, options.long_seeds))
        print(rows[-1], flush=True)
    PAGE.write_text(page(commit, rows, options.seeds, options.long_seeds))


if __name__ == "__main__":
    main()
