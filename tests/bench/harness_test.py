# SPDX-License-Identifier: Apache-2.0
"""The benchmarks' driver itself: known runs in, right statistics out; rounds, giving up, censoring, resuming."""

import argparse
import contextlib
import importlib.util
import io
import json
import math
import os
import signal
import sys
import tempfile
import threading
import time
import unittest
from dataclasses import replace
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from harness import experiments, problems, readme, session, statistics, tables, worker  # noqa: E402
from harness.cells import FRESH, Cell  # noqa: E402
from harness.claims import claims  # noqa: E402
from harness.journal import Journal, JournalError, compressed, merged  # noqa: E402
from harness.parts import all_over_floor, blocks_of, parts_of, together  # noqa: E402
from harness.problems import Problem, movingai_queries, roomiest_heading  # noqa: E402
from harness.progress import Progress  # noqa: E402
from harness.prose import wrapped  # noqa: E402
from harness.protocol import Protocol, Shard, disturbed  # noqa: E402
from harness.results import Results, time_a_step, to_csv, vertices  # noqa: E402
from harness.session import Rounds  # noqa: E402
from harness.statistics import Figure, deviation, interval, mean, quantile, rounded  # noqa: E402
from harness.statistics import summarise, times, trimmed  # noqa: E402
from harness.worker import BadInput, Worker, timing_core  # noqa: E402

HAS_MATPLOTLIB = importlib.util.find_spec("matplotlib")
LIMIT = 10.0
OURS = Cell("rooms", "snake:15", "adaptive")
RIVAL = Cell("rooms", "snake:15", "prior")
PAPER = Cell("rooms", "snake:15", "paper")


def solved(seconds, trial=1, **more):
    return {"trial": trial, "status": "solved", "verified": True, "time_s": seconds, "limit_s": LIMIT, **more}


def timed_out(trial=1, limit=LIMIT):
    return {"trial": trial, "status": "time_used", "time_s": limit, "limit_s": limit}


def run_of(cell, run, session=0):
    return {"kind": "run", "session": session, "cell": cell.key, **run}


def session_of(machine="m", commit="abc"):
    return {"kind": "session", "machine": machine, "commit": commit, "protocol": {"give_up": 10}}


class Statistics(unittest.TestCase):
    def test_sixty_runs_lose_five_at_each_end(self):
        figures = times([solved(float(i)) for i in range(60, 0, -1)], 100.0, OURS)
        kept = trimmed(figures)
        self.assertEqual([f.value for f in kept], [float(i) for i in range(6, 56)])
        self.assertEqual(mean(kept), Figure(30.5))
        self.assertAlmostEqual(deviation(kept), math.sqrt((50 * 50 - 1) / 12 * 50 / 49))

    def test_few_runs_lose_none(self):
        self.assertEqual(len(trimmed(times([solved(1.0)] * 11, LIMIT, OURS))), 11)
        self.assertEqual(len(trimmed(times([solved(1.0)] * 12, LIMIT, OURS))), 10)

    def test_quantiles_are_nearest_ranks_of_all_runs(self):
        figures = times([solved(float(i)) for i in range(1, 61)], 100.0, OURS)
        self.assertEqual([quantile(figures, q).value for q in (0.5, 0.9, 0.99, 1.0)], [30, 54, 60, 60])
        self.assertEqual(quantile([Figure(7.0)], 0.01).value, 7)

    def test_a_time_out_is_a_bound(self):
        summary = summarise([solved(1.0), solved(2.0), timed_out()], LIMIT, False, OURS)
        self.assertEqual(summary.mean, Figure(13 / 3, True))
        self.assertIsNone(summary.deviation)
        self.assertEqual(summary.median, Figure(2.0))
        self.assertEqual(summary.p90, Figure(LIMIT, True))
        self.assertEqual(summary.p90.shown(), "≥ 10.0")
        self.assertAlmostEqual(summary.success, 2 / 3)

    def test_trimmed_time_outs_leave_the_mean_exact(self):
        runs = [solved(1.0)] * 55 + [timed_out()] * 5
        self.assertEqual(summarise(runs, LIMIT, False, OURS).mean, Figure(1.0))
        runs = [solved(1.0)] * 54 + [timed_out()] * 6
        self.assertTrue(summarise(runs, LIMIT, False, OURS).mean.at_least)

    def test_a_plan_that_is_late_or_not_verified_is_none(self):
        late, wrong = solved(LIMIT + 0.1), solved(1.0) | {"verified": False}
        self.assertEqual(summarise([late, wrong, solved(LIMIT)], LIMIT, False, OURS).solved, 1)
        self.assertEqual(times([wrong], LIMIT, OURS), [Figure(LIMIT, True)])

    def test_by_the_papers_criterion_a_plan_counts_and_whether_it_holds_stands_beside(self):
        wrong = solved(1.0) | {"verified": False}
        for cell in (PAPER, Cell("rooms", "snake:15", "adaptive", ("continuous=0",))):
            summary = summarise([wrong, solved(2.0), timed_out()], LIMIT, False, cell)
            self.assertEqual((summary.solved, summary.verified), (2, 1))
            self.assertEqual(summary.median, Figure(2.0))

    def test_medians_are_of_solved_runs_that_tell(self):
        runs = [solved(1.0, vertices=10), solved(1.0, vertices=30), solved(1.0), timed_out() | {"vertices": 999}]
        summary = summarise(runs, LIMIT, False, OURS)
        self.assertEqual((summary.medians, summary.vertices_p90), ({"vertices": 10}, 30))

    def test_numbers_keep_their_digits(self):
        self.assertEqual([rounded(x) for x in (0.012345, 1.0, 12345.0, 0)], ["0.0123", "1.00", "12300", "0"])


