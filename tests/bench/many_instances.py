#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A scene of many instances of the bunny, the same each time: many_instances.py COUNT > scene.json"""
import json
import random
import sys

chance = random.Random(1)


def between(least, most):
    return round(chance.uniform(least, most), 4)


def instance():
    return {"type": "instance", "of": "bunny", "color": [between(0.2, 1) for _ in range(3)], "transform": [
        {"scale": [between(0.1, 0.3) for _ in range(3)]},
        {"rotate": {"axis": [between(-1, 1) for _ in range(3)], "degrees": between(0, 360)}},
        {"translate": [between(-2, 2), between(-0.9, 1.5), between(-3, 1)]}]}


print(json.dumps({
    "camera": {"position": [0.4, 1.2, 4], "look_at": [0, 0.3, 0],
               "screen": {"columns": 640, "rows": 480, "horizontal_fov": 50}},
    "light": {"ambient": 0.2, "direction": [-0.5, -1, -0.7]},
    "shapes": {"bunny": {"type": "mesh", "file": "/usr/share/glmark2/models/bunny.obj"}},
    "objects": [instance() for _ in range(int(sys.argv[1]))]}))
