# SPDX-License-Identifier: MIT
"""Tests of the layer `gpu` that draw both eyes of a headset in one draw. The engine makes the shaders for that only where a project asks
for them, so they run in a copy of the project that does."""

import shutil

from tools.places import BUILD, PROJECT
from tools.run import engine
from tools.test.test_runs import Tally, in_engine

COPY = BUILD / "stereo/project"


def layer(only, where):
	tests = [f"stereo/{file.stem}" for file in (PROJECT / "tests/stereo").glob("test_*.gd")]
	if only and not any(part in test for part in only.split(",") for test in tests):
		return Tally()
	shutil.rmtree(COPY, ignore_errors=True)
	shutil.copytree(PROJECT, COPY, symlinks=True)
	with open(COPY / "project.godot", "a") as file:
		file.write("\n[xr]\n\nshaders/enabled=true\n")
	with engine.window(**where) as (command, environment):
		return in_engine("stereo", command, environment, only, title="gpu (stereo)", project=COPY)