class Intervals(unittest.TestCase):
    def middle(self, samples):
        return quantile(statistics.in_order(samples[0]), 0.5)

    def test_of_equal_figures_have_no_width(self):
        found = interval([[Figure(2.0)] * 9], self.middle)
        self.assertEqual((found.estimate, found.low, found.high), (Figure(2.0), 2.0, 2.0))

    def test_hold_the_estimate_and_shrink_with_more_figures(self):
        few, many = (interval([[Figure(1 + i / n) for i in range(n)]], self.middle) for n in (9, 400))
        for found in (few, many):
            self.assertLess(found.low, found.estimate.value)
            self.assertGreater(found.high, found.estimate.value)
        self.assertLess(many.high - many.low, 0.3 * (few.high - few.low))

    def test_of_bounds_have_no_upper_end(self):
        found = interval([[Figure(10.0, True)] * 5 + [Figure(1.0)] * 5], self.middle)
        self.assertEqual((found.low, found.high), (1.0, math.inf))
        self.assertEqual(interval([[Figure(10.0, True)]], self.middle).shown(), "≥ 10.0 [10, ∞]")
        self.assertEqual(statistics.Interval(Figure(10.0, True), math.inf, math.inf).shown(), "≥ 10.0 [∞, ∞]")

    def test_decide_a_goal_or_leave_it_open(self):
        found = statistics.Interval(Figure(2.0), 1.5, 3.0)
        self.assertEqual([found.reaches(x) for x in (1.5, 2.0, 3.5)], [True, None, False])
        self.assertEqual([found.stays(x) for x in (3.0, 2.0, 1.0)], [True, None, False])


class RoundsOfCells(unittest.TestCase):
    def rounds(self, count=60, give_up=10):
        return Rounds({OURS: 2, RIVAL: count}, {OURS: None, RIVAL: give_up})

    def test_end_with_the_cells_own_count(self):
        rounds = self.rounds()
        self.assertEqual(len(rounds), 60)
        self.assertEqual([rounds.due(i) for i in (0, 1, 2)], [[OURS, RIVAL], [OURS, RIVAL], [RIVAL]])

    def after(self, outcomes, **how):
        rounds = self.rounds(**how)
        for outcome in outcomes:
            rounds.add(RIVAL, outcome)
        return RIVAL in rounds.due(5)

    def test_leave_a_cell_out_after_failures_in_a_row(self):
        self.assertTrue(self.after([timed_out()] * 9))
        self.assertFalse(self.after([timed_out()] * 10))
        self.assertTrue(self.after([timed_out()] * 9 + [solved(1.0)] + [timed_out()] * 9))
        self.assertFalse(self.after([solved(LIMIT + 1)] * 10))

    def test_never_leave_out_a_cell_whose_trials_are_different_queries(self):
        self.assertTrue(self.after([timed_out()] * 59, give_up=None))


class Protocols(unittest.TestCase):
    def test_limits_follow_the_adaptive_median(self):
        self.assertEqual(Protocol().limit_of(RIVAL, 0.001), 1.0)
        self.assertEqual(Protocol().limit_of(RIVAL, 0.02), 6.0)
        self.assertEqual(Protocol(limit=3.0).limit_of(RIVAL, 0.02), 3.0)

    def test_the_adaptive_planner_has_the_papers_limit(self):
        self.assertEqual(Protocol().limit_of(OURS, 0.02), 100.0)
        changed = Cell("rooms", "snake:15", "adaptive", ("alpha=4",))
        self.assertEqual(Protocol().limit_of(changed, 0.02), 6.0)

    def test_a_run_that_waited_for_its_core_is_disturbed(self):
        self.assertFalse(disturbed({"time_s": 0.001, "waited_s": 9e-5}))
        self.assertTrue(disturbed({"time_s": 0.001, "waited_s": 2e-4}))
        self.assertFalse(disturbed({"status": "crashed"}))

    def test_so_is_one_whose_core_a_hypervisor_took(self):
        self.assertTrue(disturbed({"time_s": 0.05, "waited_s": 0.0, "stolen_s": 0.01}))
        self.assertFalse(disturbed({"time_s": 0.5, "stolen_s": 0.01}))

    def test_shards_share_the_rounds(self):
        shares = [[round_ for round_ in range(10) if Shard(i, 3).has(round_)] for i in (1, 2, 3)]
        self.assertEqual(sorted(sum(shares, [])), list(range(10)))
        self.assertEqual(shares[1], [1, 4, 7])


