#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the mistakes of mutations.toml one by one, and sees that the tests named with each notice it.

    run.py [--only NAME] [--jobs N]     in build/mutations, a copy of the sources; --only may be repeated
    run.py --check BUILD                changes nothing: every mistake can be made, and its tests exist in that build

Exit code 0: all are noticed but those that are listed with a reason; 1 otherwise; 2 the list is wrong."""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import tomllib

SOURCE = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("src", "hw_model", "tests", "scenes", "machines", "docs", "tools", "cmake", "examples")
KEYS = {"name", "file", "old", "new", "tests", "why"}
PRESET = "release"  # without assertions: what they notice, a user's build does not
SECONDS_A_TEST = 120


class ListError(Exception):
    pass


def read_list():
    mutations = tomllib.loads((SOURCE / "tests/mutations/mutations.toml").read_text())["mutation"]
    names = [mutation.get("name") for mutation in mutations]
    for mutation in mutations:
        name = mutation.get("name")
        if not KEYS <= mutation.keys() <= KEYS | {"survives"}:
            raise ListError(f"{name}: needs {', '.join(sorted(KEYS))}, and allows survives")
        if names.count(name) > 1:
            raise ListError(f"{name}: there are two of that name")
        mutated(mutation, SOURCE)
    return mutations


def mutated(mutation, folder):
    """The file's text with the mistake in it."""
    file = folder / mutation["file"]
    text = file.read_text() if file.is_file() else ""
    occurrences = text.count(mutation["old"])
    if occurrences != 1:
        raise ListError(f"{mutation['name']}: {mutation['file']} has its old text {occurrences} times, not once")
    return text.replace(mutation["old"], mutation["new"])


def targets_of(mutations):
    return sorted({entry.split()[0] for mutation in mutations for entry in mutation["tests"]})


def check(build):
    mutations = read_list()
    if len(mutations) < 40:
        raise ListError(f"only {len(mutations)} mutations")
    listing = subprocess.run(["ctest", "--test-dir", build, "-N"], capture_output=True, text=True, check=True).stdout
    tests = re.findall(r"Test +#\d+: (.+)", listing)
    for mutation in mutations:
        for entry in mutation["tests"]:
            if not any(re.search(entry.split()[1], test) for test in tests):
                raise ListError(f"{mutation['name']}: no test matches {entry}")
    print(f"{len(mutations)} mutations apply, and all of their tests exist")


def copy_tree(tree):
    """A copy of the sources, in which what is the same keeps its date."""
    for name in ("CMakeLists.txt", "CMakePresets.json", *FOLDERS):
        source = SOURCE / name
        files = [path for path in source.rglob("*") if path.is_file()] if source.is_dir() else [source]
        wanted = {tree / file.relative_to(SOURCE) for file in files}
        for path in (tree / name).rglob("*"):
            if path.is_file() and path not in wanted:
                path.unlink()
        for file in files:
            copy = tree / file.relative_to(SOURCE)
            if copy.is_file() and copy.read_bytes() == file.read_bytes():
                continue
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, copy)


class Workshop:
    """The copy, and what is built from it."""

    def __init__(self, tree, jobs):
        self.tree = tree
        self.build_folder = tree / "build" / PRESET
        self.jobs = jobs
        # Paths below it do not matter to ccache: what the sources' own build has compiled need not be compiled again.
        self.environment = {**os.environ, "CCACHE_BASEDIR": str(tree), "CCACHE_NOHASHDIR": "1"}
        copy_tree(self.tree)
        if self.run("cmake", "--preset", PRESET) != 0:
            sys.exit(self.words)

    def run(self, *command):
        """The command's exit code; its words are kept for who asks why."""
        done = subprocess.run(list(map(str, command)), cwd=self.tree, env=self.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace")
        self.words = done.stdout
        return done.returncode

    def build(self, targets):
        return self.run("cmake", "--build", self.build_folder, "--target", *targets, "--", f"-j{self.jobs}") == 0

    def passes(self, entry):
        return self.run("ctest", "--test-dir", self.build_folder, "-R", entry.split()[1], "--no-tests=error",
                        "--stop-on-failure", f"-j{self.jobs}", "--timeout", SECONDS_A_TEST) == 0

    def failed_test(self):
        """The first of those that ctest named as failed."""
        failed = re.search(r"^\s*\d+ - (.+)$", self.words, re.MULTILINE)
        return failed.group(1) if failed else ""

    def judge(self, mutation):
        """What becomes of one mistake, and the last test that noticed it; afterwards the file is as it was."""
        file = self.tree / mutation["file"]
        original = file.read_text()
        file.write_text(mutated(mutation, self.tree))
        try:
            if not self.build(targets_of([mutation])):
                return "DOES NOT BUILD", ""
            if any(self.passes(entry) for entry in mutation["tests"]):
                return "SURVIVED", ""
            return "caught", self.failed_test()
        finally:
            file.write_text(original)


def outcome(mutation, verdict):
    """The line's first word, and whether all is well."""
    reason = mutation.get("survives")
    if verdict == "SURVIVED" and reason:
        return "survives", True
    if verdict == "caught" and reason:
        return "CAUGHT, though listed as a survivor", False
    return verdict, verdict == "caught"


def judge_all(mutations, workshop):
    targets = targets_of(mutations)
    if not workshop.build(targets):
        sys.exit(workshop.words)
    for entry in sorted({entry for mutation in mutations for entry in mutation["tests"]}):
        if not workshop.passes(entry):
            sys.exit(f"{entry} fails without any mistake:\n{workshop.words}")
    all_well = True
    counts = {}
    for mutation in mutations:
        begun = time.monotonic()
        verdict, noticed_by = workshop.judge(mutation)
        word, well = outcome(mutation, verdict)
        all_well = all_well and well
        counts[word] = counts.get(word, 0) + 1
        remark = mutation["survives"] if word == "survives" else noticed_by
        print(f"{word:9} {time.monotonic() - begun:4.0f} s  {mutation['name']}: {remark}", flush=True)
    print(", ".join(f"{count} {word}" for word, count in counts.items()))
    return all_well


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", metavar="NAME")
    parser.add_argument("--jobs", type=int, default=2, metavar="N")
    parser.add_argument("--check", metavar="BUILD")
    arguments = parser.parse_args()
    try:
        if arguments.check:
            check(arguments.check)
            return 0
        mutations = read_list()
        if arguments.only:
            unknown = set(arguments.only) - {mutation["name"] for mutation in mutations}
            if unknown:
                raise ListError(f"no mutation is named {', '.join(sorted(unknown))}")
            mutations = [mutation for mutation in mutations if mutation["name"] in arguments.only]
        return 0 if judge_all(mutations, Workshop(SOURCE / "build/mutations", arguments.jobs)) else 1
    except ListError as error:
        print(f"mutations.toml: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
