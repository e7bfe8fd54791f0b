# SPDX-License-Identifier: MIT
"""A test of the layer `gpu`: a field stands in engines that are built without some of their classes and methods. The debug library treats
what GRASS_HIDDEN names as if the engine had none (extension/binding/src/engine_call.cpp)."""

from tools.places import PROJECT
from tools.run import engine
from tools.say import Failure, progress
from tools.test.test_runs import Tally

# What a game's own template may lack: without XR (`disable_xr=yes`), without modules, or by a build profile.
OPTIONAL = (
	"Viewport.is_using_xr",
	"XRServer",
	"XRInterface",
	"CSGShape3D",
	"SoftBody3D",
	"VehicleBody3D",
	"VehicleWheel3D",
	"Compositor",
	"CompositorEffect",
)
SCENE = "res://tests/gpu/lacking.tscn"
SIZE = "64x64"  # of the window, the least
LIMIT = 400  # seconds


def layer(only, where):
	"""Returns the Tally: all of it hidden at once, and if `only` names this test, each in turn. `where`: for engine.window()."""
	tally = Tally()
	for hidden in (OPTIONAL, *((name,) for name in OPTIONAL if only)):
		name = f"gpu/lacking.{'everything_that_is_optional' if len(hidden) > 1 else hidden[0]}"
		if only and not any(part in name for part in only.split(",")):
			continue
		wrong = run(name, hidden, where)
		print(f"  {'fail' if wrong else 'pass'} {name}", flush=True)
		tally.passed += not wrong
		tally.failed += [f"{name}: {wrong}"] if wrong else []
	return tally


def run(name, hidden, where):
	"""Runs the scene where `hidden` is hidden. Returns what is wrong, or ""."""
	said = []
	with engine.window(**{**where, "size": SIZE}) as (command, environment), progress(f"Running {name}"):
		try:
			command = [*command, "--path", str(PROJECT), "--fixed-fps", "60", SCENE]
			code = engine.run(command, {**environment, "GRASS_HIDDEN": ",".join(hidden)}, said.append, LIMIT)
		except Failure as failure:
			code = failure
	errors = [line for line in said if "ERROR" in line and "This engine has no" not in line]
	if code or errors or not any(line.startswith("The ball bends the grass") for line in said):
		return f"{code}: {' | '.join([*errors, *said[-8:]])}"
	return ""
