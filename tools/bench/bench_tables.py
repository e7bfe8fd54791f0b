# SPDX-License-Identifier: MIT
"""The committed tables of the benchmarks, of which pages are made.

The layer `docs` fails if a newer table of a benchmark is not used, and if no page names a table.
"""

import csv
import re

from tools.places import ROOT

FOLDER = ROOT / "docs/benchmarks"
# The newest table of each benchmark.
TABLES = {
	"draw": "2026-11-23-h200/forward_draw.csv",
	"draw_mobile": "2026-11-23-h200/mobile_draw.csv",
	"kernel": "2026-11-23-h200/kernel.csv",
	"flops": "2026-11-23-h200/flops.csv",
	"sleep": "2026-11-21-h100/sleep.csv",
	"awake": "2026-11-24-h200/awake.csv",
	"cpu": "2026-11-25-h100/cpu.csv",
	"movers": "2026-11-23-xeon/movers.csv",
	"change": "2026-11-21-epyc/change.csv",
	"hitch": "2026-11-25-h100/hitch_warm.csv",
	"hitch_cold": "2026-11-25-h100/hitch_cold.csv",
	"limits": "2026-11-23-h200/limits.csv",
	"rest": "2026-11-24-h200/rest.csv",
	"crowd": "2026-11-25-epyc/crowd.csv",
	"levels": "2026-11-26-h200/levels.csv",
	"detail": "2026-11-26-h200/detail.csv",
}
FAMILIES = {"draw": "forward_draw*.csv", "draw_mobile": "mobile_draw*.csv", "hitch": "hitch_warm*.csv"}  # by file name; else NAME*.csv


def read(name):
	"""(the table's note about its device, its rows)."""
	lines = (FOLDER / TABLES[name]).read_text().splitlines()
	notes = [line[2:] for line in lines if line.startswith("#")]
	return "; ".join(notes), list(csv.DictReader(line for line in lines if not line.startswith("#")))


def newer():
	"""Tables of a benchmark that are newer than the page's one, as texts."""
	wrong = []
	for name, table in TABLES.items():
		for other in FOLDER.glob(f"*/{FAMILIES.get(name, f'{name}*.csv')}"):
			if re.match(r"\d{4}", other.parent.name) and other.parent.name[:10] > table[:10]:
				wrong.append(f"{other.relative_to(FOLDER)} is newer than {table}")
	return wrong


def unnamed():
	"""Tables and plots that no page names, as texts. They may be deleted: their commit keeps them."""
	pages = "".join(path.read_text() for path in (ROOT / "docs").rglob("*.md"))
	kept = (path.relative_to(FOLDER) for path in sorted(FOLDER.glob("*/*")))
	return [f"no page names {path}: name it, or remove it" for path in kept if str(path) not in pages]
