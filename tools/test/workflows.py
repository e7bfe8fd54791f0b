# SPDX-License-Identifier: MIT
"""Checks the workflows of public CI with actionlint, which the machine's Go builds. Part of the layer `format`."""

import os
import shutil
import subprocess

from tools.places import ROOT, TOOLS
from tools.say import Failure, progress
from tools.test.test_runs import noted

MODULE, VERSION = "github.com/rhysd/actionlint/cmd/actionlint", "v1.7.12"
PLACE = TOOLS / "actionlint"
PLANTED = "on: push\njobs:\n  one:\n    runs-on: ubuntu-latest\n    needs: nobody\n    steps:\n      - run: ${{ matrix.word }}\n"


def actionlint():
	"""Returns the path of actionlint, built once."""
	program = PLACE / VERSION / "actionlint"
	if not program.exists():
		folders = {"GOBIN": str(program.parent), "GOPATH": str(PLACE / "go"), "GOCACHE": str(PLACE / "cache"), "GOFLAGS": "-modcacherw"}
		with progress("Fetching actionlint"):
			result = subprocess.run(["go", "install", f"{MODULE}@{VERSION}"], env={**os.environ, **folders}, capture_output=True, text=True)
		if result.returncode:
			raise Failure(f"Go could not build actionlint {VERSION}:\n{result.stderr[-1000:]}")
		for folder in (PLACE / "go", PLACE / "cache"):  # sources and objects, which nobody needs again
			shutil.rmtree(folder, ignore_errors=True)
	return str(program)


def found_in(paths, text=None):
	"""Returns what actionlint says of files, or of a `text`."""
	arguments = ["-shellcheck=", "-pyflakes=", "-oneline", *(["-"] if text else map(str, paths))]
	return subprocess.run([actionlint(), *arguments], input=text, cwd=ROOT, capture_output=True, text=True).stdout.splitlines()


def wrong():
	"""Returns what is wrong with the workflows, as texts."""
	if len(found_in([], PLANTED)) != 2:
		return ["tools/test/workflows.py: it does not find what is planted"]
	return found_in(sorted(path.relative_to(ROOT) for path in (ROOT / ".github/workflows").glob("*.yml")))


def layer(tally):
	"""Adds the check to `tally`: a skip where nothing can build actionlint."""
	if not (PLACE / VERSION / "actionlint").exists() and not shutil.which("go"):
		tally.skipped.append("format/workflows: there is no Go to build actionlint with")
	else:
		noted(tally, "format/workflows", "; ".join(wrong()))
