# SPDX-License-Identifier: Apache-2.0
"""Which cells belong to which table or figure."""

from harness.cells import PEER, Cell

SCENES = ("openings", "gates", "rooms", "comb", "corridors")
IMPASSABLE = ("openings", "gates", "rooms", "comb")  # scenes with passages that are too narrow
ROBOT = "snake:15"

RIVALS = ("adaptive", "prior", "rrt")
VARIANTS = ("plain", "control", "adaptive-unpruned", "prior-unpruned", "paper")

LINKS = (5, 10, 15, 20, 25)
LONG_CHAIN = f"snake:{LINKS[-1]}"
SCALES = ("0.75", "1", "2", "3", "4")
SCALED_SCENE = "comb"  # the paper's figure 3(c)
PARAMETERS = {
    "alpha": ("2", "4", "8", "12", "16"),
    "beta": ("0.5", "0.65", "0.75", "0.85", "0.95"),
    "gamma": ("15", "20", "25", "50", "75", "100"),
    "kappa": ("1", "5", "10", "20", "30"),
}
DEFAULTS = {"alpha": "8", "beta": "0.85", "gamma": "20", "kappa": "10"}
REPAIR_KAPPAS = ("1", "20")  # paths repaired most often, and as often as the paper's
PARAMETERS_SCENE = "rooms"  # the paper's figure 3(b)

STEERED_PEERS = ("RRT", "KPIECE1", "EST", "PDST", "SST", "SyclopRRT", "SyclopEST", "SyclopRRT-grid", "SyclopEST-grid")
RANDOM_PEERS = tuple(
    f"{name}-random" for name in ("RRT", "KPIECE1", "EST", "PDST", "SST", "SyclopRRT", "SyclopEST")
)
PEERS = tuple(PEER + name for name in STEERED_PEERS + RANDOM_PEERS)

# The fastest of them in each scene.
FASTEST_PEERS = {
    "openings": "SyclopEST", "gates": "SyclopEST", "rooms": "KPIECE1", "comb": "SyclopEST", "corridors": "KPIECE1"
}

DYNOBENCH = ("dynobench/bugtrap_0", "dynobench/parallelpark_0")
MOVINGAI = ("movingai/arena", "movingai/den312d")


def scaled(scene, scale):
    return scene if scale == "1" else f"{scene}@{scale}"


def with_setting(name, value):
    settings = () if DEFAULTS[name] == value else (f"{name}={value}",)
    return Cell(PARAMETERS_SCENE, ROBOT, "adaptive", settings)


def scenes(robot=ROBOT):
    return [Cell(scene, robot, planner) for scene in SCENES for planner in RIVALS + VARIANTS]


def links():
    return [Cell(scene, f"snake:{n}", planner) for n in LINKS for scene in SCENES for planner in RIVALS]


def scale():
    """The table's, and the other scenes at the largest scale."""
    cells = [Cell(scaled(SCALED_SCENE, s), ROBOT, planner) for s in SCALES for planner in RIVALS]
    return cells + [Cell(scaled(scene, SCALES[-1]), ROBOT, "adaptive") for scene in SCENES if scene != SCALED_SCENE]


def parameters():
    return [with_setting(name, value) for name, values in PARAMETERS.items() for value in values]


def peers():
    return [Cell(scene, ROBOT, planner) for scene in SCENES for planner in ("adaptive", *PEERS)]


def foreign():
    cells = [Cell(problem, "unicycle1_v0", planner) for problem in DYNOBENCH for planner in RIVALS]
    return cells + [
        Cell(problem, robot, planner) for problem in MOVINGAI for robot in ("unicycle", "car") for planner in RIVALS
    ]


def goals():
    """What the goals over all scenes are held against, of the other experiments: few enough for many seeds at once."""
    cells = [Cell(scene, ROBOT, planner) for scene in SCENES for planner in ("adaptive", "plain", "prior")]
    cells += [Cell(scene, ROBOT, PEER + peer) for scene, peer in FASTEST_PEERS.items()]
    cells += [Cell(scaled(scene, SCALES[-1]), ROBOT, "adaptive") for scene in SCENES]
    cells += [Cell(scene, LONG_CHAIN, "adaptive") for scene in SCENES]
    return cells + [with_setting("kappa", value) for value in REPAIR_KAPPAS]


EXPERIMENTS = {
    "scenes": scenes,
    "links": links,
    "scale": scale,
    "parameters": parameters,
    "peers": peers,
    "foreign": foreign,
    "goals": goals,
}


def cells_of(what, robot=ROBOT):
    """The cells of an experiment, or of all, each once; the adaptive planner's first, since they set time limits."""
    if what == "all":
        cells = [cell for experiment in EXPERIMENTS.values() for cell in experiment()]
    else:
        cells = scenes(robot) if what == "scenes" else EXPERIMENTS[what]()
    return sorted(dict.fromkeys(cells), key=lambda cell: cell != cell.reference)
