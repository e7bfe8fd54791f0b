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
COMPARING = ROOT / "tests/release/compare.gd"
EXTENSION = "res://addons/grass_field/grass_field.gdextension"
SEEN = re.compile(r"^GrassField (\S+), (.*): (\d+) blades, the ball bends them by (\d\.\d+) m(?:, bits (\w+))?", re.MULTILINE)
LIMIT = 900  # seconds
APART_MOST, FAR_MOST = 1.0, 4.0  # of two drivers' pictures, in steps of 255: see compare.gd. Mobile's is 0.5 and 1.4 from Forward+'s


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


def run(*command, more=None):
	"""Returns the output of an engine that ends well. Raises Failure otherwise. `more`: additions to the environment."""
	try:
		result = subprocess.run(
			list(map(str, command)),
			env={**os.environ, **(more or {})},
			stdin=subprocess.DEVNULL,
			capture_output=True,
			text=True,
			errors="replace",
			timeout=LIMIT,
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


def files_in(paths, kind):
	"""Returns the files of a kind (".json") among `paths` and in those that are folders."""
	found = [file for path in map(pathlib.Path, paths) for file in (sorted(path.rglob(f"*{kind}")) if path.is_dir() else [path])]
	return [file for file in found if file.suffix == kind]


def compare(paths, command=None, more=None):
	"""Raises Failure unless all files that run_all() wrote have the same bits, and all pictures look alike. `paths`: files, or folders of
	them; `command`, `more`: an engine without a window, and additions to its environment."""
	results, pictures = files_in(paths, ".json"), files_in(paths, ".png")
	if len(results) == 1 or len(pictures) == 1 or not results + pictures:
		raise Failure(f"{len(results)} results and {len(pictures)} pictures: nothing to compare.", 2)
	if results:
		compare_bits({file: json.loads(file.read_text()) for file in results})
	if pictures:
		compare_pictures(pictures, command or [engine(), "--headless"], more)


def compare_bits(results):
	rows = [f"{one['bits']}  {one['system']}, {one['engine']} ({file.name})" for file, one in results.items()]
	if len({one["bits"] for one in results.values()}) > 1:
		raise Failure("Systems differ in what blades do:\n" + "\n".join(rows))
	say("The same bits everywhere:\n" + "\n".join(rows))


def pictures_apart(command, pairs, more=None):
	"""Returns what compare.gd says of each pair of pictures. `command`: an engine without a window."""
	said = run(*command, "--script", COMPARING, "--", *(file for pair in pairs for file in pair), more=more)
	found = [json.loads(line) for line in said.splitlines() if line.startswith("{")]
	if len(found) != len(pairs) or any("error" in one for one in found):
		raise Failure(f"The pictures could not be compared:\n{said[-2000:]}")
	return found


def compare_pictures(files, command, more):
	first, *others = files
	found = pictures_apart(command, [(first, other) for other in others], more)
	rows = [f"{one['apart']:.2f} apart, {one['far']:.2f} at most  {other}" for one, other in zip(found, others)]
	if any(one["apart"] > APART_MOST or one["far"] > FAR_MOST for one in found):
		raise Failure(f"Pictures differ from {first}, in steps of 255:\n" + "\n".join(rows))
	say(f"The picture of {first} everywhere, in steps of 255:\n" + "\n".join(rows))
