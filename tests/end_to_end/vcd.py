# SPDX-License-Identifier: Apache-2.0
"""The trace, read by a reader of its own, says the same as the statistics."""

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
                bits, code = re.fullmatch(r"b([01]+) (\S+)", line).groups()
                changes = self.signals[names[code]]
                assert len(bits) <= self.widths[names[code]]
                assert dumping == (not changes), line  # each has one initial value, first
                changes.append((now, int(bits, 2)))
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

    def test_trace_is_the_statistics(self):
        keel, spheres = SCENES / "keel.json", SCENES / "spheres.json"
        self.check(keel, "--size", "32x24")
        self.check(keel, "--size", "24x18", "--machine", MACHINES / "small.json", "--max-level", "5")
        self.check(spheres, "--size", "24x18", "--machine", MACHINES / "wide.json", "--edge", "drop")
        self.check(spheres, "--size", "17x11", "--max-level", "0")
        self.check(keel, "--size", "16x12", "--set", "fifos.all=1", "--set", "frame_buffer.interval=7")
        self.check(SCENES / "fins.json", "--size", "1x1")
        self.check(self.write("empty.json", tool.scene([])))

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
