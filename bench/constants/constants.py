# SPDX-License-Identifier: Apache-2.0
"""What the library's constants are worth: each is varied alone, in a build of a copy of the library in which they are
variables, and the searches of fixed seeds are counted. Writes the table of bench/ABLATIONS.md, section "Constants";
with names of constants, their rows only. What is 5 % better in both halves of the seeds it reports on standard error.
--check compares the table with the sources instead, and looks for constants that are neither measured nor argued for;
exit code of that: 0 none, 1 some. --known only looks whether there are constants of these names; exit code: 0 there are,
2 there are not. The working folder is the project's."""
import argparse
import math
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

WORK = Path("build/bench/constants")
PAGE = Path("bench/ABLATIONS.md")
SCENES = ["openings", "gates", "rooms", "comb", "corridors"]
FIRST_SEED = 20_001
# What may be counted: the kind of count.cpp, its robots, and how many seeds.
FIVE = ["car", "reversing-car", "truck:2", "diff_drive", "snake:5"]
MEASURES = {
    "search": ("search", FIVE, 100),
    "backward": ("search", ["reversing-car", "unicycle"], 200),
    "pose": ("pose", FIVE, 100),
    "turning": ("pose", ["diff_drive", "unicycle"], 200),
    "straight": ("straight", ["truck:1", "truck:2"], 100),
    "improve": ("improve", FIVE, 50),
    "improve to poses": ("improve_pose", FIVE, 50),
    "improve by turns": ("improve_pose", ["diff_drive", "unicycle"], 100),
}

# By measure and file: the constants and, where half and twice are not the sensible neighbours, the factors.
CONSTANTS = {
    "search": {
        "include/krait/parameters.hpp": {
            "group_sample": (), "alpha": (), "beta": (0.824, 1.088), "epsilon": (), "gamma": (), "cost_length": (),
            "kappa": (), "max_steps": (), "open_steps": (0.04, 0.5), "path_regions": (), "path_lengths": (),
            "near_radius": (), "stray_share": (), "gentle_share": (), "sight_tries": (), "candidates": (),
            "least_sketch": (), "doomed_steps": (0.5, 1.5), "restart_unit": (), "slowest": (0.5, 0.75),
            "stopping_ways": (),
            "max_substeps": (), "kTreeSlack": ()},
        "lib/decomposition/regions.hpp": {"kMostAhead": (), "kMostRaised": (), "kRaiseReach": ()},
        "lib/search/search.hpp": {"kPatience": (), "kLeastCost": (), "kDepthKept": ()},
        "lib/search/search.cpp": {"kGentlest": ()},
        "lib/search/adaptive_search.hpp": {
            "kSketchTime": (), "kSketchRate": (), "kSightRoom": (0.8, 1.52), "kSightStep": ()},
        "lib/search/sketcher.hpp": {"kSteps": (), "kRoom": (0.963, 1.074)},
        "lib/search/expander.hpp": {"kOpen": (0, 2)},
        "lib/collision/sight.hpp": {"kMostLooks": ()},
        "lib/collision/obstacles.hpp": {"kLookBeyond": ()},
        "lib/collision/goal_room.cpp": {"kDeepest": (0.6, 1.4)}},
    "backward": {"include/krait/parameters.hpp": {"reverse_share": ()}},
    "pose": {
        "lib/last_metres/last_metres.hpp": {"kHold": (), "kEvery": (), "kMostShots": (), "kLook": ()},
        "lib/last_metres/last_metres.cpp": {
            "kRadii": (0.96, 1.5), "kCaptureRadii": (), "kCaptureLengths": (), "kLeads": (),
            "kDetour": (), "kDetourLengths": (), "kSightRoom": (0.5, 1.5), "kSightStep": (), "kMostLooks": (),
            "kLookSteps": (), "kOff": (), "kBraking": (), "kNearEnough": (), "kMostStops": ()},
        "lib/last_metres/nimbleness.cpp": {"kSettle": ()},
        "lib/last_metres/nimbleness.hpp": {"kSlowest": ()}},
    "turning": {
        "lib/last_metres/last_metres.hpp": {"kLongest": ()},
        "lib/last_metres/last_metres.cpp": {
            "kLeastRadius": (), "kTight": (), "kFaced": (), "kTurned": (), "kTurnLook": (), "kTurnCreep": ()}},
    "straight": {"lib/last_metres/last_metres.cpp": {"kHitchLeads": ()}},
    "improve": {
        "lib/improve/improver.hpp": {
            "kHold": (), "kAgain": (), "kTries": (), "kMostTries": (), "kReturns": (), "kStraightOn": (0.95, 1.0095),
            "kPast": (), "kAhead": (), "kAskew": (), "kPatience": (), "kNearer": (), "kAsNear": (), "kTakenAsNear": (),
            "kRounded": (0.5, 1.5), "kRunUp": (), "kTurning": (), "kMeasured": (),
            "kSearchAhead": (), "kSpacing": (), "kLeastDisc": (0.9, 1.3), "kMoreDisc": (), "kPullStep": (),
            "kBeforeFailure": (), "kAroundFailure": (), "kNearFailure": (), "kSpread": (), "kFar": ()},
        "lib/improve/taut_line.hpp": {"kPasses": (), "kNarrower": ()},
        "lib/improve/way_drive.hpp": {
            "kMostStuck": (), "kFurther": (), "kLeastShare": (0.94, 1.03)},
        "lib/improve/corners.hpp": {"kShare": (0.5, 0.75)},
        "lib/improve/corners.cpp": {
            "kLooks": (), "kCornerLooks": (), "kCircleLooks": (), "kLooksBefore": (), "kOutward": (), "kMostCut": (),
            "kSharpest": (), "kTurns": (0.5, 0.75), "kRound": (0.5, 1.3), "kVary": (0.8, 1.1), "kLeaveOut": (0.9, 1.1),
            "kInsert": (0.9, 1.2), "kWithNext": (), "kBeside": (), "kLittle": (), "kMuch": (), "kVaryMoved": ()}},
    "improve to poses": {
        "lib/improve/improver.hpp": {"kBraking": ()},
        "lib/improve/way_drive.hpp": {"kNextShots": (0.5, 1.5)}},
    "improve by turns": {
        "lib/improve/improver.hpp": {"kWorthBackwards": (), "kBackwards": (), "kNoShots": (), "kVaryShots": ()}},
}

