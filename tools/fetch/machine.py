# SPDX-License-Identifier: MIT
"""Finds tools: first on the system, then among the fetched packages.

Each finder returns what is needed to use the tool, or None where it has yet to be fetched (packages.py).
"""

import functools
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys

from tools import locks
from tools.fetch import settle
from tools.fetch.packages import fetch
from tools.fetch.roots import MAIN
from tools.places import UNPACKED
from tools.say import Failure

GODOT_MINIMUM = (4, 6)


def unpacked(path):
	"""Returns a file of the fetched packages, or None."""
	file = UNPACKED / path
	return file if file.exists() else None


def program(*names):
	"""Returns the path of the first of `names` that the machine has, otherwise of a fetched one. None if there is neither."""
	fetched = (UNPACKED / "usr/bin" / name for name in names)
	return next(filter(None, map(shutil.which, names)), None) or next((str(file) for file in fetched if file.exists()), None)


@functools.cache
def godot_version(executable):
	"""Returns the version of a Godot executable, such as (4, 6, 3). None if it does not run or is not Godot."""
	try:
		answer = subprocess.run([executable, "--version"], capture_output=True, text=True, timeout=60).stdout
	except (OSError, subprocess.TimeoutExpired):
		return None
	match = re.search(r"^(\d+)\.(\d+)(?:\.(\d+))?\.\w", answer, re.MULTILINE)
	return tuple(int(part or 0) for part in match.groups()) if match else None


def godot():
	"""The engine: the one that GODOT= names, or else a new enough one of the machine, or else the fetched one. None if there is none."""
	if named := os.environ.get("GODOT"):
		version = godot_version(shutil.which(named) or named)
		if version is None:
			raise Failure(f"GODOT={named} is no Godot that runs here.")
		if version < GODOT_MINIMUM:
			raise Failure(
				f"GODOT={named} is Godot {'.'.join(map(str, version))}; GrassField needs 4.6 or newer."
				" Name a newer one, or unset GODOT to have one fetched."
			)
		return shutil.which(named) or named
	for name in ("godot", "godot4", "godot-4"):
		found = shutil.which(name)
		if found and (godot_version(found) or (0,)) >= GODOT_MINIMUM:
			return found
	fetched = unpacked("usr/bin/godot")
	return str(fetched) if fetched else None


def scons():
	"""Returns (command, environment additions) that runs SCons."""
	if importlib.util.find_spec("SCons"):
		return [sys.executable, "-m", "SCons"], {}
	if found := shutil.which("scons"):
		return [found], {}
	if packages := unpacked("usr/lib/python3/dist-packages"):
		if (packages / "SCons").is_dir():
			return [sys.executable, "-m", "SCons"], {"PYTHONPATH": str(packages)}
	return None


def header_folder(header, *folders):
	"""Returns the folder to put on the include path so that `header` is found: the machine's first."""
	candidates = [pathlib.Path(top) / folder for top in ("/usr/local", "/opt/homebrew", "/usr", UNPACKED / "usr") for folder in folders]
	return next((str(folder) for folder in candidates if (folder / header).is_file()), None)


def eigen():
	return header_folder("Eigen/Dense", "include/eigen3", "include")


def doctest():
	return header_folder("doctest/doctest.h", "include")


def glslang():
	return program("glslang", "glslangValidator")


def compiler():
	return os.environ.get("CXX") or next((name for name in ("g++", "clang++", "c++") if shutil.which(name)), None)


def display():
	"""Returns whether there is a screen for a window."""
	return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def vulkan_drivers():
	"""Returns the system's Vulkan driver descriptions, as (of GPUs, of software)."""
	files = [file for top in ("/etc", "/usr/share", "/usr/local/share") for file in pathlib.Path(top, "vulkan/icd.d").glob("*.json")]
	software = [file for file in files if file.name.startswith("lvp")]
	return [file for file in files if file not in software], software


def gpu():
	"""Returns whether there is a GPU that Vulkan can use."""
	cards = [*pathlib.Path("/dev/dri").glob("renderD*"), *pathlib.Path("/dev").glob("nvidia[0-9]*")]
	return bool(cards and vulkan_drivers()[0])


def x_server():
	"""Xvfb, which needs xkbcomp beside it. None if either is missing."""
	xvfb = program("Xvfb")
	return xvfb if xvfb and (str(UNPACKED) in xvfb or shutil.which("xkbcomp")) else None


def software_vulkan():
	"""Lavapipe for the engine: the system's for an engine of the machine, otherwise the fetched one. None if there is none."""
	fetched = unpacked(settle.LIBRARIES + "/libvulkan_lvp.so")
	engine_is_fetched = godot() in (None, str(UNPACKED / "usr/bin/godot"))  # or will be
	return fetched if engine_is_fetched else next(iter(vulkan_drivers()[1]), fetched)


def validation_layer():
	"""The folder of the validation layer for the Vulkan loader: the machine's for an engine of the machine, otherwise the fetched one."""
	folders = [pathlib.Path(top) / "vulkan/explicit_layer.d" for top in ("/etc", "/usr/share", "/usr/local/share")]
	fetched = UNPACKED / "usr/share/vulkan/explicit_layer.d"
	known = [fetched] if godot() in (None, str(UNPACKED / "usr/bin/godot")) else [*folders, fetched]
	return next((folder for folder in known if (folder / "VkLayer_khronos_validation.json").exists()), None)


# The needs of the commands: how to find each tool, the Debian packages that contain it, and where to unpack them if not beside the engine.
ENGINE = (godot, ("godot", "patchelf"))
BUILDING = (
	ENGINE,
	(scons, ("scons",)),
	(eigen, ("libeigen3-dev",)),
	(doctest, ("doctest-dev",)),
	(glslang, ("glslang-tools", "patchelf")),
)
VIRTUAL_SCREEN = (x_server, ("xvfb", "xkb-data", "x11-xkb-utils", "patchelf"))
SCREEN = (lambda: display() or x_server(), VIRTUAL_SCREEN[1])
SOFTWARE_VULKAN = (software_vulkan, ("libvulkan1", "mesa-vulkan-drivers", "patchelf"))
VALIDATION = (validation_layer, ("vulkan-validationlayers", "patchelf"))
VULKAN = (lambda: gpu() and display() or software_vulkan(), SOFTWARE_VULKAN[1])


def ensure(*needs):
	"""Fetches those of `needs` that the machine lacks. Raises Failure if it lacks a compiler, or if fetching fails."""
	ensure_compiler()
	settle.check()
	with locks.alone("fetch"):
		wanted = {}
		for found, names, *root in needs:
			if not found():
				wanted.setdefault(root[0] if root else MAIN, set()).update(names)
		for root, packages in wanted.items():
			fetch(sorted(packages), root)
	lacking = [names[0] for found, names, *_ in needs if not found()]
	if lacking:
		raise Failure(f"Fetched, but not found: {', '.join(lacking)}. Remove {UNPACKED.parent} and run this again.")


def ensure_compiler():
	if compiler() is None:
		raise Failure(
			"There is no C++ compiler. Install one: `apt-get install g++` (Debian, Ubuntu), `dnf install gcc-c++` (Fedora),"
			" `pacman -S gcc` (Arch)."
		)
