# SPDX-License-Identifier: Apache-2.0
"""Traces of all formats, read by readers of their own, say the same as the statistics; their windows; and what is left of
runs that were broken off."""

import collections
import json
import re
import signal
import struct
import subprocess
import time
from random import Random

import tool
from tool import MACHINES, SCENES, USAGE

STATES = ("busy", "starved", "blocked")
FRAMES = ([SCENES / "keel.json", "--size", "32x24"],
          [SCENES / "shadows.json", "--size", "24x18", "--machine", MACHINES / "wide.json"],
          [SCENES / "buoys.json", "--size", "16x12", "--max-level", "1", "--machine", MACHINES / "small.json"])


class Timeline:
    """Slices (unit, state, begin, end, ray) and fills of FIFOs (cycle, tokens), by name."""

    def __init__(self):
        self.slices, self.fills = [], collections.defaultdict(list)

    def cycles(self):
        """By unit and state."""
        sums = collections.Counter()
        for name, state, begin, end, _ in self.slices:
            sums[name, state] += end - begin
        return sums

    def rays(self):
        return {ray for *_, ray in self.slices if ray is not None}

    def window(self, first, last):
        """The slices cut to a window."""
        return sorted((name, state, max(begin, first), min(end, last), -1 if ray is None else ray)
                      for name, state, begin, end, ray in self.slices if begin < last and end > first)

    def all(self):
        return self.window(0, float("inf"))


def fields(data):
    """Number and value of each field of a message of Protocol Buffers; of one that is cut short, those that are whole."""
    at = 0
    while at < len(data):
        try:
            (key, at), value = tool.varint(data, at), None
            if key & 7 == 0:
                value, at = tool.varint(data, at)
            elif key & 7 == 1:
                value = struct.unpack_from("<Q", data, at)[0]
                at += 8
            else:
                assert key & 7 == 2
                size, at = tool.varint(data, at)
                value = data[at:at + size]
                at += size
        except (IndexError, struct.error):
            return
        if at > len(data):
            return
        yield key >> 3, value


def read_perfetto(data):
    """By perfetto/protos/perfetto/trace: packets with descriptors of tracks, names, and events."""
    timeline, tracks, counters, names, notes, open_slices = Timeline(), {}, set(), {}, {}, {}
    for _, packet in fields(data):
        packet = dict(fields(packet))
        assert packet[10] == 1
        if 12 in packet:  # interned data
            assert packet[13] == 1
            for kind, entry in fields(packet[12]):
                entry = dict(fields(entry))
                (names if kind == 2 else notes)[entry[1]] = entry[2].decode()
        if 60 in packet:  # a track
            track = dict(fields(packet[60]))
            if 3 not in track:
                assert track[5] == 1
                tracks[track[1]] = track[2].decode()
                if 8 in track:
                    counters.add(track[1])
        if 11 in packet:
            event = collections.defaultdict(list)
            for number, value in fields(packet[11]):
                event[number].append(value)
            track, at = event[11][0], packet[8]
            if event[9] == [4]:
                assert track in counters
                timeline.fills[tracks[track]].append((at, event[30][0]))
            elif event[9] == [1]:
                annotations = {notes[note[1]]: note[3] for note in map(dict, map(fields, event[4]))}
                ray = annotations.get("ray")
                assert event[47] == ([] if ray is None else [ray + 1]) and track not in open_slices
                name = event[23][0].decode() if event[23] else names[event[10][0]]
                open_slices[track] = (name, at, ray)
            else:
                assert event[9] == [2]
                state, begin, ray = open_slices.pop(track)
                timeline.slices.append((tracks[track], state, begin, at, ray))
    return timeline


def read_chrome(data):
    """By the Trace Event Format: complete events, counters, and names of threads."""
    text = data.decode().rstrip()
    timeline, threads = Timeline(), {}
    if not text.endswith("]"):  # it was killed, perhaps within a record
        text = text[:text.rindex(",\n")] + "]"
    for event in json.loads(text):
        if event["ph"] == "M" and event["name"] == "thread_name":
            threads[event["tid"]] = event["args"]["name"]
        elif event["ph"] == "X":
            timeline.slices.append((threads[event["tid"]], event["name"], event["ts"], event["ts"] + event["dur"],
                                    event.get("args", {}).get("ray")))
        elif event["ph"] == "C":
            timeline.fills[event["name"]].append((event["ts"], event["args"]["tokens"]))
    return timeline


