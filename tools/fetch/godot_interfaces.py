# SPDX-License-Identifier: MIT
"""The engine's interface as it is published for each version of Godot, in a crate that `cargo` fetches."""

import os
import pathlib
import re
import shutil
import subprocess

from tools import locks
from tools.places import TOOLS
from tools.say import Failure, progress

# The newest that was published. It holds extension_api.json of each version, and the C interface of the last one.
CRATE, VERSION = "gdextension-api", "0.5.1"
PLACE = TOOLS / "godot_interfaces"
PACKAGE = f"""[package]
name = "godot_interfaces"
version = "0.0.0"

[lib]
path = "empty.rs"

[dependencies]
{CRATE} = "={VERSION}"
"""


def published(least):
	"""Paths of the extension_api.json of each Godot from version `least` on, oldest first, and of the C interface's description.
	([], None) if there is no cargo to fetch them. GODOT_API names a single extension_api.json to take instead."""
	if named := os.environ.get("GODOT_API"):
		if not pathlib.Path(named).is_file():
			raise Failure(f"GODOT_API={named} is no file: name an extension_api.json.")
		return [pathlib.Path(named)], None
	if not shutil.which("cargo"):
		return [], None
	with locks.alone("fetch"):
		fetch()
	folder = PLACE / "crates" / CRATE / "src"
	found = {tuple(map(int, path.parent.name.split("."))): path for path in folder.glob("*/extension_api.json")}
	versions = sorted(version for version in found if version >= least)
	return [found[version] for version in versions], folder / "gdextension_interface.json"


def fetch():
	"""Fetches the crate once, from the registry that the machine's cargo knows."""
	stamp = PLACE / "stamp"
	if stamp.exists() and stamp.read_text() == PACKAGE:
		return
	shutil.rmtree(PLACE, ignore_errors=True)
	PLACE.mkdir(parents=True)
	(PLACE / "Cargo.toml").write_text(PACKAGE)
	(PLACE / "empty.rs").touch()
	command = ["cargo", "vendor", "--quiet", "--manifest-path", str(PLACE / "Cargo.toml"), str(PLACE / "crates")]
	with progress("Fetching the interfaces of other versions of Godot"):
		result = subprocess.run(command, cwd=PLACE, capture_output=True, text=True)
	if result.returncode:
		words = re.sub(r"\S+://\S+", "(address)", result.stderr[-2000:])
		raise Failure(f"cargo could not fetch {CRATE} {VERSION}:\n{words}")
	stamp.write_text(PACKAGE)
