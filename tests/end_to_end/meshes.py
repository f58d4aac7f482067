# SPDX-License-Identifier: Apache-2.0
"""What OBJ files say beside triangles: materials, texture coordinates, normals, groups."""

import tool
from tool import INPUT

CAMERA = {"position": [0, 0, 0.03], "look_at": [1, 0, 0.03], "screen": {"columns": 64, "rows": 48, "horizontal_fov": 40}}
#: A wall of two panes before the observer, 4 units wide and 3 high: the left one red, the right one with a picture.
WALL = """mtllib wall.mtl
v 6 -1.5 -2
v 6 -1.5 0
v 6 -1.5 2
v 6 1.5 -2
v 6 1.5 0
v 6 1.5 2
vt 0 0
vt 1 0
vt 0 1
vt 1 1
vn -1 0 0
o left
usemtl red
f 1/1/1 2/2/1 5/4/1 4/3/1
o right
usemtl picture
f 2/1/1 3/2/1 6/4/1 5/3/1
"""
MATERIALS = "newmtl red\nKd 1 0 0\nnewmtl picture\nKd 1 1 1\nmap_Kd -s 2 1 checks.png\n"


class Meshes(tool.EndToEnd):
    def setUp(self):
        super().setUp()
        self.write("wall.obj", WALL)
        self.write("wall.mtl", MATERIALS)
        checks = {"camera": {"screen": {"columns": 4, "rows": 4, "dx": 1, "dy": 1, "dz": 1}}, "objects": [
            {"type": "plane", "normal": [-1, 0, 0], "offset": -1,
             "texture": {"type": "checker", "colors": [[0, 0, 1], [0, 1, 0]], "scale": [2, 2]}}]}
        self.ok("render", self.write("checks.json", checks), "-o", "checks.png")

    def scene(self, *objects, **more):
        objects = [{"type": "mesh", "file": "wall.obj"} | thing for thing in objects]
        return self.write("scene.json", {"camera": CAMERA, "objects": objects} | more)

    def pixels(self, scene, *options):
        self.ok("render", scene, *options, "-o", "picture.pfm")
        values = tool.pfm_values(self.folder / "picture.pfm")
        return [tuple(values[k:k + 3]) for k in range(0, len(values), 3)]

    def test_materials_are_colours_pictures_and_edges(self):
        scene = self.scene({"name": "wall"})
        pixels = self.pixels(scene)
        middle = 24 * 64
        self.assertEqual(pixels[middle + 12], (1, 0, 0))
        self.assertEqual({pixels[middle + k] for k in range(34, 52)} & {(0, 0, 1), (0, 1, 0)}, {(0, 0, 1), (0, 1, 0)})
        several = self.stats("render", scene)
        self.assertIn("a scene of 2 objects", self.ok("check", scene))
        one = self.stats("render", self.scene({"color": [1, 1, 1]}))
        self.assertGreater(several["rays"]["total"], one["rays"]["total"], "the border of two materials is an edge")

    def test_the_whole_is_seen_the_same_by_all(self):
        scene = self.scene({"smooth": True}, {"smooth": True, "split": "groups", "transform": {"translate": [3, 0.5, 2]}},
                           lights=[{"type": "point", "position": [3, 1, 1], "color": [1, 1, 1]}])
        expected = self.pixels(scene)
        self.assertGreater(len(set(expected)), 100)
        for engine in ("decoupled", "lockstep"):
            self.ok("simulate", scene, "--engine", engine, "-o", "simulated.pfm")
            self.assertEqual(tool.sha256_of_pfm(self.folder / "simulated.pfm"),
                             tool.sha256_of_pfm(self.folder / "picture.pfm"))

    def test_groups_are_objects(self):
        scene = self.scene({"color": [1, 1, 1], "split": "groups"})
        self.assertIn("a scene of 2 objects", self.ok("check", scene, warnings=1))

    def test_warnings(self):
        run = self.run_tool("check", self.scene({"color": [1, 1, 1]}))
        self.assertIn("materials are not used (2)", run.stderr)
        self.assertIn("groups are one object (2)", run.stderr)
        self.assertEqual(len(run.stderr.splitlines()), 2)
        self.ok("check", self.scene({"split": "groups"}))
        self.ok("check", self.scene({}))

    def test_mistakes(self):
        def refused(says, thing=None):
            self.refused(INPUT, "render", self.scene(thing or {}), "-o", "x.png", says=says)
            self.assertFalse((self.folder / "x.png").exists())

        self.write("wall.mtl", MATERIALS.replace("checks.png", "none.png"))
        refused("wall.mtl:5: ")
        self.write("wall.mtl", MATERIALS.replace("checks.png", "checks.json"))
        refused("checks.json is no PNG file by its name")
        self.write("wall.mtl", MATERIALS.replace("newmtl picture", "newmtl other"))
        refused('wall.obj:17: none of its libraries has a material "picture"')
        self.write("wall.mtl", WALL)
        refused('wall.obj:14: none of its libraries has a material "red"')
        (self.folder / "wall.mtl").unlink()
        refused("wall.obj:1: ")
        self.ok("check", self.scene({"color": [1, 1, 1]}), warnings=2)
        refused("/objects/0/split: ", {"split": "materials"})
        self.write("wall.obj", WALL.replace("/1/1 ", "//1 "))
        refused("no texture coordinates (vt)", {"texture": {"type": "image", "file": "checks.png"}})
        self.write("wall.obj", WALL.replace("/1/1 ", " "))
        refused("/objects/0/smooth: some faces of the mesh have no normals", {"color": [1, 1, 1], "smooth": True})


tool.main()
