# SPDX-License-Identifier: MIT
"""Takes a new set of tables: puts them into folders DATE-CARD and DATE-PROCESSOR, writes lab/results/set.json and all pages, and
removes tables that no page names. `python3 -m lab.tools.new_set` writes the pages of the present set anew."""

import re
import shutil

from lab.tools import accuracy, accuracy_page, bench_page, cost_table, paper_page, solver_page
from lab.tools.bench_tables import FOLDER, Tables, unnamed
from lab.tools.commits import DIRTY
from lab.tools.parts import BY_NAME, HERE
from lab.tools.run_parts import records
from tools.say import Failure, say

KEPT = ("commit", "quick", "date", "device", "driver", "renderer", "engine", "processor", "seconds", "command")
MAKERS = r"\b(NVIDIA|GeForce|AMD|ATI|Intel|Radeon|Apple|Processor|Graphics|\w*\(\w+\))\b|\([^)]*\)"


def slug(machine):
	"""Returns a card or a processor in a word: NVIDIA H100 80GB HBM3 is h100, Intel(R) Xeon(R) Processor xeon."""
	words = re.sub(MAKERS, " ", machine).split()
	return re.sub(r"[^a-z0-9]+", "-", (words or ["unknown"])[0].lower()).strip("-")


def kept(record):
	"""Returns what the set keeps of a record. Its command names no folder of the machine: --out OUT."""
	about = {key: record.get(key, "") for key in KEPT}
	about["command"] = re.sub(r"--(\w+) \S*/\S*", lambda found: f"--{found[1]} {found[1].upper()}", about["command"])
	return about


def gathered(card, here):
	"""Returns {part: (its folder, its record)} of both folders; what was measured here counts only for parts that are measured here."""
	found = {name: (card, record) for name, record in records(card).items() if name in BY_NAME and BY_NAME[name].where != HERE}
	return found | {name: (here, record) for name, record in records(here).items() if name in BY_NAME and BY_NAME[name].where == HERE}


def write(card, here, folder, commit, is_quick):
	"""`card`, `here`: folders with tables and records; `folder`: lab/results, or a copy. Without records of a card the set stays that of
	its commit."""
	new = gathered(card, here)
	if not new:
		raise Failure(f"There are no records of parts in {card} and {here}.", 2)
	if folder == FOLDER and (bad := sorted(name for name, (_, record) in new.items() if record["quick"] or DIRTY in record["commit"])):
		raise Failure(f"These are samples, or of sources that are not committed: {', '.join(bad)}. Such tables are for another --out.", 2)
	tables = Tables(folder)
	tables.commit = next((record["commit"] for name, (_, record) in new.items() if BY_NAME[name].where != HERE), tables.commit)
	before = {tables.path(name) for name in tables.parts if not name.startswith("accuracy")}
	date = max(record["date"] for _, record in new.values())
	for name, (place, record) in new.items():
		if name.startswith("accuracy"):
			continue  # both become one table below
		machine = record["processor"] if BY_NAME[name].where == HERE else record["device"]
		table = f"{date}-{slug(machine)}/{name}.csv"
		(folder / table).parent.mkdir(parents=True, exist_ok=True)
		shutil.copyfile(place / f"{name}.csv", folder / table)
		tables.parts[name] = {"table": table, **kept(record)}
		if BY_NAME[name].where == HERE:
			tables.parts[name] |= {"device": "", "driver": ""}
	add_accuracy(tables, new, is_quick)
	tables.save()
	write_pages(tables)
	for file in unnamed(folder):
		if file in before:
			(folder / file).unlink()
			say(f"Removed {file}: no page names it")
	if lacking := [name for name, part in BY_NAME.items() if part.pages and name not in new]:
		say(f"Not in this set, so pages show earlier tables and say so, or none: {', '.join(lacking)}")
	if others := [name for name, (_, record) in new.items() if record["commit"] != tables.commit]:
		say(f"Of another commit than the card's, {tables.commit}: {', '.join(others)}; here it is {commit}")


def add_accuracy(tables, new, is_quick):
	if not {"accuracy", "accuracy_cpu"} & new.keys():
		return
	cpu = new["accuracy_cpu"][0] / "accuracy_cpu.csv" if "accuracy_cpu" in new else None
	accuracy.write(tables.folder / "accuracy", cpu, new["accuracy"][0] if "accuracy" in new else None, is_quick)
	for name in ("accuracy", "accuracy_cpu"):
		if name in new:
			tables.parts[name] = {"table": "accuracy/accuracy.csv", **kept(new[name][1])}


def write_pages(tables):
	folder = tables.folder
	(folder / "README.md").write_text(bench_page.page(tables))
	(folder / "paper.md").write_text(paper_page.page(tables))
	for page in (accuracy_page, solver_page):
		page.write(tables)
	for page in cost_table.PAGES if folder == FOLDER else ():
		page.write_text(cost_table.made(page, tables))
	say(f"Tables and pages: {folder}")


if __name__ == "__main__":
	write_pages(Tables())
