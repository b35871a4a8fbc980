# SPDX-License-Identifier: Apache-2.0
"""The benchmarks' driver itself: known timings in, right statistics out; giving up, censoring, resuming."""

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
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from harness import experiments, problems, readme, session  # noqa: E402
from harness.cells import Cell  # noqa: E402
from harness.claims import claims  # noqa: E402
from harness.journal import Journal, JournalError  # noqa: E402
from harness.machine import cores_described  # noqa: E402
from harness.parts import parts_of  # noqa: E402
from harness.pool import Pool  # noqa: E402
from harness.problems import Problem, movingai_queries, roomiest_heading  # noqa: E402
from harness.progress import Progress  # noqa: E402
from harness.prose import wrapped  # noqa: E402
from harness.protocol import Protocol, measure  # noqa: E402
from harness.results import Results, to_csv, to_json  # noqa: E402
from harness.statistics import Figure, deviation, mean, quantile, rounded, summarise, times, trimmed  # noqa: E402
from harness.stop import Stop, Stopped  # noqa: E402
from harness.worker import BadInput, Worker, timing_cores  # noqa: E402

LIMIT = 10.0


def solved(seconds, trial=1, **more):
    return {"trial": trial, "status": "solved", "verified": True, "time_s": seconds, "limit_s": LIMIT, **more}


def timed_out(trial=1, limit=LIMIT):
    return {"trial": trial, "status": "time_used", "time_s": limit, "limit_s": limit}


def trials(count):
    return [{"trial": i, "seed": i} for i in range(1, count + 1)]


class Statistics(unittest.TestCase):
    def test_sixty_runs_lose_five_at_each_end(self):
        figures = times([solved(float(i)) for i in range(60, 0, -1)], 100.0)
        kept = trimmed(figures)
        self.assertEqual([f.value for f in kept], [float(i) for i in range(6, 56)])
        self.assertEqual(mean(kept), Figure(30.5))
        self.assertAlmostEqual(deviation(kept), math.sqrt((50 * 50 - 1) / 12 * 50 / 49))

    def test_few_runs_lose_none(self):
        self.assertEqual(len(trimmed(times([solved(1.0)] * 11, LIMIT))), 11)
        self.assertEqual(len(trimmed(times([solved(1.0)] * 12, LIMIT))), 10)

    def test_quantiles_are_nearest_ranks_of_all_runs(self):
        figures = times([solved(float(i)) for i in range(1, 61)], 100.0)
        self.assertEqual([quantile(figures, q).value for q in (0.5, 0.9, 0.99, 1.0)], [30, 54, 60, 60])
        self.assertEqual(quantile([Figure(7.0)], 0.01).value, 7)

    def test_a_time_out_is_a_bound(self):
        summary = summarise([solved(1.0), solved(2.0), timed_out()], 3, LIMIT, False)
        self.assertEqual(summary.mean, Figure(13 / 3, True))
        self.assertIsNone(summary.deviation)
        self.assertEqual(summary.median, Figure(2.0))
        self.assertEqual(summary.p90, Figure(LIMIT, True))
        self.assertEqual(summary.p90.shown(), "≥ 10.0")
        self.assertAlmostEqual(summary.success, 2 / 3)

    def test_trimmed_time_outs_leave_the_mean_exact(self):
        runs = [solved(1.0)] * 55 + [timed_out()] * 5
        self.assertEqual(summarise(runs, 60, LIMIT, False).mean, Figure(1.0))
        runs = [solved(1.0)] * 54 + [timed_out()] * 6
        self.assertTrue(summarise(runs, 60, LIMIT, False).mean.at_least)

    def test_a_plan_that_is_late_or_not_verified_is_none(self):
        late, wrong = solved(LIMIT + 0.1), solved(1.0) | {"verified": False}
        summary = summarise([late, wrong, solved(LIMIT)], 3, LIMIT, False)
        self.assertEqual((summary.solved, summary.unverified), (1, 1))
        self.assertEqual(times([wrong], LIMIT), [Figure(LIMIT, True)])

    def test_medians_are_of_solved_runs_that_tell(self):
        runs = [solved(1.0, vertices=10), solved(1.0, vertices=30), solved(1.0), timed_out() | {"vertices": 999}]
        self.assertEqual(summarise(runs, 4, LIMIT, False).medians, {"vertices": 10})

    def test_numbers_keep_their_digits(self):
        self.assertEqual([rounded(x) for x in (0.012345, 1.0, 12345.0, 0)], ["0.0123", "1.00", "12300", "0"])


