# SPDX-License-Identifier: MIT
"""lab/results/README.md: what a user asks first, then all figures, made from the committed tables.

lab/tools/new_set.py writes it. The layer `lab` fails if the page is not what the tables make.
"""

from lab.tools import summary
from lab.tools.bench_sections import SECTIONS
from tools.pages.tables import wrapped


def measured(tables):
	"""Returns what the page says first about its tables."""
	if not tables.commit:
		return "The tables were measured one by one: below each stands its commit."
	one = f"All tables are of one run of `./grass bench all`, of commit {tables.commit}"
	return f"{one}, but for those below which another one stands." if tables.others(*tables.parts) else f"{one}."


def page(tables):
	lines = [
		"# Benchmarks",
		"",
		*summary.lines(tables),
		measured(tables)
		+ " [Measure your own machine](../../docs/guide/machines.md); [how to run all](HOWTO.md); [how the figures came about](../../docs/history/benchmarks.md); "
		"[figures of the solver](solver.md); [accuracy against run time](accuracy.md); "
		"[beside the paper, and against MultiMeshes](paper.md).",
		"",
	]
	for section, parts in SECTIONS:
		if all(tables.has(part) and not tables.parts[part].get("quick") for part in parts):
			lines += section(tables)
	return wrapped("\n".join(lines).rstrip() + "\n")
