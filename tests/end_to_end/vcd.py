# SPDX-License-Identifier: Apache-2.0
"""The trace, read by a reader of its own, says the same as the statistics."""

import bisect
import collections
import os
import re
import subprocess
from fractions import Fraction

import tool
from tool import MACHINES, SCENES

UNITS = ("s", "ms", "us", "ns", "ps", "fs")
STATES = ("idle", "busy", "starved", "blocked")


class Vcd:
    """A value change dump (IEEE 1364-2005, clause 18) of vectors. `signals`: name to the list of (cycle, value)."""

    def __init__(self, text, clock_mhz):
        header, body = text.split("$enddefinitions $end\n")
        number, unit = re.search(r"^\$timescale (1|10|100) ([munpf]?s) \$end$", header, re.M).groups()
        self.unit = int(number) * Fraction(1, 10 ** (3 * UNITS.index(unit)))  # seconds
        self.period = 1 / (Fraction(clock_mhz) * 10**6)  # seconds
        self.scopes = re.findall(r"^\$scope module (\w+) \$end$", header, re.M)
        self.widths, self.signals, names = {}, {}, {}
        for kind, width, code, name, high in re.findall(r"^\$var (\w+) (\d+) (\S+) (\w+) \[(\d+):0\] \$end$", header,
                                                        re.M):
            assert kind == "reg" and int(high) == int(width) - 1
            assert code not in names and name not in self.signals
            names[code], self.widths[name], self.signals[name] = name, int(width), []
        assert len(names) == header.count("$var") and header.count("$scope") == header.count("$upscope")
        now, dumping = None, False
        for line in body.splitlines():
            if line.startswith("#"):
                cycle = self.cycle(int(line[1:]))
                assert now is None and cycle == 0 or cycle > now, (now, line)
                now = cycle
            elif line in ("$dumpvars", "$end"):
                assert now == 0
                dumping = line == "$dumpvars"
            else:
                bits, code = re.fullmatch(r"b(x|[01]+) (\S+)", line).groups()
                changes = self.signals[names[code]]
                assert len(bits) <= self.widths[names[code]]
                assert dumping == (not changes), line  # each has one initial value, first
                changes.append((now, None if bits == "x" else int(bits, 2)))
        self.end = now

    def cycle(self, time):
        """The one that begins at `time`, in units."""
        cycle = round(time * self.unit / self.period)
        assert abs(cycle * self.period - time * self.unit) <= self.unit / 2, time
        return cycle

    def spans(self, name):
        """(value, cycles) one after the other, to the end of the trace."""
        changes = self.signals[name]
        ends = [time for time, _ in changes[1:]] + [self.end]
        return [(value, end - time) for (time, value), end in zip(changes, ends)]


