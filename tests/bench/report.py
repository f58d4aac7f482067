#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the benchmarks and prints their ratios as Markdown: report.py FOLDER_OF_BENCHMARKS ROUNDS"""
import json
import os
import random
import re
import subprocess
import sys
import tempfile

SCENES = ["keel", "spheres", "bunny"]
UNITS = [1, 4, 16]


def program(folder):
    return os.path.join(folder, "..", "..", "pyrasim")


def povray(pov, columns, rows):
    """Its command: one thread, one ray a pixel, no output file."""
    return ["povray", "+WT1", "-A", "-D", "-F", f"+W{columns}", f"+H{rows}", f"+I{pov}"]


def povray_seconds(pov):
    """The trace time that POV-Ray prints, 640x480."""
    run = subprocess.run(povray(pov, 640, 480), capture_output=True, text=True, check=True)
    return float(re.search(r"Trace Time:.*\(([0-9.]+) seconds\)", run.stdout + run.stderr).group(1))


def render_seconds(folder):
    """One frame of the same scene at MAX_LEVEL 0: 308,321 rays, one thread, double."""
    run = subprocess.run([f"{folder}/kernel_bench", "--benchmark_filter=^frame/spheres/0/1/",
                          "--benchmark_min_time=0.3", "--benchmark_format=json"], capture_output=True, text=True,
                         check=True)
    return json.loads(run.stdout)["benchmarks"][0]["real_time"] / 1e3


def against_povray(folder, rounds):
    with tempfile.TemporaryDirectory() as temporary:
        pov = os.path.join(temporary, "spheres.pov")
        subprocess.run([program(folder), "export", "scenes/spheres.json", "-o", pov], check=True)
        theirs, ours = [], []
        for _ in range(rounds):
            theirs.append(povray_seconds(pov))
            ours.append(render_seconds(folder))
    theirs, mine = 307200 / min(theirs), 308321 / min(ours)
    print("| spheres, 640x480, one thread | million primary rays a second | ratio |\n|---|---|---|")
    print(f"| POV-Ray `+WT1 -A` | {theirs / 1e6:.2f} | 1 |")
    print(f"| pyrasim `render --threads 1`, double | {mine / 1e6:.2f} | {mine / theirs:.2f} |\n")


def thousand_spheres(shadow):
    """Over a plane, under a lamp and a sun that cast shadows or do not."""
    dice = random.Random(5)
    between = dice.uniform
    objects = [{"type": "plane", "normal": [0, 1, 0], "offset": -6, "color": [0.8, 0.8, 0.8]}]
    objects += [{"type": "sphere", "center": [between(12, 40), between(-6, 8), between(-13, 13)],
                 "radius": between(0.2, 0.7), "color": [between(0, 1), between(0, 1), between(0, 1)]}
                for _ in range(1000)]
    lights = [{"type": "ambient", "color": [0.1, 0.1, 0.1]},
              {"type": "point", "position": [10, 20, 8], "color": [0.6, 0.6, 0.6], "shadow": shadow},
              {"type": "directional", "direction": [1, -1, 0.5], "color": [0.4, 0.4, 0.4], "shadow": shadow}]
    screen = {"columns": 1600, "rows": 1200, "horizontal_fov": 60}
    return {"camera": {"position": [0, 0, 0], "look_at": [1, 0, 0], "screen": screen}, "lights": lights,
            "objects": objects}


