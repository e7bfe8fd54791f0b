# SPDX-License-Identifier: MIT
"""Runs the layers of tests and adds them up. The last line is `N passed, N failed`, and skips if there are any."""

import os
import re
import shutil
import subprocess
from dataclasses import dataclass

from tools.build import build
from tools.fetch import machine
from tools.places import BUILD, PROJECT
from tools.run import engine
from tools.say import Failure, say
from tools.test import (
	binding_tests,
	csharp_tests,
	docs_tests,
	drivers,
	formatting,
	lacking,
	pass_rules,
	quitting,
	sanitize,
	side_by_side,
	starting,
	stereo,
	testing_macos,
	testing_platforms,
	testing_release,
	testing_web,
	testing_windows_arm,
	tidy,
	validation,
)
from tools.test.test_runs import LEAK_OF_EDITOR, Tally, core, in_engine

OTHER_RENDERERS = ("mobile", "gl_compatibility")  # these draw PICTURES, too; everything else of the gpu layer runs in Forward+
PICTURES = "test_picture"
EDITED = BUILD / "editor/project"  # the copy of the project that the editor may change; its pictures are beside it
SOFTWARE = re.compile(r"Vulkan .* Using Device #\d+: .*(llvmpipe|lavapipe|SwiftShader)")


def stress_in_full():
	"""Runs the stress tests in their full size and prints their output as it comes. Returns the exit code."""
	machine.ensure(*machine.BUILDING)
	build.scons("stress")
	command = [str(BUILD / "stress/stress_tests"), "--duration=true"]
	return subprocess.run(command, env={**os.environ, "GRASS_STRESS": "full"}).returncode


def binding(only):
	passed, failed, skipped = binding_tests.run(only)
	return Tally(len(passed), failed, skipped)


def headless(only):
	return in_engine("headless", *engine.headless(), only)


def gpu(only, hardware):
	plain = {"size": "320x180", "software": not hardware, "hardware": hardware}
	below = {} if hardware else drivers.build()
	slow_passes = {**plain, "more": below and {**below, drivers.LAZY: "drawing"}}  # they take their time, as tests of that want
	where = {**plain, "more": below and {**below, drivers.LAZY: "all"}}
	forbidden = [(SOFTWARE, "not on the machine's GPU")] if hardware else []
	tally = Tally()
	for more in ((),) if only else (("--motion=no",), ("--motion=yes",)):  # those with motion vectors after all others: see runner.gd
		with engine.window(**(where if "--motion=yes" in more else slow_passes)) as (command, environment):
			tally.add(in_engine("gpu", command, environment, only, forbidden=forbidden, more=more))
	for method in OTHER_RENDERERS if not only or PICTURES in only else ():
		with engine.window(method, **where) as (command, environment):
			tally.add(in_engine("gpu", command, environment, only or PICTURES, bool(only), f"gpu ({method})", forbidden=forbidden))
	tally.add(quitting.layer(only, plain))
	tally.add(lacking.layer(only, where))
	tally.add(starting.layer(only, where))
	tally.add(stereo.layer(only, where))
	if not hardware:
		tally.add(drivers.layer(only, below))
	return tally


def copy_project(light):
	"""Makes a copy of the project with the plugin for tests in the editor. `light`: a small window, which software draws in half the time;
	else, in a larger window, its pictures are those for the docs."""
	shutil.rmtree(EDITED, ignore_errors=True)
	shutil.copytree(PROJECT, EDITED, symlinks=True)
	with open(EDITED / "project.godot", "a") as file:
		file.write('\n[application]\n\nrun/main_scene="res://tests/editor/hills.tscn"\n')  # the scene that the editor opens first
		if light:
			file.write(
				"\n[rendering]\n\nanti_aliasing/quality/msaa_3d=0\nscaling_3d/scale=0.5\nlights_and_shadows/directional_shadow/size=1024\n"
			)
		file.write('\n[editor_plugins]\n\nenabled=PackedStringArray("res://tests/editor/plugin.cfg")\n')


def drawn_in_editor():
	"""Returns whether each test of the editor, by name, needs a window. As runner.gd finds them."""
	drawn = {}
	for script in sorted((PROJECT / "tests/editor").glob("test_*.gd")):
		text = script.read_text()
		listed = re.search(r"^const DRAWN := \[(.*?)\]", text, re.MULTILINE | re.DOTALL)
		for function in re.findall(r"^func (test_\w+)", text, re.MULTILINE):
			drawn[f"editor/{script.stem}.{function}"] = bool(listed) and f'"{function}"' in listed[1]
	return drawn


def editor(only):
	"""Runs tests that look at the picture in a window, and all others without one, which takes a tenth of the time. An editor that has no
	test to run would not end well: it is not started."""
	tests = {name: drawn for name, drawn in drawn_in_editor().items() if any(part in name for part in only.split(","))}
	start = {"start": ("--editor", "--verbose"), "project": EDITED, "leak": LEAK_OF_EDITOR}
	tally = Tally()
	if tests:
		copy_project(light=not only)
	if not all(tests.values()):
		tally.add(in_engine("editor", *engine.headless(), only, more=("--drawn=no",), may_be_none=False, **start))
	if any(tests.values()):
		lazy = {**drivers.build(), drivers.LAZY: "all"}
		with engine.window(size="1280x720" if only else "1024x600", software=True, more=lazy) as (command, environment):
			tally.add(in_engine("editor", command, environment, only, more=("--drawn=yes",), may_be_none=False, **start))
	return tally


