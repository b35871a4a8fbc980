#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether every file says under which licence it stands: in one of its first three lines, or, where it cannot, by the
list in REUSE.toml, which names no file that is gone. The scene compiler and what includes its headers stand under
GPL-3.0-or-later, as it links CGAL, everything else under Apache-2.0. Prints what breaks a rule. Exit code: 0 nothing
does, 1 something does."""
import argparse
import re
import subprocess
import sys
import tomllib
from pathlib import Path

APACHE, GPL = "Apache-2.0", "GPL-3.0-or-later"
COMPILER = "port/host/compiler/"


def files(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "-coz", "--exclude-standard"], check=True,
                            capture_output=True, text=True).stdout
    return sorted(name for name in listed.split("\0") if name and (root / name).is_file())


# A path of REUSE.toml: ** stands for anything, * for anything but a slash.
def pattern(path):
    parts = {"**": ".*", "*": "[^/]*"}
    return re.compile("".join(parts.get(part) or re.escape(part) for part in re.split(r"(\*\*|\*)", path)))


def annotations(root):
    for annotation in tomllib.loads((root / "REUSE.toml").read_text())["annotations"]:
        for path in annotation["path"]:
            yield path, pattern(path), annotation["SPDX-License-Identifier"]


def licence_in(text):
    found = re.search(r"SPDX-License-Identifier: ([\w.-]+)", "\n".join(text.split("\n", 3)[:3]))
    return found and found[1]


def of_compiler(name, text):
    return name.startswith(COMPILER) or re.search(r'^#include "host/compiler/', text, re.MULTILINE)


def complaints(root, names):
    listed = list(annotations(root))
    used = set()
    for name in names:
        if Path(name).name == "LICENSE":
            continue
        text = (root / name).read_bytes().decode(errors="replace")
        covering = [(path, licence) for path, matches, licence in listed if matches.fullmatch(name)]
        used |= {path for path, _ in covering}
        licence = licence_in(text) or next((licence for _, licence in covering), None)
        if licence is None:
            yield f"{name}: it has no line SPDX-License-Identifier, and REUSE.toml does not name it"
        elif licence not in (APACHE, GPL):
            yield f"{name}: {licence} is not a licence of krait"
        elif licence != GPL and of_compiler(name, text):
            yield f"{name}: it must stand under {GPL}, as the scene compiler does, and says {licence}"
    yield from (f"REUSE.toml: no file is {path}" for path, _, _ in listed if path not in used)


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    root = Path(__file__).resolve().parents[2]
    names = files(root)
    found = list(complaints(root, names))
    print("\n".join(found) if found else f"{len(names)} files say their licence")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
