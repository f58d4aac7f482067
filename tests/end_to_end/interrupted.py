# SPDX-License-Identifier: Apache-2.0
"""A run that is killed leaves nothing behind, and an old file as it was."""

import signal
import subprocess
import time

import tool


class Interrupted(tool.EndToEnd):
    def test_killed(self):
        scene = self.write("scene.json", tool.scene())
        old = self.write("old.png", "an old file")
        before = self.listing()
        for arguments in (["render", scene, "--size", "4000x4000", "--max-level", "0", "--method", "grid:64"],
                          ["simulate", scene, "--size", "3000x3000", "--max-level", "16", "--engine", "lockstep"],
                          ["sweep", scene, "--size", "3000x3000", "--max-level", "16"]):
            if arguments[0] == "sweep":
                outputs = ["--csv", "new.csv"]
            else:
                outputs = ["-o", old, "--stats", "new.json"]
            for number in (signal.SIGKILL, signal.SIGINT, signal.SIGTERM):
                with subprocess.Popen([tool.PYRASIM, *arguments, *outputs], cwd=self.folder, stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL) as process:
                    time.sleep(0.3)
                    self.assertIsNone(process.poll(), arguments)
                    process.send_signal(number)
                    output = process.communicate(timeout=60)[0]
                self.assertEqual(output, b"")
                self.assertIn(process.returncode, (-number, 128 + number))
                self.assertEqual(self.listing(), before, (arguments, number))
        self.assertEqual(old.read_text(), "an old file")


tool.main()
