# SPDX-License-Identifier: Apache-2.0
"""The Debian packages: made by cpack, laid out by dpkg, and run from there."""

import subprocess

import tool
from tool import SOURCE


class Package(tool.EndToEnd):
    def run_command(self, *command):
        run = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             encoding="utf-8", timeout=300, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def field(self, package, name):
        return self.run_command("dpkg-deb", "--field", package, name).strip()

    def test_packages(self):
        self.run_command("cpack", "--config", tool.PYRASIM.parent / "CPackConfig.cmake", "-B", self.folder)
        program, development = (next(self.folder.glob(f"{name}_*.deb")) for name in ("pyrasim", "libpyrasim-dev"))

        depends = self.field(program, "Depends")
        for library in ("libc6", "libstdc++6", "libsystemc", "libfmt", "libpng", "libssl"):
            self.assertRegex(depends, rf"(^|, ){library.replace('+', '[+]')}")
        self.assertIn(f"pyrasim (= {self.field(program, 'Version')})", self.field(development, "Depends"))

        root = self.folder / "root"
        (root / "var/lib/dpkg").mkdir(parents=True)
        (root / "var/lib/dpkg/status").touch()
        self.run_command("dpkg", f"--root={root}", "--force-not-root", "--force-depends", f"--log={self.folder}/log",
                         "--install", program, development)
        listed = self.run_command("dpkg-query", f"--admindir={root}/var/lib/dpkg", "--listfiles", "pyrasim").splitlines()
        for file in ("bin/pyrasim", "share/man/man1/pyrasim.1", "share/bash-completion/completions/pyrasim",
                     "share/zsh/vendor-completions/_pyrasim", "share/fish/vendor_completions.d/pyrasim.fish",
                     "share/pyrasim/scenes/keel.json", "share/doc/pyrasim/copyright"):
            self.assertIn(f"/usr/{file}", listed)
            self.assertTrue((root / "usr" / file).is_file(), file)
        for file in ("lib/libpyrasim_core.a", "lib/libpyrasim_hw.a", "lib/cmake/pyrasim/pyrasimConfig.cmake",
                     "include/pyrasim/hw_model/processor.h", "share/doc/libpyrasim-dev/copyright"):
            self.assertTrue((root / "usr" / file).is_file(), file)

        simulate = ["simulate", SOURCE / "scenes/keel.json", "--size", "64x48"]
        built = self.stats(*simulate)
        tool.PYRASIM = root / "usr/bin/pyrasim"
        simulate[1] = root / "usr/share/pyrasim/scenes/keel.json"
        packaged = self.stats(*simulate)
        for part in ("rays", "machine", "image", "units", "fifos"):
            self.assertEqual(packaged[part], built[part], part)


tool.main()
