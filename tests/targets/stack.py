#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The most stack that a bare-metal program can ever use, and the chain of calls that does it.

  python3 tests/targets/stack.py PROGRAM.elf FOLDER [--json] [--limit BYTES]

FOLDER is the program's build folder, of Ninja. Every function's frame is what the compiler says (-fcallgraph-info=su: the
.ci files beside the objects). The calls are the compiler's and those that stand in the linked program, together. Functions that come without a .ci file (the C library's
and the compiler's own) are measured by their instructions. On top comes the deepest interrupt with the frame that the
processor pushes for it.

Exit code: 0 a bound, 1 above the limit, 2 there is no bound: recursion, a frame of unknown size, an indirect call whose
targets are not listed here, or a function that cannot be measured."""

import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys

RESET = "krait_reset"

# What an indirect call can reach: the folder or file of the source line that calls, and the targets by their C++ names,
# in which CALLED stands for the member that the line calls.
INDIRECT_CALLS = [
    ("krait/robot.hpp", r"krait::detail::FunctionsOf<.*>::CALLED\("),
    ("search/expander.hpp", r"bool krait::detail::Keeper::keep<krait::detail::AdaptiveSearch>\("),
    ("search/adaptive_search.cpp", r"krait::detail::\(anonymous namespace\)::CALLED\("),  # of departure.cpp
    ("last_metres/last_metres.cpp", r"krait::detail::\(anonymous namespace\)::CALLED\("),  # of parking.cpp
    ("krait/planner.hpp", r"no such function"),  # a firmware's search has nobody who watches
    ("port/firmware/", r"krait::bare_metal::(\(anonymous namespace\)::(clock|log|fault)|stack_bytes)\("),
    ("port/bare_metal/memory.cpp", r"_GLOBAL__sub_I_"),  # static constructors
]

# What may interrupt the program, and the bytes that the processor pushes: Armv7-M Architecture Reference Manual, B1.5.7,
# a basic frame of 8 words, with floating point 18 more, and a word of alignment, rounded up to 8 bytes. Faults take the
# whole stack for their report and do not return; RISC-V has traps only, which do the same.
INTERRUPTS = ["krait_systick"]
BASIC_FRAME, FLOATING_POINT_FRAME, ALIGNMENT = 32, 104, 8


class Unbounded(Exception):
    pass


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Program:
    """The functions of a linked program, by symbol: instructions, calls, and the bytes that its own pushes take."""

    def __init__(self, path):
        header = output_of("readelf", "-hA", path)
        self.arm = "ARM" in header
        self.floating_point = "Tag_ABI_VFP_args" in header
        tools = "arm-none-eabi-" if self.arm else "riscv64-unknown-elf-"
        symbols = [line.split() for line in output_of("nm", "-S", path).splitlines()]
        self.ends = {each[3]: int(each[0], 16) + int(each[1], 16) for each in symbols if len(each) == 4}
        self.code = {}
        self.disassemble(output_of(tools + "objdump", "-d", "--no-show-raw-insn", path))
        names = list(self.code)
        self.after = dict(zip(names, names[1:]))
        # By symbol, the one among those of the same address that the disassembly uses.
        used = {each[0]: each[-1] for each in symbols if each[-1] in self.code}
        self.alias = {each[-1]: used[each[0]] for each in symbols if each[0] in used}

    def disassemble(self, text):
        name = None
        for line in text.splitlines():
            label = re.match(r"[0-9a-f]+ <(.+)>:$", line)
            instruction = re.match(r"\s*([0-9a-f]+):\t(.*)", line)
            if label:
                name = label.group(1)
                self.code[name] = []
            elif instruction and int(instruction.group(1), 16) < self.ends.get(name, sys.maxsize):  # not the data behind it
                self.code[name].append(instruction.group(2))

    def calls(self, name):
        """Symbols that the function branches or falls through to."""
        targets = set()
        for instruction in self.code[name]:
            target = re.search(r"<([^>+]+)(\+0x[0-9a-f]+)?>", instruction)
            if target and re.match(r"[bcj]", instruction) and target.group(1) != name:
                targets.add(self.alias.get(target.group(1), target.group(1)))
        return targets

    def falls_through(self, name):
        """The next symbol, where the function's last instruction does not leave it: assembly with two entries."""
        ends = r"(b|b\.n|b\.w|bx|j|jr|tail)\s|ret|udf|(pop|ldmia).*pc|ldr\s+pc"
        code = [line for line in self.code[name] if not re.match(r"nop|\.|bl?\s.*fault|c?unimp", line)]
        return self.after.get(name) if code and not re.match(ends, code[-1]) else None

    def pushes(self, name):
        """Bytes, all pushes together: an upper bound, since no push of the libraries stands in a loop."""
        pushed_by = pushed_by_arm if self.arm else pushed_by_riscv
        return sum(pushed_by(instruction) for instruction in self.code[name])


