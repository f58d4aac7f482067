# SPDX-License-Identifier: Apache-2.0
"""A run that is ended by a signal leaves nothing behind, and an old file as it was."""

import pathlib
import signal
import subprocess
import time

import tool


def wait_until(condition):
    for _ in range(1000):
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

    def start(self, *arguments):
        return subprocess.Popen([tool.PYRASIM, *map(str, arguments)], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, text=True)

    def nothing_changes(self, before):
        self.assertEqual(self.listing(), before)
        self.assertEqual(self.old.read_text(), "an old file")

    def test_killed(self):
        before = self.listing()
        kill = (signal.SIGKILL,)
        for arguments, numbers in (
                (["render", self.scene, "--size", "4000x4000", "--method", "grid:16", *self.outputs], kill),
                (["simulate", self.scene, "--size", "3000x3000", "--max-level", "16", *self.outputs], kill),
                (["sweep", self.scene, "--size", "3000x3000", "--max-level", "16", "--csv", "new.csv"],
                 (signal.SIGKILL, signal.SIGINT, signal.SIGTERM))):
            for number in numbers:
                with self.start(*arguments) as process:
                    time.sleep(0.3)
                    self.assertIsNone(process.poll(), arguments)
                    process.send_signal(number)
                    self.assertEqual(process.communicate(timeout=60)[0], "")
                self.assertEqual(process.returncode, -number)
                self.nothing_changes(before)

    def test_interrupted(self):
        """The run says in one line how far it came."""
        before = self.listing()
        simulated = r"after \d+ cycles, \d+ of 16000000 pixels stored"
        for arguments, how_far in (
                (["render", self.scene, "--size", "4000x4000", "--method", "grid:16"], r"with \d+\.\d % rendered"),
                (["render", self.scene, "--size", "4000x4000", "--max-level", "11"], r"with \d+\.\d % rendered"),
                (["simulate", self.scene, "--size", "4000x4000"], simulated),
                (["simulate", self.scene, "--size", "4000x4000", "--engine", "lockstep"], simulated)):
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.start(*arguments, *self.outputs) as process:
                    wait_until(lambda: catches(process, number))
                    process.send_signal(number)
                    output = tool.STACK_NOTICE.sub("", process.communicate(timeout=60)[0])
                self.assertRegex(output, rf"\Apyrasim: interrupted {how_far}\n\Z", arguments)
                self.assertEqual(process.returncode, 128 + number)
                self.nothing_changes(before)

    def test_a_second_signal_kills(self):
        """Pixels with deep trees: there is no opportunity to stop for long."""
        before = self.listing()
        with self.start("simulate", self.scene, "--size", "2x2", "--max-level", "16", "--engine", "lockstep",
                        *self.outputs) as process:
            wait_until(lambda: catches(process, signal.SIGINT))
            process.send_signal(signal.SIGINT)
            wait_until(lambda: not catches(process, signal.SIGINT))
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.communicate(timeout=60)[0], "")
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.nothing_changes(before)


tool.main()