class JournalFile(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name) / "runs.jsonl"

    def test_keeps_what_was_appended(self):
        with Journal(self.path) as journal:
            journal.append(run_of(OURS, solved(1.0)))
        self.assertEqual(Journal(self.path, writable=False).runs(), {OURS.key: {1: run_of(OURS, solved(1.0))}})

    def test_cuts_off_a_torn_line_and_goes_on(self):
        self.path.write_text(json.dumps(run_of(OURS, solved(1.0))) + "\n" + '{"kind": "run", "cel')
        with Journal(self.path) as journal:
            journal.append(run_of(OURS, solved(1.0, 2)))
        self.assertEqual(sorted(Journal(self.path, writable=False).runs()[OURS.key]), [1, 2])

    def test_refuses_a_second_writer(self):
        with Journal(self.path), self.assertRaisesRegex(JournalError, "another"):
            Journal(self.path)

    def test_names_a_broken_line(self):
        for line in ("nonsense", "{}", "5"):
            self.path.write_text(f'{{"kind": "run"}}\n{line}\n')
            with self.assertRaisesRegex(JournalError, "line 2 is no "):
                Journal(self.path, writable=False)

    def test_names_a_file_that_is_none(self):
        packed = self.path.with_suffix(".jsonl.xz")
        packed.write_text("nonsense")
        for path in (packed, self.path.parent):
            with self.assertRaisesRegex(JournalError, f"^{path}: cannot be read: "):
                Journal(path, writable=False)
        with self.assertRaisesRegex(JournalError, f"^{self.path.parent}: cannot be written: Is a directory$"):
            Journal(self.path.parent)
        with self.assertRaisesRegex(JournalError, "compressed"):
            Journal(packed)
        self.assertEqual(packed.read_text(), "nonsense")

    def test_the_last_run_of_a_trial_counts(self):
        with Journal(self.path) as journal:
            for seconds in (1.0, 2.0, 3.0):
                journal.append(run_of(OURS, solved(seconds)))
            self.assertEqual(journal.runs()[OURS.key][1]["time_s"], 3.0)

    def test_is_read_compressed(self):
        packed = self.path.with_suffix(".jsonl.xz")
        packed.write_bytes(compressed([session_of(), run_of(OURS, solved(1.0))]))
        self.assertEqual(len(Journal(packed, writable=False).records), 2)

    def test_of_several_shards_keeps_each_runs_machine(self):
        journals = []
        for number, machine in enumerate("ab"):
            with Journal(self.path.with_name(machine)) as journal:
                journal.append(session_of(machine))
                journal.append(run_of(OURS, solved(1.0, number)))
                journals.append(journal)
        records = merged(journals)
        self.assertEqual([record["session"] for record in records if record["kind"] == "run"], [0, 1])
        self.assertEqual([record["machine"] for record in records if record["kind"] == "session"], ["a", "b"])


class ResultsOfRuns(unittest.TestCase):
    def results(self, runs, machines=("m",)):
        return Results([*map(session_of, machines), *runs])

    def test_say_whether_a_cell_was_given_up(self):
        found = self.results([run_of(OURS, timed_out(i)) for i in range(10)])
        self.assertTrue(found.summary(OURS).given_up)
        self.assertIsNone(found.summary(RIVAL))
        self.assertIn("rooms,snake:15,adaptive", to_csv(found.rows([OURS])))

    def test_ratios_are_of_the_trials_that_both_have(self):
        ours = [run_of(OURS, solved(1.0, i)) for i in range(5)] + [run_of(OURS, solved(9.0, i)) for i in range(5, 9)]
        rival = [run_of(RIVAL, solved(3.0, i)) for i in range(5)]
        found = self.results(ours + rival).ratio([(RIVAL, OURS)])
        for value in (found.estimate.value, found.low, found.high):
            self.assertAlmostEqual(value, 3.0)

    def test_ratios_are_formed_within_each_machine(self):
        runs = []
        for trial, (machine, ours, rival) in enumerate([(0, 1.0, 2.0)] * 3 + [(1, 100.0, 800.0)] * 3):
            runs += [run_of(OURS, solved(ours, trial, limit_s=1e3), machine)]
            runs += [run_of(RIVAL, solved(rival, trial, limit_s=1e3), machine)]
        found = self.results(runs, ("a", "b")).ratio([(RIVAL, OURS)])
        self.assertAlmostEqual(found.estimate.value, 4.0)  # of 2 and 8

    def test_a_censored_rival_bounds_the_ratio_and_a_censored_self_says_nothing(self):
        runs = [run_of(OURS, solved(0.1)), run_of(RIVAL, timed_out())]
        found = self.results(runs).ratio([(RIVAL, OURS)])
        self.assertEqual((found.estimate.at_least, found.reaches(50), found.reaches(200)), (True, True, None))
        runs = [run_of(OURS, timed_out()), run_of(RIVAL, solved(0.1))]
        self.assertIsNone(self.results(runs).ratio([(RIVAL, OURS)]).reaches(0.5))

    def test_counts_and_times_a_step_are_measured_as_times_are(self):
        runs = [run_of(OURS, solved(1.0, i, vertices=i, plan_steps=10)) for i in (10, 20, 30)]
        runs += [run_of(RIVAL, solved(4.0, i, vertices=4 * i, plan_steps=20)) for i in (10, 20, 30)]
        found = self.results(runs)
        self.assertAlmostEqual(found.mean_quantile([OURS], 0.5, vertices).estimate.value, 20)
        self.assertAlmostEqual(found.ratio([(RIVAL, OURS)], value=vertices).estimate.value, 4)
        self.assertAlmostEqual(found.ratio([(RIVAL, OURS)], value=time_a_step).estimate.value, 2)
        self.assertIsNone(found.ratio([(PAPER, OURS)]))


