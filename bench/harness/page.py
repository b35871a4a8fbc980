# SPDX-License-Identifier: Apache-2.0
"""RESULTS.md: what was found, on two screens; the tables lie beside it."""

from harness import experiments, pictures
from harness.cells import Cell
from harness.claims import claims
from harness.experiments import ABLATIONS, ROBOT, SCENES
from harness.journal import JournalError, compressed
from harness.prose import wrapped
from harness.results import to_csv, to_json, vertices, write
from harness.tables import HOLDS, markdown, tables

INTRODUCTION = """# What was measured
Written by `bash bench/run results` from [every run](results/runs.jsonl.xz); [every table](results/TABLES.md), with the
protocol and what differs from the paper. How to measure: [README](README.md).

![](results/ratios.svg)

How many times as long as krait's planner the others take, in the median over the same seeds or queries, with 95 %
intervals: on problems of others, and on our five scenes. An arrow is a bound: the other did not solve half of them
within its limit. Three settings were chosen on problems of others: `goal_near_radius` and `reverse_share` on
`parallelpark_0` and `bugtrap_0`, `open_steps` on `maze512-32-0:a`. [ABLATIONS](ABLATIONS.md) names the seeds of each
choice.

All planners keep the library's clearance of 1 mm.

![](results/success.svg)

"""

REASONS = """
**Where a goal may be missed, why.**
- **`prior`** has our pruning, steering and proofs, and may end at full speed, where `adaptive` brakes: where nothing is
  narrow, both take about as long.
- **The best peers** are Syclop's planners, which have our triangles without the portals that are too narrow, and
  KPIECE1; all have our steering, gentle turns and proofs, and may end at full speed.
- **The paper's comparison** is held at 15 links. Figure 4, in the tables, has the others: in `rooms` with 20 links
  `prior` (reference [18] of the paper) solves more than the method under the paper's conditions does, and with 25
  hardly a run of either is solved.
- **The floor** is one Runge-Kutta step and one proof that it is free for every vertex. It leaves out steps that are
  tried and refused, sketches, the paths' repairs, the plan's second drive before it is returned, and the check of the
  scene's bytes (the parts of a search, in the tables).
"""


def goals_section(results):
    rows = []
    missed = []
    for name, found in claims(results).items():
        hold = sum(claim.holds is True for claim in found)
        rows.append([name, f"{hold} of {len(found)}"])
        missed += [[claim.text, claim.found, HOLDS[claim.holds]] for claim in found if not claim.holds]
    if not rows:
        return ""
    text = "## Goals\n" + markdown(["goals", "hold"], rows)
    if missed:
        text += "\nThose that do not hold, or whose interval has the goal between its ends:\n\n"
        text += markdown(["goal", "measured", "holds"], missed)
    return text + REASONS


def worth_section(results):
    """What the paper's adaptation is worth, all else equal."""
    default = [Cell(scene, ROBOT, "adaptive") for scene in SCENES]
    without = [Cell(scene, ROBOT, "adaptive", ABLATIONS["costs never rise"]) for scene in SCENES]
    found = [results.ratio(list(zip(without, default)), share, vertices) for share in (0.5, 0.9)]
    if not all(found):
        return ""
    return (
        "## What the adaptation is worth\n"
        f"Where edge costs never rise (γ 0, all else equal) a search of {ROBOT} takes {found[0].shown()} times as many "
        f"vertices in the median and {found[1].shown()} times at the 90th percentile, over the five scenes; each of "
        "our additions, off in turn: [tables](results/TABLES.md).\n"
    )


def machine_section(results):
    last = results.sessions[-1]
    machines = len({session["machine"] for session in results.sessions})
    loads = sorted(record["load"] for record in results.activity)
    if not loads:
        return ""
    stolen = sum(record.get("stolen_s", 0) for record in results.activity)
    return (
        f"**Where.** {last['processor']}, {last['cores']} cores, core {last['pinned_to_core']} for the timed program"
        f"{'' if machines == 1 else f', one of {machines} machines'}; {last['system']}; {last['compiler']}, "
        f"`{last['flags'].strip()}`; {last['date']}, commit {last['commit']}. Load of the machine {loads[0]:g} to "
        f"{loads[-1]:g}, {stolen:.1f} s taken by its hypervisor.\n"
    )


def page(results):
    sections = [INTRODUCTION + machine_section(results), goals_section(results), worth_section(results)]
    return "\n".join(section for section in sections if section)


def refuse_mixture(results):
    """One page is of one clean commit."""
    commits = sorted({session["commit"] for session in results.sessions})
    if len(commits) > 1 or any(commit.endswith("-dirty") for commit in commits):
        raise JournalError(f"the runs are of {', '.join(commits)}: a page is of one clean commit")


def refuse_none(results):
    """Without a run of any of its experiments a page would be empty, and take the place of one that is not."""
    if not any(results.runs(cell) for cell in experiments.cells_of("all")):
        raise JournalError("there is no run of the pages' experiments, to which own and tuning do not belong")


def write_page(results, folder, records=None):
    """RESULTS.md in the folder; tables and pictures, and the runs themselves if given, in the folder's results."""
    rows = results.rows(experiments.cells_of("all"))
    write(folder / "results/cells.json", to_json(rows))
    write(folder / "results/cells.csv", to_csv(rows))
    write(folder / "results/TABLES.md", wrapped(tables(results)))
    pictures.draw_all(results, folder / "results")
    if records is not None:
        write(folder / "results/runs.jsonl.xz", compressed(records))
    write(folder / "RESULTS.md", wrapped(page(results)))
