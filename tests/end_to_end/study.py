# SPDX-License-Identifier: Apache-2.0
"""pyrasim study numerics: its rows are what render and simulate give for each format, compared by other means."""

import csv
import io
import math
import os
import re
import struct
import xml.etree.ElementTree

import tool
from tool import LIMIT, SCENES, USAGE

TOO_LARGE = 24 * 65535**2 > os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
FRAME = [SCENES / "spheres.json", "--size", "40x30", "--max-level", "2"]


def eight_bit(sample):
    """A linear sample as 8 bits of sRGB."""
    clamped = min(max(sample, 0.0), 1.0)
    signal = 12.92 * clamped if clamped <= 0.0031308 else 1.055 * clamped ** (1 / 2.4) - 0.055
    return math.floor(signal * 255 + 0.5)


class Study(tool.EndToEnd):
    def pixels(self, scalar):
        self.ok("render", *FRAME, "--scalar", scalar, "-o", "frame.pfm", warnings=int(scalar in ("fp16", "bf16")))
        _, _, rows = tool.read_pfm(self.folder / "frame.pfm")
        samples = [sample for row in rows for (sample,) in struct.iter_unpack("<f", row)]
        return [tuple(map(eight_bit, samples[k : k + 3])) for k in range(0, len(samples), 3)]

    def test_rows_are_those_of_render_and_simulate(self):
        table = self.ok("study", "numerics", *FRAME, "--formats", "bf16,fp16,fp24,fix32.20,fix24.12,e7p13",
                        "--csv", "rows.csv", "--plot", "plot.svg")
        rows = list(csv.DictReader(io.StringIO((self.folder / "rows.csv").read_text())))
        self.assertEqual([row["format"] for row in rows], ["double", "bf16", "fp16", "fp24", "fix32.20", "fix24.12", "e7p13"])
        exact = self.pixels("double")
        for row in rows:
            with self.subTest(format=row["format"]):
                document = self.stats("simulate", *FRAME, "--scalar", row["format"])
                self.assertEqual(int(row["rays"]), document["rays"]["total"])
                self.assertEqual(int(row["cycles"]), document["machine"]["cycles"])
                changed = sum(a != b for a, b in zip(self.pixels(row["format"]), exact))
                self.assertEqual(int(row["changed_pixels"]), changed)
                if row["format"] == "double":
                    self.assertEqual(row["saturations"], "")
                else:
                    events = document["arithmetic"].values()
                    for name in ("saturations", "underflows", "inexact", "divisions_by_zero", "invalid"):
                        self.assertEqual(int(row[name]), sum(stage[name] for stage in events), name)
        self.assertGreater(int(rows[1]["changed_pixels"]), int(rows[3]["changed_pixels"]))
        self.assertGreater(int(rows[1]["flipped"]), int(rows[3]["flipped"]))
        self.assertRegex(table, r"(?m)^ +bf16 +16 +e8 p8 +\d")
        root = xml.etree.ElementTree.parse(self.folder / "plot.svg").getroot()
        self.assertEqual(len([e for e in root if e.tag.endswith("circle")]), 12)

    def test_all_formats_without_a_list(self):
        table = self.ok("study", "numerics", SCENES / "fins.json", "--size", "64x48", "--max-level", "1")
        for name in self.formats():
            self.assertRegex(table, rf"(?m)^ +{re.escape(name)} +\d")
        self.assertIn("the smallest format that leaves", table)

    def test_a_screen_too_fine_for_a_format(self):
        table = self.ok("study", "numerics", SCENES / "fins.json", "--formats", "fix24.12", "--max-level", "5")
        self.assertRegex(table, r"(?m)^ +fix24\.12 +24 i11 f12 cannot address the screen$")
        self.assertIn("fixed point: none of these", table)

    def test_usage(self):
        self.refused(USAGE, "study", says="numerics")
        self.refused(USAGE, "study", "colours", says="colours")
        if TOO_LARGE:
            self.refused(LIMIT, "study", "numerics", SCENES / "fins.json", "--size", "65535x65535", "--max-level", "0",
                     says="a picture of 65535x65535 pixels takes 96.0 GiB")
        self.refused(USAGE, "study", "numerics", says="is required")
        self.refused(USAGE, "study", "numerics", *FRAME, "--formats", "fp24,half", says="half")

    def test_a_failure_keeps_the_rows_that_are_done(self):
        """fix24.12 takes longer than the formats before it."""
        arguments = ["study", "numerics", *FRAME, "--formats", "fp24,fix24.12,fp16"]
        whole = self.run_tool(*arguments, "--csv", "-").stdout
        rows = list(csv.DictReader(io.StringIO(whole)))
        limit = int(rows[2]["cycles"]) - 1
        self.assertGreater(limit, max(int(row["cycles"]) for row in rows[:2]))
        run = self.run_tool(*arguments, "--csv", "out.csv", "--plot", "out.svg", "--max-cycles", limit)
        self.assertEqual(run.returncode, LIMIT)
        self.assertRegex(run.stderr, r"\Apyrasim: fix24\.12 \(2 of 4 rows done\): the frame is not finished within ")
        self.assertEqual(len(run.stdout.splitlines()), 1 + 2)
        self.assertEqual((self.folder / "out.csv").read_text().splitlines(), whole.splitlines()[:3])
        self.assertEqual([file.name for file in self.folder.iterdir()], ["out.csv"])


tool.main()
