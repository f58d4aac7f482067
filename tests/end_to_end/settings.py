# SPDX-License-Identifier: Apache-2.0
"""Every setting of a machine file moves something in what simulate reports."""

import hashlib
import json

import tool
from tool import INPUT, SOURCE

SCENE = tool.scene(
    [{"type": "sphere", "center": [10, 1, 0], "radius": 2, "color": [1, 0.5, 0.25]},
     {"type": "sphere", "center": [9, -1, 1], "radius": 1, "color": [0, 0.5, 0.25]},
     {"type": "plane", "normal": [0, 1, 0], "offset": -2, "color": [0.5, 0.5, 0.5]},
     {"type": "triangle", "vertices": [[8, 0, -3], [8, 3, -1], [11, -1, 3]], "color": [0, 0, 1]},
     {"type": "disc", "center": [11, 2, 3], "normal": [-1, 1, 0], "radius": 1, "color": [0, 1, 1]},
     {"type": "box", "min": [9, 1, 2], "max": [10, 2, 3], "color": [1, 0, 1]},
     {"type": "ellipsoid", "center": [9, -2, -3], "radii": [1, 0.5, 2], "color": [1, 1, 0]},
     {"type": "cylinder", "base": [12, -2, 2], "cap": [12, 2, 2], "radius": 0.5, "color": [1, 1, 0.5]},
     {"type": "cone", "base": [12, -2, -2], "cap": [12, 2, -2], "base_radius": 1, "cap_radius": 0, "color": [0, 1, 0]},
     {"type": "quadric", "coefficients": {"yy": 1, "zz": 1, "x": -1, "constant": 9}, "clip": {"max": [10, 9, 9]},
      "color": [0.5, 1, 0.5]},
     {"type": "torus", "center": [9, 3, -2], "axis": [1, 1, 0], "major_radius": 1, "minor_radius": 0.4, "color": [1, 0, 0.5]},
     {"type": "instance", "of": "mesh", "transform": {"translate": [8, -2, 0]}, "color": [0.5, 0.75, 1]}],
    columns=24, rows=18) | {"shapes": {"mesh": {"type": "mesh", "file": str(tool.SCENES / "crystal.obj")}}}

# For what stands only where lights have shadows.
SHADOWED = SCENE | {"lights": [{"type": "directional", "direction": [1, -1, 1], "color": [1, 1, 1]},
                               {"type": "point", "position": [0, 6, 0], "color": [1, 1, 1]}]}

# For the texture part of the colour unit.
TEXTURED = SCENE | {"objects": [thing | {"texture": {"type": "checker", "colors": [[1, 1, 1], [0, 0, 0]]}}
                                if thing["type"] == "plane" else thing for thing in SCENE["objects"]] +
                    [{"type": "sphere", "center": [7, 0, 0], "radius": 1, "texture":
                      {"type": "image", "file": str(SOURCE / "docs/images/keel_crop.png")}}]}

# What a setting needs beside it to matter.
BESIDE = {"intersection.issue_order_queue": ['intersection.dispatch="first_free"'],
          "fifos.tree_accumulator_to_frame_buffer": ["frame_buffer.interval=20"]}
LEAST = {"subdivision_controller.pool": 7}  # that MAX_LEVEL 3 takes
STEP = 7
# A size that is there or not: the frame that does not fit is refused, no other is changed.
SIZES = {"pyramid_classifier.line_buffer": 24 + 2}


def schema_leaves():
    """Every setting of the schema: its path, and what is allowed."""
    document = json.loads((SOURCE / "docs" / "schemas" / "machine.schema.json").read_text())

    def leaves(node, path):
        node = {**document["$defs"].get(node.get("$ref", "").rpartition("/")[2], {}), **node}
        if "properties" not in node:
            yield ".".join(path), node
        for key, child in node.get("properties", {}).items():
            yield from leaves(child, path + [key])

    yield from leaves(document, [])


def settings():
    """Every setting of the schema: its path, and two of its values."""
    for path, node in schema_leaves():
        if "enum" in node:
            yield path, [json.dumps(value) for value in node["enum"][:2]]
        elif node["type"] == "string":
            yield path, ['"one"', '"other"']
        else:
            least = LEAST.get(path, node["minimum"])
            yield path, [least, least + STEP]