def pushed_by_riscv(instruction):
    moved = re.match(r"addi?\s+sp,sp,(-?\d+)", instruction)
    if moved:
        return max(0, -int(moved.group(1)))
    if re.match(r"(add|sub|mv|l[wd])\S*\s+sp,", instruction):
        raise Unbounded(f"'{instruction}' moves the stack pointer")
    return 0


def pushed_by_arm(instruction):
    registers = re.match(r"v?(?:push|stmdb\s+sp!,|stmfd\s+sp!,)\S*\s*\{(.*)\}", instruction)
    if registers:
        return sum(register_bytes(part) for part in registers.group(1).split(","))
    moved = re.match(r"sub(?:\.w|w)?\s+sp,(?: sp,)? #(\d+)", instruction) or re.search(r"\[sp, #-(\d+)\]!", instruction)
    if moved:
        return int(moved.group(1))
    if re.match(r"(sub|mov|ldr)\S*\s+sp\b", instruction):
        raise Unbounded(f"'{instruction}' moves the stack pointer")
    return 0


def register_bytes(part):
    """Bytes of 'r4', 'd8' or 'd8-d15'."""
    first, _, last = part.strip().partition("-")
    count = int(last[1:]) - int(first[1:]) + 1 if last else 1
    return count * (8 if first.startswith("d") else 4)


