# SPDX-License-Identifier: Apache-2.0
"""A run that is ended by a signal leaves nothing behind, and an old file as it was."""

import os
import pathlib
import signal
import subprocess
import time

import tool
from tool import SCENES


KEEL = SCENES / "keel.json"
EDGE = "a scene with many edges in a single pixel"
# Spheres behind each other, each a ring wider than the one before it; the outer ones cover a corner.
EDGE_SCENE = tool.scene([{"type": "sphere", "center": [distance, 0.3 * distance, 0.3 * distance],
                          "radius": (0.05 + 0.002 * k) * distance, "color": [1, 1, 1]}
                         for k, distance in enumerate(10 * 1.3**k for k in range(40))])
PATIENCE = 120  # seconds; the program takes one or less


def wait_until(condition):
    for _ in range(12_000):  # a busy machine is slow
        if condition():
            return
        time.sleep(0.01)
    raise TimeoutError


def catches(process, number):
    """Whether the process has a handler for the signal; before that the signal kills it."""
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    mask = next(line.split()[1] for line in status.splitlines() if line.startswith("SigCgt:"))
    return int(mask, 16) >> (number - 1) & 1 == 1


class Interrupted(tool.EndToEnd):
    def setUp(self):
        super().setUp()
        self.scene = self.write("scene.json", tool.scene())
        self.old = self.write("old.png", "an old file")
        self.outputs = ["-o", self.old, "--stats", "new.json"]

    def start(self, *arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT):
        return subprocess.Popen([tool.PYRASIM, *map(str, arguments)], cwd=self.folder, stdout=stdout, stderr=stderr,
                                stdin=stdin, text=True)

    def interrupt(self, number, *arguments):
        """What a run says that the signal ends as soon as it catches it, without how far it is; its exit code is the
        signal's. Where the machine is so busy that a task takes longer than the program waits for one, it does not say
        how far it came: it is tried again."""
        for _ in range(20):
            with self.start(*arguments) as process:
                wait_until(lambda: catches(process, number))
                process.send_signal(number)
                output = process.communicate(timeout=PATIENCE)[0]
            self.assertEqual(process.returncode, 128 + number, arguments)
            said = "".join(f"{line}\n" for line in tool.messages(output))
            if said != "pyrasim: interrupted\n":
                break
        return said

    def nothing_changes(self, before):
        self.assertEqual(self.listing(), before)
        self.assertEqual(self.old.read_text(), "an old file")

    def test_killed(self):
        before = self.listing()
        for arguments in (["render", self.scene, "--size", "4000x4000", "--method", "grid:16"],
                          ["simulate", self.scene, "--size", "3000x3000", "--max-level", "16"],
                          ["simulate", self.scene, "--size", "3000x3000", "--trace", "new.vcd"]):
            with self.start(*arguments, *self.outputs) as process:
                time.sleep(0.3)
                self.assertIsNone(process.poll(), arguments)
                process.send_signal(signal.SIGKILL)
                self.assertEqual(process.communicate(timeout=60)[0], "")
            self.assertEqual(process.returncode, -signal.SIGKILL)
            self.nothing_changes(before)

    def test_interrupted(self):
        """The run says in one line how far it came."""
        before = self.listing()
        simulated = r"after \d+ cycles, \d+ of 16000000 pixels stored"
        for arguments, how_far in (
                (["render", self.scene, "--size", "50x20000", "--method", "grid:64"], r"with \d+\.\d % rendered"),
                (["render", KEEL, "--size", "1000x1000", "--max-level", "11"], r"with \d+\.\d % rendered"),
                (["simulate", self.scene, "--size", "4000x4000"], simulated),
                (["simulate", self.scene, "--size", "4000x4000", "--trace", "new.vcd"], simulated),
                (["simulate", self.scene, "--size", "4000x4000", "--engine", "lockstep"], simulated)):
            for number in (signal.SIGINT, signal.SIGTERM):
                said = self.interrupt(number, *arguments, *self.outputs)
                self.assertRegex(said, rf"\Apyrasim: interrupted {how_far}\n\Z", arguments)
                if "--trace" in arguments:  # it reaches to where the run came
                    (self.folder / "new.vcd").unlink()
                self.nothing_changes(before)

    def test_recorded_frames(self):
        """Likewise of commands that make a frame again, and of one that shows a pixel of it."""
        subprocess.run([tool.PYRASIM, "simulate", KEEL, "--size", "800x600", "--trace", "run.ptrace"], cwd=self.folder,
                       stdout=subprocess.DEVNULL, check=True)
        page = self.write("old.html", "an old file")
        before = self.listing()
        for arguments, how_far in (
                (["view", "run.ptrace", "-o", "old.html"], "with 0 of 1 run simulated"),
                (["view", "run.ptrace", "run.ptrace", "-o", "-"], "with 0 of 2 runs simulated"),
                (["whatif", "run.ptrace", "--csv", "new.csv"], "(while RUN was read|with 0 of 1 row done, in recorded)"),
                (["whatif", "run.ptrace", "--sensitivity"], "(while RUN was read|with 0 of 1 row done, in recorded)"),
                (["pixel", KEEL, "9,9", "--size", "2000x2000"], r"after \d+ cycles, \d+ of 4000000 pixels stored")):
            for number in (signal.SIGINT, signal.SIGTERM):
                said = self.interrupt(number, *arguments)
                self.assertRegex(said, rf"(?m)^pyrasim: interrupted {how_far}\n\Z", arguments)
                self.nothing_changes(before)
                self.assertEqual(page.read_text(), "an old file")

    def test_a_trace_that_does_not_come(self):
        reader, writer = os.pipe()
        for arguments in (["whatif", "/dev/stdin"], ["view", "/dev/stdin", "-o", "new.html"]):
            with self.start(*arguments, stdin=reader) as process:
                wait_until(lambda: catches(process, signal.SIGINT))
                process.send_signal(signal.SIGINT)
                self.assertRegex(process.communicate(timeout=PATIENCE)[0], r"\Apyrasim: interrupted.*\n\Z", arguments)
            self.assertEqual(process.returncode, 128 + signal.SIGINT)
        os.close(reader)
        os.close(writer)

    def test_a_second_signal_kills(self):
        """A row of long pixels: there is no opportunity to stop for longer than the program waits for one."""
        before = self.listing()
        with self.start("render", self.scene, "--size", "20000x4", "--method", "grid:256", *self.outputs) as process:
            wait_until(lambda: catches(process, signal.SIGINT))
            process.send_signal(signal.SIGINT)
            wait_until(lambda: not catches(process, signal.SIGINT))
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.communicate(timeout=60)[0], "")
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.nothing_changes(before)

    def ends(self, process, number, arguments):
        """The signal ends the process, as a shell sees it, within `patience`; returns what it said."""
        time.sleep(0.4)
        self.assertIsNone(process.poll(), arguments)
        process.send_signal(number)
        try:
            output = process.communicate(timeout=PATIENCE)[0]
        except subprocess.TimeoutExpired:
            process.kill()
            self.fail(f"{arguments}: goes on after {number.name}")
        self.assertIn(process.returncode, (-number, 128 + number), arguments)
        return output or ""

    def test_any_state_of_a_run(self):
        """One pixel that takes long, tasks that do, time that passes in long steps, processes of their own."""
        before = self.listing()
        slow = ["--set", "intersection.cost.box_test=1000000", "--set", "clock_mhz=0.001"]
        for arguments in (
                ["simulate", EDGE, "--size", "1x1", "--max-level", "16", "--scalar", "fix64.32"],
                ["simulate", EDGE, "--size", "1x1", "--max-level", "16", "--engine", "lockstep"],
                ["simulate", KEEL, "--size", "2000x2000", "--engine", "lockstep", *slow],
                ["simulate", KEEL, "--size", "4000x4000", "--max-cycles", 10**18],
                ["simulate", KEEL, "--size", "9000x5000", "--max-level", "0", "--set", "fifos.all=65536", "--set",
                 "tree_accumulator.pixels=1000000"],
                ["render", self.scene, "--size", "20000x4", "--method", "grid:256"],
                ["render", KEEL, "--size", "64x48", "--max-level", "16"],
                ["budget", KEEL, "--size", "4000x4000"],
                ["budget", KEEL, "--size", "300x200", "--max-level", "12", "--fps", "100000"],
                ["sweep", KEEL, "--size", "3000x3000"],
                ["sweep", EDGE, "--size", "1x1", "--max-level", "16", "--set", "intersection.units=256"],
                ["study", "numerics", KEEL, "--size", "3000x3000"],
                ["study", "numerics", EDGE, "--size", "1x1", "--max-level", "16"]):
            file = self.write("edge.json", EDGE_SCENE)
            with self.start(*(file if argument is EDGE else argument for argument in arguments)) as process:
                self.ends(process, signal.SIGTERM, arguments)
            file.unlink()
            self.nothing_changes(before)

    def test_no_temporary_files(self):
        """What budget records is in no file."""
        temporary = self.folder / "temporary"
        temporary.mkdir()
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            for seconds in (0.2, 1):  # while the frame is recorded, and while it is replayed
                with subprocess.Popen([tool.PYRASIM, "budget", KEEL, "--size", "800x600", "--fps", "3000"],
                                      env={**os.environ, "TMPDIR": str(temporary)}, stdout=subprocess.DEVNULL,
                                      stderr=subprocess.DEVNULL) as process:
                    time.sleep(seconds)
                    self.assertEqual(list(temporary.iterdir()), [])
                    process.send_signal(number)
                self.assertIn(process.returncode, (-number, 128 + number))
                self.assertEqual(list(temporary.iterdir()), [])

    def test_reading_for_long(self):
        """A mesh of many triangles, and a pipe that delivers nothing."""
        side = 700
        lines = [f"v {5 + (i * 7 + j * 13) % 17 / 50} {i / side} {j / side}" for i in range(side) for j in range(side)]
        lines += [f"f {k + 1} {k + 2} {k + side + 1}" for k in range(side * (side - 1) - 1)]
        self.write("huge.obj", "\n".join(lines * 2))
        scene = self.write("huge.json", tool.scene([{"type": "mesh", "file": "huge.obj", "color": [1, 1, 1]}]))
        before = self.listing()
        for arguments in (["render", scene], ["simulate", scene], ["check", scene], ["sweep", scene]):
            with self.start(*arguments) as process:
                self.ends(process, signal.SIGTERM, arguments)
            self.nothing_changes(before)
        for arguments in (["render", "/dev/stdin"], ["check", "/dev/stdin"]):
            reader, writer = os.pipe()
            with self.start(*arguments, stdin=reader) as process:
                self.ends(process, signal.SIGINT, arguments)
            os.close(reader)
            os.close(writer)

    def test_comparing_for_long(self):
        """Two large pictures, black."""
        columns, rows = 20000, 5000
        for name in ("a.pfm", "b.pfm"):
            with open(self.folder / name, "wb") as file:
                file.write(f"PF\n{columns} {rows}\n-1\n".encode())
                file.truncate(file.tell() + columns * rows * 12)
        before = self.listing()
        with self.start("compare", "a.pfm", "b.pfm", "-o", self.old) as process:
            self.ends(process, signal.SIGTERM, "compare")
        self.nothing_changes(before)

    def test_writing_to_nobody_who_reads(self):
        """stdout is a pipe that is full."""
        levels = ",".join(["0"] * 50)
        for arguments in (["simulate", self.scene, "--stats", "-"], ["simulate", self.scene],
                          ["render", self.scene, "--stats", "-"], ["budget", self.scene],
                          ["sweep", self.scene, "--reference", "point", "--max-level", levels, "--csv", "-"],
                          ["study", "numerics", self.scene, "--formats", "fp24", "--csv", "-"]):
            for both in (False, True):
                reader, writer = os.pipe()
                os.set_blocking(writer, False)
                try:
                    while True:
                        os.write(writer, b"x" * 512)
                except BlockingIOError:
                    os.set_blocking(writer, True)
                with self.start(*arguments, stdout=writer, stderr=writer if both else subprocess.DEVNULL) as process:
                    self.ends(process, signal.SIGTERM, arguments)
                os.close(reader)
                os.close(writer)

    def test_rows_that_are_done_stay(self):
        """Of a sweep and a study: in the file and on stdout, whole, whatever ends the run."""
        cheap = ",".join(["0"] * 3)
        runs = ((["sweep", EDGE, "--size", "2x2", "--reference", "point", "--max-level", cheap + ",16"],
                 r"with 3 of 4 rows done, in 2x2 pixels, MAX_LEVEL 16, edge mean"),
                (["study", "numerics", EDGE, "--size", "2x2", "--max-level", "13"], r"with \d+ of 35 rows done, in \S+"))
        scene = self.write("edge.json", EDGE_SCENE)
        for arguments, how_far in runs:
            words = [scene if word is EDGE else word for word in arguments]
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
                with self.start(*words, "--csv", "rows.csv") as process:
                    file = self.folder / "rows.csv"
                    least = 1 + (3 if words[0] == "sweep" else 1)
                    wait_until(lambda: file.exists() and len(file.read_text().splitlines()) >= least)
                    process.send_signal(number)
                    output = process.communicate(timeout=60)[0]
                rows = file.read_text()
                self.assertTrue(rows.endswith("\n"), rows)
                self.assertEqual({row.count(",") for row in rows.splitlines()}, {rows.splitlines()[0].count(",")})
                self.assertEqual(len([line for line in tool.messages(output) if "pyrasim" not in line]),
                                 len(rows.splitlines()))
                if number == signal.SIGKILL:
                    self.assertEqual(process.returncode, -number)
                else:
                    self.assertRegex(output, rf"(?m)^pyrasim: interrupted {how_far}$")
                    self.assertEqual(process.returncode, 128 + number)
                file.unlink()


tool.main()
