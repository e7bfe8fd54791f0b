# SPDX-License-Identifier: MIT
"""`./grass try ZIP`: runs a packed add-on in an empty project, in the engine that GODOT names or the machine has.

It builds and fetches nothing and runs wherever Python does, Windows and macOS among them.
"""

import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import zipfile

from tools.places import OUT, ROOT
from tools.say import Failure, say

EMPTY = ROOT / "tests/release/project"  # a project with a field that knows nothing of this one
EXTENSION = "res://addons/grass_field/grass_field.gdextension"
SEEN = re.compile(r"^GrassField (\S+), (.*): (\d+) blades, the ball bends them by (\d\.\d+) m(?:, bits (\w+))?", re.MULTILINE)
LIMIT = 900  # seconds


def unpack(archive, project, sample=True):
	"""Makes a fresh project of a zip, for an add-on with the sample scene. The engine knows the extension when it starts, as
	docs/guide/ci.md describes."""
	shutil.rmtree(project, ignore_errors=True)
	if sample:
		shutil.copytree(EMPTY, project)
	with zipfile.ZipFile(archive) as file:
		file.extractall(project)
	(project / ".godot").mkdir()
	(project / ".godot/extension_list.cfg").write_text(f"{EXTENSION}\n")
	return project


def seen(said):
	"""Returns what the sample scene tells: version, renderer, blades, bend, bits. Raises Failure if it does not."""
	found = SEEN.search(said)
	if not found:
		raise Failure(f"The scene did not tell what it saw: {said[-1000:]}")
	return found.groups()


def engine():
	"""Returns the path of the engine."""
	named = os.environ.get("GODOT") or next(filter(None, map(shutil.which, ("godot", "godot4"))), None)
	if not named or not shutil.which(named):
		raise Failure(f"There is no engine to try it in ({named or 'none is on the path'}): name one, GODOT=/path/to/godot.")
	return shutil.which(named)


def run(*command):
	"""Returns the output of an engine that ends well. Raises Failure otherwise."""
	try:
		result = subprocess.run(
			list(map(str, command)), stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", timeout=LIMIT
		)
	except subprocess.TimeoutExpired:
		raise Failure(f"The engine still runs after {LIMIT} s: {' '.join(map(str, command))}") from None
	said = result.stdout + result.stderr
	if result.returncode or re.search(r"^(SCRIPT )?ERROR:", said, re.MULTILINE):
		raise Failure(f"The engine ended with code {result.returncode}:\n{said[-3000:]}")
	return said


def find(archive):
	"""Returns the add-on's zip: `archive` itself, or the one in that folder."""
	path = pathlib.Path(archive).resolve()
	if path.is_dir():
		zips = [found for found in path.glob("grass_field-*.zip") if re.fullmatch(r"grass_field-[\d.]+\.zip", found.name)]
		if len(zips) != 1:
			raise Failure(f"{path} holds {len(zips)} zips of the add-on: name one.", 2)
		path = zips[0]
	return path


def run_all(archive, out=None, driver="", picture=None):
	"""Runs it without a window, or in one with a rendering driver. Writes what was seen to `out`, a JSON file, and a `picture` of the
	window."""
	project, godot = unpack(find(archive), OUT / "try"), engine()
	made = [pathlib.Path(file).resolve() for file in (out, picture) if file]
	for file in made:
		file.parent.mkdir(parents=True, exist_ok=True)
	run(godot, "--headless", "--path", project, "--import")
	method = "gl_compatibility" if driver.startswith("opengl") else "forward_plus"
	window = ["--rendering-driver", driver, "--rendering-method", method, "--audio-driver", "Dummy", "--resolution", "320x180"]
	where = window if driver else ["--headless"]
	shown = ["--", made[-1]] if driver and picture else []
	version, renderer, blades, bend, bits = seen(run(godot, *where, "--path", project, "--fixed-fps", 60, *shown))
	if not driver and not bits:
		raise Failure(f"The scene ran with {renderer}, not headless.")
	found = {
		"system": f"{platform.system()} {platform.machine()}",
		"engine": run(godot, "--version").strip().splitlines()[-1],
		"grass_field": version,
		"renderer": f"{renderer} {driver}".strip(),
		"blades": int(blades),
		"bend": float(bend),
		"bits": bits,
	}
	say(", ".join(f"{name} {value}" for name, value in found.items()))
	if out:
		made[0].write_text(json.dumps(found, indent="\t") + "\n")


def compare(paths):
	"""Raises Failure unless all files that run_all() wrote have the same bits. `paths`: files, or folders of them."""
	files = [file for path in map(pathlib.Path, paths) for file in (sorted(path.rglob("*.json")) if path.is_dir() else [path])]
	results = {file: json.loads(file.read_text()) for file in files}
	if len(results) < 2:
		raise Failure(f"{len(results)} results: nothing to compare.", 2)
	rows = [f"{one['bits']}  {one['system']}, {one['engine']} ({file.name})" for file, one in results.items()]
	if len({one["bits"] for one in results.values()}) > 1:
		raise Failure("Systems differ in what blades do:\n" + "\n".join(rows))
	say("The same bits everywhere:\n" + "\n".join(rows))
