# SPDX-License-Identifier: Apache-2.0
"""Whether a frame rate is met, and the smallest changes that make it so: of one setting, and of two."""

import copy
import json

import jsonschema

import tool
from settings import TEXTURED
from tool import MACHINES, SCENES, SOURCE, USAGE

KEEL = SCENES / "keel.json"
SMALL = [KEEL, "--size", "32x24", "--max-level", "3"]
SETTINGS = ["intersection.units", "clock_mhz", "max_level", "size"]


def words_of(changes):
    """What makes simulate take them."""
    options = {"max_level": "--max-level", "size": "--size"}
    for change in changes:
        setting, value = change["setting"], change["to"]
        yield from (options[setting], value) if setting in options else ("--set", f"{setting}={value}")


def budget_schema():
    document = json.loads((SOURCE / "docs" / "schemas" / "budget.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(document)
    return jsonschema.Draft202012Validator(document)


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
        rows = [line.split() for line in text.split("each alone:\n")[1].splitlines()]
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
            machine = self.stats("simulate", *SMALL, *words_of([change]))["machine"]
            self.assertEqual(change["cycles"], machine["cycles"])
            self.assertEqual(change["frames_per_second"], machine["frames_per_second"])

    def test_rays_are_traced_once(self):
        """Whatever the number of machines that are tried: for the frame as asked for, and for what is proposed."""
        only_units = [KEEL, "--size", "1x1", "--max-level", 0]  # nothing smaller to try
        document = self.budget(*only_units, "--fps", 1e6, "--set", "intersection.cost.ray=300")
        units, clock, level, size = document["changes"]
        self.assertEqual([change["met"] for change in (units, clock, level, size)], [False, True, False, False])
        self.assertEqual(document["simulated"], 1)  # a clock changes no cycles
        self.assertGreaterEqual(document["replayed"], 7)  # 8, 16 ... 256 units, and those of the pair

        document = self.budget(*SMALL, "--fps", 20000)  # each alone is enough
        sizes = 6  # of 1, 16, 8, 12, 14 and 15 columns
        self.assertEqual(document["simulated"], 1 + sizes + 2)  # and the units and the level that are proposed
        self.assertGreaterEqual(document["replayed"], 4)
        self.assertEqual(self.budget(*SMALL)["simulated"], 1)

    def test_levels_of_textured_scenes_are_not_those_of_a_higher_one(self):
        """Their nodes take other places of the texture."""
        self.write("textured.json", TEXTURED)
        frame = ["textured.json", "--size", "24x18"]
        document = self.budget(*frame, "--max-level", 3, "--fps", 5000, "--set", "color_unit.cost.line=40")
        level = document["changes"][2]
        self.assertTrue(level["met"], level)
        simulate = [self.stats("simulate", *frame, "--max-level", int(level["to"]) + more, "--set", "goal_fps=5000",
                               "--set", "color_unit.cost.line=40")["machine"] for more in (0, 1)]
        self.assertEqual(level["cycles"], simulate[0]["cycles"])
        self.assertEqual([machine["budget"]["met"] for machine in simulate], [True, False])

    def further(self, frame, *options):
        """The changes beside the usual ones, by name."""
        changes = self.budget(KEEL, *frame, *options)["changes"]
        for change in changes:
            machine = self.stats("simulate", KEEL, *frame, *words_of([change]))["machine"]
            self.assertEqual(change["cycles"], machine["cycles"], change)
        return {change["setting"]: change for change in changes if change["setting"] not in SETTINGS}

    def test_what_the_critical_path_leads_to(self):
        """A FIFO that is too shallow for a long latency, found and made no deeper than has to be."""
        frame = ["--size", "160x120", "--set", "intersection.units=16", "--set", "intersection.latency=200"]
        fifo = "fifos.intersection_unit_to_pyramid_classifier"
        found = self.further(frame, "--fps", 3000)
        self.assertEqual(list(found), [fifo])
        self.assertTrue(found[fifo]["met"])
        least = int(found[fifo]["to"])
        cycles = [self.stats("simulate", KEEL, *frame, "--set", f"{fifo}={depth}")["machine"]["cycles"]
                  for depth in (least - 1, least)]
        budget = 200_000_000 // 3000
        self.assertEqual([of_depth <= budget for of_depth in cycles], [False, True])
        found = self.further(frame, "--fps", 4000)[fifo]  # twice as deep helps, and no depth is enough
        self.assertEqual((found["from"], found["to"], found["met"]), ("8", "16", False))

    def test_pools_that_no_path_leads_to(self):
        for setting, value, fps in (("tree_accumulator.pixels", 1, 3000), ("subdivision_controller.pool", 7, 10000)):
            found = self.further(["--size", "64x48", "--set", f"{setting}={value}", "--set", "intersection.units=32"],
                                 "--fps", fps)
            self.assertTrue(found[setting]["met"], found)

    def test_intervals_beside_units_that_are_enough(self):
        found = self.further(["--size", "64x48", "--set", "color_unit.interval=6"], "--fps", 3400)
        self.assertEqual(list(found), ["color_unit.interval"])

    def test_proposed_pairs_are_those_of_simulate(self):
        frame = ["--size", "64x48", "--set", "view_vector_generator.interval=3"]
        pairs = [pair for pair in self.budget(KEEL, *frame, "--fps", 30000)["pairs"] if pair["met"]]
        self.assertGreaterEqual(len(pairs), 4)
        for pair in pairs:
            machine = self.stats("simulate", KEEL, *frame, *words_of(pair["changes"]))["machine"]
            self.assertEqual((pair["cycles"], pair["frames_per_second"]), (machine["cycles"], machine["frames_per_second"]))

    def test_not_enough(self):
        document = self.budget(*SMALL, "--fps", 1e6)
        units, clock, level, size = document["changes"]
        self.assertEqual([change["met"] for change in document["changes"]], [False, True, False, False])
        self.assertEqual((units["to"], level["to"], size["to"]), ("256", "0", "1x1"))
        self.assertEqual(clock["to"], str(document["cycles"]))
        self.assertFalse(self.meets(1e6, **{"intersection.units": 256}))
        self.assertFalse(self.meets(1e6, level=0))
        self.assertFalse(self.meets(1e6, size="1x1"))
        text = self.ok("budget", *SMALL, "--fps", 1e6)
        self.assertEqual(text.partition("\nand of two together")[0].count("not enough: capped by "), 3)

    def cap(self, *arguments):
        """The end of the bottleneck chain, and the cycles, of a frame that is simulated on its own."""
        document = self.stats("simulate", *arguments)
        chain = document["bottleneck"]["chain"]
        return {"unit": chain[-1]["unit"], "busy": chain[-1]["busy"],
                "closes_loop": chain[-1]["unit"] in [link["unit"] for link in chain[:-1]]}, document["machine"]["cycles"]

    def test_what_is_not_enough_names_what_caps_it(self):
        frame = [KEEL, "--size", "64x48", "--max-level", "3"]
        for extra, unit in (([], "pyramid_classifier"), (["--set", "view_vector_generator.interval=3"],
                            "view_vector_generator"), (["--set", "tree_accumulator.pixels=1"], None)):
            units = self.budget(*frame, *extra, "--fps", 30000)["changes"][0]
            self.assertEqual((units["setting"], units["to"], units["met"]), ("intersection.units", "256", False))
            cap, cycles = self.cap(*frame, *extra, "--set", "intersection.units=256")
            self.assertEqual(units["capped_by"]["unit"], cap["unit"])
            self.assertEqual(units["capped_by"]["closes_loop"], cap["closes_loop"])
            self.assertAlmostEqual(units["capped_by"]["busy"], cap["busy"])
            self.assertEqual(units["cycles"], cycles)
            if unit is None:
                self.assertTrue(cap["closes_loop"])
            else:
                self.assertEqual(cap["unit"], unit)

    def test_pairs(self):
        """Where units alone are not enough: each pair meets the goal, and neither of its changes can be smaller."""
        fps, frame = 30000, [KEEL, "--size", "64x48", "--max-level", "3"]
        document = self.budget(*frame, "--fps", fps, "--set", "view_vector_generator.interval=3")
        alone = {change["setting"]: change for change in document["changes"]}
        self.assertEqual(list(alone), [SETTINGS[0], "view_vector_generator.interval", *SETTINGS[1:]])
        self.assertFalse(alone["intersection.units"]["met"])
        def meets(settings):
            words = words_of({"setting": setting, "to": value} for setting, value in settings.items())
            machine = ["--set", "view_vector_generator.interval=3", "--set", f"goal_fps={fps}"]
            return self.stats("simulate", *frame, *machine, *words)["machine"]["budget"]["met"]

        def smaller(setting, value):
            if setting == "size":
                columns = int(value.split("x")[0]) + 1
                return f"{columns}x{round(columns * 0.75 + 1e-9)}"
            return int(value) + (-1 if setting in ("intersection.units", "clock_mhz") else 1)

        pairs = document["pairs"]
        self.assertGreaterEqual(len(pairs), 4)
        self.assertTrue(any(pair["met"] for pair in pairs))
        for pair in pairs:
            first, second = pair["changes"]
            self.assertFalse(alone[first["setting"]]["met"])
            to = {change["setting"]: change["to"] for change in (first, second)}
            with self.subTest(pair=to):
                self.assertEqual(meets(to), pair["met"])
                if pair["met"]:
                    self.assertNotIn("capped_by", pair)
                    for change in (first, second):
                        if change["to"] != change["from"]:
                            less = smaller(change["setting"], change["to"])
                            self.assertFalse(meets({**to, change["setting"]: less}), less)
                else:
                    self.assertIn("unit", pair["capped_by"])

    def test_no_pairs_where_each_alone_is_enough(self):
        self.assertEqual(self.budget(*SMALL, "--fps", 11000)["pairs"], [])
        self.assertNotIn("of two together", self.ok("budget", *SMALL, "--fps", 11000))

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
        arguments = [*SMALL, "--machine", MACHINES / "small.json", "--scalar", "float", "--edge", "drop"]
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
                drop("command"), drop("cycles"), drop("simulated"), drop("replayed"), drop("goal_fps", lambda document: document["budget"]),
                drop("met", first), drop("cycles", first), drop("changes"),
                lambda document: document.update(extra=1), lambda document: document.update(cycles=0),
                lambda document: document.update(cycles=1.5), lambda document: document.update(changes=[]),
                lambda document: document["budget"].update(met=True), lambda document: first(document).update(met=False),
                lambda document: first(document).update(setting="units"),
                lambda document: first(document).update(to="many")):
            self.assertTrue(refuses(change))


tool.main()
