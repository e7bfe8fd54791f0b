# SPDX-License-Identifier: MIT
"""Runs the scenes that a person looks at: the demo, the editor."""

import os
import pathlib
import subprocess
import time

from tools.build import build
from tools.fetch import machine, settle
from tools.places import OUT, PROJECT
from tools.run import engine
from tools.say import Failure, progress, say

LIMIT = 3600  # seconds
PLAYED = ("walk",)  # demos that somebody plays, where there are a screen and a GPU
EVENING = 12 * 3600  # seconds that one may play
SIZES = {"large": "1920x1080", "small": "1280x720"}


def play(scene, folder, arguments, size, method):
	"""Runs `scene` in a window, with arguments of its own, until it ends. It writes to `folder`."""
	folder.mkdir(parents=True, exist_ok=True)
	engine.import_project()
	begin = time.time()

	def how_far():
		return f"{sum(file.stat().st_mtime >= begin for file in folder.iterdir())} files written"

	with engine.window(method, size) as (command, environment), progress(f"Running {scene}", how_far, every=10):
		everything = [*command, "--path", str(PROJECT), scene, "--", "--out", str(folder), *arguments]
		code = engine.run(everything, environment, lambda line: print(line, flush=True), LIMIT, silence=LIMIT)
	if code:
		raise Failure(f"{scene} ended with code {code} (negative: a signal).")


def ready(scene, *targets):
	"""Fetches and builds everything that a scene needs."""
	if not (PROJECT / scene.removeprefix("res://")).exists():
		raise Failure(f"There is no {scene} in this version.")
	machine.ensure(*machine.BUILDING, machine.SCREEN, machine.VULKAN)
	build.scons("extension", *targets)


def results(folder):
	"""Prints the pictures and tables in `folder`."""
	files = sorted(file for file in folder.rglob("*") if file.is_file())
	if not files:
		raise Failure(f"The scene wrote nothing to {folder}.")
	say(f"Pictures and tables are in {folder}:")
	for file in files:
		print(f"  {file.relative_to(folder)}")


def enter(scene, size, method):
	"""Runs `scene` in a window until the player closes it."""
	engine.import_project()
	with engine.window(method, SIZES[size]) as (command, environment):
		everything = [*command, "--path", str(PROJECT), scene, "--", "--size", size]
		code = engine.run(everything, environment, lambda line: print(line, flush=True), EVENING, silence=EVENING)
	if code:
		raise Failure(f"{scene} ended with code {code} (negative: a signal).")


def demo(place, out, size, method):
	scene = f"res://demo/{place}.tscn"
	ready(scene)
	hardware = machine.gpu() and machine.display()
	size = size or ("large" if hardware else "small")
	if place in PLAYED and hardware and not out:
		say(f"The {place}, {size}, to play; with --out DIR it takes pictures of itself instead")
		enter(scene, size, method)
		return
	folder = pathlib.Path(out or OUT / place).resolve()
	say(f"The {place}, {size}, on {'the GPU' if hardware else 'software Vulkan: this takes some minutes'}")
	play(scene, folder, ["--size", size], SIZES[size], method)
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