class Settings(tool.EndToEnd):
    def report(self, path, value):
        """Without what only repeats the setting."""
        sets = [word for setting in (*BESIDE.get(path, []), f"{path}={value}") for word in ("--set", setting)]
        scene = SHADOWED if "shadow_unit" in path else TEXTURED if path.startswith("color_unit.cost") else SCENE
        document = self.stats("simulate", self.write("scene.json", scene), "--max-level", 3, *sets)
        del document["command"]
        del document["machine"]["settings"]
        del document["machine"]["settings_sha256"]
        for fifo in document["fifos"]:
            del fifo["depth"]
        for key in ("clock_mhz", "budget"):
            if path != "goal_fps":
                del document["machine"][key]
        return document

    def test_each_moves_something(self):
        found = dict(settings())
        self.assertGreaterEqual(len(found), 35)
        for path, (one, other) in found.items():
            with self.subTest(setting=path):
                if path in SIZES:
                    continue
                self.assertNotEqual(self.report(path, one), self.report(path, other))

    def test_sizes_refuse_what_does_not_fit(self):
        scene = self.write("scene.json", SCENE)
        for path, least in SIZES.items():
            file = {}
            node = file
            *groups, key = path.split(".")
            for group in groups:
                node = node.setdefault(group, {})
            node[key] = least
            self.ok("simulate", scene, "--machine", self.write("machine.json", file))
            node[key] = least - 1
            self.refused(INPUT, "simulate", scene, "--machine", self.write("machine.json", file),
                         says=f"/{path.replace('.', '/')}: {least - 1} cannot hold")

    def effective(self, *options):
        machine = self.stats("simulate", self.write("scene.json", SCENE), "--size", "4x3", *options)["machine"]
        return machine["settings"], machine["settings_sha256"]

    def test_a_run_records_its_whole_machine(self):
        """As a machine file that makes the same machine, under another name."""
        small = tool.MACHINES / "small.json"
        settings, digest = self.effective("--machine", small, "--set", "intersection.latency=5")
        self.assertEqual(settings["intersection"]["latency"], 5)
        self.assertEqual(settings["fifos"]["tree_accumulator_to_frame_buffer"], 2)  # by small.json's fifos.all
        text = json.dumps(settings, separators=(",", ":"))
        self.assertEqual(digest, hashlib.sha256(text.encode()).hexdigest())
        again = self.effective("--machine", self.write("again.json", settings))
        self.assertEqual(again, (settings, digest))
        self.assertNotEqual(self.effective("--machine", small)[1], digest)

    def test_the_schema_says_the_defaults_and_the_limits(self):
        def flat(node, path=""):
            if not isinstance(node, dict):
                return {path: node}
            prefix = path + "." if path else ""
            return {name: value for key, child in node.items() for name, value in flat(child, prefix + key).items()}

        defaults = flat(self.effective()[0])
        nodes = dict(schema_leaves())
        self.assertEqual(set(nodes) - {"name", "fifos.all"}, set(defaults))
        for path, node in nodes.items():
            with self.subTest(setting=path):
                if "default" in node:
                    self.assertEqual(node["default"], defaults[path])
                if "minimum" not in node:
                    continue
                step = 1 if node["type"] == "integer" else 1e-4
                for value, code in ((node["minimum"], tool.OK), (node["minimum"] - step, INPUT),
                                    (node["maximum"], tool.OK), (node["maximum"] + 1, INPUT)):
                    file = {}
                    inner = file
                    *groups, key = path.split(".")
                    for group in groups:
                        inner = inner.setdefault(group, {})
                    inner[key] = value
                    run = self.run_tool("check", self.write("machine.json", file))
                    self.assertEqual(run.returncode, code, (value, run.stderr))

    def test_the_table_counts_what_was_set(self):
        scene = self.write("scene.json", SCENE)
        for options, title in (([], "default"), (["--set", "intersection.units=4"], "default"),
                               (["--set", "intersection.units=5"], "default + 1 setting"),
                               (["--set", "fifos.all=3", "--set", "clock_mhz=10"], "default + 12 settings"),
                               (["--machine", tool.MACHINES / "wide.json", "--set", "goal_fps=3"], "wide + 1 setting")):
            self.assertIn(f" on machine {title}\n", self.ok("simulate", scene, *options))

    def test_a_frame_buffer_has_no_latency(self):
        file = self.write("machine.json", {"frame_buffer": {"latency": 1}})
        says = "/frame_buffer/latency: nothing waits for what the frame buffer stores, so that it has no latency; remove it"
        self.refused(INPUT, "check", file, says=says)
        self.refused(tool.USAGE, "simulate", self.write("scene.json", SCENE), "--set", "frame_buffer.latency=3", says=says)


if __name__ == "__main__":
    tool.main()
