# SPDX-License-Identifier: MIT
"""Tests of the layer `gpu` with a Vulkan layer of our own (tests/drivers/) that behaves like drivers on which the tests cannot run: it
counts instances from 0 in every draw call, as Direct3D 12 does, refuses compute passes, and says that the device is another maker's.

`numbers`: still grass looks the same however instances count, to the pixel. `refused`: grass is drawn all the same, by the CPU. The others:
what fields do otherwise on devices of that maker.
"""

import json
import re
import shlex
import shutil
import subprocess

from tools.fetch import machine
from tools.places import BUILD, PROJECT, ROOT
from tools.run import engine
from tools.say import Failure, progress
from tools.test.test_runs import Tally, in_engine

SOURCES = ROOT / "tests/drivers"
FOLDER = BUILD / "drivers"  # the library, what the loader reads of it, pictures
NAME = "VK_LAYER_GRASS_drivers"
LIMIT = 1200  # seconds, of one run
SCENE = "res://tests/drivers/numbers.tscn"
METHODS = ("forward_plus", "mobile")
LAZY = "GRASS_LAYER_LAZY"  # pipelines are made when a command binds them: the engine makes many of which a test draws with few
RESTORED = "restored"  # a control of the layer itself: it rewrites shaders, and they count as before. By name only
FIRST = "the instance of a draw call that begins at 5 is "
# What the layer does from the start of a process, for the tests that need it; other tests change it themselves.
BEHAVIOUR = {
	"test_refused_later": {}, "test_refused_first": {"GRASS_LAYER_REFUSED": "cull"},
	"test_refused_cull": {"GRASS_LAYER_REFUSED": "cull"}, "test_refused_simulate": {"GRASS_LAYER_REFUSED": "simulate"},
	"test_refused_gather": {"GRASS_LAYER_REFUSED": "gather"},
	"test_own_work": {"GRASS_LAYER_VENDOR": "0x10de"},
}  # fmt: skip


def build():
	"""Returns environment additions that put the layer below the engine."""
	FOLDER.mkdir(parents=True, exist_ok=True)
	library = FOLDER / "libgrass_drivers.so"
	sources = sorted(map(str, SOURCES.glob("*.cpp")))
	options = ["-std=c++20", "-O1", "-fPIC", "-shared", "-fvisibility=hidden", "-pthread"]
	command = [*shlex.split(machine.compiler()), *options, "-I", str(ROOT / "shaders"), "-o", str(library), *sources]
	result = subprocess.run(command, capture_output=True, text=True)
	if result.returncode:
		raise Failure(f"The layer of {SOURCES} does not compile:\n{result.stderr}")
	about = {
		"name": NAME, "type": "GLOBAL", "library_path": str(library), "api_version": "1.3.0", "implementation_version": "1",
		"description": "What other drivers do", "functions": {},
	}  # fmt: skip
	(FOLDER / "layer.json").write_text(json.dumps({"file_format_version": "1.2.0", "layer": about}))
	passes = str(BUILD / "gen/spirv")
	return {"VK_LAYER_PATH": str(FOLDER), "VK_INSTANCE_LAYERS": NAME, "GRASS_LAYER_PASSES": passes}


def pictures(method, name, environment, more=()):
	"""Returns ({picture: its bytes}, the number that a shader reads for the first instance of a draw call that begins at 5)."""
	folder = FOLDER / f"{method}_{name}"
	folder.mkdir(parents=True, exist_ok=True)
	for old in folder.glob("*.png"):
		old.unlink()
	said = []
	with engine.window(method, "64x36", software=True) as (command, driver), progress(f"Drawing {method}, {name}", every=10):
		start = ["--path", str(PROJECT), "--fixed-fps", "60", SCENE, "--", f"--folder={folder}", *more]
		code = engine.run([*command, *start], {**driver, **environment}, said.append, LIMIT)
	if code or "GRASS-DRIVERS done" not in said or any("ERROR" in line for line in said):
		raise Failure(f"the scene ended with code {code}:\n" + "\n".join(said[-20:]))
	told = [line for line in said if line.startswith("GRASS-DRIVERS ")]
	print("\n".join(told[1:-1]))
	return {file.name: file.read_bytes() for file in sorted(folder.glob("*.png"))}, int(told[0].rpartition(FIRST)[2])


def drawing_shaders(method):
	"""Returns the SPIR-V of the vertex and fragment shaders that the renderer makes for the scene's fields: files, NUMBER.STAGE.spv."""
	folder = FOLDER / f"{method}_spirv"
	shutil.rmtree(folder, ignore_errors=True)
	folder.mkdir(parents=True)
	pictures(method, "shaders", build(), (f"--shaders={folder}",))
	return sorted(folder.glob("*.spv"))


def compare(method, counting, layer):
	"""Raises a Failure that names the picture if one differs."""
	lazy = {**layer, LAZY: "all"}  # for both: most pipelines that the engine makes in advance are never bound here
	plain, first = pictures(method, "plain", lazy)
	other, first_there = pictures(method, counting, {**lazy, "GRASS_LAYER_COUNTING": counting})
	expected = (5, 5 if counting == RESTORED else 0)
	if (first, first_there) != expected:
		raise Failure(f"the layer is at fault: instances {(first, first_there)}, not {expected}")
	different = [name for name in plain if plain[name] != other.get(name)]
	if different or not plain or plain.keys() != other.keys():
		raise Failure(f"{', '.join(different) or 'pictures'} differ: {FOLDER}/{method}_plain and {FOLDER}/{method}_{counting}")


def numbers(only, layer):
	tally = Tally()
	tests = [(method, "zero") for method in METHODS] + [(METHODS[0], RESTORED)]
	for method, counting in tests:
		name = f"gpu/numbers.instances_count_from_{counting}.{method}"
		# By name only: the control, and Mobile, which may hang when the scene begins on a machine with two threads (Godot's issue 123060).
		if not wanted(name, only) or (not only and (counting == RESTORED or method != METHODS[0])):
			continue
		try:
			compare(method, counting, layer)
			tally.passed += 1
			print(f"  pass {name}")
		except Failure as failure:
			tally.failed.append(f"{name}: {failure}")
			print(f"  fail {name}")
	return tally


def wanted(name, only):
	return not only or any(part in name for part in only.split(","))


def functions_of(script):
	return re.findall(r"^func (test_\w+)", (PROJECT / f"tests/drivers/{script}.gd").read_text(), re.MULTILINE)


def behaving(only, layer):
	"""Runs each script in a process of its own, since a process compiles a pass only once."""
	tally = Tally()
	for script, behaviour in BEHAVIOUR.items():
		chosen = [f"/{script}.{function}" for function in functions_of(script)]
		chosen = [name for name in chosen if wanted("gpu" + name, only)]
		if not chosen:
			continue
		with engine.window(size="64x36", software=True) as (command, driver):
			asked = FOLDER / f"{script}_asked.txt"
			asked.unlink(missing_ok=True)
			environment = {**driver, **layer, LAZY: "all", "GRASS_LAYER_ASKED": str(asked), **behaviour}
			tally.add(in_engine("drivers", command, environment, ",".join(chosen), title="gpu"))
	return tally


def layer(only, below):
	"""Returns the Tally of these tests, empty if `only` names other tests. `below`: what build() returned."""
	tally = numbers(only, below)
	tally.add(behaving(only, below))
	return tally
