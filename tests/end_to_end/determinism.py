# SPDX-License-Identifier: Apache-2.0
"""The same result from every compiler and optimisation level, with and without traces, run after run."""

import tool

OTHER = tool.SOURCE / "build" / "clang" / "pyrasim"  # clang++ -O0, by tools/build clang
RUNS = [("keel.json", "64x48", 4, []), ("spheres.json", "48x36", 3, ["--set", "intersection.dispatch=first_free"]),
        ("fins.json", "48x36", 5, ["--set", "fifos.all=1"]), ("bunny.json", "32x24", 3, ["--scalar", "float"]),
        ("bunny.json", "32x24", 3, ["--engine", "lockstep"])]


class Determinism(tool.EndToEnd):
    def document(self, scene, size, max_level, options, program=None, more=()):
        """Statistics of a simulation, and the picture's bytes; without what names the command."""
        own = tool.PYRASIM
        tool.PYRASIM = program or own
        try:
            document = self.stats("simulate", tool.SCENES / scene, "--size", size, "--max-level", max_level, *options,
                                  "-o", "image.pfm", *more)
        finally:
            tool.PYRASIM = own
        del document["command"]
        return document, (self.folder / "image.pfm").read_bytes()

    def test_compilers_and_optimisation_levels(self):
        self.assertTrue(OTHER.exists(), f"{OTHER} is missing: tools/build clang makes it")
        for run in RUNS:
            self.assertEqual(self.document(*run), self.document(*run, program=OTHER), run)

    def test_traces_threads_and_repetition(self):
        for run in RUNS:
            first = self.document(*run)
            for more in ([], ["--trace", "trace.vcd"], ["--threads", "1"], ["--threads", "2"]):
                self.assertEqual(self.document(*run, more=more), first, (run, more))
        self.document(*RUNS[0], more=["--trace", "again.vcd"])
        self.document(*RUNS[0], more=["--trace", "trace.vcd"])
        self.assertEqual((self.folder / "again.vcd").read_bytes(), (self.folder / "trace.vcd").read_bytes())


tool.main()
