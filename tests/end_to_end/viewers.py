# SPDX-License-Identifier: Apache-2.0
"""Where programs of others are that read traces."""

import pathlib
import shutil
import subprocess

from tool import SOURCE

CHROMIUM = pathlib.Path("/usr/bin/chromium")
VIEWERS = SOURCE / "tests/viewers"
PATIENCE = 600  # seconds for one of them, which takes some: machines may be slow and busy


def node_modules():
    """The packages of tests/viewers/package.json, installed once for each list of versions."""
    folder, lock = SOURCE / "build/viewers", VIEWERS / "package-lock.json"
    done = folder / "installed.json"
    if not done.exists() or done.read_bytes() != lock.read_bytes():
        folder.mkdir(parents=True, exist_ok=True)
        for file in (VIEWERS / "package.json", lock):
            shutil.copy(file, folder)
        subprocess.run(["npm", "ci", "--silent", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=folder, check=True,
                       timeout=PATIENCE)
        shutil.copy(lock, done)
    return folder / "node_modules"