class GivingUp(unittest.TestCase):
    def made(self, outcomes, give_up, known=None):
        asked = []

        def run(trial):
            asked.append(trial["trial"])
            return outcomes[trial["trial"] - 1]

        runs = list(measure(trials(len(outcomes)), LIMIT, give_up, known or {}, run))
        return runs, asked

    def test_after_failures_in_a_row(self):
        runs, _ = self.made([timed_out()] * 60, 10)
        self.assertEqual(len(runs), 10)

    def test_not_after_failures_with_a_success_between(self):
        runs, _ = self.made(([timed_out()] * 9 + [solved(1.0)]) * 6, 10)
        self.assertEqual(len(runs), 60)

    def test_never_where_every_trial_is_another_problem(self):
        runs, _ = self.made([timed_out()] * 60, None)
        self.assertEqual(len(runs), 60)

    def test_runs_of_an_earlier_session_count(self):
        known = {i: timed_out(i) for i in range(1, 9)}
        runs, asked = self.made([timed_out()] * 60, 10, known)
        self.assertEqual((len(runs), asked), (10, [9, 10]))


class Resuming(unittest.TestCase):
    def run_with(self, known, limit):
        asked = []

        def run(trial):
            asked.append(trial["trial"])
            return solved(1.0, trial["trial"])

        list(measure(trials(3), limit, 10, known, run))
        return asked

    def test_finished_trials_are_not_run_again(self):
        self.assertEqual(self.run_with({1: solved(1.0), 3: timed_out()}, LIMIT), [2])

    def test_a_time_out_under_a_shorter_limit_says_nothing(self):
        self.assertEqual(self.run_with({1: timed_out(limit=5.0), 2: timed_out(limit=20.0)}, LIMIT), [1, 3])

    def test_a_run_that_took_longer_than_the_new_limit_is_a_time_out(self):
        self.assertEqual(self.run_with({1: solved(8.0)}, 5.0), [2, 3])
        self.assertEqual(times([solved(8.0)], 5.0), [Figure(5.0, True)])


class Limits(unittest.TestCase):
    def test_follow_the_adaptive_median(self):
        rival = Cell("rooms", "snake:15", "prior")
        self.assertEqual(Protocol().limit_of(rival, [solved(0.001)] * 3), 5.0)
        self.assertEqual(Protocol().limit_of(rival, [solved(0.02)] * 3), 20.0)
        self.assertEqual(Protocol(limit=3.0).limit_of(rival, []), 3.0)

    def test_the_adaptive_planner_has_the_papers(self):
        self.assertEqual(Protocol().limit_of(Cell("rooms", "snake:15", "adaptive"), []), 100.0)
        changed = Cell("rooms", "snake:15", "adaptive", ("alpha=4",))
        self.assertEqual(Protocol().limit_of(changed, [solved(0.02)]), 20.0)


