#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Pixel pyramids beside POV-Ray's adaptive anti-aliasing: rays a pixel against the error of the picture.

Prints two Markdown tables: every picture's rays and error, and how many rays POV-Ray needs for the error of each
MAX_LEVEL. tools/antialiasing calls it."""
import argparse
import array
import concurrent.futures
import itertools
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
LEVELS = (1, 2, 3, 4)
THRESHOLDS = ("0.3", "0.1", "0.03", "0.01")
DEPTHS = (2, 3, 4, 5)  # of +R: 1 divides no pixel
CHECK_GRID = 16  # rays along a pixel's side where both programs' references are compared
LARGEST_DIFFERENCE = 1e-4


class Picture:
    """Linear colours, from 0 to 1, and the rays from the observer that it took; shadow rays are not among them."""

    def __init__(self, samples, rays=None):
        self.samples, self.rays = [min(max(value, 0.0), 1.0) for value in samples], rays

    def rmse(self, reference):
        return math.dist(self.samples, reference.samples) / math.sqrt(len(self.samples))


def called(command, **options):
    run = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace",
                         check=False, **options)
    if run.returncode != 0:
        sys.exit(f"antialiasing: {' '.join(map(str, command))}\n{run.stderr.strip()}")
    return run


def without_header(data, pattern):
    return data[re.match(pattern, data).end():]


class Scene:
    """One scene in both programs."""

    def __init__(self, arguments, file, folder):
        self.name, self.file, self.folder = file.stem, file, folder
        self.program, (self.columns, self.rows) = arguments.program, arguments.size
        self.pixels = self.columns * self.rows
        self.pov = folder / f"{self.name}.pov"
        called([self.program, "export", file, "--size", f"{self.columns}x{self.rows}", "-o", self.pov])

    def pyrasim(self, *method, reuse=None):
        """By reuse, as the statistics name it: rays; the picture is the same."""
        picture = self.folder / f"{self.name}{''.join(method)}.pfm"
        run = called([self.program, "render", self.file, "--size", f"{self.columns}x{self.rows}", *method, "-o",
                      picture, "--stats", "-"])
        rows = array.array("f", without_header(picture.read_bytes(), rb"PF\s\d+ \d+\s-1\S*\s"))
        width = 3 * self.columns
        samples = itertools.chain.from_iterable(rows[at : at + width] for at in range(len(rows) - width, -1, -width))
        return Picture(samples, json.loads(run.stdout)["rays_by_reuse"][reuse] if reuse else None)

    def povray(self, *options, enlarged=1):
        """Its own picture: 16 bits, linear (no transfer function), blocks as large as the picture, so that no corner is
        traced twice."""
        columns, rows = self.columns * enlarged, self.rows * enlarged
        stem = f"{self.name}{''.join(options)}x{enlarged}"
        called(["povray", f"+I{self.pov.name}", f"+O{stem}.ppm", f"+W{columns}", f"+H{rows}", "+FP16", "File_Gamma=1.0",
                *options, "-J", "-D", "+WT1", f"+BS{max(columns, rows)}", "-GA", f"+GS{stem}.txt"], cwd=self.folder)
        samples = array.array("H", without_header((self.folder / f"{stem}.ppm").read_bytes(),
                                                  rb"P6\s(?:#[^\n]*\n|\s)*\d+\s+\d+\s+65535\s"))
        (self.folder / f"{stem}.ppm").unlink()
        if sys.byteorder == "little":
            samples.byteswap()
        first, more = map(int, re.search(r"Pixels: +(\d+) +Samples: +(\d+)", (self.folder / f"{stem}.txt").read_text())
                          .groups())
        return Picture(means(samples, self.columns, enlarged, 65535), first + more)

    def adaptive(self, setting):
        threshold, depth = setting
        return self.povray(f"+A{threshold}", "+AM2", f"+R{depth}")

    def difference_of_references(self):
        """Both programs' pictures of the same CHECK_GRID x CHECK_GRID rays a pixel."""
        return self.povray("-A", enlarged=CHECK_GRID).rmse(self.pyrasim("--method", f"grid:{CHECK_GRID}"))


