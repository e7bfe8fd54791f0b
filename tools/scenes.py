# SPDX-License-Identifier: MIT
"""Runs the scenes that a person looks at: the demo, the benchmark, the editor."""

import os
import pathlib
import subprocess

from tools import build, engine, machine, settle
from tools.places import OUT, PROJECT
from tools.say import Failure, say

DEMO_LIMIT = 3600  # seconds
SIZES = {"large": "1920x1080", "small": "1280x720"}


def play(scene, arguments, size, method, limit):
	"""Runs `scene` in a window with arguments of its own, until it ends."""
	engine.import_project()
	with engine.window(method, size) as (command, environment):
		everything = [*command, "--path", str(PROJECT), scene, "--", *arguments]
		code = engine.run(everything, environment, lambda line: print(line, flush=True), limit)
	if code:
		raise Failure(f"{scene} ended with code {code}." if code > 0 else f"{scene}: the engine died of signal {-code}.")


def ready(scene):
	"""Gets and builds what a scene needs."""
	if not (PROJECT / scene.removeprefix("res://")).exists():
		raise Failure(f"There is no {scene} in this version.")
	machine.ensure(*machine.BUILDING, machine.SCREEN, machine.VULKAN)
	build.scons("extension")


def results(folder):
	"""Says which pictures and tables lie in `folder`."""
	files = sorted(file for file in folder.rglob("*") if file.is_file())
	if not files:
		raise Failure(f"The scene wrote nothing to {folder}.")
	say(f"Pictures and tables are in {folder}:")
	for file in files:
		print(f"  {file.relative_to(folder)}")


def demo(out, size, method):
	ready("res://demo/demo.tscn")
	hardware = machine.gpu() and machine.display()
	size = size or ("large" if hardware else "small")
	folder = pathlib.Path(out or OUT / "demo").resolve()
	folder.mkdir(parents=True, exist_ok=True)
	say(f"Running the demo, {size}, on {'the GPU' if hardware else 'software Vulkan (some minutes)'}")
	play("res://demo/demo.tscn", ["--out", str(folder), "--size", size], SIZES[size], method, DEMO_LIMIT)
	results(folder)


def bench(out):
	ready("res://bench/bench.tscn")
	folder = pathlib.Path(out or OUT / "bench").resolve()
	folder.mkdir(parents=True, exist_ok=True)
	play("res://bench/bench.tscn", ["--out", str(folder)], SIZES["large"], "forward_plus", DEMO_LIMIT)
	results(folder)


def editor():
	"""Opens the editor with the user's own settings."""
	if not machine.display():
		raise Failure("The editor needs a screen: neither DISPLAY nor WAYLAND_DISPLAY is set.")
	machine.ensure(*machine.BUILDING, machine.VULKAN)
	build.scons("extension")
	prefix, driver = ([], {}) if machine.gpu() else engine.software_vulkan()
	sound = [] if os.path.isdir("/dev/snd") else ["--audio-driver", "Dummy"]
	command = [*prefix, machine.godot(), *sound, "--editor", "--path", str(PROJECT)]
	code = subprocess.run(command, env={**os.environ, **settle.environment(), **driver}).returncode
	if code:
		raise Failure(f"The editor ended with code {code}.")