PROGRAM = """
import json, sys, time
for line in sys.stdin:
    trial = json.loads(line)["trial"]
    if trial == 2: sys.exit(7)
    if trial == 3: time.sleep(60)
    if trial == 4: print("bad scene", file=sys.stderr); sys.exit(2)
    print(json.dumps({"trial": trial, "status": "solved"}), flush=True)
"""


class Programs(unittest.TestCase):
    def worker(self, fresh=False, patience=60.0):
        made = Worker(["/usr/bin/python3", "-c", PROGRAM], fresh, timing_core(), patience)
        self.addCleanup(made.stop)
        return made

    def ask(self, worker_, trial):
        return worker_.run({"trial": trial, "limit_s": 0.0})

    def test_answer_in_turn(self):
        for fresh in (False, True):
            made = self.worker(fresh)
            self.assertEqual([self.ask(made, i)["trial"] for i in (1, 5, 6)], [1, 5, 6])

    def test_that_crash_or_hang_cost_one_trial(self):
        made = self.worker()
        self.assertEqual(self.ask(made, 2)["status"], "crashed")
        made.patience = 0.5
        self.assertEqual(self.ask(made, 3)["status"], "hung")
        made.patience = 60
        self.assertEqual(self.ask(made, 1)["status"], "solved")

    def test_that_refuse_their_input_end_the_session(self):
        with self.assertRaisesRegex(BadInput, "bad scene"):
            self.ask(self.worker(), 4)

    def test_have_the_last_core_and_leave_it_to_them(self):
        with mock.patch("os.sched_getaffinity", lambda _: {5, 0, 2}), mock.patch("os.sched_setaffinity") as kept:
            self.assertEqual(timing_core(), 5)
            worker.leave(5)
        kept.assert_called_once_with(0, {0, 2})


PREPARE = problems.prepare

# Answers with its process and core; a scene's name says how it behaves.
SEARCH = """#!/usr/bin/python3
import json, os, sys, time
asked = 0
for line in sys.stdin:
    trial = json.loads(line)
    scene = trial["scene"]
    asked += 1
    if "refusing" in scene: print("bad scene", file=sys.stderr); sys.exit(2)
    if "endless" in scene: time.sleep(100)
    waited = 0.5 / asked if "noisy" in scene else 0.0
    answer = {"status": "solved", "verified": True, "time_s": 0.02, "waited_s": waited, "hash": os.getpid()}
    print(json.dumps({"trial": trial["trial"], "vertices": trial["limit_s"], **answer}), flush=True)
"""


