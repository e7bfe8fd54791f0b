# SPDX-License-Identifier: MIT
"""Runs the layers of tests and adds them up. The last line is `N passed, N failed`, and skips if there are any."""

import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass, field

from tools import binding_tests, build, engine, machine, testing_platforms, validation
from tools.places import BUILD, PROJECT
from tools.say import Failure, progress, say

OTHER_RENDERERS = ("mobile", "gl_compatibility")  # draw PICTURES too; everything else of the gpu layer is Forward+
PICTURES = "test_picture"
# Seconds; ten times what the longest layer takes on two cores, for machines that are slow or busy. What hangs is found long before.
PROGRAM_LIMIT = 3600
ENGINE_LIMIT = 14400
EDITED = BUILD / "editor/project"  # the copy of the project that the editor may change; its pictures lie beside it
MARK = "GRASS-TEST "  # begins the runner's reports; see godot_project/tests/runner.gd
LEAK = re.compile(r"leaked at exit|still in use at exit|were leaked")
UNSUPPORTED = re.compile(r"is not supported yet")  # the engine about a shader of ours
SOFTWARE = re.compile(r"Vulkan .* Using Device #\d+: .*(llvmpipe|lavapipe|SwiftShader)")


@dataclass
class Tally:
	"""How a layer went."""

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


CASES_A_PART = 8  # test cases that a slow program runs at a time


def core(layer, only, program=None, environment=None, title=None, said=None, slow=False):
	"""The core's tests of a layer, without the engine. Each TEST_CASE counts one. `program`: the command, if not this machine's
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
		return subprocess.run([*command, *part], capture_output=True, text=True, errors="replace", timeout=PROGRAM_LIMIT, env=environment)

	try:
		with progress(f"Running the {title} tests"), concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
			results = list(pool.map(run, parts))
	except subprocess.TimeoutExpired:
		return Tally(failed=[f"{title}: still running after {PROGRAM_LIMIT} s"])
	tally = Tally()
	for n, result in enumerate(results):
		print(result.stdout + result.stderr, end="")
		if said is not None:
			said += result.stderr.splitlines()
		tally.add(tally_of(result, len(cases[n * size : (n + 1) * size]), title))
	skipped = sorted(set(cases_of([*command, "--no-skip"], environment)) - set(cases))
	tally.skipped += [f"{title}: {name} (marked to be skipped)" for name in skipped]
	return tally


def tally_of(result, cases, title):
	"""Of one run of a program of doctest's, over so many test cases."""
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
	"""Names of the test cases that a program of doctest's would run, in order."""
	listing = subprocess.run([*command, "--list-test-cases"], capture_output=True, text=True, env=environment).stdout
	return [line for line in listing.splitlines() if line and not line.startswith(("[doctest]", "==="))]


def stress_in_full():
	"""The stress tests in their full size, as they come. Returns the exit code."""
	machine.ensure(*machine.BUILDING)
	build.scons("stress")
	command = [str(BUILD / "stress/stress_tests"), "--duration=true"]
	return subprocess.run(command, env={**os.environ, "GRASS_STRESS": "full"}).returncode


class Reports:
	"""Follows what the runner in the engine reports."""

	def __init__(self, layer, may_be_none, title="", forbidden=(), said=None):
		"""`forbidden`: what the engine must not say, as (pattern, what it is); `said`: gets all that it says."""
		self.layer, self.may_be_none, self.title, self.tally = layer, may_be_none, title or layer, Tally()
		self.open, self.running = [], None
		self.forbidden = [(LEAK, "leaks at exit"), (UNSUPPORTED, "the engine complains of a shader"), *forbidden]
		self.heard = {}  # lines, by what they are
		self.said = [] if said is None else said

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
			self.running = name if what == "run" else self.running
			return
		print(f"{what:>6} {name}", flush=True)
		test = name.split(": ", 1)[0]
		self.open.remove(test)
		if what == "pass":
			self.tally.passed += 1
		else:
			(self.tally.failed if what == "fail" else self.tally.skipped).append(name)

	def end(self, how):
		"""What had not run when the engine ended has failed; so has an engine that ended badly, or leaked."""
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
	project=PROJECT, forbidden=(), more=(), said=None,
):  # fmt: skip
	"""`only`: which tests (parts of names, between commas); `may_be_none`: whether none of them may be there (where the user chose).
	`forbidden`, `said`: see Reports; `more`: arguments for the runner."""
	reports = Reports(layer, bool(only) if may_be_none is None else may_be_none, title, forbidden, said)
	arguments = ["--path", str(project), *start, "--", f"--layer={layer}", *more]
	if only:
		arguments.append(f"--only={only}")
	try:
		code = engine.run([*command, *arguments], environment, reports.line, ENGINE_LIMIT)
		clean = code == 0 or code == 1 and reports.tally.failed  # 1: the runner says that a test failed, or the engine did not start
		how = f"the engine ended with code {code}" if clean else f"the engine died with code {code} (negative: a signal)"
	except Failure as failure:
		how = f"the engine died: {failure}"
	return reports.end(how)


def formatted(only):
	from tools import formatting  # pip and clang-format are looked for only where it runs

	return formatting.layer(only, Tally())


