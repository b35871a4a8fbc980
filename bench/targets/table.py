# SPDX-License-Identifier: Apache-2.0
"""The tables of bench/targets/run: python3 bench/targets/table.py FOLDER [--print] [--improve] [BUILD…]

FOLDER holds `scenes`, the scenes of the measurement one behind the other; the builds go there too."""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/targets"), str(ROOT / "bench")]
from flash import planner_flash  # noqa: E402
from harness import machine  # noqa: E402
from harness.prose import wrapped  # noqa: E402

PAGE = ROOT / "bench/targets/RESULTS.md"
MARKS = ("<!-- targets -->", "<!-- end of targets -->")
IMPROVE_MARKS = ("<!-- improve -->", "<!-- end of improve -->")

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
IMPROVE_BUILD, IMPROVE_MACHINE = "cortex-m4f-Os", "netduinoplus2"  # improve_meter is for this machine


def run(*command, **options):
    answer = subprocess.run([str(word) for word in command], cwd=ROOT, text=True, capture_output=True, **options)
    if answer.returncode != 0:
        sys.exit(f"bench/targets: {' '.join(map(str, command))} failed:\n{answer.stdout[-2000:]}{answer.stderr[-2000:]}")
    return answer.stdout


class Build:
    """Programs of one core at one optimisation."""

    def __init__(self, name, folder):
        preset, _, option = name.rpartition("-")
        self.core, self.machine, self.tools = CORES[preset]
        self.name, self.option = name, f"-{option}"
        self.folder, self.scenes = folder / name, folder / "scenes"
        self.firmware = self.folder / "bin" / f"{self.machine}-snake.elf"
        self.environment = dict(os.environ, CXXFLAGS=f"-{option} -DNDEBUG -fcallgraph-info=su", LDFLAGS="-Wl,-Map=bin")

    def make(self, *targets, whole="ON"):
        preset = self.name.rpartition("-")[0]
        # ccache does not know of the files that -fcallgraph-info writes.
        run("cmake", "--preset", preset, "-B", self.folder, "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_COMPILER_LAUNCHER=",
            f"-DKRAIT_IMPROVE={whole}", f"-DKRAIT_REASONS={whole}", env=self.environment)
        run("cmake", "--build", self.folder, "--target", *targets)

    def make_snake(self):
        """The firmware for snakes and the meter, after the firmware that only plans was measured."""
        self.make(f"{self.machine}-snake", whole="OFF")
        self.first_only = self.firmware_sizes()
        self.make(f"{self.machine}-snake", "meter")

    def firmware_sizes(self):
        """Bytes of flash: the firmware's, and the planner's in it."""
        return self.flash(self.firmware), planner_flash(self.firmware)

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

    def answers(self, machine, program, *words):
        """The lines of JSON that a program prints."""
        command = f'source port/machines; find_machine {machine}; run_machine 900 "$@"'
        lines = run("bash", "-c", command, "meter", self.folder / "bin" / program, self.scenes, *words).splitlines()
        return [json.loads(line) for line in lines if line.startswith("{")]

    def meter(self, robot):
        return self.answers(self.machine, "meter.elf", "--robot", robot, "--memory", BLOCKS[robot])


def most_placements(scenes, robot):
    """What krait info bounds the placements of one advance(1) by; the same for every scene."""
    info = run("build/host/bin/krait", "info", scenes.parent / "openings.krait", "--robot", robot)
    return int(re.search(r"at most (\d+) placements", info).group(1))


def bound_of_advance(build, robot, meter):
    """Instructions: the most placements, each as expensive as the worst one seen, and a Dijkstra."""
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
            build.library_flash(), *build.firmware_sizes(), *build.first_only, build.static_bytes(),
            build.stack()["bytes"])])
    return table(["bytes", "library, all of it", "firmware", "planner in it", "firmware that only plans",
                  "planner in it", "static RAM", "worst-case stack"], rows)


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


def bound_of_improve(build, meter):
    """Instructions: the most placements of an iteration, each as expensive as the most expensive seen, and two Dijkstras."""
    bound = most_placements(build.scenes, meter["robot"]) * meter["placement_worst"] + 2 * meter["start_worst"]
    if max(meter["iteration_worst"], meter["first_worst"]) > bound:
        sys.exit(f"bench/targets: {meter['robot']}: an iteration took {meter['iteration_worst']} instructions, above {bound}")
    return bound


def improve_report(folder):
    """The table of improvement, of one build."""
    build = Build(IMPROVE_BUILD, folder)
    build.make("improve_meter")
    meters = build.answers(IMPROVE_MACHINE, "improve_meter.elf")
    first = meters[0]
    rows = []
    for m in meters:
        rows.append([m["robot"], f"{m['iterations']:,}", pair((m["iteration_median"], m["iteration_worst"])),
                     kilo(bound_of_improve(build, m)), kilo(m["first_worst"]), kilo(m["search"] / m["searches"]),
                     kilo(m["improve"] / m["solved"]), f"{100 * (1 - m['steps_best'] / m['steps_first']):.0f} %"])
    head = ["median / worst", "iterations", "`improve(1)`", "its bound", "the first call", "search, mean",
            "improvement, mean", "fewer steps"]
    return [f"Improvement in {first['block'] // 1024}K on the model of an STM32F405 ({build.core}, {build.option}), "
            f"thousands of instructions ({first['searches']} searches, each plan improved by ten times its collision "
            "checks):", ""] + table(head, rows)


def report(builds):
    for build in builds:
        build.make_snake()
    meters = {(build.name, robot): build.meter(robot) for build in builds for robot in ROBOTS}
    for robot in ROBOTS:
        if len({meters[build.name, robot][0]["vertices"] for build in builds}) > 1:
            sys.exit(f"bench/targets: the builds grow different trees for {robot}: bash tests/targets/golden tells why")
    lines = size_table(builds) + [""] + chain(builds) + cost_tables(builds, meters)
    lines += ["", "How a block is spent in `openings`, on every machine alike:", ""] + pool_table(builds[0], meters)
    return lines


def write_page(marks, lines):
    begin, end = marks
    text = PAGE.read_text()
    if begin not in text or end not in text:
        sys.exit(f"bench/targets/RESULTS.md lacks the marks {begin} and {end}")
    before, rest = text.split(begin, 1)
    after = rest.split(end, 1)[1]
    part = PAGE.with_suffix(".part")
    part.write_text(before + begin + "\n" + wrapped("\n".join(lines)) + "\n" + end + after)
    part.replace(PAGE)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--print", action="store_true", dest="only_print")
    parser.add_argument("--improve", action="store_true", help="the table of improvement only")
    parser.add_argument("--only-parse", action="store_true", help="only look whether the arguments can be used")
    parser.add_argument("builds", nargs="*", metavar="BUILD", help=", ".join(BUILDS))
    arguments = parser.parse_intermixed_args()
    for name in arguments.builds:
        if name.rpartition("-")[0] not in CORES:
            parser.error(f"'{name}' is no build: {', '.join(BUILDS)}")
    if arguments.only_parse:
        return
    parts = {}
    if not arguments.improve:
        parts[MARKS] = report([Build(name, arguments.folder) for name in arguments.builds or BUILDS])
    if arguments.improve or not arguments.builds:
        parts[IMPROVE_MARKS] = improve_report(arguments.folder)
    for lines in parts.values():
        lines += ["", f"Measured at commit {machine.commit()}."]
    for marks, lines in parts.items():
        print("\n".join(lines))
        if not arguments.only_print:
            write_page(marks, lines)


if __name__ == "__main__":
    main()