class Sessions(unittest.TestCase):
    """With a program that answers at once, and problems that need no compiling."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name in ("krait-bench-search", "krait-bench-peers"):
            program = self.folder / name
            program.write_text(SEARCH)
            program.chmod(0o755)
        self.compiled = []
        self.described = {"machine": "m", "commit": "abc", "programs": "p"}
        for where, name, stand_in in (
            (session, "BIN", self.folder),
            (session.problems, "prepare", self.prepare),
            (session.machine, "describe", lambda core: dict(self.described)),
        ):
            patch = mock.patch.object(where, name, stand_in)
            patch.start()
            self.addCleanup(patch.stop)

    def prepare(self, name, folder):
        self.compiled.append(name)
        source = problems.foreign_input(name)
        scene = folder / f"{Path(name).name}.krait"
        scene.write_text(source.read_text() if source else name)
        return Problem(name, scene, scene, 0.1)

    def measure(self, cells, seeds=3, stream=None, shard=Shard(), rounds_of=None):
        """The journal's records."""
        path = self.folder / "runs.jsonl"
        protocol = Protocol(seeds=seeds, pilot_seeds=2)
        try:
            with Journal(path) as journal:
                progress = Progress(stream or io.StringIO())
                with session.Session(self.folder, journal, protocol, progress, timing_core(), shard) as measured:
                    measured.measure_all(cells, rounds_of)
        finally:
            self.records = Journal(path, writable=False).records
        return self.records

    def cells(self, *scenes, planners=("adaptive", "prior")):
        return [Cell(scene, "snake:15", planner) for scene in scenes for planner in planners]

    def runs(self, records):
        return [record for record in records if record["kind"] == "run"]

    def test_run_a_trial_of_every_cell_and_then_the_next(self):
        cells = self.cells("rooms", "comb")
        runs = self.runs(self.measure(cells))
        self.assertEqual([run["cell"] for run in runs], 3 * [cell.key for cell in cells])
        self.assertEqual([run["trial"] for run in runs], [Protocol.first_seed + k for k in range(3) for _ in cells])
        self.assertEqual(self.compiled, ["rooms", "comb"])

    def test_measure_some_cells_in_more_rounds(self):
        ours, rival = self.cells("rooms")
        runs = self.runs(self.measure([ours, rival], 2, rounds_of={ours: 4}))
        self.assertEqual([run["cell"] for run in runs].count(ours.key), 4)
        self.assertEqual([run["cell"] for run in runs].count(rival.key), 2)

    def test_set_limits_by_a_pilot_on_other_seeds(self):
        records = self.measure(self.cells("rooms", planners=["prior"]))
        self.assertEqual([r["cell"] for r in records if r["kind"] == "pilot"], ["rooms snake:15 adaptive"])
        self.assertEqual({run["limit_s"] for run in self.runs(records)}, {6.0})  # 300 times 0.02 s
        self.assertEqual({run["cell"] for run in self.runs(records)}, {"rooms snake:15 prior"})

    def test_share_a_process_but_for_those_that_need_a_new_one(self):
        planners = ("adaptive", "prior", FRESH + "adaptive", "ompl:RRT")
        processes = {}
        for run in self.runs(self.measure(self.cells("rooms", planners=planners))):
            processes.setdefault(run["cell"].split()[-1], set()).add(run["hash"])
        self.assertEqual([len(processes[planner]) for planner in planners], [1, 1, 3, 3])
        self.assertEqual(processes["adaptive"], processes["prior"])

    def test_make_a_disturbed_run_again(self):
        ours = Cell("noisy", "snake:15", "prior")
        with mock.patch.object(Protocol, "limit_of", lambda *_: 1.0), mock.patch.object(
            session.Session, "_pilot", lambda *_: 1.0
        ):
            [run] = self.runs(self.measure([ours], 1))
        self.assertEqual((run["repeats"], run["waited_s"]), (3, 0.12))  # 0.5 / 4, the least
        self.assertEqual(Results(self.records).repeated(), (1, 1))

    def test_record_with_each_run_what_else_the_machine_did(self):
        with mock.patch.object(session.machine.Activity, "_read", mock.Mock(side_effect=range(0, 1000, 3))):
            runs = self.runs(self.measure(self.cells("rooms"), seeds=1))
        tick = 1 / os.sysconf("SC_CLK_TCK")
        self.assertEqual([run["stolen_s"] for run in runs], [round(3 * tick, 2)] * 2)
        self.assertTrue(all(run["load"] >= 0 for run in runs))

    def test_go_on_where_they_were_broken_off(self):
        self.measure(self.cells("rooms", "comb"), seeds=2)
        runs = self.runs(self.measure(self.cells("rooms", "comb"), seeds=3))
        self.assertEqual(len(runs), 3 * 4)
        self.assertEqual([run["session"] for run in runs], 8 * [0] + 4 * [1])

    def test_do_not_go_on_with_another_build(self):
        self.measure(self.cells("rooms"))
        for name in self.described:
            with mock.patch.dict(self.described, {name: "another"}), self.assertRaisesRegex(JournalError, "abc"):
                self.measure(self.cells("rooms"))

    def test_do_not_go_on_with_another_map_or_robot_of_a_users(self):
        files = [self.folder / name for name in ("map.json", "robot.json")]
        for file in files:
            file.write_text("one")
        own = [Cell(f"own:{files[0]}", str(files[1]), "prior")]
        self.measure(own, seeds=2)
        self.assertEqual(len(self.runs(self.measure(own, seeds=3))), 3)
        for file in files:
            file.write_text("another")
            with self.assertRaisesRegex(JournalError, f"before {file} was changed"):
                self.measure(own)
            file.write_text("one")
        self.assertEqual(len(self.runs(self.measure(own, seeds=4))), 4)

    def test_measure_the_rounds_of_their_shard(self):
        runs = self.runs(self.measure(self.cells("rooms"), 5, shard=Shard(2, 2)))
        self.assertEqual(sorted({run["trial"] for run in runs}), [Protocol.first_seed + 1, Protocol.first_seed + 3])

    def test_say_once_what_the_compiler_warned_of(self):
        shown = io.StringIO()
        program = self.folder / "krait"
        program.write_text("#!/bin/sh\nfor file; do :; done\necho warning: no headings >&2\ntouch \"$file\"\n")
        program.chmod(0o755)
        (self.folder / "map.json").write_text("{}")
        with mock.patch.object(problems, "BIN", self.folder), mock.patch.object(problems, "prepare", PREPARE):
            self.measure(self.cells(f"own:{self.folder / 'map.json'}", "rooms"), stream=shown)
        self.assertEqual(shown.getvalue().count("warning: no headings\n"), 1)

    def test_say_where_the_query_of_a_users_map_is_from(self):
        answer = {"status": "refused", "complaint": "the scene has no start"}
        own = Cell(f"own:{self.folder / 'map.json'}", "snake:15", "prior")
        with self.assertRaisesRegex(BadInput, "no start; own plans from the map's first start"):
            session.Session._refuse_nonsense(own, Problem(own.problem, Path(), Path(), 0.1), answer)
        with self.assertRaisesRegex(BadInput, "no start$"):
            session.Session._refuse_nonsense(RIVAL, Problem(RIVAL.problem, Path(), Path(), 0.1), answer)

    def test_skip_problems_that_are_not_there(self):
        shown = io.StringIO()
        with mock.patch.object(problems, "SAMPLES", self.folder):
            self.measure(self.cells("movingai/none", "rooms", planners=["prior"]), stream=shown)
        first = f"movingai/none snake:15 prior: skipped, {self.folder / 'movingai/none.map'} is not there"
        self.assertEqual(shown.getvalue().splitlines()[0], first)
        self.assertEqual(self.compiled, ["rooms"])

    def test_end_when_one_program_refuses_its_input(self):
        with self.assertRaisesRegex(BadInput, "bad scene"):
            self.measure(self.cells("rooms", "refusing"))
        self.assert_no_program_is_left()

    def test_end_at_once_when_interrupted(self):
        before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a job in the background ignores it
        self.addCleanup(signal.signal, signal.SIGINT, before)
        begin = time.monotonic()
        timer = threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT))
        self.addCleanup(timer.cancel)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            self.measure(self.cells("endless"))
        self.assertLess(time.monotonic() - begin, 30)
        self.assertFalse(self.runs(self.records))
        self.assert_no_program_is_left()

    def assert_no_program_is_left(self):
        for process in Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):
                self.assertNotIn(str(self.folder).encode(), (process / "cmdline").read_bytes())


