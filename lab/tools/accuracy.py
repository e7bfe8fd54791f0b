# SPDX-License-Identifier: MIT
"""The parts `accuracy` and `accuracy_cpu`: run time against error of both solver methods, as one CSV.

The CPU's rows come from the programs build/bench/accuracy_KNOTS. For the GPU's they record the steps of the same problems
(packs), the bench scene runs them, here or on another machine, and the programs compute the errors of what came back.
"""

import csv
import gzip
import pathlib
import platform
import subprocess
import tempfile

from tools.build import build
from tools.places import BUILD
from tools.say import Failure, progress, say

KNOTS = (8, 16, 32)
COLUMNS = ("method", "precision", "knots", "substeps", "iterations", "ms", "error", "value")
ERRORS = {
	"static_1": "Sag under an even load of Γ = 1, against the elastica (share)",
	"static_5": "Sag under an even load of Γ = 5, against the elastica (share)",
	"frequency": "First frequency at 2.5 Hz (share)",
	"amplitude_lost": "Amplitude lost in a period, undamped (share)",
	"transient": "Way of all knots in a second after release, against the converged rod (RMS, blade lengths)",
	"sphere_sweep": "Way of all knots under a ball at 5 m/s, against the converged rod (RMS, blade lengths)",
	"slow_pass": "Way of all knots beside a ball at 1 m/s, without friction, against the converged rod (RMS, blade lengths)",
	"fast_pass": "Way of all knots beside a ball at 5 m/s, without friction, against the converged rod (RMS, blade lengths)",
	"slow_ensemble": "Mean height of a sward under a ball at 1 m/s, against the limit (RMS over time, share)",
	"fast_ensemble": "Share of a sward pressed by a ball at 5 m/s, against the limit (RMS over time)",
	"plate": "How far blades stay off a plate that holds them down (mean, blade lengths)",
	"post": "How far blades stay off a post that leans on them (mean, blade lengths)",
	"tremble": "Farthest way of a knot in a step among blades that a plate or a post holds still (blade lengths)",
}


def write(folder, cpu, gpu_folder, is_quick):
	"""FOLDER/accuracy.csv: of the table `cpu` of the part accuracy_cpu, or of the rows already there, and what a GPU wrote."""
	folder.mkdir(parents=True, exist_ok=True)
	build.scons("accuracy")
	table = folder / "accuracy.csv"
	notes, rows = read_table(cpu or table)
	if cpu and not gpu_folder and table.exists():  # the GPU's rows stay
		old_notes, old = read_table(table)
		notes = notes[:1] + [note for note in old_notes if note.startswith("GPU")]
		rows += [row for row in old if row["precision"] == "GPU"]
	if gpu_folder:
		gpu = read_gpu(gpu_folder, is_quick)
		rows = [row for row in rows if row["precision"] == "reference" or row["precision"].startswith("CPU")]
		compare(rows, gpu)
		if gpu and all(row["precision"] == "GPU" for row in gpu):  # times from software rendering say nothing about a GPU
			notes = [note for note in notes if not note.startswith("GPU")] + [f"GPU: {device(gpu_folder)}"]
			rows += gpu
	write_table(table, notes, rows)


def solve(text, is_quick, *arguments):
	"""Returns rows of all numbers of knots; `arguments` go to the programs."""
	rows = []
	for knots in KNOTS:
		command = [str(BUILD / f"bench/accuracy_{knots}"), *map(str, arguments), *(["--quick"] if is_quick else [])]
		with progress(f"{text} with {knots} knots", every=10):
			result = subprocess.run(command, capture_output=True, text=True)
		if result.returncode:
			raise Failure(f"accuracy_{knots} ended with code {result.returncode}:\n{result.stderr}")
		rows += [dict(zip(COLUMNS, line.split(","))) for line in result.stdout.splitlines()]
	return rows


def record(folder, is_quick):
	"""Writes the problems for a GPU to `folder`."""
	folder.mkdir(parents=True, exist_ok=True)
	solve("Recording", is_quick, "--record", folder)


def read_gpu(folder, is_quick):
	"""Returns rows from the knots that a GPU wrote to `folder`, by the same problems that made the CPU's."""
	with tempfile.TemporaryDirectory() as place:
		for file in folder.glob("*.result.gz"):
			(pathlib.Path(place) / file.stem).write_bytes(gzip.decompress(file.read_bytes()))
		return solve("Reading the GPU's results", is_quick, "--play", place)


def compare(rows, gpu):
	"""Prints how far the GPU's errors are from the CPU's in float: both compute the same."""
	key = ("method", "knots", "substeps", "iterations", "error")
	floats = {tuple(row[name] for name in key): float(row["value"]) for row in rows if row["precision"] == "CPU float"}
	for error in ERRORS:
		apart = [abs(float(row["value"]) - floats.get(tuple(row[name] for name in key), 1e9)) for row in gpu if row["error"] == error]
		if apart:
			say(f"{error}: {gpu[0]['precision']} and CPU differ by {max(apart):.2g} at most")


def device(folder):
	"""Returns the name of the GPU in the scene's table."""
	with open(folder / "accuracy.csv", encoding="utf-8") as file:
		return file.readline().removeprefix("#").strip()


def processor():
	try:
		with open("/proc/cpuinfo", encoding="utf-8") as info:
			return next(line.split(":", 1)[1].strip() for line in info if line.startswith("model name"))
	except (OSError, StopIteration):
		return platform.processor() or platform.machine()


def read_table(path):
	"""Returns (notes, rows)."""
	with open(path, encoding="utf-8", newline="") as file:
		lines = file.read().splitlines()
	notes = [line.removeprefix("#").strip() for line in lines if line.startswith("#")]
	return [note for note in notes if not note.startswith("ms:")], list(csv.DictReader(line for line in lines if not line.startswith("#")))


def write_table(path, notes, rows):
	with open(path, "w", encoding="utf-8", newline="") as file:
		file.write("".join(f"# {note}\n" for note in notes))
		file.write("# ms: a frame (1/60 s) of 65,536 blades that swing; among colliders, of blades that a ball sweeps over at 5 m/s\n")
		writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
		writer.writeheader()
		writer.writerows(rows)
