# SPDX-License-Identifier: Apache-2.0
"""The manual page and the shells' completion, which the program makes of its own command line."""

import os
import re
import shutil
import subprocess
import unittest

import tool
from tool import USAGE

SHELLS = ("bash", "zsh", "fish")


class Documents(tool.EndToEnd):
    def commands(self):
        """The words of each command that has none below it, and its options' long names, as --help lists them."""
        found = {}

        def visit(*words):
            text = self.ok(*words, "--help")
            below = re.search(r"(?ms)^Subcommands:\n(.*?)\n\n", text)
            for name in re.findall(r"(?m)^  (\w+)", below.group(1)) if below else ():
                visit(*words, name)
            if not below:
                found[words] = re.findall(r"(?m)^  (?:-\w,)?(--[\w-]+)", text)
        visit()
        self.assertIn(("study", "numerics"), found)
        return found

    def completed(self, shell, script, line):
        """What `shell` offers for the last word of `line`."""
        if shell == "fish":
            command = ["fish", "--no-config", "-c", "source $argv[1]; complete --do-complete $argv[2]", script, line]
        else:
            words = line.replace("=", " = ").split(" ")
            command = ["bash", "--norc", "-c",
                       'source "$1"; shift; COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)); '
                       f'"$(complete -p pyrasim | sed "s/.*-F //; s/ .*//")"; printf "%s\\n" "${{COMPREPLY[@]}}"',
                       "bash", script, *words]
        environment = {**os.environ, "PATH": f"{tool.PYRASIM.parent}:{os.environ['PATH']}", "HOME": str(self.folder)}
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True,
                             cwd=self.folder, env=environment, timeout=60, check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""), line)
        return [offer.split("\t")[0] for offer in run.stdout.splitlines() if offer]

    def check_completion(self, shell):
        script = self.write(f"completion.{shell}", self.ok("completion", shell))
        self.write("scene.json", "{}")
        commands = self.commands()
        names = {words[0] for words in commands}
        self.assertEqual(set(self.completed(shell, script, "pyrasim ")), names)
        for words, options in commands.items():
            offers = self.completed(shell, script, " ".join(["pyrasim", *words, "--"]))
            self.assertEqual({offer for offer in offers if offer.startswith("--")}, set(options), words)
        for line, offers in (
                ("pyrasim sim", ["simulate"]), ("pyrasim study ", ["numerics"]), ("pyrasim simulate --eng", ["--engine"]),
                ("pyrasim simulate --engine ", ["decoupled", "lockstep"]), ("pyrasim simulate --max-level ", ["auto"]),
                ("pyrasim simulate a.json --size 8x6 --engine l", ["lockstep"]), ("pyrasim simulate --size ", []),
                ("pyrasim study numerics --max-l", ["--max-level"]), ("pyrasim completion ", sorted(SHELLS)),
                ("pyrasim simulate --machine sc", ["scene.json"]), ("pyrasim render -o sc", ["scene.json"]),
                ("pyrasim check sc", ["scene.json"]), ("pyrasim formats sc", [])):
            self.assertEqual(sorted(self.completed(shell, script, line)), offers, line)
        joined = [offer.split("=")[-1] for offer in self.completed(shell, script, "pyrasim simulate --engine=")]
        self.assertEqual(sorted(joined), ["decoupled", "lockstep"])

    def test_bash(self):
        self.check_completion("bash")

    @unittest.skipUnless(shutil.which("fish"), "tools/setup test installs it")
    def test_fish(self):
        self.check_completion("fish")

    @unittest.skipUnless(shutil.which("zsh"), "tools/setup test installs it")
    def test_zsh(self):
        """zsh completes at a terminal only: there, what it lists for a tab."""
        self.write("_pyrasim", self.ok("completion", "zsh"))
        self.write("scene.json", "{}")
        script = self.write("try.zsh", ZSH)
        for line, offers in (("pyrasim sim", "pyrasim simulate "), ("pyrasim study n", "pyrasim study numerics "),
                             ("pyrasim simulate --eng", "pyrasim simulate --engine="),
                             ("pyrasim simulate --engine l", "pyrasim simulate --engine lockstep "),
                             ("pyrasim simulate --engine=d", "pyrasim simulate --engine=decoupled "),
                             ("pyrasim study numerics --max-l", "pyrasim study numerics --max-level="),
                             ("pyrasim completion f", "pyrasim completion fish "),
                             ("pyrasim render -o sc", "pyrasim render -o scene.json "),
                             ("pyrasim compare scene.json sc", "pyrasim compare scene.json scene.json ")):
            run = subprocess.run(["zsh", "-f", script, line], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                 stdin=subprocess.DEVNULL, cwd=self.folder, timeout=60, check=False)
            self.assertEqual((run.stdout, run.stderr), (f"<{offers}>\n", ""), line)

    def test_manual_page(self):
        page = self.ok("man").replace("\\-", "-")
        self.assertTrue(page.startswith('.TH PYRASIM 1 "" "pyrasim '), page[:80])
        sections = dict(re.findall(r"(?ms)^\.SS (\w+)\n(.*?)(?=^\.S|\Z)", page))
        for words, options in self.commands().items():
            for option in set(options) - {"--help"}:
                self.assertRegex(sections[words[-1]], rf"\\fB{option}\\fR", words)
        self.assertIn("128 + N ended by signal N", page.split(".SH EXIT STATUS")[1])

    @unittest.skipUnless(shutil.which("groff"), "tools/setup test installs it")
    def test_manual_page_is_roff(self):
        page = self.write("pyrasim.1", self.ok("man"))
        run = subprocess.run(["groff", "-man", "-Tutf8", "-ww", page], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             encoding="utf-8", check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertIn("pyrasim - what does a picture cost", run.stdout)

    def test_mistakes(self):
        self.refused(USAGE, "completion", says="SHELL is required")
        self.refused(USAGE, "completion", "tcsh", says="bash or zsh or fish is allowed")


# Types the argument and a tab into a zsh of its own, and prints the line as it is then.
ZSH = r"""
zmodload zsh/zpty
zpty -b shell zsh -f -i
zpty -w shell "PS1= ; unsetopt prompt_cr prompt_sp; fpath=($PWD \$fpath); autoload -Uz compinit; compinit -D -u"
zpty -w shell 'show() { print -r -- "<$BUFFER>" >line; BUFFER=; zle accept-line }; zle -N show; bindkey "^X" show'
zpty -w shell 'print -n read''y'
until zpty -r shell heard && [[ $heard == *ready* ]]; do :; done
zpty -w -n shell "$1"$'\t\x18'
until [[ -s line ]]; do zpty -r -t shell heard || sleep 0.05; done
cat line; rm line
zpty -d shell
"""


tool.main()