class ProgressShown(unittest.TestCase):
    def test_is_a_line_a_round_with_the_time_left(self):
        stream, clock = io.StringIO(), [0.0]
        with mock.patch("time.monotonic", lambda: clock[0]):
            progress = Progress(stream)
            progress.expect(10)
            for clock[0] in (10.0, 20.0):
                progress.made("rooms")
            progress.end_round(1)
        self.assertEqual(stream.getvalue(), "[2 of at most 10 runs, 80 s left] round 1\n")

    def test_on_a_terminal_is_of_the_last_run(self):
        stream = io.StringIO()
        stream.isatty = lambda: True
        progress = Progress(stream)
        progress.expect(2)
        progress.made("rooms")
        self.assertRegex(stream.getvalue(), r"^\r\033\[K\[1 of at most 2 runs, .* left\] rooms$")


@unittest.skipUnless(HAS_MATPLOTLIB, "bench/run's program draws")
class CommandLine(unittest.TestCase):
    def refusal(self, *arguments):
        from harness.arguments import parse

        with contextlib.redirect_stderr(io.StringIO()) as complaint, self.assertRaises(SystemExit) as ended:
            parse(list(arguments))
        self.assertEqual(ended.exception.code, 2)
        return complaint.getvalue()

    def test_measures_planners_alone(self):
        from harness.__main__ import only

        kept = only(experiments.cells_of("scenes"), ["plain", "prior"])
        self.assertEqual(len(kept), 2 * len(experiments.SCENES))
        self.assertEqual({cell.planner for cell in kept}, {"plain", "prior"})
        with self.assertRaisesRegex(BadInput, "--planner best: there is plain, prior"):
            only(kept, ["best"])

    def test_reads_a_shard(self):
        from harness.arguments import parse, shard_of

        self.assertEqual(parse(["goals", "--shard", "2/4"]).shard, Shard(2, 4))
        for text in ("0/4", "5/4", "2", "a/b", "1/0"):
            with self.assertRaisesRegex(argparse.ArgumentTypeError, "I/N"):
                shard_of(text)
        self.assertIn("--shard", self.refusal("goals", "--shard", "3/2"))

    def test_refuses_what_cannot_be_meant(self):
        self.assertIn("MAP", self.refusal("own"))
        self.assertIn("MAP", self.refusal("goals", "map.png"))
        self.assertIn("--seeds", self.refusal("goals", "--seeds", "0"))
        for option in (("--planner", "prior"), ("--shard", "1/2"), ("--seeds", "3"), ("--limit", "1"), ("--quick",)):
            self.assertIn(f"{option[0]} is not for results", self.refusal("results", *option))
        self.assertIn("--journal", self.refusal("results", "a.jsonl", "--journal", "b.jsonl"))
        self.assertIn("--robot is for own only", self.refusal("scenes", "--robot", "car"))

    def test_takes_options_before_the_files(self):
        from harness.arguments import parse

        options = parse(["own", "--robot", "car", "map.png", "--quick"])
        self.assertEqual((options.files, options.robot, options.quick), ([Path("map.png")], "car", True))
        self.assertEqual(parse(["results", "--journal", "a.jsonl"]).files, [])
        self.assertEqual(parse(["own", "map.png"]).robot, experiments.ROBOT)

    def test_publishes_runs_of_one_clean_commit_only(self):
        from harness.page import refuse_mixture

        refuse_mixture(Results([session_of(), session_of()]))
        for commits in (("abc", "def"), ("abc-dirty",)):
            with self.assertRaisesRegex(JournalError, "one clean commit"):
                refuse_mixture(Results([session_of(commit=commit) for commit in commits]))

    def test_publishes_no_page_without_runs(self):
        from harness.page import refuse_none

        refuse_none(Results([session_of(), run_of(OURS, solved(1.0))]))
        for cells in ([], [Cell("own:map.json", "car", "adaptive")]):
            with self.assertRaisesRegex(JournalError, "no run of the pages' experiments"):
                refuse_none(Results([session_of()] + [run_of(cell, solved(1.0)) for cell in cells]))


