# SPDX-License-Identifier: Apache-2.0
"""The benchmark programs: trials_test.py BIN. The verifier accepts every planner's plan; bad input is refused."""

import itertools
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BIN = Path(sys.argv.pop(1))
SEARCH, PEERS, CORE = BIN / "krait-bench-search", BIN / "krait-bench-peers", BIN / "krait-bench-core"
SCENE = {
    "name": "hall",
    "bounds": {"min": [0, 0], "max": [12, 8]},
    "obstacles": [{"box": {"center": [6, 2], "size": [1, 4], "angle": 0}}],
    "goals": [{"name": "goal", "box": {"center": [10, 4], "size": [3, 3], "angle": 0}}],
    "starts": [{"name": "start", "position": [3, 4], "heading": 0}],
}


def every_robot():
    """One of every model in the library's table, with a trailer where it may have any."""
    table = (Path(__file__).parents[2] / "include/krait/robots/all.hpp").read_text()
    rows = re.findall(r"^  MODEL\((\w+), \w+, \w+, (\d+|-)\)", table, re.MULTILINE)
    return [name if trailers == "-" else f"{name}:1" for name, trailers in rows]


class Trials(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.input = cls.folder / "hall.json"
        cls.input.write_text(json.dumps(SCENE))
        cls.scene = cls.compiled(cls.input)

    @staticmethod
    def compiled(path):
        scene = path.with_suffix(".krait")
        subprocess.run([BIN / "krait", "compile", path, "-o", scene], check=True, capture_output=True)
        return scene

    def ask(self, program, planner, trials, **given):
        same = {"scene": str(self.scene), "input": str(self.input), "robot": "snake:1", "limit_s": 300} | given
        command = [program, "trials", *(["--memory", "64"] if program == SEARCH else [])]
        lines = "".join(json.dumps({"planner": planner, **same, **trial}) + "\n" for trial in trials)
        return subprocess.run(command, input=lines, capture_output=True, text=True)

    def answers(self, *arguments, **given):
        result = self.ask(*arguments, **given)
        self.assertEqual(result.returncode, 0, result.stderr)
        return [json.loads(line) for line in result.stdout.splitlines()]

    def planners(self, program):
        listed = subprocess.run([program, "planners"], check=True, capture_output=True, text=True).stdout
        names = [line.split("\t")[0] for line in listed.splitlines()]
        self.assertGreater(len(names), 3)
        return names

    def solves_with_every_planner(self, program):
        for planner in self.planners(program):
            with self.subTest(planner):
                [answer] = self.answers(program, planner, [{"trial": 3, "seed": 5}])
                self.assertEqual((answer["trial"], answer["status"]), (3, "solved"))
                if not planner.startswith("paper"):  # which checks states, not the steps between
                    self.assertTrue(answer["verified"], answer.get("complaint"))
                self.assertGreater(answer["time_s"], 0)
                self.assertGreater(answer["plan_length_m"], 5)

    def test_every_planner_of_the_core(self):
        self.solves_with_every_planner(SEARCH)

    @unittest.skipUnless(PEERS.exists(), "built without OMPL (bench/packages)")
    def test_every_peer(self):
        self.solves_with_every_planner(PEERS)

    def test_one_process_answers_many_trials_each_by_its_seed(self):
        trials = [{"trial": i, "seed": seed} for i, seed in enumerate((7, 8, 7))]
        hashes = [answer["hash"] for answer in self.answers(SEARCH, "adaptive", trials)]
        self.assertEqual(hashes[0], hashes[2])
        self.assertNotEqual(hashes[0], hashes[1])

    def test_a_setting_changes_the_search(self):
        gates = self.folder / "gates.json"
        subprocess.run([BIN / "krait", "scene", "gates", "-o", gates], check=True)
        files = {"input": str(gates), "scene": str(self.compiled(gates))}
        settings = ({}, {"beta": 0.85}, {"beta": 0.1}, {"candidates": 0}, {"prune_portals": 0}, {"end_speed": 100})
        trials = [{"trial": i, "seed": 11, "set": setting} for i, setting in enumerate(settings)]
        usual, same, *others = (answer["hash"] for answer in self.answers(SEARCH, "adaptive", trials, **files))
        self.assertEqual(usual, same)
        self.assertEqual(len({usual, *others}), 5)

    def test_one_process_answers_trials_of_several_scenes_robots_and_planners(self):
        other = self.folder / "other.json"
        other.write_text(json.dumps(SCENE | {"name": "other", "obstacles": []}))
        trials = [
            {"trial": 1, "seed": 1},
            {"trial": 2, "seed": 1, "input": str(other), "scene": str(self.compiled(other)), "robot": "car"},
            {"trial": 3, "seed": 1, "planner": "prior"},
            {"trial": 4, "seed": 1},
        ]
        first, second, third, last = self.answers(SEARCH, "adaptive", trials)
        self.assertTrue(all(answer["verified"] for answer in (first, second, third, last)))
        self.assertEqual(first["hash"], last["hash"])
        self.assertEqual(len({answer["hash"] for answer in (first, second, third)}), 3)

    def test_says_how_long_it_waited_for_its_core(self):
        [answer] = self.answers(SEARCH, "adaptive", [{"trial": 1, "seed": 1}])
        self.assertLess(abs(answer["waited_s"]), 60)

    def test_plans_are_not_verified_where_instructions_are_counted(self):
        line = {"trial": 1, "seed": 1, "scene": str(self.scene), "input": str(self.input), "robot": "snake:1"}
        line |= {"planner": "adaptive", "limit_s": 300}
        command = [SEARCH, "trials", "--memory", "64", "--unverified"]
        done = subprocess.run(command, input=json.dumps(line) + "\n", capture_output=True, text=True, check=True)
        self.assertNotIn("verified", json.loads(done.stdout))

    def test_a_query_has_its_own_start_and_goal(self):
        queries = [
            {"trial": 1, "seed": 1, "start": [3, 6, 0], "goal": [4, 6, 0.5]},
            {"trial": 2, "seed": 1, "start": [6, 2, 0], "goal": [4, 6, 0.5]},
        ]
        near, blocked = self.answers(SEARCH, "adaptive", queries)
        self.assertLess(near["plan_length_m"], 2)
        self.assertEqual(blocked["status"], "refused")
        self.assertIn("start_in_collision", blocked["complaint"])

    def parts(self, robot="snake:2", scene=None):
        command = [CORE, "--scene", scene or self.scene, "--robot", robot, "--seeds", "2"]
        command += ["--benchmark_format=json", "--benchmark_min_time=0.001"]
        return subprocess.run(command, capture_output=True, text=True)

    def test_the_parts_of_a_search_do_what_the_search_did(self):
        if not CORE.exists():
            self.skipTest("built without Google Benchmark")
        result = self.parts()
        self.assertEqual(result.returncode, 0, result.stderr)
        entries = {entry["name"]: entry for entry in json.loads(result.stdout)["benchmarks"]}
        self.assertTrue({"open", "set_up", "plan", "floor", "steer", "propagate", "check"} <= set(entries))
        self.assertTrue(all(entry["cpu_time"] > 0 for entry in entries.values()))
        trials = [{"trial": seed, "seed": seed} for seed in (1, 2)]
        answers = self.answers(SEARCH, "adaptive", trials, robot="snake:2")
        for name in ("vertices", "plan_steps"):
            self.assertEqual(entries["plan"][name], sum(answer[name] for answer in answers))

    def test_the_parts_of_a_search_refuse_bad_input(self):
        if not CORE.exists():
            self.skipTest("built without Google Benchmark")
        for result in (self.parts(robot="car"), self.parts(robot="eel"), self.parts(scene="/nowhere")):
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stdout, "")
            self.assertIn("krait-bench-core: ", result.stderr)

    def test_bad_input_ends_the_program_with_a_line(self):
        trial = [{"trial": 1, "seed": 1}]
        for words, result in (
            ("no planner 'none'", self.ask(SEARCH, "none", trial)),
            ("no setting 'delta'", self.ask(SEARCH, "adaptive", trial, set={"delta": 1})),
            ("set beta: must be from", self.ask(SEARCH, "adaptive", trial, set={"beta": 1})),
            ("without a fraction", self.ask(SEARCH, "adaptive", trial, set={"kappa": 1.5})),
            ("seed", self.ask(SEARCH, "adaptive", [{"trial": 1}])),
            ("speed", self.ask(SEARCH, "adaptive", [{"trial": 1, "seed": 1, "speed": 1}])),
            ("limit_s", self.ask(SEARCH, "adaptive", trial, limit_s=0)),
            ("/nowhere", self.ask(SEARCH, "adaptive", trial, scene="/nowhere")),
        ):
            self.assertEqual(result.returncode, 2)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
            self.assertIn(words, result.stderr)

    @unittest.skipUnless(PEERS.exists(), "built without OMPL (bench/packages)")
    def test_peers_drive_every_model(self):
        for robot, planner in itertools.product(every_robot(), ("KPIECE1", "SyclopEST", "PDST-random")):
            with self.subTest(f"{robot}, {planner}"):
                [answer] = self.answers(PEERS, planner, [{"trial": 1, "seed": 4}], robot=robot)
                self.assertEqual(answer["status"], "solved")
                self.assertTrue(answer["verified"], answer.get("complaint"))

    @unittest.skipUnless(PEERS.exists(), "built without OMPL (bench/packages)")
    def test_peers_are_tuned_and_refuse_what_they_do_not_have(self):
        trials = [{"trial": 1, "seed": 1, "set": {"gentle_share": 0.5, "slowest": 1}}]
        self.assertTrue(self.answers(PEERS, "SyclopEST", trials)[0]["verified"])
        for words, setting in (("no setting 'alpha'", {"alpha": 1}), ("set range: must be", {"range": 0})):
            result = self.ask(PEERS, "EST", [{"trial": 1, "seed": 1}], set=setting)
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1))
            self.assertIn(words, result.stderr)


if __name__ == "__main__":
    unittest.main()
