# SPDX-License-Identifier: Apache-2.0
"""--jobs: whatever it is, the same rows, the same failures, and no process that outlives its sweep."""

import csv
import io
import os
import pathlib
import signal
import subprocess
import time

import tool
from tool import LIMIT, OK, RUN_FAILED, SCENES, USAGE

KEEL = str(SCENES / "keel.json")
SWEEP = ["sweep", KEEL, SCENES / "fins.json", "--size", "32x24,64x48", "--max-level", "0,3", "--edge", "mean,drop", "--set",
         "intersection.units=1,4", "--reference", "grid:2"]
STUDY = ["study", "numerics", SCENES / "spheres.json", "--size", "40x30", "--max-level", "2", "--formats",
         "fp24,fix24.12,fp16,fix32.20"]
LONG = ["sweep", KEEL, "--size", "3000x2000", "--max-level", "4,5,6", "--reference", "none"]
PATIENCE = 2  # seconds that a signal may take
CORES = os.cpu_count()


def children_of(process):
    """The numbers of its processes."""
    return [int(number) for number in pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()]


def runs(number):
    """Whether the process is there, and is no zombie."""
    try:
        return pathlib.Path(f"/proc/{number}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def wait_until(condition, seconds=120):
    end = time.monotonic() + seconds
    while not (found := condition()):
        if time.monotonic() > end:
            raise TimeoutError
        time.sleep(0.01)
    return found


class Jobs(tool.EndToEnd):
    def start(self, *arguments, **options):
        return subprocess.Popen([tool.PYRASIM, *map(str, arguments)], cwd=self.folder, stdout=subprocess.PIPE, text=True,
                                stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, **options)

    def with_jobs(self, jobs, *arguments):
        """Exit code, stdout and stderr, the table and its rows as CSV."""
        file = self.folder / "rows.csv"
        run = self.run_tool(*arguments, "--jobs", jobs, "--csv", file)
        rows = file.read_text() if file.exists() else ""
        file.unlink(missing_ok=True)
        on_stdout = self.run_tool(*arguments, "--jobs", jobs, "--csv", "-")
        self.assertEqual((on_stdout.returncode, on_stdout.stdout), (run.returncode, rows))
        return run.returncode, run.stdout, run.stderr, rows

    def test_the_same_bytes(self):
        for arguments, count in ((SWEEP, 32), (STUDY, 5)):
            alone = self.with_jobs(1, *arguments)
            self.assertEqual((alone[0], len(alone[3].splitlines())), (OK, 1 + count))
            for jobs in (2, 4, 100, 0):
                self.assertEqual(self.with_jobs(jobs, *arguments), alone, jobs)
            self.assertEqual(self.ok(*arguments), alone[1])

    def test_several_at_once(self):
        """So many processes as there are jobs, and no more; never more than rows."""
        for jobs, most in ((1, 1), (2, 2), (50, 3)):
            with self.start(*LONG, "--jobs", jobs) as process:
                wait_until(lambda: len(children_of(process)) == most)
                for _ in range(20):
                    self.assertEqual(len(children_of(process)), most)
                    time.sleep(0.01)
                process.terminate()

    def test_a_failure(self):
        """The first in order is the one that is told, though others fail too and may sooner."""
        frame = ["sweep", KEEL, "--size", "64x48", "--max-level", "0,1,5,2,4,0", "--reference", "point"]
        cycles = [int(row["cycles"]) for row in csv.DictReader(io.StringIO(self.run_tool(*frame, "--csv", "-").stdout))]
        limited = [*frame, "--max-cycles", sorted(cycles)[-2] - 1]
        alone = self.with_jobs(1, *limited)
        self.assertEqual((alone[0], len(alone[3].splitlines())), (LIMIT, 1 + 2))
        self.assertTrue(alone[2].startswith("pyrasim: 64x48 pixels, MAX_LEVEL 5, edge mean (2 of 6 rows done): the frame "))
        for jobs in (2, 3, 6):
            self.assertEqual(self.with_jobs(jobs, *limited), alone, jobs)
        self.assertEqual(self.with_jobs(2, *STUDY, "--max-cycles", 1000), self.with_jobs(1, *STUDY, "--max-cycles", 1000))

    def test_one_that_dies(self):
        """It is named, after the rows before it have been made; the others end with it."""
        levels = ["sweep", KEEL, "--size", "600x400", "--max-level", "3,8,9", "--reference", "none", "--csv", "rows.csv"]
        with self.start(*levels, "--jobs", 3) as process:
            children = wait_until(lambda: (numbers := children_of(process)) and len(numbers) == 3 and sorted(numbers))
            os.kill(children[1], signal.SIGKILL)
            _, error = process.communicate(timeout=120)
        self.assertRegex(error, r"\Apyrasim: 600x400 pixels, MAX_LEVEL 8, edge mean \(1 of 3 rows done\): its simulation "
                                r"was killed by SIGKILL, as the system does where memory runs out; a smaller --size takes ")
        self.assertEqual(process.returncode, RUN_FAILED)
        self.assertFalse(any(map(runs, children)))
        self.assertEqual(len((self.folder / "rows.csv").read_text().splitlines()), 1 + 1)

    def test_signals_leave_no_orphan(self):
        """Neither one for the program alone nor one for all of its processes, as Ctrl-C sends it."""
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            for send in (os.kill, os.killpg):
                with self.start(*LONG, "--jobs", 3, start_new_session=True) as process:
                    children = wait_until(lambda: (numbers := children_of(process)) and len(numbers) == 3 and numbers)
                    time.sleep(0.1)
                    begin = time.monotonic()
                    send(process.pid, number)
                    _, error = process.communicate(timeout=60)
                    wait_until(lambda: not any(map(runs, children)), PATIENCE)
                    self.assertLess(time.monotonic() - begin, PATIENCE)
                if number == signal.SIGKILL:
                    self.assertEqual((process.returncode, error), (-number, ""))
                else:
                    self.assertEqual(process.returncode, 128 + number)
                    self.assertEqual(error, "pyrasim: interrupted with 0 of 3 rows done, in 3000x2000 pixels, MAX_LEVEL 4, "
                                            "edge mean\n")

    def test_a_signal_while_the_reference_is_made(self):
        """The simulations of the picture before go on meanwhile."""
        arguments = ["sweep", KEEL, "--size", "300x200,6000x4000", "--max-level", "10", "--reference", "grid:4", "--jobs", 2]
        with self.start(*arguments) as process:
            children = wait_until(lambda: children_of(process), 60)
            time.sleep(0.3)
            begin = time.monotonic()
            process.terminate()
            _, error = process.communicate(timeout=60)
            self.assertLess(time.monotonic() - begin, PATIENCE)
        self.assertFalse(any(map(runs, children)))
        self.assertEqual(process.returncode, 128 + signal.SIGTERM, error)

    def test_nobody_who_reads(self):
        """A closed pipe ends the program, and with it all of its processes."""
        with self.start("sweep", KEEL, "--size", "8x6,3000x2000", "--max-level", "0,0,4,5", "--reference", "none", "--jobs",
                        4, "--csv", "-") as process:
            children = wait_until(lambda: (numbers := children_of(process)) and numbers)
            process.stdout.close()
            process.wait(timeout=60)
            wait_until(lambda: not any(map(runs, children)), PATIENCE)
        self.assertNotEqual(process.returncode, 0)

    def test_resume(self):
        """What was made with several at once is known again, and the other way round."""
        whole = self.with_jobs(1, *SWEEP)[3]
        lines = whole.splitlines(keepends=True)
        self.write("some.csv", "".join(lines[:9]))
        self.assertIn("\n8 of 32 rows were in some.csv\n", self.ok(*SWEEP, "--jobs", 3, "--resume", "some.csv"))
        self.assertEqual((self.folder / "some.csv").read_text(), whole)
        self.assertIn("32 of 32 rows were in some.csv", self.ok(*SWEEP, "--resume", "some.csv"))

    def test_memory_is_checked_for_all_at_once(self):
        """One picture and its reference have room, as many as there are jobs have not; with fewer the sweep would begin."""
        side = int((os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / (12 * 2.5)) ** 0.5)
        if side > 65535:
            self.skipTest("this machine holds any two pictures")
        for command in (["sweep", KEEL, "--max-level", "0,0,0", "--reference", "point", "--csv", "out.csv"],
                        ["study", "numerics", KEEL, "--max-level", "0", "--formats", "float,fp24", "--csv", "out.csv"]):
            large = [*command, "--size", f"{side}x{side}"]
            for jobs in (2, 3, 100):
                self.refused(LIMIT, *large, "--jobs", jobs, says=" pictures at the same time take ")
            self.refused(LIMIT, *command, "--size", f"{2 * side}x{side}", says=f"a picture of {2 * side}x{side} pixels")

    def test_usage(self):
        for command in (["sweep", KEEL], ["study", "numerics", KEEL]):
            for value in ("-1", "1.5", "x", "", "1025"):
                self.refused(USAGE, *command, "--jobs", value, says="--jobs")
            self.assertRegex(self.ok(*command[:-1], "--help"), r"--jobs ")


tool.main()