def laboratory():
	"""Imported here: nothing else of the house knows it."""
	from lab.tools import lab_tests

	return lab_tests


def on_screen(layers, hardware):
	"""Returns everything that drawing layers need."""
	software = {"gpu", "validation", "editor", "release", "sanitize", "drivers"} & set(layers) - ({"gpu"} if hardware else set())
	needs = [machine.VIRTUAL_SCREEN, machine.SOFTWARE_VULKAN] if software else []
	return [*needs, *([machine.SCREEN] if hardware else []), *([machine.VALIDATION] if "validation" in layers else [])]


@dataclass
class Layer:
	"""A layer of tests: `run(only, hardware)` returns its Tally; `target` is what SCons builds for it; `in_all`: whether it runs
	where no layer is named; `minutes` of a processor, about, its building included: where several run, the longest begins."""

	run: object
	target: str = "extension"
	in_all: bool = True
	minutes: float = 1.0


# In the order in which they are added up.
LAYERS = {
	"format": Layer(lambda only, _: formatting.layer(only, Tally()), None, minutes=0.3),
	"tidy": Layer(lambda only, _: tidy.layer(only, Tally()), minutes=1.5),  # reads headers that the build makes
	"binding": Layer(lambda only, _: binding(only), None, minutes=0.3),
	"unit": Layer(lambda only, _: core("unit", only), "unit", minutes=3.5),  # of doctest, without the engine: a test case counts one
	"stress": Layer(lambda only, _: core("stress", only), "stress", minutes=2.7),
	"sanitize-short": Layer(lambda only, _: sanitize.run_short(only), None, minutes=1.2),
	"sanitize": Layer(lambda only, _: sanitize.run(only), in_all=False),
	"headless": Layer(lambda only, _: headless(only), minutes=3.3),
	"docs": Layer(lambda only, _: docs_tests.run(only, LAYERS), minutes=0.2),
	"csharp": Layer(lambda only, _: csharp_tests.layer(only), minutes=0.3),
	"passes": Layer(lambda only, _: pass_rules.run(only), None, minutes=0.1),
	"lab": Layer(lambda only, _: laboratory().run(only), in_all=False),
	"drivers": Layer(lambda only, _: laboratory().run_drivers(only), in_all=False),
	"gpu": Layer(gpu, minutes=9.1),
	"validation": Layer(lambda only, _: validation.layer(only, Tally()), minutes=0.7),
	"editor": Layer(lambda only, _: editor(only), minutes=2.6),
	"platforms": Layer(lambda only, _: testing_platforms.run_layer("platforms", only), minutes=3.5),
	"package": Layer(lambda only, _: testing_release.run_layer("package", only), minutes=0.3),
	"windows": Layer(lambda only, _: testing_platforms.run_layer("windows", only), in_all=False),
	"arm64": Layer(lambda only, _: testing_platforms.run_layer("arm64", only), in_all=False),
	"riscv": Layer(lambda only, _: testing_platforms.run_layer("riscv", only), in_all=False),
	"windows-arm64": Layer(lambda only, _: testing_windows_arm.run_layer(only), None, in_all=False),
	"double": Layer(lambda only, _: testing_platforms.run_layer("double", only), in_all=False),
	"macos": Layer(lambda only, _: testing_macos.run_layer(only), None, in_all=False),
	"web": Layer(lambda only, _: testing_web.run_layer(only), None, in_all=False),
	"release": Layer(lambda only, _: testing_release.run_layer("release", only), None, in_all=False),
}
ALL = tuple(name for name, layer in LAYERS.items() if layer.in_all)


def took(before, after):
	"""Returns the time between two results of os.times(), in words."""
	processor = sum(after[:4]) - sum(before[:4])
	return f"{after.elapsed - before.elapsed:.0f} s, {processor:.0f} s of a processor"


def run_layer(layer, only, hardware):
	"""Runs a layer in this process, which has built and imported the extension. Returns its Tally."""
	say(f"Tests: {layer}")
	before = os.times()
	if target := {LAYERS[layer].target} - {None, "extension"}:
		build.scons(*target)
	testing_platforms.prepare([layer])
	tally = LAYERS[layer].run(only, hardware)
	say(f"{layer}: {tally.line()} ({took(before, os.times())})")
	return tally


def run(layers=ALL, only="", hardware=False):
	"""Builds, runs `layers` (the gpu layer on the machine's GPU if `hardware`), prints the sum. Returns whether all went well."""
	if side_by_side.is_part():
		return side_by_side.hand_over(run_layer(layers[0], only, hardware))
	if hardware and not machine.gpu():
		raise Failure("--gpu: there is no GPU here that Vulkan can use: no card in /dev/dri or /dev/nvidia*, or no driver in vulkan/icd.d.")
	machine.ensure(*machine.BUILDING, *on_screen(layers, hardware))
	if "extension" in {LAYERS[layer].target for layer in layers}:
		build.scons("extension")
		engine.import_project()
	total = Tally()
	if len(layers) > 1:
		tallies = side_by_side.run(sorted(layers, key=lambda layer: -LAYERS[layer].minutes), only, hardware)
		for layer in layers:
			total.add(tallies[layer])
	else:
		total.add(run_layer(layers[0], only, hardware))
	if not total.count():
		total.failed.append(f"no test has {only!r} in its name")
	for text in total.skipped:
		print(f"skipped: {text}")
	for text in total.failed:
		print(f"FAILED: {text}")
	print(total.line(), flush=True)
	return not total.failed