class JournalFile(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name) / "runs.jsonl"

    def record(self, trial, build="b", **more):
        return {"kind": "run", "cell": "c", "build": build, **solved(1.0, trial), **more}

    def test_keeps_what_was_appended(self):
        journal = Journal(self.path)
        journal.append(self.record(1))
        journal.close()
        self.assertEqual(Journal(self.path, writable=False).runs("c", "b"), {1: self.record(1)})

    def test_cuts_off_a_torn_line_and_goes_on(self):
        self.path.write_text(json.dumps(self.record(1)) + "\n" + '{"kind": "run", "cel')
        journal = Journal(self.path)
        journal.append(self.record(2))
        journal.close()
        self.assertEqual(sorted(Journal(self.path, writable=False).runs("c", "b")), [1, 2])

    def test_refuses_a_second_writer(self):
        first = Journal(self.path)
        with self.assertRaisesRegex(JournalError, "another"):
            Journal(self.path)
        first.close()

    def test_names_a_broken_line(self):
        self.path.write_text("{}\nnonsense\n")
        with self.assertRaisesRegex(JournalError, "line 2"):
            Journal(self.path, writable=False)

    def test_tells_builds_apart_and_takes_the_last_run_of_a_trial(self):
        journal = Journal(self.path)
        journal.append(self.record(1, build="old"))
        journal.append(self.record(1, time_s=2.0))
        journal.append(self.record(1, time_s=3.0))
        self.assertEqual(journal.runs("c", "b")[1]["time_s"], 3.0)
        self.assertEqual(journal.runs("c", "old")[1]["time_s"], 1.0)
        self.assertEqual(list(journal.runs("c", None)), [1])
        journal.close()

    def test_results_take_the_cell_as_it_was_last_finished(self):
        cell = Cell("rooms", "snake:15", "adaptive")
        journal = Journal(self.path)
        for trial in (1, 2, 3):
            journal.append(self.record(trial) | {"cell": cell.key})
        finished = {"kind": "cell", "cell": cell.key, "build": "b", "limit_s": LIMIT, "asked": 60}
        journal.append(finished | {"given_up": False, "trials": [1]})
        journal.append(finished | {"given_up": True, "trials": [1, 2]})
        summary = Results(journal).summary(cell)
        self.assertEqual((summary.runs, summary.given_up), (2, True))
        self.assertIsNone(Results(journal).summary(Cell("comb", "snake:15", "adaptive")))
        self.assertIn("rooms,snake:15,adaptive", to_csv(Results(journal).rows([cell])))
        journal.close()

    def test_results_know_what_is_not_in_the_journal_from_an_earlier_table(self):
        measured, earlier = (Cell(scene, "snake:15", "adaptive") for scene in ("rooms", "gates"))
        journal = Journal(self.path)
        for trial, cell in enumerate((measured, earlier), 1):
            journal.append(self.record(trial, **{"time_s": 0.5 * trial}) | {"cell": cell.key, "vertices": 7})
            finished = {"kind": "cell", "cell": cell.key, "build": "b", "limit_s": LIMIT, "asked": 1, "commit": "abc"}
            journal.append(finished | {"given_up": False, "trials": [trial]})
        table = json.loads(to_json(Results(journal).rows([measured, earlier])))
        self.assertEqual({row["commit"] for row in table}, {"abc"})
        table[0]["median_s"] = 99.0  # the journal knows better
        journal.records = [record for record in journal.records if record.get("cell") != earlier.key]
        results = Results(journal, table)
        self.assertEqual(results.summary(measured).median, Figure(0.5))
        self.assertFalse(results.summary(measured).earlier)
        self.assertEqual(results.summary(earlier).median, Figure(1.0))
        self.assertEqual(results.summary(earlier).medians, {"vertices": 7})
        self.assertTrue(results.summary(earlier).earlier)
        self.assertEqual(results.rows([earlier]), [table[1]])
        self.assertIsNone(results.of_journal().summary(earlier))
        journal.close()


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
    def worker(self, fresh=False, stop=None):
        worker = Worker(["/usr/bin/python3", "-c", PROGRAM], 1, fresh, timing_cores(1)[0], stop or Stop())
        self.addCleanup(worker.stop)
        return worker

    def test_answer_in_turn(self):
        for fresh in (False, True):
            worker = self.worker(fresh)
            self.assertEqual([worker.run({"trial": i})["trial"] for i in (1, 5, 6)], [1, 5, 6])

    def test_that_crash_or_hang_cost_one_trial(self):
        worker = self.worker()
        self.assertEqual(worker.run({"trial": 2})["status"], "crashed")
        worker.patience = 0.5
        self.assertEqual(worker.run({"trial": 3})["status"], "hung")
        worker.patience = 60
        self.assertEqual(worker.run({"trial": 1})["status"], "solved")

    def test_that_refuse_their_input_end_the_session(self):
        with self.assertRaisesRegex(BadInput, "bad scene"):
            self.worker().run({"trial": 4})

    def test_are_not_waited_for_once_told_to_stop(self):
        stop = Stop()
        worker = self.worker(stop=stop)
        threading.Timer(0.2, stop.say).start()
        with self.assertRaises(Stopped):
            worker.run({"trial": 3})


