# SPDX-License-Identifier: Apache-2.0
"""A simulation in a process of its own that dies, or cannot be started, is named with the cause and what helps."""

import os
import pathlib
import resource
import signal
import subprocess
import time

import tool
from tool import RUN_FAILED, SCENES

KEEL = str(SCENES / "keel.json")
LONG = ["--size", "4000x3000", "--max-level", "8"]
NOBODY = 65534


def child_of(process):
    """The number of its only child, once there is one."""
    file = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children")
    for _ in range(12_000):  # a busy machine is slow
        if numbers := file.read_text().split():
            return int(numbers[0])
        time.sleep(0.01)
    raise TimeoutError


class Deaths(tool.EndToEnd):
    def start(self, *arguments, preexec_fn=None):
        return subprocess.Popen([tool.PYRASIM, *arguments], cwd=self.folder, stdout=subprocess.PIPE, text=True,
                                stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, preexec_fn=preexec_fn)

    def test_killed(self):
        """By whatever signal; what is said is one line."""
        out_of_memory = "was killed by SIGKILL, as the system does where memory runs out; a smaller --size takes less memory"
        for arguments, what in (
                (["budget", KEEL, *LONG], "the simulation"),
                (["sweep", KEEL, *LONG, "--reference", "point", "--csv", "out.csv"],
                 r"4000x3000 pixels, MAX_LEVEL 8, edge mean \(0 of 1 row done\): its simulation"),
                (["study", "numerics", KEEL, "--size", "2000x1500"],
                 r"double \(0 of 35 rows done\): its simulation")):
            for number, how in ((signal.SIGKILL, out_of_memory), (signal.SIGSEGV, "was ended by SIGSEGV"),
                                (signal.SIGTERM, "was ended by SIGTERM")):
                with self.start(*arguments) as process:
                    child = child_of(process)
                    time.sleep(0.2)
                    os.kill(child, number)
                    _, error = process.communicate(timeout=60)
                if number == signal.SIGSEGV and process.returncode == RUN_FAILED and "Sanitizer" in error:
                    continue  # the sanitizer tells of it, and ends the process in its own way
                self.assertRegex(error, rf"\Apyrasim: {what} {how}\n\Z")
                self.assertEqual(process.returncode, RUN_FAILED)
        self.assertEqual(self.listing(), [])

    def test_a_change_that_dies_is_named(self):
        """The simulation after that of the frame as asked for."""
        with self.start("budget", KEEL, "--size", "2000x1500", "--max-level", "3", "--fps", "100") as process:
            asked = child_of(process)
            while (child := child_of(process)) == asked:
                time.sleep(0.01)
            os.kill(child, signal.SIGKILL)
            _, error = process.communicate(timeout=60)
        self.assertRegex(error, r"\Apyrasim: the simulation with intersection\.units 8 was killed by SIGKILL, as ")
        self.assertEqual(process.returncode, RUN_FAILED)

    def test_too_many_processes(self):
        """A user who may have no further process; not for root, whom that does not limit."""
        def limited():
            if os.geteuid() == 0:
                os.setuid(NOBODY)
            resource.setrlimit(resource.RLIMIT_NPROC, (0, 0))
        os.chmod(self.folder, 0o777)
        try:
            process = self.start("budget", KEEL, "--size", "8x6", preexec_fn=limited)
        except (PermissionError, subprocess.SubprocessError):
            self.skipTest("another user may not run this program")
        with process:
            _, error = process.communicate(timeout=60)
        self.assertEqual(error, "pyrasim: the simulation: cannot start a process: Resource temporarily unavailable; "
                                "the user's limit on processes (ulimit -u) may be reached\n")
        self.assertEqual(process.returncode, RUN_FAILED)

    def test_out_of_memory(self):
        """The limit on the address space is reached in the simulation, not before."""
        def limited():
            resource.setrlimit(resource.RLIMIT_AS, (600 << 20, 600 << 20))
        arguments = [KEEL, "--size", "9000x9000", "--max-level", "0"]
        for command, what in (("budget", "the simulation"),):
            with self.start(command, *arguments, preexec_fn=limited) as process:
                output, error = process.communicate(timeout=60)
            if "Sanitizer" in error:
                self.skipTest("the sanitizer needs the address space")
            self.assertEqual(error, f"pyrasim: {what}: out of memory; a smaller --size takes less memory\n")
            self.assertEqual((process.returncode, output), (RUN_FAILED, ""))

    def test_no_room_for_threads(self):
        """Each would have a stack larger than any address space: the main one does the work."""
        def limited():
            resource.setrlimit(resource.RLIMIT_STACK, (1 << 46, resource.getrlimit(resource.RLIMIT_STACK)[1]))
        if resource.getrlimit(resource.RLIMIT_STACK)[1] != resource.RLIM_INFINITY:
            self.skipTest("this user's stacks are limited")
        for arguments in (["render", KEEL, "--size", "64x48", "--threads", "4"],
                          ["simulate", KEEL, "--size", "64x48", "--threads", "2"]):
            with self.start(*arguments, preexec_fn=limited) as process:
                output, error = process.communicate(timeout=60)
            self.assertEqual((process.returncode, error), (0, ""))
            self.assertEqual(output, self.ok(*arguments))

    def test_little_memory(self):
        """Whatever there is too little memory for, it is one line, and nothing aborts or waits for ever."""
        started = failed = 0
        for arguments in (["render", KEEL, "--size", "300x200", "--threads", "8", "-o", "out.pfm"],
                          ["simulate", KEEL, "--size", "64x48", "-o", "out.pfm"]):
            for megabytes in range(12, 80, 2):
                def limited(bytes_=megabytes << 20):
                    resource.setrlimit(resource.RLIMIT_AS, (bytes_, bytes_))
                with self.start("--version", preexec_fn=limited) as process:
                    process.communicate(timeout=60)
                if process.returncode != 0:
                    continue  # its libraries take more
                started += 1
                with self.start(*arguments, preexec_fn=limited) as process:
                    _, error = process.communicate(timeout=60)
                if process.returncode != 0:
                    failed += 1
                    self.assertEqual((process.returncode, error), (RUN_FAILED, "pyrasim: out of memory\n"), megabytes)
        if started == 0:
            self.skipTest("the sanitizer needs the address space")
        self.assertGreater(failed, 0)


tool.main()
