# SPDX-License-Identifier: Apache-2.0
"""Which cells belong to which table or figure."""

from harness.cells import FRESH, PEER, Cell
from harness.problems import DYNOBENCH, FAR, MOVINGAI, OWN

SCENES = ("openings", "gates", "rooms", "comb", "corridors")
IMPASSABLE = ("openings", "gates", "rooms", "comb")  # scenes with passages that are too narrow
ROBOT = "snake:15"

RIVALS = ("adaptive", "prior", "rrt")
VARIANTS = ("plain", "control", "adaptive-unpruned", "prior-unpruned", FRESH + "adaptive")
PAPERS = ("paper", "paper-prior", "paper-rrt")  # the paper's three, under its conditions

LINKS = (5, 10, 15, 20, 25)
LONG_CHAIN = f"snake:{LINKS[-1]}"
STREETS = "streets"  # drawn for long chains; not the paper's
SCALES = ("0.75", "1", "2", "3", "4")
SCALED_SCENE = "comb"  # the paper's figure 3(c)
PARAMETERS_SCENE = "rooms"  # the paper's figure 3(b)
PARAMETERS = {
    "alpha": ("2", "4", "8", "12", "16"),
    "beta": ("0.5", "0.65", "0.75", "0.85", "0.95"),
    "gamma": ("15", "25", "50", "75", "100"),
    "kappa": ("1", "5", "10", "20", "30"),
}
PAPER_DEFAULTS = {"alpha": "8", "beta": "0.85", "gamma": "50", "kappa": "20"}

# The adaptation, and each of our additions, off in turn.
ABLATIONS = {
    "costs never rise": ("gamma=0",),
    "a failure raises costs by Eqn 9 as printed": ("cost_length=0",),
    "the goal's edges rise as well": ("raise_goal=1",),
    "updates wait no longer where regions are many": ("update_regions=0",),
    "every state of a group can be drawn": ("group_sample=65535",),
    "targets up to six regions ahead, however small": ("path_lengths=0",),
    "no stray targets": ("stray_share=0",),
    "no gentle turns": ("gentle_share=0",),
    "targets in sight or not": ("sight_tries=0",),
    "no sketches": ("candidates=0",),
    "expansions in the open as short as others": ("open_steps=0",),
    "a target in the goal is reached near it": ("goal_near_radius=0.7",),
    "states right before a collision kept": ("doomed_steps=0",),
    "no restarts": ("restart_unit=0",),
    "no ways out of narrow places": ("stuck_expansions=0",),
    "speeds from three quarters of the top": ("slowest=0.75",),
    "targets driven to at any speed": ("stopping_ways=0",),
    "portals that are too narrow kept": ("prune_portals=0",),
    "states checked, not the steps between": ("continuous=0",),
    "plans end at any speed": ("end_speed=100",),
    "plans end anywhere in the goal": ("goal_margin=0",),
}

STEERED_PEERS = ("RRT", "KPIECE1", "EST", "PDST", "SST", "SyclopRRT", "SyclopEST", "SyclopRRT-grid", "SyclopEST-grid")
RANDOM_PEERS = tuple(f"{name}-random" for name in ("RRT", "KPIECE1", "EST", "PDST", "SST", "SyclopRRT", "SyclopEST"))
PEERS = tuple(PEER + name for name in STEERED_PEERS + RANDOM_PEERS)


def scaled(scene, scale):
    return scene if scale == "1" else f"{scene}@{scale}"


def with_setting(name, value):
    """Of the paper's table 2, under its conditions."""
    settings = () if PAPER_DEFAULTS[name] == value else (f"{name}={value}",)
    return Cell(PARAMETERS_SCENE, ROBOT, "paper", settings)


def scenes():
    return [Cell(scene, ROBOT, planner) for scene in SCENES for planner in RIVALS + VARIANTS + PAPERS]


def links():
    planners = ("adaptive", "prior", "paper", "paper-prior")
    return [Cell(scene, f"snake:{n}", planner) for n in LINKS for scene in SCENES for planner in planners]


def streets():
    """Long chains in a town quarter."""
    return [Cell(STREETS, f"snake:{n}", planner) for n in LINKS[-3:] for planner in ("adaptive", "prior")]


def scale():
    """The table's, and the other scenes at the largest scale."""
    planners = ("adaptive", "prior", *PAPERS)
    cells = [Cell(scaled(SCALED_SCENE, s), ROBOT, planner) for s in SCALES for planner in planners]
    return cells + [Cell(scaled(scene, SCALES[-1]), ROBOT, "adaptive") for scene in SCENES]


