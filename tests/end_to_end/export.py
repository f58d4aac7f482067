# SPDX-License-Identifier: Apache-2.0
"""What pyrasim export writes shows in POV-Ray, at one ray a pixel, what pyrasim render --method point shows."""

import concurrent.futures
import json
import math
import pathlib
import random
import re
import struct
import subprocess
import tempfile

import tool
from tool import SCENES

RANDOM_SCENES = 50
LARGEST_ERROR = 1 / 4096
SURFACES = ("sphere", "plane", "triangle", "disc", "box", "ellipsoid", "cylinder", "cone", "quadric", "polygon",
            "torus", "mesh", "instance")


def povray(scene, columns, rows):
    """Rows of linear colours, from 0 to 1: one ray a pixel, 16 bits, no transfer function."""
    picture = scene.with_suffix(".ppm")
    run = subprocess.run(["povray", f"+I{scene.name}", f"+O{picture.name}", f"+W{columns}", f"+H{rows}", "+FP16",
                          "File_Gamma=1.0", "-A", "-D", "+WT1", "-GA"], cwd=scene.parent, stdin=subprocess.DEVNULL,
                         capture_output=True, check=False, timeout=120)
    said = run.stderr.decode(errors="replace")
    assert run.returncode == 0, said
    assert "Warning" not in said.replace("This is an unofficial version", ""), said
    header, samples = re.match(rb"(P6\s(?:#[^\n]*\n|\s)*\d+\s+\d+\s+65535\s)(.*)", picture.read_bytes(), re.S).groups()
    assert header.startswith(b"P6") and len(samples) == columns * rows * 6
    return as_rows([value / 65535 for value in struct.unpack(f">{columns * rows * 3}H", samples)], columns)


def as_rows(samples, columns):
    pixels = list(zip(samples[0::3], samples[1::3], samples[2::3]))
    return [pixels[k : k + columns] for k in range(0, len(pixels), columns)]


