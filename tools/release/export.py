# SPDX-License-Identifier: MIT
"""Packs the project to run without the editor: OUT/grass_field, its .pck and the extension's library."""

import pathlib
import re
import subprocess

from tools.build import build
from tools.fetch import machine
from tools.places import PROJECT
from tools.run import engine
from tools.say import Failure, progress, say

PRESET = "Linux"  # in godot_project/export_presets.cfg
TESTS_PRESET = "Tests"  # the same, but that res://tests/runner.tscn is the main scene
NAME = "grass_field"
KINDS = ("debug", "release")


def install_templates():
	"""Puts the export templates where the engine looks for them: in its data folder, under its version."""
	answer = subprocess.run([machine.godot(), "--version"], capture_output=True, text=True).stdout
	version = re.search(r"^\d+\.\d+(\.\d+)?\.[a-z]+\d*", answer, re.MULTILINE)[0]  # such as 4.6.3.stable
	folder = engine.HOME / "data/godot/export_templates" / version
	folder.mkdir(parents=True, exist_ok=True)
	for kind in KINDS:
		place = folder / f"linux_{kind}.x86_64"
		place.unlink(missing_ok=True)
		place.symlink_to(machine.program(f"godot-template-{kind}"))


def export(out, debug, tests=False):
	kind = "debug" if debug or tests else "release"
	folder = pathlib.Path(out).resolve()
	if folder == PROJECT or PROJECT in folder.parents:
		raise Failure("OUT must lie outside of the project that is packed.", 2)
	build.scons("extension", f"target={kind}")
	templates = [f"godot-template-{kind}" for kind in KINDS]  # the engine asks for both
	machine.ensure((lambda: all(map(machine.program, templates)), tuple(templates)))
	engine.import_project()
	install_templates()
	folder.mkdir(parents=True, exist_ok=True)
	pack(f"--export-{kind}", TESTS_PRESET if tests else PRESET, folder / NAME, folder / f"{NAME}.pck")
	say(f"Packed: {', '.join(sorted(file.name for file in folder.iterdir()))} in {folder}")
	say("Debian's template needs Debian's libraries: elsewhere, put a template of your own in the place of " + NAME)


def pack(how, preset, file, pck, project=PROJECT):
	output = []
	command, environment = engine.headless()
	with progress("Packing the project"):
		code = engine.run([*command, "--path", str(project), how, preset, str(file)], environment, output.append)
	if code or not pck.exists():
		raise Failure("The engine could not pack the project:\n" + "\n".join(output[-30:]))
