# SPDX-License-Identifier: Apache-2.0
"""bench/run's program."""

import argparse
import json
import os
import signal
import sys
from pathlib import Path

from harness import experiments, readme
from harness.journal import Journal, JournalError
from harness.page import write_page
from harness.parts import measure_parts
from harness.problems import ROOT
from harness.progress import Progress
from harness.protocol import Protocol
from harness.results import Results, to_json, write
from harness.session import Session
from harness.worker import BadInput, timing_cores

DATA = ROOT / "build/bench"
QUICK = Protocol(seeds=3, queries=3, limit=1.0, give_up=1)


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="bench/run",
        description="Measures what the tables claim, by the paper's protocol. What has been measured is not measured "
        "again: break off at any time, and the same command goes on.",
    )
    parser.add_argument("what", choices=[*experiments.EXPERIMENTS, "core", "all", "readme", "results"],
                        metavar="WHAT",
                        help="scenes: the five scenes, every planner of krait; links: figure 4; scale: table 1; "
                        "parameters: table 2; peers: OMPL; foreign: dynobench and MovingAI; core: what the parts "
                        "of a search cost; goals: of these, what goals over all scenes are held against; all: all of these; readme: the table in README.md; results: write bench/RESULTS.md of what has been measured")
    parser.add_argument("--seeds", type=int, default=Protocol.seeds, help="runs a cell (default %(default)s)")
    parser.add_argument("--limit", type=float,
                        help="seconds a run (default: 5, or 1000 times the adaptive planner's median if that is more)")
    parser.add_argument("--planner", action="append", metavar="NAME",
                        help="measure this planner only, and what sets its time limits (ompl:NAME: a peer); may be given again")
    parser.add_argument("--robot", default=experiments.ROBOT, help="of scenes (default %(default)s)")
    parser.add_argument("--quick", action="store_true",
                        help=f"{QUICK.seeds} seeds, {QUICK.limit:g} s a run, given up at once: shows that all of it "
                        "works, measures nothing; with files of its own")
    parser.add_argument("--cores", type=int, default=1, metavar="N",
                        help="measure on the last N cores at once, one timed program on each (default %(default)s)")
    parser.add_argument("--any-build", action="store_true",
                        help="accept what other builds of the programs or scenes have measured")
    parser.add_argument("--json", type=Path, help="also write the measured cells here")
    options = parser.parse_args(arguments)
    if options.seeds < 1 or (options.limit is not None and not options.limit > 0):
        parser.error("--seeds must be at least 1 and --limit above 0")
    available = len(os.sched_getaffinity(0))
    if not 1 <= options.cores <= available:
        parser.error(f"--cores must be between 1 and {available}, the cores there are")
    if options.planner and options.what in ("core", "readme", "results"):
        parser.error(f"--planner is not for {options.what}")
    if options.quick and options.what in ("readme", "results"):
        parser.error("--quick measures nothing that could stand in README.md or bench/RESULTS.md")
    return options


def measure(options, folder, cells):
    protocol = QUICK if options.quick else Protocol(seeds=options.seeds, limit=options.limit)
    with Journal(folder / "runs.jsonl") as journal:
        session = Session(folder, journal, protocol, Progress(), timing_cores(options.cores), options.any_build)
        session.measure_all(cells)
        if options.what in ("goals", "core", "all"):
            measure_parts(session, lambda text: print(text, file=sys.stderr))
        return Results(journal)


def only(cells, planners):
    names = {cell.planner for cell in cells}
    for name in planners:
        if name not in names:
            raise BadInput(f"--planner {name}: there is " + ", ".join(sorted(names)))
    return [cell for cell in cells if cell.planner in planners]


def earlier_table(path):
    """What the repository has on record; a machine that measures anew has no journal of it."""
    return json.loads(path.read_text()) if path.exists() else []


def run(options):
    folder = DATA / ("quick" if options.quick else "full")
    if options.what == "results":
        journal = Journal(folder / "runs.jsonl", writable=False)
        write_page(Results(journal, earlier_table(ROOT / "bench/results/cells.json")), ROOT / "bench")
        return
    if options.what == "readme":
        cells = readme.cells()
        readme.write_table(measure(options, folder, cells), ROOT / "README.md")
        return
    cells = [] if options.what == "core" else experiments.cells_of(options.what, options.robot)
    if options.planner:
        cells = only(cells, options.planner)
    results = measure(options, folder, cells)
    write_page(results, folder)
    if options.json:
        write(options.json, to_json(results.rows(cells)))
    print(f"tables and pictures: {os.path.relpath(folder / 'RESULTS.md')}")


def main():
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # SIGINT may be ignored: of a job in the background, it is
    try:
        run(parse(sys.argv[1:]))
    except (JournalError, BadInput) as error:
        print(f"bench/run: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nbench/run: broken off; the same command goes on from here", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