class Trace(tool.EndToEnd):
    def check(self, *arguments):
        texts = []
        for engine in ("decoupled", "lockstep"):
            trace, stats = self.folder / f"{engine}.vcd", self.folder / f"{engine}.json"
            self.ok("simulate", *arguments, "--engine", engine, "--trace", trace, "--stats", stats)
            texts.append(trace.read_text())
            document = tool.read_json(stats)
        self.assertEqual(*texts)
        vcd = Vcd(texts[0], document["machine"]["clock_mhz"])
        self.assertEqual(len(vcd.scopes), 1)
        self.assertEqual(vcd.end, document["machine"]["cycles"])
        self.assertEqual(list(vcd.signals), [part["name"] for part in document["units"] + document["fifos"]])
        for unit in document["units"]:
            cycles = dict.fromkeys(STATES, 0)
            for value, length in vcd.spans(unit["name"]):
                cycles[STATES[value]] += length
            self.assertEqual({"name": unit["name"], **cycles, "waits": unit["waits"]}, unit)
        for fifo in document["fifos"]:
            spans = vcd.spans(fifo["name"])
            where = (fifo["name"], arguments)
            self.assertEqual(max(value for value, length in spans if length > 0), fifo["max"], where)
            self.assertAlmostEqual(sum(value * length for value, length in spans) / vcd.end, fifo["mean"], 9, where)
            self.assertLess(fifo["depth"], 2 ** vcd.widths[fifo["name"]])
        return document

    def test_trace_is_the_statistics(self):
        keel, spheres = SCENES / "keel.json", SCENES / "spheres.json"
        self.check(keel, "--size", "32x24")
        self.check(keel, "--size", "24x18", "--machine", MACHINES / "small.json", "--max-level", "5")
        self.check(spheres, "--size", "24x18", "--machine", MACHINES / "wide.json", "--edge", "drop")
        self.check(spheres, "--size", "17x11", "--max-level", "0")
        self.check(keel, "--size", "16x12", "--set", "fifos.all=1", "--set", "frame_buffer.interval=7")
        self.check(SCENES / "fins.json", "--size", "1x1")
        self.check(self.write("empty.json", tool.scene([])))

    def test_details(self):
        """What units work on is what `.json` says; rays are issued in order, each pixel is stored once; FIFOs are valid while
        there is a token to be read, ready while there is room."""
        for machine in ("small.json", "wide.json"):
            document = self.stats("simulate", SCENES / "shadows.json", "--size", "24x18", "--window", "3,5,12,9", "--machine",
                                  MACHINES / machine, "--trace-detail", "--trace", "x.vcd", "--trace", "x.json")
            vcd = Vcd((self.folder / "x.vcd").read_text(), document["machine"]["clock_mhz"])
            plain = [part["name"] for part in document["units"] + document["fifos"]]
            self.assertEqual(list(vcd.signals), plain + [f"{unit['name']}_{part}" for unit in document["units"]
                                                         for part in ("row", "column", "ray")]
                             + [f"{fifo['name']}_{part}" for fifo in document["fifos"] for part in ("valid", "ready")])
            self.assertEqual([value for _, value in vcd.signals["view_vector_generator_ray"]],
                             [None, *range(document["rays"]["total"])])
            row, column, places = None, None, set()
            changes = collections.defaultdict(dict)
            for part in ("row", "column"):
                for time, value in vcd.signals[f"frame_buffer_{part}"]:
                    changes[time][part] = value
            for time in sorted(changes):
                row, column = changes[time].get("row", row), changes[time].get("column", column)
                self.assertNotIn((row, column), places)
                places.add((row, column))
            self.assertEqual(places, {(None, None), *((5 + row, 3 + column) for row in range(9) for column in range(12))})
            slices = [event for event in tool.read_json(self.folder / "x.json") if "ray" in event.get("args", {})]
            self.assertGreater(len(slices), 1000)
            names = [unit["name"] for unit in document["units"]]
            for event in slices:
                rays = vcd.signals[f"{names[event['tid'] - 1]}_ray"]
                self.assertEqual(rays[bisect.bisect(rays, event["ts"], key=lambda change: change[0]) - 1][1],
                                 event["args"]["ray"], event)

    def test_details_want_a_waveform(self):
        for files in ([], ["--trace", "x.json"]):
            self.refused(tool.USAGE, "simulate", SCENES / "keel.json", "--trace-detail", *files,
                         says="--trace-detail goes with --trace FILE.vcd, FILE.fst or FILE.gtkw")

    def test_time_is_the_clocks(self):
        """The unit is as stated, exact where a cycle is a whole number of it, and never off by more than a half."""
        for clock, unit, dates in ((200, "1 ns", 5), (1000, "1 ns", 1), (1, "1 us", 1), (400, "100 ps", 25),
                                   (0.001, "1 ms", 1), (333, "1 fs", None), (0.3, "1 ps", None)):
            document = self.check(SCENES / "keel.json", "--size", "16x12", "--set", f"clock_mhz={clock}")
            text = (self.folder / "decoupled.vcd").read_text()
            self.assertIn(f"\n$timescale {unit} $end\n", text)
            if dates:
                last = re.findall("^#([0-9]+)$", text, re.M)[-1]
                self.assertEqual(int(last), document["machine"]["cycles"] * dates)

    def test_pipes_and_descriptors(self):
        """What cannot be written twice gets the same bytes."""
        arguments = ["simulate", SCENES / "keel.json", "--size", "64x48"]
        self.ok(*arguments, "--trace", "out.vcd")
        expected = (self.folder / "out.vcd").read_text()
        self.assertGreater(len(expected), 10 * 65536)
        self.assertEqual(self.run_tool(*arguments, "--trace", "-").stdout, expected)
        self.assertTrue(self.run_tool(*arguments, "--trace", "/dev/stdout").stdout.startswith(expected))
        self.assertEqual([file.name for file in self.folder.iterdir()], ["out.vcd"])

    def test_memory_does_not_grow_with_the_frame(self):
        """Ten times the rows are a hundred megabytes more of trace, and some of picture in memory."""
        for name in ("out.vcd", "out.fst", "-"):
            arguments = ["simulate", SCENES / "keel.json", "--trace", name, "--threads", "1", "--size"]
            low, high = (self.memory(*arguments, f"320x{rows}") for rows in (200, 2000))
            self.assertLess(high - low, 48e6)

    def test_of_a_frame_that_is_not_finished(self):
        """It reaches to where the frame was broken off; there is none where the disk is full."""
        for engine in ("decoupled", "lockstep"):
            arguments = ["simulate", SCENES / "keel.json", "--size", "64x48", "--engine", engine]
            cycles = self.stats(*arguments)["machine"]["cycles"]
            before = sorted(self.folder.iterdir())
            for name in ("out.vcd", "-", "/dev/stdout"):
                run = self.run_tool(*arguments, "--max-cycles", cycles - 1, "--trace", name)
                self.assertEqual(run.returncode, tool.LIMIT)
                file = self.folder / name
                vcd = Vcd(file.read_text() if name == "out.vcd" else run.stdout, 200)
                self.assertTrue(0.9 * cycles < vcd.end <= cycles + 100, vcd.end)
            (self.folder / "out.vcd").unlink()
            for name, says in (("out.vcd", "out.vcd"), ("out.fst", str(self.folder)), ("-", str(self.folder))):
                run = subprocess.run(["sh", "-c", 'trap "" XFSZ; ulimit -f 100; exec "$0" "$@"', tool.PYRASIM,
                                      *map(str, arguments), "--trace", name], stdin=subprocess.DEVNULL, timeout=60,
                                     capture_output=True, encoding="utf-8", cwd=self.folder, check=False,
                                     env={**os.environ, "TMPDIR": str(self.folder)})
                self.assertEqual((run.returncode, run.stdout), (tool.RUN_FAILED, ""))
                # AddressSanitizer may have its say before: it does not know the stacks of the simulation's coroutines.
                *before_it, last = run.stderr.splitlines()
                self.assertEqual(last, f"pyrasim: {says}: cannot write: File too large")
                self.assertFalse([line for line in before_it if line.startswith("pyrasim")])
            self.assertEqual(sorted(self.folder.iterdir()), before)

    def test_stdout(self):
        run = self.run_tool("simulate", SCENES / "keel.json", "--size", "16x12", "--trace", "-")
        self.assertEqual(run.returncode, tool.OK)
        self.assertIn("cycles", run.stderr)
        self.ok("simulate", SCENES / "keel.json", "--size", "16x12", "--trace", "out.vcd")
        self.assertEqual(run.stdout, (self.folder / "out.vcd").read_text())
        self.assertGreater(Vcd(run.stdout, 200).end, 0)

    def test_trace_changes_nothing(self):
        arguments = ["simulate", SCENES / "keel.json", "--size", "32x24"]
        plain, traced = self.stats(*arguments), self.stats(*arguments, "--trace", "out.vcd")
        self.assertEqual({**traced, "command": ""}, {**plain, "command": ""})


tool.main()
