# SPDX-License-Identifier: Apache-2.0
"""--max-cycles, what the statistics say of waits, latencies and occupancy, and what instances take of memory."""

import tool
from tool import LIMIT, MACHINES, SCENES, USAGE

KEEL = SCENES / "keel.json"
SMALL = [KEEL, "--size", "32x24", "--max-level", "3"]


class MaxCycles(tool.EndToEnd):
    def test_simulate_to_the_cycle(self):
        """The frame's own cycles are enough, one less is not; nothing but a trace is left behind."""
        for engine in ("decoupled", "lockstep"):
            simulate = ["simulate", *SMALL, "--engine", engine, "-o", "out.png", "--stats"]
            cycles = self.stats("simulate", *SMALL)["machine"]["cycles"]
            for limit, said in ((1, "1 cycle"), *((number, f"{number} cycles") for number in (cycles // 2, cycles - 1))):
                self.refused(LIMIT, *simulate, "out.json", "--max-cycles", limit, more_lines=True,
                             says=f"the frame is not finished within {said}")
            self.ok(*simulate, "out.json", "--max-cycles", cycles, "--trace", "out.vcd")
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
        run = self.run_tool(*sweep, "--max-cycles", cycles - 1)
        self.assertEqual(run.returncode, LIMIT)
        self.assertRegex(run.stderr, r"\Apyrasim: 32x24 pixels, MAX_LEVEL 3, edge mean \(1 of 2 rows done\): "
                                     rf"the frame is not finished within {cycles - 1} cycles\n  pixel_scan: ready at ")
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
            slowest = document["pixel_latency"]["slowest"]
            self.assertEqual(len(slowest), min(5, every["pixels"]))
            self.assertEqual(slowest[0]["cycles"], every["max"])
            self.assertEqual(slowest, sorted(slowest, key=lambda pixel: -pixel["cycles"]))
            self.assertEqual(len({(pixel["row"], pixel["column"]) for pixel in slowest}), len(slowest))
            for pixel in slowest:
                self.assertLessEqual(pixel["cycles"], levels[pixel["level"]]["max"])
                self.assertTrue(pixel["row"] < document["rows"] and pixel["column"] < document["columns"], pixel)
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


    def test_every_cycle_is_owed_to_something(self):
        command = ["simulate", KEEL, "--size", "32x24", "--machine", MACHINES / "small.json"]
        plain = self.ok(*command, "--stats", "plain.json")
        table = self.ok(*command, "--critical-path", "--stats", "path.json")
        plain_document, document = (tool.read_json(self.folder / name) for name in ("plain.json", "path.json"))
        path = document["bottleneck"].pop("critical_path")
        self.assertEqual(document | {"command": ""}, plain_document | {"command": ""})
        self.assertEqual(sum(part["cycles"] for part in path), document["machine"]["cycles"])
        places = {"room": {fifo["name"] for fifo in document["fifos"]}}
        units = {unit["name"] for unit in document["units"]}
        for part in path:
            self.assertIn(part["place"], places.get(part["owed"], units))
        lines = table.splitlines()
        added = [line for line in lines if line not in plain.splitlines()]
        self.assertTrue(added[0].startswith("critical path"), added)
        self.assertEqual(sum(int(line[14:26].replace(",", "")) for line in added), document["machine"]["cycles"])


class Memory(tool.EndToEnd):
    def scene(self, count):
        side = 120
        vertices = "".join(f"v {x} {(x * y) % 7} {y}\n" for y in range(side) for x in range(side))
        faces = "".join(f"f {k} {k + 1} {k + side + 1} {k + side}\n" for y in range(side - 1)
                        for k in range(y * side + 1, (y + 1) * side))
        self.write("ground.obj", vertices + faces)
        scene = tool.scene([{"type": "instance", "of": "ground", "color": [1, 1, 1], "transform": [
            {"scale": 0.01}, {"translate": [5 + k % 30, k % 7 - 3, k % 11 - 5]}]} for k in range(count)])
        return self.write(f"{count}.json", scene | {"shapes": {"ground": {"type": "mesh", "file": "ground.obj"}}})

    def test_a_thousand_instances_take_hardly_more_than_one(self):
        """Of a mesh of 28,322 triangles."""
        one, many = (self.memory("render", self.scene(count), "--size", "32x24", "--threads", "1", "-o", "x.png")
                     for count in (1, 1000))
        print(f"figure: {one / 1e6:.1f} MB for one instance, {many / 1e6:.1f} MB for 1,000")
        self.assertLess(many, 1.2 * one + 2e6)


tool.main()
