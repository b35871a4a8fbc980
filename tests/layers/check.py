#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether the includes follow the layers: no file and no folder, of tests and bench as well, includes itself, directly or
round about; the core includes nothing of the workstation, none of the core's layers includes one above it, what is
installed is what the list here says, and no header that is installed includes one that is not. Prints what breaks a
rule. Exit code: 0 none does, 1 some do."""
import argparse
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

# Of the core, the lowest first: folders and files directly under include/krait and lib.
LAYERS = [
    "version", "math", "geometry", "status", "base", "format", "parameters", "scene", "goal",
    "decomposition", "robots", "robot", "motion", "collision", "plan", "last_metres", "improve", "planner", "search",
    "robot_check", "krait", "c",
]
# What is installed under include/krait. Its headers are layers one by one, and the folder robots is one, too: its
# headers stand on geometry.hpp, and robot.hpp and krait.hpp stand on them.
PUBLIC = {
    "krait.hpp", "krait.h", "version.h", "status.hpp", "scene.hpp", "goal.hpp", "parameters.hpp", "robot.hpp",
    "planner.hpp", "plan.hpp", "robot_check.hpp",  # what programs name
    "math.hpp", "geometry.hpp", "format.hpp",  # what these stand on
    "robots/all.hpp",  # and the headers that it includes, of a model each
    "robots/chain.hpp", "robots/planar.hpp", "robots/fields.hpp",  # what some robots share
    "robots/model.hpp",  # what the author of a robot writes to
    "robots/detail/defaults.hpp", "robots/detail/functions.hpp",  # what such a robot is compiled with
}
ENTRANCES = ["krait.hpp", "krait.h", "robot_check.hpp"]  # what a user's program includes, under include/krait
SEARCHED = ["include", "lib", "port", "bench", "tests"]
# What #include "…" is relative to, beside the including file's folder.
RELATIVE_TO = [*SEARCHED, ".", "bench/constants", "tests/campaign", "tests/consumer/c", "tests/consumer/firmware",
               "tests/core", "tests/host/compiler", "tests/host/rivals"]
CORE = ("include", "lib")


def sources(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "-co", "--exclude-standard", *SEARCHED],
                            check=True, capture_output=True, text=True).stdout.split()
    return {name for name in listed if name.endswith((".hpp", ".cpp", ".h", ".c")) and (root / name).exists()}


def includes(root, names):
    found = []  # (including file, included file)
    for name in sorted(names):
        for path in re.findall(r'^\s*#\s*include "([^"]+)"', (root / name).read_text(), re.MULTILINE):
            beside = str(Path(name).parent / path)
            for candidate in [beside, *(str(Path(folder) / path) for folder in RELATIVE_TO)]:
                if candidate in names:
                    found.append((name, candidate))
                    break
    return found


# The name of a core file's layer; None for any other file.
def layer(name):
    parts = Path(name).parts
    if parts[0] not in CORE:
        return None
    inner = parts[2:] if parts[0] == "include" else parts[1:]
    return Path(inner[0]).stem


# A folder of the core has its headers under include/krait and its sources under lib.
def folder(name):
    own = layer(name)
    return str(Path(name).parent) if own is None else f"core/{own}"


def cycle(edges):
    following = defaultdict(list)
    for a, b in edges:
        if a != b:
            following[a].append(b)
    done = set()

    def walk(node, path):
        if node in path:
            return path[path.index(node):] + [node]
        if node in done:
            return None
        for after in following[node]:
            found = walk(after, path + [node])
            if found:
                return found
        done.add(node)
        return None

    for node in sorted(following):
        found = walk(node, [])
        if found:
            return found
    return None


def complaints(pairs):
    for a, b in pairs:
        own, other = layer(a), layer(b)
        for name, of in ((a, own), (b, other)):
            if of is not None and of not in LAYERS:
                yield f"{name}: the layer {of} is not in the list of tests/layers/check.py"
                return
        if own is not None and other is None:
            yield f"{a} includes {b}: the core must include nothing of {Path(b).parts[0]}"
        elif own is not None and LAYERS.index(other) > LAYERS.index(own):
            yield f"{a} includes {b}: {own} lies below {other}"
    for what, edges in (("files", pairs), ("folders", [(folder(a), folder(b)) for a, b in pairs])):
        found = cycle(edges)
        if found:
            yield f"{what} include each other: " + " -> ".join(found)
            for a, b in zip(found, found[1:]):
                yield from (f"  {x} includes {y}" for x, y in pairs if what == "folders" and (folder(x), folder(y)) == (a, b))


# What a user includes is reached from the entrances and reaches nothing else; what stands in lib is krait::detail.
def complaints_of_the_face(root, names, pairs):
    public = {name for name in names if name.startswith("include/")}
    installed = {name.removeprefix("include/krait/") for name in public}
    robots = {b.removeprefix("include/krait/") for a, b in pairs if a == "include/krait/robots/all.hpp"}
    for name in sorted(installed ^ (PUBLIC | robots)):
        what = "is not in the list" if name in installed else "is missing, but in the list"
        yield f"include/krait/{name}: it {what} of tests/layers/check.py"
    yield from (f"{a} includes {b}: what is installed must not include what is not"
                for a, b in pairs if a in public and b not in public)
    reached, found = set(), {f"include/krait/{name}" for name in ENTRANCES}
    while found:
        reached |= found
        found = {b for a, b in pairs if a in found} - reached
    yield from (f"{name}: neither of {', '.join(ENTRANCES)} includes it" for name in sorted(public - reached))
    for name in sorted(names):
        if name.startswith("lib/") and name.endswith(".hpp") and not name.startswith("lib/c/"):
            if not re.search(r"^namespace krait::(detail|box2d)\b", (root / name).read_text(), re.MULTILINE):
                yield f"{name}: it is internal, and must stand in krait::detail"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", nargs="?", type=Path, default=Path(__file__).parents[2], help="default: the project's")
    root = parser.parse_args().root.resolve()
    names = sources(root)
    pairs = includes(root, names)
    if len(pairs) < 100:
        sys.exit(f"{root}: only {len(pairs)} includes were found, which cannot be all")
    found = list(complaints(pairs)) + list(complaints_of_the_face(root, names, pairs))
    print("\n".join(found) if found else f"{len(pairs)} includes follow the layers")
    sys.exit(1 if found else 0)


main()
