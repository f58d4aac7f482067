# SPDX-License-Identifier: Apache-2.0
"""Textures with integral colour: how much better they are than points, and what they cost the machine."""

import math

import tool

CHECKER = {"type": "checker", "colors": [[0.9, 0.9, 0.9], [0.05, 0.05, 0.08]]}
CAMERA = {"position": [0, 1.5, 0], "look_at": [1, 1.4, 0.05],
          "screen": {"columns": 160, "rows": 120, "horizontal_fov": 60}}
HORIZON = {"camera": CAMERA, "background": [0.45, 0.6, 0.85],
           "objects": [{"type": "plane", "normal": [0, 1, 0], "offset": 0, "texture": CHECKER}]}


class Textures(tool.EndToEnd):
    def picture(self, scene, *options):
        self.ok("render", scene, *options, "-o", "picture.pfm")
        return tool.pfm_values(self.folder / "picture.pfm")

    @staticmethod
    def rmse(one, other):
        return math.sqrt(sum((a - b) ** 2 for a, b in zip(one, other)) / len(one))

    def test_a_checkered_plane_to_the_horizon(self):
        """One ray a pixel against 256 of them."""
        scene = self.write("horizon.json", HORIZON)
        reference = self.picture(scene, "--method", "grid:48", "--threads", "0")
        integral = self.rmse(self.picture(scene, "--max-level", "0"), reference)
        point = self.rmse(self.picture(scene, "--max-level", "0", "--texture", "point"), reference)
        grid = self.rmse(self.picture(scene, "--method", "grid:16"), reference)
        print(f"figure: RMSE {integral:.5f} integral, {point:.5f} point, {grid:.5f} grid:16")
        self.assertLess(integral, 1.5 * grid)
        self.assertLess(integral, point / 4)

    def test_a_picture_is_what_it_was(self):
        """A picture on a wall, seen pixel by texel."""
        self.ok("render", tool.SCENES / "keel.json", "--size", "40x30", "-o", "keel.png")
        self.ok("render", tool.SCENES / "keel.json", "--size", "40x30", "-o", "keel.pfm")
        wall = {"type": "plane", "normal": [-1, 0, 0], "offset": -1,
                "texture": {"type": "image", "file": "keel.png", "scale": [40, 30], "shift": [-20, -15]}}
        scene = {"camera": {"screen": {"columns": 40, "rows": 30, "dx": 1, "dy": 1, "dz": 1}}, "objects": [wall]}
        seen = self.picture(self.write("wall.json", scene), "--max-level", "0")
        original = tool.pfm_values(self.folder / "keel.pfm")
        self.assertLess(max(abs(a - b) for a, b in zip(seen, original)), 0.005)  # 8 bits, sRGB
        work = self.stats("simulate", self.folder / "wall.json", "--max-level", "0")["work"]["texture"]
        self.assertEqual(work["places"], 4 * 40 * 30)

    def test_color_multiplies(self):
        objects = [HORIZON["objects"][0] | {"color": [1, 0.5, 0]}]
        plain = self.picture(self.write("plain.json", HORIZON))
        tinted = self.picture(self.write("tinted.json", HORIZON | {"objects": objects, "background": [0, 0, 0]}))
        below = slice(3 * 160 * 100, None)
        for factor, k in ((1, 0), (0.5, 1), (0, 2)):
            for one, other in zip(plain[below][k::3], tinted[below][k::3]):
                self.assertAlmostEqual(factor * one, other, 6)

    def test_what_it_costs_the_machine(self):
        scene = self.write("horizon.json", HORIZON)
        document = self.stats("simulate", scene)
        work = document["work"]["texture"]
        self.assertGreater(work["lines"], 0)
        self.assertGreater(work["places"], 4 * 160 * 50)
        self.assertEqual(document["image"], self.stats("render", scene)["image"])
        self.assertEqual(work, self.stats("render", scene)["work"]["texture"])
        part = next(line for line in self.ok("simulate", scene, "--explain").splitlines() if line.startswith("  texture"))
        self.assertIn("built: 1 object of the scene has a texture", part)
        plain = HORIZON | {"objects": [{"type": "plane", "normal": [0, 1, 0], "offset": 0, "color": [1, 1, 1]}]}
        self.assertIn("color_unit.texture", [part["name"] for part in
                                             self.stats("simulate", self.write("p.json", plain))["machine"]["omitted"]])

    def test_export_says_that_it_writes_means(self):
        run = self.run_tool("export", self.write("horizon.json", HORIZON), "-o", "-")
        self.assertEqual(run.stderr, "pyrasim: warning: the textures of 1 object are written as their mean colours\n")
        self.assertRegex(run.stdout, "pigment { rgb <0.475[0-9]*, 0.475[0-9]*, 0.49[0-9]*> }")

    def test_mistakes(self):
        def refused(texture, says, **more):
            thing = {"type": "sphere", "center": [9, 0, 0], "radius": 1, "texture": texture, **more}
            self.refused(tool.INPUT, "check", self.write("wrong.json", tool.scene([thing])), says=says)

        refused({"type": "checker"}, "/objects/0/texture")
        refused(CHECKER | {"type": "dots"}, '/objects/0/texture/type: "dots"')
        refused(CHECKER | {"scale": [1, 0]}, "/objects/0/texture/scale/1")
        refused(CHECKER | {"colors": [[1, 1, 1]]}, "/objects/0/texture/colors")
        refused(CHECKER | {"size": 1}, "/objects/0/texture/size: unknown key")
        refused({"type": "image", "file": "none.png"}, "none.png")
        refused({"type": "image", "file": "none.jpg"}, "/objects/0/texture/file: it is no PNG file by its name")
        refused({"type": "image", "file": "x.png", "colors": []}, "/objects/0/texture/colors: unknown key")
        self.write("broken.png", b"\x89PNG\r\n\x1a\n and no more")
        refused({"type": "image", "file": "broken.png"}, "broken.png")
        mesh = {"type": "mesh", "file": str(tool.SCENES / "keel_fin.obj"), "texture": CHECKER}
        self.refused(tool.INPUT, "check", self.write("wrong.json", tool.scene([mesh])),
                     says="/objects/0/texture: some faces of the mesh have no texture coordinates (vt)")


tool.main()