class Pools(unittest.TestCase):
    def test_begin_in_order_and_do_everything_once(self):
        done = []
        Pool([7]).each("abc", lambda *item: done.append(item))
        self.assertEqual(done, [("a", 7), ("b", 7), ("c", 7)])
        done.clear()
        Pool([0, 1]).each(range(1000), lambda item, _: done.append(item))
        self.assertEqual(sorted(done), list(range(1000)))

    def test_work_on_all_cores_at_once(self):
        meeting = threading.Barrier(2, timeout=30)
        cores = []

        def meet(_, core):
            meeting.wait()
            cores.append(core)

        Pool([0, 1]).each("ab", meet)
        self.assertEqual(sorted(cores), [0, 1])

    def test_end_all_when_one_fails(self):
        pool = Pool([0, 1])
        done = []

        def work(item, _):
            done.append(item)
            if item == "bad":
                raise BadInput("bad scene")
            while not pool.stop.said:
                time.sleep(0.01)

        with self.assertRaisesRegex(BadInput, "bad scene"):
            pool.each(["slow", "bad", "never"], work)
        self.assertEqual(sorted(done), ["bad", "slow"])


# Answers with the core that it runs on; a scene's name says how it behaves.
SEARCH = """#!/usr/bin/python3
import json, os, sys, time
scene = sys.argv[sys.argv.index("--scene") + 1]
for line in sys.stdin:
    if "refusing" in scene: print("bad scene", file=sys.stderr); sys.exit(2)
    if "endless" in scene: time.sleep(100)
    answer = {"status": "solved", "verified": True, "time_s": 0.02, "cores": sorted(os.sched_getaffinity(0))}
    print(json.dumps({"trial": json.loads(line)["trial"], **answer}), flush=True)
"""


