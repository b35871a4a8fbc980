# SPDX-License-Identifier: Apache-2.0
"""results/TABLES.md: every table, and how it was measured."""

import subprocess

from harness import experiments, paper
from harness.cells import FRESH, PEER, Cell
from harness.claims import claims
from harness.experiments import (
    LINKS,
    PARAMETERS,
    PARAMETERS_SCENE,
    ROBOT,
    SCALED_SCENE,
    SCALES,
    SCENES,
    scaled,
    with_setting,
)
from harness.parts import all_over_floor, together
from harness.problems import BIN
from harness.results import vertices
from harness.statistics import quantile, rounded

HOLDS = {True: "yes", False: "**no**", None: "open"}

DIFFERENCES = """## What differs from the paper
- **Scenes.** The paper's are not published. Ours are drawn after its figures 1 and 3: same idea, other proportions. A
  passage of 1.4 m here may be easier or harder than theirs, so absolute times say nothing about the paper; ratios
  between planners on one scene do.
- **Machines** are ten years apart, and the paper's times count reading the input and decomposing it; ours do not (the
  compile time stands beside).
- **Robot.** Eqn 1's sine is corrected ([lib/DESIGN.md](../../lib/DESIGN.md)); lengths and limits of the paper's robot
  are not given, ours are `krait plan --help`'s.
- **Criterion.** `paper`, `paper-prior` and `paper-rrt` check states, as the paper does, and their runs count when they
  say that they are solved; how many of these plans the verifier accepts stands beside. Every other planner proves whole
  steps free, and its runs count only if the verifier accepts the plan.
- **What `paper` has that is ours:** an edge never costs less than 5 % of its length; targets are points of a grid of 16
  bits over a region; 1 mm of clearance, and in the tree 0.2 % of a body's length more; limits of speed, steering and
  hitches hold between the states too; set-points of the speed are uniform from 0.75 to 1 of the top; a plan is driven
  once more from its controls, and is refused where it does not hold; a robot that can reverse does so in a share of the
  expansions; front wheels are turned so that they are straight again in time (since 30 November 2026).
- **Not in `paper`, but in `adaptive`:** sight, sketches, restarts, strays, gentle turns, a sample of 12 states a group,
  no states just before a collision, κ 10, γ 20, Eqn 9 with a length, a goal shrunk by 3 cm, an end at rest, no raise
  just before the goal, no portals that are too narrow, longer expansions in the open, targets further along the path,
  expansions toward a point in the goal that end in the goal only, updates that are rarer where they look at many
  regions, and (since 30 November 2026) speeds at which the robot can stop in time and ways out of narrow starts.
- **An end at rest.** `adaptive` and its variants brake at the end of the plan; all rivals and peers may end at full
  speed.
- **Prior and RRT** are this project's implementations of the published methods, not the authors' programs. They share
  our speeds, gentle turns, goal margin and collision proof, `prior` the paper's β.
- **Figure 4** shows its numbers as bars only, so that no published ones stand beside ours.
- **Time limit.** The paper's is 100 s for all. A limit that follows the adaptive planner's median censors more of the
  rivals' runs: a "≥" is a bound, and success within 100 s may be higher.
- **Peers** get our dynamics, collision proof, steering and triangles through OMPL's interfaces. Their settings were
  chosen by `bash bench/run tuning` on these scenes and other seeds; someone who knows them better may do better. They
  end at any speed.
"""

PEERS_NOTE = """
A control of theirs is a target point (the sampled state's, or uniform over the workspace and in 5 % of the draws the
goal) and a speed, to which our PID controller steers for at most 40 steps (SyclopRRT 5, SST 80), in a fifth of the
draws gently (SST never). It ends in the goal, and of RRT, EST and SyclopEST near its target as well; of the others it
does not, which was better or made no difference on seeds 1 to 19 (`bash bench/run tuning`). With `-random`, the robot's
own control (a chain's acceleration and steering rate) is held for at most 20 steps and clipped to what the robot's
limits allow. Sampled states are straight chains; the projection is the position. Each run of theirs is a new process,
as it is of `fresh:adaptive`."""

