# SPDX-License-Identifier: Apache-2.0
"""A recorded frame on other machines takes what it takes there when it is simulated: every number of the statistics."""

import csv
import io
import json
import random
import zlib

import tool
from settings import BESIDE, SHADOWED, TEXTURED, schema_leaves, settings
from tool import INPUT, LIMIT, MACHINES, SCENES, USAGE

MAX_LEVEL = 3


def random_settings(seed):
    """A machine: a value for each setting, small ones more often than large ones."""
    chance = random.Random(seed)
    for path, node in schema_leaves():
        if path in ("name", "clock_mhz", "goal_fps", "fifos.all", "pyramid_classifier.line_buffer"):
            continue
        if "enum" in node:
            yield path, chance.choice(node["enum"])
        else:
            least = 3 * (MAX_LEVEL - 1) + 1 if path == "subdivision_controller.pool" else node["minimum"]
            yield path, least + chance.randrange(chance.choice((1, 4, 16, 64)))


class Whatif(tool.EndToEnd):
    def record(self, *arguments, name="run.ptrace"):
        self.ok("simulate", *arguments, "--trace", name)

    def points(self, *arguments):
        return self.stats("whatif", *arguments)["points"]

    def expect_same(self, found, expected):
        self.assertEqual({**found, "command": ""}, {**expected, "command": ""})

    def test_equals_simulate_on_random_machines(self):
        self.write("shadowed.json", SHADOWED)
        self.write("textured.json", TEXTURED)
        frames = ([SCENES / "keel.json", "--size", "48x36"], ["shadowed.json", "--edge", "drop"],
                  ["textured.json", "--scalar", "view_vectors=fp24,intersection=fix40.28", "--texture", "point"],
                  [SCENES / "crystals.json", "--size", "32x24", "--window", "8,4,20,16", "--max-level", MAX_LEVEL])
        for number, frame in enumerate(frames):
            self.record(*frame, "--machine", MACHINES / ("wide.json" if number % 2 else "small.json"))
            for seed in range(10 * number, 10 * number + 6):
                machine = [f"{path}={value}" for path, value in random_settings(seed)]
                with self.subTest(frame=frame, machine=machine):
                    sets = [word for setting in machine for word in ("--set", setting)]
                    expected = self.stats("simulate", *frame, *sets)
                    expected["machine"]["name"] = ["small", "wide"][number % 2]
                    self.expect_same(self.points("run.ptrace", *machine)[-1]["statistics"], expected)

    def test_every_setting(self):
        """One at a time, from a machine that has others."""
        for number, scene in enumerate((SHADOWED, TEXTURED)):
            self.write("scene.json", scene)
            self.record("scene.json", "--machine", MACHINES / "wide.json")
            for path, (_, value) in settings():
                if path in ("name", "fifos.all", "pyramid_classifier.line_buffer") or ("shadow" in path) != (number == 0):
                    continue
                with self.subTest(setting=path):
                    changes = [*BESIDE.get(path, []), f"{path}={value}"]
                    sets = [word for change in changes for word in ("--set", change)]
                    expected = self.stats("simulate", "scene.json", "--machine", MACHINES / "wide.json", *sets)
                    self.expect_same(self.points("run.ptrace", *changes)[-1]["statistics"], expected)

    def test_first_row_is_the_recorded_run(self):
        frame = [SCENES / "keel.json", "--size", "32x24", "--set", "intersection.units=3"]
        expected = self.stats("simulate", *frame, "--trace", "run.ptrace")
        for more in ([], ["intersection.units=+1"], ["--machine", MACHINES / "wide.json"]):
            first = self.points("run.ptrace", *more)[0]
            self.assertEqual((first["change"], first["difference_percent"]), ("recorded", 0))
            self.expect_same(first["statistics"], expected)

    def test_needs_no_scene(self):
        scene = self.write("scene.json", tool.scene())
        self.record(scene)
        scene.unlink()
        self.ok("whatif", "run.ptrace", "intersection.units=1")

    def settings_of(self, *changes):
        """The last machine's."""
        return self.points("run.ptrace", *changes)[-1]["statistics"]["machine"]["settings"]

    def test_relative_values(self):
        self.record(self.write("scene.json", tool.scene()))
        before = self.settings_of()
        units = before["intersection"]["units"]
        for value, expected in (("7", 7), ("+3", units + 3), ("-1", units - 1), ("x2", 2 * units), ("×3", 3 * units),
                                ("x0.5", units // 2), ("x1.6", round(1.6 * units)), ("+0", units)):
            self.assertEqual(self.settings_of(f"intersection.units={value}")["intersection"]["units"], expected, value)
        self.assertEqual(self.settings_of("clock_mhz=x1.5")["clock_mhz"], 300)
        self.assertEqual(self.settings_of("clock_mhz=+0.5")["clock_mhz"], 200.5)
        doubled = {name: 2 * depth for name, depth in before["fifos"].items()}
        self.assertEqual(self.settings_of("fifos.all=x2")["fifos"], doubled)
        self.assertEqual(set(self.settings_of("fifos.all=5")["fifos"].values()), {5})
        both = self.settings_of("fifos.all=x2", "fifos.pixel_scan_to_view_vector_generator=1", "intersection.units=x2")
        self.assertEqual((both["fifos"]["pixel_scan_to_view_vector_generator"], both["intersection"]["units"],
                          both["fifos"]["color_unit_to_tree_accumulator"]), (1, 2 * units, 16))
        self.assertEqual(self.settings_of("intersection.dispatch=first_free")["intersection"]["dispatch"], "first_free")

    def test_rows(self):
        """All combinations; a range, a list, and both files."""
        self.record(SCENES / "keel.json", "--size", "32x24")
        run = self.run_tool("whatif", "run.ptrace", "intersection.units=1..3", "fifos.all=x1,x4", "--csv", "-", "--jobs", "2")
        rows = list(csv.DictReader(io.StringIO(run.stdout)))
        self.assertEqual([row["change"] for row in rows],
                         ["recorded"] + [f"intersection.units={units} fifos.all={depth}"
                                         for units in (1, 2, 3) for depth in ("x1", "x4")])
        table = run.stderr.splitlines()
        self.assertEqual(len(table), 1 + 7)
        for line, row in zip(table[1:], rows):
            self.assertIn(f"{int(row['cycles']):,}", line)
            self.assertIn(row["bottleneck"], line)
            difference = 100 * (int(row["cycles"]) / int(rows[0]["cycles"]) - 1)
            self.assertAlmostEqual(float(row["difference_percent"]), difference, 5)
            self.assertIn(f"{difference:+.2f} %", line)
        self.ok("whatif", "run.ptrace", "intersection.units=1..3", "fifos.all=x1,x4", "--csv", "rows.csv")
        self.assertEqual((self.folder / "rows.csv").read_text(), run.stdout)

    def test_columns_are_as_wide_as_what_they_show(self):
        """In characters: × is one, of two bytes."""
        self.record(self.write("scene.json", tool.scene()))
        change = "intersection.units=×2"
        header, recorded, changed = self.ok("whatif", "run.ptrace", change).splitlines()
        for line, cells in ((header, ("change", "cycles")), (recorded, ("recorded", r"[\d,]+")), (changed, (change, r"[\d,]+"))):
            self.assertRegex(line[:len(change) + 15], rf"\A{cells[0]} +{cells[1]}\Z")

    def test_sensitivity(self):
        """Estimates of a step of every setting; those of the busiest unit are near what is found."""
        self.record(SCENES / "keel.json", "--size", "64x48")
        trace = "run.ptrace"
        self.ok("whatif", trace, "--sensitivity", "--stats", "all.json", "--csv", "all.csv")
        table = self.ok("whatif", trace, "--sensitivity").splitlines()
        document = tool.read_json(self.folder / "all.json")
        recorded = document["cycles"]
        predicted = {part["change"]: part["predicted_cycles"] for part in document["predictions"]}
        rows = list(csv.DictReader((self.folder / "all.csv").read_text().splitlines()))
        self.assertEqual({row["change"]: int(row["predicted_cycles"]) for row in rows}, predicted)
        self.assertEqual(list(predicted.values()), sorted(predicted.values()))
        self.assertGreaterEqual(len(predicted), 50)
        shown = {line.split()[0]: int(line.split()[1].replace(",", "")) for line in table[1:-2]}
        self.assertLess(shown.items(), predicted.items())
        for change, cycles in predicted.items():
            self.assertEqual(change in shown, abs(cycles - recorded) >= recorded / 10_000, change)
        for change in ("intersection.units=+1", "intersection.units=-1", "intersection.cost.box_test=+1"):
            found = self.points(trace, change)[1]["statistics"]["machine"]["cycles"]
            self.assertGreater(abs(found - recorded), recorded / 10)
            self.assertLess(abs(predicted[change] - found), recorded / 50, change)

    def test_another_machine(self):
        frame = [SCENES / "keel.json", "--size", "32x24"]
        self.record(*frame)
        wide = MACHINES / "wide.json"
        names = [point["change"] for point in self.points("run.ptrace", "--machine", wide, "intersection.units=-1")]
        self.assertEqual(names, ["recorded", "wide", "wide intersection.units=-1"])
        self.expect_same(self.points("run.ptrace", "--machine", wide)[1]["statistics"],
                         self.stats("simulate", *frame, "--machine", wide))

    def test_refused(self):
        self.record(self.write("scene.json", tool.scene()))
        for change, says in (("intersection.unit=3", "whatif intersection.unit=3: there is no such setting; intersection.units is"),
                             ("colour=3", "there is no such setting; those of machine files are allowed"),
                             ("intersection=3", "there is no such setting"),
                             ("intersection.units", 'there is no "="; PATH=VALUE is allowed'),
                             ("intersection.units=", "the value is missing"),
                             ("intersection.units=-4", "/intersection/units: 0 is out of range; an integer from 1 to 256"),
                             ("intersection.units=x100", "/intersection/units: 400 is out of range; an integer from 1 to 256"),
                             ("intersection.units=+0.5", "/intersection/units: it is the number 4.5"),
                             ("intersection.units=9..2", "intersection.units=9..2: 2 is less than 9; FIRST..LAST is allowed, from 0 on, ascending"),
                             ("intersection.units=-1..2", "intersection.units=-1..2: it begins below 0; FIRST..LAST"),
                             ("intersection.units=0..1000", "intersection.units=0..1000: it has too many values; FIRST..LAST is"),
                             ("intersection.units=0..999", "/intersection/units: 0 is out of range"),
                             ("intersection.units=1,2,300", "/intersection/units: 300 is out of range; an integer from 1 to 256"),
                             ("intersection.dispatch=+1", "the setting is no number"),
                             ("intersection.dispatch=other", "/intersection/dispatch")):
            self.refused(USAGE, "whatif", "run.ptrace", change, says=says)
        self.refused(USAGE, "whatif", "run.ptrace", "intersection.units=+1", "intersection.units=3",
                     says="whatif intersection.units: it is changed twice")
        self.refused(INPUT, "whatif", "run.ptrace", "subdivision_controller.pool=2", says="cannot hold one pixel's tree")
        self.refused(INPUT, "whatif", "none.ptrace", says="none.ptrace: cannot read: No such file")
        self.refused(INPUT, "whatif", "scene.json", says="scene.json: it is no trace of this program")
        self.refused(USAGE, "whatif", "run.ptrace", "--csv", "run.ptrace", says="RUN reads this file")
        run = self.run_tool("whatif", "run.ptrace", "intersection.units=1", "--max-cycles", "10")
        self.assertEqual(run.returncode, LIMIT)
        self.assertIn("recorded (0 of 2 rows done): the frame is not finished within 10 cycles", run.stderr)

    def test_changes_are_made_together(self):
        """A FIFO that is named is changed as that says, from what was recorded, in whatever order."""
        self.record(SCENES / "keel.json", "--size", "16x12")
        name = "pyramid_classifier_to_color_unit"
        recorded = self.settings_of("clock_mhz=x1")["fifos"]
        for one, every, expected in (("=1", "=2", 1), ("=x2", "=x3", 2 * recorded[name])):
            both = [f"fifos.{name}{one}", f"fifos.all{every}"]
            for changes in (both, both[::-1]):
                fifos = self.settings_of(*changes)["fifos"]
                self.assertEqual(fifos[name], expected)
                self.assertNotEqual(fifos["color_unit_to_tree_accumulator"], recorded["color_unit_to_tree_accumulator"])

    def test_files_that_do_not_fit_together(self):
        """Of another picture than the rays: said when it is read."""
        self.record(SCENES / "keel.json", "--size", "16x12")
        data = (self.folder / "run.ptrace").read_bytes()
        for old, new in ((b'"max_level":3', b'"max_level":2'), (b'"rows":12', b'"rows":13'), (b'"columns":16', b'"columns":17')):
            self.assertEqual(data.count(old), 1)
            self.write("bad.ptrace", data.replace(old, new))
            for command in (["whatif"], ["view", "-o", "x.html"]):
                self.refused(INPUT, *command, "bad.ptrace", says="bad.ptrace: ")
        head, *rest = tool.ptrace_chunks(data)
        _, at = tool.varint(head, 1)
        header = head[at:].replace(b'"columns":16', b'"columns":9000').replace(b'"rows":12', b'"rows":9000')
        huge = tool.PTRACE_MAGIC + b"".join([b"H", tool.varint_of(len(header)), header, *rest])
        rays = self.points("run.ptrace")[0]["statistics"]["rays"]["total"]
        self.refuses_damaged(huge, says=f": (root): {rays} rays recorded, and a frame of 9000x9000 pixels has more corners; the file")

    def refuses_damaged(self, data, says=": a chunk of it is damaged; it has to be as simulate wrote it"):
        """In little memory."""
        self.write("bad.ptrace", data)
        for command in (["whatif"], ["view", "-o", "x.html"]):
            self.refused(INPUT, *command, "bad.ptrace", says="bad.ptrace" + says)
            self.assertLess(self.memory(*command, "bad.ptrace", code=INPUT), 300 << 20)

    def test_order_of_chunks(self):
        """Each type as often as docs/ptrace.md says, and nothing behind the end."""
        self.record(SCENES / "keel.json", "--size", "16x12")
        data = (self.folder / "run.ptrace").read_bytes()
        parts = dict(zip("HRIZ", tool.ptrace_chunks(data), strict=True))
        build = lambda order: tool.PTRACE_MAGIC + b"".join(parts[kind] for kind in order)
        parts["Q"] = b"Q\x03abc"
        self.assertEqual(build("HRIZ"), data)
        for order in ("HRIZ", "HIRZ", "HQRQIQZ"):
            self.write("good.ptrace", build(order))
            self.ok("whatif", "good.ptrace")
        for order in ("HHRIZ", "HRIHZ", "HRIIZ", "HRIZZ", "HRZI", "HRZ", "HRIZQ", "HRIZR", "HRIZI"):
            with self.subTest(order):
                self.refuses_damaged(build(order))
        self.refuses_damaged(data + b"R")  # a piece of one
        self.refuses_damaged(data + b"Q\x09ab")

    def test_bombs(self):
        """A chunk that inflates to gigabytes, in whatever it claims to be."""
        self.record(SCENES / "keel.json", "--size", "16x12")
        head, rays, image, end = tool.ptrace_chunks((self.folder / "run.ptrace").read_bytes())
        packer = zlib.compressobj(1)
        content = b"".join(packer.compress(bytes(1 << 20)) for _ in range(1024)) + packer.flush()
        for kind in b"RNEZ":
            bomb = bytes([kind]) + tool.varint_of(len(content)) + content
            self.refuses_damaged(tool.PTRACE_MAGIC + head + bomb + rays + image + end)
        self.write("most.ptrace", tool.PTRACE_MAGIC + head + self.filler(32 << 20) + rays + image + end)
        self.ok("whatif", "most.ptrace")
        self.refuses_damaged(tool.PTRACE_MAGIC + head + self.filler((32 << 20) + 1) + rays + image + end)

    @staticmethod
    def filler(size):
        """A chunk that says nothing, so large."""
        content = zlib.compress(bytes(size))
        return b"E" + tool.varint_of(len(content)) + content

    def test_damaged_files(self):
        """Cut anywhere, or with any byte changed: one line, or the same result."""
        self.record(self.write("scene.json", TEXTURED), "--size", "8x6")
        data = (self.folder / "run.ptrace").read_bytes()
        chance = random.Random(7)
        for size in (0, 5, 16, 17, 40, len(data) // 2, len(data) - 1):
            self.write("cut.ptrace", data[:size])
            self.refused(INPUT, "whatif", "cut.ptrace", says="cut.ptrace: ")
        for _ in range(60):
            at = chance.randrange(len(data))
            self.write("bad.ptrace", data[:at] + bytes([data[at] ^ 1 << chance.randrange(8)]) + data[at + 1:])
            run = self.run_tool("whatif", "bad.ptrace", "--stats", "-")
            self.assertIn(run.returncode, (tool.OK, INPUT, USAGE, LIMIT), (at, run.stderr))
            if run.returncode == INPUT:
                self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
            elif run.returncode == tool.OK:
                json.loads(run.stdout)


if __name__ == "__main__":
    tool.main()