class Sessions(unittest.TestCase):
    """With a program that answers at once, and problems that need no compiling."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        program = self.folder / "krait-bench-search"
        program.write_text(SEARCH)
        program.chmod(0o755)
        self.compiled = []
        for where, name, stand_in in (
            (session, "BIN", self.folder),
            (session.problems, "prepare", self.prepare),
            (session.machine, "describe", lambda cores: {"pinned_to_cores": cores, "commit": "abc"}),
        ):
            patch = mock.patch.object(where, name, stand_in)
            patch.start()
            self.addCleanup(patch.stop)

    def prepare(self, name, folder):
        self.compiled.append(name)
        scene = folder / f"{name}.krait"
        scene.write_text(name)
        return Problem(name, scene, scene, 0.1)

    def measure(self, cells, cores=1, seeds=3, stream=None):
        """The journal's records."""
        pinned = (timing_cores(cores) * cores)[:cores]  # a machine with one core will do
        path = self.folder / f"{cores}.jsonl"
        try:
            with Journal(path) as journal:
                progress = Progress(stream or io.StringIO())
                session.Session(self.folder, journal, Protocol(seeds=seeds), progress, pinned).measure_all(cells)
        finally:
            self.records = Journal(path, writable=False).records
        return self.records

    def cells(self, *scenes, planners=("prior", "rrt", "adaptive")):
        return [Cell(scene, "snake:15", planner) for scene in scenes for planner in planners]

    def test_on_two_cores_measure_what_one_does(self):
        def content(records):
            return sorted(json.dumps(record | {"cores": 0}) for record in records if record["kind"] != "session")

        cells = self.cells("rooms", "comb", "gates")
        one, two = self.measure(cells, 1), self.measure(cells, 2)
        self.assertEqual(content(one), content(two))
        self.assertEqual(sum(record["kind"] == "run" for record in two), 3 * len(cells))
        self.assertEqual(self.compiled, 2 * ["rooms", "comb", "gates"])

    def test_pin_each_program_to_one_of_the_cores(self):
        started, *records = self.measure(self.cells("rooms", "comb"), 2)
        cores = [record["cores"] for record in records if record["kind"] == "run"]
        self.assertEqual({len(pinned) for pinned in cores}, {1})
        self.assertLessEqual({core for [core] in cores}, set(started["pinned_to_cores"]))

    def test_compile_first_then_measure_all_references_then_the_others(self):
        kinds = {"compiled": 0, "run": 1, "cell": 1}
        for cores in (1, 2):
            _, *records = self.measure(self.cells("rooms", "comb"), cores)
            order = [kinds[r["kind"]] + ("cell" in r and "adaptive" not in r["cell"]) for r in records]
            self.assertEqual(order, sorted(order))
            self.assertEqual(set(order), {0, 1, 2})

    def test_measure_references_that_nobody_asked_for_where_they_set_the_limit(self):
        records = self.measure(self.cells("rooms", planners=["prior"]), 2)
        limits = {record["cell"]: record["limit_s"] for record in records if record["kind"] == "cell"}
        self.assertEqual(limits, {"rooms snake:15 adaptive": 100.0, "rooms snake:15 prior": 20.0})
        self.assertEqual(session.in_phases(self.cells("rooms", planners=["prior"]), False)[0], [])

    def test_go_on_where_they_were_broken_off(self):
        self.measure(self.cells("rooms", "comb"), 2, seeds=2)
        records = self.measure(self.cells("rooms", "comb"), 2, seeds=3)
        self.assertEqual(sum(record["kind"] == "run" for record in records), 3 * 6)

    def test_skip_problems_that_are_not_there(self):
        shown = io.StringIO()
        with mock.patch.object(problems, "SAMPLES", self.folder):
            self.measure(self.cells("movingai/none", "rooms", planners=["prior"]), 2, stream=shown)
        first = f"[1/3] movingai/none snake:15 prior: skipped: {self.folder / 'movingai/none.map'} is not there"
        self.assertEqual(shown.getvalue().splitlines()[0], first)
        self.assertEqual(self.compiled, ["rooms"])

    def test_end_when_one_program_refuses_its_input(self):
        begin = time.monotonic()
        with self.assertRaisesRegex(BadInput, "bad scene"):
            self.measure(self.cells("endless", "rooms", "refusing"), 2)
        self.assertLess(time.monotonic() - begin, 30)
        self.assertEqual({record["status"] for record in self.records if record["kind"] == "run"}, {"solved"})
        self.assert_no_program_is_left()

    def test_end_at_once_when_interrupted(self):
        before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a job in the background ignores it
        self.addCleanup(signal.signal, signal.SIGINT, before)
        begin = time.monotonic()
        timer = threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT))
        self.addCleanup(timer.cancel)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            self.measure(self.cells("endless", "endless2", "rooms"), 2)
        self.assertLess(time.monotonic() - begin, 30)
        self.assertFalse([record for record in self.records if record["kind"] == "run"])
        self.assert_no_program_is_left()

    def assert_no_program_is_left(self):
        for process in Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):
                self.assertNotIn(str(self.folder).encode(), (process / "cmdline").read_bytes())


