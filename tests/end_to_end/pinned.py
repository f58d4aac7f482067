# SPDX-License-Identifier: Apache-2.0
"""Results that were published may change only on purpose: small frames of each shipped scene, on two machines, under both
dispatch policies, in four number formats, against tests/end_to_end/pinned.json.

A change that moves them on purpose says why, and writes the file anew: pinned.py PYRASIM SOURCE --update"""

import json
import sys

import tool
from tool import MACHINES, SCENES, SOURCE

PINNED = SOURCE / "tests/end_to_end/pinned.json"
FRAMES = {"keel": "64x48", "spheres": "64x48", "fins": "64x48", "bunny": "32x24", "blocks": "64x48",
          "quadrics": "64x48", "shadows": "64x48", "tori": "64x48", "crystals": "64x48", "buoys": "64x48",
          "horizon": "64x48", "runway": "64x48", "columns": "64x48"}
MACHINE_FILES = ("small", "wide")
POLICIES = ("round_robin", "first_free")
FORMATS = ("double", "float", "fp24", "fix48.20")


def tested(surface_tests):
    """Kinds of surfaces that a scene does not have are not pinned: there may come more."""
    return {kind: tests for kind, tests in surface_tests.items() if tests}


def pinned_results(document):
    """The part of a run's statistics that is pinned."""
    cases = [[level["empty"], level["covered"], level["edge"]] for level in document["cases"]["by_level"]]
    work = document["work"]
    return {
        "image": document["image"]["sha256"], "rays": document["rays"]["by_level"], "cases": cases,
        "terminal_nodes": document["terminal_nodes"], "box_tests": work["box_tests"],
        "surface_tests": tested(work["surface_tests"]), "cycles": document["machine"]["cycles"]}


class Pinned(tool.EndToEnd):
    def results(self, scene, machine, policy, scalar):
        return pinned_results(self.stats(
            "simulate", SCENES / f"{scene}.json", "--size", FRAMES[scene], "--scalar", scalar, "--machine",
            MACHINES / f"{machine}.json", "--set", f"intersection.dispatch={policy}"))

    def all_results(self):
        return {f"{scene} {machine} {policy} {scalar}": self.results(scene, machine, policy, scalar)
                for scene in FRAMES for machine in MACHINE_FILES for policy in POLICIES for scalar in FORMATS}

    def test_results(self):
        expected = json.loads(PINNED.read_text())
        results = self.all_results()
        self.assertEqual(results.keys(), expected.keys())
        for run, result in results.items():
            with self.subTest(run=run):
                pinned = expected[run]
                self.assertEqual(result, pinned | {"surface_tests": tested(pinned["surface_tests"])})


def update():
    test = Pinned("test_results")
    test.setUp()
    rows = [f"{json.dumps(run)}: {json.dumps(result)}" for run, result in test.all_results().items()]
    PINNED.write_text("{\n" + ",\n".join(rows) + "\n}\n")
    test.doCleanups()


if __name__ == "__main__":
    if sys.argv[3:] == ["--update"]:
        update()
    else:
        tool.main()
