# SPDX-License-Identifier: Apache-2.0
"""bench/run's program."""

import argparse
import os
import re
import signal
import sys
from dataclasses import replace
from pathlib import Path

from harness import experiments, readme
from harness.instructions import measure_instructions
from harness.journal import Journal, JournalError, merged
from harness.page import refuse_mixture, write_page
from harness.parts import measure_parts
from harness.problems import ROOT
from harness.progress import Progress
from harness.protocol import Protocol, Shard
from harness.results import Results
from harness.session import Session
from harness.tables import own_section, tuning_section
from harness.worker import BadInput, leave, timing_core

DATA = ROOT / "build/bench"
PUBLISHED = ROOT / "bench/results/runs.jsonl.xz"
QUICK = Protocol(seeds=3, goal_seeds=3, queries=3, pilot_seeds=1, limit=1.0, give_up=1)

HELP = {
    "goals": "what the goals are held against, with most seeds",
    "foreign": "dynobench and MovingAI",
    "far": "goals at the far end of maps of 512 cells",
    "scenes": "the five scenes, every planner of krait",
    "ablations": "each addition to the paper off in turn",
    "links": "figure 4",
    "streets": "15, 20 and 25 links in a town quarter",
    "scale": "table 1",
    "parameters": "table 2",
    "peers": "OMPL",
    "tuning": "the peers' settings, each alone, on seeds from 1 on, in no page",
    "all": "all of these but tuning, the parts of a search, and its instructions",
    "own": "a map and a robot of yours: own MAP --robot ROBOT",
    "results": "write bench/RESULTS.md, bench/results and README's table of what was measured; with files: of these, "
    "the journals of shards",
}
PRINTED = {"own": own_section, "tuning": tuning_section}  # and in no page


def shard_of(text):
    found = re.fullmatch(r"(\d+)/(\d+)", text)
    shard = Shard(*map(int, found.groups())) if found else None
    if not shard or not 1 <= shard.index <= shard.count:
        raise argparse.ArgumentTypeError(f"{text}: must be I/N, the I-th of N shares")
    return shard


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="bench/run",
        description="Measures what the tables claim, round by round. What has been measured is not measured again: "
        "break off at any time, and the same command goes on.",
        epilog="WHAT is one of: " + "; ".join(f"{name}: {text}" for name, text in HELP.items()) + ".",
    )
    parser.add_argument("what", choices=list(HELP), metavar="WHAT", help="see below")
    parser.add_argument("files", nargs="*", type=Path, metavar="FILE", help="own: the map; results: journals")
    parser.add_argument("--seeds", type=int,
                        help=f"rounds (default {Protocol.seeds}, {Protocol.goal_seeds} of the cells of goals)")
    parser.add_argument("--limit", type=float,
                        help=f"seconds a run (default: {Protocol.least:g}, or {Protocol.factor:g} times the adaptive "
                        "planner's median if that is more)")
    parser.add_argument("--planner", action="append", metavar="NAME",
                        help="measure this planner only (ompl:NAME: a peer); may be given again")
    parser.add_argument("--robot", default=experiments.ROBOT, help="of own (default %(default)s)")
    parser.add_argument("--shard", type=shard_of, default=Shard(), metavar="I/N",
                        help="measure the I-th of N shares of the seeds; bench/README.md has how to spread them")
    parser.add_argument("--journal", type=Path, help="file of what was measured (default: in build/bench)")
    parser.add_argument("--quick", action="store_true",
                        help=f"{QUICK.seeds} rounds, {QUICK.limit:g} s a run, given up at once: shows that all of it "
                        "works, measures nothing; with files of its own")
    options = parser.parse_args(arguments)
    if (options.seeds is not None and options.seeds < 1) or (options.limit is not None and not options.limit > 0):
        parser.error("--seeds must be at least 1 and --limit above 0")
    if (options.what == "own") != (len(options.files) == 1) and options.what != "results":
        parser.error("own needs one MAP, and nothing else takes a file")
    if options.what == "results" and (options.planner or options.quick):
        parser.error("--planner and --quick are not for results")
    return options


def protocol_of(options):
    if options.quick:
        return QUICK
    protocol = Protocol(limit=options.limit, first_seed=1 if options.what == "tuning" else Protocol.first_seed)
    return replace(protocol, seeds=options.seeds, goal_seeds=options.seeds) if options.seeds else protocol


def only(cells, planners):
    names = {cell.planner for cell in cells}
    for name in planners:
        if name not in names:
            raise BadInput(f"--planner {name}: there is " + ", ".join(sorted(names)))
    return [cell for cell in cells if cell.planner in planners]


def folder_of(options):
    if options.what == "own":
        robot = re.sub(r"\W+", "-", options.robot)
        return DATA / f"own-{options.files[0].stem}-{robot}{'-quick' if options.quick else ''}"
    if options.quick:
        return DATA / "quick"
    return DATA / ("tuning" if options.what == "tuning" else "full")


def cells_of(options):
    if options.what != "own":
        return experiments.cells_of(options.what)
    [path] = options.files
    if not path.exists():
        raise BadInput(f"{path}: there is no such map")
    return experiments.own(path.resolve(), options.robot)


def measure(options):
    cells = cells_of(options)
    cells = only(cells, options.planner) if options.planner else cells
    folder, core, progress = folder_of(options), timing_core(), Progress()
    leave(core)
    with Journal(options.journal or folder / "runs.jsonl") as journal:
        with Session(folder, journal, protocol_of(options), progress, core, options.shard) as session:
            session.measure_all(cells, experiments.rounds(session.protocol))
            if options.what == "all" and options.shard.index == 1:
                measure_instructions(session, progress)
                measure_parts(session, progress)
        results = Results(journal.records)
    if options.what in PRINTED:
        print(PRINTED[options.what](results, cells), end="")
        return
    write_page(results, folder)
    print(f"what was found: {os.path.relpath(folder / 'RESULTS.md')}; bench/run results publishes it")


def publish(options):
    """Of the journals that are named, of the one in build, or of the published runs themselves."""
    usual = DATA / "full/runs.jsonl"
    files = options.files or [options.journal or (usual if usual.exists() else PUBLISHED)]
    records = merged([Journal(file, writable=False) for file in files])
    results = Results(records)
    refuse_mixture(results)
    write_page(results, ROOT / "bench", records)
    missing = readme.missing(results)
    if missing:
        print(f"README.md keeps its table: there is no solved run of {', '.join(missing)}")
    else:
        readme.write_table(results, ROOT / "README.md")


def main():
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # SIGINT may be ignored: of a job in the background, it is
    try:
        options = parse(sys.argv[1:])
        publish(options) if options.what == "results" else measure(options)
    except (JournalError, BadInput) as error:
        print(f"bench/run: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nbench/run: broken off; the same command goes on from here", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