PARTS_NOTE = """
Microseconds a search, the mean over the seeds. Steering, Runge-Kutta and collision are done again from a recording of
the search, for every step that it tried; the rest is what remains: the tree, the groups, the shortest paths, finding
triangles, and driving the plan at the end. The floor of the method is one Runge-Kutta step and one proof that it is
free for every vertex. The last columns: vertices of the tree a step of the plan; median vertices of the quarter of the
runs with the shortest plans, and with the longest.
"""

FOREIGN_NOTE = """
dynobench's problems run over seeds, MovingAI's over the queries of their `.scen` files up to a shortest way of 100 m
(cells are 1 m wide): from the middle of a cell, facing where most room is, into a disc of 0.5 m. A start is blocked
where the robot's body overlaps a wall there. Some of the car's queries cannot be solved: its front is 1 m ahead of its
axle, and a goal may lie in a notch one cell deep (den312d's query 70).
"""


def markdown(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def section(title, header, rows, note=""):
    return f"## {title}\n" + markdown(header, rows) + note if rows else ""


def with_deviation(summary):
    """As the paper prints it: mean (standard deviation)."""
    shown = summary.mean.shown()
    return shown if summary.deviation is None else f"{shown} ({rounded(summary.deviation, 2)})"


def solved_of(summary, cell):
    text = f"{summary.solved} of {summary.runs}"
    if cell.checks_states:
        text += f", {summary.verified} verified"
    return text + (", given up" if summary.given_up else "")


def _median(summary, name, digits=3):
    value = summary.medians.get(name)
    return "" if value is None else rounded(value, digits)


FIGURES = ["solved", "mean", "median", "90th", "99th", "vertices", "plan s", "plan m", "limit s"]


def figures(summary, cell):
    return [
        solved_of(summary, cell),
        with_deviation(summary),
        summary.median.shown(),
        summary.p90.shown(),
        summary.p99.shown(),
        _median(summary, "vertices"),
        _median(summary, "plan_duration_s"),
        _median(summary, "plan_length_m"),
        rounded(summary.limit),
    ]


def _rows(results, cells, *columns):
    """A row a cell that was measured: what columns(cell) say, then its figures."""
    return [
        [*(column(cell) for column in columns), *figures(summary, cell)]
        for cell in dict.fromkeys(cells)
        if (summary := results.summary(cell))
    ]


def descriptions():
    """A line for every planner, by the name that cells have."""
    found = {FRESH + "adaptive": "a new process for each run"}
    for program, prefix in (("krait-bench-search", ""), ("krait-bench-peers", PEER)):
        listed = subprocess.run([BIN / program, "planners"], check=True, capture_output=True, text=True).stdout
        for line in listed.splitlines():
            name, text = line.split("\t")
            found[prefix + name] = text
    return found


def _problem(cell):
    return cell.problem


def _robot(cell):
    return cell.robot


def _planner(cell):
    return cell.planner.removeprefix(PEER)


def claims_section(results):
    rows = [[claim.text, claim.found, HOLDS[claim.holds]] for found in claims(results).values() for claim in found]
    return section("Goals, and what was measured", ["goal", "measured", "holds"], rows)


def scenes_section(results):
    rows = _rows(results, experiments.scenes(), _problem, _planner)
    compiled = [f"{scene} {rounded(results.compile_s[scene], 2)} s" for scene in SCENES if scene in results.compile_s]
    names = descriptions()
    planners = experiments.RIVALS + experiments.VARIANTS + experiments.PAPERS
    note = "\nCompiling: " + ", ".join(compiled) + ". Planners: "
    note += "; ".join(f"`{name}` {names[name]}" for name in planners) + ".\n"
    return section(f"Scenes, {ROBOT}", ["scene", "planner", *FIGURES], rows, note)


def proofs_section(results):
    """The verifier's worst figures over krait's plans."""
    rows = []
    for scene in SCENES:
        solved = [run for run in results.runs(Cell(scene, ROBOT, "adaptive")) if run["status"] == "solved"]
        if solved:
            figures = [
                f"{max(run['step_error'] for run in solved):.1e}",
                f"{1e3 * max(run['drift_m'] for run in solved):.1f}",
                f"{1e3 * min(run['clearance_m'] for run in solved):.1f}",
                f"{1e3 * min(run['goal_depth_m'] for run in solved):.1f}",
            ]
            rows.append([scene, str(len(solved)), *figures])
    note = (
        "\nThe worst over all plans: by how much a component of a step's end departs from where the controls lead (m, "
        "rad, m/s or rad/s), how far that adds up (drift), and the clearance and the depth in the goal of the motion "
        "as driven.\n"
    )
    header = ["scene", "plans", "error", "drift mm", "clearance mm", "depth mm"]
    return section(f"What the verifier measured, {ROBOT}, adaptive", header, rows, note)


def ablations_section(results):
    """By vertices alone, which no machine changes."""
    rows = []
    default = [Cell(scene, ROBOT, "adaptive") for scene in SCENES]
    for name, settings in {"(as it ships)": (), **experiments.ABLATIONS}.items():
        cells = [Cell(scene, ROBOT, "adaptive", settings) for scene in SCENES]
        if not all(results.runs(cell) for cell in cells):
            continue
        pairs = list(zip(cells, default))
        factors = [results.ratio(pairs, share, vertices).shown() for share in (0.5, 0.9)] if settings else ["1", "1"]
        found = [results.summary(cell) for cell in cells]
        each = [f"{_median(s, 'vertices')} [{rounded(s.vertices_p90)}]" for s in found if s.solved]
        solved = f"{sum(summary.solved for summary in found)} of {sum(summary.runs for summary in found)}"
        rows.append([name, " ".join(settings), solved, *factors, *each])
    note = (
        "\nTimes as many vertices as the default takes on the same seeds, with the interval; for each scene the median "
        "and the 90th percentile. γ 0 takes the paper's adaptation away and leaves all else.\n"
    )
    header = ["without", "set", "solved", "× median", "× 90th", *SCENES]
    return section(f"What the adaptation and each addition is worth, {ROBOT}, vertices", header, rows, note)


def links_section(results):
    planners = ("adaptive", "prior", "paper", "paper-prior")
    rows = []
    for scene in SCENES:
        for links in LINKS:
            cells = [Cell(scene, f"snake:{links}", planner) for planner in planners]
            if any(results.runs(cell) for cell in cells):
                rows.append([scene, str(links), *(shown for cell in cells for shown in _short(results, cell))])
    header = ["scene", "links"]
    for planner in planners:
        header += [planner, "median", "solved"]
    return section("Links (figure 4)", header, rows, "\n![](links.svg)\n\n![](links-growth.svg)\n")


def _short(results, cell):
    summary = results.summary(cell)
    return [with_deviation(summary), summary.median.shown(), solved_of(summary, cell)] if summary else ["", "", ""]


def _paper_figures(mean_and_deviation, otherwise):
    return "{:.2f} ({:.2f})".format(*mean_and_deviation) if mean_and_deviation else otherwise


def streets_section(results):
    rows = _rows(results, experiments.streets(), _robot, _planner)
    return section("Long chains in streets of 3.5 m", ["robot", "planner", *FIGURES], rows)


def scale_section(results):
    rows = []
    papers = dict(zip(experiments.PAPERS, ("adaptive", "prior", "rrt")))
    for scale in SCALES:
        cells = [Cell(scaled(SCALED_SCENE, scale), ROBOT, planner) for planner in ("adaptive", "prior", *papers)]
        if not any(results.runs(cell) for cell in cells):
            continue
        row = [scale]
        for cell in cells:
            row += _short(results, cell)
            if cell.planner in papers:
                row.append(_paper_figures(paper.SCALE[papers[cell.planner]][scale], "X"))
        compiled = results.compile_s.get(scaled(SCALED_SCENE, scale))
        rows.append([*row, rounded(compiled, 2) if compiled else ""])
    header = ["scale"]
    for planner in ("adaptive", "prior", *papers):
        header += [planner, "median", "solved", *(["published"] if planner in papers else [])]
    title = f"Scale (table 1): {SCALED_SCENE}, {ROBOT}"
    return section(title, [*header, "compiling s"], rows, "\n![](scale-growth.svg)\n")


def parameters_section(results):
    rows = []
    for name, values in PARAMETERS.items():
        for value in values:
            cell = with_setting(name, value)
            if summary := results.summary(cell):
                bold = "**" if experiments.PAPER_DEFAULTS[name] == value else ""
                shown = figures(summary, cell)[:6]
                published = _paper_figures(paper.PARAMETERS[name].get(value), "")
                rows.append([name, f"{bold}{value}{bold}", *shown, published])
    title = f"Parameters (table 2): {PARAMETERS_SCENE}, {ROBOT}, the paper's conditions"
    return section(title, ["parameter", "value", *FIGURES[:6], "published"], rows)


def peers_section(results):
    rows = [[*row[:7], *row[8:]] for row in _rows(results, experiments.peers(), _problem, _planner)]
    if not any(results.runs(cell) for cell in experiments.peers() if cell.peer):
        return ""
    names = descriptions()
    header = ["scene", "planner", *FIGURES[:5], *FIGURES[6:]]
    said = "; ".join(f"`{peer.removeprefix(PEER)}`: {names[peer]}" for peer in experiments.PEERS)
    note = f"{PEERS_NOTE} {said}.\n"
    library = f"OMPL {results.sessions[-1].get('ompl', '')}".strip()
    return section(f"Peers ({library}), {ROBOT}", header, rows, note)


def foreign_section(results):
    rows = []
    for cell in (*experiments.foreign(), *experiments.far()):
        if summary := results.summary(cell):
            rows.append([cell.problem, cell.robot, cell.planner, *figures(summary, cell), str(summary.refused)])
    header = ["problem", "robot", "planner", *FIGURES, "start blocked"]
    return section("Foreign problems and far goals", header, rows, FOREIGN_NOTE)


def own_section(results, cells):
    rows = _rows(results, cells, _planner)
    return section(f"{cells[0].problem}, {cells[0].robot}", ["planner", *FIGURES], rows)


def tuning_section(results, cells):
    """Times over those of the peer as it is published: less than 1 is better."""
    rows = []
    for planner, settings in dict.fromkeys((cell.planner, cell.settings) for cell in cells if cell.settings):
        pairs = [(Cell(scene, ROBOT, planner, settings), Cell(scene, ROBOT, planner)) for scene in SCENES]
        found = results.ratio(pairs)
        solved = [sum(summary.solved for c in column if (summary := results.summary(c))) for column in zip(*pairs)]
        rows.append([planner.removeprefix(PEER), *settings, found.shown() if found else "", *map(str, solved)])
    return section(f"Tuning of the peers, {ROBOT}", ["planner", "set", "× median time", "solved", "as published"], rows)


def _percent(share):
    return f"{100 * share:.0f} %"


def _by_length(runs):
    """Median vertices of the quarter of the runs with the shortest plans, and of that with the longest."""
    ordered = sorted((run["plan_steps"], run["vertices"]) for run in runs if run["status"] == "solved")
    quarter = max(len(ordered) // 4, 1)
    return [rounded(quantile(sorted(v for _, v in part), 0.5)) for part in (ordered[:quarter], ordered[-quarter:])]


def parts_section(results):
    rows = []
    for scene, blocks in results.parts.items():
        parts = together(blocks)
        rest = 1 - parts.share("steer", "propagate", "check")
        runs = results.runs(Cell(scene, ROBOT, "adaptive"))
        row = [scene, *(rounded(parts.each(name)) for name in ("open", "set_up", "search"))]
        shares = [parts.share(name) for name in ("steer", "propagate", "check")]
        row += [_percent(share) for share in (*shares, rest)]
        row += [rounded(parts.each("floor")), rounded(parts.over_floor), all_over_floor([blocks]).shown()]
        row += [rounded(parts.each("shortest_paths")), rounded(1e3 * parts.each("select_group"))]
        row += [rounded(parts.counts["vertices"] / parts.counts["plan_steps"])]
        row += _by_length(runs) if runs else ["", ""]
        rows.append(row)
    header = ["scene", "open", "set up", "search", "steer", "Runge-Kutta", "collision", "rest", "floor"]
    header += ["search / floor", "all / floor", "Dijkstra", "group ns", "vertices a plan's step", "shortest plans"]
    header.append("longest")
    return section(f"The parts of a search, {ROBOT}", header, rows, PARTS_NOTE)


def instructions_section(results):
    rows = [[*key.split(" "), rounded(each / 1e6)] for key, each in results.instructions.items()]
    note = (
        "\nMillions a search, the mean over the first 11 seeds or queries, from opening the scene to the plan, counted "
        "by Valgrind.\n"
    )
    return section("Instructions", ["problem", "robot", "planner", "10⁶ instructions"], rows, note)


def protocol_section(results):
    protocol = results.protocol
    limit = (
        f"{protocol['limit']:g} s"
        if protocol["limit"]
        else f"{protocol['reference_limit']:g} s for the adaptive planner, as in the paper, and for all others the "
        f"larger of {protocol['least']:g} s and {protocol['factor']:g} times its median in a pilot on seeds "
        f"1 to {protocol['pilot_seeds']}"
    )
    again, disturbed_ = results.repeated()
    before = protocol["first_seed"] - 1
    return f"""# Every table
Written by `bash bench/run results` from [every run](runs.jsonl.xz); the same as [JSON](cells.json) and
[CSV](cells.csv). What they say: [RESULTS](../RESULTS.md).

**Protocol.** Round k is the k-th run of every cell (scene, robot, planner, settings), with seed {before} + k, one timed
program at a time: what is held against each other was measured in one round. There are {protocol['seeds']} rounds,
{protocol['goal_seeds']} of the cells that goals are held against, and {protocol['few_seeds']} of peers that are slow by
far. Mean and standard deviation (in brackets) leave out a twelfth of the runs at each end, the paper's five best and
five worst of 60; median, 90th and 99th percentile (nearest rank) and success are over all runs. A run counts as solved
only if the independent verifier accepts its plan; every other run counts with the time limit, and a figure that this
touches is printed with "≥". The limit is {limit}. After {protocol['give_up']} failures in a row a cell is given up.
Ratios are of the same seeds or queries, with 95 % of a bootstrap in brackets; where the goal lies between the ends, it
is open.

**Time** is seconds from opening the compiled scene to the plan: open, validate, set up, search; compiling a map stands
beside it. Timed programs are pinned to a core of their own. krait's planners share a process and a block of 1 GB whose
pages are in memory; OMPL's have a new process for each run and allocate as they go, which their times include;
`fresh:adaptive` has a new process too. A run that waited for its core for more than 5 % of its time, because something
else ran there, is made again, up to {protocol['repeats']} times, and the one that waited least counts: {again} of
{len(results.all_runs())} were, {disturbed_} of these waited to the last.
"""


def tables(results):
    sections = [
        protocol_section(results),
        claims_section(results),
        foreign_section(results),
        scenes_section(results),
        proofs_section(results),
        ablations_section(results),
        links_section(results),
        streets_section(results),
        scale_section(results),
        parameters_section(results),
        peers_section(results),
        instructions_section(results),
        parts_section(results),
        DIFFERENCES,
    ]
    return "\n".join(section_ for section_ in sections if section_)
