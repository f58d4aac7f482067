# SPDX-License-Identifier: Apache-2.0
"""Limits and goals: --max-cycles, the budget and its smallest changes, and what the statistics say of waits, latencies
and occupancy."""

import copy
import json

import jsonschema

import tool
from tool import LIMIT, MACHINES, SCENES, SOURCE, USAGE

KEEL = SCENES / "keel.json"
SMALL = [KEEL, "--size", "32x24", "--max-level", "3"]
SETTINGS = ["intersection.units", "clock_mhz", "max_level", "size"]


def budget_schema():
    document = json.loads((SOURCE / "docs" / "schemas" / "budget.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(document)
    return jsonschema.Draft202012Validator(document)


class MaxCycles(tool.EndToEnd):
    def test_simulate_to_the_cycle(self):
        """The frame's own cycles are enough, one less is not; nothing is left behind."""
        for engine in ("decoupled", "lockstep"):
            simulate = ["simulate", *SMALL, "--engine", engine, "-o", "out.png", "--trace", "out.vcd", "--stats"]
            cycles = self.stats("simulate", *SMALL)["machine"]["cycles"]
            for limit in (1, cycles // 2, cycles - 1):
                self.refused(LIMIT, *simulate, "out.json", "--max-cycles", limit, more_lines=True,
                             says=f"the frame is not finished within {limit} cycles")
            self.ok(*simulate, "out.json", "--max-cycles", cycles)
            self.assertEqual({file.name for file in self.folder.iterdir()}, {"out.png", "out.vcd", "out.json"})
            for file in self.folder.iterdir():
                file.unlink()

    def test_an_old_file_stays(self):
        self.write("out.json", "old")
        self.refused(LIMIT, "simulate", *SMALL, "--stats", "out.json", "--max-cycles", 9, more_lines=True)
        self.assertEqual((self.folder / "out.json").read_text(), "old")

    def test_the_state_names_every_unit_and_fifo(self):
        document = self.stats("simulate", *SMALL)
        lines = self.run_tool("simulate", *SMALL, "--max-cycles", 500).stderr.splitlines()
        names = [item["name"] for kind in ("units", "fifos") for item in document[kind]]
        self.assertEqual([line.split(":")[0].strip() for line in lines[1:] if line], names)

    def test_sweep(self):
        sweep = ["sweep", KEEL, "--size", "32x24", "--max-level", "0,3", "--reference", "point", "--csv", "out.csv"]
        cycles = self.stats("simulate", *SMALL)["machine"]["cycles"]
        self.refused(LIMIT, *sweep, "--max-cycles", cycles - 1, more_lines=True, says=f"within {cycles - 1} cycles")
        self.ok(*sweep, "--max-cycles", cycles)

    def test_budget(self):
        cycles = self.stats("budget", *SMALL)["cycles"]
        self.refused(LIMIT, "budget", *SMALL, "--max-cycles", cycles - 1, "--stats", "out.json", more_lines=True,
                     says=f"the frame is not finished within {cycles - 1} cycles")
        self.ok("budget", *SMALL, "--max-cycles", cycles, "--stats", "out.json")

    def test_budget_reports_the_state_as_simulate_does(self):
        """The state of a machine with 256 units comes in many pieces from the process that simulates it."""
        for arguments in ([], ["--set", "intersection.units=256"]):
            limited = [*SMALL, *arguments, "--max-cycles", 500]
            of_simulate, of_budget = (self.run_tool(command, *limited) for command in ("simulate", "budget"))
            self.assertEqual((of_budget.returncode, of_budget.stderr), (LIMIT, of_simulate.stderr))
            self.assertIn("\n  frame_buffer: ready at ", of_budget.stderr)

    def test_usage(self):
        for command in ("simulate", "sweep", "budget"):
            for value in ("0", "-1", "1.5", "x", "", "18446744073709551615", "99999999999999999999"):
                self.refused(USAGE, command, KEEL, "--max-cycles", value, says="--max-cycles")


class Budget(tool.EndToEnd):
    def budget(self, *arguments):
        document = self.stats("budget", *arguments)
        errors = [f"{error.json_path}: {error.message}" for error in budget_schema().iter_errors(document)]
        self.assertEqual(errors, [], arguments)
        return document

    def meets(self, fps, scene=KEEL, size="32x24", level=3, **settings):
        """Whether a simulation of its own meets the goal."""
        sets = [argument for key, value in settings.items() for argument in ("--set", f"{key}={value}")]
        document = self.stats("simulate", scene, "--size", size, "--max-level", level, "--set", f"goal_fps={fps}", *sets)
        return document["machine"]["budget"]["met"]

    def test_met(self):
        document = self.budget(*SMALL)
        self.assertEqual(document["budget"], {"goal_fps": 30, "cycles": 6666666, "met": True})
        self.assertEqual(document["changes"], [])
        simulated = self.stats("simulate", *SMALL)["machine"]
        for key in ("cycles", "frames_per_second", "budget"):
            self.assertEqual(document[key], simulated[key])
        self.assertEqual(document["machine"], simulated["name"])
        text = self.ok("budget", *SMALL)
        self.assertIn("budget: 6666666 cycles for 30 frames per second, met by", text)
        self.assertNotIn("changes", text)

    def test_met_to_the_cycle(self):
        """A goal whose budget is the frame's cycles is met; one cycle less is not."""
        machine = self.stats("simulate", *SMALL)["machine"]
        for cycles, met in ((machine["cycles"], True), (machine["cycles"] - 1, False)):
            fps = machine["clock_mhz"] * 1e6 / (cycles + 0.5)  # between this budget and the next
            document = self.budget(*SMALL, "--fps", fps)
            self.assertEqual((document["budget"]["cycles"], document["budget"]["met"]), (cycles, met))

    def test_missed(self):
        text = self.ok("budget", *SMALL, "--fps", 20000)
        self.assertIn("budget: 10000 cycles for 20000 frames per second, missed by", text)
        rows = [line.split() for line in text.split("simulated:\n")[1].splitlines()]
        document = self.budget(*SMALL, "--fps", 20000)
        self.assertEqual([row[0] for row in rows], SETTINGS)
        for row, change in zip(rows, document["changes"]):
            self.assertEqual((row[0], row[1], row[3], int(row[4])),
                             (change["setting"], change["from"], change["to"], change["cycles"]))

    def test_each_change_is_the_smallest(self):
        for scene, fps in ((KEEL, 20000), (KEEL, 11000), (SCENES / "spheres.json", 9000)):
            document = self.budget(scene, "--size", "32x24", "--max-level", 3, "--fps", fps)
            self.assertFalse(document["budget"]["met"])
            self.assertEqual([change["setting"] for change in document["changes"]], SETTINGS)
            units, clock, level, size = document["changes"]
            for change in document["changes"]:
                self.assertTrue(change["met"], change)
                self.assertGreaterEqual(change["frames_per_second"], fps)
            to = int(units["to"])
            self.assertTrue(self.meets(fps, scene, **{"intersection.units": to}))
            self.assertFalse(self.meets(fps, scene, **{"intersection.units": to - 1}))
            to = int(clock["to"])
            self.assertTrue(self.meets(fps, scene, clock_mhz=to))
            self.assertFalse(self.meets(fps, scene, clock_mhz=to - 1))
            to = int(level["to"])
            self.assertTrue(self.meets(fps, scene, level=to))
            self.assertFalse(self.meets(fps, scene, level=to + 1))
            columns, rows = map(int, size["to"].split("x"))
            self.assertEqual(rows, columns * 3 // 4 if columns % 4 == 0 else round(columns * 0.75 + 1e-9))
            self.assertTrue(self.meets(fps, scene, size=size["to"]))
            wider = columns + 1
            self.assertFalse(self.meets(fps, scene, size=f"{wider}x{round(wider * 0.75 + 1e-9)}"))

    def test_a_changed_frame_is_that_of_simulate(self):
        for change in self.budget(*SMALL, "--fps", 20000)["changes"]:
            base = ["simulate", KEEL, "--size", "32x24", "--max-level", 3]
            option = {"max_level": ["--max-level", change["to"]], "size": ["--size", change["to"]]}
            arguments = option.get(change["setting"], ["--set", f"{change['setting']}={change['to']}"])
            machine = self.stats(*base, *arguments)["machine"]
            self.assertEqual(change["cycles"], machine["cycles"])
            self.assertEqual(change["frames_per_second"], machine["frames_per_second"])

    def test_not_enough(self):
        document = self.budget(*SMALL, "--fps", 1e6)
        units, clock, level, size = document["changes"]
        self.assertEqual([change["met"] for change in document["changes"]], [False, True, False, False])
        self.assertEqual((units["to"], level["to"], size["to"]), ("256", "0", "1x1"))
        self.assertEqual(clock["to"], str(document["cycles"]))
        self.assertFalse(self.meets(1e6, **{"intersection.units": 256}))
        self.assertFalse(self.meets(1e6, level=0))
        self.assertFalse(self.meets(1e6, size="1x1"))
        self.assertEqual(self.ok("budget", *SMALL, "--fps", 1e6).count("not enough"), 3)

    def test_no_clock_beyond_what_a_machine_may_have(self):
        """A frame of more than a million cycles, a million times a second."""
        document = self.budget(KEEL, "--size", "8x6", "--max-level", 0, "--fps", 1e6,
                               "--set", "intersection.cost.ray=100000")
        self.assertGreater(document["cycles"], 1e6)
        clock = document["changes"][1]
        self.assertEqual((clock["setting"], clock["to"], clock["met"]), ("clock_mhz", "1000000", False))

    def test_nothing_below_level_0_nor_one_pixel(self):
        document = self.budget(KEEL, "--size", "1x1", "--max-level", 0, "--fps", 1e6, "--set", "clock_mhz=1",
                               "--set", "intersection.units=256")
        units, _, level, size = document["changes"]
        for change, value in ((units, "256"), (level, "0"), (size, "1x1")):
            self.assertEqual((change["from"], change["to"], change["met"]), (value, value, False))

    def test_machine_file_and_other_options(self):
        arguments = [*SMALL, "--machine", MACHINES / "small.json", "--scalar", "float", "--leaf", "drop"]
        document = self.budget(*arguments, "--fps", 5000)
        self.assertEqual(document["cycles"], self.stats("simulate", *arguments)["machine"]["cycles"])
        self.assertEqual(document["machine"], "small")

    def test_stats_on_stdout_are_json_alone(self):
        run = self.run_tool("budget", *SMALL, "--fps", 20000, "--stats", "-")
        self.assertEqual(run.returncode, tool.OK)
        json.loads(run.stdout)
        self.assertIn("the smallest changes", run.stderr)

    def test_usage(self):
        for value in ("0", "-1", "x", "", "nan", "-nan", "inf", "0.0009", "1000001", "30fps"):
            self.refused(USAGE, "budget", *SMALL, "--fps", value, "--stats", "out.json", says="--fps")
        self.refused(USAGE, "budget", says="is required")
        self.refused(tool.INPUT, "budget", *SMALL, "--max-level", 16, "--set", "subdivision_controller.pool=3",
                     says="/subdivision_controller/pool")

    def test_schema_refuses(self):
        validator = budget_schema()
        missed = self.budget(*SMALL, "--fps", 20000)

        def refuses(change):
            document = copy.deepcopy(missed)
            change(document)
            return not validator.is_valid(document)

        def drop(key, of=lambda document: document):
            return lambda document: of(document).pop(key)

        first = lambda document: document["changes"][0]
        for change in (
                drop("command"), drop("cycles"), drop("goal_fps", lambda document: document["budget"]),
                drop("met", first), drop("cycles", first), drop("changes"),
                lambda document: document.update(extra=1), lambda document: document.update(cycles=0),
                lambda document: document.update(cycles=1.5), lambda document: document.update(changes=[]),
                lambda document: document["budget"].update(met=True), lambda document: first(document).update(met=False),
                lambda document: first(document).update(setting="units"),
                lambda document: first(document).update(to="many")):
            self.assertTrue(refuses(change))


class Statistics(tool.EndToEnd):
    def documents(self):
        for arguments in (SMALL, [*SMALL, "--machine", MACHINES / "small.json"], [*SMALL, "--engine", "lockstep"],
                          [KEEL, "--size", "1x1"], [*SMALL, "--set", "intersection.dispatch=\"first_free\""],
                          [KEEL, "--size", "160x120", "--set", "tree_accumulator.pixels=1"]):
            yield self.stats("simulate", *arguments)

    def test_waits_add_up(self):
        for document in self.documents():
            causes = {}
            for unit in document["units"]:
                for kind, state in (("token", "starved"), ("room", "blocked")):
                    waits = [wait for wait in unit["waits"] if wait["for"] == kind]
                    self.assertEqual(sum(wait["cycles"] for wait in waits), unit[state], unit["name"])
                    causes.update({(wait["fifo"], kind): wait["cycles"] for wait in waits})
                cycles = [wait["cycles"] for wait in unit["waits"]]
                self.assertEqual(cycles, sorted(cycles, reverse=True))
            for fifo in document["fifos"]:
                self.assertEqual(fifo["reader_starved"], causes.get((fifo["name"], "token"), 0))
                self.assertEqual(fifo["writer_blocked"], causes.get((fifo["name"], "room"), 0))

    def test_latencies_count_every_pixel(self):
        for document in self.documents():
            every, levels = document["pixel_latency"]["all"], document["pixel_latency"]["by_level"]
            self.assertEqual(every["pixels"], document["columns"] * document["rows"])
            self.assertEqual(sum(level["pixels"] for level in levels), every["pixels"])
            self.assertEqual(max(level["max"] for level in levels), every["max"])
            for latency in (every, *levels):
                counts = [item["pixels"] for item in latency["histogram"]]
                ends = [item["up_to"] for item in latency["histogram"]]
                self.assertEqual(sum(counts), latency["pixels"])
                self.assertEqual(ends, sorted(set(ends)))
                self.assertLessEqual(latency["p50"], latency["p90"])
                self.assertLessEqual(latency["p90"], latency["p99"])
                self.assertLessEqual(latency["p99"], latency["max"])
                self.assertLessEqual(latency["max"], document["machine"]["cycles"])

    def test_occupancy_is_within_the_depth(self):
        for document in self.documents():
            cycles = document["machine"]["cycles"]
            for fifo in document["fifos"]:
                tokens, stride = fifo["occupancy"]["tokens"], fifo["occupancy"]["stride"]
                self.assertLessEqual(max(tokens), fifo["max"], fifo["name"])
                self.assertLessEqual(fifo["max"], fifo["depth"], fifo["name"])
                self.assertEqual(len(tokens), -(-cycles // stride))
                self.assertLessEqual(len(tokens), 256)
                if stride == 1:
                    self.assertAlmostEqual(sum(tokens) / cycles, fifo["mean"], 9, fifo["name"])

    def test_lower_bound(self):
        for document in self.documents():
            bound = document["bottleneck"]["lower_bound"]
            self.assertLessEqual(bound["cycles"], document["machine"]["cycles"])
            units = [unit["busy"] for unit in document["units"] if unit["name"].startswith("intersection_unit")]
            others = [unit["busy"] for unit in document["units"] if not unit["name"].startswith("intersection_unit")]
            self.assertEqual(bound["cycles"], max(-(-sum(units) // len(units)), *others))


tool.main()
