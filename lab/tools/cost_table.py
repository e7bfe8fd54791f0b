# SPDX-License-Identifier: MIT
"""The short table of costs in docs/guide/performance.md. lab/tools/new_set.py writes it.

It takes its figures from the tables that lab/results/README.md shows. The layer `lab` fails where a page has other figures.
"""

import os
import re

from lab.tools.bench_sections import measured
from lab.tools.bench_tables import Tables
from lab.tools.paper_page import number
from lab.tools.paper_rows import pick
from tools.pages.tables import grid
from tools.places import ROOT

PAGES = (ROOT / "docs/guide/performance.md",)
TABLE = re.compile(r"(<!-- table costs -->\n).*?(<!-- end -->)", re.DOTALL)
AWAKE = 65536  # blades that a small crowd keeps awake
DRAWN = (1048576, 16777216)


class Costs:
	"""The rows of the table on one page. Each is (what costs, ms, the part whose table says so)."""

	def __init__(self, tables):
		self.tables = tables

	def drawing(self, part, renderer, blades):
		rows = self.tables.rows(part)
		times = [f"{float(pick(rows, blades=blades, view='eye', shadows=shadows, msaa=0)[0]['gpu_ms']):.1f}" for shadows in ("off", "on")]
		return f"drawing a field of {number(blades)} blades, {renderer}, without / with shadows", " / ".join(times), part

	def step(self):
		times = [f"{measured(self.tables.rows('kernel'), method, 'balls', AWAKE):.2f}" for method in ("DIRECT", "PBD")]
		return f"a tick in which balls bend {number(AWAKE)} blades, `METHOD_DIRECT` / `METHOD_PBD`", " / ".join(times), "kernel"

	def thrown(self):
		rows = [pick(self.tables.rows("detail"), detail=detail, seconds=3)[0] for detail in ("whole", "seen")]
		what = "a tick of 128 bodies thrown among 4 million blades, all blades of awake tiles / those that the camera needs (default)"
		return what, " / ".join(f"{float(one['simulate_ms']):.2f}" for one in rows), "detail"

	def crowd(self):
		moving = pick(self.tables.rows("crowd"), bodies=128, crowd="moving")[0]
		ms = float(moving["gather_ms_median"]) + float(moving["tiles_ms_median"])
		return "128 moving bodies and a small pool, a tick, on the processor", f"{ms:.2f}", "crowd"

	def churn(self):
		full = pick(self.tables.rows("cpu"), tiles=16000000, bodies=128)[0]
		ms = sum(float(full[name]) for name in ("gather_ms", "tiles_ms", "upload_ms"))
		return "128 moving bodies and a pool of 4,096 tiles that is always full, a tick, on the processor", f"{ms:.2f}", "cpu"

	def rest(self):
		rows = {entry["field"]: float(entry["wall_ms"]) for entry in self.tables.rows("rest")}
		added = max(0.0, rows["hidden"] - rows["nothing"])
		return "what 64 million blades at rest and out of sight add to a frame", f"{added:.1f}", "rest"

	def rows(self):
		return [
			*(self.drawing("draw", "Forward+", blades) for blades in DRAWN),
			self.drawing("draw_mobile", "Mobile", DRAWN[0]),
			self.step(),
			self.thrown(),
			self.crowd(),
			self.churn(),
			self.rest(),
		]


def machine(tables, part):
	"""In a word or two: the processor for what it does, else the card."""
	entry = tables.parts[part]
	text = entry["processor"] if part in ("crowd", "cpu") else entry["device"] or entry["processor"]
	found = re.search(r"NVIDIA (?:GeForce \w+ \w+|\w+)|AMD (?:\w+ )?\w+|Intel \w+", text.replace("(R)", ""))
	return found[0] if found else text


def table(page, tables):
	rows, body = Costs(tables).rows(), []
	for what, times, part in rows:
		target = os.path.relpath(tables.folder / tables.path(part), page.parent)
		body.append([what, times, machine(tables, part), f"[{os.path.basename(target)}]({target})"])
	lines = grid(["what", "ms", "measured on", "table"], body)
	parts = list(dict.fromkeys(part for _, _, part in rows))
	commits = list(dict.fromkeys(tables.parts[part]["commit"] for part in parts))
	others = tables.others(*parts)
	said = f"Of commit {tables.commit}" if tables.commit else f"Commits: {', '.join(commits)}"
	return [*lines, f"{said}{', but for ' if others else ''}{', '.join(others)}."]


def made(page, tables=None):
	"""Returns the page's text with its table made anew."""
	lines = table(page, tables or Tables())
	return TABLE.sub(lambda found: found[1] + "\n".join([*lines, "", ""]) + found[2], page.read_text())


def wrong():
	"""Returns what is wrong with the tables of costs, or ""."""
	lacking = [page.name for page in PAGES if not TABLE.search(page.read_text())]
	stale = [page.name for page in PAGES if page.read_text() != made(page)]
	return f"{lacking[0]} has no table of costs" if lacking else f"{stale[0]}: run `python3 -m lab.tools.new_set`" if stale else ""
