# SPDX-License-Identifier: Apache-2.0
"""Scenes in the Neutral File Format: what tools/generate writes, and that NFF says what the same scene in JSON does."""

import math
import re
import subprocess
import sys

import tool
from tool import INPUT, SOURCE, USAGE

GENERATE = [sys.executable, "-B", SOURCE / "tools" / "generate"]
DATABASES = ("balls", "gears", "mount", "rings", "tetra", "tree")
VIEW = "v\nfrom 0 -5 0\nat 0 0 0\nup 0 0 1\nangle 60\nhither 1\nresolution 32 32\n"


def generate(*arguments):
    return subprocess.run([*GENERATE, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          timeout=120, check=False)


class Generate(tool.EndToEnd):
    @classmethod
    def setUpClass(cls):
        """What --help says: the number of objects by database and size."""
        text = re.sub(r"\n {9}", " ", generate("--help").stdout)
        cls.counts = {name: dict(re.findall(r"(\d+): (\d+)", line))
                      for name, line in re.findall(r"(?m)^  (\w+)  .*Objects by SIZE: (.*)$", text)}

    def database(self, name, size):
        run = generate(name, size)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return self.write(f"{name}.nff", run.stdout), run.stdout

    def test_there_are_as_many_objects_as_help_says(self):
        self.assertEqual(tuple(self.counts), DATABASES)
        for name, counts in self.counts.items():
            for size in ("1", "2", "3"):
                _, text = self.database(name, size)
                self.assertEqual(len(re.findall(r"(?m)^(?:s|c|p)\b", text)), int(counts[size]), (name, size))
                self.assertIn(f"size {size}: {counts[size]} objects", text)
            self.assertGreater(int(counts[max(counts, key=int)]), 500000, name)
            self.assertLess(int(counts[max(counts, key=int)]), 1100000, name)

    def test_the_same_each_time(self):
        for name in DATABASES:
            self.assertEqual(generate(name, 2).stdout, generate(name, 2).stdout)

    def test_they_are_checked_and_rendered(self):
        for name in DATABASES:
            file, text = self.database(name, 2)
            glass = re.findall(r"(?m)^f(?: \S+){6} (?!0 )\S+ \S+$", text)
            checked = self.ok("check", file, warnings=1 if glass else 0)
            self.assertEqual(checked, f"{file}: a scene of {self.counts[name]['2']} objects on 512x512 pixels\n")
            self.assertEqual(bool(glass), name in ("gears", "mount"))
            self.ok("render", file, "--size", "32x32", "--max-level", "1", "-o", f"{name}.pfm", warnings=bool(glass))
            colors = set(zip(*[iter(tool.pfm_values(self.folder / f"{name}.pfm"))] * 3))
            self.assertGreater(len(colors), 50, name)

    def test_usage(self):
        for arguments, says in ((("cubes", 1), "invalid choice: 'cubes'"), (("balls", 0), "balls takes 1 to 6"),
                                (("rings", 37), "rings takes 1 to 36"), (("tree", "x"), "invalid int value: 'x'")):
            run = generate(*arguments)
            self.assertEqual((run.returncode, run.stdout), (USAGE, ""))
            self.assertIn(says, run.stderr)


class Scenes(tool.EndToEnd):
    def render(self, scene, *more):
        self.ok("render", scene, "-o", "out.pfm", *more)
        return tool.read_pfm(self.folder / "out.pfm")[2]

    def test_right_is_right_and_up_is_up(self):
        """World x, y, z are right, forward and up here: a red ball right of the middle, a green one above it."""
        scene = self.write("s.nff", VIEW + "f 1 0 0 1 0 0 0 1\ns 2 0 0 0.5\nf 0 1 0 1 0 0 0 1\ns 0 0 2 0.5\n")
        self.render(scene)
        seen = {}
        for row in range(32):
            for column in range(32):
                seen.setdefault(tool.pixel_of_pfm(self.folder / "out.pfm", row, column), []).append((row, column))
        for color, place in (((1, 0, 0), (0, 1)), ((0, 1, 0), (-1, 0))):
            self.assertGreater(len(seen[color]), 9)
            for row, column in seen[color]:
                self.assertEqual([(x > 20) - (x < 11) for x in (row, column)], list(place), (color, row, column))

    def test_it_is_the_same_scene_as_in_json(self):
        nff = self.write("s.nff", VIEW + "b 0.1 0.2 0.3\nl 3 -4 5\nl -3 -4 5 0.5 0.25 1\nl 0 0 9 0.25 0.25 0.25\n"
                         "f 1 0.5 0.25 1 0 0 0 1\ns 0 0 0.5 1\nc\n-2 0 -1 0.5\n-2 0 1 0.25\nc 2 0 -1 0.5 2 0 1 0.5\n"
                         "p 4\n-4 4 -1\n4 4 -1\n4 -4 -1\n-4 -4 -1\npp 3\n-1 1 1 0 0 1\n1 1 1 0 0 1\n0 1 2 0 0 1\n"
                         "p 4\n-1 -2 -0.9\n0 -1.5 -0.9\n1 -2 -0.9\n0 -1 -0.9\n")
        self.write("chevron.obj", "v -1 -2 -0.9\nv 0 -1.5 -0.9\nv 1 -2 -0.9\nv 0 -1 -0.9\nf 1 2 3 4\n")
        color = [1, 0.5, 0.25]
        objects = [{"type": "sphere", "center": [0, 0, 0.5], "radius": 1},
                   {"type": "cone", "base": [-2, 0, -1], "cap": [-2, 0, 1], "base_radius": 0.5, "cap_radius": 0.25,
                    "capped": False},
                   {"type": "cylinder", "base": [2, 0, -1], "cap": [2, 0, 1], "radius": 0.5, "capped": False},
                   {"type": "polygon", "vertices": [[-4, 4, -1], [4, 4, -1], [4, -4, -1], [-4, -4, -1]]},
                   {"type": "triangle", "vertices": [[-1, 1, 1], [1, 1, 1], [0, 1, 2]]},
                   {"type": "mesh", "file": "chevron.obj"}]
        lights = [([3, -4, 5], [1 / math.sqrt(3)] * 3), ([-3, -4, 5], [0.5, 0.25, 1]), ([0, 0, 9], [0.25] * 3)]
        document = {"camera": {"position": [0, -5, 0], "look_at": [0, 0, 0], "up": [0, 0, 1],
                               "screen": {"columns": 32, "rows": 32, "horizontal_fov": 60}},
                    "background": [0.1, 0.2, 0.3],
                    "lights": [{"type": "point", "position": place, "color": light} for place, light in lights],
                    "objects": [{**thing, "color": color} for thing in objects]}
        same = self.write("s.json", document)
        self.assertEqual(self.render(nff), self.render(same))
        texts = []
        for scene in (nff, same):
            self.ok("export", scene, "-o", "out.pov")
            texts.append((self.folder / "out.pov").read_text().split("\n", 1)[1])  # without the command in the first line
        self.assertEqual(*texts)
        runs = [self.stats("simulate", scene, "--size", "16x16") for scene in (nff, same)]
        self.assertEqual(*(run["machine"]["cycles"] for run in runs))

    def test_the_resolution_shows_a_square(self):
        text = VIEW + "f 1 1 1 1 0 0 0 1\ns 0 0 0 1\n"
        self.write("wide.nff", text.replace("32 32", "128 32"))
        self.assertEqual(self.ok("check", "wide.nff"), "wide.nff: a scene of 1 object on 128x32 pixels\n")
        rows = self.render("wide.nff")
        white = [sum(row[k : k + 12] != bytes(12) for k in range(0, len(row), 12)) for row in rows]
        self.assertAlmostEqual(max(white) / sum(count > 0 for count in white), 4, delta=0.4)

    def test_mistakes(self):
        mistake = self.write("s.nff", VIEW + "f 1 1 1 1 0 0 0 1\ns 0 0 zero 1\n")
        says = f'{mistake}:9: "zero" is no coordinate; a number from -1e+30 to 1e+30 is allowed'
        for command in (["check"], ["render"], ["simulate"], ["sweep"], ["export", "-o", "out.pov"], ["diagram"]):
            self.refused(INPUT, *command, mistake, says=says)
        self.refused(INPUT, "check", "none.nff", says="none.nff: cannot be read: No such file or directory")
        self.refused(USAGE, "export", self.write("good.nff", VIEW), "-o", "good.nff", says="its name must end in .pov")


tool.main()