# Those that follow from an argument, which stands beside them or here; all others of these folders and of SearchTuning
# are measured above or, as SECTIONS says, in a section of the page; or they are STEERING.
ARGUED = {
    "lib/search/search.hpp": ["kStartDepth"],
    "lib/search/disc_route.hpp": ["kReachRounding"],
    "lib/search/groups.cpp": ["kLeastBlockBits"],
    "lib/last_metres/dubins.cpp": ["kNoTurn"],
    "lib/last_metres/dubins.hpp": ["kMostPieces", "kDubinsWords"],
    "lib/last_metres/last_metres.hpp": ["kRadii", "kShortLeadCount", "kLeadCount"],
    "lib/last_metres/manoeuvre.hpp": ["kNoWay", "kShortening", "kMostShortenings"],
    "lib/last_metres/pull_outs.cpp": ["kSides", "kFarOut"],
    "lib/last_metres/pull_outs.hpp": ["kMostLooks"],
    "lib/search/recent_states.hpp": ["kCount"],
    # What 32 bits hold.
    "lib/search/restarts.hpp": ["kMostUnit"],
    "lib/improve/improver.hpp": ["kLeastVias", "kLeastPoints"],
    # Larger than any turn that matters, and than any way that is driven toward it.
    "lib/improve/improver.cpp": ["kStraightRadius", "kFarAway"],
    "lib/improve/corners.hpp": ["kShares"],
    "lib/collision/distance.cpp": ["kMaxRounds"],
    "lib/collision/goal_room.cpp": ["kDiagonal"],
    "lib/collision/obstacles.hpp": ["kRounding", "kPositionRounding", "kRelativeRounding"],
    "lib/scene/scene.cpp": ["kHeaderWords", "kOthers"],
    "lib/scene/cells.hpp": ["kMargin"],
    "lib/scene/grid_checker.cpp": ["kRounding", "kNear"],
    "lib/scene/checker.cpp": ["kMaxCount", "kMaxOrigin", "kCrcStart", "kBitsAtOnce", "kCrcTables", "kBitsMask",
                              "kTablesOfWord", "kWordsAtOnce", "kLeast"],
    # Where a triangle is not found in that many steps, its bucket is searched, which finds the same one.
    "lib/decomposition/locate.cpp": ["kMaxWalk"],
    # A power of two that a float's bits lead to; and how closely a report names a place, which no search asks for.
    "lib/decomposition/regions.cpp": ["kExactRatio", "kPoints"],
    # A packed byte's parts.
    "lib/decomposition/regions.hpp": ["kEdgeMask", "kNoEdge", "kListed", "kAround"],
    # Simpson's and Dekker's numbers; and from where on rounding is as large as what Simpson's rule corrects.
    "lib/motion/plan_drive.cpp": ["kSimpson", "kSplitter", "kSame", "kNear"],
    # A power of two, so that it rounds nothing; and shorter steps than the tree's, whatever the robot.
    "lib/motion/plan_drive.hpp": ["kMagnified", "kUnknownParts"],
    # Promised to users: Goal::deepest.
    "lib/decomposition/goal.cpp": ["kDeepestShare"],
    # They bound the error of a step, which tests hold (lib/DESIGN.md, "Integration"), and the work that keeps it.
    "lib/motion/rk4.hpp": ["kStepRate", "kPlanStepRate", "kFinePlanStepRate", "kMostParts", "kMostPlanParts"],
    # Promised to users: Parameters::end_speed; and at most a tenth of what a pose's tolerances leave.
    "lib/plan/ending.hpp": ["kRestSpeed", "kMostInside"],
    # A vertex, and parts of packed words.
    "lib/plan/motion_tree.hpp": ["kRoot", "kMostExpansions", "kMostSteps", "kUse", "kNoBranch"],
    # They bound how far a driven plan is from where its controls lead (lib/DESIGN.md, "Integration").
    "lib/plan/plan_proof.hpp": ["kDriveError", "kDriftShare", "kMostError", "kLarge", "kSpare"],
    # The largest numbers of 16 and 15 bits, and what rounds to the nearest.
    "lib/plan/target_grid.cpp": ["kParts", "kSpeedParts", "kHalf"],
    # No length; and memory against work: a state takes as much as a leg or two, and a leg is driven to find it again.
    "lib/plan/way.hpp": ["kOffRoute", "kLegsAState"],
    # Bounds on rounding and on Runge-Kutta's error, which the lemmas' tests hold, and a reserve of several of them.
    "lib/robot/chain.cpp": ["kHitchReserve", "kHitchError", "kRounding", "kNormError", "kMostReach", "kSteeringShare",
                            "kStages", "kMaxHeading"],
    "lib/robot/chain_sketch.cpp": ["kLittlePull"],
    # Controls of robots that hold still.
    "lib/robot/differential_drive.cpp": ["kStill"],
    "lib/robot/kinematic_truck.cpp": ["kCarState", "kNoControl"],
    # So much more than rounding that no state crosses its limit by it.
    "lib/robot/limits.hpp": ["kInside"],
    # As many trailers as the wheels can answer to (lib/robot/TRUCK.md, "Reverse").
    "lib/robot/pushing.hpp": ["kMostPushed"],
    # Promised to users: RobotModel, body(k).
    "lib/robot/shape.cpp": ["kLeastSide"],
    "lib/robot/shape.hpp": ["kMaxExtent"],
    # Keeps a division from zero.
    "lib/robot/truck.cpp": ["kLeast"],
}
# How the models are steered: gains and shares of their controllers, which are part of what a model is, as its page in
# lib/robot says, and are held by the tests of robots. They were found by driving and are not varied here.
STEERING = {
    "lib/robot/chain.cpp": ["kSpeedGains"],
    "lib/robot/differential_drive.cpp": ["kHeadingGains", "kCatchUp", "kCreep"],
    "lib/robot/front_wheels.hpp": ["kSteeringGains", "kCreep"],
    "lib/robot/unicycle.cpp": ["kHeadingGains"],
    "lib/robot/pushing.cpp": ["kNear", "kSharpest", "kLockShare", "kShortest", "kLongest", "kBack"],
    "lib/robot/tracking.hpp": ["kHeadingShare", "kSteps", "kShare"],
    "lib/robot/trailers.hpp": ["kUnfoldRate", "kFoldBound", "kLeastSpeed"],
    "lib/robot/turning.hpp": ["kSteered", "kTurnBrake", "kTurnTimes"],
}
SECTIONS = {
    "include/krait/parameters.hpp": ["update_regions", "goal_near_radius", "stuck_expansions"],
    "lib/search/departure.cpp": ["kAway"],
    "lib/search/search.hpp": ["kUnitRegions", "kShortestTry"],
    "lib/improve/corners.cpp": ["kTrailerCut"],
    "lib/improve/improver.hpp": ["kFromStart", "kKeep", "kLongChain", "kSearches", "kShortcut", "kTakeShortcut",
                                 "kOtherShots", "kLeastArcs", "kMoreArcs", "kLeastLeads", "kMoreLeads"],
    "lib/last_metres/last_metres.hpp": ["kMostLegs"],
    "lib/last_metres/last_metres.cpp": ["kMoveRadius", "kShortCost", "kNearMoveEnd"],
    "lib/robot/front_wheels.hpp": ["kPast"],
    "lib/robot/pushing.cpp": ["kFading"],
    "lib/robot/truck.cpp": ["kLag"],
    "lib/last_metres/docking.cpp": ["kHoldWay", "kPushLook", "kMostPush", "kStages", "kSwingRadius", "kSwings",
                                    "kSwingAim", "kSwingTilt", "kDrawStep", "kMostSteps", "kFold",
                                    "kStraightEnough"],
    "lib/last_metres/manoeuvre.cpp": ["kMoveBraking", "kOutBraking", "kOutSlowest", "kAstray", "kGrip", "kLeastTurn",
                                     "kStill", "kMostWait", "kMostMoveStops"],
    "lib/last_metres/pull_outs.hpp": ["kMost", "kMostMoves"],
    "lib/last_metres/pull_outs.cpp": ["kStep", "kStraights", "kOut", "kMostTurn", "kMostMoveSteps", "kRooms",
                                      "kWider", "kGearCost", "kStrides"],
}


