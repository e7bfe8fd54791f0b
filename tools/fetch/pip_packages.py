# SPDX-License-Identifier: MIT
"""Installs Python packages for a tool with pip, in the versions of a requirements file, each set into a folder of its own."""

import importlib.util
import os
import shutil
import subprocess
import sys

from tools.fetch import machine
from tools.say import Failure, progress


def pip():
	"""Returns (command, environment additions) that runs pip."""
	if importlib.util.find_spec("pip"):
		return [sys.executable, "-m", "pip"], {}
	packages = machine.unpacked("usr/lib/python3/dist-packages")
	return ([sys.executable, "-m", "pip"], {"PYTHONPATH": str(packages)}) if packages and (packages / "pip").is_dir() else None


def ensure(requirements, folder, purpose):
	"""Installs what the file `requirements` names into `folder`, from the index that the machine's pip knows."""
	state = f"{sys.version}\n{requirements.read_text()}"
	stamp = folder / "stamp"
	if stamp.exists() and stamp.read_text() == state:
		return
	machine.ensure((pip, ("python3-pip",)))
	shutil.rmtree(folder, ignore_errors=True)
	command, additions = pip()
	command += ["install", "--quiet", "--disable-pip-version-check", "--no-deps", "--target", str(folder), "-r", str(requirements)]
	with progress(f"Fetching {purpose}"):
		result = subprocess.run(command, env={**os.environ, **additions}, capture_output=True, text=True)
	if result.returncode:
		raise Failure(f"pip could not fetch {purpose}:\n{result.stderr[-2000:]}")
	stamp.write_text(state)


def source(requirement, folder, purpose):
	"""Fetches the sources of one package, as an archive, into a new `folder`; returns the archive."""
	machine.ensure((pip, ("python3-pip",)))
	shutil.rmtree(folder, ignore_errors=True)
	command, additions = pip()
	command += ["download", "--quiet", "--disable-pip-version-check", "--no-deps", "--no-binary=:all:", "--dest", str(folder), requirement]
	with progress(f"Fetching {purpose}"):
		result = subprocess.run(command, env={**os.environ, **additions}, capture_output=True, text=True)
	if result.returncode:
		raise Failure(f"pip could not fetch {purpose}:\n{result.stderr[-2000:]}")
	return next(folder.glob("*.tar.gz"))
