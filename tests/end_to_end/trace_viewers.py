# SPDX-License-Identifier: Apache-2.0
"""Programs of others read the traces, and find in them what the statistics say: GTKWave with its save file, fst2vcd,
vcd-stream, Perfetto's trace processor, speedscope. What is not installed (tools/setup test) is skipped."""

import collections
import contextlib
import ctypes
import json
import os
import pathlib
import re
import shutil
import subprocess
import unittest

import tool
from tool import MACHINES, SCENES
from viewers import CHROMIUM, PATIENCE, VIEWERS, node_modules

STATES = ("idle", "busy", "starved", "blocked")
NANOSECONDS = 5  # a cycle, at 200 MHz
FRAMES = ([SCENES / "keel.json", "--size", "32x24"],
          [SCENES / "shadows.json", "--size", "16x12", "--max-level", "2", "--machine", MACHINES / "wide.json"],
          [SCENES / "keel.json", "--size", "16x12", "--set", "fifos.all=1"])
PERFETTO = pathlib.Path("/usr/lib/chromium/libtest_trace_processor.so")


def needs(*programs):
    missing = [str(program) for program in programs if not shutil.which(program) and not pathlib.Path(program).exists()]
    return unittest.skipIf(missing, f"{', '.join(missing)}: not installed; tools/setup test does it")


def sums(changes, end):
    """Cycles of each value of a signal, of its changes (time, value)."""
    cycles = collections.Counter()
    for (begin, value), (next_begin, _) in zip(changes, [*changes[1:], (end, None)]):
        cycles[value] += (next_begin - begin) // NANOSECONDS
    return cycles


def value_changes(text):
    """Of a VCD: the set of ((time, name), value) where the value is another than before, and the end. Of several at one time
    the last is meant. A value of x is None; before its first one a signal has it."""
    header, body = text.split("$enddefinitions $end\n")
    names = {code: name for code, name in re.findall(r"^\$var reg \d+ (\S+) (\w+) ", header, re.M)}
    values, changes, now = {}, {}, 0
    for line in body.splitlines():
        if line.startswith("#"):
            now = int(line[1:])
        elif line[:1] in ("b", "0", "1", "x"):
            bits, code = line[1:].split() if line[0] == "b" else (line[0], line[1:])
            value = None if "x" in bits else int(bits, 2)
            if values.get(code) != value:
                values[code] = value
                changes[now, names[code]] = value
    return set(changes.items()), now


class PerfettoProcessor:
    """SQL on a trace by Perfetto's trace processor, as Debian's chromium-shell has it: a C++ class of a shared library, with
    strings and vectors of libc++."""

    CLASS = "4base4test22TestTraceProcessorImpl"
    STRING = "NSt3__112basic_stringIcNS2_11char_traitsIcEENS2_9allocatorIcEEEE"

    def __init__(self, data):
        library = ctypes.CDLL(str(PERFETTO))
        self._query = library[f"_ZNK{self.CLASS}12ExecuteQueryERK{self.STRING}"]
        create = library[f"_ZN{self.CLASS}C1Ev"]
        parse = library[f"_ZN{self.CLASS}10ParseTraceERKNSt3__16vectorIcNS2_9allocatorIcEEEE"]
        for function in (create, parse, self._query):
            function.restype = None  # what is returned is a class: its place is the first argument
        self._object = ctypes.create_string_buffer(256)
        create(self._object)
        begin = ctypes.addressof(bytes_of := ctypes.create_string_buffer(data, len(data)))
        vector = (ctypes.c_size_t * 3)(begin, begin + len(bytes_of), begin + len(bytes_of))
        parse(status := ctypes.create_string_buffer(8), self._object, vector)
        assert int.from_bytes(status.raw, "little") == 1, "the trace processor does not take the trace"

    def query(self, sql):
        """Rows of texts, without the names of the columns."""
        text = ctypes.create_string_buffer(sql.encode())
        string = (ctypes.c_size_t * 3)(len(text) | 1, len(text) - 1, ctypes.addressof(text))
        self._query(result := ctypes.create_string_buffer(48), self._object, string)
        rows, error = ctypes.addressof(result), self._text(ctypes.addressof(result) + 24)
        assert not error, error
        return [[self._text(cell) for cell in self._elements(row)] for row in self._elements(rows)][1:]

    @staticmethod
    def _elements(vector):
        begin, end = (ctypes.c_size_t * 2).from_address(vector)
        return range(begin, end, 24)

    @staticmethod
    def _text(string):
        """A short one stands in the string itself, behind twice its length."""
        first = ctypes.c_uint8.from_address(string).value
        _, size, data = (ctypes.c_size_t * 3).from_address(string)
        return (ctypes.string_at(data, size) if first & 1 else ctypes.string_at(string + 1, first >> 1)).decode()


