#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""How far the texture's mean over a footprint is off where the footprint is an approximation: RMSE of pictures at one ray a
pixel against 4,096 rays a pixel, of surfaces that fill the picture, but for the horizon of one.

Usage: curved_footprints.py PYRASIM"""

import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

SIZE = (48, 36)
# Surfaces, and how many of their units a pixel in the picture's middle is wide.
SURFACES = {
    "plane, square on": ({"type": "plane", "normal": [-1, 0, 0], "offset": -1}, 1),
    "plane, at 8 degrees": ({"type": "plane", "normal": [-0.14, 0.99, 0], "offset": -0.6}, 4),
    "sphere": ({"type": "sphere", "center": [2, 0, 0], "radius": 1.2}, 0.8 / (2 * math.pi * 1.2)),
    "cylinder": ({"type": "cylinder", "base": [2, -9, 0.1], "cap": [2, 9, 0], "radius": 1.2}, 0.8 / (2 * math.pi * 1.2)),
}


def samples(file):
    data = pathlib.Path(file).read_bytes().split(b"\n", 3)[3]
    return struct.unpack(f"<{len(data) // 4}f", data)


def rmse(one, other):
    return math.sqrt(sum((a - b) ** 2 for a, b in zip(one, other)) / len(one))


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    print("surface              cells a pixel   integral      point    grid:4")
    with tempfile.TemporaryDirectory() as folder:
        for name, (surface, unit) in SURFACES.items():
            for cells in (0.2, 1, 5):
                pixel = 2 * math.tan(math.radians(20)) / SIZE[0]
                scale = unit * pixel / cells
                texture = {"type": "checker", "colors": [[1, 1, 1], [0, 0, 0]], "scale": [scale, scale], "turn": 20}
                scene = {"camera": {"screen": {"columns": SIZE[0], "rows": SIZE[1], "horizontal_fov": 40}},
                         "background": [0.5, 0.5, 0.5], "objects": [{**surface, "texture": texture}]}
                file = pathlib.Path(folder) / "scene.json"
                file.write_text(json.dumps(scene))

                def picture(*options):
                    image = pathlib.Path(folder) / "image.pfm"
                    subprocess.run([program, "render", file, *options, "-o", image], check=True, capture_output=True)
                    return samples(image)

                reference = picture("--method", "grid:64")
                errors = [rmse(picture(*options), reference) for options in (
                    ("--max-level", "0"), ("--max-level", "0", "--texture", "point"), ("--method", "grid:4"))]
                print(f"{name:20} {cells:13} {errors[0]:10.4f} {errors[1]:10.4f} {errors[2]:9.4f}", flush=True)


main()
