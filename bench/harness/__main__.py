# SPDX-License-Identifier: Apache-2.0
"""bench/run's program."""

import os
import re
import signal
import sys
from dataclasses import replace
from pathlib import Path

from harness import experiments, readme
from harness.arguments import QUICK, parse
from harness.instructions import measure_instructions
from harness.journal import Journal, JournalError, merged
from harness.page import refuse_mixture, refuse_none, write_page
from harness.parts import measure_parts
from harness.problems import ROOT
from harness.progress import Progress
from harness.protocol import Protocol
from harness.results import Results
from harness.session import Session
from harness.tables import own_section, tuning_section
from harness.worker import BadInput, leave, timing_core

DATA = ROOT / "build/bench"
PUBLISHED = ROOT / "bench/results/runs.jsonl.xz"
PRINTED = {"own": own_section, "tuning": tuning_section}  # and in no page


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
    refuse_none(results)
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
