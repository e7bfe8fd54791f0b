# SPDX-License-Identifier: MIT
"""The table of speeds in lab/results/solver.md from the part `speed`. `./grass bench all --gpu-results` writes it."""

import re

from lab.tools.paper_rows import pick
from tools.pages.tables import grid

TABLE = re.compile(r"(<!-- table speed -->\n).*?(<!-- end -->)", re.DOTALL)


def table(tables):
	rows = tables.rows("speed")
	numbers = list(dict.fromkeys(row["numbers"] for row in rows))
	body = []
	for method, scene in dict.fromkeys((row["method"], row["scene"]) for row in rows):
		cells = []
		for row in pick(rows, method=method, scene=scene):
			times = f" ({float(row['times_double']):.1f})" if row["numbers"] != "double" else ""
			cells.append(f"{float(row['million_blades_a_second']):g}{times}")
		body.append([f"METHOD_{method}, {scene}", *cells])
	return grid(["", *numbers], body) + tables.source("speed")


def made(text, tables):
	"""Returns the page's text with its table made anew; as it is where the set has none."""
	if not tables.has("speed"):
		return text
	return TABLE.sub(lambda found: found[1] + "\n".join(table(tables)) + found[2], text)


def write(tables):
	page = tables.folder / "solver.md"
	if page.exists():
		page.write_text(made(page.read_text(), tables))
