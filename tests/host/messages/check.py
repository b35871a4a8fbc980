#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds what the programs say where they say no against the table beside this, `messages`.

  python3 tests/host/messages/check.py BIN             runs each command of the table with the programs in BIN
  python3 tests/host/messages/check.py BIN --update    writes what they say into the table

A block of the table is a command, what it prints on both streams, and its exit code. Commands run in a folder that has
the files below. Exits 1 where a block differs, and prints how.
"""
import argparse
import difflib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

TABLE = pathlib.Path(__file__).parent / "messages"
ROOT = pathlib.Path(__file__).resolve().parents[3]  # $ROOT of the table's commands


def box(x, y, width, height):
    return {"box": {"center": [x, y], "size": [width, height], "angle": 0}}


def room(**changes):
    """20 m by 10 m, a wall with a door of 2 m, start "west", goal "east"."""
    return {
        "name": "room",
        "bounds": {"min": [0, 0], "max": [20, 10]},
        "obstacles": [box(10, 2, 1, 4), box(10, 8, 1, 4)],
        "goals": [{"name": "east", **box(17, 5, 2, 2)}],
        "starts": [{"name": "west", "position": [3, 5], "heading": 0}],
        **changes,
    }


def dock(**changes):
    return {"name": "dock", "position": [17, 5], "radius": 0.5, "heading": 1.5, **changes}


def map_server(resolution, key="resolution", indent=""):
    """A map_server map whose image is missing."""
    return (f"{indent}image: gone.pgm\n{key}: {resolution}\norigin: [0, 0, 0]\n"
            "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n")


FILES = {
    "room.json": room(),
    "narrow.json": room(obstacles=[box(10, 2.35, 1, 4.7), box(10, 7.65, 1, 4.7)]),
    "wall.json": room(obstacles=[box(10, 5, 1, 10)]),
    "full.json": room(obstacles=[box(10, 5, 20, 10)]),
    "crossed.json": room(obstacles=[{"polygon": [[5, 5], [6, 5]]}]),
    "unknown.json": room(obstacle=[]),
    "flat.json": room(bounds={"min": [0, 0], "max": [20, 0]}),
    "text.json": room(bounds={"min": ["a", 0], "max": [20, 10]}),
    "outside.json": room(starts=[{"name": "west", "position": [30, 5], "heading": 0}]),
    "two.json": room(starts=[{"name": "a", "position": [3, 5], "heading": 0}] * 2),
    "nostart.json": room(starts=[]),
    "nogoal.json": room(goals=[]),
    "degrees.json": room(starts=[{"name": "west", "position": [3, 5], "heading": 90}]),
    "point.json": room(goals=[{"name": "dock", "position": [17, 5], "radius": 0.5}]),
    "pose.json": room(goals=[dock()]),
    "loose.json": room(goals=[{"name": "east", **box(17, 5, 2, 2), "either_way": True}]),
    "turned.json": room(goals=[{"name": "east", **box(17, 5, 2, 2), "heading": 1}]),
    "wide.json": room(goals=[dock(heading_tolerance=10)]),
    "tank.json": {"model": "tank", "links": 0, "parameters": {}},
    "short.json": {"model": "car", "links": 0, "parameters": {"wheelbase": -1}},
    "centimetres.json": {"model": "car", "links": 0,
                         "parameters": {"body_length": 450, "body_width": 180, "wheelbase": 270}},
    "wheels.json": {"model": "car", "links": 0, "parameters": {"wheels": 4}},
    "fast.json": {"model": "truck", "links": 3, "parameters": {"hitch_length": 0.02, "max_speed": 20}},
    "lines.geojson": {"type": "FeatureCollection", "features": []},
}
TEXTS = {
    "broken.json": '{"name": "room", "bounds": ',
    "empty.json": "",
    "map.yaml": map_server(0.05),
    "scale.yaml": map_server(0),
    "typo.yaml": map_server(0.05, key="resolutoin"),
    "indent.yaml": map_server(0.05, indent=" "),
    "cut.map": "type octile\nheight 3\nwidth 3\nmap\n...\n.@.\n",
    "rooms.map": "type octile\nheight 9\nwidth 9\nmap\n" + "....@....\n" * 4 + ".........\n" + "....@....\n" * 4,
    "drawing.svg": "<svg><rect x='1'",
    "picture.bmp": "BM",
    "letter.txt": "Dear robot,\n",
}


def fill(folder, environment):
    for name, content in FILES.items():
        (folder / name).write_text(json.dumps(content))
    for name, content in TEXTS.items():
        (folder / name).write_text(content)
    for command in ["krait compile room.json -o room.krait",
                    "krait compile nostart.json -o nostart.krait",
                    "krait compile nogoal.json -o nogoal.krait",
                    "krait plan room.json --robot car --clearance 0.001 --improve 0 -o plan.json",
                    "head -c 400 room.krait >cut.krait"]:
        subprocess.run(["bash", "-c", command], cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)


def read_table():
    """Comments, and blocks as (command, what follows it)."""
    for block in TABLE.read_text().strip().split("\n\n"):
        first, *rest = block.split("\n")
        yield (first[2:], rest) if first.startswith("$ ") else (None, block.split("\n"))


def require_programs(programs, path):
    wanted = {command.split()[0] for command, _ in read_table() if command}
    absent = sorted(program for program in wanted if shutil.which(program, path=path) is None)
    if absent:
        sys.exit(f"{programs} has no {', '.join(absent)}: build it first (bash port/host/build --tests host)")


def answer(command, folder, environment):
    done = subprocess.run(["bash", "-c", "set -o pipefail; " + command], cwd=folder, env=environment, timeout=120,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.stdout.splitlines() + [f"exit {done.returncode}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path, metavar="BIN")
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    programs = options.programs.resolve()
    environment = {**os.environ, "ROOT": str(ROOT), "PATH": f"{programs}:{os.environ['PATH']}"}
    require_programs(programs, environment["PATH"])
    blocks, wrong = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        fill(folder, environment)
        for command, expected in read_table():
            if command is None:
                blocks.append("\n".join(expected))
                continue
            said = answer(command, folder, environment)
            blocks.append("\n".join(["$ " + command, *said]))
            if said != expected:
                wrong += 1
                print("$ " + command, *list(difflib.ndiff(expected, said)), sep="\n")
    if options.update:
        TABLE.write_text("\n\n".join(blocks) + "\n")
        return 0
    print(f"{wrong} of {len(blocks)} blocks differ" if wrong else "every message is as the table has it")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
