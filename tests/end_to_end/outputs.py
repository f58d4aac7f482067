# SPDX-License-Identifier: Apache-2.0
"""Where output goes: files that cannot be written, a full stdout, and what a success leaves."""

import os
import subprocess

import tool
from tool import OK, RUN_FAILED, USAGE


class Outputs(tool.EndToEnd):
    def setUp(self):
        super().setUp()
        self.scene = self.write("scene.json", tool.scene())
        (self.folder / "folder.png").mkdir()

    def test_cannot_write(self):
        for target in ("missing/out.png", "folder.png"):
            for command in ("render", "simulate"):
                self.refused(RUN_FAILED, command, self.scene, "-o", target, says=f"{target}: cannot write")
                self.refused(RUN_FAILED, command, self.scene, "--stats", target, says=f"{target}: cannot write")
                self.refused(RUN_FAILED, command, self.scene, "-o", target, "--stats", target, says=target)
                self.refused(RUN_FAILED, command, self.scene, "-o", "good.png", "--stats", target, says=target)
                self.refused(RUN_FAILED, command, self.scene, "-o", target, "--stats", "good.json", says=target)
            self.refused(RUN_FAILED, "simulate", self.scene, "--trace", target, "-o", "good.png", says=target)
            self.refused(RUN_FAILED, "sweep", self.scene, "--csv", target, says=target)
        self.refused(RUN_FAILED, "render", self.scene, "--stats", "/dev/full", "-o", "/dev/null/out.png")
        for ending in ("bmp", "PNG", "json", ""):
            self.refused(USAGE, "render", self.scene, "-o", f"out.{ending}", says="its name must end in .png or .pfm")

    def test_read_only_folder(self):
        if os.geteuid() == 0:
            self.skipTest("root writes everywhere")
        folder = self.folder / "read_only"
        folder.mkdir(mode=0o555)
        self.refused(RUN_FAILED, "render", self.scene, "-o", folder / "out.png", says="cannot write")

    def test_full(self):
        self.ok("render", self.scene, "-o", "out.pfm")
        with open("/dev/full", "wb") as full:
            for arguments in (["render", self.scene, "--stats", "-"], ["simulate", self.scene, "--stats", "-"],
                              ["simulate", self.scene, "--trace", "-"], ["simulate", self.scene],
                              ["sweep", self.scene, "--max-level", "1", "--reference", "point"],
                              ["sweep", self.scene, "--max-level", "1", "--reference", "point", "--csv", "-"],
                              ["check", self.scene], ["level"], ["compare", "out.pfm", "out.pfm", "--crop", "4x4"],
                              ["--help"], ["--version"]):
                run = self.run_tool(*arguments, stdout=full)
                self.assertEqual(run.returncode, RUN_FAILED, arguments)
                self.assertTrue(run.stderr.endswith("stdout: cannot write\n"), run.stderr)
        self.refused(RUN_FAILED, "render", self.scene, "--stats", "/dev/full", says="/dev/full: cannot write")

    def test_closed_pipe(self):
        """A reader that leaves early ends the run without a word."""
        with subprocess.Popen([tool.PYRASIM, "simulate", self.scene, "--trace", "-"], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            process.stdout.close()
            self.assertNotEqual(process.wait(timeout=60), OK)
            self.assertLessEqual(len(process.stderr.read().splitlines()), 1)

    def test_success(self):
        self.write("old.png", "an old file")
        before = set(self.listing())
        self.assertEqual(self.ok("render", self.scene, "-o", "old.png", "--stats", "new.json"), "")
        self.assertEqual(set(self.listing()) - before, {str(self.folder / "new.json")})
        self.assertTrue((self.folder / "old.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n"))
        table = self.ok("simulate", self.scene, "-o", "new.pfm", "--stats", "new.json", "--trace", "new.vcd")
        self.assertIn("cycles", table)
        self.assertEqual(set(self.listing()) - before,
                         {str(self.folder / name) for name in ("new.json", "new.pfm", "new.vcd")})
        first = (self.folder / "old.png").read_bytes()
        self.ok("render", self.scene, "-o", "old.png", "--stats", "new.json")
        self.assertEqual((self.folder / "old.png").read_bytes(), first)  # the same command, the same bytes

    def test_simulation_is_silent(self):
        """No warning of SystemC's, no bar, no greeting: stderr is empty."""
        for scene in sorted(tool.SCENES.glob("*.json")):
            for options in (["--engine", "lockstep"], ["--engine", "decoupled", "--max-level", "0"],
                            ["--max-level", "5", "--machine", tool.MACHINES / "small.json"]):
                output = self.ok("simulate", scene, "--size", "16x12", *options)
                self.assertNotIn("SystemC", output)
        self.ok("sweep", tool.SCENES / "keel.json", "--size", "16x12,20x15", "--max-level", "0:2", "--reference",
                "point")


tool.main()