def tidied(only):
	from tools import tidy  # clang-tidy is looked for only where it runs

	return tidy.layer(only, Tally())


def binding(only):
	passed, failed = binding_tests.run(only)
	return Tally(len(passed), failed)


def headless(only):
	return in_engine("headless", *engine.headless(), only)


def gpu(only, hardware):
	where = {"size": "320x180", "software": not hardware, "hardware": hardware}
	forbidden = [(SOFTWARE, "not on the machine's GPU")] if hardware else []
	with engine.window(**where) as (command, environment):
		tally = in_engine("gpu", command, environment, only, forbidden=forbidden)
	for method in OTHER_RENDERERS if not only or PICTURES in only else ():
		with engine.window(method, **where) as (command, environment):
			tally.add(in_engine("gpu", command, environment, only or PICTURES, bool(only), f"gpu ({method})", forbidden=forbidden))
	return tally


def docs(only):
	from tools import docs_tests  # it imports this module

	return docs_tests.run(only)


def on_platform(layer, only):
	return testing_platforms.run_layer(layer, only, sys.modules[__name__])


def packed(layer, only):
	from tools import testing_release  # it imports this module

	return testing_release.run_layer(layer, only)


def sanitize(only, in_full):
	from tools import sanitize as sanitizers  # it imports this module

	return sanitizers.run(only) if in_full else sanitizers.run_short(only)


def copy_project():
	"""The project once more, with the plugin that runs the tests in the editor."""
	shutil.rmtree(EDITED, ignore_errors=True)
	shutil.copytree(PROJECT, EDITED, symlinks=True)
	with open(EDITED / "project.godot", "a") as file:
		file.write('\n[application]\n\nrun/main_scene="res://tests/editor/hills.tscn"\n')  # what the editor opens at first
		file.write('\n[editor_plugins]\n\nenabled=PackedStringArray("res://tests/editor/plugin.cfg")\n')


def editor(only):
	copy_project()
	with engine.window(size="1280x720", software=True) as (command, environment):
		return in_engine("editor", command, environment, only, start=("--editor",), project=EDITED)


def on_screen(layers, hardware):
	"""What layers that draw need."""
	software = {"gpu", "validation", "editor", "release", "sanitize"} & set(layers) - ({"gpu"} if hardware else set())
	needs = [machine.VIRTUAL_SCREEN, machine.SOFTWARE_VULKAN] if software else []
	return [*needs, *([machine.SCREEN] if hardware else []), *([machine.VALIDATION] if "validation" in layers else [])]


@dataclass
class Layer:
	"""A layer of tests: `run(only, hardware)` returns its Tally; `target` is what SCons builds for it; `in_all`: whether it runs
	where no layer is named."""

	run: object
	target: str = "extension"
	in_all: bool = True


# In the order in which they run.
LAYERS = {
	"format": Layer(lambda only, _: formatted(only), None),
	"tidy": Layer(lambda only, _: tidied(only)),  # reads headers that the build makes
	"binding": Layer(lambda only, _: binding(only), None),
	"unit": Layer(lambda only, _: core("unit", only), "unit"),  # of doctest, without the engine: a test case counts one
	"stress": Layer(lambda only, _: core("stress", only), "stress"),
	"sanitize-short": Layer(lambda only, _: sanitize(only, False), None),
	"sanitize": Layer(lambda only, _: sanitize(only, True), in_all=False),
	"headless": Layer(lambda only, _: headless(only)),
	"docs": Layer(lambda only, _: docs(only)),
	"gpu": Layer(gpu),
	"validation": Layer(lambda only, _: validation.layer(only, Tally())),
	"editor": Layer(lambda only, _: editor(only)),
	"platforms": Layer(lambda only, _: on_platform("platforms", only)),
	"package": Layer(lambda only, _: packed("package", only)),
	"windows": Layer(lambda only, _: on_platform("windows", only), in_all=False),
	"arm64": Layer(lambda only, _: on_platform("arm64", only), in_all=False),
	"release": Layer(lambda only, _: packed("release", only), in_all=False),
}
ALL = tuple(name for name, layer in LAYERS.items() if layer.in_all)


def run(layers=ALL, only="", hardware=False):
	"""Builds, runs `layers` (the gpu layer on the machine's GPU if `hardware`), prints the sum. Returns whether all went well."""
	if hardware and not machine.gpu():
		raise Failure("--gpu: there is no GPU here that Vulkan can use: no card in /dev/dri or /dev/nvidia*, or no driver in vulkan/icd.d.")
	machine.ensure(*machine.BUILDING, *on_screen(layers, hardware))
	targets = sorted({LAYERS[layer].target for layer in layers} - {None})
	if targets:
		build.scons(*targets)
	if "extension" in targets:
		engine.import_project()
	testing_platforms.prepare(layers)
	total = Tally()
	for layer in layers:
		say(f"Tests: {layer}")
		tally = LAYERS[layer].run(only, hardware)
		say(f"{layer}: {tally.line()}")
		total.add(tally)
	if not total.count():
		total.failed.append(f"no test has {only!r} in its name")
	for text in total.skipped:
		print(f"skipped: {text}")
	for text in total.failed:
		print(f"FAILED: {text}")
	print(total.line(), flush=True)
	return not total.failed
