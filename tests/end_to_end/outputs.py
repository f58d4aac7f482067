# SPDX-License-Identifier: Apache-2.0
"""Where output goes: files that cannot be written, a full stdout, descriptors, and what a success leaves."""

import json
import os
import subprocess
import xml.etree.ElementTree

import tool
from tool import OK, RUN_FAILED, USAGE


class Outputs(tool.EndToEnd):
    def setUp(self):
        super().setUp()
        self.scene = self.write("scene.json", tool.scene())
        for ending in ("png", "json", "csv"):
            (self.folder / f"folder.{ending}").mkdir()

    def test_cannot_write(self):
        for name in ("missing/out", "folder"):
            target, stats, rows = (f"{name}.{ending}" for ending in ("png", "json", "csv"))
            for command in ("render", "simulate"):
                self.refused(RUN_FAILED, command, self.scene, "-o", target, says=f"{target}: cannot write")
                self.refused(RUN_FAILED, command, self.scene, "--stats", stats, says=f"{stats}: cannot write")
                self.refused(RUN_FAILED, command, self.scene, "-o", target, "--stats", "missing/out.json", says=target)
                self.refused(RUN_FAILED, command, self.scene, "-o", "good.png", "--stats", stats, says=stats)
                self.refused(RUN_FAILED, command, self.scene, "-o", target, "--stats", "good.json", says=target)
            self.refused(RUN_FAILED, "sweep", self.scene, "--csv", rows, says=rows)
        self.refused(RUN_FAILED, "simulate", self.scene, "--trace", "missing/out.vcd", "-o", "good.png",
                     says="missing/out.vcd: cannot write")
        self.refused(RUN_FAILED, "export", self.scene, "-o", "missing/out.pov", says="missing/out.pov: cannot write")
        self.refused(RUN_FAILED, "render", self.scene, "--stats", "/dev/full", "-o", "/dev/null/out.png")
        for ending in ("bmp", "PNG", "json", ""):
            self.refused(USAGE, "render", self.scene, "-o", f"out.{ending}", says="its name must end in .png or .pfm")

    def test_read_only_folder(self):
        if os.geteuid() == 0:
            self.skipTest("root writes everywhere")
        folder = self.folder / "read_only"
        folder.mkdir(mode=0o555)
        self.refused(RUN_FAILED, "render", self.scene, "-o", folder / "out.png", says="cannot write")

    def test_full(self):
        self.ok("render", self.scene, "-o", "out.pfm")
        with open("/dev/full", "wb") as full:
            for arguments in (["render", self.scene, "--stats", "-"], ["simulate", self.scene, "--stats", "-"],
                              ["simulate", self.scene, "--trace", "-"], ["simulate", self.scene],
                              ["sweep", self.scene, "--max-level", "1", "--reference", "point"],
                              ["sweep", self.scene, "--max-level", "1", "--reference", "point", "--csv", "-"],
                              ["check", self.scene], ["level"], ["export", self.scene, "-o", "-"], ["compare", "out.pfm", "out.pfm", "--crop", "4x4"],
                              ["--help"], ["--version"]):
                run = self.run_tool(*arguments, stdout=full)
                self.assertEqual(run.returncode, RUN_FAILED, arguments)
                self.assertTrue(run.stderr.endswith("stdout: cannot write\n"), run.stderr)
        self.refused(RUN_FAILED, "render", self.scene, "--stats", "/dev/full", says="/dev/full: cannot write")

    def test_closed_pipe(self):
        """A reader that leaves early ends the run without a word."""
        with subprocess.Popen([tool.PYRASIM, "simulate", self.scene, "--trace", "-"], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            process.stdout.close()
            self.assertNotEqual(process.wait(timeout=60), OK)
            self.assertLessEqual(len(process.stderr.read().splitlines()), 1)

    def test_success(self):
        self.write("old.png", "an old file")
        before = set(self.listing())
        self.assertEqual(self.ok("render", self.scene, "-o", "old.png", "--stats", "new.json"), "")
        self.assertEqual(set(self.listing()) - before, {str(self.folder / "new.json")})
        self.assertTrue((self.folder / "old.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n"))
        table = self.ok("simulate", self.scene, "-o", "new.pfm", "--stats", "new.json", "--trace", "new.vcd")
        self.assertIn("cycles", table)
        self.assertEqual(set(self.listing()) - before,
                         {str(self.folder / name) for name in ("new.json", "new.pfm", "new.vcd")})
        first = (self.folder / "old.png").read_bytes()
        self.ok("render", self.scene, "-o", "old.png", "--stats", "new.json")
        self.assertEqual((self.folder / "old.png").read_bytes(), first)  # the same command, the same bytes

    def test_simulation_is_silent(self):
        """No warning of SystemC's, no bar, no greeting: stderr is empty."""
        for scene in sorted(tool.SCENES.glob("*.json")):
            for options in (["--engine", "lockstep"], ["--engine", "decoupled", "--max-level", "0"],
                            ["--max-level", "5", "--machine", tool.MACHINES / "small.json"]):
                output = self.ok("simulate", scene, "--size", "16x12", *options)
                self.assertNotIn("SystemC", output)
        self.ok("sweep", tool.SCENES / "keel.json", "--size", "16x12,20x15", "--max-level", "0:2", "--reference",
                "point")

    def shell(self, redirections, *arguments):
        """A finished run whose descriptors are as a shell makes them: "2>&-", ">> log"."""
        return subprocess.run(["sh", "-c", f'exec "$0" "$@" {redirections}', tool.PYRASIM, *map(str, arguments)],
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder,
                              timeout=60, encoding="utf-8", check=False)

    def test_closed_descriptors(self):
        """No output takes the place of a stream that is closed, and nothing printed lands in it."""
        table_on_stdout = ["simulate", self.scene, "-o", "out.png", "--stats", "out.json", "--trace", "out.vcd"]
        table_on_stderr = ["simulate", self.scene, "-o", "out.png", "--stats", "-", "--trace", "out.vcd"]
        for arguments in (table_on_stdout, table_on_stderr):
            def outputs():
                return {name: (self.folder / name).read_bytes() for name in ("out.png", "out.vcd")}
            self.run_tool(*arguments)
            expected = outputs()
            for closed in ("<&-", ">&-", "2>&-", "<&- >&-", ">&- 2>&-", "<&- >&- 2>&-"):
                self.assertEqual(self.shell(closed, *arguments).returncode, OK, closed)
                self.assertEqual(outputs(), expected, closed)
        for closed in ("2>&-", "<&- 2>&-"):
            self.assertIn("machine", json.loads(self.shell(closed, *table_on_stderr).stdout))

    def test_descriptors(self):
        """What a descriptor leads to is written where its opener wants it, and is not replaced."""
        def content(name):
            return (self.folder / name).read_text()
        self.ok("render", self.scene, "--stats", "plain.json")
        for name in ("/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "-"):
            arguments = ["render", self.scene, "--stats", name]
            document = self.run_tool(*arguments).stdout
            self.assertEqual(json.loads(document)["rays"], tool.read_json(self.folder / "plain.json")["rays"])
            self.write("log", "old\n")
            self.assertEqual(self.shell(">> log", *arguments).returncode, OK)
            self.assertEqual(content("log"), "old\n" + document)
            self.assertEqual(self.shell("> log", *arguments).returncode, OK)
            self.assertEqual(content("log"), document)
        for name in ("/dev/stderr", "/dev/fd/3"):
            arguments = ["simulate", self.scene, "--stats", name]
            self.write("log", "old\n")
            run = self.shell("2>> log 3>> log", *arguments)
            self.assertEqual(run.returncode, OK)
            self.assertIn("cycles", run.stdout)
            self.assertEqual(content("log")[:6], "old\n{\n")
        self.refused(RUN_FAILED, "render", self.scene, "--stats", "/dev/fd/9", says="/dev/fd/9: cannot write: Bad file")

    def test_table_gives_way(self):
        """Where an output takes stdout, by whatever name, the table goes to stderr."""
        for command in (["simulate", self.scene], ["budget", self.scene]):
            for name in ("-", "/dev/stdout", "/proc/self/fd/1"):
                run = self.run_tool(*command, "--stats", name)
                self.assertEqual(run.returncode, OK, run.stderr)
                self.assertIn("scene", json.loads(run.stdout))
                self.assertIn("frames per second", run.stderr)
        run = self.shell("> out.json", "simulate", self.scene, "--stats", "out.json")
        self.assertIn("machine", tool.read_json(self.folder / "out.json"))
        self.assertIn("cycles", run.stderr)

    def test_symbolic_links(self):
        """A link stays; what it leads to is written, also where that does not exist yet."""
        (self.folder / "sub").mkdir()
        (self.folder / "new.png").symlink_to("sub/target.png")
        (self.folder / "again.png").symlink_to("new.png")
        for _ in range(2):
            self.ok("render", self.scene, "-o", "again.png")
            self.assertTrue((self.folder / "new.png").is_symlink() and (self.folder / "again.png").is_symlink())
            self.assertTrue((self.folder / "sub/target.png").read_bytes().startswith(b"\x89PNG"))
        (self.folder / "astray.png").symlink_to("missing/target.png")
        self.refused(RUN_FAILED, "render", self.scene, "-o", "astray.png", says="astray.png: cannot write: No such file")

    def test_two_outputs_in_one(self):
        """One would be lost: refused before the work, whatever the names; both options are named."""
        self.write("there.vcd", "old")
        os.link(self.folder / "there.vcd", self.folder / "hard.vcd")
        (self.folder / "soft.vcd").symlink_to("there.vcd")
        (self.folder / "dangling.vcd").symlink_to("new.vcd")
        (self.folder / "here").symlink_to(".")
        os.mkfifo(self.folder / "pipe.vcd")
        for first, second in (("new.vcd", "new.vcd"), ("new.vcd", "./new.vcd"), ("new.vcd", "here/new.vcd"),
                              ("new.vcd", self.folder / "new.vcd"), ("new.vcd", "dangling.vcd"),
                              ("there.vcd", "hard.vcd"), ("there.vcd", "soft.vcd"), ("pipe.vcd", "pipe.vcd"),
                              ("-", "-"), ("-", "/dev/stdout"), ("/dev/stdout", "/dev/fd/1"),
                              ("/dev/stderr", "/proc/self/fd/2")):
            self.refused(USAGE, "simulate", self.scene, "--trace", first, "--trace", second,
                         says=f"--trace {first} and --trace {second} are one file or stream")
        for command, options in ((["render"], ("-o", "--stats")), (["simulate"], ("-o", "--stats")),
                                 (["simulate"], ("-o", "--trace")), (["compare", "a.pfm"], ("-o", "--stats")),
                                 (["study", "numerics"], ("--csv", "--plot"))):
            name = {"-o": "same.png", "--csv": "same.csv"}[options[0]]
            second = {"--stats": name, "--trace": "same.vcd", "--plot": "same.svg"}[options[1]]
            if second != name:
                (self.folder / second).symlink_to(name)
            input_file = "b.pfm" if command[0] == "compare" else self.scene
            self.refused(USAGE, *command, input_file, options[0], name, options[1], second,
                         says=f"{options[0]} {name} and {options[1]} {second} are one file or stream")
        self.ok("simulate", self.scene, "--stats", "/dev/null", "--trace", "/dev/null")
        log = self.shell("2> out.json", "simulate", self.scene, "--stats", "out.json")
        self.assertEqual(log.returncode, USAGE)
        self.assertIn("stderr goes to this file", (self.folder / "out.json").read_text())

    def test_output_that_is_an_input(self):
        """It would be replaced: refused before the work, and the input stays."""
        mesh = self.write("mesh.obj", "v 5 -1 -1\nv 5 1 -1\nv 5 0 1\nf 1 2 3\n")
        scene = self.write("mesh.json", tool.scene([{"type": "mesh", "file": "mesh.obj", "color": [1, 1, 1]}]))
        machine = self.write("machine.json", {"clock_mhz": 100})
        (self.folder / "soft.json").symlink_to("mesh.json")
        self.write("a.pfm", b"PF\n1 1\n-1.0\n" + bytes(12))
        self.write("b.pfm", b"PF\n1 1\n-1.0\n" + bytes(12))
        before = {file: (self.folder / file).read_bytes() for file in ("mesh.json", "mesh.obj", "machine.json", "a.pfm")}
        for command in (["render"], ["simulate"], ["budget"]):
            for output in ("mesh.json", "./mesh.json", scene, "soft.json", "mesh.obj", mesh):
                self.refused(USAGE, *command, "mesh.json", "--stats", output,
                             says=f"--stats {output}: SCENE reads this file")
        for command in (["simulate"], ["budget"]):
            self.refused(USAGE, *command, "mesh.json", "--machine", machine, "--stats", "machine.json",
                         says="--stats machine.json: --machine reads this file")
        self.refused(USAGE, "sweep", "mesh.json", "--csv", "mesh.obj", says="--csv mesh.obj: SCENE reads this file")
        self.refused(USAGE, "study", "numerics", "mesh.json", "--csv", "mesh.obj", says="SCENE reads this file")
        self.refused(USAGE, "compare", "a.pfm", "b.pfm", "-o", "a.pfm", says="-o a.pfm: FIRST reads this file")
        self.refused(USAGE, "compare", "a.pfm", "b.pfm", "-o", "./b.pfm", says="-o ./b.pfm: SECOND reads this file")
        self.assertEqual({file: (self.folder / file).read_bytes() for file in before}, before)

    def test_kinds(self):
        """A name whose ending says another kind than is written is refused; a stream takes what it is sent."""
        for name in ("x.ghw", "x", "x.VCD", "x.pf"):
            self.refused(USAGE, "simulate", self.scene, "--trace", name, says=f"--trace {name}: its name must end in .vcd")
        for name in ("x.png", "x.pdf", "x"):
            self.refused(USAGE, "study", "numerics", self.scene, "--plot", name, says="its name must end in .svg")
        for name in ("x.png", "x.POV", "x"):
            self.refused(USAGE, "export", self.scene, "-o", name, says="its name must end in .pov")
        os.mkfifo(self.folder / "pipe.csv")
        self.ok("simulate", self.scene, "--trace", "run.ptrace")
        for option, own, commands in (("--stats", ".json", (["simulate"], ["render"], ["budget"], ["whatif"], ["compare"])),
                                      ("--csv", ".csv", (["sweep"], ["study", "numerics"], ["whatif"])),
                                      ("--resume", ".csv", (["sweep"],))):
            for command in commands:
                read = {"whatif": ["run.ptrace"], "compare": ["a.pfm", "b.pfm"]}.get(command[0], [self.scene])
                for ending in {".csv", ".json", ".png", ".pfm", ".svg", ".pov", ".vcd", ".fst", ".pftrace", ".kanata", ".gtkw",
                               ".ptrace", ".html"} - {own}:
                    self.refused(USAGE, *command, *read, option, f"x{ending}",
                                 says=f"{option} x{ending}: {ending} is the ending of another format; one that ends in {own} is")
        for name in ("x", "x.txt", "x.JSON", "x.csv.old", "x.json"):
            self.ok("render", self.scene, "--stats", name)
        with subprocess.Popen(["cat", self.folder / "pipe.csv"], stdout=subprocess.PIPE) as reader:
            self.ok("render", self.scene, "--stats", "pipe.csv")
            self.assertTrue(json.loads(reader.communicate()[0]))
        for name in ("-", "/dev/stdout", "/dev/fd/1"):
            self.assertTrue(self.run_tool("export", self.scene, "-o", name).stdout.startswith("// pyrasim"))
            self.assertTrue(self.run_tool("simulate", self.scene, "--trace", name).stdout.startswith("$"))

    def test_names_in_files(self):
        """A file's name of any bytes leaves plots, pictures and statistics valid; the recorded command line is exact."""
        name = b"a\x1b[2J\x9b\xc2\x9b\xff<&>'\\ \n\xe2\x82\xac.json"
        (self.folder / os.fsdecode(name)).write_text(json.dumps(tool.scene()))
        self.ok("study", "numerics", name, "--formats", "fp16", "--plot", "plot.svg")
        plot = xml.etree.ElementTree.parse(self.folder / "plot.svg").getroot()
        self.assertIn("<&>'\\ \ufffd\u20ac.json", "".join(plot.itertext()))
        self.ok("render", name, "-o", "out.png", "--stats", "out.json")
        command = tool.read_json(self.folder / "out.json")["command"]
        self.assertTrue(command.isprintable(), command)
        texts = dict(tool.texts_of_png(self.folder / "out.png"))
        self.assertEqual(texts["Comment"], command)
        words = subprocess.run(["bash", "-c", f"printf '%s\\0' {command}"], stdout=subprocess.PIPE, check=True).stdout
        self.assertEqual(words.split(b"\0")[:-1], [b"pyrasim", b"render", name, b"-o", b"out.png", b"--stats", b"out.json"])
        self.assertEqual(dict(tool.texts_of_png(self.picture("plain.json")))["Comment"],
                         "pyrasim render plain.json -o out.png")

    def picture(self, scene):
        self.write(scene, tool.scene())
        self.ok("render", scene, "-o", "out.png")
        return self.folder / "out.png"

    def test_render_without_output(self):
        """Its counts, as simulate prints them."""
        table = self.ok("render", self.scene)
        simulated = self.ok("simulate", self.scene)
        counts = table[table.index("rays") :]
        self.assertIn("level", counts)
        self.assertIn(counts, simulated)
        self.assertEqual(self.ok("render", self.scene, "-o", "out.png"), "")
        self.assertRegex(self.ok("render", self.scene, "--method", "grid:2"), r"8x6 pixels, grid:2\n\nrays +192 ")


tool.main()
