# SPDX-License-Identifier: MIT
"""Runs programs of tests, the core's and those in the engine, and counts their results. tools/test/testing.py makes layers of them."""

import concurrent.futures
import os
import re
import subprocess
import time
from dataclasses import dataclass, field

from tools.places import BUILD, PROJECT
from tools.run import engine
from tools.say import Failure, progress

# Seconds; ten times the time of the longest layer on two cores, for slow or busy machines. A test that hangs is found long before.
PROGRAM_LIMIT = 3600
ENGINE_LIMIT = 14400
MARK = "GRASS-TEST "  # begins the runner's reports; see godot_project/tests/runner.gd
LEAK = re.compile(r"leaked at exit|still in use at exit|were leaked")
# The editor, which lists them with --verbose, may end with scripts of the project that it has read for itself.
LEAK_OF_EDITOR = re.compile(r"^Leaked instance: (?!GDScript)|^Resource still in use: (?!.*\(GDScript\))|were leaked")
UNSUPPORTED = re.compile(r"is not supported yet")  # the engine about a shader of ours
WORTH_SAYING = 5.0  # seconds that a test takes, or that a processor is busy for it
CASES_A_PART = 8  # test cases that a slow program runs at a time


@dataclass
class Tally:
	"""The results of a layer."""

	passed: int = 0
	failed: list = field(default_factory=list)
	skipped: list = field(default_factory=list)

	def add(self, other):
		self.passed += other.passed
		self.failed += other.failed
		self.skipped += other.skipped

	def count(self):
		return self.passed + len(self.failed) + len(self.skipped)

	def line(self):
		skips = f", {len(self.skipped)} skipped" if self.skipped else ""
		return f"{self.passed} passed, {len(self.failed)} failed{skips}"


def noted(tally, name, wrong):
	"""Adds a test to `tally`: passed unless something is `wrong`."""
	print(f"{'fail' if wrong else 'pass':>6} {name}{': ' + wrong if wrong else ''}", flush=True)
	if wrong:
		tally.failed.append(f"{name}: {wrong}")
	else:
		tally.passed += 1


def core(layer, only, program=None, environment=None, title=None, said=None, slow=False):
	"""Runs the core's tests of a layer, without the engine. Each TEST_CASE counts one. `program`: the command, if not this machine's
	ordinary one; `said`: gets the lines of its errors; `slow`: it runs in parts, one on each processor."""
	program = program or [str(BUILD / layer / f"{layer}_tests")]
	title = title or layer
	environment = {**os.environ, **(environment or {})}
	chosen = [f"--test-case=*{only}*"] if only else []
	command = [*program, *chosen]
	cases = cases_of(command, environment)
	size = CASES_A_PART if slow else max(len(cases), 1)
	parts = [[f"--first={at + 1}", f"--last={at + size}"] if slow else [] for at in range(0, max(len(cases), 1), size)]

	def run(part):
		try:
			result = subprocess.run(
				[*command, *part], capture_output=True, text=True, errors="replace", timeout=PROGRAM_LIMIT, env=environment
			)
		except subprocess.TimeoutExpired:
			return None
		print(result.stdout + result.stderr, end="", flush=True)  # at once, so that a run that is cut off has printed its output
		return result

	tally = Tally()
	with progress(f"Running the {title} tests"), concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
		for n, result in enumerate(pool.map(run, parts)):
			names = cases[n * size : (n + 1) * size]
			if result is None:
				tally.failed.append(f"{title}: still running after {PROGRAM_LIMIT} s, one of: {'; '.join(names)}")
				continue
			if said is not None:
				said += result.stderr.splitlines()
			tally.add(tally_of(result, len(names), title))
	skipped = sorted(set(cases_of([*command, "--no-skip"], environment)) - set(cases))
	tally.skipped += [f"{title}: {name} (marked to be skipped)" for name in skipped]
	return tally


def tally_of(result, cases, title):
	"""Returns the results of one run of a doctest program over so many test cases."""
	summary = re.search(r"test cases:\s*\d+\s*\|\s*\d+ passed\s*\|\s*(\d+) failed", result.stdout)
	failed = int(summary[1]) if summary else 0
	# A block between rulers is one report: of failed checks, or only of a message.
	blocks = [block for block in re.split(r"^=+$", result.stdout, flags=re.MULTILINE) if "ERROR:" in block]
	names = [name.strip() for block in blocks for name in re.findall(r"^TEST CASE:\s*(.*)$", block, re.MULTILINE)]
	names = list(dict.fromkeys(names)) + ["a test case"] * failed
	failures = [f"{title}: {name}" for name in names[:failed]]
	if result.returncode and not failures:
		failures = [f"{title}: the tests ended with code {result.returncode}"]
	return Tally(cases - failed if summary else 0, failures)


