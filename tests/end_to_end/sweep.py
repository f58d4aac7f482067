# SPDX-License-Identifier: Apache-2.0
"""The sweep's table: its columns, its rows, and the same numbers as single runs."""

import csv
import io
import json
import os
import resource
import signal
import subprocess

import tool
from tool import SCENES

COLUMNS = ["pyrasim", "scene", "scene_sha256", "machine", "settings_sha256", "set", "columns", "rows", "max_level", "edge",
           "reference", "rays_primary", "rays_subdivision", "rays_total", "subdivisions", "rmse", "max_error", "cycles",
           "frames_per_second", "reference_rays"]
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
        rows = self.table("--max-level", "1,3", "--size", "32x24,48x36", "--edge", "mean,drop", "--reference", "grid:4")
        points = [(int(row["columns"]), int(row["rows"]), row["edge"], int(row["max_level"])) for row in rows]
        self.assertEqual(points, [(columns, lines, edge, level) for columns, lines in ((32, 24), (48, 36))
                                  for edge in ("mean", "drop") for level in (1, 3)])
        for row in rows:
            self.assertEqual(row["reference"], "grid:4")
            self.assertEqual(int(row["reference_rays"]), 16 * int(row["columns"]) * int(row["rows"]))
            single = self.stats("simulate", KEEL, "--size", f"{row['columns']}x{row['rows']}", "--edge", row["edge"],
                                "--max-level", row["max_level"])
            for key in ("primary", "subdivision", "total"):
                self.assertEqual(int(row[f"rays_{key}"]), single["rays"][key])
            self.assertEqual(int(row["subdivisions"]), single["subdivisions"])
            self.assertEqual(int(row["cycles"]), single["machine"]["cycles"])
            self.assertAlmostEqual(float(row["frames_per_second"]) / single["machine"]["frames_per_second"], 1, 7)

    def test_scenes_and_settings(self):
        """Each scene on each machine, those of several values in each combination; and each row says which it was."""
        arguments = ["sweep", KEEL, SCENES / "fins.json", "--size", "16x12", "--max-level", "1", "--reference", "none",
                     "--set", "intersection.units=1,3", "--set", "clock_mhz=50", "--set", "fifos.all=2,8"]
        rows = list(csv.DictReader(io.StringIO(self.run_tool(*arguments, "--csv", "-").stdout)))
        asked = [(row["scene"], row["set"]) for row in rows]
        self.assertEqual(asked, [(str(scene), f"intersection.units={units} clock_mhz=50 fifos.all={depth}")
                                 for scene in (KEEL, SCENES / "fins.json") for units in (1, 3) for depth in (2, 8)])
        self.assertEqual(len({row["settings_sha256"] for row in rows}), 4)
        self.assertEqual(len({row["scene_sha256"] for row in rows}), 2)
        for row in rows:
            sets = [word for setting in row["set"].split() for word in ("--set", setting)]
            machine = self.stats("simulate", row["scene"], "--size", "16x12", "--max-level", "1", *sets)["machine"]
            self.assertEqual((int(row["cycles"]), row["settings_sha256"], row["machine"]),
                             (machine["cycles"], machine["settings_sha256"], machine["name"]))
            self.assertEqual((row["rmse"], row["max_error"], row["reference_rays"]), ("", "", ""))
        header, *lines = self.ok(*arguments).splitlines()
        for name in ("scene", "intersection.units", "fifos.all"):
            self.assertIn(f" {name} ", f" {header}")
        self.assertNotIn("clock_mhz", header)
        self.assertRegex(lines[3], r"keel\.json +16x12 +1 mean +3 +8 ")
        run = self.run_tool(*arguments, "--max-cycles", "10")
        self.assertIn("keel.json, 16x12 pixels, MAX_LEVEL 1, edge mean, intersection.units 1, fifos.all 2 (0 of 8", run.stderr)

    def test_columns_are_as_wide_as_what_they_show(self):
        """In characters, one of which may be several bytes."""
        name = "Würfel ×××.json"
        self.write(name, tool.scene())
        lines = self.ok("sweep", name, self.write("b.json", tool.scene()).name, "--max-level", "0", "--reference", "none").splitlines()
        for line, scene, size in zip(lines, ("scene", name, "b.json"), ("size", "8x6", "8x6"), strict=True):
            self.assertEqual(line[:len(name) + 12], f"{scene:<{len(name)}} {size:>11}")

    def test_resume(self):
        """What a file holds is kept and not made again, whatever ended the run that made it; all the same in the end."""
        scene = self.write("scene.json", tool.scene())
        arguments = ["sweep", "scene.json", "--max-level", "0:3", "--reference", "point", "--set", "intersection.units=1,2"]
        self.ok(*arguments, "--csv", "whole.csv")
        whole = (self.folder / "whole.csv").read_text()
        lines = whole.splitlines(keepends=True)
        for kept, rest in ((lines[:1], ""), (lines[:4], ""), (lines[:4], lines[4][:30]), (lines[:1] + lines[5:7], "")):
            self.write("some.csv", "".join(kept) + rest)
            text = self.ok(*arguments, "--resume", "some.csv")
            self.assertIn(f"\n{len(kept) - 1} of 8 rows were in some.csv\n", text)
            self.assertEqual(len(text.splitlines()), 1 + (9 - len(kept)) + 2)
            result = (self.folder / "some.csv").read_text()
            self.assertTrue(result.startswith("".join(kept)))
            self.assertEqual(sorted(result.splitlines()), sorted(whole.splitlines()))
        self.assertIn("8 of 8 rows were in some.csv", self.ok(*arguments, "--resume", "some.csv"))
        self.assertEqual((self.folder / "some.csv").read_text(), result)
        self.ok(*arguments, "--resume", "new.csv")
        self.assertEqual((self.folder / "new.csv").read_text(), whole)
        # Another scene of the same name is another run.
        self.write("scene.json", tool.scene(columns=9))
        self.assertIn("0 of 8 rows were in new.csv", self.ok(*arguments, "--resume", "new.csv"))
        self.assertEqual(len((self.folder / "new.csv").read_text().splitlines()), 1 + 8 + 8)
        for other in ("a,b\n1,2\n", "a,b", "\0", lines[0][:-1] + ",more"):
            self.write("other.csv", other)
            self.refused(tool.INPUT, *arguments, "--resume", "other.csv",
                         says="other.csv:1: it is not a table of this version's")
            self.assertEqual((self.folder / "other.csv").read_text(), other)
        self.write("some.csv", lines[0][:20])
        self.ok(*arguments, "--resume", "some.csv")
        self.refused(tool.USAGE, *arguments, "--resume", "scene.json", says="--resume")
        self.refused(tool.USAGE, *arguments, "--resume", "a.csv", "--csv", "b.csv", says="either --csv, or --resume")
        self.assertTrue(scene.exists())

    def test_resume_by_names_of_any_kind(self):
        """One row is one line, by which it is known again."""
        self.write("a,\nb\".json", tool.scene())
        arguments = ["sweep", "a,\nb\".json", "--max-level", "0:1", "--reference", "none", "--set", "name=x\n\"y"]
        self.ok(*arguments, "--resume", "rows.csv")
        text = (self.folder / "rows.csv").read_text()
        self.assertEqual(len(text.splitlines()), 3)
        row, _ = csv.DictReader(io.StringIO(text))
        self.assertEqual([row[name] for name in ("scene", "machine", "set")],
                         ["a,\\u000ab\".json", "x\\u000a\"y", "name=x\\u000a\"y"])
        self.assertIn("2 of 2 rows were in rows.csv", self.ok(*arguments, "--resume", "rows.csv"))
        self.assertEqual((self.folder / "rows.csv").read_text(), text)

    def test_resume_with_a_scene_that_can_be_read_once(self):
        """Nobody knows whether it is the one of before."""
        for columns in (8, 9):
            document = json.dumps(tool.scene(columns=columns, rows=6))
            run = subprocess.run([tool.PYRASIM, "sweep", "/dev/stdin", "--size", "8x6", "--max-level", "0",
                                  "--reference", "none", "--resume", "rows.csv"], input=document, cwd=self.folder,
                                 capture_output=True, text=True, check=False)
            self.assertIn("0 of 1 row were in rows.csv", run.stdout, run.stderr)

    def test_values_of_a_setting_are_json(self):
        """A comma inside one separates nothing."""
        arguments = ["sweep", KEEL, "--size", "16x12", "--max-level", "1", "--reference", "none", "--csv", "-"]
        for setting, values in (('intersection={"units":2,"latency":9}', ['{"units":2,"latency":9}']),
                                ('intersection={"units":2,"latency":9},{"units":3}',
                                 ['{"units":2,"latency":9}', '{"units":3}']),
                                ('name="a,b"', ['"a,b"']), ('name="a\\",b","c"', ['"a\\",b"', '"c"']),
                                ('name=a"b,c"d', ['a"b', 'c"d'])):
            rows = csv.DictReader(io.StringIO(self.run_tool(*arguments, "--set", setting).stdout))
            path = setting.split("=")[0]
            self.assertEqual([row["set"] for row in rows], [f"{path}={value}" for value in values])

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

    def test_a_failure_keeps_the_rows_that_are_done(self):
        """The point is named, and how far the sweep came; the CSV file and stdout have the rows before it."""
        arguments = ["sweep", KEEL, "--max-level", "0,1,3,2", "--size", "32x24", "--reference", "point"]
        whole = self.run_tool(*arguments, "--csv", "-").stdout
        cycles = sorted(int(row["cycles"]) for row in csv.DictReader(io.StringIO(whole)))
        limit = ["--max-cycles", cycles[-1] - 1]  # MAX_LEVEL 3 takes longest
        says = r"\Apyrasim: 32x24 pixels, MAX_LEVEL 3, edge mean \(2 of 4 rows done\): the frame is not finished within "
        self.write("out.csv", "old")
        for name in ("new.csv", "out.csv"):
            run = self.run_tool(*arguments, *limit, "--csv", name)
            self.assertEqual(run.returncode, tool.LIMIT)
            self.assertRegex(run.stderr, says)
            self.assertEqual(len(run.stdout.splitlines()), 1 + 2)
            self.assertEqual((self.folder / name).read_text().splitlines(), whole.splitlines()[:3])
        run = self.run_tool(*arguments, *limit, "--csv", "-")
        self.assertEqual((run.returncode, run.stdout.splitlines()), (tool.LIMIT, whole.splitlines()[:3]))

    def test_what_can_be_known_before_is_refused_before(self):
        """Of the last point too; the old file stays."""
        self.write("out.csv", "old")
        sweep = ["sweep", KEEL, "--reference", "point", "--csv", "out.csv"]
        self.refused(tool.INPUT, *sweep, "--max-level", "0:4", "--set", "subdivision_controller.pool=9",
                     says="/subdivision_controller/pool: 9 cannot hold one pixel's tree at MAX_LEVEL 4")
        self.refused(tool.INPUT, *sweep, "--max-level", "0", "--size", "8x6,64x48", "--set",
                     "pyramid_classifier.line_buffer=10", says="/pyramid_classifier/line_buffer: 10 cannot hold")
        size = 65535
        if 24 * size * size > os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"):
            self.refused(tool.LIMIT, *sweep, "--max-level", "0", "--size", f"8x6,{size}x{size}",
                         says=f"a picture of {size}x{size} pixels takes 96.0 GiB of memory")
        self.assertEqual((self.folder / "out.csv").read_text(), "old")

    def test_a_file_that_cannot_grow_holds_whole_rows(self):
        """The limit on a file's size, as a full disk: the row that does not fit is not begun."""
        arguments = ["sweep", str(KEEL), "--max-level", "0:5", "--size", "16x12", "--reference", "point", "--csv"]
        whole = self.run_tool(*arguments, "-").stdout
        rows = whole.splitlines(keepends=True)
        limit = len("".join(rows[:4])) + 5  # bytes: in the fourth row of numbers

        def limited():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        run = subprocess.run([tool.PYRASIM, *arguments, "out.csv"], preexec_fn=limited, cwd=self.folder, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        self.assertEqual(run.returncode, tool.RUN_FAILED, run.stderr)
        self.assertRegex(run.stderr, r"\Apyrasim: 16x12 pixels, MAX_LEVEL 3, edge mean \(3 of 6 rows done\): "
                                     r"out\.csv: cannot write: File too large\n\Z")
        self.assertEqual((self.folder / "out.csv").read_text(), "".join(rows[:4]))


tool.main()