def number_of(color):
    """The object that id_color() says, 0 for none: its bits are dealt out to red, green and blue from the highest down."""
    levels = [round(component * 255) for component in color]
    return sum((levels[bit % 3] >> (7 - bit // 3) & 1) << bit for bit in range(24))


def numbered(document):
    """The same scene without light, where an object's colour says its number."""
    objects = [{**thing, "color": [k + 1, 0, 0]} for k, thing in enumerate(document["objects"])]
    unlit = {key: value for key, value in document.items() if key not in ("light", "lights")}
    return {**unlit, "background": [0, 0, 0], "objects": objects}


def in_light_and_shadow(document, chance):
    """The same scene under a list of lights."""
    def color():
        return [chance.uniform(0, 0.6) for _ in range(3)]

    def direction():
        return [chance.uniform(-1, 1) for _ in range(3)]

    eye, target = document["camera"]["position"], document["camera"]["look_at"]
    lights = [{"type": "ambient", "color": [0.1, 0.2, 0.1], "intensity": chance.uniform(0, 1)}]
    for falloff, strength in (("none", 1), ("linear", 4), ("quadratic", 30)):
        ahead = chance.uniform(-2, 8)
        place = [e + ahead * (t - e) + 4 * d for e, t, d in zip(eye, target, direction())]
        lights.append({"type": "point", "position": place, "color": color(), "intensity": strength,
                       "falloff": falloff, "shadow": chance.random() < 0.7})
    for shadow in (True, False):
        lights.append({"type": "directional", "direction": direction(), "color": color(), "shadow": shadow})
    objects = [{**thing, "shadow": chance.random() < 0.8} for thing in document["objects"]]
    return {**{key: value for key, value in document.items() if key != "light"}, "lights": lights, "objects": objects}


def inside(ids, row, column):
    """Whether a pixel and its neighbours show one object."""
    around = {ids[r][c] for r in range(max(row - 1, 0), min(row + 2, len(ids)))
              for c in range(max(column - 1, 0), min(column + 2, len(ids[0])))}
    return len(around) == 1


class RandomScene:
    """Up to fourteen surfaces of moderate size in front of an observer anywhere, without any that coincide."""

    def __init__(self, seed, folder):
        self.random = random.Random(seed)
        self.folder = folder
        self.name = f"random_{seed}"
        self.eye = self.vector(20)
        self.forward, self.up = self.unit(), self.unit()
        self.meshes, self.shapes = 0, {}

    def vector(self, size):
        return [self.random.uniform(-size, size) for _ in range(3)]

    def unit(self):
        while True:
            v = self.vector(1)
            length = math.hypot(*v)
            if 0.1 < length < 1:
                return [x / length for x in v]

    def between(self, least, most):
        return self.random.uniform(least, most)

    def chance(self, share=0.5):
        return self.random.random() < share

    def place(self):
        distance, spread = self.between(4, 16), self.vector(1)
        return [e + distance * (f + 0.45 * s) for e, f, s in zip(self.eye, self.forward, spread)]

    def near(self, place, size):
        return [x + d for x, d in zip(place, self.vector(size))]

    def document(self):
        kinds = list(SURFACES) + self.random.choices(SURFACES, k=3)
        self.random.shuffle(kinds)
        document = {
            "camera": {"position": self.eye, "look_at": [e + f for e, f in zip(self.eye, self.forward)], "up": self.up,
                       "screen": {"columns": 64, "rows": 48, "horizontal_fov": self.between(30, 90)}},
            "background": [self.between(0, 1) for _ in range(3)],
            "objects": [{"name": f"{kind} ü */ \\\n#error", "type": kind, **getattr(self, kind)(),
                         "color": [self.between(0.2, 1) for _ in range(3)]}
                        for kind in kinds[: self.random.randrange(3, 17)]]}
        if self.shapes:
            document["shapes"] = self.shapes
        if self.chance(0.8):
            document["light"] = {"ambient": self.random.choice([0, 1, self.between(0, 1)]), "direction": self.vector(3)}
        return document

    def transformed(self, document):
        """The same scene with each surface turned, mirrored or sheared about a place before the observer."""
        place = [e + 9 * f for e, f in zip(self.eye, self.forward)]
        for thing in document["objects"]:
            back = {"translate": [-x for x in place]}
            steps = [{"rotate": {"axis": self.unit(), "degrees": self.between(-180, 180)}}]
            if thing["type"] in ("disc", "torus") or self.chance(0.3):
                steps.append({"scale": self.random.choice([-1, 1]) * self.between(0.6, 1.5)})
            elif self.chance():
                steps.append({"scale": [self.random.choice([-1, 1]) * self.between(0.4, 1.8) for _ in range(3)]})
            else:
                steps.append({"matrix": [[self.between(-0.5, 0.5) + (i == j) for j in range(3)] + [0]
                                         for i in range(3)]})
            thing["transform"] = [back, *steps, {"translate": place}]
        return document

    def sphere(self):
        return {"center": self.place(), "radius": self.between(0.1, 2)}

    def plane(self):
        normal, place = self.vector(2), [e - f * self.between(1, 3) for e, f in zip(self.place(), self.vector(3))]
        return {"normal": normal, "offset": sum(n * p for n, p in zip(normal, place))}

    def triangle(self):
        place = self.place()
        return {"vertices": [self.near(place, 3) for _ in range(3)]}

    def disc(self):
        return {"center": self.place(), "normal": self.vector(1), "radius": self.between(0.3, 2)}

    def box(self):
        place = self.place()
        return {"min": [x - self.between(0.1, 1) for x in place], "max": [x + self.between(0.1, 1) for x in place]}

    def ellipsoid(self):
        return {"center": self.place(), "radii": [self.between(0.1, 2) for _ in range(3)]}

    def cylinder(self):
        base = self.place()
        return {"base": base, "cap": self.near(base, 3), "radius": self.between(0.1, 1.2), "capped": self.chance()}

    def cone(self):
        base = self.place()
        radii = [self.between(0.1, 1.5), self.random.choice([0, self.between(0.1, 1.5)])]
        self.random.shuffle(radii)
        return {"base": base, "cap": self.near(base, 3), "base_radius": radii[0], "cap_radius": radii[1],
                "capped": self.chance()}

    def quadric(self):
        """(p - c) . A (p - c) + l . (p - c) = k, of any kind and at any angle; clipped in any way, or not at all."""
        c = self.place()
        xx, yy, zz = (self.random.choice([0, self.between(-1, 1)]) for _ in range(3))
        xy, xz, yz = (self.random.choice([0, self.between(-1, 1)]) for _ in range(3))
        linear, k = [self.random.choice([0, self.between(-1, 1)]) for _ in range(3)], self.between(-1, 1)
        if not any((xx, yy, zz, xy, xz, yz)):
            xx = 1
        gradient = [2 * xx * c[0] + xy * c[1] + xz * c[2], xy * c[0] + 2 * yy * c[1] + yz * c[2],
                    xz * c[0] + yz * c[1] + 2 * zz * c[2]]
        x, y, z = (l - g for l, g in zip(linear, gradient))
        constant = sum(g * p for g, p in zip(gradient, c)) / 2 - sum(l * p for l, p in zip(linear, c)) - k
        clip = {}
        if self.chance(0.9):
            clip = {"min": [p - self.between(0.5, 2) for p in c], "max": [p + self.between(0.5, 2) for p in c]}
        if self.chance():
            normal = self.vector(1)
            offset = sum(n * p for n, p in zip(normal, c)) + self.between(0, 0.5)
            clip["planes"] = [{"normal": normal, "offset": offset}]
        coefficients = {"xx": xx, "yy": yy, "zz": zz, "xy": xy, "xz": xz, "yz": yz, "x": x, "y": y, "z": z,
                        "constant": constant}
        return {"coefficients": coefficients, "clip": clip, "capped": self.chance()}

    def polygon(self):
        center, a, b = self.place(), self.vector(1.5), self.vector(1.5)
        corners = self.random.randrange(3, 9)
        turns = [(k + self.between(-0.3, 0.3)) * 2 * math.pi / corners for k in range(corners)]
        return {"vertices": [[c + math.cos(t) * u + math.sin(t) * v for c, u, v in zip(center, a, b)] for t in turns]}

    def torus(self):
        major = self.between(0.4, 1.8)
        return {"center": self.place(), "axis": self.vector(1), "major_radius": major,
                "minor_radius": major * self.between(0.1, 0.9)}

    def mesh(self):
        """A bent octahedron."""
        place, axes = self.place(), [[0.7 * x for x in self.unit()] for _ in range(3)]
        corners = [[p + sign * self.between(0.5, 2) * a for p, a in zip(place, axis)] for axis in axes
                   for sign in (1, -1)]
        faces = [(x, y, z) for x in (1, 2) for y in (3, 4) for z in (5, 6)]
        self.meshes += 1
        file = self.folder / f"{self.name}_{self.meshes}.obj"
        file.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in corners)
                        + "".join(f"f {a} {b} {c}\n" for a, b, c in faces))
        return {"file": str(file)}

    def instance(self):
        """Of a mesh that others may show, or of an instance of it."""
        if not self.shapes:
            self.shapes = {"mesh": {"type": "mesh", **self.mesh()},
                           "tall": {"type": "instance", "of": "mesh", "transform": [{"scale": [1, 1.25, 1]}]}}
        return {"of": self.random.choice(list(self.shapes)), "transform": {"translate": self.vector(2)}}


class Comparison:
    """Of one scene in both programs; what of it differs."""

    def __init__(self, folder, name, document, size):
        self.name, self.columns, self.rows = name, *size
        self.kinds = [thing["type"] for thing in document["objects"]]
        scene, numbers = folder / f"{name}.json", folder / f"{name}_numbers.json"
        scene.write_text(json.dumps(document))
        numbers.write_text(json.dumps(numbered(document)))
        self.ids = [[round(color[0]) for color in row] for row in self.render(numbers)]
        self.pov_ids = [[number_of(color) for color in row] for row in self.export(scene, "--ids")]
        self.colors, self.pov_colors = self.render(scene), self.export(scene)
        self.without_shadows = self.render(self.without(document, scene))

    @staticmethod
    def without(document, scene):
        file = scene.with_name(scene.stem + "_unshadowed.json")
        lights = {"lights": [{**light, "shadow": False} if light["type"] != "ambient" else light
                             for light in document["lights"]]} if "lights" in document else {}
        file.write_text(json.dumps({**document, **lights}))
        return file

    def render(self, scene):
        picture = scene.with_suffix(".pfm")
        subprocess.run([tool.PYRASIM, "render", scene, "--method", "point", "--threads", "1", "--size",
                        f"{self.columns}x{self.rows}", "-o", picture], check=True, capture_output=True)
        assert tool.read_pfm(picture)[:2] == (self.columns, self.rows)
        return as_rows(tool.pfm_values(picture), self.columns)

    def export(self, scene, *options):
        pov = scene.with_name(scene.stem + "".join(options) + ".pov")
        subprocess.run([tool.PYRASIM, "export", scene, *options, "--size", f"{self.columns}x{self.rows}", "-o", pov],
                       check=True, capture_output=True)
        return povray(pov, self.columns, self.rows)

    def pixels(self):
        return ((row, column) for row in range(self.rows) for column in range(self.columns))

    def other_objects(self):
        return [(row, column) for row, column in self.pixels() if self.ids[row][column] != self.pov_ids[row][column]]

    def insides(self):
        return [(row, column) for row, column in self.pixels()
                if inside(self.ids, row, column) and inside(self.pov_ids, row, column)]

    def color_error(self, row, column):
        return max(abs(min(a, 1) - b) for a, b in zip(self.colors[row][column], self.pov_colors[row][column]))


def by_material(thing, folder):
    """A mesh with the colours of its materials as a mesh for each, without their pictures."""
    mesh = pathlib.Path(thing["file"])
    words = [line.split() for line in mesh.with_suffix(".mtl").read_text().splitlines()]
    colors, faces, others = {}, {}, []
    for keyword, *rest in words:
        if keyword == "newmtl":
            name = rest[0]
        elif keyword == "Kd":
            colors[name] = [float(number) for number in rest]
    for line in mesh.read_text().splitlines():
        if line.startswith("usemtl"):
            name = line.split()[1]
        elif line.startswith("f "):
            faces.setdefault(name, []).append(line)
        elif line.startswith("v"):
            others.append(line)
    for name, its in faces.items():
        file = folder / f"{mesh.stem}_{name}.obj"
        file.write_text("\n".join([*others, *its]) + "\n")
        yield {**thing, "file": str(file), "color": colors[name]}


def shipped(folder):
    """Textures are written as their means: here there are none."""
    for file in sorted(SCENES.glob("*.json")):
        document = tool.read_json(file)
        for thing in [*document["objects"], *document.get("shapes", {}).values()]:
            if thing["type"] == "mesh":
                thing["file"] = str(SCENES / thing["file"])
            if thing.pop("texture", None):
                thing.setdefault("color", [0.5, 0.6, 0.7])
        document["objects"] = [part for thing in document["objects"] for part in
                               ([thing] if "color" in thing else by_material(thing, folder))]
        yield file.stem, document, (160, 120)


def randomly(folder):
    for seed in range(RANDOM_SCENES):
        scene = RandomScene(seed, folder)
        document = scene.document()
        if seed % 4 < 2:
            document = scene.transformed(document)
        yield scene.name, in_light_and_shadow(document, scene.random) if seed % 2 else document, (64, 48)


class AgainstPovRay(tool.EndToEnd):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory(prefix="pyrasim_test_") as folder:
            folder = pathlib.Path(folder)
            with concurrent.futures.ThreadPoolExecutor(4) as pool:  # POV-Ray sleeps most of a short run
                cls.scenes = list(pool.map(lambda scene: Comparison(folder, *scene), [*shipped(folder), *randomly(folder)]))

    def test_the_same_objects(self):
        pixels = sum(scene.columns * scene.rows for scene in self.scenes)
        others = {scene.name: scene.other_objects() for scene in self.scenes if scene.other_objects()}
        print("figure: other objects", sum(map(len, others.values())), "of", pixels, others)
        self.assertLessEqual(sum(map(len, others.values())), pixels / 10000, others)

    def test_the_same_colors(self):
        worst = 0
        for scene in self.scenes:
            insides = scene.insides()
            self.assertGreater(len(insides), scene.rows * scene.columns / 10, scene.name)
            errors = {pixel: scene.color_error(*pixel) for pixel in insides}
            worst = max(worst, *errors.values())
            wrong = {pixel: error for pixel, error in errors.items() if error > LARGEST_ERROR}
            self.assertEqual(wrong, {}, scene.name)
        print("figure: largest error of a colour", worst)

    def test_every_surface_is_seen(self):
        seen = dict.fromkeys(SURFACES, 0)
        for scene in self.scenes:
            for row, column in scene.insides():
                if number := scene.ids[row][column]:
                    seen[scene.kinds[number - 1]] += 1
        print("figure: pixels", seen)
        for surface, pixels in seen.items():
            self.assertGreater(pixels, 500, surface)

    def test_shadows_are_seen(self):
        shadowed = sum(scene.colors[row][column] != scene.without_shadows[row][column]
                       for scene in self.scenes for row, column in scene.insides())
        print("figure: pixels in shadow", shadowed)
        self.assertGreater(shadowed, 5000)

    def test_mistakes(self):
        scene = self.write("scene.json", tool.scene())
        self.refused(tool.USAGE, "export", scene, says="--output is required")
        self.refused(tool.USAGE, "export", scene, "-o", "scene.json", says="its name must end in .pov")
        self.refused(tool.INPUT, "export", "none.json", "-o", "out.pov", says="none.json")


tool.main()