class ProgressShown(unittest.TestCase):
    def setUp(self):
        self.stream = io.StringIO()
        self.progress = Progress(self.stream)
        self.clock = 0.0
        patch = mock.patch("time.monotonic", lambda: self.clock)
        patch.start()
        self.addCleanup(patch.stop)

    def test_of_two_cells_at_once(self):
        a, b, known, last = (Cell("rooms", "snake:15", name) for name in "abcd")
        self.progress.expect(4)
        self.progress.begin_cell(known)
        self.clock = 5.0
        self.progress.end_cell(known, "there")
        for cell in (a, b):
            self.progress.begin_cell(cell)
        for cell in (b, a, b):
            self.progress.made_run(cell, 1, 2, LIMIT)
        self.clock = 45.0
        self.progress.end_cell(a, "solved")
        self.progress.begin_cell(last)
        self.progress.end_cell(b, "solved too")
        self.assertEqual(
            self.stream.getvalue().splitlines(),
            [
                "[1/4] rooms snake:15 c: there",
                "[2/4, about 80 s left] rooms snake:15 a: solved",
                "[3/4, about 20 s left] rooms snake:15 b: solved too",
            ],
        )

    def test_on_a_terminal_is_of_the_last_run(self):
        self.stream.isatty = lambda: True
        a, b = (Cell("rooms", "snake:15", name) for name in "ab")
        for cell in (a, b):
            self.progress.begin_cell(cell)
        for cell in (a, b):
            self.progress.made_run(cell, 1, 2, LIMIT)
        last = self.stream.getvalue().split("\r\033[K")[-1]
        self.assertEqual(last, "[0/0] rooms snake:15 b: 1 of 2, limit 10 s")


class Planners(unittest.TestCase):
    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "bench/run's program draws")
    def test_can_be_measured_alone(self):
        from harness.__main__ import only

        cells = experiments.cells_of("scenes")
        kept = only(cells, ["plain", "prior"])
        self.assertEqual(len(kept), 2 * len(experiments.SCENES))
        self.assertEqual({cell.planner for cell in kept}, {"plain", "prior"})
        with self.assertRaisesRegex(BadInput, "--planner best: there is .*adaptive"):
            only(cells, ["best"])


class Cores(unittest.TestCase):
    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "bench/run's program draws")
    def test_that_are_not_there_are_refused(self):
        from harness.__main__ import parse

        there = len(os.sched_getaffinity(0))
        self.assertEqual(parse(["scenes"]).cores, 1)
        self.assertEqual(parse(["scenes", "--cores", str(there)]).cores, there)
        for count in (0, -1, there + 1):
            with contextlib.redirect_stderr(io.StringIO()) as complaint, self.assertRaises(SystemExit):
                parse(["scenes", "--cores", str(count)])
            self.assertIn(f"--cores must be between 1 and {there}", complaint.getvalue())

    def test_are_the_last(self):
        with mock.patch("os.sched_getaffinity", lambda _: {5, 0, 2}):
            self.assertEqual([timing_cores(count) for count in (1, 2, 3)], [[5], [2, 5], [0, 2, 5]])

    def test_are_told_of_all_sessions(self):
        old, one, two = {"cores": 4}, {"cores": 4, "pinned_to_cores": [3]}, {"cores": 4, "pinned_to_cores": [2, 3]}
        self.assertEqual(cores_described([old]), "4 cores")
        self.assertEqual(cores_described([old, one]), "4 cores, core 3 for the timed program")
        self.assertEqual(cores_described([two, one]), "4 cores, cores 2 and 3 for timed programs, one each")


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

    def test_are_all_asked_or_evenly_spread(self):
        problem = Problem("m", Path(), Path(), 0.0, list(range(10)))
        self.assertEqual(problem.trials(60, 0), list(range(10)))
        self.assertEqual(problem.trials(60, 3), [0, 3, 6])
        self.assertEqual(problem.trials(60, 99), list(range(10)))
        seeds = Problem("s", Path(), Path(), 0.0).trials(2, 0)
        self.assertEqual(seeds, [{"trial": 1, "seed": 1}, {"trial": 2, "seed": 2}])

    def test_face_where_most_room_is(self):
        free = [[c == "." for c in row] for row in self.MAP.splitlines()[4:]]
        self.assertEqual(roomiest_heading(free, 1, 1), 0)
        self.assertAlmostEqual(roomiest_heading(free, 4, 1), math.pi)
        self.assertEqual(roomiest_heading(free, 1, 2), 0)


