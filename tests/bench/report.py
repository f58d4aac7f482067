#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the benchmarks and prints their ratios as Markdown: report.py FOLDER_OF_BENCHMARKS ROUNDS"""
import json
import os
import re
import subprocess
import sys
import tempfile

SCENES = ["keel", "spheres", "bunny"]
UNITS = [1, 4, 16]


def povray_seconds(pov):
    """The trace time that POV-Ray prints: one thread, one ray a pixel, 640x480, no output file."""
    run = subprocess.run(["povray", "+WT1", "-A", "-D", "-F", "+W640", "+H480", f"+I{pov}"], capture_output=True,
                         text=True, check=True)
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
        with open(pov, "w", encoding="utf-8") as file:
            subprocess.run(["/usr/bin/python3", "tests/bench/povray_scene.py", "scenes/spheres.json"], stdout=file,
                           check=True)
        povray, ours = [], []
        for _ in range(rounds):
            povray.append(povray_seconds(pov))
            ours.append(render_seconds(folder))
    theirs, mine = 307200 / min(povray), 308321 / min(ours)
    print("| spheres, 640x480, one thread | million primary rays a second | ratio |\n|---|---|---|")
    print(f"| POV-Ray `+WT1 -A` | {theirs / 1e6:.2f} | 1 |")
    print(f"| pyrasim `render --threads 1`, double | {mine / 1e6:.2f} | {mine / theirs:.2f} |\n")


def simulations(folder, rounds):
    print("| scene | units | render, ns a ray | 2 threads | simulate | timing | in sc_fifo transfers | "
          "simulate / render | lockstep / simulate |\n|---|---|---|---|---|---|---|---|---|")
    for scene in SCENES:
        for units in UNITS:
            run = subprocess.run([f"{folder}/simulation_bench", f"scenes/{scene}.json", "3", str(rounds),
                                  f"intersection.units={units}"], capture_output=True, text=True, check=True)
            row = json.loads(run.stdout)
            timing = row["decoupled"] - row["render"]
            print(f"| {scene} | {units} | {row['render']:.0f} | {row['render'] / row['render_two_threads']:.2f}x | "
                  f"{row['decoupled']:.0f} | {timing:.0f} | {timing / row['sc_fifo_transfer']:.2f} | "
                  f"{row['decoupled'] / row['render']:.2f} | {row['lockstep'] / row['decoupled']:.1f} |", flush=True)


def main():
    folder, rounds = sys.argv[1], int(sys.argv[2])
    against_povray(folder, rounds)
    simulations(folder, rounds)


main()