def parameters():
    return [with_setting(name, value) for name, values in PARAMETERS.items() for value in values]


def ablations():
    settings = [(), *ABLATIONS.values()]
    return [Cell(scene, ROBOT, "adaptive", setting) for scene in SCENES for setting in settings]


def peers():
    return [Cell(scene, ROBOT, planner) for scene in SCENES for planner in ("adaptive", FRESH + "adaptive", *PEERS)]


# Each alone, for the peers that steer; the default stands in bench/peers/planners.cpp.
STEERING = {"slowest": ("1",), "gentle_share": ("0.2",)}
HELD = {"max_steps": ("20", "80"), "stop_at_target": ("0", "1"), **STEERING}
SYCLOP = {"max_steps": ("5", "10", "20", "40"), "stop_at_target": ("0", "1"), **STEERING}
GRID = {"cells_a_side": ("16", "64")}
TUNINGS = {
    "RRT": {"goal_bias": ("0.01", "0.2"), **HELD},
    "KPIECE1": {"cell_lengths": ("0.5", "2", "4"), **HELD},
    "EST": {"range": ("10", "40"), "cell_lengths": ("0.5", "2"), **HELD},
    "PDST": HELD,
    "SST": {
        "selection_radius": ("0.5", "2"),
        "pruning_radius": ("0.15", "0.6"),
        "heading_weight": ("0", "3"),
        **HELD,
    },
    "SyclopRRT": SYCLOP,
    "SyclopEST": SYCLOP,
    "SyclopRRT-grid": GRID,
    "SyclopEST-grid": GRID,
}


def tuning():
    """Peers as they are published, and with each of their settings changed."""
    cells = []
    for peer, settings in TUNINGS.items():
        changes = [(), *((f"{name}={value}",) for name, values in settings.items() for value in values)]
        cells += [Cell(scene, ROBOT, PEER + peer, change) for scene in SCENES for change in changes]
    return cells


FOREIGN = [
    *((problem, "unicycle1_v0") for problem in DYNOBENCH),
    *((problem, robot) for problem in MOVINGAI for robot in ("unicycle", "car")),
]
FAR_ONES = [(problem, robot) for problem in FAR for robot in ("turtle_diff_drive", "turtle_unicycle")]


def foreign():
    return [Cell(problem, robot, planner) for problem, robot in FOREIGN for planner in RIVALS]


def far():
    return [Cell(problem, robot, planner) for problem, robot in FAR_ONES for planner in ("adaptive", "prior")]


def goals():
    """What goals are held against, with more seeds than the tables have: the adaptive planner and its rival."""
    cells = [Cell(scene, ROBOT, planner) for scene in SCENES for planner in ("adaptive", "prior")]
    cells += [Cell(scaled(scene, SCALES[-1]), ROBOT, "adaptive") for scene in SCENES]
    cells += [Cell(scene, LONG_CHAIN, "adaptive") for scene in SCENES]
    cells += [Cell(STREETS, robot, "adaptive") for robot in (ROBOT, LONG_CHAIN)]
    cells += [Cell(problem, robot, "adaptive") for problem, robot in FAR_ONES]
    return cells + [Cell(problem, robot, planner) for problem, robot in FOREIGN for planner in ("adaptive", "prior")]


def rounds(protocol):
    """Of the cells that do not have `protocol.seeds`. Peers that are never the best, by far, need few to show it."""
    slow = [cell for cell in peers() if cell.planner.endswith(("-grid", "-random"))]
    few = min(protocol.few_seeds, protocol.seeds)
    return dict.fromkeys(slow, few) | dict.fromkeys(goals(), protocol.goal_seeds)


def own(path, robot):
    """A user's map and robot, by every planner, and by krait's in a new process for each run as the peers have it."""
    return [Cell(OWN + str(path), robot, planner) for planner in (*RIVALS, FRESH + "adaptive", *PEERS)]


EXPERIMENTS = {
    "goals": goals,
    "foreign": foreign,
    "far": far,
    "scenes": scenes,
    "ablations": ablations,
    "links": links,
    "streets": streets,
    "scale": scale,
    "parameters": parameters,
    "peers": peers,
}


APART = {"tuning": tuning}  # on other seeds, and in no page


def cells_of(what):
    """The cells of an experiment, or of all, each once."""
    if what == "all":
        return list(dict.fromkeys(cell for experiment in EXPERIMENTS.values() for cell in experiment()))
    return list(dict.fromkeys((EXPERIMENTS | APART)[what]()))