@contextlib.contextmanager
def screen():
    """A display for programs with windows; its name."""
    reader, writer = os.pipe()
    with subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1600x1000x24", "-nolisten", "tcp"],
                          pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as server:
        os.close(writer)
        with open(reader, encoding="ascii") as number:
            display = f":{number.readline().strip()}"
        try:
            yield display
        finally:
            server.terminate()


class Viewers(tool.EndToEnd):
    def traced(self, frame, *endings):
        """The statistics; the traces are x.ENDING."""
        return self.stats("simulate", *frame, *(word for ending in endings for word in ("--trace", f"x.{ending}")))

    def program(self, *arguments, **environment):
        run = subprocess.run(list(map(str, arguments)), cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True,
                             encoding="utf-8", check=False, timeout=PATIENCE, env={**os.environ, **environment})
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def check_units(self, document, cycles_of):
        """`cycles_of`: cycles by state's name, of the unit of a name."""
        for unit in document["units"]:
            cycles = cycles_of(unit["name"])
            for state in STATES:
                self.assertEqual(cycles[state], unit[state], (unit["name"], state))

    def check_signals(self, document, changes, end):
        """`changes`: of the signals by name, with numbers as values, None for x; with details."""
        self.assertEqual(end, document["machine"]["cycles"] * NANOSECONDS)
        names = set()
        for unit in document["units"]:
            names |= {unit["name"] + suffix for suffix in ("", "_row", "_column", "_ray")}
        for fifo in document["fifos"]:
            names |= {fifo["name"] + suffix for suffix in ("", "_valid", "_ready")}
        self.assertEqual(set(changes), names)
        self.assertEqual([value for _, value in changes["view_vector_generator_ray"]],
                         [None, *range(document["rays"]["total"])])
        self.check_units(document, lambda name: collections.Counter(
            {STATES[value]: cycles for value, cycles in sums(changes[name], end).items()}))
        for fifo in document["fifos"]:
            cycles = sums(changes[fifo["name"]], end)
            self.assertEqual(max(value for value, length in cycles.items() if length > 0), fifo["max"], fifo["name"])
        # And what own eyes see in the same trace.
        seen = {(time, name): value for name, its in changes.items()
                for (_, before), (time, value) in zip([(0, None), *its], its) if value != before}
        self.assertEqual(set(seen.items()) ^ value_changes((self.folder / "x.vcd").read_text())[0], set())

    @needs("fst2vcd")
    def test_fst2vcd(self):
        """The `.fst` has the changes of the VCD, of all of a frame, of a part, and of a frame that was broken off."""
        for more in ([], ["--trace-from", "1000", "--trace-to", "2500", "--trace-unit", "[!s]*"], ["--set", "clock_mhz=333"],
                     ["--max-cycles", "3000"], ["--trace-detail"]):
            self.run_tool("simulate", *FRAMES[0], *more, "--trace", "x.vcd", "--trace", "x.fst")
            self.program("fst2vcd", "-f", "x.fst", "-o", "y.vcd")
            changes, end = value_changes((self.folder / "x.vcd").read_text())
            self.assertGreater(len(changes), 1000)
            again, its_end = value_changes((self.folder / "y.vcd").read_text())
            self.assertEqual(again ^ changes, set(), more)
            self.assertEqual(its_end, end)

    def test_fst_is_small(self):
        self.traced([SCENES / "keel.json", "--size", "640x480", "--max-level", "3"], "vcd", "fst")
        vcd, fst = ((self.folder / f"x.{ending}").stat().st_size for ending in ("vcd", "fst"))
        self.assertLess(20 * fst, vcd)

    @needs("gtkwave", "Xvfb")
    def test_gtkwave(self):
        """The save file shows every signal by its name, the states by theirs."""
        with screen() as display:
            for frame in FRAMES:
                document = self.traced([*frame, "--trace-detail"], "vcd", "fst", "gtkw")
                units, fifos = ([part["name"] for part in document[kind]] for kind in ("units", "fifos"))
                for ending in ("vcd", "fst"):
                    text = self.program("gtkwave", "-S", VIEWERS / "gtkwave.tcl", f"x.{ending}", "x.gtkw", DISPLAY=display,
                                        MARKER=str(document["machine"]["cycles"] * NANOSECONDS // 2))
                    lines = [line.split("\t") for line in text.splitlines()]
                    rows = {line[1]: line[2] for line in lines if line[0] == "ROW"}
                    self.assertEqual([line[1] for line in lines if line[0] == "ROW"],
                                     ["units", *(unit + suffix for unit in units for suffix in ("", "_row", "_column", "_ray")),
                                      "units",
                                      "FIFOs", *(fifo + suffix for fifo in fifos for suffix in ("", "_valid", "_ready")),
                                      "FIFOs"])
                    self.assertEqual({rows[name] for name in units} - set(STATES), set())
                    changes, end = {}, int(lines[-1][1])
                    for kind, name, words in (line[1:] for line in lines if line[0] == "CHANGES"):
                        words = words.split()  # beyond the end GTKWave has values of its own
                        values = [(int(time), value) for time, value in zip(words[::2], words[1::2]) if int(time) <= end]
                        if kind == "row" and name in units:
                            changes[name] = [(time, STATES.index(value.removeprefix("0x"))) for time, value in values]
                        signal = re.match(r"(?:processor\.)?(\w+)", name).group(1)
                        if kind == "signal" and signal not in units:
                            changes[signal] = [(time, None if "X" in value else int(value, 0)) for time, value in values]
                    self.check_signals(document, changes, end)

    @needs("node", "npm")
    def test_vcd_stream(self):
        modules = node_modules()
        for frame in FRAMES:
            document = self.traced([*frame, "--trace-detail"], "vcd")
            read = json.loads(self.program("node", VIEWERS / "vcd_stream.cjs", modules, self.folder / "x.vcd"))
            self.assertEqual(read["timescale"], "1 ns")
            self.check_signals(document, read["changes"], read["end"])

    @needs(PERFETTO)
    def test_perfetto(self):
        for frame in FRAMES:
            document = self.traced(frame, "pftrace")
            processor = PerfettoProcessor((self.folder / "x.pftrace").read_bytes())
            self.assertEqual(processor.query("SELECT name FROM stats WHERE severity != 'info' AND value > 0"), [])
            cycles = collections.Counter()
            for unit, state, length in processor.query("SELECT track.name, slice.name, SUM(dur) FROM slice "
                                                       "JOIN track ON track_id = track.id GROUP BY 1, 2"):
                cycles[unit, state] = int(length)
            self.check_units(document, lambda name: {state: cycles[name, state] for state in STATES})
            fills = {fifo: int(most) for fifo, most in processor.query(
                "SELECT name, CAST(MAX(value) AS INT) FROM counter "
                "JOIN counter_track ON track_id = counter_track.id GROUP BY 1")}
            for fifo in document["fifos"]:
                self.assertEqual(fills.get(fifo["name"], 0), fifo["max"], fifo["name"])
            [[rays, first, last]] = processor.query("SELECT COUNT(DISTINCT int_value), MIN(int_value), MAX(int_value) "
                                                    "FROM args WHERE key = 'debug.ray'")
            total = document["rays"]["total"]
            self.assertEqual((int(rays), int(first), int(last)), (total, 0, total - 1))
            # A flow of each ray: as many arrows as it has slices, less one.
            [[arrows]] = processor.query("SELECT COUNT(*) FROM flow")
            [[slices]] = processor.query("SELECT COUNT(*) FROM slice WHERE EXTRACT_ARG(arg_set_id, 'debug.ray') >= 0")
            self.assertEqual(int(arrows), int(slices) - total)

    @needs("node", "npm", CHROMIUM)
    def test_speedscope(self):
        modules = node_modules()
        for frame in FRAMES[:2]:
            document = self.traced(frame, "json")
            (browser := self.folder / "browser").mkdir(exist_ok=True)
            exported = json.loads(self.program("node", VIEWERS / "speedscope.cjs", modules, CHROMIUM,
                                               self.folder / "x.json", browser))
            frames = [part["name"] for part in exported["shared"]["frames"]]
            units, rays = {}, set()
            for profile in exported["profiles"]:
                cycles = units[re.search(r", (\w+) \(tid \d+\)$", profile["name"]).group(1)] = collections.Counter()
                for event in profile["events"]:
                    state, *details = frames[event["frame"]].split(" ", 1)
                    cycles[state] += event["at"] if event["type"] == "C" else -event["at"]
                    rays |= {json.loads(detail)["ray"] for detail in details}
            self.check_units(document, units.get)
            self.assertEqual(rays, set(range(document["rays"]["total"])))


tool.main()
