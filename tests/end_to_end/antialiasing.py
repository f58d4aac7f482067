# SPDX-License-Identifier: Apache-2.0
"""tools/antialiasing's script works, in small: its tables are complete, and say what has to hold."""

import importlib.util
import re
import shutil
import subprocess
import sys
import unittest

import tool

SCRIPT = tool.SOURCE / "tests" / "bench" / "antialiasing.py"
PIXELS = 32 * 24


def script():
    spec = importlib.util.spec_from_file_location("bench_antialiasing", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@unittest.skipUnless(shutil.which("povray"), "POV-Ray is not installed")
class Tables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        run = subprocess.run([sys.executable, "-B", SCRIPT, tool.PYRASIM, "--scenes", "spheres", "--size", "32x24",
                              "--grid", "16"], capture_output=True, text=True, check=False, timeout=300)
        assert run.returncode == 0, run.stderr
        rows, cls.equal = run.stdout.split("\n\n")
        row = re.compile(r"\| spheres \| (?:POV-Ray `\+A(\S+) \+AM2 \+R(\d)`|pyrasim `--max-level (\d)`) \| (\S+) \| (\S+) \|")
        found = [row.fullmatch(line).groups() for line in rows.splitlines()[2:]]
        cls.povray = {(float(threshold), int(depth)): (float(rays), float(error))
                      for threshold, depth, level, rays, error in found if not level}
        cls.pyrasim = {int(level): (float(rays), float(error)) for _, _, level, rays, error in found if level}

    def test_every_setting_has_a_row(self):
        self.assertEqual(sorted(self.pyrasim), [1, 2, 3, 4])
        self.assertEqual(sorted(self.povray), [(a, r) for a in (0.01, 0.03, 0.1, 0.3) for r in (2, 3, 4, 5)])
        self.assertRegex(self.equal.splitlines()[2], r"^\| spheres( \| [<>]? ?\d+\.\d\d){4} \| \de-0\d \|$")

    def test_more_rays_leave_less_error(self):
        for points in [list(self.pyrasim.values())] + [[self.povray[a, r] for r in (2, 3, 4, 5)]
                                                       for a in (0.01, 0.03, 0.1, 0.3)]:
            for (rays, error), (more, less) in zip(points, points[1:]):
                self.assertLess(rays, more)
                self.assertLess(less, error)
            self.assertLess(points[0][1], 0.03)
            self.assertGreater(points[-1][1], 0)

    def test_corners_are_counted_once_and_five_rays_a_division(self):
        for rays in [self.pyrasim[1][0]] + [self.povray[a, 2][0] for a in (0.01, 0.03, 0.1, 0.3)]:
            more = round(rays * PIXELS) - 33 * 25
            self.assertEqual(more % 5, 0)
            self.assertTrue(0 < more // 5 <= PIXELS, more)


class EqualErrors(unittest.TestCase):
    def test_lie_on_lines_through_the_best_points(self):
        rays_for = script().rays_for
        points = [(1, 0.1), (4, 0.025), (3, 0.2), (16, 0.00625)]
        for error, rays, sure in ((0.1, 1, ""), (0.05, 2, ""), (0.0125, 8, ""), (0.3, 1, "<"), (0.001, 16, ">")):
            its, how = rays_for(error, points)
            self.assertAlmostEqual(its, rays)
            self.assertEqual(how, sure)


tool.main()
