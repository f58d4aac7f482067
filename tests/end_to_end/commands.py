# SPDX-License-Identifier: Apache-2.0
"""Usage mistakes, and what the small commands print."""

import json
import os
import re
import struct
import zlib

import tool
from tool import LIMIT, OK, SCENES, USAGE

COMMANDS = ("render", "simulate", "sweep", "budget", "study", "compare", "check", "export", "level", "formats",
            "completion", "man")
KEEL = SCENES / "keel.json"


class Commands(tool.EndToEnd):
    def test_help_and_version(self):
        text = self.ok("--help")
        for command in COMMANDS:
            self.assertRegex(text, rf"(?m)^  {command} ")
            self.assertIn("--help", self.ok(command, "--help"))
        self.assertIn("Exit codes: 0 done, 1 a run failed, 2 usage, 3 input, 4 deadlock or limit, "
                      "128 + N ended by signal N.", text)
        self.assertRegex(self.ok("--version"), r"^pyrasim \d+\.\d+\.\d+\S*\n$")

    def test_usage(self):
        self.refused(USAGE, says="command is required")
        self.refused(USAGE, "paint", says="paint: unknown command; pyrasim --help")
        self.refused(USAGE, "--paint", says="--paint: unknown option; pyrasim --help")
        for wrong, meant in (("simulte", "simulate"), ("redner", "render"), ("bugdet", "budget"), ("sweeep", "sweep"),
                             ("formts", "formats")):
            self.refused(USAGE, wrong, KEEL, says=f"{wrong}: unknown command; did you mean {meant}?")
        self.refused(USAGE, "study", "numercs", KEEL, says="numercs: unknown command; did you mean numerics?")
        for wrong, meant in (("--scaler", "--scalar"), ("--sclaar=fp24", "--scalar"), ("--max_level", "--max-level")):
            self.refused(USAGE, "render", KEEL, wrong, "fp24",
                         says=f"{wrong.split('=')[0]}: unknown option; did you mean {meant}?")
        self.refused(USAGE, "x" * 100000, says="unknown command; pyrasim --help")
        for command in COMMANDS:
            self.refused(USAGE, command, "--paint", "x", says="")
            if command not in ("level", "formats", "man"):
                self.refused(USAGE, command, says="is required")
        for command in ("render", "simulate"):
            for option, value, says in (
                    ("--size", "0x0", "columns 0"), ("--size", "640", "COLUMNSxROWS"), ("--size", "8x", "rows"),
                    ("--size", "8x6x4", "6x4"), ("--size", "-8x6", "-8"), ("--size", "65536x1", "65536"),
                    ("--max-level", "x", "--max-level x"), ("--max-level", "-1", "-1"), ("--max-level", "17", "17"),
                    ("--max-level", "2.5", "2.5"), ("--edge", "median", "mean or drop"),
                    ("--edge", "0", "mean or drop"), ("--scalar", "half", "double or float"),
                    ("--scalar", "accumulation=fp24", "intersection=FORMAT is allowed"),
                    ("--scalar", "view_vectors=fp24,", "intersection=FORMAT is allowed"),
                    ("--scalar", "view_vectors=", "(empty)"), ("--scalar", "fix24.12", "multiples of 2^-13 are needed"),
                    ("--scalar", "view_vectors=fp24,view_vectors=fp16", "a second format for view_vectors"),
                    ("--scalar", "intersection=fix24.12", "multiples of 2^-13 are needed"),
                    ("--png-bits", "9", "9"), ("--png-encoding", "cmyk", "cmyk")):
                self.refused(USAGE, command, KEEL, option, value, "-o", "out.png", says=says)
            for window, says in (
                    ("1,2,3", "as in 0,0,64,48"),
                    ("1,2,3,4,5", "as in 0,0,64,48"), ("64x48", "as in 0,0,64,48"), (",0,1,1", "x (empty)"),
                    ("-1,0,1,1", "x -1: a whole number from 0 to 63 is"), ("64,0,1,1", "x 64: a whole number from 0 to 63"),
                    ("0,48,1,1", "y 48: a whole number from 0 to 47"), ("0,0,0,1", "columns 0: a whole number from 1 to 64"),
                    ("60,0,5,1", "columns 5: a whole number from 1 to 4"), ("0,47,1,2", "rows 2: a whole number from 1 to 1"),
                    ("0,0,1,1.5", "rows 1.5"), ("0,0,1,99999999999999999999", "rows 9999"), ("0,0, 1,1", "columns  1")):
                self.refused(USAGE, command, KEEL, "--size", "64x48", "--window", window, "-o", "out.png", says=says)
            self.refused(USAGE, command, KEEL, KEEL, says="keel.json")
            self.refused(USAGE, command, KEEL, "--size", says="--size")

    def test_a_long_value(self):
        """A message repeats 60 characters of it."""
        for arguments in ("{}", "{} x", "check {} {}", "study {}", "level --eye {}", "render SCENE --{}",
                          "render SCENE --threads {}", "render SCENE --edge {}", "render SCENE --method {}",
                          "render SCENE --size {}", "render SCENE --size {}x1", "render SCENE --max-level {}",
                          "render SCENE --window {}", "render SCENE --window {},1,1,1", "render SCENE --scalar {}",
                          "render SCENE --scalar {}={}", "sweep SCENE --edge {}", "sweep SCENE --max-level {}",
                          "sweep SCENE --size {}", "sweep SCENE --reference {}", "study numerics SCENE --formats {}"):
            words = arguments.replace("{}", 999 * "k").replace("SCENE", str(KEEL)).split()
            self.refused(USAGE, *words, says="kkk\u2026")

    def test_empty_value(self):
        """An option whose value is empty, a shell's unset variable for one, is not an option that is not given."""
        scene = self.write("scene.json", tool.scene())
        options = {"render": ("-o", "--stats", "--size", "--window", "--max-level", "--edge", "--scalar", "--method",
                              "--reuse", "--seed", "--threads", "--png-bits", "--png-encoding"),
                   "simulate": ("-o", "--stats", "--trace", "--machine", "--set", "--max-cycles", "--engine"),
                   "sweep": ("--csv", "--size", "--edge", "--max-level", "--reference", "--machine"),
                   "budget": ("--stats", "--machine", "--fps"), "level": ("--eye",), "export": ("-o", "--size")}
        for command, names in options.items():
            for name in names:
                self.refused(USAGE, command, scene, name, "", says="(empty): a value is needed")
                self.refused(USAGE, command, scene, f"{'--output' if name == '-o' else name}=", says="missing")
        for name in ("--csv", "--plot", "--formats", "--machine"):
            self.refused(USAGE, "study", "numerics", scene, name, "", says=f"{name}: (empty): a value is needed")
        self.write("a.pfm", b"PF\n1 1\n-1.0\n" + bytes(12))
        for name in ("-o", "--at", "--crop", "--scale", "--stats"):
            self.refused(USAGE, "compare", "a.pfm", "a.pfm", name, "", says="(empty): a value is needed")
        for command in (["render"], ["simulate"], ["sweep"], ["budget"], ["study", "numerics"], ["level"]):
            self.refused(USAGE, *command, "", says="SCENE: (empty): a value is needed")
        self.refused(USAGE, "check", "", says="FILE: (empty)")
        self.refused(USAGE, "compare", "", "a.pfm", says="FIRST: (empty)")
        self.refused(USAGE, "compare", "a.pfm", "", says="SECOND: (empty)")

    def test_numbers(self):
        """Decimal digits within the limits; nothing wraps, is cut off or read as octal."""
        scene = self.write("scene.json", tool.scene())
        whole = ("-1", "+1", "1.5", "1e3", "0x10", " 1", "1 ", "1_000", "18446744073709551616", "x", "nan", "inf")
        for value in whole:
            self.refused(USAGE, "render", scene, "--seed", value,
                         says=f"--seed: {value}: a whole number from 0 to 18446744073709551615 is allowed")
            self.refused(USAGE, "render", scene, f"--seed={value}", says="--seed")
            for command in (["render"], ["simulate"], ["study", "numerics"]):
                self.refused(USAGE, *command, scene, "--threads", value, says="a whole number from 0 to 1024 is allowed")
            for command in (["simulate"], ["sweep"], ["budget"], ["study", "numerics"]):
                self.refused(USAGE, *command, scene, "--max-cycles", value, says="a whole number from 1 to")
            self.refused(USAGE, "render", scene, "--png-bits", value, says="--png-bits")
            for method in ("grid", "jitter"):
                self.refused(USAGE, "render", scene, "--method", f"{method}:{value}", says="with N from 1 to 256")
        self.refused(USAGE, "render", scene, "--threads", "1025", says="from 0 to 1024")
        self.refused(USAGE, "render", scene, "--threads", "4294967297", says="from 0 to 1024")
        self.refused(USAGE, "simulate", scene, "--max-cycles", "0", says="from 1 to")
        for value in ("nan", "inf", "-1", "0", "1e7", "1e999", "0x10", "x", "1 "):
            self.refused(USAGE, "budget", scene, "--fps", value, says="--fps")
        def picture(seed):
            return self.stats("render", scene, "--method", "jitter:2", "--seed", seed)["image"]
        self.assertEqual(picture("010"), picture("10"))
        self.assertNotEqual(picture("18446744073709551615"), picture("1"))

    def test_grid_of_a_peer(self):
        """Formats are checked against the grid that the method's own rays go through."""
        coarse = ["render", KEEL, "--size", "64x48", "--scalar", "fix32.12"]
        self.ok(*coarse, "--method", "grid:8")
        self.refused(USAGE, *coarse, "--method", "jitter:1", says="multiples of 2^-")

    def test_formats(self):
        """Limits and the usual ones, on a page of their own; the help of --scalar names that page."""
        text = self.ok("formats")
        names = self.formats()
        self.assertEqual(len(names), 35)
        scene = self.write("scene.json", tool.scene())
        limits = ("eEpP, E from 2 to 11 and P from 2 to 25, or fixW.F, W from 2 to 64 and F from 0 to W - 1, is allowed")
        for name in ("half", "e12p8", "e8p26", "e1p8", "e8p1", "fix65.20", "fix16.16", "fix08.4"):
            self.refused(USAGE, "render", scene, "--scalar", name, says=limits)
        for name in ("e6p13", "e11p25", "fix37.21", "fix50.30", "view_vectors=e10p19,intersection=fix33.18"):
            self.assertNotIn(name, names)
            document = self.stats("render", scene, "--size", "16x12", "--scalar", name)
            self.assertEqual(document["scalar"], name)
            self.assertGreater(document["arithmetic"]["intersection"]["inexact"], 0)
        for row in (r"fp16 +16 +5 +11 +2\^16 +2\^-10 +2\^-24 +also e5p11; IEEE 754 binary16",
                    r"double +64 +11 +53 +2\^1024 +2\^-52 +2\^-1074 .*", r"fix32\.12 +32 +19 +12 +2\^19 +2\^-12"):
            self.assertRegex(text, rf"(?m)^{row}$")
        for command in ("render", "simulate", "budget"):
            help_text = self.ok(command, "--help")
            self.assertIn("pyrasim formats", help_text)
            self.assertNotIn("e8p12", help_text)

    def test_picture_larger_than_memory(self):
        size = 65535
        if 24 * size * size <= os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"):
            self.skipTest("this machine holds the largest picture")
        for command in ("render", "simulate", "budget"):
            output = ["--stats", "out.json"] if command == "budget" else ["-o", "out.png"]
            self.refused(LIMIT, command, KEEL, "--size", f"{size}x{size}", *output,
                         says="a picture of 65535x65535 pixels takes 96.0 GiB of memory")
        for command in ("render", "simulate"):
            self.ok(command, KEEL, "--size", f"{size}x{size}", "--window", "65527,65527,8,8", "--max-level", 16)

    def test_usage_of_one_command(self):
        for method in ("paint", "grid", "grid:", "grid:0", "grid:257", "grid:2x", "jitter:-1", "point:2"):
            self.refused(USAGE, "render", KEEL, "--method", method, says="jitter:N with N from 1 to 256")
            self.refused(USAGE, "sweep", KEEL, "--reference", method, says="jitter:N with N from 1 to 256")
        for option, value in (("--reuse", "all"), ("--threads", "-1"), ("--threads", "x"), ("--seed", "x")):
            self.refused(USAGE, "render", KEEL, option, value, says=option)
        self.refused(USAGE, "simulate", KEEL, "--engine", "fast", says="decoupled or lockstep")
        for assignment, says in (
                ("clock=1", "/clock: unknown key"),
                ("intersection.units=four", '/intersection/units: it is the string'),
                ("intersection.units=0", "/intersection/units: 0 is out of range"), ("intersection.units", '"="'),
                ("=1", "key is empty"), ("intersection..units=1", "key is empty"), ("fifos.all=[", "--set fifos.all=["),
                ("clock_mhz=NaN", "clock_mhz"), ("clock_mhz=1e999", "too large"), ("clock_mhz=", "value is missing"),
                ("name.x=1", "/name"), ("intersection=4", "/intersection: it is the number 4")):
            self.refused(USAGE, "simulate", KEEL, "--set", assignment, "-o", "out.png", says=says)
        for then, now in (("--leaf=drop", "--leaf: has another name now, --edge;"),
                          ("--set=intersection.reorder_buffer=8",
                           "/intersection/reorder_buffer: has another name now; issue_order_queue is allowed"),
                          ("--set=pyramid_classifier.corner_row=9",
                           "/pyramid_classifier/corner_row: has another name now; line_buffer is allowed"),
                          ("--set=fifos.pyramid_classifier_to_tree_accumulator=9",
                           "/fifos/pyramid_classifier_to_tree_accumulator: the colour unit stands between the two now; "
                           "pyramid_classifier_to_color_unit and color_unit_to_tree_accumulator are allowed")):
            self.refused(USAGE, "simulate", KEEL, then, says=now)
        for option, value in (("--max-level", "3:1"), ("--max-level", "0:17"), ("--max-level", "1,,2"), ("--edge", "x"),
                              ("--edge", "mean,"), ("--size", "8x6,"), ("--size", "0x1")):
            self.refused(USAGE, "sweep", KEEL, option, value, "--csv", "out.csv", says=option)

    def test_set(self):
        """The last word on a setting is that of the last --set, over the machine file's."""
        machine = ["--machine", tool.MACHINES / "small.json"]
        simulate = ["simulate", KEEL, "--size", "16x12"]
        def units(*options):
            return sum("intersection_unit" in unit["name"] for unit in self.stats(*simulate, *options)["units"])
        self.assertEqual(units(), 4)
        self.assertEqual(units(*machine), 1)
        self.assertEqual(units(*machine, "--set", "intersection.units=3"), 3)
        self.assertEqual(units("--set", "intersection.units=3", "--set", "intersection.units=2"), 2)
        cost = {kind: 2 for kind in ("ray", "box_test", "sphere", "plane", "triangle")}
        options = [word for kind in cost for word in ("--set", f"intersection.cost.{kind}=2")]
        by_hand = self.stats(*simulate, *options)
        document = tool.read_json(tool.MACHINES / "default.json")
        document["intersection"]["cost"] = cost
        from_file = self.stats(*simulate, "--machine", self.write("default.json", document))
        self.assertEqual({**from_file, "command": ""}, {**by_hand, "command": ""})

    def test_level(self):
        text = self.ok("level")
        self.assertEqual(text.splitlines()[-1], "MAX_LEVEL = 3")
        self.assertEqual(len(re.findall(r"visible$", text, re.M)), 3)
        for options, level in (
                (["--pixel-size", "0.25", "--distance", "600"], 2), (["--pixel-size", "1e-6", "--distance", "1"], 0),
                (["--eye", "0.0009765625"], 0), (["--eye", "0.00048828125"], 1), (["--eye", "1e-12"], 30)):
            self.assertRegex(self.ok("level", *options), rf"\nMAX_LEVEL = {level}(, above the limit of 16)?\n$")
        self.assertIn("above the limit of 16", self.ok("level", "--eye", "1e-12"))
        chosen = int(self.ok("level", KEEL).split()[-1])
        self.assertEqual(self.stats("render", KEEL, "--max-level", "auto", "--size", "640x480")["max_level"], chosen)
        self.refused(USAGE, "level", "--pixel-size", "1", says="--distance")
        self.refused(USAGE, "level", KEEL, "--pixel-size", "1", "--distance", "1", says="either")
        for bad in ("0", "-1", "nan", "inf", "1e31", "x", "1x"):
            self.refused(USAGE, "level", "--pixel-size", bad, "--distance", "1", says="--pixel-size")
            self.refused(USAGE, "level", "--eye", bad, says="--eye")

    def test_check(self):
        self.assertIn("a scene of 7 objects on 640x480 pixels", self.ok("check", KEEL))
        self.assertIn("machine wide with 16 intersection units at 200 MHz",
                      self.ok("check", tool.MACHINES / "wide.json"))

    def test_like_units_are_one_line_of_the_table(self):
        for units in (1, 2, 16):
            simulate = ["simulate", KEEL, "--size", "64x48", "--set", f"intersection.units={units}"]
            table, document = self.ok(*simulate), self.stats(*simulate)
            lines = [line for line in table.splitlines() if line.startswith("intersection_unit")]
            self.assertEqual(len(lines), 1, table)
            alike = [unit for unit in document["units"] if unit["name"].startswith("intersection_unit_")]
            self.assertEqual(len(alike), units)
            name = "intersection_unit_0" if units == 1 else f"intersection_units 0-{units - 1}"
            shares = []
            for part in ("busy", "starved", "blocked", "idle"):
                percent = sorted(100 * unit[part] / document["machine"]["cycles"] for unit in alike)
                least, most = f"{percent[0]:.1f}", f"{percent[-1]:.1f}"
                shares.append(f"{most} %" if least == most else f"{least}-{most} %")
            self.assertEqual(re.split(r" {2,}", lines[0]), [name, *shares])

    def test_the_table_names_the_slowest_pixels(self):
        simulate = ["simulate", KEEL, "--size", "64x48", "--window", "20,10,40,30"]
        table, document = self.ok(*simulate), self.stats(*simulate)
        found = re.findall(r"(?m)^(?:slowest)? +([\d,]+)   cycles at row (\d+), column (\d+); level (\d+)$", table)
        self.assertEqual([[int(number.replace(",", "")) for number in line] for line in found],
                         [[pixel[key] for key in ("cycles", "row", "column", "level")]
                          for pixel in document["pixel_latency"]["slowest"]])
        self.assertEqual(len(found), 5)
        for _, row, column, _ in found:
            self.assertTrue(10 <= int(row) < 40 and 20 <= int(column) < 60)

    def test_compare(self):
        self.ok("render", KEEL, "--size", "100x80", "--max-level", "0", "-o", "a.pfm")
        self.ok("render", KEEL, "--size", "100x80", "--max-level", "4", "-o", "b.pfm")
        self.assertEqual(self.ok("compare", "a.pfm", "a.pfm"), "RMSE 0, maximum 0, PSNR inf dB\n")
        line = self.ok("compare", "a.pfm", "b.pfm", "-o", "view.pfm", "--crop", "10x8", "--scale", "3")
        rmse, maximum, decibel = map(float, re.fullmatch(r"RMSE (\S+), maximum (\S+), PSNR (\S+) dB\n", line).groups())
        self.assertTrue(0 < rmse < maximum <= 1 and decibel > 0, line)
        self.assertEqual(self.ok("compare", "b.pfm", "a.pfm"), line)
        columns, rows, _ = tool.read_pfm(self.folder / "view.pfm")
        self.assertTrue(columns >= 60 and rows >= 24, (columns, rows))
        for option, value, says in (("--crop", "0x1", "--crop: columns 0"), ("--crop", "10", "--crop 10: COLUMNSxROWS"),
                                    ("--crop", "10x", "--crop: rows (empty)"), ("--at", "1", "--at"),
                                    ("--at", "95,0", "--at: column 95"), ("--scale", "0", "--scale"),
                                    ("--scale", "65", "--scale"), ("--scale", "-1", "--scale")):
            self.refused(USAGE, "compare", "a.pfm", "b.pfm", "--crop", "10x8", option, value, says=says)
        document = json.loads(self.run_tool("compare", "a.pfm", "b.pfm", "--stats", "-").stdout)
        self.assertAlmostEqual(document["rmse"], rmse, 6)
        self.ok("compare", "a.pfm", "a.pfm", "--stats", "same.json")
        self.assertIsNone(tool.read_json(self.folder / "same.json")["psnr_db"])

    def test_compare_transparent(self):
        """Alpha is composed over black, and the output says so."""
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        def png(color_type, row):
            header = struct.pack(">IIBBBBB", 2, 1, 8, color_type, 0, 0, 0)
            return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"\0" + row))
                    + chunk(b"IEND", b""))
        self.write("clear.png", png(6, bytes((255, 255, 255, 0, 255, 0, 0, 255))))
        self.write("opaque.png", png(2, bytes((255, 255, 255, 255, 0, 0))))
        self.write("black.png", png(2, bytes((0, 0, 0, 255, 0, 0))))
        remark = "clear.png: 1 pixel is not opaque; composed over black\n"
        self.assertEqual(self.ok("compare", "clear.png", "black.png"), remark + "RMSE 0, maximum 0, PSNR inf dB\n")
        self.assertTrue(self.ok("compare", "opaque.png", "clear.png").startswith(remark + "RMSE 0.707107, maximum 1,"))
        self.assertTrue(self.ok("compare", "opaque.png", "black.png").startswith("RMSE 0.707107"))
        self.assertIn("composed over black", self.ok("compare", "--help"))


tool.main()