@dataclass
class Constant:
    measure: str
    file: str
    name: str
    text: str  # its value, as the source has it
    factors: tuple

    @property
    def key(self):
        return f"{Path(self.file).name} {self.name}"

    @property
    def title(self):
        return f"| `{self.name}`, {Path(self.file).name} | {self.measure}"

    @property
    def begin(self):  # of its row
        return f"{self.title} | {self.value(1)} |"

    def value(self, factor):
        return ", ".join(shown(float(number) * factor, "F" in self.text) for number in NUMBER.findall(self.text))


NUMBER = re.compile(r"-?\d[\d.e-]*(?=F?\b)")


def shown(number, real):
    return f"{number:.3g}" if real else str(math.floor(number + 0.5))


def definition(name):
    return re.compile(rf"((?:static |inline )?)(constexpr )?([\w:]+)( {name}(?:\[\w*\])? = )([^;]+);")


def listed():
    found = []
    for measure, files in CONSTANTS.items():
        for file, names in files.items():
            for name, factors in names.items():
                text = definition(name).search(Path(file).read_text()).group(5)
                found.append(Constant(measure, file, name, text, factors or (0.5, 2)))
    return found


# The definition of a constant, as a variable that is multiplied by a factor of the environment.
def make_variable(source, constant):
    def varied(match):
        storage, fixed, kind, name, value = match.groups()
        number = "float" if kind == "Span" else kind
        value = re.sub(r"(-?\d[\d.e-]*F?)\b", rf'krait::bench::varied<{number}>("{constant.key}", \1)', value)
        if storage == "static ":
            storage = "static inline "
        return f"{storage}{'const ' if fixed else ''}{kind}{name}{value};"
    source, count = definition(constant.name).subn(varied, source)
    assert count == 1, constant
    return re.sub(rf"\[{constant.name}\];", f"[2 * ({constant.text})];", source)


