# SPDX-License-Identifier: MIT
"""The layer `web`: builds the libraries for Web, with threads and without, and reads them. The one without is loaded in Node.js, and its
bits are compared with those of this machine, and with recorded ones. Then the demo's page is made, with an engine that is built once, and
played (testing_page.py).
"""

import os
import re
import struct
import subprocess

from tools.build import build, emscripten, names
from tools.say import Failure
from tools.release import page
from tools.test import testing_page, testing_platforms, wasm
from tools.test.test_runs import Tally

WEB = ("web", "wasm32")
COLORS = re.compile(r"\x1b\[[0-9;]*m")
SPIRV = struct.pack("<I", 0x07230203)  # how each compute pass begins
THREADS = re.compile(r"pthread_create|emscripten_(?:create_|init_)?(?:wasm_worker|pthread)|_emscripten_thread")
FILES = re.compile(r"__syscall_open\w*|fopen|fd_(?:read|write|seek)")
MOST = 2_700_000  # bytes of a library


def options(threads, *more):
	return ("platform=web", "arch=wasm32", f"threads={'yes' if threads else 'no'}", *more)


def library(threads):
	return names.folder(*WEB, threads) / "symbols/release" / names.library(*WEB, "release", threads=threads)


def node(name, *arguments):
	"""Returns the output of a program without threads in Node.js. Raises Failure if it fails."""
	command = [emscripten.PROGRAM, names.program(*WEB, name, threads=False), *arguments]
	environment = {**os.environ, **emscripten.QUIET}
	result = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=testing_platforms.STEP_LIMIT, env=environment)
	if result.returncode:
		raise Failure(f"ended with code {result.returncode}: {(result.stdout[-500:] + result.stderr[-2000:]).strip()}")
	return result.stdout


def expect(condition, text):
	if not condition:
		raise Failure(text)


def is_a_side_module(threads):
	module = wasm.read(library(threads))
	expect(module.names[:1] == ["dylink.0"], f"its first part is {module.names[:1]}: it is no side module")
	expect(testing_platforms.ENTRY in module.exports, f"it offers {len(module.exports)} names, not its entry")


def agrees_about_threads(threads):
	module = wasm.read(library(threads))
	starts = sorted(filter(THREADS.search, module.imports))
	expect(module.has_shared_memory == threads, f"its memory is{'' if module.has_shared_memory else ' not'} shared")
	expect(threads or not starts, f"it would start threads: {', '.join(starts)}")


def uses_no_file(threads):
	found = sorted(filter(FILES.fullmatch, wasm.read(library(threads)).imports))
	expect(not found, f"it asks for {', '.join(found)}, but the engine has the files")


def has_only_what_runs_there(threads):
	data = library(threads).read_bytes()
	expect(SPIRV not in data, "it holds compute passes, which no browser runs")
	expect(b"<brief_description>" not in data, "it holds the class reference, which no browser shows")
	expect(len(data) <= MOST, f"it has {len(data):,} bytes, at most {MOST:,}")


def registers_the_same():
	here, there = (testing_platforms.ENTRY, "game"), library(False)
	ours = testing_platforms.run(
		names.HERE, testing_platforms.program(names.HERE, "host/host"), testing_platforms.library(names.HERE, False), *here
	)
	testing_platforms.same_lines(ours, node("host/host", there, *here))


def same_bits():
	here = subprocess.run([testing_platforms.program(names.HERE, "bits/bits")], capture_output=True, text=True, check=True).stdout
	testing_platforms.same_lines(here, node("bits/bits"))


def recorded_bits():
	said = COLORS.sub("", node("golden/golden_tests"))  # in Node the program takes no arguments that would leave them out
	expect(re.search(r"test cases: +[1-9]\d* \| +[1-9]\d* passed \| +0 failed", said), said[-1000:])


CHECKS = {
	"a side module that offers its entry": is_a_side_module,
	"its memory and threads are those of the template": agrees_about_threads,
	"no file of its own": uses_no_file,
	"nothing that a browser cannot run": has_only_what_runs_there,
}
RUNS = {
	"loads in Node.js, and registers what the library for this machine does": registers_the_same,
	"steps 100 random scenes to the bits that they have on this machine": same_bits,
	"steps golden scenes to the recorded bits": recorded_bits,
}


def run_layer(only):
	build.scons("extension", "host", "bits")
	for threads in (False, True):
		build.scons("extension", *options(threads, "target=release", "symbols=yes"))
	build.scons("host", "bits", "golden", *options(False))
	tally = Tally()
	for threads in (False, True):
		kind = f"web with{'' if threads else 'out'} threads"
		testing_platforms.check(tally, only, ((f"{kind}: {name}", lambda act=act: act(threads)) for name, act in CHECKS.items()))
	testing_platforms.check(tally, only, ((f"web without threads: {name}", run) for name, run in RUNS.items()))
	on_page = {f"the page: {name}": act for name, act in testing_page.CHECKS.items() if only in f"the page: {name}"}
	if on_page:
		page.make()
		testing_platforms.check(tally, only, on_page.items())
	return tally
