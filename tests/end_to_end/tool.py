# SPDX-License-Identifier: Apache-2.0
"""What the end-to-end tests share. A test is called with the pyrasim executable and the source directory."""

import hashlib
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

PYRASIM, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
SCENES = SOURCE / "scenes"
MACHINES = SOURCE / "machines"

OK, RUN_FAILED, USAGE, INPUT, LIMIT = range(5)

SCREEN = {"columns": 8, "rows": 6, "horizontal_fov": 40}
SPHERE = {"type": "sphere", "center": [10, 0, 0], "radius": 2, "color": [1, 0.5, 0.25]}


def scene(objects=(SPHERE,), **screen):
    """A scene document: `screen` over a small screen."""
    return {"camera": {"screen": {**SCREEN, **screen}}, "background": [0.125, 0.25, 0.5], "objects": list(objects)}


def without_comments(text):
    """JSON text without its // comments; a string that holds // stays."""
    return re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*', lambda match: match.group(1) or "", text)


def read_json(file):
    return json.loads(without_comments(pathlib.Path(file).read_text()))


def pfm_values(file):
    """All samples, in the order of read_pfm()."""
    samples = b"".join(read_pfm(file)[2])
    return struct.unpack(f"<{len(samples) // 4}f", samples)


def read_pfm(file):
    """Columns, rows and the rows of samples from the top, each as bytes of little-endian 32-bit floats."""
    data = pathlib.Path(file).read_bytes()
    magic, size, scale, samples = data.split(b"\n", 3)
    assert magic == b"PF" and float(scale) == -1
    columns, rows = map(int, size.split())
    assert len(samples) == columns * rows * 12
    return columns, rows, [samples[row * columns * 12 : (row + 1) * columns * 12] for row in reversed(range(rows))]


def sha256_of_pfm(file):
    return hashlib.sha256(b"".join(read_pfm(file)[2])).hexdigest()


def pixel_of_pfm(file, row, column):
    return struct.unpack_from("<3f", read_pfm(file)[2][row], column * 12)


def texts_of_png(file):
    """Keyword and text of each text chunk, which has to be ASCII (tEXt) or UTF-8 (iTXt)."""
    data = pathlib.Path(file).read_bytes()
    at = 8
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        content = data[at + 8 : at + 8 + length]
        if kind == b"tEXt":
            keyword, text = content.split(b"\0")
            yield keyword.decode("ascii"), text.decode("ascii")
        elif kind == b"iTXt":
            keyword, rest = content.split(b"\0", 1)
            yield keyword.decode("ascii"), rest[2:].split(b"\0", 2)[2].decode("utf-8")
        at += 12 + length


def varint(data, at):
    """The number that begins there, seven bits a byte, the lowest first; and where the next one does. Throws IndexError
    where it is cut."""
    value = shift = 0
    while True:
        byte = data[at]
        value |= (byte & 0x7F) << shift
        at, shift = at + 1, shift + 7
        if byte < 0x80:
            return value, at


def varint_of(value):
    """Its bytes, likewise."""
    data = b""
    while value >= 0x80:
        data += bytes([value & 0x7F | 0x80])
        value >>= 7
    return data + bytes([value])


PTRACE_MAGIC = b"pyrasim trace 1\n"


def ptrace_chunks(data):
    """The chunks of a .ptrace file, each as it stands there; the last one may be cut."""
    at = len(PTRACE_MAGIC)
    while at < len(data):
        length, content = varint(data, at + 1)
        yield data[at:content + length]
        at = content + length


def messages(stderr):
    """Its lines but those that tell how far a run of more than ten seconds is, as any may be on a busy machine."""
    return [line for line in stderr.splitlines() if not re.fullmatch(r"[a-z0-9 ]+: \d+ %", line)]


class EndToEnd(unittest.TestCase):
    """Runs pyrasim in a folder of its own."""

    maxDiff = None

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory(prefix="pyrasim_test_")
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)

    def write(self, name, content):
        """Writes a text, bytes or a JSON document into the folder; returns its path."""
        file = self.folder / name
        if isinstance(content, bytes):
            file.write_bytes(content)
        else:
            file.write_text(content if isinstance(content, str) else json.dumps(content))
        return file

    def run_tool(self, *arguments, stdout=subprocess.PIPE, timeout=120):
        """The finished process; stdout and stderr as text."""
        return subprocess.run(
            [PYRASIM, *map(os.fspath, map(self._text, arguments))],
            stdin=subprocess.DEVNULL, stdout=stdout, stderr=subprocess.PIPE, cwd=self.folder, timeout=timeout,
            encoding="utf-8", errors="replace", check=False)

    @staticmethod
    def _text(argument):
        return argument if isinstance(argument, (bytes, os.PathLike)) else str(argument)

    def ok(self, *arguments, warnings=0):
        """stdout of a run that has to work, with `warnings` lines on stderr."""
        run = self.run_tool(*arguments)
        self.assertEqual(run.returncode, OK, run.stderr)
        self.assertEqual(len(messages(run.stderr)), warnings, run.stderr)
        return run.stdout

    def memory(self, *arguments, code=OK):
        """The most that a run that ends with `code` takes, bytes; AddressSanitizer keeps little of what is freed."""
        environment = os.environ | {"ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":quarantine_size_mb=8"}
        process = subprocess.Popen([PYRASIM, *map(str, arguments)], stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL if code else None, cwd=self.folder, env=environment)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, code)
        return 1024 * usage.ru_maxrss

    def stats(self, *arguments):
        """The document of a run with --stats -; whatever table comes with it is on stderr."""
        run = self.run_tool(*arguments, "--stats", "-")
        self.assertEqual(run.returncode, OK, run.stderr)
        return json.loads(run.stdout)

    def refused(self, code, *arguments, says="", more_lines=False):
        """A run has to end with `code` and one line on stderr (more_lines: the first of several) that holds `says`;
        nothing on stdout, and the folder as it was."""
        before = self.listing()
        run = self.run_tool(*arguments)
        where = " ".join(map(str, arguments)) + "\n" + run.stdout + run.stderr
        self.assertEqual(run.returncode, code, where)
        self.assertEqual(run.stdout, "", where)
        lines = messages(run.stderr)
        self.assertTrue(run.stderr.endswith("\n"), where)
        self.assertTrue(len(lines) > 1 if more_lines else len(lines) == 1, where)
        self.assertTrue(lines[0].startswith("pyrasim: "), where)
        self.assertIn(says, lines[0], where)
        self.assertEqual(self.listing(), before, where)

    def formats(self):
        """The names of all number formats."""
        return re.findall(r"(?m)^(\w+(?:\.\d+)?) +\d+ +\d+ +\d+ +2\^", self.ok("formats"))

    def listing(self):
        return sorted(str(path) for path in self.folder.rglob("*"))


def main():
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
