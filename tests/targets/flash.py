#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the planner takes of the flash of a linked firmware: what came out of the library, and the model's instance of
it. Reads the linker's map, PROGRAM.elf.map (LDFLAGS=-Wl,-Map=FOLDER). Prints the bytes, or with a limit whether they
keep it. Exit code: 0 they do, 1 they do not, 2 there is no map."""
import argparse
import re
import sys
from pathlib import Path

OWN = re.compile(r"lib/libkrait\.a\(|/firmware/.*/model\.cpp")  # objects, as the map names them


def planner_flash(program):
    """Bytes of code, constants and initial values."""
    text = Path(f"{program}.map").read_text().split("Linker script and memory map")[1]
    text = re.sub(r"\n (\.\S+)\n\s+0x", r"\n \1 0x", text)
    kinds = r"^ \.(?:text|rodata|data|srodata|sdata)\S*"
    sections = re.findall(kinds + r"\s+0x[0-9a-f]+\s+0x([0-9a-f]+)\s+(\S+)", text, re.M)
    return sum(int(size, 16) for size, source in sections if OWN.search(source))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", metavar="PROGRAM.elf")
    parser.add_argument("limit", nargs="?", type=int, help="bytes")
    options = parser.parse_args()
    program, limit = options.program, options.limit
    try:
        count = planner_flash(program)
    except OSError as error:
        print(f"{program}: no map: {error}", file=sys.stderr)
        sys.exit(2)
    if count == 0:
        print(f"{program}.map: nothing of the library is in it", file=sys.stderr)
        sys.exit(2)
    print(f"planner: {count} bytes of flash" + ("" if limit is None else f" of at most {limit}"))
    sys.exit(1 if limit is not None and count > limit else 0)


if __name__ == "__main__":
    main()
