# SPDX-License-Identifier: MIT
"""Runs parts of the benchmarks on this machine, one process each. A part whose record lies in the folder is done: a second start goes on.

The folder has for each part its table NAME.csv, its record NAME.json and what its engine said, NAME.log; and manifest.json, all records.
"""

import contextlib
import datetime
import json
import subprocess
import time

from lab.tools import accuracy, commits, lab_project
from lab.tools.parts import HERE, PARTS
from tools.fetch import machine
from tools.places import BUILD, OUT
from tools.run import engine, scenes
from tools.say import Failure, progress, say

SCENE = "res://bench/bench.tscn"
SMALL = "640x360"  # of a window whose picture software draws


def records(folder):
	"""Returns the records of parts that are done, by name."""
	found = {}
	for path in sorted(folder.glob("*.json")):
		with contextlib.suppress(ValueError):  # one that was cut off
			record = json.loads(path.read_text())
			if isinstance(record, dict) and record.get("part") == path.stem:
				found[path.stem] = record
	return found


def left(parts, folder, commit, is_quick):
	"""Returns those of the parts that are not done at this commit, in full or as a sample."""
	known = records(folder)
	return [
		part
		for part in parts
		if any(known.get(part.name, {}).get(key) != value for key, value in (("commit", commit), ("quick", is_quick)))
	]


def write_manifest(folder):
	(folder / "manifest.json").write_text(json.dumps({"parts": records(folder)}, indent="\t", ensure_ascii=False) + "\n")


def run(parts, folder, is_quick):
	"""Returns the names of parts that failed."""
	folder.mkdir(parents=True, exist_ok=True)
	commit, failed = commits.measured(), []
	todo = left(parts, folder, commit, is_quick)
	if done := len(parts) - len(todo):
		say(f"{done} of {len(parts)} parts are done, in {folder}")
	if todo:
		lab_project.ready("bench", "accuracy")
	for part in todo:
		(folder / f"{part.name}.json").unlink(missing_ok=True)
		begin = time.monotonic()
		try:
			program(part, folder, commit, is_quick) if part.program else play(part, folder, commit, is_quick)
		except Failure as failure:
			say(f"{part.name}: {failure}")
		write_manifest(folder)
		if part.name not in records(folder):
			failed.append(part.name)
		say(f"{part.name}: {'FAILED after ' if part.name in failed else ''}{time.monotonic() - begin:.0f} s")
	return failed


def program(part, folder, commit, is_quick):
	"""Programs, whose output is the table."""
	begin, lines = time.monotonic(), []
	with progress(f"Running {part.name}", every=10):
		for one in part.program.split(";"):
			name, *arguments = [*one.split(), *(["--quick"] if is_quick and "quick" in part.takes else [])]
			result = subprocess.run([str(BUILD / "bench" / name), *arguments], capture_output=True, text=True)
			if result.returncode:
				raise Failure(f"{one} ended with code {result.returncode}:\n{result.stderr}")
			lines += result.stdout.splitlines()
	today = str(datetime.date.today())
	head = f"# {accuracy.processor()}, one core; commit {commit}; {today}"
	columns = [",".join(accuracy.COLUMNS)] if part.name == "accuracy_cpu" else []
	(folder / f"{part.name}.csv").write_text("\n".join([head, *columns, *lines, ""]))
	record = {"part": part.name, "state": "done", "commit": commit, "quick": is_quick, "date": today, "processor": accuracy.processor()}
	record |= {"seconds": round(time.monotonic() - begin, 1), "command": part.program}
	(folder / f"{part.name}.json").write_text(json.dumps(record, indent="\t") + "\n")


def arguments(part, folder, commit, is_quick):
	"""Returns those of bench.gd."""
	found = ["--only", part.key(), "--as", part.name, "--commit", commit, "--out", str(folder)]
	if "spirv" in part.takes:
		found += ["--spirv", str(BUILD / "bench")]
	if "packs" in part.takes:
		found += ["--packs", str(packs(is_quick))]
	return [*found, "--quick", "yes"] if is_quick else found


def packs(is_quick):
	folder = OUT / f"bench_packs{'_quick' if is_quick else ''}"
	if not folder.exists():
		accuracy.record(folder, is_quick)
	return folder


def play(part, folder, commit, is_quick):
	size = SMALL if is_quick else part.size
	window = contextlib.nullcontext(engine.headless()) if part.method == "headless" else engine.window(part.method, size)
	with window as (command, environment), progress(f"Running {part.name}", every=10), open(folder / f"{part.name}.log", "w") as log:
		everything = [
			*command,
			*part.flags.split(),
			"--path",
			str(lab_project.PLACE),
			SCENE,
			"--",
			*arguments(part, folder, commit, is_quick),
		]
		own = {**environment, **caches(part, folder)}
		code = engine.run(everything, own, lambda line: print(line, file=log, flush=True), scenes.LIMIT, silence=scenes.LIMIT)
	if code:
		raise Failure(f"it ended with code {code} (negative: a signal); {folder / part.name}.log has what it said.")


def caches(part, folder):
	"""Environment additions: caches of shaders that are this part's own, where it has to have an empty one, or that of the part before."""
	if part.cache == "shared":
		return {}
	home = folder / "caches"
	if part.cache == "empty":
		subprocess.run(["rm", "-rf", str(home)], check=True)
	names = ("XDG_DATA_HOME", "XDG_CACHE_HOME", "MESA_SHADER_CACHE_DIR", "__GL_SHADER_DISK_CACHE_PATH")
	return {name: str(home / name.lower()) for name in names}


def only_here(parts):
	return [part for part in parts if part.where == HERE]


def has_card():
	return machine.gpu() and machine.display()


def listing(times):
	"""Returns lines that name the parts, the seconds of each and its pages."""
	lines = []
	for part in PARTS:
		seconds = times.get(part.name)
		took = f"{seconds:6.1f} s" if seconds else f"{part.seconds:4d} s ?"
		shown = ", ".join(f"{page}.md" for page in part.pages) or "only if named with --only"
		lines.append(f"  {part.name:14} {part.where:5} {took:9}  {shown}")
	return lines
