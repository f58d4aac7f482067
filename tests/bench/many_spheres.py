#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A scene of many spheres, the same each time: many_spheres.py COUNT > scene.json"""
import json
import random
import sys

chance = random.Random(1)


def between(least, most):
    return round(chance.uniform(least, most), 4)


def sphere():
    return {"type": "sphere", "center": [between(-50, 50) for _ in range(3)], "radius": between(0.05, 0.3),
            "color": [between(0, 1) for _ in range(3)]}


camera = {"position": [-150, 0, 0], "look_at": [0, 0, 0],
          "screen": {"columns": 640, "rows": 480, "horizontal_fov": 60}}
print(f'{{"camera": {json.dumps(camera)}, "light": {{"ambient": 0.2, "direction": [1, -1, 0.5]}}, "objects": [')
print(",\n".join(json.dumps(sphere()) for _ in range(int(sys.argv[1]))) + "]}")