def adapt(path, pattern, replacement):
    path.write_text(re.sub(pattern, replacement, path.read_text()))


def build(constants):
    copy = WORK / "library"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree("lib", copy / "lib")
    shutil.copytree("include", copy / "include")
    shutil.copy("CMakeLists.txt", copy)
    for constant in constants:
        path = copy / constant.file
        source = make_variable(path.read_text(), constant)
        if "constants/varied.hpp" not in source:
            source = '#include "varied.hpp"  // constants/varied.hpp\n' + source
        path.write_text(source)
    adapt(copy / "lib/search/search.hpp", r"inline constexpr Parameters", "inline const Parameters")
    adapt(copy / "include/krait/planner.hpp", r"kSearchBytes = (.+);", r"kSearchBytes = 4096 + (\1);")
    quietly = {"check": True, "stdout": subprocess.DEVNULL}
    box2d = os.environ.get("KRAIT_BOX2D_SOURCE", Path("build/deps/box2d").resolve())
    subprocess.run(["cmake", "-S", "bench/constants", "-B", WORK / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    f"-DVARIED={copy.resolve()}", f"-DKRAIT_BOX2D_SOURCE={box2d}"], **quietly)
    subprocess.run(["cmake", "--build", WORK / "build"], **quietly)


# By scene and robot: a number for each seed.
def counts(measure, constant=None, factor=1.0):
    kind, robots, seeds = MEASURES[measure]
    environment = dict(os.environ)
    if constant:
        environment |= {"KRAIT_CONSTANT": constant.key, "KRAIT_FACTOR": repr(factor)}
    output = subprocess.run([WORK / "build/count", kind, ",".join(robots), str(FIRST_SEED), str(FIRST_SEED + seeds - 1),
                             *[WORK / f"{scene}.krait" for scene in SCENES]],
                            env=environment, check=True, capture_output=True, text=True).stdout
    return {tuple(line.split()[:2]): [int(x) for x in line.split()[2:]] for line in output.splitlines()}


