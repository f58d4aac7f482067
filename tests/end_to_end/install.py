# SPDX-License-Identifier: Apache-2.0
"""What `cmake --install` leaves: the program with its data, and a CMake package that each of examples/ is built upon and
run. All of it stays below the build folder, so that a second run builds what has changed."""

import os
import pathlib
import re
import shutil
import subprocess

import tool
from tool import SOURCE, USAGE

BUILD = tool.PYRASIM.parent
PREFIX = BUILD / "installed"
DATA = PREFIX / "share/pyrasim"


def run(*command, **more):
    """The finished process."""
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          encoding="utf-8", timeout=500, check=False, **more)


class Install(tool.EndToEnd):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(PREFIX, ignore_errors=True)
        install = run("cmake", "--install", BUILD, "--prefix", PREFIX)
        assert install.returncode == 0, install.stdout + install.stderr

    def example(self, name, *arguments, code=0):
        """stdout, or stderr where `code` is none of success, of the example, which is configured and built if need be."""
        launcher = shutil.which("ccache") or ""
        folder = BUILD / "examples" / name
        for command in (("cmake", "-S", SOURCE / "examples" / name, "-B", folder, "-G", "Ninja",
                         "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}",
                         "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wshadow -Wpedantic -Werror", f"-DCMAKE_PREFIX_PATH={PREFIX}"),
                        ("cmake", "--build", folder)):
            made = run(*command)
            self.assertEqual(made.returncode, 0, made.stdout + made.stderr)
        found = re.search(r"(?m)^pyrasim_DIR:PATH=(.*)$", (folder / "CMakeCache.txt").read_text()).group(1)
        self.assertTrue(pathlib.Path(found).is_relative_to(PREFIX), found)
        ran = run(folder / name, *arguments, cwd=self.folder,
                  env={**os.environ, "SYSTEMC_DISABLE_COPYRIGHT_MESSAGE": "1"})
        self.assertEqual(ran.returncode, code, ran.stderr)
        return ran.stderr if code else ran.stdout

    def test_program_and_data(self):
        tool.PYRASIM, built = PREFIX / "bin/pyrasim", tool.PYRASIM
        self.addCleanup(setattr, tool, "PYRASIM", built)
        for file in (*(DATA / "scenes").glob("*.json"), *(DATA / "machines").glob("*.json")):
            if file.name != "bunny.json":  # its mesh is Debian's
                self.ok("check", file)
        for folder, name in (("scenes", "scenes"), ("machines", "machines"), ("docs/schemas", "schemas")):
            self.assertEqual({file.name for file in (DATA / name).iterdir()},
                             {file.name for file in (SOURCE / folder).iterdir()})
        for file, command in (("man/man1/pyrasim.1", ["man"]), ("zsh/site-functions/_pyrasim", ["completion", "zsh"]),
                              ("bash-completion/completions/pyrasim", ["completion", "bash"]),
                              ("fish/vendor_completions.d/pyrasim.fish", ["completion", "fish"])):
            self.assertEqual((PREFIX / "share" / file).read_text(), self.ok(*command))

    def test_headers(self):
        """All of them, under the names by which the sources include them; none of the command line's."""
        sources = {file.relative_to(SOURCE / "src") for file in (SOURCE / "src").rglob("*.h")}
        machine = {file.relative_to(SOURCE) for file in (SOURCE / "hw_model").rglob("*.h")}
        installed = PREFIX / "include/pyrasim"
        self.assertEqual({file.relative_to(installed) for file in installed.rglob("*") if file.is_file()},
                         {file for file in sources if file.parts[0] != "cli"} | machine)

    def test_two_machines(self):
        """Two machines in one simulation have each the cycles and the picture that they have alone."""
        keel = DATA / "scenes/keel.json"
        machines = [DATA / "machines" / f"{name}.json" for name in ("default", "wide")]
        lines = self.example("two_machines", keel, *machines).splitlines()
        for line, name, machine in zip(lines, ("first", "second"), machines, strict=True):
            document = self.stats("simulate", keel, "--machine", machine, "-o", "alone.png")
            self.assertEqual(line, f"{name} {machine.stem} {document['machine']['cycles']} cycles")
            self.assertEqual(self.ok("compare", "alone.png", f"{name}.png"), "RMSE 0, maximum 0, PSNR inf dB\n")
        self.assertIn("no.json", self.example("two_machines", "no.json", *machines, code=tool.INPUT))
        self.example("two_machines", code=USAGE)

    def test_memory_port(self):
        """An own stage behind the machine, whichever engine runs that, and own sinks."""
        scene = self.write("scene.json", tool.scene(columns=64, rows=48))
        cycles = self.stats("simulate", scene)["machine"]["cycles"]
        pixels = 64 * 48
        refresh = pixels // 256 * 16
        for interval in (1, 40):
            text = self.example("memory_port", scene, str(interval))
            self.assertEqual(self.example("memory_port", scene, str(interval), "lockstep"), text)
            frame, memory, stored, waiting, wait = map(int, re.fullmatch(
                r"frame (\d+) cycles, memory (\d+) cycles\npixels (\d+), most waiting (\d+)\n"
                r"longest wait of frame_buffer (\d+) cycles\n", text).groups())
            self.assertEqual((frame, stored), (cycles, pixels))
            self.assertTrue(0 < wait < frame)
            if interval == 40:  # too slow for the frame: it never waits
                self.assertTrue(pixels * interval + refresh < memory < pixels * interval + refresh + frame)
                self.assertGreater(waiting, pixels // 2)
            else:
                self.assertTrue(frame < memory < frame + 2 + 16)
        self.example("memory_port", scene, "0", code=USAGE)


tool.main()