class Queries(unittest.TestCase):
    MAP = "type octile\nheight 4\nwidth 6\nmap\nTTTTTT\nT....T\nT..TTT\nTTTTTT\n"

    def test_are_in_the_maps_world(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.map"
            path.write_text(self.MAP)
            lines = ["version 1", "0\ta.map\t6\t4\t1\t2\t4\t1\t3.41421", "0\ta.map\t6\t4\t1\t1\t1\t1\t0",
                     "200\ta.map\t6\t4\t1\t1\t4\t1\t101", ""]
            path.with_suffix(".map.scen").write_text("\n".join(lines) + "\n")
            [query] = movingai_queries(path)
        self.assertEqual(query["trial"], 1)
        self.assertEqual(query["start"][:2], [1.5, 1.5])
        self.assertEqual(query["goal"], [4.5, 2.5, 0.5])

    def test_are_the_trials_where_there_are_some(self):
        self.assertEqual(Problem("m", Path(), Path(), 0.0, ["a", "b"]).trial(1, 10001), "b")
        self.assertEqual(Problem("s", Path(), Path(), 0.0).trial(1, 10001), {"trial": 10002, "seed": 10002})
        far = Problem("f", Path(), Path(), 0.0, ends={"goal": [1, 2, 3]}).trial(0, 5)
        self.assertEqual(far, {"trial": 5, "seed": 5, "goal": [1, 2, 3]})

    def test_face_where_most_room_is(self):
        free = [[c == "." for c in row] for row in self.MAP.splitlines()[4:]]
        self.assertEqual(roomiest_heading(free, 1, 1), 0)
        self.assertAlmostEqual(roomiest_heading(free, 4, 1), math.pi)
        self.assertEqual(roomiest_heading(free, 1, 2), 0)


class Written(unittest.TestCase):
    """Claims and the README's table, from known runs."""

    def results(self, seconds_of):
        figures = {"vertices": 500, "plan_steps": 100, "step_error": 1e-4, "drift_m": 1e-3, "clearance_m": 0.01}
        figures |= {"goal_depth_m": 0.03}
        runs = [run_of(cell, solved(s) | figures if s else timed_out()) for cell, s in seconds_of.items()]
        return Results([session_of(), *runs])

    def found(self, seconds_of):
        return {claim.text: claim for group in claims(self.results(seconds_of)).values() for claim in group}

    def test_claims_say_by_how_much_and_whether(self):
        ours, prior = (Cell("gates", "snake:15", planner) for planner in ("adaptive", "prior"))
        [text] = [text for text in self.found({ours: 0.01, prior: 0.1}) if "prior" in text]
        for seconds, shown, holds in (
            (0.1, "10.0 [10, 10]", True),
            (0.005, "0.500 [0.50, 0.50]", False),
            (None, "≥ 1000 [1000, ∞]", True),
        ):
            claim = self.found({ours: 0.01, prior: seconds})[text]
            self.assertEqual((claim.found, claim.holds), (shown, holds))
        self.assertIsNone(self.found({ours: None, prior: 0.1})[text].holds)

    def test_claims_over_all_scenes_are_geometric_means(self):
        scenes = experiments.SCENES
        ours = {Cell(scene, "snake:15", "adaptive"): 0.1 * 4 ** (scene == "rooms") for scene in scenes}
        peers = {Cell(scene, "snake:15", "ompl:RRT"): None for scene in scenes}
        peers |= {Cell(scene, "snake:15", "ompl:EST"): 8.0 for scene in scenes}  # 80 / 4 ** 0.2 times ours
        large = {Cell(f"{scene}@4", "snake:15", "adaptive"): 0.16 for scene in scenes}
        long = {Cell("rooms", "snake:25", "adaptive"): 1.5}
        found = self.found(ours | peers | large | long)
        for text, shown, holds in (
            ("all scenes: median vertices: at most 600", "500 [500, 500]", True),
            ("all scenes: time of the best peer of each over ours: at least 60", "60.6 [61, 61]", True),
            ("all scenes: time a plan's step at scale 4 over that at 1: at most 1.5", "1.21 [1.2, 1.2]", True),
            ("all scenes: 90th percentile of time over its median: at most 2.5", "1.00 [1.0, 1.0]", True),
            ("rooms, snake:25: every run within 1 s", "0 of 1", False),
        ):
            self.assertEqual((found[text].found, found[text].holds), (shown, holds), text)

    def test_the_papers_comparison_is_by_its_own_criterion(self):
        pair = {Cell("comb", "snake:15", planner): s for planner, s in (("paper", 0.1), ("paper-prior", 2.0))}
        found = self.found(pair)
        self.assertEqual([claim.holds for text, claim in found.items() if "table 1" in text], [True])

    def test_the_readmes_table_is_replaced_and_nothing_else(self):
        results = self.results({cell: 0.5 for cell in readme.cells()})
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "README.md"
            page.write_text(f"before\n{readme.BEGIN}\nold\n{readme.END}\nafter\n")
            readme.write_table(results, page)
            text = page.read_text()
        self.assertTrue(text.startswith(f"before\n{readme.BEGIN}\nsnake:15, 1 seeds\n"))
        self.assertTrue(text.endswith(f"|\n{readme.END}\nafter\n"))
        self.assertIn("| rooms | 1 | 1 | 500.0 ms | 500.0 ms | 500 |\n", text)
        self.assertNotIn("old", text)

    def test_the_verifiers_figures_are_the_worst_of_each_scene(self):
        text = tables.proofs_section(self.results({Cell("rooms", "snake:15", "adaptive"): 0.5}))
        self.assertIn("| rooms | 1 | 1.0e-04 | 1.0 | 10.0 | 30.0 |\n", text)

    def test_the_readmes_table_is_of_all_scenes_or_none(self):
        cells = readme.cells()
        self.assertEqual(readme.missing(self.results({cell: 0.5 for cell in cells})), [])
        self.assertEqual(readme.missing(self.results({cell: 0.5 for cell in cells[2:]})), ["openings", "gates"])


class Prose(unittest.TestCase):
    def test_is_wrapped_and_nothing_else(self):
        row, title = "| " + "cell " * 40 + "|", "## " + "title " * 30
        page = "\n".join([title, "", row, "word " * 60 + "end", "of it.", "- " + "item " * 30 + "- 5", "- next", ""])
        lines = wrapped(page).split("\n")
        self.assertEqual(" ".join(lines).split(), page.split())
        self.assertEqual(lines[:3], [title, "", row])
        self.assertLessEqual(max(len(line) for line in lines if line not in (row, title)), 120)
        self.assertEqual(lines[5], "word " * 12 + "end of it.")
        self.assertEqual((lines[7], lines[8], lines[9]), ("  " + "item " * 7 + "- 5", "- next", ""))
        self.assertEqual(wrapped(wrapped(page)), wrapped(page))


class Parts(unittest.TestCase):
    """Of a search: what Google Benchmark reports for two seeds."""

    TIMES = {"open": (1.0, "us"), "set_up": (3.0, "us"), "plan": (0.023, "ms"), "floor": (8e3, "ns")}

    def setUp(self):
        entries = []
        for name, (time_, unit) in self.TIMES.items():
            for aggregate, factor in (("mean", 7), ("median", 1)):
                entry = {"run_name": name, "aggregate_name": aggregate, "cpu_time": factor * time_, "time_unit": unit}
                entries.append(entry)
        entries[5] |= {"seeds": 2.0, "vertices": 30.0, "attempts": 40.0, "expansions": 5.0, "plan_steps": 10.0}
        self.parts = parts_of({"benchmarks": entries})

    def test_are_the_medians_in_one_unit(self):
        self.assertAlmostEqual(self.parts.each("search"), 10)
        self.assertAlmostEqual(self.parts.each("floor"), 4)
        self.assertAlmostEqual(self.parts.share("open", "set_up"), 0.2)

    def test_are_held_against_the_floor(self):
        self.assertAlmostEqual(self.parts.over_floor, 2.5)
        self.assertAlmostEqual(self.parts.all_over_floor, 3)

    def block(self, floor):
        return replace(self.parts, times=self.parts.times | {"floor": floor})

    def test_of_several_blocks_are_of_all_their_seeds(self):
        both = together([self.parts, self.block(24e-6)])
        self.assertEqual((both.seeds, both.counts["vertices"]), (4, 60))
        self.assertAlmostEqual(both.each("floor"), 8)
        self.assertAlmostEqual(both.all_over_floor, 1.5)

    def test_have_an_interval_that_is_drawn_from_the_blocks(self):
        found = all_over_floor([[self.block(6e-6), self.block(8e-6), self.block(12e-6)]])
        self.assertAlmostEqual(found.estimate.value, 24 / (26 / 3))
        self.assertTrue(2 <= found.low < found.estimate.value < found.high <= 4)

    def test_are_measured_by_blocks_that_have_each_seed_once(self):
        for seeds in (1, 3, 60, 61):
            protocol = Protocol(seeds=seeds)
            blocks = blocks_of(protocol)
            measured = [seed for first, count in blocks for seed in range(first, first + count)]
            self.assertEqual(measured, list(range(protocol.first_seed, protocol.first_seed + seeds)))
            self.assertEqual(len(blocks), min(12, seeds))


class Experiments(unittest.TestCase):
    def test_name_each_cell_once(self):
        cells = experiments.cells_of("all")
        self.assertEqual(len(cells), len(set(cells)))
        self.assertEqual(len({cell.key for cell in cells}), len(cells))

    def test_of_goals_are_cells_of_others(self):
        others = {cell for name, cells in experiments.EXPERIMENTS.items() if name != "goals" for cell in cells()}
        self.assertEqual(set(experiments.goals()) - others, set())

    def test_have_the_papers_cells(self):
        self.assertEqual(len(experiments.links()), 5 * 5 * 4)
        self.assertEqual(len(experiments.streets()), 3 * 2)
        self.assertEqual(len(experiments.parameters()), 20)
        self.assertEqual(len(set(experiments.parameters())), 17)  # the defaults are one cell
        for name, values in experiments.PARAMETERS.items():
            self.assertIn(experiments.PAPER_DEFAULTS[name], values)

    def test_give_few_rounds_to_slow_peers_and_many_to_goals(self):
        rounds = experiments.rounds(Protocol())
        self.assertEqual(rounds[Cell("rooms", "snake:15", "ompl:RRT-random")], 20)
        self.assertNotIn(Cell("rooms", "snake:15", "ompl:SyclopEST"), rounds)
        self.assertEqual(rounds[OURS], 200)

    def test_of_a_users_own_have_every_planner(self):
        planners = [cell.planner for cell in experiments.own("map.png", "car")]
        self.assertEqual(planners, [*experiments.RIVALS, "fresh:adaptive", *experiments.PEERS])


if __name__ == "__main__":
    unittest.main()
