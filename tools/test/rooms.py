# SPDX-License-Identifier: MIT
"""Compares the tables of rooms in docs/internals/architecture.md with the includes and imports of the sources. Part of the layer `docs`.

Each table lists rooms from the lowest up, with those that a room includes: exactly these, and none that comes after it.
"""

import re

from tools.places import ROOT

PAGE = ROOT / "docs/internals/architecture.md"
ROW = re.compile(r"^\| `(\w+)/` \|.*\|(.*)\|$", re.MULTILINE)
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
IMPORT = re.compile(r"^\s*from tools\.?(\w*)\S* import ([\w, ]+)", re.MULTILINE)


def tables():
	"""Each table of rooms: {room: the rooms that it includes by its row}, in the order of its rows."""
	text = PAGE.read_text()
	for block in re.findall(r"^\| room \|.*?\n((?:\|.*\n)+)", text, re.MULTILINE):
		yield {room: set(re.findall(r"`(\w+)/`", cell)) for room, cell in ROW.findall(block)}


def includes(folder, root, kinds, skipped=()):
	"""The other rooms of `folder` that the sources of these kinds in each room include, by a path from `root` or from themselves."""
	found = {}
	for path in sorted(path for kind in kinds for path in folder.rglob(f"*.{kind}")):
		room = path.relative_to(folder).parts[0]
		if path.parent == folder or room in skipped:
			continue
		targets = found.setdefault(room, set())
		for name in INCLUDE.findall(path.read_text()):
			for place in (root, path.parent):
				target = (place / name).resolve()
				if target.is_file() and folder in target.parents:
					targets.add(target.relative_to(folder).parts[0])
	return {room: targets - {room} for room, targets in found.items()}


def imports():
	"""Returns the other rooms of tools/ that the Python modules in each room import, and `cli`, which none may import."""
	folder, found = ROOT / "tools", {}
	rooms = {path.name for path in folder.iterdir() if (path / "__init__.py").is_file()}
	for path in sorted(folder.rglob("*.py")):
		if path.parent == folder:
			continue
		targets = found.setdefault(path.relative_to(folder).parts[0], set())
		for package, names in IMPORT.findall(path.read_text()):
			targets |= {package} & rooms if package else {"cli"} & {name.strip() for name in names.split(",")}
	return {room: targets - {room} for room, targets in found.items()}


def wrong_rows(told, real):
	"""Returns what is wrong with a table."""
	wrong, below = [], set()
	for room, said in told.items():
		if room not in real:
			wrong.append(f"there is no room {room}/")
		elif said != real[room]:
			wrong.append(
				f"{room}/ includes {', '.join(sorted(real[room])) or 'nothing'}, the table says {', '.join(sorted(said)) or 'nothing'}"
			)
		if up := real.get(room, set()) - below:
			wrong.append(f"{room}/ includes {', '.join(sorted(up))}, which the table lists after it")
		below.add(room)
	return [*wrong, *(f"the table lacks {room}/" for room in real if room not in told)]


def wrong():
	"""Returns what is wrong with the tables, or ""."""
	extension, shaders = ROOT / "extension", ROOT / "shaders"
	rooms = (
		includes(extension, extension, ("h", "cpp"), ("binding", "old_glibc")),
		includes(extension / "core", extension, ("h", "cpp")),
		includes(shaders, shaders, ("inc", "gdshaderinc", "gdshader")),  # a pass (glsl) puts together what it needs from any room
		imports(),
	)
	told = list(tables())
	if len(told) != len(rooms):
		return f"{len(told)} tables begin with a column `room`, not {len(rooms)}: extension, core, shaders, tools"
	return "; ".join(line for table, real in zip(told, rooms) for line in wrong_rows(table, real))