class Kanata:
    """By the description of the log format of Konata. `rows`: by row the list of (stage, begin, end), `arrows`: pairs of
    rows, from one to another that begins just then."""

    def __init__(self, text):
        lines = text.splitlines()
        assert lines[0] == "Kanata\t0004" and lines[1].startswith("C=\t")
        self.rows, self.labels, self.arrows, self.flushed = {}, {}, [], 0
        now, inside, retired = int(lines[1].split("\t")[1]), {}, set()
        for line in lines[2:]:
            command, *words = line.split("\t")
            if command == "C":
                assert int(words[0]) > 0
                now += int(words[0])
            elif command == "I":
                row, ray, thread = map(int, words)
                assert row == len(self.rows) and thread == 0
                self.rows[row] = []
            elif command == "L":
                self.labels[int(words[0])] = words[2]
            elif command == "S":
                row, lane, stage = int(words[0]), *words[1:]
                assert lane == ("1" if "_to_" in stage else "0") and row not in inside and row not in retired
                inside[row] = (stage, now)
            elif command == "E":
                row, lane, stage = int(words[0]), *words[1:]
                its, begin = inside.pop(row)
                assert its == stage
                self.rows[row].append((stage, begin, now))
            elif command == "W":
                consumer, producer, kind = map(int, words)
                assert kind == 0 and consumer in inside and producer < consumer
                self.arrows.append((producer, consumer))
            else:
                assert command == "R", line
                row, number, flush = map(int, words)
                assert row not in inside and number == len(retired)
                retired.add(row)
                self.flushed += flush
        assert retired == set(self.rows)


READERS = {"pftrace": read_perfetto, "json": read_chrome}


