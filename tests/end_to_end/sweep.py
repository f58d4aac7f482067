# SPDX-License-Identifier: Apache-2.0
"""The sweep's table: its columns, its rows, and the same numbers as single runs."""

import csv
import io

import tool
from tool import SCENES

COLUMNS = ["columns", "rows", "max_level", "leaf", "rays_primary", "rays_subdivision", "rays_total", "subdivisions",
           "rmse", "max_error", "cycles", "frames_per_second", "reference", "reference_rays"]
KEEL = SCENES / "keel.json"


class Sweep(tool.EndToEnd):
    def table(self, *arguments):
        run = self.run_tool("sweep", KEEL, *arguments, "--csv", "-")
        self.assertEqual(run.returncode, tool.OK, run.stderr)
        reader = csv.DictReader(io.StringIO(run.stdout, newline=""), strict=True)
        rows = list(reader)
        self.assertEqual(reader.fieldnames, COLUMNS)
        self.assertEqual(len(run.stderr.splitlines()), len(rows) + 2)  # for people: header, rows, reference
        return rows

    def test_all_combinations(self):
        rows = self.table("--max-level", "1,3", "--size", "32x24,48x36", "--leaf", "mean,drop", "--reference", "grid:4")
        points = [(int(row["columns"]), int(row["rows"]), row["leaf"], int(row["max_level"])) for row in rows]
        self.assertEqual(points, [(columns, lines, leaf, level) for columns, lines in ((32, 24), (48, 36))
                                  for leaf in ("mean", "drop") for level in (1, 3)])
        for row in rows:
            self.assertEqual(row["reference"], "grid:4")
            self.assertEqual(int(row["reference_rays"]), 16 * int(row["columns"]) * int(row["rows"]))
            single = self.stats("simulate", KEEL, "--size", f"{row['columns']}x{row['rows']}", "--leaf", row["leaf"],
                                "--max-level", row["max_level"])
            for key in ("primary", "subdivision", "total"):
                self.assertEqual(int(row[f"rays_{key}"]), single["rays"][key])
            self.assertEqual(int(row["subdivisions"]), single["subdivisions"])
            self.assertEqual(int(row["cycles"]), single["machine"]["cycles"])
            self.assertAlmostEqual(float(row["frames_per_second"]) / single["machine"]["frames_per_second"], 1, 7)

    def test_errors_are_those_of_compare(self):
        row, = self.table("--max-level", "2", "--size", "32x24", "--reference", "grid:4")
        self.ok("simulate", KEEL, "--max-level", "2", "--size", "32x24", "-o", "a.pfm")
        self.ok("render", KEEL, "--method", "grid:4", "--size", "32x24", "-o", "b.pfm")
        words = self.ok("compare", "a.pfm", "b.pfm", "--crop", "8x6").replace(",", "").split()
        self.assertAlmostEqual(float(row["rmse"]) / float(words[1]), 1, 4)
        self.assertAlmostEqual(float(row["max_error"]) / float(words[3]), 1, 4)

    def test_error_falls_with_the_level(self):
        rows = self.table("--max-level", "0:5", "--size", "120x90", "--reference", "grid:16")
        errors = [float(row["rmse"]) for row in rows]
        self.assertEqual(len(errors), 6)
        for level in range(3):
            self.assertLess(errors[level + 1], errors[level])
        self.assertLess(errors[5], errors[0] / 4)
        rays = [int(row["rays_total"]) for row in rows]
        self.assertEqual(rays, sorted(set(rays)))

    def test_file(self):
        arguments = ["--max-level", "0:1", "--size", "16x12", "--reference", "point"]
        text = self.ok("sweep", KEEL, *arguments, "--csv", "out.csv")
        self.assertIn("RMSE", text)
        self.assertEqual((self.folder / "out.csv").read_text(), self.run_tool("sweep", KEEL, *arguments, "--csv",
                                                                              "-").stdout)


tool.main()
