# SPDX-License-Identifier: Apache-2.0
"""Reads the symbols and sections of archives that are linked together, and complains about every sign of a heap,
exceptions, run-time types, thread-local storage, static constructors that do something, writable globals, or a library
beyond the short list.

  check.py --nm NM --objdump OBJDUMP ARCHIVE...    exit code 0: nothing found
"""
import argparse
import re
import subprocess
import sys

# What the core may ask of the C library and of the compiler's own.
ALLOWED = re.compile(r"""(
    mem(cpy|set|move|cmp) | strcmp | sqrtf | __popcount[ds]i2 | _GLOBAL_OFFSET_TABLE_
  | __aeabi_(mem(cpy|set|move|clr)[48]?|uldivmod|ldivmod|uidivmod|idivmod|uidiv|idiv|lmul|llsl|llsr|lasr|ul2f|l2f)
  | __stack_chk_(fail|guard)
)$""", re.VERBOSE)
# Eigen's assertions in a debug build for an operating system.
ASSERTION = re.compile(r"__assert_fail$")
# The scene's origin is double; only its checker may look.
DOUBLE = re.compile(r"__aeabi_(d\w+|f2d|ui2d|i2d)$")
DOUBLE_OBJECT = "checker.cpp"
# What the compiler's own library knows of the processor; only who chooses the lanes may ask.
PROCESSOR = re.compile(r"__cpu_model$")
PROCESSOR_OBJECT = "angles.cpp"

# Ours; of Eigen's and the standard library's templates what is not inlined, and placement new.
OURS = re.compile(r"_ZZ?NK?5krait|krait_")
TEMPLATES = re.compile(r"_ZZ?NK?(5Eigen|St)|_ZSt|_Znw[jm]Pv$|_ZdlPvS_$")

# Constants whose types keep them out of read-only memory; the constructors that fill them write only them.
CONSTANTS = re.compile(r"_ZN5krait5box2d11b2Vec2_zeroE|_ZN5EigenL(3all|4last|6lastp1|3fix\w+)E")

SECTIONS = re.compile(r"\.(ctors|dtors|preinit_array|fini_array|gcc_except_table|ARM\.extab|tdata|tbss)")


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def symbols(nm, archives):
    """(object, name, kind) of every symbol."""
    for line in output_of(nm, "-A", "-P", *archives):
        found = re.match(r".*\[(.*)\]: (\S+) (\S)", line)
        if found:
            yield found.groups()


def check_symbols(nm, archives):
    table = list(symbols(nm, archives))
    defined = {name for _, name, kind in table if kind not in "Uw"}
    if not any(OURS.match(name) for name in defined):
        yield f"{archives}: no symbol of krait: read wrongly?"
    for where, name, kind in table:
        if kind in "Uw":
            allowed = name in defined or any(known.match(name) for known in (ALLOWED, ASSERTION))
            allowed = allowed or (DOUBLE.match(name) and where.startswith(DOUBLE_OBJECT))
            allowed = allowed or (PROCESSOR.match(name) and where.startswith(PROCESSOR_OBJECT))
            if not allowed:
                yield f"{where}: asks for {name}"
        elif kind.isupper() or kind in "uvw":
            weak = kind in "VWuvw"
            if not OURS.match(name) and not (weak and TEMPLATES.match(name)):
                yield f"{where}: defines {name} ({kind})"


def check_sections(objdump, archives):
    where = "?"
    for line in output_of(objdump, "-h", "-t", *archives):
        member = re.match(r"(\S+):\s+file format", line)
        section = re.match(r"\s+\d+ (\.\S+)\s+([0-9a-f]+)", line)
        symbol = re.match(r"[0-9a-f]+ .{6}O (\S+)\s+[0-9a-f]+ (?:\.hidden )?(\S+)", line)
        if member:
            where = member.group(1)
        elif section and int(section.group(2), 16) > 0 and SECTIONS.match(section.group(1)):
            yield f"{where}: has a section {section.group(1)}"
        elif symbol:
            place, name = symbol.groups()
            writable = place.startswith((".data", ".bss", "*COM*")) and not place.startswith(".data.rel.ro")
            if writable and not CONSTANTS.match(name):
                yield f"{where}: has a writable {name} in {place}"


def check_constructors(nm, objdump, archives):
    """A static constructor may stand only where one of the constants does."""
    with_constants = {where for where, name, _ in symbols(nm, archives) if CONSTANTS.match(name)}
    where = "?"
    for line in output_of(objdump, "-h", *archives):
        member = re.match(r"(\S+):\s+file format", line)
        where = member.group(1) if member else where
        if re.match(r"\s+\d+ \.init_array", line) and where not in with_constants:
            yield f"{where}: has static constructors"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--nm", required=True)
    parser.add_argument("--objdump", required=True)
    parser.add_argument("archives", nargs="+")
    given = parser.parse_args()
    complaints = [
        *check_symbols(given.nm, given.archives),
        *check_sections(given.objdump, given.archives),
        *check_constructors(given.nm, given.objdump, given.archives),
    ]
    print("\n".join(complaints) if complaints else "nothing forbidden")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