class Traces(tool.EndToEnd):
    def traced(self, *arguments, formats=("pftrace", "json", "kanata"), **names):
        traces = [word for ending in formats for word in ("--trace", f"x.{ending}")]
        document = self.stats("simulate", *arguments, *traces)
        return document, {ending: (self.folder / f"x.{ending}").read_bytes() for ending in formats}

    def test_sums_are_those_of_the_statistics(self):
        for frame in FRAMES:
            document, traces = self.traced(*frame)
            for ending, read in READERS.items():
                timeline = read(traces[ending])
                self.assertEqual({name for name, *_ in timeline.slices}, {unit["name"] for unit in document["units"]})
                cycles = timeline.cycles()
                for unit in document["units"]:
                    for state in STATES:
                        self.assertEqual(cycles[unit["name"], state], unit[state], (ending, unit["name"], state))
                for fifo in document["fifos"]:
                    fills = [tokens for _, tokens in timeline.fills[fifo["name"]]]
                    self.assertEqual(max(fills, default=0), fifo["max"] if fills else 0, (ending, fifo["name"]))
                self.assertEqual(timeline.rays(), set(range(document["rays"]["total"])))
            kanata = Kanata(traces["kanata"].decode())
            self.assertEqual(len(kanata.rows), document["rays"]["total"])
            self.assertEqual(kanata.flushed, 0)
            requests = {label for label in kanata.labels.values() if "request" in label}
            self.assertEqual(len(requests), document["rays"]["subdivision"])

    def test_arrows_lead_from_the_ray_that_completed_a_node_to_those_that_split_it(self):
        for frame in FRAMES:
            kanata = Kanata(self.traced(*frame, formats=("kanata",))[1]["kanata"].decode())
            requests = {row: int(label.split()[-1]) for row, label in kanata.labels.items() if "request" in label}
            producers = dict((consumer, producer) for producer, consumer in kanata.arrows)
            self.assertEqual(len(kanata.arrows), len(requests))
            self.assertEqual(set(producers), set(requests))
            self.assertEqual(len(set(zip(map(producers.get, requests), requests.values()))), len(set(requests.values())))
            for consumer, producer in producers.items():
                stage, begin, _ = kanata.rows[producer][-1]
                self.assertEqual(stage, "pyramid_classifier")
                self.assertLess(begin, kanata.rows[consumer][0][1])

    def test_a_rays_life_has_no_gaps(self):
        """Each row goes on where its last stage ended; a ray's units are those that the timeline shows."""
        for frame in FRAMES:
            _, traces = self.traced(*frame)
            kanata, timeline = Kanata(traces["kanata"].decode()), read_perfetto(traces["pftrace"])
            units = collections.defaultdict(list)
            for name, state, begin, _, ray in timeline.slices:
                if ray is not None and state == "busy":
                    units[ray].append((begin, name))
            for row, stages in kanata.rows.items():
                ray = int(kanata.labels[row].split()[1])
                for (_, _, end), (_, begin, _) in zip(stages, stages[1:]):
                    self.assertEqual(end, begin)
                self.assertTrue(all(begin < end for stage, begin, end in stages if "_to_" not in stage), stages)
                served = [(begin, stage) for stage, begin, _ in stages if "_to_" not in stage]
                self.assertEqual(served, sorted(units[ray])[:len(served)])

    def test_engines_write_the_same(self):
        formats = ("fst", "pftrace", "json", "kanata")
        for frame in FRAMES[:2]:
            bytes_of = [self.traced(*frame, "--engine", engine, formats=formats)[1] for engine in ("decoupled", "lockstep")]
            self.assertEqual(*bytes_of)

    def test_windows(self):
        frame, first, last = FRAMES[0], 1000, 2500
        whole = read_chrome(self.traced(*frame)[1]["json"])
        _, traces = self.traced(*frame, "--trace-from", first, "--trace-to", last)
        for ending, read in READERS.items():
            part = read(traces[ending])
            self.assertEqual(part.all(), whole.window(first, last))
            for name, fills in whole.fills.items():
                before = [tokens for at, tokens in fills if at <= first][-1]
                self.assertEqual(part.fills[name], [(first, before)] + [fill for fill in fills if first < fill[0] < last], name)
        for stages in Kanata(traces["kanata"].decode()).rows.values():
            self.assertTrue(first <= stages[0][1] < last)
        document, traces = self.traced(*frame, "--trace-unit", "inter*unit*", "--trace-unit", "color_unit")
        shown = {unit["name"] for unit in document["units"] if unit["name"].startswith("inter")} | {"color_unit"}
        for ending, read in READERS.items():
            self.assertEqual({name for name, *_ in read(traces[ending]).slices}, shown)

    def test_pixels(self):
        """The pixel's own rays and nodes, as in the whole trace, and FIFOs that hold nothing else."""
        for frame in FRAMES:
            document = self.stats("simulate", *frame, "--map", "rays=rays.pfm", "--trace", "whole.json")
            whole = read_chrome((self.folder / "whole.json").read_bytes())
            row, column = (document["pixel_latency"]["slowest"][0][key] for key in ("row", "column"))
            _, traces = self.traced(*frame, "--trace-pixel", f"{row},{column}")
            kanata = Kanata(traces["kanata"].decode())
            rays = int(tool.pixel_of_pfm(self.folder / "rays.pfm", row, column)[0])
            self.assertEqual(len(kanata.rows), rays)
            for ending, read in READERS.items():
                part = read(traces[ending])
                shown = {its for its in part.slices if its[1] != "idle"}
                self.assertEqual(len(part.rays()), rays)
                self.assertEqual({its[4] for its in shown if its[0] == "view_vector_generator"}, part.rays())
                self.assertLess(shown, set(whole.slices))
                self.assertEqual({its for its in whole.slices if its[4] in part.rays()}, {its for its in shown if its[4] is not None})
                for name in ("color_unit", "tree_accumulator"):
                    self.assertEqual(sum(its[0] == name for its in shown), 1 + 3 * (rays - 1) // 5)
                self.assertEqual(sum(its[0] == "frame_buffer" for its in shown), 1)
                for name, fills in part.fills.items():
                    self.assertEqual(fills[-1][1], 0, name)
                    self.assertTrue(all(tokens >= 0 for _, tokens in fills))
        keel = ["simulate", *FRAMES[0], "--trace", "x.json", "--trace-pixel"]
        self.refused(USAGE, *keel, "24,0", says="--trace-pixel: row 24: a whole number from 0 to 23 is allowed")
        self.refused(USAGE, *keel, "1", says="--trace-pixel 1: ROW,COLUMN is allowed")

    def test_critical_path(self):
        """A track whose stretches follow each other, with the sums of the statistics."""
        for frame in FRAMES:
            document, traces = self.traced(*frame, "--critical-path", formats=("pftrace", "json"))
            sums = collections.Counter()
            for part in document["bottleneck"]["critical_path"]:
                word = {"room": "in"}.get(part["owed"], "of")
                name = f"{part['owed']} {word} {part['place']}" if part["owed"] != "occupied" else f"{part['place']} occupied"
                sums[name] += part["cycles"]
            for ending, read in READERS.items():
                path = sorted((its for its in read(traces[ending]).slices if its[0] == "critical path"), key=lambda its: its[2])
                self.assertEqual(path[0][2], 0)
                self.assertEqual(path[-1][3], document["machine"]["cycles"])
                self.assertTrue(all(one[3] == other[2] and one[1] != other[1] for one, other in zip(path, path[1:])))
                found = collections.Counter()
                for _, owed, begin, end, _ in path:
                    found[owed] += end - begin
                self.assertEqual(found, sums)

    def test_windows_of_vcd(self):
        """What is shown of a window is what the whole trace shows there, however little happens before and in it."""
        def changes(name):
            header, body = (self.folder / name).read_text().split("$enddefinitions $end\n")
            codes = {words[3]: words[4] for words in map(str.split, header.splitlines()) if words[:1] == ["$var"]}
            values, now = collections.defaultdict(dict), 0
            for line in body.splitlines():
                if line.startswith("#"):
                    now = int(line[1:]) // 5  # of 200 MHz, in ns
                elif line.startswith("b"):
                    bits, code = line[1:].split()
                    values[codes[code]][now] = bits.lstrip("0")
            return values, now

        def values(changes, first, last):
            """In each cycle of the window."""
            now = changes[max(date for date in changes if date <= first)]
            return [now := changes.get(at, now) for at in range(first, last)]

        def check(first, last, *patterns):
            self.ok("simulate", *FRAMES[0], "--trace", "part.vcd", "--trace-from", first, "--trace-to", last,
                    "--trace-detail", *(word for pattern in patterns for word in ("--trace-unit", pattern)))
            part, end = changes("part.vcd")
            self.assertEqual(end, last)
            for name, its in part.items():
                self.assertEqual(min(its), first)
                self.assertEqual(values(its, first, last), values(whole[name], first, last), (first, name))
            return set(part)

        self.ok("simulate", *FRAMES[0], "--trace", "whole.vcd", "--trace-detail")
        whole, end = changes("whole.vcd")
        self.assertEqual(check(1000, 2500, "[!s]*"), {name for name in whole if not name.startswith("s")})
        random = Random(7)
        for name in ("tree_accumulator", "pyramid_classifier", "pixel_scan", "subdivision_controller", "frame_buffer"):
            for _ in range(5):
                first = random.randrange(end - 50)
                self.assertEqual(check(first, first + 50, name), {name + suffix for suffix in ("", "_row", "_column", "_ray")})

    def broken_off(self, number):
        """A run that a signal ends; its traces by ending."""
        traces = [word for ending in ("vcd", "fst", "pftrace", "json", "kanata") for word in ("--trace", f"x.{ending}")]
        with subprocess.Popen([tool.PYRASIM, "simulate", SCENES / "keel.json", "--size", "2000x1500", *traces],
                              cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            file = self.folder / "x.json"
            for _ in range(12_000):
                if file.exists() and file.stat().st_size > 1_000_000:
                    break
                time.sleep(0.01)
            process.send_signal(number)
            process.communicate(timeout=120)
        return process.returncode

    def test_interrupted(self):
        self.assertEqual(self.broken_off(signal.SIGINT), 128 + signal.SIGINT)
        for ending, read in READERS.items():
            self.assertGreater(len(read((self.folder / f"x.{ending}").read_bytes()).slices), 1000)
        kanata = Kanata((self.folder / "x.kanata").read_text())
        self.assertGreater(len(kanata.rows), 1000)
        self.assertTrue((self.folder / "x.vcd").read_text().endswith("\n"))
        self.assertTrue((self.folder / "x.fst").exists())

    def test_killed(self):
        self.assertEqual(self.broken_off(signal.SIGKILL), -signal.SIGKILL)
        for ending in ("vcd", "fst"):
            self.assertFalse((self.folder / f"x.{ending}").exists())
        for ending, read in READERS.items():
            self.assertGreater(len(read((self.folder / f"x.{ending}").read_bytes()).slices), 1000)
        self.assertEqual((self.folder / "x.kanata").read_text().count("Kanata"), 1)

    def test_a_limit_leaves_the_traces(self):
        run = self.run_tool("simulate", *FRAMES[0], "--max-cycles", "3000", "--trace", "x.json", "--trace", "x.pftrace")
        self.assertEqual(run.returncode, tool.LIMIT)
        for ending, read in READERS.items():
            slices = read((self.folder / f"x.{ending}").read_bytes()).slices
            self.assertGreater(max(end for _, _, _, end, _ in slices), 2000)

    def test_a_limit_of_size(self):
        """The trace ends, not the run: it is that of a window, which ends at the cycle that stderr names."""
        whole = self.stats("simulate", *FRAMES[0])
        limit = 200_000
        for ending in ("vcd", "fst", "kanata", *READERS):
            run = self.run_tool("simulate", *FRAMES[0], "--trace", f"x.{ending}", "--trace-limit", "200K", "--stats",
                                "x.stats")
            self.assertEqual(run.returncode, tool.OK)
            self.assertEqual({**tool.read_json(self.folder / "x.stats"), "command": ""}, {**whole, "command": ""})
            says = re.fullmatch(rf"pyrasim: warning: --trace x.{ending}: ends at cycle (\d+), with --trace-limit\n", run.stderr)
            end = int(says.group(1))
            self.assertLess(100, end)
            self.assertLess(end, whole["machine"]["cycles"] / 2)
            limited = (self.folder / f"x.{ending}").read_bytes()
            self.assertLess(len(limited), 1.1 * limit)
            if ending != "fst":  # of as many changes as the .vcd
                self.assertGreaterEqual(len(limited), limit)
            self.ok("simulate", *FRAMES[0], "--trace", f"x.{ending}", "--trace-to", end)
            window = (self.folder / f"x.{ending}").read_bytes()
            if ending not in READERS:
                self.assertEqual(limited, window)
                continue
            limited, window = READERS[ending](limited), READERS[ending](window)
            self.assertEqual(limited.window(0, end), window.all())
            self.assertEqual(limited.fills, window.fills)
        self.ok("simulate", *FRAMES[0], "--trace", "x.json", "--trace", "x.vcd", "--trace-limit", "1G")

    def test_mistakes(self):
        def refused(*arguments, says):
            self.refused(USAGE, "simulate", SCENES / "keel.json", *arguments, says=says)

        refused("--trace", "x.trace", says="--trace x.trace: its name must end in .vcd, .fst, .pftrace, .json, .kanata, .gtkw, .ptrace, .html, or be -")
        refused("--trace", "x.vcd", "--trace", "x.vcd", says="are one file or stream")
        refused("--trace", "x.json", "--stats", "x.json", says="are one file or stream")
        refused("--trace", "x.gtkw", "--trace", "./x.gtkw", says="are one file or stream")
        refused("--trace", "x.gtkw", "--stats", "x.states", says="are one file or stream")
        refused("--trace", "x.vcd", "--trace-from", "9", "--trace-to", "9", says="no cycle lies between them")
        for size in ("0", "-1", "K", "5x", "1KK", "1T", "1000000001"):
            refused("--trace", "x.vcd", "--trace-limit", size, says=f"--trace-limit {size}: a number of bytes from 1 to")
        refused("--trace", "x.vcd", "--trace-from", "-1", says="--trace-from")
        refused("--trace", "x.vcd", "--trace-unit", "colour_unit",
                says="--trace-unit colour_unit: no unit or FIFO of this machine has such a name; color_unit is near")
        refused("--trace", "x.pftrace", "--trace-unit", "*buffer", "--trace-unit", "zzz", says="--trace-unit zzz: no unit or FIFO")
        for option in (["--trace-from", "3"], ["--trace-to", "3"], ["--trace-limit", "1K"], ["--trace-pixel", "0,0"],
                       ["--trace-unit", "*"]):
            refused(*option, says="go with --trace FILE")
            for whole in (["x.html"], ["x.ptrace"], ["x.html", "x.ptrace"]):
                files = [word for file in whole for word in ("--trace", file)]
                refused(*files, *option, says="do not apply to .ptrace and .html, which are of the whole frame")
                for part in ("x.vcd", "x.fst", "x.pftrace", "x.json", "x.kanata", "x.gtkw"):
                    run = self.run_tool("simulate", SCENES / "keel.json", "--size", "4x3", *files, "--trace", part, *option)
                    self.assertEqual(run.returncode, tool.OK, run.stderr)
                    for file in [*self.folder.glob("x.*")]:
                        file.unlink()


tool.main()
