# SPDX-License-Identifier: Apache-2.0
"""The shipped files and what --stats writes keep to the schemas, and the schemas refuse what is wrong."""

import copy
import json

import jsonschema

import tool
from tool import MACHINES, SCENES, SOURCE


def schema(kind):
    document = json.loads((SOURCE / "docs" / "schemas" / f"{kind}.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(document)
    return jsonschema.Draft202012Validator(document)


def changed(document, path, value):
    """A copy with the value at `path`, a list of keys, replaced; None removes it."""
    result = copy.deepcopy(document)
    node = result
    for key in path[:-1]:
        node = node[key]
    if value is None:
        del node[path[-1]]
    else:
        node[path[-1]] = value
    return result


class Schemas(tool.EndToEnd):
    def assert_valid(self, validator, document, what):
        errors = [f"{error.json_path}: {error.message}" for error in validator.iter_errors(document)]
        self.assertEqual(errors, [], what)

    def assert_refused(self, validator, document, changes):
        self.assert_valid(validator, document, "before the change")
        for path, value in changes:
            with self.subTest(path=path, value=value):
                self.assertFalse(validator.is_valid(changed(document, path, value)))

    def test_scenes(self):
        validator = schema("scene")
        files = sorted(SCENES.glob("*.json"))
        self.assertGreaterEqual(len(files), 4)
        for file in files:
            self.assert_valid(validator, tool.read_json(file), file)
        self.assert_valid(validator, tool.scene([]), "an empty scene")
        self.assert_refused(validator, tool.scene(), [
            (["objects"], None), (["camera"], None), (["objects", 0, "radius"], 0), (["objects", 0, "radius"], None),
            (["objects", 0, "type"], "cube"), (["objects", 0, "vertices"], [[0, 0, 0]] * 3),
            (["camera", "screen", "dx"], 1), (["camera", "screen", "rows"], 0), (["camera", "screen", "rows"], 1.5),
            (["background"], [1, 1]), (["lamps"], []), (["light"], {"ambient": 0.5})])
        sun = {"type": "directional", "direction": [1, 0, 0], "color": [1, 1, 1]}
        lit = tool.scene() | {"lights": [sun, {"type": "ambient", "color": [1, 1, 1]},
                                         {"type": "point", "position": [0, 1, 0], "color": [1, 1, 1]}]}
        self.assert_refused(validator, lit, [
            (["light"], {"direction": [1, 0, 0]}), (["lights"], sun), (["lights", 0, "type"], "sun"),
            (["lights", 0, "color"], [1, 1]), (["lights", 0, "falloff"], "none"), (["lights", 1, "shadow"], True),
            (["lights", 2, "falloff"], "cubic"), (["lights", 2, "intensity"], -1), (["objects", 0, "shadow"], 1)])

    def test_textures(self):
        validator = schema("scene")
        scene = tool.scene()
        texture = {"type": "checker", "colors": [[1, 1, 1], [0, 0, 0]], "scale": [2, 0.5], "shift": [0, -1], "turn": 30}
        scene["objects"].append({"type": "disc", "center": [5, 0, 0], "normal": [1, 0, 0], "radius": 1, "texture": texture})
        self.ok("check", self.write("textures.json", scene))
        last = len(scene["objects"]) - 1
        changes = [(["objects", last, "texture", *path], value) for path, value in (
            (["type"], "dots"), (["colors"], [[1, 1, 1]]), (["colors"], None), (["scale"], [0, 1]), (["scale"], 2),
            (["shift"], [1]), (["turn"], "30"), (["file"], "x.png"))]
        changes += [(["objects", last, "texture"], None), (["objects", last, "texture", "type"], "image")]
        picture = tool.SOURCE / "docs/images/keel_crop.png"
        image = changed(scene, ["objects", last, "texture"], {"type": "image", "file": str(picture), "wrap": "clamp"})
        self.ok("check", self.write("image.json", image))
        self.assert_refused(validator, image, [(["objects", last, "texture", *path], value) for path, value in (
            (["wrap"], "mirror"), (["file"], "x.jpg"), (["file"], None), (["colors"], [[1, 1, 1], [0, 0, 0]]))])
        self.assert_refused(validator, scene, changes)
        for path, value in changes:
            self.refused(tool.INPUT, "check", self.write("wrong.json", changed(scene, path, value)), says="wrong.json: /")

    def test_transforms(self):
        """The schema and the program are of one mind."""
        validator = schema("scene")
        scene = tool.scene()
        scene["shapes"] = {"s": {"type": "sphere", "center": [0, 0, 0], "radius": 1, "transform": {"scale": [1, -2, 3]}},
                           "t": {"type": "instance", "of": "s"}}
        scene["objects"].append({"type": "instance", "of": "t", "color": [1, 1, 1], "shadow": False, "transform": [
            {"scale": 2}, {"rotate": {"axis": [0, 1, 0], "degrees": 30}}, {"translate": [9, 0, 0]},
            {"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}]})
        self.ok("check", self.write("transforms.json", scene))
        last = len(scene["objects"]) - 1
        changes = [(["objects", last, "transform", *path], value) for path, value in (
            ([0, "scale"], 0), ([0, "scale"], [1, 1]), ([0], {}), ([1, "rotate", "degrees"], None), ([0, "turn"], 1),
            ([1, "rotate", "axis"], [1, 1]), ([2, "translate"], 1), ([3, "matrix"], [[1, 0, 0, 0]] * 2), ([], []))]
        changes += [(["shapes", "s", "color"], [1, 1, 1]), (["objects", last, "of"], None), (["objects", last, "shadow"], 1),
                    (["shapes", "s", "type"], "x")]
        self.assert_refused(validator, scene, changes)
        for path, value in changes:
            self.refused(tool.INPUT, "check", self.write("wrong.json", changed(scene, path, value)), says="wrong.json: /")

    def test_machines(self):
        validator = schema("machine")
        files = sorted(MACHINES.glob("*.json"))
        self.assertEqual([file.name for file in files], ["default.json", "small.json", "wide.json"])
        for file in files:
            self.assert_valid(validator, tool.read_json(file), file)
            self.assertIn(f"machine {file.stem} ", self.ok("check", file))
        self.assert_valid(validator, {}, "an empty machine file")
        changes = [
            (["clock"], 1), (["clock_mhz"], 0), (["name"], 3), (["intersection", "units"], 0),
            (["intersection", "units"], 257), (["intersection", "units"], 1.5), (["intersection", "interval"], 1),
            (["intersection", "cost", "ray"], 0), (["intersection", "cost", "mesh"], 1), (["frame_buffer", "pool"], 1),
            (["frame_buffer", "latency"], 0), (["fifos", "all"], 0), (["fifos", "pixel_scan"], 1),
            (["tree_accumulator", "pixels"], 0), (["subdivision_controller", "pool"], -1), (["pixel_scan"], [])]
        default = tool.read_json(MACHINES / "default.json")
        self.assert_refused(validator, default, changes)
        for path, value in changes:  # and the program is of the same mind
            file = self.write("machine.json", changed(default, path, value))
            self.refused(tool.INPUT, "check", file, says="/".join(["", *path]))

    def test_machine_limits_are_those_of_the_program(self):
        """The least and the greatest of every setting is taken by the program, and one beyond is not."""
        document = json.loads((SOURCE / "docs" / "schemas" / "machine.schema.json").read_text())

        def settings(node, path):
            node = {**document["$defs"].get(node.get("$ref", "").rpartition("/")[2], {}), **node}
            for key, child in node.get("properties", {}).items():
                yield from settings(child, path + [key])
            if "minimum" in node:
                yield path, node

        found = list(settings(document, []))
        self.assertEqual(len(found), 51)
        for path, node in found:
            def file_with(value, path=path):
                nested = value
                for key in reversed(path):
                    nested = {key: nested}
                return self.write("machine.json", nested)
            for value in (node["minimum"], node["maximum"]):
                self.ok("check", file_with(value))
            for value in (node["minimum"] - 1, node["maximum"] + 1):
                self.refused(tool.INPUT, "check", file_with(value), says="/".join(["", *path]))

    def test_default_machine_is_built_in(self):
        """default.json states every setting, each as the schema documents it and as the program has it."""
        default = tool.read_json(MACHINES / "default.json")
        validator = json.loads((SOURCE / "docs" / "schemas" / "machine.schema.json").read_text())
        defined = validator["$defs"]
        self.assertEqual(set(default), set(validator["properties"]))
        self.assertEqual(set(default["fifos"]), set(defined["fifos"]["properties"]) - {"all"})
        self.assertEqual(set(default["intersection"]), set(defined["intersection"]["properties"]))
        costs = defined["intersection"]["properties"]["cost"]["properties"]
        self.assertEqual(set(default["intersection"]["cost"]), set(costs))
        for value, properties in [(default["fifos"], defined["fifos"]["properties"]),
                                  (default["intersection"]["cost"], costs)]:
            for key in value:
                self.assertEqual(value[key], properties[key]["default"], key)
        self.assertEqual(default["frame_buffer"], {"interval": validator["properties"]["frame_buffer"]["properties"]["interval"]["default"]})
        for name in ("pixel_scan", "view_vector_generator", "pyramid_classifier"):
            self.assertEqual(set(default[name]) - {"line_buffer"}, {"latency", "interval"})
            text = "Defaults: latency {latency}, interval {interval}.".format(**default[name])
            self.assertIn(text, validator["properties"][name]["description"])
        # Every setting shows in the document of a run that depends on it: same document, same settings.
        for arguments in (["keel.json", "--size", "48x36", "--max-level", "3"],
                          ["spheres.json", "--size", "32x24", "--max-level", "5"]):
            command = ["simulate", SCENES / arguments[0], *arguments[1:]]
            built_in = self.stats(*command)
            from_file = self.stats(*command, "--machine", MACHINES / "default.json")
            for document in (built_in, from_file):
                del document["command"]
            self.assertEqual(from_file, built_in)

    def test_statistics(self):
        validator = schema("statistics")
        keel, spheres = SCENES / "keel.json", SCENES / "spheres.json"
        empty = self.write("empty.json", tool.scene([]))
        small = ["--size", "24x18"]
        for arguments in (
                ["render", keel, *small], ["render", keel, *small, "--max-level", "0"],
                ["render", keel, *small, "--max-level", "auto", "--edge", "drop", "--scalar", "float"],
                ["render", keel, *small, "--scalar", "e8p12"],
                ["simulate", keel, *small, "--scalar", "view_vectors=fix64.32,intersection=fp24"],
                ["render", spheres, *small, "--reuse", "pixel"], ["render", spheres, *small, "--reuse", "frame"],
                ["render", keel, *small, "--method", "point"], ["render", keel, *small, "--method", "grid:3"],
                ["render", keel, *small, "--method", "jitter:2", "--seed", "7"],
                ["render", keel, "--size", "2x2", "--max-level", "16"], ["render", empty],
                ["simulate", keel, *small], ["simulate", keel, *small, "--engine", "lockstep", "--scalar", "float"],
                ["render", keel, *small, "--window", "3,2,8,6"], ["simulate", keel, *small, "--window", "0,17,24,1"],
                ["simulate", keel, *small, "--max-level", "0"], ["simulate", spheres, *small, "--edge", "drop"],
                ["simulate", spheres, *small, "--machine", MACHINES / "small.json"],
                ["simulate", spheres, *small, "--machine", MACHINES / "wide.json"],
                ["simulate", keel, *small, "--set", "goal_fps=1e5"], ["simulate", empty], ["simulate", keel, *small, "--critical-path"]):
            document = self.stats(*arguments)
            self.assert_valid(validator, document, arguments)
            self.check_sums(document)
            self.assertEqual("engine" in document, arguments[0] == "simulate")

    def check_sums(self, document):
        """What the schema's descriptions promise."""
        rays, level = document["rays"], document["max_level"]
        self.assertEqual(len(rays["by_level"]), level + 1)
        self.assertEqual(len(document["cases"]["by_level"]), level + 1)
        self.assertEqual(rays["by_level"][0], rays["primary"])
        self.assertEqual(sum(rays["by_level"]), rays["total"])
        self.assertEqual(rays["primary"] + rays["subdivision"], rays["total"])
        picture = document.get("window", document)
        pixels = picture["columns"] * picture["rows"]
        if document["method"] == "pyramid":
            self.assertEqual(document["terminal_nodes"], pixels + 3 * document["subdivisions"])
            self.assertEqual(sum(document["cases"]["by_level"][0].values()), pixels)
            self.assertEqual(document["rays_by_reuse"]["none"], rays["primary"] + 5 * document["subdivisions"])
        else:
            self.assertEqual((document["terminal_nodes"], rays["subdivision"]), (0, 0))
        if "machine" in document:
            machine = document["machine"]
            self.assertEqual([unit["name"] for unit in document["units"]], machine["elaborated"])
            for unit in document["units"]:
                cycles = unit["busy"] + unit["starved"] + unit["blocked"] + unit["idle"]
                self.assertEqual(cycles, machine["cycles"], unit["name"])
            for fifo in document["fifos"]:
                self.assertLessEqual(fifo["max"], fifo["depth"], fifo["name"])
                self.assertLessEqual(fifo["mean"], fifo["max"], fifo["name"])
            self.assertAlmostEqual(machine["frames_per_second"] * machine["cycles"], machine["clock_mhz"] * 1e6,
                                   delta=1)
            self.assertEqual(machine["budget"]["met"], machine["cycles"] <= machine["budget"]["cycles"])

    def test_statistics_refused(self):
        validator = schema("statistics")
        keel = SCENES / "keel.json"
        both = [
            (["pyrasim"], None), (["command"], None), (["extra"], 1), (["edge"], "median"), (["scalar"], "half"),
            (["method"], "grid:0"), (["rays", "total"], -1), (["rays", "total"], 1.5), (["rays", "by_level"], []),
            (["cases", "by_level", 0, "edge"], None), (["work", "surface_tests", "mesh"], 0),
            (["image", "sha256"], "0" * 63), (["image", "sha256"], "G" * 64), (["columns"], 0)]
        self.assert_refused(validator, self.stats("render", keel, "--size", "8x6"),
                            both + [(["engine"], "lockstep"), (["units"], []), (["rays_by_reuse", "pixel"], None)])
        self.assert_refused(validator, self.stats("render", keel, "--size", "8x6", "--window", "0,0,8,6"), [
            (["window", "x"], -1), (["window", "y"], 65535), (["window", "columns"], 0), (["window", "rows"], None),
            (["window", "width"], 8), (["window"], [0, 0, 8, 6])])
        self.assert_refused(validator, self.stats("simulate", keel, "--size", "8x6"), both + [
            (["engine"], None), (["engine"], "fast"), (["machine"], None), (["units"], None), (["fifos"], None),
            (["method"], "grid:2"), (["machine", "cycles"], 0), (["machine", "budget", "met"], 1),
            (["machine", "elaborated"], ["x", "x"]), (["units", 0, "idle"], None), (["fifos", 0, "depth"], 0),
            (["fifos", 0, "mean"], "1"), (["units", 0, "name"], "Unit"), (["rays_by_reuse", "pixel"], 3)])


tool.main()
