# SPDX-License-Identifier: Apache-2.0
"""docs/machine.md says what the machine is: its boxes, settings and FIFOs are those of the program, in their order, with
their defaults."""

import re
import shutil
import subprocess
import unittest

import tool
from tool import INPUT, MACHINES, SCENES, SOURCE, USAGE

KEEL = SCENES / "keel.json"
# Machines that have every FIFO between them; the first has every box.
EVERYTHING, OTHERS = [("diagram", SCENES / f"{scene}.json", "--set", 'intersection.dispatch="first_free"')
                      for scene in ("shadows", "keel")]


def table(head):
    """The rows of the page's table whose first line begins so, as lists of cells."""
    lines = (SOURCE / "docs/machine.md").read_text().partition("\n| " + head + " |")[2].split("\n")[2:]
    rows = []
    for line in lines:
        if not line.startswith("|"):
            return rows
        rows.append([cell.strip() for cell in line.strip("|").split("|")])
    return rows


def number(text):
    return int(text.replace(",", "")) if re.fullmatch(r"[\d,]+", text) else text


def without_numbers(names):
    return list(dict.fromkeys(re.sub(r"_\d+", "", name) for name in names))


def flat(node, path=""):
    if not isinstance(node, dict):
        return {path: node}
    return {k: v for key, child in node.items() for k, v in flat(child, f"{path}.{key}".strip(".")).items()}


class MachinePage(tool.EndToEnd):
    def diagram(self, *arguments):
        """Nodes, and edges with their depths."""
        text = self.ok(*arguments)
        nodes = re.findall(r"(?m)^  (\w+);$", text)
        edges = {f"{a}_to_{b}": int(depth) for a, b, depth in re.findall(r"(?m)^  (\w+) -> (\w+) \[label=(\d+)\];$", text)}
        return nodes, edges

    def settings(self):
        return flat(self.stats("simulate", KEEL, "--size", "8x6")["machine"]["settings"])

    def test_boxes(self):
        rows = table("box")
        stems = [re.fullmatch(r"`(\w+)\.\*`", row[1]).group(1) for row in rows]
        self.assertEqual(stems, without_numbers(self.diagram(*EVERYTHING)[0]))
        for row, stem in zip(rows, stems):
            self.assertEqual(row[0].removesuffix(" k").translate(str.maketrans(" -", "__")).replace("colour", "color"), stem)
            self.assertTrue((SOURCE / f"hw_model/{stem}.h").is_file(), stem)

    def test_settings_of_stages(self):
        said = {}
        for _, latency, interval, settings in table("stage"):
            columns = {"latency": latency, "interval": interval}
            group = None
            for path, value in re.findall(r"`([\w.]+)`(?: \(`?([\w,]+)`?\))?", settings):
                group = group if path.startswith(".") else path.partition(".")[0]
                path = group + path if path.startswith(".") else path
                said[path] = number(value or columns[path.rpartition(".")[2]])
        expected = {path: value for path, value in self.settings().items()
                    if not path.startswith("fifos.") and path not in ("clock_mhz", "goal_fps")}
        self.assertEqual(said, expected)

    def test_fifos(self):
        settings = self.settings()
        said = {}
        for name, depth in table("FIFO"):
            name = re.match(r"`(\w+)`", name).group(1)
            setting = depth.strip("`")
            said[name] = number(depth) if depth == setting else settings[setting]
            self.assertEqual(depth == setting, f"fifos.{name}" in settings, name)
        every = {}
        for machine in (EVERYTHING, OTHERS):
            edges = {re.sub(r"_\d+", "", name): depth for name, depth in self.diagram(*machine)[1].items()}
            self.assertEqual([edge for edge in said.items() if edge[0] in edges], list(edges.items()))
            every |= edges
        self.assertEqual(said, every)

    def test_diagram_is_of_the_machine_that_is_simulated(self):
        for options in ((), ("--max-level", "0"), ("--machine", MACHINES / "small.json", "--set", "intersection.units=3")):
            nodes, edges = self.diagram("diagram", KEEL, *options)
            document = self.stats("simulate", KEEL, "--size", "8x6", *options)
            self.assertEqual(nodes, document["machine"]["elaborated"])
            self.assertEqual(edges, {fifo["name"]: fifo["depth"] for fifo in document["fifos"]})
            omitted = [f"  // not built: {unit['name']}; {unit['reason']}" for unit in document["machine"]["omitted"]]
            self.assertEqual(re.findall(r"(?m)^  //.*$", self.ok("diagram", KEEL, *options)), omitted)

    def test_explained_parts(self):
        """Boxes and parts are those of the statistics, and their work is all there is."""
        line = re.compile(r"(?m)^((?:  )?)(\w+) +(\d+|-) +(?:([\d.]+) %|-) +(?:([\d.]+) %|-)  (built|not built): .+$")
        for options in ((), ("--max-level", "0"), ("--machine", MACHINES / "wide.json", "--size", "80x60")):
            document = self.stats("simulate", KEEL, "--explain", *options)
            printed = self.ok("simulate", KEEL, "--explain", *options)
            lines = line.findall(printed)
            boxes = [(name, units, work) for inside, name, units, _, work, _ in lines if not inside]
            built = [name for name, units, _ in boxes for _ in range(int(units) if units != "-" else 0)]
            self.assertEqual(built, [re.sub(r"_\d+$", "", name) for name in document["machine"]["elaborated"]])
            omitted = [name for _, name, *_, kind in lines if kind == "not built"]
            self.assertEqual(omitted, [unit["name"].split(".")[-1] for unit in document["machine"]["omitted"]])
            self.assertAlmostEqual(sum(float(work or 0) for *_, work in boxes), 100, delta=0.05 * len(boxes))
            busy = {unit["name"]: unit["busy"] for unit in document["units"]}
            shown = {name: float(share) for _, name, _, share, *_ in lines if share}
            cycles = document["machine"]["cycles"]
            self.assertAlmostEqual(shown["color_unit"], 100 * busy["color_unit"] / cycles, delta=0.051)

    def test_explained_on_the_page(self):
        page = (SOURCE / "docs/machine.md").read_text()
        quoted = re.search(r"(?m)^    part  (?:.*\n)+?(?=\n)", page).group().splitlines()
        printed = self.ok("simulate", KEEL, "--explain").splitlines()
        self.assertGreater(len(quoted), 10)
        self.assertEqual([line for line in quoted if line[4:] not in [*printed, "  ..."]], [])

    @unittest.skipUnless(shutil.which("dot"), "Graphviz is not installed")
    def test_diagram_is_dot(self):
        run = subprocess.run(["dot", "-Tsvg"], input=self.ok(*EVERYTHING), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             text=True, check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_diagram_mistakes(self):
        self.refused(USAGE, "diagram", says="SCENE is required")
        self.refused(USAGE, "diagram", KEEL, "--max-level", "17", says="--max-level")
        self.refused(INPUT, "diagram", KEEL, "--machine", self.write("machine.json", {"fifos": {"all": 0}}), says="/fifos/all")


if __name__ == "__main__":
    tool.main()
