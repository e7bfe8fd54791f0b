# SPDX-License-Identifier: MIT
"""The short table of costs in README.md and docs/guide/performance.md. `python3 -m tools.bench.cost_table` writes it.

It takes its figures from the tables that docs/benchmarks/README.md shows. The layer `docs` fails where a page has other figures.
"""

import os
import re

from tools.bench import bench_page, bench_tables
from tools.bench.paper_page import grid, number
from tools.bench.paper_rows import pick
from tools.pages import prose
from tools.places import ROOT

PAGES = (ROOT / "README.md", ROOT / "docs/guide/performance.md")
TABLE = re.compile(r"(<!-- table costs -->\n).*?(<!-- end -->)", re.DOTALL)
CARD, PROCESSOR = r"NVIDIA \w+", r"Intel \w+|AMD \w+"  # in a table's note about its machine
AWAKE = 65536  # blades that a small crowd keeps awake
DRAWN = (1048576, 16777216)


def row(page, what, name, *times, device=CARD):
	"""A row of the table: what costs, how much, and the table and the machine that say so."""
	target = os.path.relpath(bench_tables.FOLDER / bench_tables.TABLES[name], page.parent)
	return [what, " / ".join(times), re.search(device, bench_tables.read(name)[0])[0], f"[{os.path.basename(target)}]({target})"]


def drawing(page, name, renderer, blades):
	rows = bench_tables.read(name)[1]
	times = [f"{float(pick(rows, blades=blades, view='eye', shadows=shadows, msaa=0)[0]['gpu_ms']):.1f}" for shadows in ("off", "on")]
	return row(page, f"drawing a field of {number(blades)} blades, {renderer}, without / with shadows", name, *times)


def crowd(page):
	moving = pick(bench_tables.read("crowd")[1], bodies=128, crowd="moving")[0]
	ms = float(moving["gather_ms_median"]) + float(moving["tiles_ms_median"])
	return row(page, "128 moving bodies and a small pool, a tick, on the processor", "crowd", f"{ms:.2f}", device=PROCESSOR)


def churn(page):
	full = pick(bench_tables.read("cpu")[1], tiles=16000000, bodies=128)[0]
	ms = sum(float(full[name]) for name in ("gather_ms", "tiles_ms", "upload_ms"))
	return row(
		page,
		"128 moving bodies and a pool of 4,096 tiles that is always full, a tick, on the processor",
		"cpu",
		f"{ms:.2f}",
		device=PROCESSOR,
	)


def thrown(page):
	rows = [pick(bench_tables.read("detail")[1], detail=detail, seconds=3)[0] for detail in ("whole", "seen")]
	what = "a tick of 128 bodies thrown among 4 million blades, all blades of awake tiles / those that the camera needs (default)"
	return row(page, what, "detail", *(f"{float(one['simulate_ms']):.2f}" for one in rows))


def rest(page):
	rows = {entry["field"]: float(entry["wall_ms"]) for entry in bench_tables.read("rest")[1]}
	added = rows["hidden"] - rows["nothing"]
	return row(page, "what 64 million blades at rest and out of sight add to a frame", "rest", f"{added:.1f}")


def table(page):
	solved = bench_tables.read("kernel")[1]
	steps = [f"{bench_page.measured(solved, method, 'balls', AWAKE):.2f}" for method in ("DIRECT", "PBD")]
	body = [
		*(drawing(page, "draw", "Forward+", blades) for blades in DRAWN),
		drawing(page, "draw_mobile", "Mobile", DRAWN[0]),
		row(page, f"a tick in which balls bend {number(AWAKE)} blades, `METHOD_DIRECT` / `METHOD_PBD`", "kernel", *steps),
		thrown(page),
		crowd(page),
		churn(page),
		rest(page),
	]
	return grid(["what", "ms", "measured on", "table"], body)[:-1]


def made(page):
	"""The page's text with its table made anew."""
	return prose.page(TABLE.sub(lambda found: found[1] + "\n".join([*table(page), ""]) + found[2], page.read_text()))


def wrong():
	"""What is wrong with the tables of costs, or ""."""
	lacking = [page.name for page in PAGES if not TABLE.search(page.read_text())]
	stale = [page.name for page in PAGES if page.read_text() != made(page)]
	return f"{lacking[0]} has no table of costs" if lacking else f"{stale[0]}: run `python3 -m tools.bench.cost_table`" if stale else ""


if __name__ == "__main__":
	for one in PAGES:
		one.write_text(made(one))
