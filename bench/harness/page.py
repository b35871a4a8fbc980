# SPDX-License-Identifier: Apache-2.0
"""RESULTS.md and its tables."""

import subprocess

from harness import experiments, paper, pictures
from harness.cells import PEER, Cell
from harness.claims import best_peer, claims
from harness.experiments import LINKS, PARAMETERS, ROBOT, SCALED_SCENE, SCALES, SCENES, scaled, with_setting
from harness.machine import cores_described
from harness.problems import BIN
from harness.prose import wrapped
from harness.results import to_csv, to_json, write
from harness.statistics import quantile, rounded

INTRODUCTION = """# What was measured
Written by `bash bench/run results` from what `bash bench/run all` has measured; tables as [JSON](results/cells.json) and [CSV](results/cells.csv).

**How.** The paper's protocol: every cell (scene, robot, planner, parameters) is run with {seeds}; mean and standard deviation
(in brackets) leave out a twelfth of the runs at each end, the paper's five best and five worst of 60. Median, 90th and 99th percentile (nearest rank) and success are over all runs.
A run counts as solved only if the independent verifier accepts its plan; every other run counts with the time limit, and a figure that this
touches is printed with "≥". The limit is {limit}. After {give_up} failures in a row a cell is given up; its figures are over the runs made.
Time is seconds from opening the compiled scene to the plan: open, validate, set up, search; compiling a map stands beside it. Every timed program
is pinned to a core of its own. krait's planners reuse one block of 1 GB whose pages are in memory; OMPL's run in a new process for each trial and allocate as they go, which their times include.
"""

DIFFERENCES = """## What differs from the paper
- **Scenes.** The paper's are not published. Ours are drawn after its figures 1 and 3: same idea, other proportions. A passage of 1.4 m here may be easier or harder than theirs, so absolute times
  say nothing about the paper; ratios between planners on one scene do.
- **Machines** are ten years apart, and the paper's times count reading the input and decomposing it; ours do not (the compile time stands beside).
- **Robot.** Eqn 1's sine is corrected ([lib/DESIGN.md](../lib/DESIGN.md)); lengths and limits of the paper's robot are not given, ours are `krait plan --help`'s.
- **Clearance.** Every planner here keeps 1 mm, the library's default, and not `krait plan`'s.
- **Collision.** Every planner here proves whole steps free, not states only; `paper` alone checks as the paper does, and its plans may fail the verifier.
- **Portals too narrow for the robot are cut off before the search**, for `adaptive`, `prior`, `rrt`, `control` and `plain`, and for Syclop on our triangles. The paper's planners have to find out; `paper`, `adaptive-unpruned` and
  `prior-unpruned` do here.
- **Prior and RRT** are this project's implementations of the published methods, not the authors' programs. They share our speeds, gentle turns, goal margin and collision proof, `prior` the paper's β.
- **Figure 4** gives its numbers as bars only, so that ours stand alone there.
- **Ours, not the paper's, and not in `paper`:** restarts (25 links mostly), strays, gentle turns, a sample of 12 states a group, no states just before a collision, κ 10, γ 20, Eqn 9 with a length, a goal shrunk by 3 cm, no raise just before the goal.
- **Time limit.** The paper's is 100 s for all. A limit that follows the adaptive planner's median censors more of the rivals' runs: a "≥" is a bound, and success within 100 s may be higher.
- **Peers** get our dynamics, collision proof, steering and triangles through OMPL's interfaces. Their parameters were chosen by short trials on these scenes; someone who knows them better may do better.
"""


REASONS = """
**Where a goal is missed, why.**
- **`prior` with our pruning.** Portals that are too narrow for the robot are cut off before any search, so that nothing impassable is left to run into: what raised costs save in the paper, geometry saves here
  before the first expansion. Against [18] as published, which has to find out (`prior-unpruned`), the paper's comparison stands.
- **`plain`** is the same search to the bit and shares what costs most: a proof of the whole step for every vertex, one sine and cosine a body, lanes, few vertices. Searches of some hundred expansions leave full
  Dijkstra and weights little to lose.
- **The fastest peer**, where it is nearest to `adaptive`, has our triangles, our pruning, our steering and our proofs.
- **The floor** leaves out steps that are tried and refused, the paths' repairs, the plan's second drive before it is given out, and the check of the scene's bytes (the parts below).
- **Scale.** A plan at four times the size has nearly four times as many steps, each of which must be made at least once.
- **κ = 1** finds some 300 regions' paths anew after every expansion that failed, κ = 20 once for a dozen of them, and the vertices that this spares are too few to pay for it.
- **Parameters.** Deviations are larger than the paper's for their means, half a mean instead of an eighth: so are the standard errors, and means of one parameter's values differ by more without meaning more.
"""


