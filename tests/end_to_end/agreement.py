# SPDX-License-Identifier: Apache-2.0
"""The same picture and the same counts, whichever way a frame is made; and counts that are known beforehand."""


import tool
from tool import MACHINES, SCENES

COUNTED = ("rays", "cases", "subdivisions", "terminal_nodes", "work", "image", "arithmetic")


class Agreement(tool.EndToEnd):
    def counts(self, *arguments):
        document = self.stats(*arguments)
        return {key: document.get(key) for key in COUNTED}

    def test_render_and_simulate(self):
        for scene, *options in (
                ["keel.json", "--size", "64x48"], ["spheres.json", "--size", "40x30", "--edge", "drop"],
                ["fins.json", "--size", "48x36", "--max-level", "5"],
                ["keel.json", "--size", "40x30", "--max-level", "0"],
                ["keel.json", "--size", "33x17", "--scalar", "float", "--max-level", "2"],
                ["keel.json", "--size", "33x17", "--scalar", "fp24"],
                ["spheres.json", "--size", "24x18", "--scalar", "fix32.20", "--max-level", "2"],
                ["fins.json", "--size", "24x18", "--scalar", "view_vectors=fix64.32,intersection=e8p20"],
                ["blocks.json", "--size", "24x18", "--scalar", "view_vectors=e9p21,intersection=fix57.23"],
                ["spheres.json", "--size", "1x9"]):
            with self.subTest(scene=scene, options=options):
                frame = [SCENES / scene, *options]
                rendered = self.counts("render", *frame)
                self.assertGreater(rendered["rays"]["total"], 0)
                for machine in ([], ["--machine", MACHINES / "small.json"], ["--machine", MACHINES / "wide.json"]):
                    cycles = set()
                    for engine in ("decoupled", "lockstep"):
                        command = ["simulate", *frame, *machine, "--engine", engine]
                        document = self.stats(*command)
                        self.assertEqual({key: document.get(key) for key in COUNTED}, rendered, command)
                        cycles.add(document["machine"]["cycles"])
                    self.assertEqual(len(cycles), 1)

    def test_number_formats(self):
        """What a narrow format gets wrong it gets wrong alike, with and without the machine, on one thread and two."""
        formats = self.formats()
        self.assertGreaterEqual(len(formats), 35)
        differing = 0
        for scalar in formats:
            with self.subTest(scalar=scalar):
                frame = [SCENES / "spheres.json", "--size", "16x12", "--max-level", "2", "--scalar", scalar]
                run = self.run_tool("render", *frame)
                if run.returncode == 2:
                    self.assertRegex(scalar, r"^fix")
                    continue
                rendered = self.counts("render", *frame, "--threads", "2")
                self.assertEqual(rendered["arithmetic"] is None, scalar in ("double", "float"))
                for threads in ("1", "2"):
                    self.assertEqual(self.counts("simulate", *frame, "--threads", threads), rendered)
                differing += rendered["image"] != self.counts("render", *frame[:-2])["image"]
        self.assertGreater(differing, 20)

    def test_engines_write_the_same_statistics(self):
        documents = []
        for engine in ("decoupled", "lockstep"):
            document = self.stats("simulate", SCENES / "keel.json", "--size", "64x48", "--max-level", "4",
                                  "--engine", engine)
            self.assertEqual(document.pop("engine"), engine)
            document.pop("command")
            documents.append(document)
        self.assertEqual(*documents)

    def test_engines_where_a_freed_cell_comes_before_a_result(self):
        """One cell for parents and a slow classifier: that a parent was read lets the next request go long before the
        classifier's results could."""
        for scene, size, level, settings in (
                ("keel.json", "9x10", 2, {
                    "intersection.units": 16, "intersection.latency": 20, "intersection.cost.sphere": 0,
                    "intersection.cost.box_test": 0, "intersection.cost.triangle": 1, "pixel_scan.interval": 13,
                    "view_vector_generator.latency": 1, "view_vector_generator.interval": 2,
                    "pyramid_classifier.latency": 40, "pyramid_classifier.interval": 2, "tree_accumulator.latency": 1,
                    "tree_accumulator.interval": 5, "frame_buffer.interval": 13,
                    "tree_accumulator.pixels": 2, "fifos.all": 1, "fifos.pixel_scan_to_view_vector_generator": 2,
                    "fifos.intersection_unit_to_pyramid_classifier": 3,
                    "fifos.pyramid_classifier_to_color_unit": 9, "fifos.tree_accumulator_to_frame_buffer": 3}),
                ("fins.json", "14x4", 4, {
                    "intersection.units": 5, "intersection.latency": 1, "intersection.cost.box_test": 0,
                    "intersection.cost.sphere": 1, "intersection.cost.triangle": 5, "pixel_scan.latency": 2,
                    "view_vector_generator.latency": 1, "pyramid_classifier.latency": 40,
                    "subdivision_controller.latency": 1, "subdivision_controller.interval": 2,
                    "subdivision_controller.pool": 11, "tree_accumulator.latency": 1, "tree_accumulator.interval": 5,
                    "tree_accumulator.pixels": 3, "fifos.all": 1, "fifos.pixel_scan_to_view_vector_generator": 2,
                    "fifos.view_vector_generator_to_intersection_unit": 3,
                    "fifos.pyramid_classifier_to_subdivision_controller": 3,
                    "fifos.pyramid_classifier_to_color_unit": 2})):
            command = ["simulate", SCENES / scene, "--size", size, "--max-level", level]
            for path, value in settings.items():
                command += ["--set", f"{path}={value}"]
            documents = [self.stats(*command, "--engine", engine) for engine in ("decoupled", "lockstep")]
            for document in documents:
                del document["command"], document["engine"]
            self.assertEqual(*documents)

    def test_threads_and_reuse(self):
        frame = ["render", SCENES / "keel.json", "--size", "80x60", "--max-level", "4"]
        plain = self.stats(*frame)
        for threads in (1, 2, 3, 7):
            document = self.stats(*frame, "--threads", threads)
            self.assertEqual({**document, "command": plain["command"]}, plain)
        jitter = [self.stats(*frame, "--method", "jitter:2", "--threads", threads)["image"] for threads in (1, 5)]
        self.assertEqual(*jitter)
        seeds = [self.stats(*frame, "--method", "jitter:2", "--seed", seed)["image"]["sha256"] for seed in (1, 1, 2)]
        self.assertEqual(seeds[0], seeds[1])
        self.assertNotEqual(seeds[0], seeds[2])

    def test_reuse_is_counted_whichever_is_traced(self):
        for scene in ("keel.json", "spheres.json", "fins.json"):
            frame = ["render", SCENES / scene, "--size", "60x45", "--max-level", "4"]
            documents = {reuse: self.stats(*frame, "--reuse", reuse) for reuse in ("none", "pixel", "frame")}
            counts = documents["none"]["rays_by_reuse"]
            self.assertGreater(counts["none"], counts["pixel"])
            self.assertGreater(counts["pixel"], counts["frame"])
            for reuse, document in documents.items():
                self.assertEqual(document["rays_by_reuse"], counts)
                self.assertEqual(document["rays"]["total"], counts[reuse])
                for key in ("image", "cases", "subdivisions", "terminal_nodes"):
                    self.assertEqual(document[key], documents["none"][key])

    def test_hash_is_of_the_samples(self):
        picture = self.folder / "frame.pfm"
        for arguments in (["render", "--method", "grid:3"], ["render", "--scalar", "float"], ["simulate"]):
            document = self.stats(arguments[0], SCENES / "keel.json", *arguments[1:], "--size", "31x23", "-o", picture)
            self.assertEqual(tool.read_pfm(picture)[:2], (31, 23))
            self.assertEqual(tool.sha256_of_pfm(picture), document["image"]["sha256"])

    def test_window(self):
        """A window's pixels are those of the whole picture, whoever renders it."""
        column, row, columns, rows = window = (13, 7, 40, 21)
        whole, part = self.folder / "whole.pfm", self.folder / "part.pfm"
        for arguments in (["render"], ["render", "--method", "grid:2"], ["render", "--method", "jitter:2"],
                          ["simulate"], ["simulate", "--engine", "lockstep"]):
            frame = [arguments[0], SCENES / "keel.json", *arguments[1:], "--size", "96x72"]
            document = self.stats(*frame, "-o", whole)
            self.assertNotIn("window", document)
            document = self.stats(*frame, "--window", ",".join(map(str, window)), "-o", part)
            self.assertEqual((document["columns"], document["rows"]), (96, 72))
            self.assertEqual(document["window"], {"x": column, "y": row, "columns": columns, "rows": rows})
            expected = [line[12 * column : 12 * (column + columns)]
                        for line in tool.read_pfm(whole)[2][row : row + rows]]
            self.assertEqual(tool.read_pfm(part), (columns, rows, expected), arguments)
            self.assertGreater(len(set(expected)), 1)
        table = self.ok("simulate", SCENES / "keel.json", "--size", "96x72", "--window", "13,7,40,21")
        self.assertIn("keel.json at 96x72 pixels, 40x21 of them from column 13, row 7, MAX_LEVEL 3", table)
        rendered = self.counts("render", SCENES / "keel.json", "--size", "96x72", "--window", "13,7,40,21")
        simulated = self.counts("simulate", SCENES / "keel.json", "--size", "96x72", "--window", "13,7,40,21")
        self.assertEqual(simulated, rendered)
        self.assertEqual(rendered["rays"]["primary"], 41 * 22)

    def test_every_light_with_shadows_is_listed(self):
        """What a frame sees of a scene does not decide how many there are."""
        sun = {"type": "directional", "direction": [1, 0, 0], "color": [1, 1, 1]}
        lights = [{"type": "ambient", "color": [1, 1, 1]}, sun, {**sun, "shadow": False},
                  {"type": "point", "position": [0, 5, 0], "color": [1, 1, 1]}]
        for seen, by_light in (([10, 0, 0], [True, True]), ([-10, 0, 0], [False, False])):
            scene = self.write("lit.json", {**tool.scene([{**tool.SPHERE, "center": seen}]), "lights": lights})
            for command in (["render"], ["render", "--method", "grid:2"], ["simulate"],
                            ["simulate", "--engine", "lockstep"]):
                shadow = self.stats(command[0], scene, *command[1:])["rays"]["shadow"]
                self.assertEqual([rays > 0 for rays in shadow["by_light"]], by_light, command)
                self.assertEqual(sum(shadow["by_light"]), shadow["total"])
                self.assertIn(f"{shadow['total']}   to 2 lights", self.ok(*command[:1], scene, *command[1:]))
        dark = self.write("dark.json", {**tool.scene([{**tool.SPHERE, "shadow": False}]), "lights": lights})
        for command in ("render", "simulate"):
            self.assertEqual(self.stats(command, dark)["rays"]["shadow"], {"total": 0, "by_light": []})

    def test_empty_scene(self):
        empty = self.write("empty.json", tool.scene([], columns=640, rows=480))
        for command in (["render"], ["render", "--reuse", "frame"], ["simulate"], ["simulate", "--engine", "lockstep"]):
            document = self.stats(command[0], empty, *command[1:])
            self.assertEqual(document["rays"], {"primary": 308321, "subdivision": 0, "total": 308321,
                                                "by_level": [308321, 0, 0, 0], "shadow": {"total": 0, "by_light": []}})
            self.assertEqual(document["subdivisions"], 0)
            self.assertEqual(document["terminal_nodes"], 307200)
            self.assertEqual(document["cases"]["by_level"][0], {"empty": 307200, "covered": 0, "edge": 0})

    def test_one_pixel(self):
        """A plane ahead covers every pixel; a sphere inside one pixel of the screen shows nowhere (case 4)."""
        plane = {"type": "plane", "normal": [-1, 0, 0], "offset": -5, "color": [1, 0, 0]}
        covered = self.write("plane.json", tool.scene([plane], columns=1, rows=1))
        picture = self.folder / "one.pfm"
        document = self.stats("render", covered, "-o", picture)
        self.assertEqual(document["rays"]["total"], 4)
        self.assertEqual(document["cases"]["by_level"][0], {"empty": 0, "covered": 1, "edge": 0})
        self.assertEqual(tool.pixel_of_pfm(picture, 0, 0), (1, 0, 0))
        hidden = {**tool.SPHERE, "radius": 0.1}
        document = self.stats("simulate", self.write("hidden.json", tool.scene([hidden], columns=1, rows=1)),
                              "-o", picture)
        self.assertEqual(document["cases"]["by_level"][0], {"empty": 1, "covered": 0, "edge": 0})
        self.assertEqual(tool.pixel_of_pfm(picture, 0, 0), (0.125, 0.25, 0.5))


tool.main()
