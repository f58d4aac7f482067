# SPDX-License-Identifier: Apache-2.0
"""The trace page says what the statistics say: its data, and what headless Chromium shows of it after real clicks and keys."""

import collections
import json
import re
import shutil
import subprocess
import unittest

import tool
from pixel import RAY, number
from tool import INPUT, LIMIT, MACHINES, SCENES, USAGE
from viewers import CHROMIUM, PATIENCE, VIEWERS, node_modules

STATES = ("busy", "starved", "blocked", "idle")
KEEL = [SCENES / "keel.json", "--size", "32x24"]
FRAMES = (KEEL, [SCENES / "shadows.json", "--size", "24x18", "--machine", MACHINES / "wide.json"],
          [SCENES / "buoys.json", "--size", "16x12", "--max-level", "1", "--machine", MACHINES / "small.json"],
          [SCENES / "keel.json", "--size", "24x16", "--max-level", "0"],
          [SCENES / "keel.json", "--size", "64x48", "--window", "20,15,17,9", "--max-level", "5", "--set", "fifos.all=1"],
          [SCENES / "keel.json", "--size", "24x16", "--set", "intersection.units=3", "--set", "intersection.dispatch=first_free"])


def grouped(number):
    return f"{number:,}"


def percent(part, whole):
    return f"{100 * part / whole:.1f} %"