def cases_of(command, environment):
	"""Returns the names of the test cases that a doctest program would run, in order."""
	listing = subprocess.run([*command, "--list-test-cases"], capture_output=True, text=True, env=environment).stdout
	return [line for line in listing.splitlines() if line and not line.startswith(("[doctest]", "==="))]


class Reports:
	"""Follows the reports of the runner in the engine."""

	def __init__(self, layer, may_be_none, title="", forbidden=(), said=None, leak=LEAK):
		"""`forbidden`: output that the engine must not print, as (pattern, what it is); `said`: gets all of its output; `leak`: what tells
		of a leak."""
		self.layer, self.may_be_none, self.title, self.tally = layer, may_be_none, title or layer, Tally()
		self.open, self.running = [], None
		self.process, self.began, self.busy = None, time.monotonic(), 0.0
		self.forbidden = [(leak, "leaks at exit"), (UNSUPPORTED, "the engine complains of a shader"), *forbidden]
		self.heard = {}  # lines, by what they are
		self.said = [] if said is None else said

	def follow(self, process):
		"""`process`: the engine's, which is asked how long each test keeps processors busy."""
		self.process = process

	def line(self, text):
		if not text.startswith(MARK):
			print(text, flush=True)
			self.said.append(text)
			for pattern, what in self.forbidden:
				if pattern.search(text):
					self.heard.setdefault(what, []).append(text)
			return
		what, name = text[len(MARK) :].split(" ", 1)
		name = self.title + name.removeprefix(self.layer)
		if what in ("plan", "run"):
			self.open += [name] if what == "plan" else []
			if what == "run":
				self.running, self.began, self.busy = name, time.monotonic(), engine.busy(self.process)
			return
		print(f"{what:>6} {name}{self.took()}", flush=True)
		test = name.split(": ", 1)[0]
		self.open.remove(test)
		if what == "pass":
			self.tally.passed += 1
		else:
			(self.tally.failed if what == "fail" else self.tally.skipped).append(name)

	def took(self):
		"""In words, where the running test was long."""
		seconds, busy = time.monotonic() - self.began, engine.busy(self.process) - self.busy
		return f" ({seconds:.0f} s, {busy:.1f} s of a processor)" if max(seconds, busy) >= WORTH_SAYING else ""

	def end(self, how):
		"""Counts tests that had not run when the engine ended as failed, and an engine that ended badly or leaked."""
		planned, died = self.open or self.tally.count(), how.startswith("the engine died")
		for name in self.open:
			reason = f"while it ran, {how}" if name == self.running else f"not run: {how}"
			self.tally.failed.append(f"{name}: {reason}")
		if not planned and (died or not self.may_be_none):
			self.tally.failed.append(f"{self.title}: no test was found ({how})")
		elif died and not self.open:
			self.tally.failed.append(f"{self.title}: after the last test {how}")
		for what, lines in self.heard.items():
			self.tally.failed.append(f"{self.title}: {what}: {'; '.join(lines)}")
		return self.tally


def in_engine(
	layer, command, environment, only, may_be_none=None, title="", start=("--fixed-fps", "60", "res://tests/runner.tscn"),
	project=PROJECT, forbidden=(), more=(), said=None, leak=LEAK,
):  # fmt: skip
	"""`only`: which tests (parts of names, between commas); `may_be_none`: whether none of them may be there (where the user chose).
	`forbidden`, `said`, `leak`: see Reports; `more`: arguments for the runner."""
	reports = Reports(layer, bool(only) if may_be_none is None else may_be_none, title, forbidden, said, leak)
	arguments = ["--path", str(project), *start, "--", f"--layer={layer}", *more]
	if only:
		arguments.append(f"--only={only}")
	try:
		code = engine.run([*command, *arguments], environment, reports.line, ENGINE_LIMIT, on_start=reports.follow)
		clean = code == 0 or code == 1 and reports.tally.failed  # 1: the runner says that a test failed, or the engine did not start
		how = f"the engine ended with code {code}" if clean else f"the engine died with code {code} (negative: a signal)"
	except Failure as failure:
		how = f"the engine died: {failure}"
	return reports.end(how)
