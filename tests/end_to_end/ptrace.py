# SPDX-License-Identifier: Apache-2.0
"""The program's own trace, read by a reader made from docs/ptrace.md alone: its rays, nodes and picture add up to the
statistics, and what is left of a run that was broken off can be read up to where it came."""

import collections
import json
import signal
import subprocess
import time
import zlib

import tool
from settings import SHADOWED, TEXTURED
from tool import MACHINES, SCENES


def chunks(data):
    """Type and content of each whole chunk."""
    assert data.startswith(tool.PTRACE_MAGIC)
    at = len(tool.PTRACE_MAGIC)
    while at < len(data):
        kind = chr(data[at])
        try:
            length, at = tool.varint(data, at + 1)
        except IndexError:
            return
        content, at = data[at:at + length], at + length
        if at > len(data):
            return
        yield kind, content if kind in "HI" else zlib.decompress(content)


def table(content, columns):
    """The rows of a chunk of rays or nodes."""
    count, at = tool.varint(content, 0)
    numbers = []
    for _ in columns:
        column, value = [], 0
        for _ in range(count):
            difference, at = tool.varint(content, at)
            value += difference >> 1 ^ -(difference & 1)
            column.append(value)
        numbers.append(column)
    assert at == len(content)
    return [dict(zip(columns, row)) for row in zip(*numbers)]


class Trace:
    def __init__(self, file):
        self.order, self.rays, self.nodes, self.end, self.image = "", [], [], None, None
        for kind, content in chunks(file.read_bytes()):
            self.order += kind
            if kind == "H":
                self.header = json.loads(content)
                columns = self.header["columns"]
            elif kind == "R":
                self.rays += table(content, columns["rays"])
            elif kind == "N":
                self.nodes += table(content, columns["nodes"])
            elif kind == "I":
                self.image = content
            elif kind == "Z":
                self.end = json.loads(content)


def sums(rows, prefix=""):
    """Box and surface tests of the columns that begin with `prefix`, as the statistics have them."""
    total = collections.Counter()
    for row in rows:
        total.update({name: value for name, value in row.items()
                      if name.removeprefix(prefix).startswith(("box_tests", "surface_tests."))
                      and name.startswith(prefix)})
    return {name.removeprefix(prefix): value for name, value in total.items() if value}


def flat(work):
    counts = {"box_tests": work["box_tests"], **{f"surface_tests.{kind}": n for kind, n in work["surface_tests"].items()}}
    return {name: value for name, value in counts.items() if value}


