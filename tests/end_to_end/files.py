# SPDX-License-Identifier: Apache-2.0
"""Scene, mesh and machine files as other programs write them: what is read, what is warned of, and what of them reaches
the terminal."""

import json
import os
import re
import subprocess

import tool
from tool import INPUT, OK, SCENES, MACHINES, USAGE

SQUARE = "v 5 -1 -1\nv 5 1 -1\nv 5 1 1\nv 5 -1 1\n"
DART = [(1.5, 0.0), (-1.2, 0.3), (0.9, 0.0), (-1.2, -0.3)]
PENTAGON = [(1.3, 2.0), (2.0, 1.0), (1.3, 0.1), (0.2, 0.4), (0.8, 1.2)]
COMB = [(-1.5, -1), (1.5, -1), (1.5, 1), (1, 1), (1, -0.5), (0.5, -0.5), (0.5, 1), (0, 1), (0, -0.5), (-1.5, -0.5)]
KEYHOLE = [(-1.2, -1.2), (-1.2, 1.2), (1.2, 1.2), (1.2, -1.2), (-1.2, -1.2),
           (-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5), (-0.5, -0.5)]
BOW_TIE = [(-1, -1), (1, 1), (1, -1), (-1, 1)]

# What may steer a terminal: control characters but the newline, and marks of the direction of writing.
STEERS = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")


def obj(corners, faces=None, scale=1.0):
    """Points (y, z) of the plane x = 5 and one face of them all, or `faces`."""
    lines = [f"v {5 * scale!r} {y * scale!r} {z * scale!r}" for y, z in corners]
    for face in faces or [range(1, len(corners) + 1)]:
        lines.append("f " + " ".join(map(str, face)))
    return "\n".join(lines) + "\n"


