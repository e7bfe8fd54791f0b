# SPDX-License-Identifier: MIT
"""The layers `sanitize` and `sanitize-short`: other layers' tests under the compiler's sanitizers. Each report is one failed test.

The engine is not sanitized. The address sanitizer is loaded into it, with a small library before it (tests/sanitize/), and
the sanitized extension is that of a copy of the project.
"""

import pathlib
import re
import shutil
import subprocess

from tools.build import build, toolchains
from tools.fetch import machine
from tools.places import BUILD, PROJECT
from tools.run import engine
from tools.say import Failure, say
from tools.test import test_runs

MEMORY, RACES = "sanitize=address,undefined", "sanitize=thread"
FOLDER = BUILD / "sanitize"
COPY = FOLDER / "project"
SHIM = FOLDER / "plain_dlopen.so"
LIBRARY = BUILD / "debug-address-undefined"
STARTS = re.compile(r"^(?=.*(?:ERROR: \w+Sanitizer|WARNING: ThreadSanitizer|: runtime error: ))", re.MULTILINE)
SAID_FIRST = 4  # places of a report that are named in the list of what failed
OPTIONS = {"UBSAN_OPTIONS": "print_stacktrace=1"}
# The files of the headless layer that do things which a field may not expect. The others step thousands of tiles, which is too slow here.
HEADLESS = (
	*("fuzz", "mutated_files", "scripts", "scripts_terrain", "scripts_world", "threads"),
	*("enums", "properties", "movers", "growing", "game", "field", "map"),
)
TEST_LIMIT = 3600  # seconds that a test in the engine may take; on a busy machine the longest took 828
# For the engine: it frees some things only when it ends, catches signals to print a trace, and loads libraries that free with one function
# what another one allocated (Embree's, where the sanitizer is that of GCC 13).
IN_ENGINE = "detect_leaks=0:handle_segv=2:verify_asan_link_order=0:alloc_dealloc_mismatch=0"


def reports_in(text):
	"""Returns the reports that sanitizers wrote, one text for each."""
	return [report.strip() for report in STARTS.split(text) if STARTS.match(report)]


def headline(report):
	"""Returns the error of a report, and its stack, the innermost places first."""
	what = re.sub(r"^=+\d+=+|\(pid=\d+\)| (?:on address|at pc) 0x.*", "", report.splitlines()[0]).strip()
	places = [place.strip() for place in re.findall(r"^\s+#\d+ (?:0x[0-9a-f]+ in )?(.*)$", report, re.MULTILINE)]
	return " < ".join([what, *places[:SAID_FIRST]])


def failures(name, said):
	return [f"sanitize, {name}: {headline(report)}" for report in reports_in("\n".join(said))]


def of_core(program, option, only):
	"""Returns tests of the core, with the sanitizers of `option`."""
	folder = f"{'stress' if program == 'stress' else 'unit'}-{option.removeprefix('sanitize=').replace(',', '-')}"
	said = []
	went = test_runs.core(program, only, [str(BUILD / folder / f"{program}_tests")], OPTIONS, said=said, slow=True)
	failed, skipped = ([f"sanitize, {text}" for text in texts] for texts in (went.failed, went.skipped))
	return test_runs.Tally(went.passed, [*failures(program, said), *failed], skipped)


def copy_project():
	"""Makes a copy of the project with the sanitized library."""
	shutil.rmtree(COPY, ignore_errors=True)
	shutil.copytree(PROJECT, COPY, symlinks=True, ignore=shutil.ignore_patterns("bin"))
	library = next(LIBRARY.glob("*.so"))
	extension = COPY / "addons/grass_field/grass_field.gdextension"
	extension.write_text(re.sub(r'"bin/.*"', f'"bin/{library.name}"', extension.read_text()))
	(extension.parent / "bin").mkdir()
	shutil.copy2(library, extension.parent / "bin")


def preload():
	"""Returns the library that is loaded into the engine before everything else."""
	compiler = machine.compiler()
	if "clang" in compiler:
		raise Failure("The extension under sanitizers needs g++: clang links a sanitizer into programs, not into libraries.")

	def runtime(name):
		answer = subprocess.run([*compiler.split(), f"-print-file-name=lib{name}.so"], capture_output=True, text=True).stdout
		path = pathlib.Path(answer.strip())
		if not path.is_absolute():
			raise Failure(f"{compiler} has no lib{name}.so. Install it: in Debian it is part of libgcc-VERSION-dev.")
		return str(path.resolve())

	return {"LD_PRELOAD": ":".join([str(SHIM), runtime("asan"), runtime("ubsan")])}


def in_engine(layer, started, only, may_be_none):
	"""Returns a layer's tests in the engine, with the sanitized extension."""
	command, environment = started
	said, title = [], f"sanitize, {layer}"
	environment = {**environment, **OPTIONS, **preload(), "ASAN_OPTIONS": IN_ENGINE}
	more = (f"--limit={TEST_LIMIT}",)
	tally = test_runs.in_engine(layer, command, environment, only, may_be_none, title, project=COPY, said=said, more=more)
	tally.failed += failures(layer, said)
	return tally


def run_short(only):
	"""Runs a few of the core's tests, built by clang: for every change, in a minute, building included."""
	machine.ensure(toolchains.CLANG_NEED)
	build.scons("bounds", MEMORY, f"cxx={toolchains.clang()}")
	return of_core("bounds", MEMORY, only)


def run(only):
	"""Runs the whole layer `sanitize`."""
	preload()  # reports missing programs before the long build
	has_core = "test_" not in only  # part of each name of the engine's tests; the core's tests have sentences for names
	if has_core:
		build.scons("unit", "stress", MEMORY)
		build.scons("threads", RACES)
	build.scons("extension", "plain_dlopen", MEMORY)
	copy_project()
	total = test_runs.Tally()

	def add(what, tally):
		say(f"sanitize, {what}: {tally.line()}")
		total.add(tally)

	if has_core:
		add("unit", of_core("unit", MEMORY, only))
		add("threads", of_core("threads", RACES, only))
		add("stress", of_core("stress", MEMORY, only))
	for part in [only] if only else (f"headless/test_{name}." for name in HEADLESS):
		add("headless", in_engine("headless", engine.headless(), part, bool(only)))
	with engine.window(size="320x180", software=True) as started:
		add("gpu", in_engine("gpu", started, only or "test_fuzz", bool(only)))
	return total
