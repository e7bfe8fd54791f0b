# SPDX-License-Identifier: MIT
"""`./grass bench paper`: the paper's tables and figure on this machine, and a page that sets them beside the paper's numbers.

The engine's scenes measure (godot_project/bench/paper_*.gd) and write one CSV each; this reads what there is of them, has the plots drawn
(tools/bench/paper_plots.py) and writes the page (tools/bench/paper_page.py). What was not measured is not on the page.
"""

import csv
import pathlib
import shutil

from tools.bench.accuracy import when
from tools.bench.paper_page import page
from tools.bench.paper_plots import plots
from tools.fetch import machine
from tools.places import BUILD, OUT
from tools.run import scenes
from tools.say import Failure, say

PARTS = ("memory", "lists", "awake", "tiles", "passes", "table1", "rivals")


def run(out, is_quick, only=None, gpu_results=None):
	"""Measures all parts or `only` one; or takes the tables that another machine's GPU wrote to the folder `gpu_results`."""
	if only not in (None, *PARTS):
		raise Failure(f"--only takes one of {', '.join(PARTS)}.", 2)
	top = pathlib.Path(out or OUT / "bench").resolve()
	folder = top / "paper"
	folder.mkdir(parents=True, exist_ok=True)
	if gpu_results:
		found = sorted(pathlib.Path(gpu_results).glob("paper_*.csv"))
		if not found:
			raise Failure(f"There are no paper_*.csv in {gpu_results}.", 2)
		for file in found:
			shutil.copyfile(file, folder / file.name)
			note(folder / file.name)
	else:
		measure(folder, only, is_quick or not (machine.gpu() and machine.display()))
	tables = {part: read(folder / f"paper_{part}.csv") for part in PARTS}
	for name, svg in plots(tables).items():
		(folder / f"{name}.svg").write_text(svg)
	(top / "paper.md").write_text(page(tables))
	say(f"Tables and plots: {folder}; the page: {top / 'paper.md'}")


def measure(folder, only, is_quick):
	"""One engine for each part: what ends one takes nothing from the others."""
	scenes.ready("res://bench/bench.tscn", "accuracy")
	for part in [only] if only else PARTS:
		arguments = ["--only", f"paper_{part}", "--spirv", str(BUILD / "bench"), *(["--quick", "yes"] if is_quick else [])]
		try:
			scenes.play("res://bench/bench.tscn", folder, arguments, "640x360" if is_quick else "1920x1080", "forward_plus")
		except Failure as failure:
			say(f"{part}: {failure}")
		if (file := folder / f"paper_{part}.csv").exists():
			note(file)


def note(file):
	"""Adds to a table's first line what made it."""
	lines = file.read_text().splitlines()
	if "commit" not in lines[0]:
		file.write_text("\n".join([f"{lines[0]}; {when()}", *lines[1:], ""]))


def read(path):
	"""(first line, rows that were measured, rows that failed); (None, [], []) without the file."""
	if not path.exists():
		return None, [], []
	with open(path, encoding="utf-8", newline="") as file:
		head = file.readline().removeprefix("#").strip()
		rows = list(csv.DictReader(file))
	return head, [row for row in rows if row["outcome"] == "ok"], [row for row in rows if row["outcome"] != "ok"]
