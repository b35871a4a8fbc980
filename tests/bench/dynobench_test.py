# SPDX-License-Identifier: Apache-2.0
"""bench/dynobench/dynobench.py plans for dynobench's robots in a problem like dynobench's: dynobench_test.py BIN."""

import importlib.util
import json
import sys
import tempfile
import unittest
from pathlib import Path

BIN = Path(sys.argv.pop(1)).resolve()
SCRIPT = Path(__file__).parents[2] / "bench/dynobench/dynobench.py"
MODELS = {
    "unicycle1_v0": "dynamics: unicycle1\nmax_angular_vel: 0.5\n",
    "unicycle2_v0": "dynamics: unicycle2\nmax_angular_vel: 0.5\nmax_acc_abs: 0.25\nmax_angular_acc: 0.25\n",
    "car1_v0": "dynamics: car_with_trailers\nl: 0.25\nmax_steering_abs: 1.0\nnum_trailers: 1\nhitch_lengths: [0.5]\n"
    "size_trailer: [.3, .25]\n",
}
SAME = "max_vel: 0.5\nmin_vel: -0.1\nsize: [.5, .25]  # m\n"
PROBLEM = """name: hall
environment:
  min: [0.0, 0.0]
  max: [8.0, 4.0]
  obstacles:
    - {{type: box, center: [4.0, 0.5], size: [0.5, 1.0]}}
robots:
  - type: {robot}
    start: [1.5, 2.0, {angles}]
    goal: [6.0, 2.0, {angles}]
"""
ANGLES = {"unicycle1_v0": "0", "unicycle2_v0": "0, 0, 0", "car1_v0": "0, 0"}


def loaded(folder):
    spec = importlib.util.spec_from_file_location("dynobench", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.KRAIT, module.WORK, module.ROBOT = BIN / "krait", folder, folder / "robot.json"
    return module


class Dynobench(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.dynobench = loaded(self.folder)

    def write(self, robot):
        place = self.folder / robot
        place.mkdir()
        (place / "model.yaml").write_text(MODELS[robot] + SAME)
        (place / "bugtrap_0.yaml").write_text(PROBLEM.format(robot=robot, angles=ANGLES[robot]))

    def test_a_row_has_what_each_robot_needs(self):
        for robot in MODELS:
            with self.subTest(robot=robot):
                self.write(robot)
                row = self.dynobench.row(self.folder, robot, "bugtrap_0", 2, 1)
                cells = [cell.strip() for cell in row.strip("|").split("|")]
                self.assertEqual(cells[:3], [robot, "bugtrap_0", "2 of 2"])
                self.assertEqual(len(cells), 9)
                self.assertLess(float(cells[-1]), 20)

    def test_a_plan_is_as_long_as_its_file_says(self):
        self.write("unicycle1_v0")
        robot = self.dynobench.robot_of(self.dynobench.read_model(self.folder / "unicycle1_v0/model.yaml"))
        self.dynobench.ROBOT.write_text(json.dumps(robot))
        problem = self.folder / "unicycle1_v0/bugtrap_0.yaml"
        took, duration, apart = self.dynobench.plan(problem, robot, 1, "--improve", "0")
        self.assertGreater(took, 0)
        self.assertGreaterEqual(duration, 4.3 / 0.5)  # metres at the top speed
        self.assertLess(apart, 0.2)


if __name__ == "__main__":
    unittest.main()
