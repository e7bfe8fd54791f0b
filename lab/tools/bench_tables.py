# SPDX-License-Identifier: MIT
"""The committed tables of the benchmarks, of which pages are made: lab/results/set.json says which table each part has, and of what.

A set is what one run of `./grass bench all` measured, of one commit. A part that it lacks keeps its earlier table, and pages say so.
The layer `lab` fails if no page names a table, and if a page shows one without its commit.
"""

import csv
import json
import re

from tools.places import ROOT

FOLDER = ROOT / "lab/results"
COMMIT = re.compile(r"\bcommits? (?:after )?([0-9a-f]{7,12})\b|^# ([0-9a-f]{7,12})\b", re.MULTILINE)
LINK = re.compile(r"\]\(((?:[^()\s]*/)?(?:\d{4}-\d\d-\d\d-[^()\s]*|paper|accuracy)/[\w.-]+\.csv)\)")


class Tables:
	def __init__(self, folder=FOLDER):
		self.folder = folder
		self.file = folder / "set.json"
		known = json.loads(self.file.read_text()) if self.file.exists() else {}
		self.commit = known.get("commit")  # of the set; None before there is one
		self.parts = known.get("parts", {})

	def save(self):
		self.file.write_text(json.dumps({"commit": self.commit, "parts": self.parts}, indent="\t", ensure_ascii=False) + "\n")

	def has(self, name):
		return name in self.parts

	def path(self, name):
		"""Relative to the folder."""
		return self.parts[name]["table"]

	def rows(self, name):
		lines = (self.folder / self.path(name)).read_text().splitlines()
		return list(csv.DictReader(line for line in lines if not line.startswith("#")))

	def outcomes(self, name):
		"""Returns (rows that were measured, rows that failed), of a table with outcomes; ([], []) without it."""
		rows = self.rows(name) if self.has(name) else []
		return [row for row in rows if row["outcome"] == "ok"], [row for row in rows if row["outcome"] != "ok"]

	def machine(self, name):
		"""Returns what was measured: the card, or the processor."""
		part = self.parts[name]
		return part["device"] or part["processor"]

	def others(self, *names):
		"""Tables that are not of the set's commit, as "NAME.csv (COMMIT)"."""
		if not self.commit:
			return []
		return [f"{name}.csv ({self.parts[name]['commit']})" for name in names if self.parts[name]["commit"] != self.commit]

	def source(self, *names):
		"""Returns the lines below a table: its files, machine and commit; and whether that is another one than the set's."""
		files = " and ".join(f"[{self.path(name).split('/')[1]}]({self.path(name)})" for name in names)
		part = self.parts[names[0]]
		driver = f", driver {part['driver']}" if part["device"] and part["driver"] else ""
		commits = " and ".join(dict.fromkeys(self.parts[name]["commit"] for name in names))
		lines = [f"{files}: {self.machine(names[0])}{driver}; commit {commits}.", ""]
		if self.others(*names):
			lines += [f"**Of another commit than the set's, {self.commit}: {', '.join(self.others(*names))}.**", ""]
		return lines


def pages_of(folder):
	return [*folder.rglob("*.md"), *((ROOT / "docs/guide").glob("*.md") if folder == FOLDER else ())]


def unnamed(folder=FOLDER):
	"""Tables and pictures that no page names, relative to the folder. They may be deleted: their commit keeps them."""
	text = "".join(path.read_text() for path in pages_of(folder))
	return [str(path.relative_to(folder)) for path in sorted(folder.glob("*/*")) if str(path.relative_to(folder)) not in text]


def commits(table):
	"""Returns the commits that a table's notes name."""
	notes = "\n".join(line for line in table.read_text().splitlines() if line.startswith("#"))
	return {first or second for first, second in COMMIT.findall(notes)}


def without_commit(pages, folder=FOLDER):
	"""Tables that a page shows without saying of which commit they are, as texts. Where a set has all, its first lines say it."""
	wrong, commit = [], Tables(folder).commit
	for page in pages:
		text = page.read_text()
		for link in dict.fromkeys(LINK.findall(text)):
			of = commits(page.parent / link)
			if of and commit not in of and not any(one in text for one in of):
				wrong.append(f"{page.name} shows {link} and does not say that it is of commit {', '.join(sorted(of))}")
	return wrong
