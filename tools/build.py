# SPDX-License-Identifier: MIT
"""Builds the extension and the unit tests with SCons."""

import os
import shutil
import subprocess

from tools import locks, machine, toolchains
from tools.places import ADDON_BIN, BUILD, PROJECT, ROOT, TOOLS
from tools.say import Failure, say


def scons(*arguments):
	"""Runs SCons with `arguments` (targets and option=value). Failure if the build fails."""
	given = dict(argument.split("=", 1) for argument in arguments if "=" in argument)
	system, arch = given.get("platform", toolchains.HERE[0]), given.get("arch", toolchains.HERE[1])
	machine.ensure(*machine.BUILDING, *toolchains.needs(system, arch))
	command, additions = machine.scons()
	environment = {**os.environ, **additions, "PYTHONDONTWRITEBYTECODE": "1"}
	with locks.alone("scons"):
		say("Building" + "".join(f" {argument}" for argument in arguments))
		code = subprocess.run([*command, "-Q", *arguments], cwd=ROOT, env=environment, stdin=subprocess.DEVNULL).returncode
	if code:
		raise Failure("The build failed; the lines above say where.")


def clean(fetched_too=False):
	"""Removes what was built and imported; pictures and tables in out/ stay."""
	for folder in (BUILD, ADDON_BIN, PROJECT / ".godot", *([TOOLS] if fetched_too else [])):
		if folder.exists():
			say(f"Removing {folder.relative_to(ROOT)}")
			shutil.rmtree(folder)
