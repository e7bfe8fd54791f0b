# SPDX-License-Identifier: MIT
"""Builds the extension and the unit tests with SCons."""

import os
import shutil
import subprocess

from tools import locks
from tools.build import toolchains, universal
from tools.fetch import machine
from tools.places import ADDON_BIN, BUILD, PROJECT, ROOT, TOOLS
from tools.say import Failure, say


def scons(*arguments):
	"""Runs SCons with `arguments` (targets and option=value). Raises Failure if the build fails."""
	given = dict(argument.split("=", 1) for argument in arguments if "=" in argument)
	system, arch = given.get("platform", toolchains.HERE[0]), given.get("arch", toolchains.HERE[1])
	if "cxx" not in given and universal.is_ours(system, arch):
		for part in universal.PROCESSORS:
			scons(*(f"arch={part}" if argument.startswith("arch=") else argument for argument in arguments))
		universal.join({part: library(system, part, given) for part in universal.PROCESSORS}, library(system, arch, given))
		return
	machine.ensure(*machine.BUILDING, *toolchains.needs(system, arch))
	command, additions = machine.scons()
	environment = {**os.environ, **additions, "PYTHONDONTWRITEBYTECODE": "1"}
	if system == "macos" and "cxx" not in given:
		universal.ensure()
		environment |= {"ZIG_GLOBAL_CACHE_DIR": str(TOOLS / "zig_cache"), "ZIG_LOCAL_CACHE_DIR": str(TOOLS / "zig_cache")}
	with locks.alone("scons"):
		say("Building" + "".join(f" {argument}" for argument in arguments))
		code = subprocess.run([*command, "-Q", *arguments], cwd=ROOT, env=environment, stdin=subprocess.DEVNULL).returncode
	if code:
		raise Failure("The build failed; the lines above say where.")


def library(system, arch, given):
	"""The path of the library that SCons builds with these options."""
	kind = given.get("target", "debug")
	folder = BUILD if (system, arch) == toolchains.HERE else BUILD / f"{system}_{arch}"
	own = "-double" if given.get("precision") == "double" else ""
	quick, symbols = (given.get(option) == "yes" for option in ("quick", "symbols"))
	place = folder / f"quick{own}" if quick else folder / "symbols" / f"{kind}{own}" if symbols else ADDON_BIN
	return place / f"libgrass_field.{system}.template_{kind}{own.replace('-', '.')}.{arch}.{toolchains.SUFFIXES[system]}"


def clean(fetched_too=False):
	"""Removes everything that was built and imported; pictures and tables in out/ stay."""
	for folder in (BUILD, ADDON_BIN, PROJECT / ".godot", *([TOOLS] if fetched_too else [])):
		if folder.exists():
			say(f"Removing {folder.relative_to(ROOT)}")
			shutil.rmtree(folder)
