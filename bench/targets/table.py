# SPDX-License-Identifier: Apache-2.0
"""The table of bench/targets/run: python3 bench/targets/table.py FOLDER [--print] [BUILD…]

FOLDER holds `scenes`, the scenes of the measurement one behind the other; the builds go there too."""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/targets"))
from flash import planner_flash  # noqa: E402

PAGE = ROOT / "bench/targets/RESULTS.md"
BEGIN, END = "<!-- targets -->", "<!-- end of targets -->"

CORES = {  # preset: what the table calls it, the machine that the presets' tests run on, prefix of its tools
    "cortex-m3": ("Cortex-M3, soft float", "mps2-an385", "arm-none-eabi-"),
    "cortex-m4f": ("Cortex-M4F", "mps2-an386", "arm-none-eabi-"),
    "cortex-m7": ("Cortex-M7", "mps2-an500", "arm-none-eabi-"),
    "cortex-m33": ("Cortex-M33", "mps2-an505", "arm-none-eabi-"),
    "cortex-m55": ("Cortex-M55", "mps3-an547", "arm-none-eabi-"),
    "rv32imafc": ("RV32IMAFC", "riscv32", "riscv64-unknown-elf-"),
    "rv64": ("RV64", "riscv64", "riscv64-unknown-elf-"),
}
BUILDS = [f"{preset}-Os" for preset in CORES] + ["cortex-m4f-O2", "cortex-m7-O2"]
ROBOTS = ["snake:5", "snake:15"]
BLOCKS = {"snake:5": "96K", "snake:15": "224K"}  # whose pools are shown
CHAIN_OF = "cortex-m7-Os"


def run(*command, **options):
    answer = subprocess.run([str(word) for word in command], cwd=ROOT, text=True, capture_output=True, **options)
    if answer.returncode != 0:
        sys.exit(f"bench/targets: {' '.join(map(str, command))} failed:\n{answer.stdout[-2000:]}{answer.stderr[-2000:]}")
    return answer.stdout


class Build:
    """The firmware for snakes and the meter, of one core at one optimisation."""

    def __init__(self, name, folder):
        preset, _, option = name.rpartition("-")
        self.core, self.machine, self.tools = CORES[preset]
        self.name, self.option = name, f"-{option}"
        self.folder, self.scenes = folder / name, folder / "scenes"
        self.firmware = self.folder / "bin" / f"{self.machine}-snake.elf"
        environment = dict(os.environ, CXXFLAGS=f"-{option} -DNDEBUG -fcallgraph-info=su", LDFLAGS="-Wl,-Map=bin")
        # ccache does not know of the files that -fcallgraph-info writes.
        run("cmake", "--preset", preset, "-B", self.folder, "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_COMPILER_LAUNCHER=",
            env=environment)
        run("cmake", "--build", self.folder, "--target", f"{self.machine}-snake", "meter")

    def flash(self, *files):
        """Bytes of code, constants and initial values."""
        rows = run(self.tools + "size", *files).splitlines()[1:]
        return sum(int(row.split()[0]) + int(row.split()[1]) for row in rows)

    def library_flash(self):
        return self.flash(self.folder / "lib" / "libkrait.a")

    def stack(self):
        return json.loads(run("python3", "tests/targets/stack.py", self.firmware, self.folder, "--json"))

    def static_bytes(self):
        """Initialised and zeroed data: everything in RAM besides stack and block."""
        rows = run(self.tools + "size", "-A", self.firmware).splitlines()
        return sum(int(row.split()[1]) for row in rows if re.match(r"\.s?(data|bss)\b", row))

    def meter(self, robot):
        command = f'source port/machines; find_machine {self.machine}; run_machine 900 "$@"'
        lines = run("bash", "-c", command, "meter", self.folder / "bin" / "meter.elf", self.scenes, "--robot", robot,
                    "--memory", BLOCKS[robot]).splitlines()
        return [json.loads(line) for line in lines if line.startswith("{")]


def most_placements(scenes, robot):
    """What krait info bounds the placements of one advance(1) by; the same for every scene."""
    info = run("build/host/bin/krait", "info", scenes.parent / "openings.krait", "--robot", robot)
    return int(re.search(r"at most (\d+) placements", info).group(1))


