# SPDX-License-Identifier: Apache-2.0
"""compare of two runs: every difference between their statistics, none where there is none."""

import json
import re

import tool
from tool import INPUT, SCENES, USAGE

KEEL = SCENES / "keel.json"


def at(document, path):
    """The value that a path leads to: keys, names of elements, or levels."""
    while path:
        if isinstance(document, list):
            named = [element for element in document if isinstance(element, dict)
                     and f"{path}.".startswith(f"{element.get('name')}.")]
            key = named[0]["name"] if named else path.split(".")[0]
            document = named[0] if named else document[int(key)]
        else:
            key = path.split(".")[0]
            document = document[key]
        path = path[len(key) + 1 :]
    return document


class CompareRuns(tool.EndToEnd):
    def setUp(self):
        super().setUp()
        for name, options in (("a", []), ("again", []), ("lockstep", ["--engine", "lockstep"]),
                              ("wide", ["--set", "intersection.units=6", "--set", "fifos.all=16"]),
                              ("level_2", ["--max-level", "2"])):
            self.ok("simulate", KEEL, "--size", "32x24", *options, "--stats", f"{name}.json")
        self.ok("render", KEEL, "--size", "32x24", "--stats", "rendered.json")

    def differences(self, first, second):
        document = json.loads(self.run_tool("compare", f"{first}.json", f"{second}.json", "--stats", "-").stdout)
        self.assertEqual(document["equal"], not document["differences"])
        return {entry["path"]: entry for entry in document["differences"]}

    def test_equal_runs(self):
        for second in ("a", "again"):
            self.assertEqual(self.differences("a", second), {})
            self.assertIn("equal in every setting, count and cycle; the pictures are the same",
                          self.ok("compare", "a.json", f"{second}.json"))
        self.assertEqual(list(self.differences("a", "lockstep")), ["engine"])
        self.assertRegex(self.ok("compare", "a.json", "lockstep.json"), r"\nengine +decoupled +lockstep\n")

    def test_columns_are_as_wide_as_what_they_show(self):
        """In characters, one of which may be several bytes."""
        names = ["langsam ×××××××××××××××××××", "größer ××××××××××××××××××××"]
        for file, name in zip("bc", names):
            self.ok("simulate", KEEL, "--size", "32x24", "--machine", self.write("m.json", {"name": name}), "--stats", f"{file}.json")
        table = self.ok("compare", "b.json", "c.json")
        self.assertRegex(table, rf"(?m)^machine.name +{names[0]}  {names[1]}$")

    def test_every_difference_is_found(self):
        """One value after the other is changed: that one, and no other, is reported, in the document and in the table."""
        document = tool.read_json(self.folder / "a.json")
        for path in ("machine.cycles", "rays.by_level.2", "cases.by_level.1.edge", "units.pixel_scan.busy",
                     "units.intersection_unit_3.starved", "fifos.tree_accumulator_to_frame_buffer.max", "scene",
                     "work.box_tests", "image.sha256", "pixel_latency.all.p99", "machine.settings.clock_mhz", "subdivisions"):
            changed = json.loads(json.dumps(document))
            holder, _, key = path.rpartition(".")
            target = at(changed, holder)
            key = int(key) if isinstance(target, list) else key
            target[key] = "other" if isinstance(target[key], str) else target[key] + 1
            self.write("changed.json", changed)
            found = self.differences("a", "changed")
            self.assertEqual(list(found), [path])
            self.assertEqual(found[path]["first"], at(document, path))
            self.assertEqual(found[path]["second"], at(changed, path))
            line = ("the pictures differ" if path == "image.sha256" else
                    path.split(".")[1] if path.startswith(("units.", "fifos.")) else path)
            self.assertIn(f"\n{line}", self.ok("compare", "a.json", "changed.json"))

    def test_table(self):
        a, wide = (tool.read_json(self.folder / f"{name}.json") for name in ("a", "wide"))
        text = self.ok("compare", "a.json", "wide.json")
        self.assertRegex(text, rf"\nmachine\.cycles +{a['machine']['cycles']:,} +{wide['machine']['cycles']:,} +-\d")
        self.assertIn("--set intersection.units=6", text)
        def busy(document, k):
            return f"{100 * document['units'][k]['busy'] / document['machine']['cycles']:.1f}"
        self.assertRegex(text, rf"\npixel_scan +{busy(a, 0)} -> {busy(wide, 0)} ")
        self.assertRegex(text, r"\nintersection_unit_5 +- -> \d")
        self.assertRegex(text, r"\npixel_scan_to_view_vector_generator +4 -> 16 ")
        self.assertIn("the pictures are the same", text)
        self.assertEqual(len(re.findall(r"(?m)^(\w+) .*->", text)), len(set(re.findall(r"(?m)^(\w+) .*->", text))))
        shallow = self.ok("compare", "a.json", "level_2.json")
        self.assertRegex(shallow, r"\nmax_level +3 +2\n")
        self.assertRegex(shallow, r"\nrays\.by_level\.3 +[\d,]+ +-\n")
        self.assertIn("the pictures differ", shallow)

    def test_rendering_and_simulation(self):
        text = self.ok("compare", "rendered.json", "a.json")
        self.assertIn("only the second run was simulated: what both have is compared\n"
                      "equal in all of that; the pictures are the same\n", text)
        self.assertNotIn("\nintersection_unit", text)
        self.assertNotIn("\nmachine", text)

    def test_mistakes(self):
        self.write("a.pfm", b"PF\n1 1\n-1.0\n" + bytes(12))
        for files in (("a.json", "a.pfm"), ("a.pfm", "a.json")):
            self.refused(USAGE, "compare", *files, says="two pictures (.png, .pfm) or the statistics of two runs (.json)")
        for option, value in (("-o", "x.png"), ("--crop", "4x4"), ("--at", "1,1"), ("--scale", "2"), ("--png-bits", "8")):
            self.refused(USAGE, "compare", "a.json", "again.json", option, value, says=f"{option}: allowed where pictures")
        self.refused(USAGE, "compare", "a.json", "again.json", "--stats", "a.json", says="FIRST reads this file")
        for name, content in (("text.json", "text"), ("list.json", []), ("scene.json", tool.scene()), ("empty.json", "{}"),
                              ("missing.json", None)):
            if content is not None:
                self.write(name, content)
            self.refused(INPUT, "compare", "a.json", name, "--stats", "out.json", says=name)
        odd = {"pyrasim": 1, "rays": [[[]]], "image": None, "units": [{"name": "x"}, 3], "fifos": {"name": "y", "depth": []},
               "machine": {"cycles": "many"}, "bottleneck": {"chain": [1, {"unit": 2}]}}
        self.ok("compare", self.write("odd.json", odd), "a.json")
        self.ok("compare", "a.json", "odd.json")


tool.main()