def usage_of(command):
    """What a run that has to work takes of the machine."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    status, usage = os.wait4(process.pid, 0)[1:]
    if status:
        raise SystemExit(f"{' '.join(command)} failed")
    return usage


def shadows_against_povray(folder, rounds):
    """What shadows add to one ray a pixel, 1600x1200, one thread: both ask the same lights from the same places."""
    with tempfile.TemporaryDirectory() as temporary:
        commands = {}
        for shadow in (True, False):
            scene, pov, statistics = (os.path.join(temporary, f"{shadow}.{kind}") for kind in ("json", "pov", "stats"))
            with open(scene, "w", encoding="utf-8") as file:
                json.dump(thousand_spheres(shadow), file)
            subprocess.run([program(folder), "export", scene, "-o", pov], check=True)
            commands["theirs", shadow] = povray(pov, 1600, 1200)
            commands["ours", shadow] = [program(folder), "render", scene, "--method", "point", "--threads", "1",
                                        "--stats", statistics]
        rows = [{run: usage_of(command).ru_utime for run, command in commands.items()} for _ in range(rounds)]
        with open(os.path.join(temporary, "True.stats"), encoding="utf-8") as file:
            rays = json.load(file)["rays"]["shadow"]["total"]
    least = {run: min(row[run] for row in rows) for run in commands}
    theirs, mine = (rays / (least[whose, True] - least[whose, False]) for whose in ("theirs", "ours"))
    print("| 1,000 spheres and a plane, 2 lights, one thread | million shadow rays a second | ratio |\n|---|---|---|")
    print(f"| POV-Ray `+WT1 -A` | {theirs / 1e6:.2f} | 1 |")
    print(f"| pyrasim `render --method point --threads 1`, double | {mine / 1e6:.2f} | {mine / theirs:.2f} |\n",
          flush=True)


def bench(folder, scene, rounds, size="640x480", settings=()):
    run = subprocess.run([f"{folder}/simulation_bench", f"scenes/{scene}.json", "3", str(rounds), size, *settings],
                         capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def simulations(folder, rounds):
    print("| scene | units | render, ns a ray | 2 threads | simulate | timing | in sc_fifo transfers | simulate / render "
          "| lockstep / simulate | cycle loop / simulate | simulate, 2 threads | timing in transfers | simulate / render "
          "|\n" + "|---" * 13 + "|")
    for scene in SCENES:
        for units in UNITS:
            row = bench(folder, scene, rounds, settings=[f"intersection.units={units}"])
            render, transfer, one, two = (row[key] for key in ("render", "sc_fifo_transfer", "decoupled",
                                                               "decoupled_two_threads"))
            print(f"| {scene} | {units} | {render:.0f} | {render / row['render_two_threads']:.2f}x | {one:.0f} | "
                  f"{one - render:.0f} | {(one - render) / transfer:.2f} | {one / render:.2f} | "
                  f"{row['lockstep'] / one:.1f} | {row['cycle_loop'] / one:.1f} | {two:.0f} | "
                  f"{(two - render) / transfer:.2f} | {two / render:.2f} |", flush=True)
    print(f"\nOne timed sc_fifo transfer between two SC_THREADs: {transfer:.0f} ns in the last row.\n")


def scaling(folder, rounds):
    """Cost must grow with the rays alone: not with the frame's size, nor with cycles in which nothing happens."""
    slow = ["intersection.latency=16", *(f"intersection.cost.{name}={cycles}" for name, cycles in
                                         [("ray", 2), ("box_test", 2), ("sphere", 4), ("plane", 2), ("triangle", 6)])]
    print("| simulate, 4 units, one thread | 480x270, ns a ray | 1920x1080 | ratio | units half as fast, 640x480 | cycles "
          "| host time |\n" + "|---" * 7 + "|")
    for scene in SCENES:
        small, large = (bench(folder, scene, rounds, size)["decoupled"] for size in ("480x270", "1920x1080"))
        usual, slower = bench(folder, scene, rounds), bench(folder, scene, rounds, settings=slow)
        print(f"| {scene} | {small:.0f} | {large:.0f} | {large / small:.2f} | {slower['decoupled']:.0f} | "
              f"{slower['cycles'] / usual['cycles']:.2f}x | {slower['decoupled'] / usual['decoupled']:.2f}x |",
              flush=True)


def memory(folder):
    print("\n| simulate at 1920x1080, MAX_LEVEL 3 | most memory, MB |\n|---|---|")
    for scene in SCENES:
        usage = usage_of([program(folder), "simulate", f"scenes/{scene}.json", "--size", "1920x1080"])
        print(f"| {scene} | {usage.ru_maxrss / 1024:.0f} |", flush=True)


def main():
    folder, rounds = sys.argv[1], int(sys.argv[2])
    against_povray(folder, rounds)
    shadows_against_povray(folder, rounds)
    simulations(folder, rounds)
    scaling(folder, rounds)
    memory(folder)


main()
