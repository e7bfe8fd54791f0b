# SPDX-License-Identifier: MIT
"""Builds the extension and the unit tests with SCons."""

import os
import shutil
import subprocess

from tools import locks
from tools.build import names, toolchains, universal
from tools.fetch import machine
from tools.places import ADDON_BIN, BUILD, PROJECT, ROOT, TOOLS
from tools.say import Failure, say


def scons(*arguments):
	"""Runs SCons with `arguments` (targets and option=value). Raises Failure if the build fails."""
	given = dict(argument.split("=", 1) for argument in arguments if "=" in argument)
	system, arch = given.get("platform", names.HERE[0]), given.get("arch", names.HERE[1])
	if "cxx" not in given and universal.is_ours(system, arch):
		for part in universal.PROCESSORS:
			scons(*(f"arch={part}" if argument.startswith("arch=") else argument for argument in arguments))
		universal.join({part: library(system, part, given) for part in universal.PROCESSORS}, library(system, arch, given))
		return
	own = {} if "cxx" in given else toolchains.ensure(system, arch)
	machine.ensure(*machine.BUILDING)
	command, additions = machine.scons()
	environment = {**os.environ, **additions, **own, "PYTHONDONTWRITEBYTECODE": "1"}
	with locks.alone("scons"):
		say("Building" + "".join(f" {argument}" for argument in arguments))
		code = subprocess.run([*command, "-Q", *arguments], cwd=ROOT, env=environment, stdin=subprocess.DEVNULL).returncode
	if code:
		raise Failure("The build failed; the lines above say where.")


def library(system, arch, given):
	"""Returns the path of the library that SCons builds with these options."""
	kind, precision, threads = given.get("target", "debug"), given.get("precision", "single"), given.get("threads", "yes") == "yes"
	folder, own = names.folder(system, arch, threads), "-double" if precision == "double" else ""
	quick, symbols = (given.get(option) == "yes" for option in ("quick", "symbols"))
	place = folder / f"quick{own}" if quick else folder / "symbols" / f"{kind}{own}" if symbols else ADDON_BIN
	return place / names.library(system, arch, kind, precision, threads)


def clean(fetched_too=False):
	"""Removes everything that was built and imported; pictures and tables in out/ stay."""
	for folder in (BUILD, ADDON_BIN, PROJECT / ".godot", *([TOOLS] if fetched_too else [])):
		if folder.exists():
			say(f"Removing {folder.relative_to(ROOT)}")
			shutil.rmtree(folder)