PEERS_NOTE = """
A control of theirs is a target point (the sampled state's, or uniform over the workspace and in 5 % of the draws the goal) and a speed, to which our PID
controller steers for at most 40 steps, SyclopRRT for 10; with `-random`, an acceleration and a steering rate held for at most 20 steps and clipped to what the
robot's limits allow. Sampled states are straight chains; the projection is the position. """


PARTS_NOTE = """
Microseconds a search, the mean over the seeds. Steering, Runge-Kutta and collision are done again from a recording of the search, for every step that it tried; the rest
is what remains: the tree, the groups, the shortest paths, finding triangles, and driving the plan at the end. The floor of the method is one Runge-Kutta step and one
proof that it is free for every vertex. The last columns: vertices of the tree a step of the plan; median vertices of the quarter of the runs with the shortest plans, and with the longest.
"""


def markdown(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def with_deviation(summary):
    """As the paper prints it: mean (standard deviation)."""
    shown = summary.mean.shown()
    return shown if summary.deviation is None else f"{shown} ({rounded(summary.deviation, 2)})"


def solved_of(summary):
    text = f"{summary.solved} of {summary.runs}"
    if summary.unverified:
        text += f", {summary.unverified} not verified"
    return text + (", given up" if summary.given_up else "") + (" †" if summary.earlier else "")


def _median(summary, name, digits=3):
    value = summary.medians.get(name)
    return "" if value is None else rounded(value, digits)


FIGURES = ["solved", "mean", "median", "90th", "99th", "vertices", "plan s", "plan m", "limit s"]


def figures(summary):
    return [
        solved_of(summary),
        with_deviation(summary),
        summary.median.shown(),
        summary.p90.shown(),
        summary.p99.shown(),
        _median(summary, "vertices"),
        _median(summary, "plan_duration_s"),
        _median(summary, "plan_length_m"),
        rounded(summary.limit),
    ]


def descriptions():
    """A line for every planner, by the name that cells have."""
    found = {}
    for program, prefix in (("krait-bench-search", ""), ("krait-bench-peers", PEER)):
        listed = subprocess.run([BIN / program, "planners"], check=True, capture_output=True, text=True).stdout
        for line in listed.splitlines():
            name, text = line.split("\t")
            found[prefix + name] = text
    return found


def seeds_described(results):
    cells = [cell for cell in experiments.cells_of("all") if cell.problem not in experiments.MOVINGAI]
    asked = [row["asked"] for row in results.rows(cells)]
    if not asked:
        return "seeds"
    fewest, most = min(asked), max(asked)
    return f"{fewest} seeds" if fewest == most else f"{fewest} seeds or more (the tables say how many)"


def introduction(results):
    protocol = results.sessions[-1]["protocol"]
    limit = (
        f"{protocol['limit']:g} s"
        if protocol["limit"]
        else f"{protocol['reference_limit']:g} s for the adaptive planner, for all others the larger of "
        f"{protocol['least']:g} s and {protocol['factor']:g} times its median"
    )
    return INTRODUCTION.format(seeds=seeds_described(results), limit=limit, give_up=protocol["give_up"])


def machine_section(results):
    last = results.sessions[-1]
    builds = {session["commit"] for session in results.sessions}
    text = (
        f"**Where.** {last['processor']}, {cores_described(results.sessions)}, "
        f"load {last['load_before']} before the start; {last['system']}; {last['compiler']}, `{last['flags'].strip()}`; "
        f"{last['date']}, commit {last['commit']}."
    )
    if len(builds) > 1:
        text += f" Measured in {len(results.sessions)} sessions, of the commits {', '.join(sorted(builds))}."
    summaries = [results.summary(cell) for cell in experiments.cells_of("all")]
    if any(summary and summary.earlier for summary in summaries):
        text += " Rows with a †, which the pictures of links and scale show like the others, were measured before, perhaps on another machine; no goal is held against them."
    return text + "\n"


HOLDS = {True: "yes", False: "**no**", None: "open"}


def claims_section(results):
    found = claims(results.of_journal())
    if not found:
        return ""
    rows = [[claim.text, claim.found, HOLDS[claim.holds]] for claim in found]
    note = "Where passages are too narrow, the named peer is the fastest of those of OMPL's on that scene that were measured beside `adaptive`.\n\n"
    return "## Goals, and what was measured\n" + note + markdown(["goal", "measured", "holds"], rows) + REASONS


def scenes_section(results):
    rows = []
    for cell in experiments.scenes():
        if summary := results.summary(cell):
            rows.append([cell.problem, cell.planner, *figures(summary)])
    if not rows:
        return ""
    compiled = [f"{scene} {rounded(results.compile_s[scene], 2)} s" for scene in SCENES if scene in results.compile_s]
    text = f"## Scenes, {ROBOT}\n" + markdown(["scene", "planner", *FIGURES], rows)
    names = descriptions()
    text += "\nCompiling: " + ", ".join(compiled) + ". Planners: "
    planners = experiments.RIVALS + experiments.VARIANTS
    return text + "; ".join(f"`{name}` {names[name]}" for name in planners) + ".\n\n![](results/success.svg)\n"


def links_section(results):
    rows = []
    for scene in SCENES:
        for links in LINKS:
            cells = [Cell(scene, f"snake:{links}", planner) for planner in experiments.RIVALS]
            summaries = [results.summary(cell) for cell in cells]
            if any(summaries):
                rows.append([scene, str(links), *(shown for s in summaries for shown in _short(s))])
    if not rows:
        return ""
    header = ["scene", "links"]
    for planner in experiments.RIVALS:
        header += [planner, "median", "solved"]
    text = "## Links (figure 4)\n" + markdown(header, rows)
    return text + "\n![](results/links.svg)\n\n![](results/links-growth.svg)\n"


def _short(summary):
    return [with_deviation(summary), summary.median.shown(), solved_of(summary)] if summary else ["", "", ""]


def _paper_figures(mean_and_deviation, otherwise):
    return "{:.2f} ({:.2f})".format(*mean_and_deviation) if mean_and_deviation else otherwise


def scale_section(results):
    rows = []
    for scale in SCALES:
        row = [scale]
        for planner in experiments.RIVALS:
            summary = results.summary(Cell(scaled(SCALED_SCENE, scale), ROBOT, planner))
            row += [*(_short(summary)), _paper_figures(paper.SCALE[planner][scale], "X")]
        compiled = results.compile_s.get(scaled(SCALED_SCENE, scale))
        rows.append([*row, rounded(compiled, 2) if compiled else ""])
    if not any(results.summary(Cell(scaled(SCALED_SCENE, s), ROBOT, "adaptive")) for s in SCALES):
        return ""
    header = ["scale"]
    for planner in experiments.RIVALS:
        header += [planner, "median", "solved", "paper"]
    text = f"## Scale (table 1): {SCALED_SCENE}, {ROBOT}\n" + markdown([*header, "compiling s"], rows)
    return text + "\n![](results/scale-growth.svg)\n"


def parameters_section(results):
    rows = []
    for name, values in PARAMETERS.items():
        for value in values:
            if summary := results.summary(with_setting(name, value)):
                bold = "**" if experiments.DEFAULTS[name] == value else ""
                rows.append([name, f"{bold}{value}{bold}", *figures(summary)[:6], _paper_figures(paper.PARAMETERS[name].get(value), "")])
    if not rows:
        return ""
    title = f"## Parameters (table 2): {experiments.PARAMETERS_SCENE}, {ROBOT}\n"
    return title + markdown(["parameter", "value", *FIGURES[:6], "paper"], rows)


def peers_section(results):
    measured = [scene for scene in SCENES if best_peer(results, scene)]
    rows = []
    for scene in measured:
        for planner in ("adaptive", *experiments.PEERS):
            if summary := results.summary(Cell(scene, ROBOT, planner)):
                shown = figures(summary)
                rows.append([scene, planner.removeprefix(PEER), *shown[:5], *shown[6:]])
    if not rows:
        return ""
    names = descriptions()
    header = ["scene", "planner", *FIGURES[:5], *FIGURES[6:]]
    text = f"## Peers (OMPL 1.5.2), {ROBOT}\n" + markdown(header, rows)
    if missing := [scene for scene in SCENES if scene not in measured]:
        text += "\nNot measured yet: " + ", ".join(missing) + ".\n"
    return text + PEERS_NOTE + "; ".join(f"`{peer.removeprefix(PEER)}`: {names[peer]}" for peer in experiments.PEERS) + ".\n"


def foreign_section(results):
    rows = []
    for cell in experiments.foreign():
        if summary := results.summary(cell):
            blocked = summary.statuses.get("refused", 0)
            rows.append([cell.problem, cell.robot, cell.planner, *figures(summary), str(blocked)])
    if not rows:
        return ""
    text = "## Foreign problems\n" + markdown(["problem", "robot", "planner", *FIGURES, "start blocked"], rows)
    return text + (
        "\ndynobench's problems run over seeds, MovingAI's over the queries of their `.scen` files up to a shortest way of "
        "100 m (cells are 1 m wide): from the middle of a cell, facing where most room is, into a disc of 0.5 m. A start is blocked "
        "where the robot's body overlaps a wall there. Some of the car's queries cannot be solved: its front is 1 m ahead of "
        "its axle, and a goal may lie in a notch one cell deep (den312d's query 70).\n"
    )


def _percent(share):
    return f"{100 * share:.0f} %"


def _by_length(runs):
    """Median vertices of the quarter of the runs with the shortest plans, and of that with the longest."""
    ordered = sorted((run["plan_steps"], run["vertices"]) for run in runs if run["status"] == "solved")
    quarter = max(len(ordered) // 4, 1)
    return [rounded(quantile(sorted(v for _, v in part), 0.5)) for part in (ordered[:quarter], ordered[-quarter:])]


def parts_section(results):
    rows = []
    for scene, parts in results.parts.items():
        rest = 1 - parts.share("steer", "propagate", "check")
        runs = results.runs(Cell(scene, ROBOT, "adaptive"))
        row = [scene, *(rounded(parts.each(name)) for name in ("open", "set_up", "search"))]
        row += [_percent(share) for share in (parts.share("steer"), parts.share("propagate"), parts.share("check"), rest)]
        row += [rounded(parts.each("floor")), rounded(parts.over_floor), rounded(parts.all_over_floor)]
        row += [rounded(parts.each("shortest_paths")), rounded(1e3 * parts.each("select_group"))]
        row += [rounded(parts.counts["vertices"] / parts.counts["plan_steps"]), *(_by_length(runs) if runs else ["", ""])]
        rows.append(row)
    if not rows:
        return ""
    header = ["scene", "open", "set up", "search", "steer", "Runge-Kutta", "collision", "rest", "floor", "search / floor"]
    header += ["all / floor", "Dijkstra", "group ns", "vertices a plan's step", "shortest plans", "longest"]
    return f"## The parts of a search, {ROBOT}\n" + markdown(header, rows) + PARTS_NOTE


def page(results):
    sections = [
        introduction(results) + "\n" + machine_section(results),
        claims_section(results),
        scenes_section(results),
        links_section(results),
        scale_section(results),
        parameters_section(results),
        peers_section(results),
        foreign_section(results),
        parts_section(results),
        DIFFERENCES,
    ]
    return "\n".join(section for section in sections if section)


def write_page(results, folder):
    """RESULTS.md in the folder, its tables and pictures in the folder's results."""
    rows = results.rows(experiments.cells_of("all"))
    write(folder / "results/cells.json", to_json(rows))
    write(folder / "results/cells.csv", to_csv(rows))
    pictures.draw_all(results, folder / "results")
    write(folder / "RESULTS.md", wrapped(page(results)))
