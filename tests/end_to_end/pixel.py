# SPDX-License-Identifier: Apache-2.0
"""What `pixel` says of one pixel is what statistics, maps, pictures and traces of the same frame say."""

import json
import re

import tool
from tool import LIMIT, MACHINES, SCENES, USAGE

FRAMES = ([SCENES / "keel.json", "--size", "32x24"],
          [SCENES / "shadows.json", "--size", "24x18", "--machine", MACHINES / "wide.json"],
          [SCENES / "buoys.json", "--window", "9,7,12,10", "--size", "32x24", "--max-level", "1"])
RAY = re.compile(r" *ray (\d+), (?:corner )?([a-z ]+?)  +([\d.]+), ([\d.]+)  +(.+?)  +([\d,]+) +(\d+) +([\d,]+) +([\d,]+) +([\d,]+)")


def number(text):
    return int(text.replace(",", ""))


class Pixel(tool.EndToEnd):
    def report(self, frame, row, column):
        return self.ok("pixel", frame[0], f"{row},{column}", *frame[1:])

    def frames(self):
        """Of each frame its slowest pixel and one whose corners see the same."""
        for frame in FRAMES:
            document = self.stats("simulate", *frame, "-o", "x.pfm", "--trace", "x.json", "--map", "rays=rays.pfm",
                                  "--map", "latency=latency.pfm")
            window = document.get("window", {"x": 0, "y": 0, "rows": document["rows"], "columns": document["columns"]})
            latency = {place: int(tool.pixel_of_pfm(self.folder / "latency.pfm", *place)[0])
                       for place in ((row, column) for row in range(window["rows"]) for column in range(window["columns"]))}
            for place in (max(latency, key=latency.get), min(latency, key=latency.get)):
                row, column = place[0] + window["y"], place[1] + window["x"]
                yield frame, document, place, (row, column), self.report(frame, row, column)

    def test_rays_are_those_of_the_trace(self):
        for frame, document, place, (row, column), report in self.frames():
            lines = [match for match in map(RAY.match, report.splitlines()) if match]
            events = [event for event in json.loads((self.folder / "x.json").read_text()) if event["ph"] == "X"]
            names = {event["tid"]: event["args"]["name"] for event in json.loads((self.folder / "x.json").read_text())
                     if event["ph"] == "M" and event["name"] == "thread_name"}
            begins = {(names[event["tid"]], event["args"]["ray"]): event["ts"] for event in events if "args" in event}
            for line in lines:
                ray, name, down, right, _, issued, unit, begin, end, seen = line.groups()
                self.assertEqual(begins["view_vector_generator", int(ray)], number(issued))
                self.assertEqual(begins[f"intersection_unit_{unit}", int(ray)], number(begin))
                self.assertLess(number(begin), number(end))
                self.assertLessEqual(number(end), number(seen))
                self.assertTrue(row <= float(down) <= row + 1 and column <= float(right) <= column + 1, (line, row, column))
            rays = int(tool.pixel_of_pfm(self.folder / "rays.pfm", *place)[0])
            self.assertEqual(len(lines), rays + 3)  # and the corners that its neighbours ask for
            self.assertEqual(len({line[1] for line in lines}), rays + 3)

    def test_its_time_and_colour(self):
        for frame, document, place, _, report in self.frames():
            lines = report.splitlines()
            cycles, begin, end, stored = map(number, re.match(
                r"latency +([\d,]+) cycles: from ([\d,]+), .* to ([\d,]+); stored by ([\d,]+)", lines[3]).groups())
            self.assertEqual(end - begin, cycles)
            self.assertLess(end, stored)
            self.assertEqual(int(tool.pixel_of_pfm(self.folder / "latency.pfm", *place)[0]), cycles)
            waits = [(number(line.split()[0]), line) for line in lines[lines.index(
                "What it took, by what came last each time:") + 1:]]
            self.assertEqual(sum(wait for wait, _ in waits), cycles)
            self.assertEqual([wait for wait, _ in waits], sorted((wait for wait, _ in waits), reverse=True))
            color = [float(word) for word in lines[2].split()[1:4]]
            for said, drawn in zip(color, tool.pixel_of_pfm(self.folder / "x.pfm", *place)):
                self.assertAlmostEqual(said, drawn, 4)

    def test_what_is_refused(self):
        keel = SCENES / "keel.json"
        size = ["--size", "8x6"]
        self.refused(USAGE, "pixel", keel, *size, says="PIXEL")
        self.refused(USAGE, "pixel", keel, "3", *size, says="PIXEL 3: ROW,COLUMN is allowed, as in 12,40")
        self.refused(USAGE, "pixel", keel, "6,0", *size, says="PIXEL: row 6: a whole number from 0 to 5 is allowed")
        self.refused(USAGE, "pixel", keel, "0,8", *size, says="PIXEL: column 8: a whole number from 0 to 7 is allowed")
        self.refused(USAGE, "pixel", keel, "0,0", *size, "--window", "1,0,2,2", says="from 1 to 2 is allowed")
        self.refused(LIMIT, "pixel", keel, "0,0", *size, "--max-cycles", "10", says="within 10 cycles", more_lines=True)


if __name__ == "__main__":
    tool.main()