class Files(tool.EndToEnd):
    def setUp(self):
        super().setUp()
        mesh = {"type": "mesh", "file": "mesh.obj", "color": [1, 1, 1]}
        self.scene = self.write("scene.json", tool.scene([mesh], columns=64, rows=64))

    def hash_of(self, text, warnings=0, method="grid:8"):
        """The picture of a mesh, with `warnings` lines on stderr."""
        self.write("mesh.obj", text)
        out = self.ok("render", self.scene, "--method", method, "--stats", "-", warnings=warnings)
        return json.loads(out)["image"]["sha256"]

    def warning_of(self, text):
        self.write("mesh.obj", text)
        run = self.run_tool("check", self.scene)
        self.assertEqual(run.returncode, OK, run.stderr)
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
        self.assertTrue(run.stderr.startswith(f"pyrasim: warning: {self.scene}: /objects/0/file: "), run.stderr)
        return run.stderr

    def test_polygons(self):
        """A polygon's picture is that of triangles cut by hand, from whichever corner and whichever way round it goes."""
        for corners, faces, more in (
                (DART, [(1, 2, 3), (1, 3, 4)], []),
                (PENTAGON, [(1, 2, 6), (2, 3, 6), (3, 4, 6), (4, 5, 6), (5, 1, 6)], [(1.0, 1.0)]),
                (COMB, [(1, 2, 11), (1, 11, 10), (5, 11, 3), (5, 3, 4), (9, 6, 7), (9, 7, 8)], [(1.5, -0.5)]),
                (KEYHOLE, [(1, 2, 9), (1, 9, 6), (2, 3, 8), (2, 8, 9), (3, 4, 7), (3, 7, 8), (4, 1, 6), (4, 6, 7)], [])):
            expected = self.hash_of(obj(corners + more, faces))
            for first in range(len(corners)):
                turned = corners[first:] + corners[:first]
                self.assertEqual(self.hash_of(obj(turned)), expected, turned)
                self.assertEqual(self.hash_of(obj(turned[::-1])), expected, turned)
            for scale in (2.0**80, 2.0**-80):
                self.assertEqual(self.hash_of(obj(corners, scale=scale)), expected, scale)
        self.assertNotEqual(self.hash_of(obj(DART)), self.hash_of(obj(DART, [(1, 2, 4)])))

    def test_polygons_that_cross_themselves(self):
        warning = self.warning_of(obj(BOW_TIE + DART, [(1, 2, 3, 4), (4, 3, 2, 1), (5, 6, 7, 8)]))
        self.assertIn("mesh.obj: 2 polygons cross or cover themselves, the first in line 9;", warning)

    def test_obj_dialects(self):
        """What other readers accept: a byte-order mark, continued lines, empty parts of corners, comments anywhere."""
        face = "f 1 2 3 4\n"
        expected = self.hash_of(SQUARE + face, method="point")
        for text in (
                "\ufeff" + SQUARE + face, SQUARE + "f 1 2 \\\n3 4\n", (SQUARE + face).replace(" -1\n", " \\\n-1\n"),
                SQUARE + "f 1/ 2/ 3/ 4/\n", SQUARE + "f 1// 2// 3// 4//\n", SQUARE + "f 1 2 3 4 # quad\n",
                SQUARE + "f -4 -3 -2 -1\n", (SQUARE + face).replace("\n", "\r\n"), (SQUARE + face).replace("\n", "\r"),
                (SQUARE + face).replace(" ", "\t"), (SQUARE + face).replace("\n", " \t\n  "), SQUARE + face[:-1]):
            self.assertEqual(self.hash_of(text.encode(), method="point"), expected, text)

    def test_what_is_not_read_of_an_obj(self):
        face = "f 1 2 3 4\n"
        self.assertIn("mesh.obj: materials are not used (1), since the object has a color or a texture",
                      self.warning_of(SQUARE + "mtllib a.mtl\no a\ng b\nusemtl c\n" + face + "usemtl d\n"))
        self.assertIn("mesh.obj: lines, points and free-form surfaces are not read (l 2, p 1);",
                      self.warning_of(SQUARE + face + "l 1 2\nl 2 3\np 0\n"))
        self.assertIn("mesh.obj: unknown keywords (bar 1, foo 2);", self.warning_of(SQUARE + face + "foo\nbar\nfoo 1\n"))
        self.hash_of(SQUARE + "vn 0 0 1\nvt 0 0\ns 1\n# end\n" + face)

    def test_json_ends_where_its_file_does(self):
        good = json.dumps(tool.scene())
        for name, text, says in (
                ("tail", good + " \0 } garbage", f"tail.json:1:{len(good) + 2}: a null character"),
                ("null", good + "\0", f"null.json:1:{len(good) + 1}: a null character"),
                ("comment", "// \0\n" + good, "comment.json:1:4: a null character"),
                ("latin1", b"// \xe8\n" + good.encode(), "latin1.json:1:4: the byte 0xe8 is not UTF-8")):
            self.refused(INPUT, "check", self.write(f"{name}.json", text), says=says)
        self.ok("check", self.write("bom.json", b"\xef\xbb\xbf" + good.encode()))

    def test_messages_are_short(self):
        much = 100_000 * "w"
        for document in ({**tool.scene(), much: 1}, tool.scene([{**tool.SPHERE, "type": much}]), {much: {much: 1}}, much,
                         tool.scene([{**tool.SPHERE, "radius": much}])):
            self.assert_short(INPUT, "check", self.write("long.json", document))
        self.assert_short(INPUT, "check", self.write("cut.json", '{"' + much))
        self.assert_short(INPUT, "check", self.write("twice.json", f'{{"{much}": 1, "{much}": 2}}'))
        self.assert_short(INPUT, "check", much)
        for settings in (much, much + "=1", "intersection." + much + "=1", "name=\"" + much, "clock_mhz=" + much):
            self.assert_short(USAGE, "simulate", SCENES / "keel.json", "--set", settings)
        self.assert_short(USAGE, "check", "--" + much)
        self.write("mesh.obj", SQUARE + "f 1 2 " + much)
        self.assert_short(INPUT, "check", self.scene)
        self.assertLess(len(self.warning_of(SQUARE + "f 1 2 3\n" + much + "\n")), 600)

    def assert_short(self, code, *arguments):
        run = self.run_tool(*arguments)
        self.assertEqual(run.returncode, code, run.stderr[:2000])
        self.assertEqual(run.stderr.count("\n"), 1)
        self.assertLess(len(run.stderr), 1300, run.stderr[:2000])

    def test_settings_of_any_depth(self):
        for levels in (65, 60_000):
            self.refused(USAGE, "simulate", SCENES / "keel.json", "--size", "8x6", "--set", ".".join(levels * "a") + "=1",
                         says=f"it is nested {levels} levels deep; at most 64 levels are allowed")
        self.refused(USAGE, "simulate", SCENES / "keel.json", "--size", "8x6", "--set", ".".join(64 * "a") + "=1",
                     says="unknown key")

    def test_nothing_steers_the_terminal(self):
        steering = "\x1b[31mred\x1b[2J\x07\r\nline\x7f\x9b2J\x85\u202etxt\u2066\u2028"
        machine = self.write("machine.json", {"name": steering})
        scene = self.write("named.json", tool.scene([{**tool.SPHERE, "name": steering, "kind" + steering: 1}]))
        good = self.write("good" + steering + ".json", tool.scene())
        bad = self.write("bad" + steering + ".json", {steering: steering})
        self.write("mesh.obj", SQUARE + f"f 1 2 {steering}\n")
        for arguments in (
                ("check", machine), ("check", scene), ("check", good), ("check", bad), ("check", self.scene),
                ("check", "missing" + steering), ("check", "--" + steering), (steering,),
                ("simulate", good, "--machine", machine, "--max-level", "2"),
                ("budget", good, "--machine", machine, "--max-level", "1"),
                ("simulate", good, "--set", "name=" + steering), ("simulate", good, "--set", steering + "=1"),
                ("simulate", good, "--set", f"subdivision_controller.pool=6", "--machine", machine),
                ("render", good, "-o", steering + ".bmp"), ("render", good, "--size", steering),
                ("render", good, "--scalar", steering), ("render", good, "--method", steering),
                ("compare", steering + ".png", "other.png")):
            run = self.run_tool(*arguments)
            self.assertTrue(run.stdout + run.stderr, arguments)
            self.assertEqual(STEERS.findall(run.stdout + run.stderr), [], arguments)

    def run_with_pipe(self, content, *arguments):
        run = subprocess.run([tool.PYRASIM, *arguments], input=content, capture_output=True, cwd=self.folder,
                             timeout=120, encoding="utf-8", check=False)
        self.assertEqual((run.returncode, run.stderr), (OK, ""), arguments)
        return run.stdout

    def test_pipes_are_read_once(self):
        scene = json.dumps(tool.scene())
        machine = (MACHINES / "default.json").read_text()
        self.assertIn("/dev/stdin: a scene of 1 object", self.run_with_pipe(scene, "check", "/dev/stdin"))
        self.assertIn("/dev/stdin: machine default", self.run_with_pipe(machine, "check", "/dev/stdin"))
        file = self.write("file.json", scene)
        for command in ("render", "simulate"):
            self.run_with_pipe(scene, command, "/dev/stdin", "--stats", "out.json")
            self.assertEqual(tool.read_json(self.folder / "out.json")["image"], self.stats(command, file)["image"])
        self.run_with_pipe(machine, "simulate", str(file), "--machine", "/dev/stdin", "--max-level", "1")

    def test_meshes_of_a_piped_scene(self):
        """They are relative to the current folder; a mesh may come from a pipe as well."""
        self.write("mesh.obj", SQUARE + "f 1 2 3 4\n")
        self.run_with_pipe(self.scene.read_text(), "check", "/dev/stdin")
        self.write("scene.json", self.scene.read_text().replace("mesh.obj", "/dev/stdin"))
        self.run_with_pipe(SQUARE + "f 1 2 3 4\n", "check", os.fspath(self.scene))


tool.main()