class Written(unittest.TestCase):
    """Claims and the README's table, from a journal with known runs."""

    def results(self, seconds_of):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        figures = {"vertices": 5, "step_error": 1e-4, "drift_m": 1e-3, "clearance_m": 0.01, "goal_depth_m": 0.03}
        with Journal(Path(folder.name) / "runs.jsonl") as journal:
            for cell, seconds in seconds_of.items():
                run = solved(seconds) | figures if seconds else timed_out()
                journal.append({"kind": "run", "cell": cell.key, "build": "b", **run})
                finished = {"limit_s": LIMIT, "asked": 1, "given_up": False, "trials": [1]}
                journal.append({"kind": "cell", "cell": cell.key, "build": "b", **finished})
            return Results(journal)

    def test_claims_say_by_how_much_and_whether(self):
        ours, prior, rrt = (Cell("gates", "snake:15", planner) for planner in ("adaptive", "prior", "rrt"))
        slow, fast = (Cell("gates", "snake:15", peer) for peer in ("ompl:RRT", "ompl:SyclopEST"))
        published = Cell("gates", "snake:15", "prior-unpruned")
        known = {ours: 0.01, published: 0.7, prior: 0.1, rrt: None, slow: None, fast: 0.3}
        found = claims(self.results(known))
        self.assertEqual(
            [(claim.found, claim.holds) for claim in found],
            [("70.0 ×", True), ("10.0 ×", False), ("≥ 1000 ×", True), ("30.0 ×", True), ("1 of 1", True)],
        )
        self.assertIn("SyclopEST", found[3].text)
        [undecided, _] = claims(self.results({ours: 1.0, prior: None}))
        self.assertEqual((undecided.found, undecided.holds), ("≥ 10.0 ×", None))

    def test_claims_over_all_scenes_are_geometric_means(self):
        scenes = experiments.SCENES
        ours = {Cell(scene, "snake:15", "adaptive"): seconds for scene, seconds in zip(scenes, (0.1, 0.1, 0.4, 0.1, 0.1))}
        plain = {Cell(scene, "snake:15", "plain"): 0.5 for scene in scenes}
        peers = {Cell(scene, "snake:15", "ompl:RRT"): None for scene in scenes}
        large = {Cell(f"{scene}@4", "snake:15", "adaptive"): 0.16 for scene in scenes}
        long = {Cell("rooms", "snake:25", "adaptive"): 1.5}
        repairs = {experiments.with_setting("kappa", value): seconds for value, seconds in (("1", 0.42), ("20", 0.4))}
        found = {claim.text: claim for claim in claims(self.results(ours | plain | peers | large | long | repairs))}
        for text, shown, holds in (
            ("all scenes: 5 × faster than plain in the median", "3.79 ×", False),  # 5 / 4 ** 0.2
            ("all scenes: 60 × faster than the best peer of each in the median", "≥ 75.8 ×", True),
            ("all scenes: 90th percentile over median at most 2.5", "1.00", True),
            ("all scenes: median vertices at most 2500", "5.00", True),
            ("comb, 4 times as large: at most 1.5 × in the median", "1.60 ×", False),
            ("all scenes, 4 times as large: at most 1.5 × in the median", "1.21 ×", True),  # 1.6 / 4 ** 0.2
            ("kappa 1: at most 1.1 × kappa 20 in the median", "1.05 ×", True),
            ("rooms, snake:25: 95 % of the runs solved within 1 s", "0 of 1", False),
        ):
            self.assertEqual((found[text].found, found[text].holds), (shown, holds), text)

    def test_claims_leave_out_what_no_run_tells(self):
        none = {Cell(scene, "snake:15", "adaptive"): None for scene in experiments.SCENES}
        self.assertNotIn("vertices", " ".join(claim.text for claim in claims(self.results(none))))

    def test_claims_that_a_bound_leaves_open_are_open(self):
        ours, large = (Cell(problem, "snake:15", "adaptive") for problem in ("comb", "comb@4"))
        known = self.results({ours: LIMIT, large: None})
        [open_] = [claim for claim in claims(known) if "at most 1.5" in claim.text]
        self.assertEqual((open_.found, open_.holds), ("≥ 1.00 ×", None))

    def test_the_readmes_table_is_replaced_and_nothing_else(self):
        results = self.results({cell: 0.5 for cell in readme.cells()})
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "README.md"
            page.write_text(f"before\n{readme.BEGIN}\nold\n{readme.END}\nafter\n")
            readme.write_table(results, page)
            text = page.read_text()
        self.assertTrue(text.startswith(f"before\n{readme.BEGIN}\nsnake:15, adaptive, 1 seeds\n"))
        self.assertTrue(text.endswith(f"|\n{readme.END}\nafter\n"))
        self.assertIn("| rooms | 1 | 1 | 500.0 | 500.0 | 5 | 5 | 1.0e-04 | 1.0 | 10.0 | 30.0 |\n", text)
        self.assertNotIn("old", text)


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
        for name, (time, unit) in self.TIMES.items():
            for aggregate, factor in (("mean", 7), ("median", 1)):
                entries.append({"run_name": name, "aggregate_name": aggregate, "cpu_time": factor * time, "time_unit": unit})
        entries[5] |= {"seeds": 2.0, "vertices": 30.0, "attempts": 40.0, "expansions": 5.0, "plan_steps": 10.0}
        self.parts = parts_of({"benchmarks": entries})

    def test_are_the_medians_in_one_unit(self):
        self.assertAlmostEqual(self.parts.each("search"), 10)
        self.assertAlmostEqual(self.parts.each("floor"), 4)
        self.assertAlmostEqual(self.parts.share("open", "set_up"), 0.2)

    def test_are_held_against_the_floor(self):
        self.assertAlmostEqual(self.parts.over_floor, 2.5)
        self.assertAlmostEqual(self.parts.all_over_floor, 3)


class Experiments(unittest.TestCase):
    def test_measure_what_sets_limits_first(self):
        cells = experiments.cells_of("all")
        references = [cell == cell.reference for cell in cells]
        self.assertEqual(references, sorted(references, reverse=True))
        self.assertEqual(len(cells), len(set(cells)))
        self.assertTrue(all(cell.reference in cells for cell in cells))

    def test_of_goals_are_cells_of_others(self):
        others = {cell for name, cells in experiments.EXPERIMENTS.items() if name != "goals" for cell in cells()}
        self.assertEqual(set(experiments.goals()) - others, set())
        self.assertEqual(len(experiments.goals()), 5 * 6 + 2)

    def test_have_the_papers_cells(self):
        self.assertEqual(len(experiments.links()), 5 * 5 * 3)
        self.assertEqual(len(experiments.scale()), 5 * 3 + 4)  # and our other scenes
        self.assertEqual(len(experiments.parameters()), 21)  # and our own beta
        self.assertEqual(len(set(experiments.parameters())), 18)


if __name__ == "__main__":
    unittest.main()
