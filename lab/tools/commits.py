# SPDX-License-Identifier: MIT
"""The commit that benchmarks measure: the last one that changed what they run. Pages and tools do not count."""

import datetime
import subprocess

from tools.places import ROOT

MEASURED = ("extension", "shaders", "godot_project/addons", "lab/project/bench", "godot_project/demo", "lab/core", "SConstruct")
UNMEASURED = (":!*.md", ":!godot_project/demo/benchmark/pictures.gd")  # no part takes the pictures of the demo's own benchmark
DIRTY = "-dirty"  # behind the commit: what was measured is nobody else's


def git(*arguments):
	result = subprocess.run(["git", *arguments, "--", *MEASURED, *UNMEASURED], cwd=ROOT, capture_output=True, text=True)
	return result.stdout.strip()


def measured():
	commit = git("log", "-1", "--format=%h", "--abbrev=8") or "unknown"
	return commit + (DIRTY if git("status", "--porcelain") else "")


def when():
	return f"commit {measured()}; {datetime.date.today()}"
