#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a scene of spheres, planes and triangles as POV-Ray's: povray_scene.py SCENE.json > SCENE.pov

The camera is given by its three vectors, so that handedness does not matter; light and shading follow docs/guide.md.
"""
import json
import math
import sys


def vector(v):
    return "<" + ", ".join(f"{x:.17g}" for x in v) + ">"


def scaled(v, s):
    return [x * s for x in v]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    return scaled(v, 1 / math.sqrt(sum(x * x for x in v)))


def camera(c):
    screen = c["screen"]
    if "horizontal_fov" in screen:
        dx = 1.0
        width = 2 * math.tan(math.radians(screen["horizontal_fov"]) / 2)
        height = width * screen["rows"] / screen["columns"]
    else:
        dx, width, height = screen["dx"], screen["columns"] * screen["dz"], screen["rows"] * screen["dy"]
    position = c.get("position", [0, 0, 0])
    forward = unit(minus(c.get("look_at", [1, 0, 0]), position))
    right = unit(cross(forward, c.get("up", [0, 1, 0])))
    up = cross(right, forward)
    return (f"camera {{ perspective location {vector(position)} direction {vector(scaled(forward, dx))} "
            f"up {vector(scaled(up, height))} right {vector(scaled(right, width))} }}")


def surface(o):
    if o["type"] == "sphere":
        return f"sphere {{ {vector(o['center'])}, {o['radius']:.17g}"
    if o["type"] == "plane":
        length = math.sqrt(sum(x * x for x in o["normal"]))
        return f"plane {{ {vector(o['normal'])}, {o['offset'] / length:.17g}"
    if o["type"] == "triangle":
        return "triangle { " + ", ".join(vector(v) for v in o["vertices"])
    sys.exit(f"povray_scene.py: no {o['type']}")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        scene = json.load(file)
    print("#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 1 }")
    print(camera(scene["camera"]))
    print(f"background {{ rgb {vector(scene.get('background', [0, 0, 0]))} }}")
    light = scene.get("light")
    ambient, diffuse = (light.get("ambient", 0), 1 - light.get("ambient", 0)) if light else (1, 0)
    if light:
        source = scaled(unit(light["direction"]), -1e6)
        print(f"light_source {{ {vector(source)} rgb 1 parallel point_at <0, 0, 0> shadowless }}")
    for o in scene["objects"]:
        print(f"{surface(o)} pigment {{ rgb {vector(o['color'])} }} "
              f"finish {{ ambient {ambient} diffuse {diffuse} }} }}")


main()
