# SPDX-License-Identifier: MIT
"""The project that the laboratory's scenes run in: a copy of godot_project with lab/project in it, build/lab."""

import shutil

from tools.build import build
from tools.fetch import machine
from tools.places import BUILD, PROJECT, ROOT
from tools.run import engine

PLACE = BUILD / "lab"
SCENES = ROOT / "lab/project"
MAIN = '\n[application]\n\nrun/main_scene.bench="res://bench/bench.tscn"\n'  # of exports by the preset Benchmark


def make():
	"""Makes the copy anew, of the library that is built, and lets the engine import it."""
	PLACE.mkdir(parents=True, exist_ok=True)
	for old in PLACE.iterdir():
		if old.name != ".godot":  # what was imported is kept: files keep their times
			shutil.rmtree(old) if old.is_dir() else old.unlink()
	shutil.copytree(PROJECT, PLACE, symlinks=True, dirs_exist_ok=True, ignore=shutil.ignore_patterns(".godot"))
	shutil.copytree(SCENES, PLACE, dirs_exist_ok=True)
	with open(PLACE / "project.godot", "a") as file:
		file.write(MAIN)
	engine.import_project(PLACE)


def ready(*targets):
	"""Fetches and builds everything that the scenes need."""
	machine.ensure(*machine.BUILDING, machine.SCREEN, machine.VULKAN)
	build.scons("extension", *targets)
	make()
