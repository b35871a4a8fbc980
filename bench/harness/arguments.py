# SPDX-License-Identifier: Apache-2.0
"""bench/run's arguments. As a program it only looks whether they can be used, before anything is installed or built."""

import argparse
import re
import sys
from pathlib import Path

from harness import experiments
from harness.protocol import Protocol, Shard

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
    parser.add_argument("--robot", help=f"of own (default {experiments.ROBOT})")
    parser.add_argument("--shard", type=shard_of, default=Shard(), metavar="I/N",
                        help="measure the I-th of N shares of the seeds; bench/README.md has how to spread them")
    parser.add_argument("--journal", type=Path, help="file of what was measured (default: in build/bench)")
    parser.add_argument("--quick", action="store_true",
                        help=f"{QUICK.seeds} rounds, {QUICK.limit:g} s a run, given up at once: shows that all of it "
                        "works, measures nothing; with files of its own")
    options = parser.parse_intermixed_args(arguments)  # options may stand before the files, too
    if (options.seeds is not None and options.seeds < 1) or (options.limit is not None and not options.limit > 0):
        parser.error("--seeds must be at least 1 and --limit above 0")
    if (options.what == "own") != (len(options.files) == 1) and options.what != "results":
        parser.error("own needs one MAP, and nothing else takes a file")
    if options.what == "results":
        for name in ("seeds", "limit", "planner", "shard", "quick"):
            if getattr(options, name) != parser.get_default(name):
                parser.error(f"--{name} is not for results")
        if options.journal and options.files:
            parser.error("results reads either the journals that are named or that of --journal")
    if options.robot is not None and options.what != "own":
        parser.error("--robot is for own only: the experiments have robots of theirs")
    options.robot = experiments.ROBOT if options.robot is None else options.robot
    return options


if __name__ == "__main__":
    parse(sys.argv[1:])
