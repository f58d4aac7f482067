# SPDX-License-Identifier: Apache-2.0
"""A mistake in a file is one line, the right exit code, and no output; odd input that is allowed works."""

import itertools
import json

import tool
from tool import INPUT, USAGE, SPHERE

TRIANGLE = {"type": "triangle", "vertices": [[5, 0, 0], [5, 1, 0], [5, 0, 1]], "color": [1, 1, 1]}
SQUARE = "v 5 -1 -1\nv 5 1 -1\nv 5 1 1\nv 5 -1 1\n"


class BadInput(tool.EndToEnd):
    def refused_everywhere(self, file, says, code=INPUT):
        """Every command that reads a scene refuses the file, and writes nothing."""
        self.refused(code, "check", file, says=says)
        for command in ("render", "simulate"):
            self.refused(code, command, file, "-o", self.folder / "out.png", "--stats", self.folder / "out.json",
                         says=says)
        self.refused(code, "sweep", file, "--csv", self.folder / "out.csv", says=says)
        self.refused(code, "level", file, says=says)

    def test_unreadable(self):
        self.refused_everywhere("missing.json", "missing.json: cannot be read: No such file")
        self.refused_everywhere(".", "it is a folder")
        self.refused_everywhere("two\nlines.json", "two\\u000alines.json")
        self.refused_everywhere(self.write("empty.json", ""), "empty.json:1:1")

    def test_syntax(self):
        good = json.dumps(tool.scene())
        for name, text, says in (
                ("cut", good[:-1], "cut.json:1:"), ("more", good + "}", "more.json:1:"),
                ("comma", good[:-1] + ",}", "comma.json:1:"), ("binary", "\0\1\2", "binary.json:1:1"),
                ("nan", good.replace("0.125", "NaN"), "NaN is not a JSON number"),
                ("inf", good.replace("0.125", "-Infinity"), "-Infinity is not a JSON number"),
                ("huge", good.replace("0.125", "1e999"), "/background/0: the number 1e999 is too large"),
                ("twice", good.replace('"rows"', '"columns"'), "/camera/screen/columns: the key appears twice"),
                ("deep", "[" * 100000, "nested too deeply")):
            self.refused_everywhere(self.write(f"{name}.json", text), says)
        latin1 = good.encode().replace(b"sphere", b"sph\xe8re")
        self.refused_everywhere(self.write("latin1.json", latin1), "latin1.json")

    def test_scene(self):
        screen = {"columns": 8, "rows": 6, "horizontal_fov": 40}
        for document, says in (
                ([], "it is an array"), ('"scene"', "it is the string"), ({"camera": {"screen": screen}}, '"objects"'),
                ({**tool.scene(), "lamps": []}, "/lamps: unknown key"),
                (tool.scene([{**SPHERE, "radios": 1}]), "/objects/0/radios: unknown key"),
                (tool.scene([{**SPHERE, "radius": 0}]), "/objects/0/radius: 0 is out of range"),
                (tool.scene([{**SPHERE, "radius": -1}]), "/objects/0/radius"),
                (tool.scene([{**SPHERE, "color": [1, 1]}]), "/objects/0/color: it has 2 elements"),
                (tool.scene([{**SPHERE, "type": "cube"}]), '/objects/0/type: "cube" is unknown'),
                (tool.scene([SPHERE, {**TRIANGLE, "vertices": [[5, 0, 0], [5, 1, 1], [5, 2, 2]]}]),
                 "/objects/1/vertices"),
                (tool.scene([{"type": "plane", "normal": [0, 0, 0], "offset": 1, "color": [1, 1, 1]}]),
                 "/objects/0/normal"),
                (tool.scene(columns=0, rows=0), "/camera/screen/columns: 0 is out of range"),
                (tool.scene(columns=1.5), "/camera/screen/columns"), (tool.scene(rows=65536), "/camera/screen/rows"),
                (tool.scene(horizontal_fov=180), "/camera/screen/horizontal_fov")):
            self.refused_everywhere(self.write("scene.json", document), says)

    def test_mesh(self):
        scene = self.write("scene.json", tool.scene([{"type": "mesh", "file": "mesh.obj", "color": [1, 1, 1]}]))
        self.refused_everywhere(scene, "mesh.obj")  # missing
        for obj in (SQUARE + "f 1 2 5\n", SQUARE + "f 1 2 0\n", SQUARE + "f -1 -2 -9\n", SQUARE + "f 1 2 x\n",
                    SQUARE + "f 1 2\n", SQUARE + "v 1 nan 2\nf 1 2 5\n", SQUARE + "f 1 2 99999999999999999999\n",
                    "# nothing\n", SQUARE, SQUARE + "f 1 1 2\n"):
            self.write("mesh.obj", obj)
            self.refused_everywhere(scene, "mesh.obj")

    def test_degenerate_triangle_of_a_mesh(self):
        """It is skipped with one line on stderr, and changes nothing."""
        scene = self.write("scene.json", tool.scene([{"type": "mesh", "file": "mesh.obj", "color": [1, 1, 1]}]))
        hashes = []
        for degenerate in ("", "f 1 2 2\n", "f 1 2 2\nf 3 3 3\n"):
            self.write("mesh.obj", SQUARE + "f 1 2 3 4\n" + degenerate)
            for command in (["render"], ["simulate"]):
                run = self.run_tool(*command, scene, "--stats", self.folder / "out.json")
                self.assertEqual(run.returncode, tool.OK)
                lines = run.stderr.splitlines()
                self.assertEqual(len(lines), 1 if degenerate else 0, run.stderr)
                self.assertTrue(all(line.startswith("pyrasim: warning: ") for line in lines), run.stderr)
                hashes.append(tool.read_json(self.folder / "out.json")["image"]["sha256"])
        self.assertEqual(len(set(hashes)), 1)

    def test_odd_but_allowed(self):
        picture = self.folder / "out.pfm"
        empty = self.write("empty.json", tool.scene([]))
        background = self.stats("render", empty, "-o", picture)
        self.assertEqual({tool.pixel_of_pfm(picture, row, column) for row in range(6) for column in range(8)},
                         {(0.125, 0.25, 0.5)})
        self.assertEqual(self.stats("simulate", empty)["image"], background["image"])
        for size in ("1x1", "20000x1", "1x20000"):
            scene = self.write("scene.json", tool.scene())
            rendered = self.stats("render", scene, "--size", size, "-o", picture)
            self.assertEqual("{}x{}".format(*tool.read_pfm(picture)[:2]), size)
            self.assertEqual(self.stats("simulate", scene, "--size", size)["image"], rendered["image"])
        commented = self.write("commented.json", "// a scene\n" + json.dumps(tool.scene()) + " // the end")
        self.ok("render", commented, "-o", self.folder / "out.png")
        not_utf8 = self.folder / "sc\udce8ne.json"
        not_utf8.write_text(json.dumps(tool.scene()))
        self.assertEqual(self.stats("render", not_utf8)["scene"], str(self.folder / "sc\ufffdne.json"))

    def test_lights_in_and_on_surfaces(self):
        """What faces away from its lamp, or holds it, is dark: without a speckle, where rays meet the lamp itself too."""
        ring = {"type": "torus", "center": [10, 0, 0], "axis": [1, 0, 0], "major_radius": 2, "minor_radius": 0.5}
        screen = {"columns": 20, "rows": 20, "dx": 1, "dy": 0.05, "dz": 0.05}
        for surface, *lamps in (
                ({"type": "sphere", "center": [10, 0, 0], "radius": 2}, [8, 0, 0], [10, 0, 0]),
                ({"type": "box", "min": [8, -2, -2], "max": [12, 2, 2]}, [8, 0.4, 1.2], [10, 0, 0]),
                ({"type": "plane", "normal": [-1, 0, 0], "offset": -8}, [8, 0.8, 0.8], [8, 0, 0]),
                ({"type": "cylinder", "base": [8, 0, 0], "cap": [12, 0, 0], "radius": 2}, [8, 0.4, 0.8], [9, 0, 0]),
                ({"type": "disc", "center": [8, 0, 0], "normal": [1, 0, 0], "radius": 2}, [8, 0.4, 0.8]),
                ({"type": "triangle", "vertices": [[8, -2, -2], [8, 2, -2], [8, 0, 2]]}, [8, 0.4, -0.8]),
                (ring, [10, 2, 0])):
            for lamp, falloff in itertools.product(lamps, ("none", "quadratic")):
                lights = [{"type": "ambient", "color": [0.25, 0.25, 0.25]},
                          {"type": "point", "position": lamp, "color": [1, 1, 1], "falloff": falloff}]
                scene = self.write("lamp.json", {"camera": {"screen": screen}, "lights": lights,
                                                 "objects": [{**surface, "color": [1, 1, 1]}]})
                self.ok("render", scene, "-o", "lamp.pfm")
                values = tool.pfm_values(self.folder / "lamp.pfm")
                self.assertTrue(all(0 <= value <= 0.25 + 1e-6 for value in values), (surface, lamp, max(values)))
                self.assertAlmostEqual(max(values), 0.25)

    def test_many_lights(self):
        """A hundred thousand without shadows shine like one."""
        def lit(count):
            lamp = {"type": "point", "color": [1 / count] * 3, "position": [0, 5, 3], "shadow": False}
            scene = self.write("lamps.json", {**tool.scene(), "lights": [lamp] * count})
            self.ok("render", scene, "-o", "lamps.pfm")
            return tool.pfm_values(self.folder / "lamps.pfm")
        one, many = lit(1), lit(100000)
        self.assertGreater(len(set(one)), 4)
        for a, b in zip(one, many):
            self.assertAlmostEqual(a, b, places=6)

    def test_machine_file(self):
        scene = self.write("scene.json", tool.scene())
        for text, says in (
                ("{", "machine.json:1:2"), ('{"clock": 1}', "/clock: unknown key"),
                ('{"clock_mhz": "fast"}', '/clock_mhz: it is the string "fast"'), ("[]", "it is an array"),
                ('{"clock_mhz": NaN}', "NaN"), ('{"name": 1}', "/name"), ('{"name": "a", "name": "b"}', "twice"),
                ('{"intersection": {"units": 0}}', "/intersection/units: 0 is out of range"),
                ('{"intersection": {"units": 1.5}}', "/intersection/units"),
                ('{"fifos": 8}', "/fifos: it is the number"),
                ('{"fifos": {"all": 65537}}', "/fifos/all"), ('{"pixel_scan": {"pool": 1}}', "/pixel_scan/pool"),
                ('{"intersection": {"cost": {"ray": 0}}}', "/intersection/cost/ray"),
                ('{"subdivision_controller": {"pool": 6}}', "at least 7")):
            machine = self.write("machine.json", text)
            self.refused(INPUT, "simulate", scene, "--machine", machine, "-o", "out.png", "--stats", "out.json",
                         "--trace", "out.vcd", says=says)
            self.refused(INPUT, "sweep", scene, "--max-level", "3", "--machine", machine, "--csv", "out.csv", says=says)
        self.ok("simulate", scene, "--machine", machine, "--max-level", "2")
        self.refused(INPUT, "simulate", scene, "--machine", "missing.json", says="missing.json: cannot be read")
        self.refused(INPUT, "simulate", scene, "--set", "subdivision_controller.pool=0", says="pool")

    def test_pictures(self):
        good = self.folder / "good.pfm"
        self.ok("render", self.write("scene.json", tool.scene()), "-o", good)
        self.write("cut.pfm", good.read_bytes()[:-1])
        self.write("text.png", "not a picture")
        for bad in ("missing.png", "missing.pfm", "cut.pfm", "text.png"):
            self.refused(INPUT, "compare", good, bad, says=bad)
            self.refused(INPUT, "compare", bad, good, "-o", "out.png", says=bad)
        self.refused(USAGE, "compare", good, "picture.bmp", says="picture.bmp")
        self.ok("render", "scene.json", "--size", "9x6", "-o", "other.pfm")
        self.refused(USAGE, "compare", good, "other.pfm", "--crop", "4x4", says="8x6 and 9x6")


tool.main()
