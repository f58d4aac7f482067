#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""How large trace pages are, and how long they take to open in headless Chromium, as Markdown:
trace_page.py PYRASIM COLUMNSxROWS ..."""
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROUNDS = 5
SOURCE = pathlib.Path(__file__).resolve().parents[2]
PYRASIM = pathlib.Path(sys.argv[1]).resolve()


def events(page):
    """Firings, writes and reads that it holds."""
    header = json.loads(re.search(r'class="run">(.*?)</script>', page.read_text()).group(1))
    return sum(unit["firings"] for unit in header["units"]) + sum(fifo["written"] + fifo["read"] for fifo in header["fifos"])


def milliseconds(page, modules):
    with tempfile.TemporaryDirectory() as folder:
        task = json.dumps({"width": 1400, "height": 1000, "scheme": "light", "steps": []})
        run = subprocess.run(["node", SOURCE / "tests/viewers/page.cjs", modules, "/usr/bin/chromium", page, folder, task],
                             capture_output=True, text=True, check=True)
    return json.loads(run.stdout)["milliseconds"]


def node_modules():
    run = subprocess.run([sys.executable, "-B", "-c", "import viewers; print(viewers.node_modules())", PYRASIM, SOURCE],
                         cwd=SOURCE / "tests/end_to_end", capture_output=True, text=True, check=True)
    return run.stdout.strip()


def main():
    modules = node_modules()
    print("| picture | events | file, MB | opens in, s |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "page.html"
        for size in sys.argv[2:]:
            subprocess.run([PYRASIM, "simulate", SOURCE / "scenes/keel.json", "--size", size, "--trace", page],
                           stdout=subprocess.DEVNULL, check=True)
            times = [milliseconds(page, modules) for _ in range(ROUNDS)]
            print(f"| {size} | {events(page):,} | {page.stat().st_size / 1e6:.1f} | {statistics.median(times) / 1000:.1f} |")


main()