class Compiled:
    """What the compiler says of its functions: frame, calls, and where it calls indirectly."""

    def __init__(self, path, folder, alias):
        self.alias = alias
        self.frames, self.unbounded = {}, {}
        self.calls, self.indirect = collections.defaultdict(set), collections.defaultdict(set)
        target = pathlib.Path(path).resolve().relative_to(pathlib.Path(folder).resolve())
        for source in output_of("ninja", "-C", folder, "-t", "inputs", str(target)).splitlines():
            if source.endswith(".obj"):
                said = pathlib.Path(folder, source).with_suffix(".ci")
                if not said.exists():
                    raise Unbounded(f"{said} is missing; build with -fcallgraph-info=su")
                self.read(said.read_text())

    def read(self, text):
        # A function that is private to its file stands as FILE:SYMBOL. Equal symbols are taken together.
        def symbol(title):
            name = title.rsplit(":", 1)[-1]
            return self.alias.get(name, name)

        for title, label in re.findall(r'node: \{ title: "([^"]+)" label: "([^"]*)"', text):
            frame = re.search(r"(\d+) bytes \(([\w,]+)\)", label)
            if not frame:
                continue
            name = symbol(title)
            self.frames[name] = max(self.frames.get(name, 0), int(frame.group(1)))
            if frame.group(2) == "dynamic":
                self.unbounded[name] = "its frame has no bound at compile time"
        for source, target, place in re.findall(
            r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"(?: label: "([^"]*)")?', text):
            if target == "__indirect_call":
                self.indirect[symbol(source)].add(place)
            else:
                self.calls[symbol(source)].add(symbol(target))


class Graph:
    """The program's call graph with a frame for every function."""

    def __init__(self, program, compiled):
        self.program, self.compiled = program, compiled
        names = list(program.code)
        plain = output_of_filter("c++filt", names)
        self.plain = dict(zip(names, plain))
        self.depths = {}

    def frame(self, name):
        if name in self.compiled.unbounded:
            raise Unbounded(f"{self.plain[name]}: {self.compiled.unbounded[name]}")
        if name in self.compiled.frames:
            return self.compiled.frames[name]
        try:
            return self.program.pushes(name)
        except Unbounded as reason:
            raise Unbounded(f"{self.plain[name]}: {reason}") from None

    def calls(self, name):
        linked = self.program.calls(name)
        if name not in self.compiled.frames:
            after = self.program.falls_through(name)
            return linked | ({after} if after else set())
        said = {target for target in self.compiled.calls[name] if target in self.program.code}
        return linked | said | self.indirect_calls(name)

    def indirect_calls(self, name):
        targets = set()
        for place in self.compiled.indirect[name]:
            listed = [pattern for folder, pattern in INDIRECT_CALLS if folder in place]
            if not listed:
                raise Unbounded(f"{self.plain[name]}: the indirect call at {place} is not listed")
            wanted = re.compile(listed[0].replace("CALLED", called_at(place)))
            targets |= {target for target, plain in self.plain.items() if wanted.match(plain)}
        return targets

    def depth(self, name, chain=()):
        """Bytes from the function's entry on, and the chain of functions that needs them."""
        if name in chain:
            raise Unbounded("recursion: " + " -> ".join(self.plain[n] for n in chain[chain.index(name):] + (name,)))
        if name not in self.program.code:
            raise Unbounded(f"{self.plain[chain[-1]]} calls {name}, which has no code")
        if name not in self.depths:
            below = [self.depth(callee, chain + (name,)) for callee in sorted(self.calls(name))]
            deepest, path = max(below, key=lambda each: each[0], default=(0, []))
            self.depths[name] = (self.frame(name) + deepest, [name] + path)
        return self.depths[name]


def called_at(place):
    """The member that is called through a pointer at FILE:LINE:COLUMN."""
    file, line, _ = place.rsplit(":", 2)
    source = pathlib.Path(file).read_text().splitlines()[int(line) - 1]
    return re.search(r"->(\w+)\(", source).group(1) if "->" in source else ""


def output_of_filter(tool, lines):
    return subprocess.run([tool], input="\n".join(lines), check=True, capture_output=True, text=True).stdout.splitlines()


def interrupt(graph):
    """Bytes of the deepest interrupt with its frame; 0 where there is none."""
    handlers = [name for name in INTERRUPTS if name in graph.program.code]
    if not handlers:
        return 0
    frame = (FLOATING_POINT_FRAME if graph.program.floating_point else BASIC_FRAME) + ALIGNMENT
    return frame + max(graph.depth(name)[0] for name in handlers)


def short(plain):
    """A C++ name without arguments and template arguments."""
    plain = re.sub(r"\(anonymous namespace\)::", "", plain)
    while re.search(r"<[^<>]*>", plain):
        plain = re.sub(r"<[^<>]*>", "", plain)
    return re.sub(r"\(.*", "", plain).split(" ")[-1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--limit", type=int, help="the most bytes that are allowed")
    arguments = parser.parse_args()
    try:
        program = Program(arguments.program)
        graph = Graph(program, Compiled(arguments.program, arguments.folder, program.alias))
        depth, path = graph.depth(RESET)
        on_top = interrupt(graph)
    except Unbounded as reason:
        print(f"stack: no bound: {reason}", file=sys.stderr)
        return 2
    total = depth + on_top
    chain = [(short(graph.plain[name]), graph.frame(name)) for name in path]
    if arguments.json:
        print(json.dumps({"bytes": total, "interrupt": on_top, "chain": chain}))
    else:
        print(f"{total} bytes: {on_top} for an interrupt, and")
        for name, frame in chain:
            print(f"{frame:6} {name}")
    if arguments.limit is not None and total > arguments.limit:
        print(f"stack: {total} bytes are more than {arguments.limit}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