def means(samples, columns, side, one):
    """Of squares of side x side pixels; `one` is the sample that stands for 1."""
    width = 3 * columns * side
    for row in range(0, len(samples), width * side):
        sums = [0] * (3 * columns)
        for line in range(row, row + width * side, width):
            pixels = samples[line : line + width]
            for channel in range(3):
                of_channel = pixels[channel::3]
                parts = [of_channel[k::side] for k in range(side)]
                sums[channel::3] = map(sum, zip(sums[channel::3], *parts))
        yield from (value / (one * side * side) for value in sums)


def rays_for(error, points):
    """The fewest rays by which (rays, error) points get down to an error, on straight lines through the best of them in
    logarithms; and how sure that is: "" or, outside of what the points reach, "<" or ">"."""
    best = []
    for rays, its in sorted(points):
        if not best or its < best[-1][1]:
            best.append((rays, its))
    if error >= best[0][1]:
        return best[0][0], "" if error == best[0][1] else "<"
    for (rays, above), (more, below) in itertools.pairwise(best):
        if below <= error:
            part = math.log(above / error) / math.log(above / below)
            return rays * (more / rays) ** part, ""
    return best[-1][0], ">"


def measured(scene, arguments, pool):
    """Rows (method, rays a pixel, error), and a line of the table of equal errors."""
    reference = scene.pyrasim("--method", f"grid:{arguments.grid}")
    difference = scene.difference_of_references()
    if difference > LARGEST_DIFFERENCE:
        sys.exit(f"antialiasing: {scene.name}: the programs' references are {difference:.1e} apart, more than "
                 f"{LARGEST_DIFFERENCE}")
    settings = list(itertools.product(THRESHOLDS, DEPTHS))
    theirs = list(pool.map(scene.adaptive, settings))
    points = [(picture.rays / scene.pixels, picture.rmse(reference)) for picture in theirs]
    rows = [(f"POV-Ray `+A{threshold} +AM2 +R{depth}`", *point) for (threshold, depth), point in zip(settings, points)]
    ratios = []
    for level in LEVELS:
        picture = scene.pyrasim("--max-level", str(level), reuse="pixel")
        rays, error = picture.rays / scene.pixels, picture.rmse(reference)
        rows.append((f"pyrasim `--max-level {level}`", rays, error))
        needed, sure = rays_for(error, points)
        ratios.append(f"{sure} {needed / rays:.2f}".strip())
    return rows, f"| {scene.name} | {' | '.join(ratios)} | {difference:.0e} |"


def parsed():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path, help="pyrasim")
    parser.add_argument("--scenes", nargs="+", metavar="NAME", help="of the shipped scenes; all by default")
    parser.add_argument("--size", default=(160, 120), type=lambda text: tuple(map(int, text.split("x"))))
    parser.add_argument("--grid", default=64, type=int, help="rays along a pixel's side in the reference")
    arguments = parser.parse_args()
    arguments.program = arguments.program.resolve()
    return arguments


def main():
    arguments = parsed()
    files = [file for file in sorted(SCENES.glob("*.json")) if not arguments.scenes or file.stem in arguments.scenes]
    equal = []
    print("| scene | method | rays a pixel | RMSE |\n|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count() + 2) as pool:
        for file in files:  # POV-Ray sleeps most of a short run: more of them than processors
            rows, ratios = measured(Scene(arguments, file, pathlib.Path(folder)), arguments, pool)
            equal.append(ratios)
            for method, rays, error in rows:
                print(f"| {file.stem} | {method} | {rays:.3f} | {error:.5f} |", flush=True)
    print("\n| POV-Ray's rays / pyrasim's, at the RMSE of | " + " | ".join(f"MAX_LEVEL {level}" for level in LEVELS)
          + " | references apart |\n" + "|---" * (len(LEVELS) + 2) + "|")
    print("\n".join(equal))


if __name__ == "__main__":
    main()