def bound_of_advance(build, robot, meter):
    """Instructions: the most placements, each as dear as the dearest seen, and a Dijkstra."""
    bound = most_placements(build.scenes, robot) * meter["placement_worst"] + meter["start_worst"]
    if meter["advance_worst"] > bound:
        sys.exit(f"bench/targets: {build.name} {robot}: a call took {meter['advance_worst']} instructions, above {bound}")
    return bound


def kilo(count):
    return f"{count / 1000:,.1f}"


def pair(numbers):
    return f"{kilo(numbers[0])} / {kilo(numbers[1])}"


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] + ["| " + " | ".join(row) + " |" for row in rows]


def size_table(builds):
    rows = []
    for build in builds:
        rows.append([f"{build.core}, {build.option}"] + [f"{count:,}" for count in (
            build.library_flash(), build.flash(build.firmware), planner_flash(build.firmware), build.static_bytes(),
            build.stack()["bytes"])])
    return table(["bytes", "library, all of it", "firmware", "planner in it", "static RAM", "worst-case stack"], rows)


def cost_tables(builds, meters):
    lines = []
    for robot in ROBOTS:
        first = meters[builds[0].name, robot][0]
        lines += ["", f"{robot}, thousands of instructions ({first['searches']} searches, {first['vertices']:,} vertices):", ""]
        rows = []
        for build in builds:
            m = meters[build.name, robot][0]
            rows.append([f"{build.core}, {build.option}", kilo(m["rk4"]), pair((m["vertex_median"], m["vertex_worst"])),
                         pair((m["advance_median"], m["advance_worst"])), kilo(bound_of_advance(build, robot, m)),
                         kilo(m["last_worst"])])
        lines += table(["median / worst", "Runge-Kutta step", "vertex, all in", "`advance(1)`", "its bound", "the last call"],
                       rows)
    return lines


def pool_table(build, meters):
    pools = {robot: meters[build.name, robot][1] for robot in ROBOTS}
    names = list(pools[ROBOTS[0]])
    rows = [[name] + [f"{pools[robot].get(name, 0):,}" for robot in ROBOTS] for name in names]
    return table(["pool, bytes"] + [f"{robot} in {BLOCKS[robot]}" for robot in ROBOTS], rows)


def chain(builds):
    deepest = next((build for build in builds if build.name == CHAIN_OF), builds[0])
    stack = deepest.stack()
    calls = ", ".join(f"`{name}` {frame}" for name, frame in stack["chain"])
    return [f"The chain that makes the stack's {stack['bytes']:,} bytes ({deepest.core}, {deepest.option}): {calls}, "
            f"and {stack['interrupt']} for an interrupt."]


def report(builds):
    meters = {(build.name, robot): build.meter(robot) for build in builds for robot in ROBOTS}
    for robot in ROBOTS:
        if len({meters[build.name, robot][0]["vertices"] for build in builds}) > 1:
            sys.exit(f"bench/targets: the builds grow different trees for {robot}: bash tests/targets/golden tells why")
    lines = size_table(builds) + [""] + chain(builds) + cost_tables(builds, meters)
    lines += ["", "How a block is spent in `openings`, on every machine alike:", ""] + pool_table(builds[0], meters)
    return lines


def write_page(lines):
    text = PAGE.read_text()
    if BEGIN not in text or END not in text:
        sys.exit(f"bench/targets/RESULTS.md lacks the marks {BEGIN} and {END}")
    before, rest = text.split(BEGIN, 1)
    after = rest.split(END, 1)[1]
    part = PAGE.with_suffix(".part")
    part.write_text(before + BEGIN + "\n" + "\n".join(lines) + "\n" + END + after)
    part.replace(PAGE)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--print", action="store_true", dest="only_print")
    parser.add_argument("builds", nargs="*", metavar="BUILD", help=", ".join(BUILDS))
    arguments = parser.parse_intermixed_args()
    for name in arguments.builds:
        if name.rpartition("-")[0] not in CORES:
            parser.error(f"'{name}' is no build: {', '.join(BUILDS)}")
    lines = report([Build(name, arguments.folder) for name in arguments.builds or BUILDS])
    print("\n".join(lines))
    if not arguments.only_print:
        write_page(lines)


if __name__ == "__main__":
    main()
