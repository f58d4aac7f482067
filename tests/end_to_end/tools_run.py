# SPDX-License-Identifier: Apache-2.0
"""tools/run's options: what it makes for a size, and its help; what tools/setup installs. What they build and install with is
replaced."""

import os
import shutil
import struct
import subprocess

import tool
from tool import SCENES, SOURCE


class ToolsRun(tool.EndToEnd):
    def setUp(self):
        super().setUp()
        (self.folder / "tools").mkdir()
        (self.folder / "build" / "release").mkdir(parents=True)
        shutil.copy(SOURCE / "tools" / "run", self.folder / "tools" / "run")
        self.write("tools/build", "#!/bin/sh\ntouch built\n").chmod(0o755)
        (self.folder / "build" / "release" / "pyrasim").symlink_to(tool.PYRASIM)
        (self.folder / "scenes").symlink_to(SCENES)

    def start(self, *options):
        return subprocess.run([self.folder / "tools" / "run", *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, timeout=120, check=False)

    def size_of(self, name):
        return struct.unpack(">II", (self.folder / "out" / name).read_bytes()[16:24])

    def test_every_picture_has_the_size_asked_for(self):
        for options, size in (((), (640, 480)), (("--size", "320x240"), (320, 240)), (("--size=100x80",), (100, 80)),
                              (("--size", "30x20", "--max-level", "1"), (30, 20)),
                              (("--size", "900x600", "--window", "500,300,90,70"), (90, 70)),
                              (("--window", "0,0,1,1", "--set", "intersection.units=2"), (1, 1))):
            run = self.start(*options)
            self.assertEqual((run.returncode, run.stderr), (0, ""), options)
            self.assertEqual((self.size_of("keel.png"), self.size_of("keel_point.png")), (size, size), options)
            self.assertGreater(min(self.size_of("keel_crop.png")), 0)
            self.assertIn("keel_crop.png", run.stdout)
        self.assertIn("--set intersection.units=2", (self.folder / "out" / "keel.stats.json").read_text())

    def test_help_builds_nothing(self):
        for option in ("--help", "-h"):
            run = self.start(option)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertTrue(run.stdout.startswith("Usage: tools/run [--size COLUMNSxROWS]"), run.stdout)
            self.assertIn("keel_crop.png", run.stdout)
            self.assertNotIn("#", run.stdout)
        self.assertFalse((self.folder / "built").exists())

    def test_mistakes(self):
        for options in (("-o", "x.png"), ("--stats=x.json",), ("--size",), ("--max-level", "2", "--window")):
            run = self.start(*options)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn(f"tools/run: {options[-1] if options[-1].startswith('-') else options[0]}: ", run.stderr)
        for options in (("--size", "0x0"), ("--paint",)):
            run = self.start(*options)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn("--", run.stderr)


class ToolsSetup(tool.EndToEnd):
    """Of a machine that has none of the packages, by what apt-get is asked for."""

    def start(self, *level, works=True):
        (self.folder / "bin").mkdir(exist_ok=True)
        self.write("bin/dpkg-query", "#!/bin/sh\nexit 1\n").chmod(0o755)
        self.write("bin/sudo", '#!/bin/sh\nexec "$@"\n').chmod(0o755)
        self.write("bin/apt-get", f'#!/bin/sh\necho "$@" >>asked\necho said\n{"true" if works else "false"}\n').chmod(0o755)
        (self.folder / "asked").unlink(missing_ok=True)
        return subprocess.run([SOURCE / "tools" / "setup", *level], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              timeout=120, check=False, cwd=self.folder, env={**os.environ, "PATH": f"{self.folder}/bin:/usr/bin:/bin"})

    def packages(self, *level):
        run = self.start(*level)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        *_, install = (self.folder / "asked").read_text().splitlines()
        return {word for word in install.split() if not word.startswith("-")} - {"install"}

    def test_each_level_has_more(self):
        plain, test, dev = self.packages(), self.packages("test"), self.packages("dev")
        self.assertLess(plain, test)
        self.assertLess(test, dev)
        self.assertLess({"g++", "cmake", "libsystemc-dev"}, plain)
        self.assertLess({"gtkwave", "xvfb", "chromium", "chromium-shell", "povray"}, test - plain)
        self.assertLess({"clang-tidy", "clang-format"}, dev - test)

    def test_mistakes(self):
        run = self.start("all")
        self.assertEqual((run.returncode, run.stdout), (2, ""))
        self.assertEqual(run.stderr, "tools/setup: unknown argument 'all'; test and dev are allowed\n")
        run = self.start(works=False)
        self.assertEqual(run.returncode, 1)
        self.assertIn("said\ntools/setup: cannot install ", run.stderr)


tool.main()