def quantile(values, share):
    return sorted(values)[int((len(values) - 1) * share)]


# Geometric mean over scenes and robots of how much a quantile of some of the seeds has grown.
def ratio(varied, normal, share, seeds=slice(None)):
    logs = [math.log(quantile(varied[cell][seeds], share) / quantile(normal[cell][seeds], share)) for cell in normal]
    return math.exp(sum(logs) / len(logs))


def cell(constant, factor, normal):
    varied = counts(constant.measure, constant, factor)
    if varied == normal:
        return f"{constant.value(factor)}: the same"
    half = MEASURES[constant.measure][2] // 2
    halves = [[ratio(varied, normal, share, part) for part in (slice(half), slice(half, None))] for share in (0.5, 0.9)]
    if any(max(pair) <= 0.95 for pair in halves):
        print(f"better in both halves of the seeds: {constant.key} {constant.value(factor)}: {halves}", file=sys.stderr)
    return f"{constant.value(factor)}: {ratio(varied, normal, 0.5):.2f} / {ratio(varied, normal, 0.9):.2f}"


def rows(constants):
    normal = {measure: counts(measure) for measure in dict.fromkeys(constant.measure for constant in constants)}
    for constant in constants:
        cells = " | ".join(cell(constant, factor, normal[constant.measure]) for factor in constant.factors)
        yield f"{constant.begin} {cells} |"


# Puts rows in the place of those that begin likewise, in the order of the constants.
def write(constants, measured):
    page = PAGE.read_text()
    before, mark, rest = page.partition("<!-- constants -->\n")
    table, end, after = rest.partition("<!-- end of constants -->")
    known = {row.rsplit(" | ", 3)[0]: row for row in [*table.splitlines(), *measured]}
    lines = ["| constant | counted | value | less | more |", "|---|---|---|---|---|"]
    lines += [known[constant.title] for constant in constants if constant.title in known]
    PAGE.write_text(before + mark + "".join(line + "\n" for line in lines) + end + after)


# What is defined in the folders of whose constants this file has every one, by file.
def defined():
    number = r"(?:float|double|int|Span|Index|PidGains|std::(?:u?int\d+|size)_t)"
    for folder in ("decomposition", "robot", "motion", "collision", "scene", "plan", "last_metres", "improve",
                   "search"):
        for path in sorted(Path("lib", folder).glob("*.[ch]pp")):
            for name in re.findall(rf"constexpr {number} (\w+)(?:\[\w*\])?(?: =|{{)", path.read_text()):
                yield str(path), name
    parameters = Path("include/krait/parameters.hpp")
    tuning = parameters.read_text().partition("struct SearchTuning {")[2].partition("\n};")[0]
    for name in [*re.findall(rf"^  {number} (\w+) = ", tuning, re.MULTILINE), "kTreeSlack"]:
        yield str(parameters), name


def check(constants):
    page = PAGE.read_text()
    wrong = [f"{PAGE} has no row that begins with {constant.begin}" for constant in constants
             if constant.begin not in page]
    found = set(defined())
    known = {(constant.file, constant.name) for constant in constants}
    known |= {(file, name) for listed_ones in (ARGUED, SECTIONS, STEERING) for file, names in listed_ones.items()
              for name in names}
    wrong += [f"{file}: {name} is not in bench/constants/constants.py" for file, name in sorted(found - known)]
    wrong += [f"{file} has no {name}, which is in bench/constants/constants.py" for file, name in sorted(known - found)]
    print("\n".join(wrong) if wrong else f"{len(known)} constants are measured, argued for or a robot's steering")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--known", action="store_true")
    options = parser.parse_args()
    constants, names = listed(), options.names
    known = {constant.name for constant in constants}
    for name in names:
        if name not in known:
            parser.error(f"'{name}' is no constant: {', '.join(sorted(known))}")
    if options.known:
        return 0
    if options.check:
        return check(constants)
    WORK.mkdir(parents=True, exist_ok=True)
    build(constants)
    measured = []
    for row in rows([constant for constant in constants if not names or constant.name in names]):
        print(row, flush=True)
        measured.append(row)
    write(constants, measured)
    return 0


if __name__ == "__main__":
    sys.exit(main())
