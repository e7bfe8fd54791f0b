# SPDX-License-Identifier: MIT
"""`./grass format` formats every source, and the layer `format` fails on those that it would change.

C++ by the clang-format of Debian 12, so that everyone's is the same; Python by ruff, GDScript by gdformat. Shaders have
no formatter: spaces and indentation are checked. So are the width of all sources, texts beyond ASCII (encodings.py), what
GCC does wrong on Windows (windows_rules.py), and threads of our own (thread_rules.py).
"""

import os
import re
import shutil
import subprocess
import sys

from tools.build.toolchains import CLANG
from tools.fetch import machine, pip_packages
from tools.fetch.roots import CROSS
from tools.places import ROOT, TOOLS
from tools.say import Failure
from tools.test import encodings, thread_rules, windows_rules, workflows

PACKAGES = TOOLS / "format"
REQUIREMENTS = ROOT / "tools/test/format_requirements.txt"
KINDS = {
	"cpp": (".c", ".cpp", ".h", ".hpp"),
	"python": (".py",),
	"gdscript": (".gd",),
	"shaders": (".glsl", ".inc", ".gdshader", ".gdshaderinc"),
}
FOLDERS = ("extension", "tests", "shaders", "godot_project", "tools", "docs", "lab")
LEFT_OUT = {"bin", ".godot", "__pycache__"}
WIDTH, TAB = 140, 4  # of a line of a source, and of a tab in it
TEXT = re.compile(r"""(?<!")"(?!")(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'(?=[,)\]}% ])""")


def sources(kind):
	"""Returns the paths of all files of a kind."""
	found = [path for path in ROOT.iterdir() if path.suffix in KINDS[kind]]
	for folder in FOLDERS:
		for place, folders, names in os.walk(ROOT / folder):
			folders[:] = [name for name in folders if name not in LEFT_OUT]
			found += [ROOT / place / name for name in names if name.endswith(KINDS[kind])]
	return sorted([*found, ROOT / "SConstruct"] if kind == "python" else found)


def clang_format():
	"""Returns the path of a clang-format of the right version, the machine's or the fetched one. None if there is neither."""
	fetched = CROSS.place / f"usr/bin/clang-format-{CLANG}"
	for found in filter(None, (shutil.which(f"clang-format-{CLANG}"), shutil.which("clang-format"), fetched.exists() and str(fetched))):
		said = subprocess.run([found, "--version"], capture_output=True, text=True).stdout
		if f"version {CLANG}." in said:
			return found
	return None


def ensure():
	machine.ensure((clang_format, (f"clang-format-{CLANG}", "patchelf"), CROSS))
	pip_packages.ensure(REQUIREMENTS, PACKAGES, "formatters of Python and GDScript")
	if not (PACKAGES / ".cache").exists():  # gdformat makes it, and fails where two of its processes do so at once
		run(formatters()["gdscript"][1], [path.relative_to(ROOT) for path in sources("gdscript")[:1]])


def run(command, paths):
	"""Runs a formatter over `paths`, as many at a time as there are processors; returns its output, and whether all went well."""
	environment = {**os.environ, "HOME": str(PACKAGES), "PYTHONPATH": str(PACKAGES), "PYTHONDONTWRITEBYTECODE": "1"}
	parts = [part for part in (paths[start :: os.cpu_count()] for start in range(os.cpu_count() or 1)) if part]
	started = [
		subprocess.Popen(
			[*command, *map(str, part)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment, cwd=ROOT
		)
		for part in parts
	]
	said = [process.communicate()[0] for process in started]
	return "".join(said), not any(process.returncode for process in started)


def named(said, paths):
	"""Returns those of `paths` that a formatter's output names."""
	return [path for path in map(lambda path: str(path.relative_to(ROOT)), paths) if re.search(rf"(?<![\w/]){re.escape(path)}\b", said)]


def formatters():
	"""For each kind: the command that formats, and the one that names files that are not formatted."""
	clang, ruff = clang_format(), [str(PACKAGES / "bin/ruff"), "format"]
	gdformat = [sys.executable, "-m", "gdtoolkit.formatter", f"--line-length={WIDTH}"]
	return {
		"cpp": ([clang, "-i"], [clang, "--dry-run", "-Werror"]),
		"python": (ruff, [*ruff, "--check"]),
		"gdscript": (gdformat, [*gdformat, "--check"]),
	}


def too_wide(path):
	"""Returns the numbers of lines that are too wide. String literals do not count: a message is easier to find in one piece."""

	def width(line):
		return len((line if line.lstrip().startswith('"""') else TEXT.sub('""', line)).expandtabs(TAB))

	return [number for number, line in enumerate(path.read_text().split("\n"), 1) if width(line) > WIDTH]


def plain_wrong(path):
	"""Returns what is wrong with the spaces and the width of a source, as texts."""
	lines = path.read_text().split("\n")
	wrong = [f"{number}: ends with a space" for number, line in enumerate(lines, 1) if line != line.rstrip()]
	wrong += [f"{number}: indented with spaces" for number, line in enumerate(lines, 1) if re.match(r" +[^ *]", line)]
	wrong += [f"{number}: wider than {WIDTH}" for number, line in enumerate(lines, 1) if len(line.expandtabs(TAB)) > WIDTH]
	return wrong if lines[-1] == "" else [*wrong, f"{len(lines)}: no newline at the end"]


def check(kind):
	"""Returns the files of a kind that `./grass format` would change, and lines that it cannot fix, as texts."""
	paths = sources(kind)
	if kind == "shaders":
		return [f"{path.relative_to(ROOT)}:{text}" for path in paths for text in plain_wrong(path)]
	said, good = run(formatters()[kind][1], [path.relative_to(ROOT) for path in paths])
	wrong = [f"{path} is not formatted" for path in named(said, paths)]
	wide = [f"{path.relative_to(ROOT)}:{line}: wider than {WIDTH}" for path in paths for line in too_wide(path)]
	if not good and not wrong:
		wrong = [f"the formatter failed: {said[-500:]}"]
	return wrong + wide


def lint():
	"""Returns the output of ruff for the Python sources."""
	said, good = run(
		[str(PACKAGES / "bin/ruff"), "check", "--output-format=concise"], [path.relative_to(ROOT) for path in sources("python")]
	)
	return [] if good else [line for line in said.splitlines() if re.match(r"\S+:\d+", line)] or [said]


def layer(only, tally):
	"""The layer `format`: a test for each kind of source, and for what no source may do. Returns `tally`."""
	ensure()
	checks = {kind: lambda kind=kind: check(kind) for kind in KINDS}
	for name, wrong in {
		**checks,
		"lint": lint,
		"encodings": encodings.check,
		"windows": windows_rules.forbidden,
		"threads": thread_rules.forbidden,
	}.items():
		if only in f"format/{name}":
			found = wrong()
			for text in found:
				print(f"       {text}")
			print(f"{'fail' if found else 'pass':>6} format/{name}", flush=True)
			tally.passed += not found
			tally.failed += [f"format/{name}: {len(found)} findings, the first: {found[0]}"] if found else []
	if only in "format/workflows":
		workflows.layer(tally)
	return tally


def format_all():
	"""Formats every source in place. Raises Failure if one of them cannot be read."""
	ensure()
	for kind, (command, _) in formatters().items():
		said, good = run(command, [path.relative_to(ROOT) for path in sources(kind)])
		if not good:
			raise Failure(f"Formatting {kind} failed:\n{said[-2000:]}")
