#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""How far the estimates of whatif --sensitivity are from what whatif finds, over all changes of frames on machines.
Usage: sensitivity.py PYRASIM"""
import csv
import io
import pathlib
import statistics
import subprocess
import sys
import tempfile

PYRASIM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(__file__).resolve().parents[2]
FRAMES = (("keel", "default"), ("shadows", "default"), ("buoys", "small"), ("fins", "wide"))
WORST = 5


def rows(*arguments):
    run = subprocess.run([PYRASIM, *arguments, "--csv", "-"], capture_output=True, text=True, check=True)
    return list(csv.DictReader(io.StringIO(run.stdout)))


def compare(trace):
    """Of each change: name, and percent of the recorded cycles that were predicted and found."""
    for predicted in rows("whatif", trace, "--sensitivity"):
        found = rows("whatif", trace, predicted["change"])[-1]
        yield predicted["change"], float(predicted["difference_percent"]), float(found["difference_percent"])


def line(name, changes):
    errors = sorted(abs(predicted - found) for _, predicted, found in changes)
    moving = [change for change in changes if abs(change[2]) >= 0.1]
    return (f"| {name} | {len(changes)} | {statistics.median(errors):.3f} | {errors[9 * len(errors) // 10]:.2f} "
            f"| {errors[-1]:.2f} | {len(moving)} "
            f"| {statistics.median([abs(predicted - found) for _, predicted, found in moving] or [0]):.2f} |")


def main():
    print("Errors in points of a percent of the recorded cycles; moving: changes that make 0.1 % or more.\n")
    print("| scene, machine | changes | median | 90 % | worst | moving | their median |")
    print("|---|---|---|---|---|---|---|")
    everything = []
    with tempfile.TemporaryDirectory() as folder:
        for scene, machine in FRAMES:
            trace = f"{folder}/{scene}_{machine}.ptrace"
            subprocess.run([PYRASIM, "simulate", SOURCE / "scenes" / f"{scene}.json", "--size", "64x48", "--machine",
                            SOURCE / "machines" / f"{machine}.json", "--trace", trace], stdout=subprocess.DEVNULL, check=True)
            changes = list(compare(trace))
            everything += [(f"{scene}, {machine}: {name}", *figures) for name, *figures in changes]
            print(line(f"{scene}, {machine}", changes), flush=True)
    print(line("all", everything))
    print("\nworst:")
    for name, predicted, found in sorted(everything, key=lambda change: -abs(change[1] - change[2]))[:WORST]:
        print(f"  {name}: predicted {predicted:+.2f} %, found {found:+.2f} %")


main()
