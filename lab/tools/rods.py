# SPDX-License-Identifier: MIT
"""`./grass bench rods`: blades beside the rods of other programs, played by their own code, which is fetched and never kept here.

The programs run under the machine's Python with lab/rods/ and what lab/rods/requirements.txt pins; the page's table is made of rods.csv.
"""

import csv
import os
import pathlib
import subprocess
import sys

from lab.tools import commits
from lab.tools.accuracy import processor
from lab.tools.bench_tables import FOLDER
from tools.build import build
from tools.fetch import pip_packages
from tools.pages.tables import grid, with_table
from tools.places import BUILD, OUT, ROOT, TOOLS
from tools.say import Failure, say

PLACE = ROOT / "lab/rods"
FETCHED = TOOLS / "rods"
KNOTS = (8, 16)
TABLE = FOLDER / "2026-11-29-xeon/rods.csv"  # the one that the page shows
PAGE = FOLDER / "accuracy.md"
COLUMNS = {
	"us_a_frame": "µs a frame",
	"sag_1": "sag Γ = 1",
	"sag_5": "sag Γ = 5",
	"period": "period",
	"amplitude_lost": "amplitude lost",
	"way": "swing",
}
ONE_THREAD = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "NUMBA_NUM_THREADS")}


def run(out):
	"""Writes rods.csv and rods.svg to the folder `out`, and the page's table, if that is what it shows."""
	folder = pathlib.Path(out or OUT / "bench").resolve()
	folder.mkdir(parents=True, exist_ok=True)
	build.scons("rods")
	pip_packages.ensure(PLACE / "requirements.txt", FETCHED, "what blades are compared with")
	note = f"{processor()}, one core; {commits.when()}; ./grass bench rods"
	programs = [str(BUILD / f"bench/rods_{knots}") for knots in KNOTS]
	environment = {**os.environ, **ONE_THREAD, "PYTHONPATH": str(FETCHED), "PYTHONDONTWRITEBYTECODE": "1"}
	if subprocess.run([sys.executable, str(PLACE / "compare.py"), str(folder), note, *programs], env=environment).returncode:
		raise Failure("The comparison stopped; the lines above say why.")
	say(f"Written: {folder / 'rods.csv'}, {folder / 'rods.svg'}")
	if folder == TABLE.parent:
		PAGE.write_text(made(PAGE.read_text()))


def table():
	"""Returns the lines of the page's table."""
	lines = TABLE.read_text().splitlines()
	body = []
	for row in csv.DictReader(line for line in lines if not line.startswith("#")):
		cells = [row[column] and f"{float(row[column]):.2g}" for column in COLUMNS]
		body.append([row["program"], row["elements"], row["steps_a_second"], *cells])
	place = TABLE.relative_to(FOLDER).as_posix()
	head = ["program", "elements", "steps a second", *COLUMNS.values()]
	return [*grid(head, body), f"[rods.csv]({place}): {lines[0].removeprefix('# ')}.", ""]


def made(text):
	"""Returns the page's text with its table made anew."""
	return with_table(text, "rods", table())


def wrong():
	"""Returns what the page's table shows and rods.csv does not say, for the layer `lab`."""
	text = PAGE.read_text()
	return "" if text == made(text) else f"the table of rods in {PAGE.name} is not what rods.csv says: run `./grass bench rods`"