@unittest.skipUnless(shutil.which("node"), "node is not installed; tools/setup test does it")
class Page(tool.EndToEnd):
    def paged(self, frame, *more):
        """The statistics; the page is x.html."""
        return self.stats("simulate", *frame, "--trace", "x.html", *more)

    def recorded(self, name, frame):
        """The statistics; the run is name.ptrace."""
        return self.stats("simulate", *frame, "--trace", f"{name}.ptrace")

    def node(self, script, *arguments):
        run = subprocess.run(["node", VIEWERS / script, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL,
                             capture_output=True, encoding="utf-8", check=False, timeout=PATIENCE)
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def data(self, page="x.html", pixels=()):
        return self.node("page_data.cjs", self.folder / page, *pixels)

    def reported(self, frame, row, column):
        """The lines of `pyrasim pixel`."""
        return self.ok("pixel", frame[0], f"{row},{column}", *frame[1:]).splitlines()


class Data(Page):
    def check_run(self, run, document):
        cycles = document["machine"]["cycles"]
        self.assertTrue(run["complete"])
        self.assertEqual(run["cycles"], cycles)
        self.assertEqual((run["rays"], run["primary"]), (document["rays"]["total"], document["rays"]["primary"]))
        for unit, its in zip(document["units"], run["units"], strict=True):
            self.assertEqual(its["name"], unit["name"])
            self.assertEqual(its["cycles"], [unit[state] for state in STATES], unit["name"])
            self.assertEqual(its["inSteps"], its["cycles"])
        for fifo, its in zip(document["fifos"], run["fifos"], strict=True):
            for key in ("name", "depth", "max", "tokens"):
                self.assertEqual(its[key], fifo[key], fifo["name"])
            self.assertEqual(its["mostInSteps"], fifo["max"], fifo["name"])
            self.assertAlmostEqual(its["mean"], fifo["mean"], 9, fifo["name"])
        self.assertEqual(run["slowest"],
                         [[slow["row"], slow["column"], slow["cycles"]] for slow in document["pixel_latency"]["slowest"]])
        self.assertEqual(max(run["latencies"]), document["pixel_latency"]["all"]["max"])
        self.assertEqual(run["unlike"], [], "pixels whose lives do not add up to their latency")

    def test_numbers(self):
        for frame in FRAMES:
            document = self.paged(frame, "--map", "rays=rays.pfm", "--map", "latency=latency.pfm")
            [run] = self.data()
            self.check_run(run, document)
            for name, values in (("rays", run["raysOfPixels"]), ("rays", run["raysListed"]), ("latency", run["latencies"])):
                self.assertEqual(list(tool.pfm_values(self.folder / f"{name}.pfm"))[::3], values, (frame, name))
            self.assertEqual(sum(pixel >= 0 for pixel in run["pixelsOfRays"]), sum(run["raysOfPixels"]))
            self.assertTrue(run["scanned"])
            self.assertEqual(run["points"], sorted(run["points"]))

    def test_pixels_are_those_of_pyrasim_pixel(self):
        """The first, one that was split most, and the last: every stretch of their lives, every date of their rays."""
        for frame in FRAMES:
            window = self.paged(frame, "--map", "rays=rays.pfm").get("window")
            columns, rows, _ = tool.read_pfm(self.folder / "rays.pfm")
            counts = self.data()[0]["raysOfPixels"]
            places = (0, counts.index(max(counts)), len(counts) - 1)
            for place, said in zip(places, self.data(pixels=places)[0]["asked"], strict=True):
                row, column = (start + at for start, at in zip((window["y"], window["x"]) if window else (0, 0), divmod(place, columns)))
                with self.subTest(frame, row=row, column=column):
                    self.check_pixel(said, self.reported(frame, row, column))

    def check_pixel(self, said, lines):
        begin, end = re.match(r"latency .*: from ([\d,]+), .* to ([\d,]+); ", lines[3]).groups()
        self.assertEqual((said["from"], said["to"]), (number(begin), number(end)))
        printed = collections.Counter()
        for line in lines[lines.index("What it took, by what came last each time:") + 1:]:
            cycles, what, place = re.fullmatch(r" *([\d,]+) +[\d.]+ %  (waiting in|held by|service of|latency of) (\w+)", line).groups()
            printed[place, what in ("waiting in", "held by")] += number(cycles)
        life = collections.Counter()
        for step in said["life"]:
            life[step["place"], step["waits"]] += step["cycles"]
        self.assertEqual(life, printed)
        printed = {number(match[1]): match for match in map(RAY.match, lines) if match}
        self.assertEqual({ray["ray"] for ray in said["rays"]}, printed.keys())
        for ray in said["rays"]:
            *_, sees, issued, unit, begin, end, seen = printed[ray["ray"]].groups()
            self.assertEqual([ray[key] for key in ("issued", "from", "to", "seen")], [*map(number, (issued, begin, end, seen))])
            self.assertEqual((ray["unit"].rsplit("_")[-1], ray["object"] == 0), (unit, sees.startswith("nothing")))

    def test_what_rays_see(self):
        """A box that fills the picture's left half: of the corner rays those see it."""
        half = {"type": "box", "min": [9, -50, 0], "max": [10, 50, 50], "color": [1, 1, 1]}
        self.write("half.json", tool.scene([half]))
        self.paged(["half.json", "--max-level", "0"])
        [run] = self.data()
        columns = [sorted({column for (_, column), seen in zip(run["points"], run["objects"]) if (seen > 0) == hit})
                   for hit in (True, False)]
        self.assertEqual(sorted(columns[0] + columns[1]), list(range(9)))
        self.assertTrue(3 <= len(columns[0]) <= 6)

    def test_waits(self):
        """The longest wait of a unit for a FIFO is no longer than all its waits for it, and there where it has some."""
        document = self.paged(KEEL)
        [run] = self.data()
        waits = {(unit["name"], wait["fifo"]): wait["cycles"] for unit in document["units"] for wait in unit["waits"]}
        for wait in run["waits"]:
            self.assertTrue(0 < wait["to"] - wait["from"] <= waits[wait["unit"], wait["cause"]])

    def test_recorded_run(self):
        """A frame that is made again is the frame."""
        document = self.recorded("keel", KEEL)
        self.ok("view", "keel.ptrace", "-o", "y.html")
        self.check_run(self.data("y.html")[0], document)
        self.paged(KEEL)
        same, again = self.data("x.html")[0], self.data("y.html")[0]
        self.assertEqual(same, again)

    def test_broken_off(self):
        run = self.run_tool("simulate", *KEEL, "--max-cycles", "3000", "--trace", "x.html")
        self.assertEqual(run.returncode, LIMIT)
        [run] = self.data()
        self.assertFalse(run["complete"])
        self.assertTrue(2000 < run["cycles"] < self.paged(KEEL)["machine"]["cycles"])
        self.assertTrue(any(latency is None for latency in run["latencies"]))

    def test_mistakes(self):
        self.recorded("keel", KEEL)
        self.refused(USAGE, "view", "keel.ptrace", "-o", "x.png", says="-o x.png: its name must end in .html, or be -")
        self.refused(USAGE, "view", *["keel.ptrace"] * 3, "-o", "x.html", says="RUN: 3 are given; a page shows one or two")
        self.refused(INPUT, "view", "none.ptrace", "-o", "x.html", says="none.ptrace")
        self.write("bad.ptrace", (self.folder / "keel.ptrace").read_bytes()[:-200])
        self.refused(INPUT, "view", "keel.ptrace", "bad.ptrace", "-o", "x.html", says="bad.ptrace")


@unittest.skipUnless(CHROMIUM.exists() and shutil.which("npm"), "chromium or npm is not installed; tools/setup test does it")
class Browser(Page):
    def see(self, steps, page="x.html", size=(1400, 1000), scheme="light"):
        """What the steps saw. Nothing is said on the console, and nothing asked of any network."""
        folder = self.folder / "browser"
        task = {"width": size[0], "height": size[1], "scheme": scheme, "steps": steps}
        result = self.node("page.cjs", node_modules(), CHROMIUM, self.folder / page, folder, json.dumps(task))
        shutil.rmtree(folder)
        self.assertEqual((result["errors"], result["requests"]), ([], []))
        return result["seen"]

    def check_tables(self, units, fifos, document, name=""):
        cycles = document["machine"]["cycles"]
        for unit in document["units"]:
            cells = [cell for state in STATES for cell in (percent(unit[state], cycles), grouped(unit[state]))]
            self.assertIn([name + unit["name"], *cells], units)
        for fifo in document["fifos"]:
            self.assertIn([name + fifo["name"], grouped(fifo["depth"]), grouped(fifo["max"]), f"{fifo['mean']:.2f}",
                           grouped(fifo["tokens"])], fifos)

    def test_pixel(self):
        """A click on a pixel shows its tree; one on a ray, its way, which is that of the trace for Chrome."""
        document = self.paged(KEEL, "--trace", "x.json", "--map", "rays=rays.pfm")
        slowest = document["pixel_latency"]["slowest"][0]
        row, column = slowest["row"], slowest["column"]
        [run] = self.data()
        rays = [ray for ray, pixel in enumerate(run["pixelsOfRays"]) if pixel == 32 * row + column]
        self.assertEqual(len(rays), tool.pixel_of_pfm(self.folder / "rays.pfm", row, column)[0])
        summary, heading, latency, count, listed, life, subject, steps, mark, tabs, units, _, fifos = self.see([
            ["texts", "#summary dd:not(.aside)"], ["clickAt", "#picture", (column + 0.5) / 32, (row + 0.5) / 24],
            ["text", "#pixel h2"], ["text", "#latency"], ["text", "#rays"],
            ["value", "[...document.querySelectorAll('.tree button.ray')].map(button => Number(button.dataset.ray))"],
            ["click", "#life summary"], ["table", "#life"], ["click", f'.tree button[data-ray="{rays[7]}"]'],
            ["text", "#subject"], ["table", ".steps"],
            ["text", ".tree .selected"], ["texts", "[role=tab]"], ["click", "[role=tab]", 1], ["table", "#units"],
            ["click", "[role=tab]", 2], ["value", "1"], ["table", "#fifos"]])
        self.assertEqual(summary[:4], [grouped(document["machine"]["cycles"]), "met", grouped(document["rays"]["total"]),
                                       grouped(document["terminal_nodes"])])
        self.assertEqual(summary[4], grouped(slowest["cycles"]))
        self.assertEqual(heading, f"Pixel row {row}, column {column}")
        self.assertEqual(latency, f"{grouped(slowest['cycles'])} cycles")
        self.assertEqual(count, str(len(rays)))
        self.assertEqual(sorted(listed[3:]), rays)  # the first three are its neighbours'
        self.assertEqual(life[-1], ["all", grouped(slowest["cycles"]), "100.000 %"])
        self.assertEqual(sum(int(cells[1].replace(",", "")) for cells in life[:-1]), slowest["cycles"])
        self.assertEqual(subject, f"Ray {rays[7]} of the pixel in row {row}, column {column}")
        self.assertTrue(mark.startswith(f"ray {rays[7]} "))
        events = json.loads((self.folder / "x.json").read_text())
        names = {event["tid"]: event["args"]["name"] for event in events if event["name"] == "thread_name"}
        begins = {names[event["tid"]]: event["ts"] for event in reversed(events)
                  if event["ph"] == "X" and event.get("args", {}).get("ray") == rays[7]}
        shown = {cells[0]: int(cells[1].replace(",", "")) for cells in steps if not cells[0].startswith("FIFO")}
        for unit, begin in begins.items():
            if unit != "pyramid_classifier":
                self.assertEqual(shown[unit], begin, unit)
        self.assertEqual(int(steps[-1][2].replace(",", "")), begins["pyramid_classifier"])
        for before, after in zip(steps, steps[1:]):
            self.assertEqual(before[2], after[1])
        self.assertEqual(tabs, ["Longest", "Units", "FIFOs"])
        self.check_tables(units, fifos, document)

    def test_rays_see_what_pyrasim_pixel_says(self):
        """Objects without a name by their place in the scene, from 0."""
        near = {"type": "sphere", "center": [10, 1, 0], "radius": 1.5, "color": [1, 1, 1]}
        self.write("scene.json", tool.scene([{**near, "name": "left"}, {**near, "center": [10, -1, 0]}]))
        self.paged(["scene.json", "--max-level", "1"])
        places = [(row, column) for row in range(6) for column in range(8)]
        steps = [step for row, column in places for step in (
            ["clickAt", "#picture", (column + 0.5) / 8, (row + 0.5) / 6],
            ["value", "[...document.querySelectorAll('.tree button.ray')].map(button => button.title)"])]
        seen = set()
        for (row, column), titles in zip(places, self.see(steps), strict=True):
            lines = filter(None, map(RAY.match, self.reported(["scene.json", "--max-level", "1"], row, column)))
            printed = {f"ray {line[1]}": f"sees {line[5]}" for line in lines}
            self.assertEqual({re.match(r"ray \d+", title)[0]: title.rsplit(", ")[-1] for title in titles}, printed)
            seen |= set(printed.values())
        self.assertEqual(seen, {"sees left", "sees object 1", "sees nothing"})

    def test_span(self):
        """A click on a span selects its ray and pixel."""
        document = self.paged(KEEL, "--trace", "x.json")
        events = json.loads((self.folder / "x.json").read_text())
        tid = next(event["tid"] for event in events if event["name"] == "thread_name" and event["args"]["name"] == "intersection_unit_2")
        span = [event for event in events if event["ph"] == "X" and event["tid"] == tid and event["name"] == "busy"][200]
        ray, middle = span["args"]["ray"], span["ts"] + span["dur"] // 2
        [run] = self.data()
        row, column = divmod(run["pixelsOfRays"][ray], 32)
        shown, heading, when, subject, pixel, whole = self.see([
            ["key", "/"], ["type", f"cycle {middle}"], ["key", "Enter"], ["text", "#readout"],
            ["clickCycle", "intersection_unit_2", middle], ["text", "#span"], ["text", "#selection p"], ["text", "#subject"],
            ["text", "#pixel h2"], ["key", "0"], ["text", "#readout"]])
        self.assertEqual(shown, f"Shown: cycle {grouped(middle - 20)} to {grouped(middle + 20)}, 40 cycles")
        self.assertEqual(heading, f"intersection_unit_2 busy with ray {ray}")
        self.assertEqual(when, f"cycle {grouped(span['ts'])} to {grouped(span['ts'] + span['dur'])}, {span['dur']} cycles")
        self.assertEqual(subject, f"Ray {ray} of the pixel in row {row}, column {column}")
        self.assertEqual(pixel, f"Pixel row {row}, column {column}")
        cycles = grouped(document["machine"]["cycles"])
        self.assertEqual(whole, f"Shown: cycle 0 to {cycles}, {cycles} cycles")

    def test_keys(self):
        document = self.paged(KEEL)
        slowest = document["pixel_latency"]["slowest"][0]
        longest, close, panned, stall, first, second, back, wait, cleared, keys = self.see([
            ["key", "l"], ["text", "#pixel h2"], ["key", "+", 16], ["text", "#readout"], ["key", "ArrowRight"], ["text", "#readout"],
            ["key", "f"], ["text", "#span"], ["key", "n"], ["text", "#selection p"], ["key", "n"], ["text", "#selection p"],
            ["key", "p"], ["text", "#selection p"], ["key", "w"], ["text", "#selection p"], ["key", "Escape"],
            ["text", "#pixel h2"], ["key", "?"], ["value", "document.querySelector('#help').open"]])
        self.assertEqual(longest, f"Pixel row {slowest['row']}, column {slowest['column']}")
        self.assertTrue(close.endswith((", 8 cycles", ", 9 cycles")), close)
        number = [int(re.search(r"[\d,]+", text)[0].replace(",", "")) for text in (close, panned)]
        self.assertIn(number[1] - number[0], (1, 2))
        self.assertIn("blocked", stall)
        begins = [int(re.search(r"[\d,]+", text)[0].replace(",", "")) for text in (first, second, back)]
        self.assertLess(begins[0], begins[1])
        self.assertEqual(back, first)
        most = max(self.data()[0]["waits"], key=lambda wait: wait["to"] - wait["from"])
        self.assertEqual(wait, f"cycle {grouped(most['from'])} to {grouped(most['to'])}, {grouped(most['to'] - most['from'])} cycles")
        self.assertEqual((cleared, keys), ("Pixel", True))

    def test_two_runs(self):
        documents = [self.recorded("a", KEEL), self.recorded("b", [*KEEL, "--machine", MACHINES / "wide.json"])]
        self.ok("view", "a.ptrace", "b.ptrace", "-o", "x.html")
        data = self.data()
        pixel = 32 * 12 + 9
        latencies = [run["latencies"][pixel] for run in data]
        headings, latency, shown, maps, units, _, fifos, active = self.see([
            ["texts", "h1"], ["clickAt", "#picture", 9.5 / 32, 12.5 / 24], ["text", "#latency"], ["text", "#readout"],
            ["texts", "#maps label"], ["click", "[value=difference]"], ["click", "[role=tab]", 1], ["table", "#units"],
            ["click", "[role=tab]", 2], ["value", "1"], ["table", "#fifos"], ["click", "#summary button", 1],
            ["text", "#summary .active h1"]])
        self.assertTrue(headings[0].startswith("a.ptrace: keel.json, 32×24 pixels"))
        self.assertEqual(headings[1], active)
        difference = f"{'−' if latencies[1] < latencies[0] else '+'}{grouped(abs(latencies[1] - latencies[0]))}"
        self.assertEqual(latency, f"A {grouped(latencies[0])} cycles, B {grouped(latencies[1])} cycles, B − A {difference}")
        cycles = [document["machine"]["cycles"] for document in documents]
        self.assertEqual(shown, f"Shown: cycle 0 to {grouped(max(cycles))}, {grouped(max(cycles))} cycles")
        self.assertEqual(maps, ["Picture", "Cases", "Rays", "Latency", "B − A"])
        for name, document in zip(("A ", "B "), documents):
            self.check_tables(units, fifos, document, name)
        a, b = (next(unit for unit in document["units"] if unit["name"] == "pixel_scan")["busy"] for document in documents)
        more = 100 * (b / cycles[1] - a / cycles[0])
        self.assertIn(["B − A", f"{'−' if more < 0 else '+'}{abs(more):.1f}"], [[cells[0], cells[1].split()[0]] for cells in units])

    def test_two_runs_of_different_pictures(self):
        documents = [self.recorded("a", KEEL), self.recorded("b", FRAMES[2])]
        self.ok("view", "a.ptrace", "b.ptrace", "-o", "x.html")
        maps, latency, other, its = self.see([
            ["texts", "#maps label"], ["key", "l"], ["text", "#latency"], ["click", "#summary button", 1], ["text", "#pixel h2"],
            ["key", "l"], ["text", "#latency"]])
        self.assertEqual(maps, ["Picture", "Cases", "Rays", "Latency"])
        self.assertEqual(other, "Pixel")
        for text, document in zip((latency, its), documents):
            self.assertEqual(text, f"{grouped(document['pixel_latency']['slowest'][0]['cycles'])} cycles")

    def test_dark_and_narrow(self):
        self.paged(KEEL)
        measure = ["value", "[getComputedStyle(document.body).backgroundColor, document.documentElement.scrollWidth]"]
        steps = [measure, ["key", "l"], ["key", "w"], measure]
        colors = set()
        for scheme in ("light", "dark"):
            for (color, width) in self.see(steps, size=(400, 800), scheme=scheme):
                self.assertEqual(width, 400)
                colors.add(color)
        self.assertEqual(len(colors), 2)

    def test_panels_scroll_by_themselves(self):
        """On a wide window picture and timeline stay where they are."""
        self.paged(KEEL)
        [height, scrolled] = self.see([["key", "l"], ["click", ".tree button.ray", 17], ["value", "document.documentElement.scrollHeight"],
                                       ["value", "document.querySelector('#pixel').scrollTop"]])
        self.assertEqual(height, 1000)
        self.assertGreaterEqual(scrolled, 0)

    def test_broken_off(self):
        self.run_tool("simulate", *KEEL, "--max-cycles", "3000", "--trace", "x.html")
        summary, pixel = self.see([["texts", "#summary dd"], ["clickAt", "#picture", 0.99, 0.99], ["text", "#latency"]])
        self.assertIn("broken off", summary)
        self.assertEqual(pixel, "not finished")


tool.main()