class PTrace(tool.EndToEnd):
    def traced(self, *arguments):
        stats = self.stats("simulate", *arguments, "--trace", "a.ptrace", "-o", "a.png")
        return Trace(self.folder / "a.ptrace"), stats

    def test_rays_nodes_and_picture_are_those_of_the_run(self):
        self.write("shadowed.json", SHADOWED)
        self.write("textured.json", TEXTURED)
        for arguments in ([SCENES / "keel.json", "--size", "64x48"],
                          [SCENES / "keel.json", "--size", "64x48", "--window", "20,10,30,20", "--engine", "lockstep"],
                          ["shadowed.json", "--machine", MACHINES / "wide.json", "--threads", "2"],
                          ["textured.json", "--max-level", "2", "--scalar", "fp24", "--edge", "drop"]):
            with self.subTest(arguments):
                trace, stats = self.traced(*arguments)
                self.assertEqual(len(trace.rays), stats["rays"]["total"])
                self.assertEqual(sums(trace.rays), flat(stats["work"]))
                self.assertEqual(sums(trace.rays, "shadow."), flat(stats["work"]["shadow"]))
                by_light = [sum(row[f"shadow.rays.{light}"] for row in trace.rays)
                            for light in range(len(stats["rays"]["shadow"]["by_light"]))]
                self.assertEqual(by_light, stats["rays"]["shadow"]["by_light"])
                for name, total in stats["work"]["texture"].items():
                    self.assertEqual(sum(node[name] for node in trace.nodes), total)
                self.assertEqual(trace.image[:8], b"\x89PNG\r\n\x1a\n")
                self.assertRegex(trace.order, r"\AH(R|N)+IZ\Z")
                end = trace.end
                self.assertEqual((end["complete"], end["cycles"], end["rays"], end["nodes"], end["image_sha256"]),
                                 (True, stats["machine"]["cycles"], len(trace.rays), len(trace.nodes),
                                  stats["image"]["sha256"]))
                for stage, events in stats.get("arithmetic", {}).items():
                    self.assertEqual(end["arithmetic"][stage], events)
                header = trace.header
                self.assertEqual({**header["run"]["machine"], "name": ""},
                                 {**stats["machine"]["settings"], "name": ""})
                self.assertEqual([stage["name"] for stage in header["stages"]], stats["machine"]["elaborated"])
                self.assertEqual([(fifo["name"], fifo["depth"]) for fifo in header["fifos"]],
                                 [(fifo["name"], fifo["depth"]) for fifo in stats["fifos"]])

    def test_corners_see_what_makes_the_cases(self):
        """The grid of corners, classified here: as many edges among pixels as the statistics count."""
        trace, stats = self.traced(SCENES / "keel.json", "--size", "64x48", "--max-level", "1")
        seen = {(row["row"], row["column"]): row["object"] for row in trace.rays}
        cases = collections.Counter()
        for row in range(0, 96, 2):
            for column in range(0, 128, 2):
                corners = {seen[row + down, column + right] for down in (0, 2) for right in (0, 2)}
                cases["edge" if len(corners) > 1 else "covered" if min(corners) else "empty"] += 1
        self.assertEqual(cases, collections.Counter(stats["cases"]["by_level"][0]))
        self.assertEqual(max(seen.values()), len(trace.header["run"]["objects"]))

    def test_does_not_depend_on_engine_threads_and_machine(self):
        """But for the order, the same rays."""
        kinds = []
        for more in ([], ["--threads", "4"], ["--engine", "lockstep"], ["--machine", MACHINES / "small.json"]):
            trace, _ = self.traced(SCENES / "fins.json", "--size", "40x30", *more)
            kinds.append(collections.Counter(tuple(row.values()) for row in trace.rays))
        self.assertTrue(all(rays == kinds[0] for rays in kinds))

    def test_changes_no_cycle(self):
        _, traced = self.traced(SCENES / "shadows.json", "--size", "40x30")
        plain = self.stats("simulate", SCENES / "shadows.json", "--size", "40x30")
        self.assertEqual({**traced, "command": ""}, {**plain, "command": ""})

    def test_broken_off(self):
        """At --max-cycles there is an end that says so; killed, whole chunks are left."""
        run = self.run_tool("simulate", SCENES / "keel.json", "--size", "64x48", "--max-cycles", "9000", "--trace",
                            "a.ptrace")
        self.assertEqual(run.returncode, tool.LIMIT)
        trace = Trace(self.folder / "a.ptrace")
        self.assertEqual((trace.end["complete"], trace.end["rays"]), (False, len(trace.rays)))
        self.assertGreater(len(trace.rays), 0)
        self.assertLess(len(trace.rays), 64 * 48)

        with subprocess.Popen([tool.PYRASIM, "simulate", SCENES / "keel.json", "--size", "4000x3000", "--trace",
                               "killed.ptrace"], cwd=self.folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as process:
            file = self.folder / "killed.ptrace"
            while process.poll() is None and (not file.exists() or file.stat().st_size < 200_000):
                time.sleep(0.01)
            process.send_signal(signal.SIGKILL)
        self.assertEqual(process.returncode, -signal.SIGKILL)
        trace = Trace(file)
        self.assertEqual(trace.end, None)
        self.assertEqual(len(trace.rays) % 65536, 0)
        self.assertGreater(len(trace.rays), 0)
        self.refused(tool.INPUT, "whatif", "killed.ptrace",
                     says=f"killed.ptrace: the run was broken off, {len(trace.rays)} rays are recorded; a trace of a whole")


if __name__ == "__main__":
    tool.main()
