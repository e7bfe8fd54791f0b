# SPDX-License-Identifier: MIT
"""The layers `lab` and `drivers`, by name only: the laboratory's own tests. Nothing is measured."""

from lab.tools import accuracy, accuracy_page, bench_page, bench_tables, bench_tests, cost_table, driver_tests, drivers_page
from lab.tools import lab_project, paper_page, rods, solver_page
from lab.tools.paper_rows import ms, pick
from tools.pages import links
from tools.places import ROOT
from tools.run import engine
from tools.test.test_runs import Tally, in_engine, noted


def wrong_pages():
	"""Pages of figures that differ from the set's tables, tables that no page names, and tables that a page shows without their commit."""
	tables = bench_tables.Tables()
	pages = {name: (bench_tables.FOLDER / name).read_text() for name in ("README.md", "paper.md", "accuracy.md", "solver.md")}
	accurate = accuracy.read_table(bench_tables.FOLDER / "accuracy/accuracy.csv")
	made = {
		"README.md": bench_page.page(tables),
		"paper.md": paper_page.page(tables),
		"accuracy.md": accuracy_page.made(pages["accuracy.md"], *accurate),
		"solver.md": solver_page.made(pages["solver.md"], tables),
	}
	stale = [f"{name} is not what its tables make: run `python3 -m lab.tools.new_set`" for name in made if pages[name] != made[name]]
	unnamed = [f"no page names {path}: name it, or remove it" for path in bench_tables.unnamed()]
	shown = [*bench_tables.FOLDER.glob("*.md"), ROOT / "README.md", *(ROOT / "docs/guide").glob("*.md")]
	return "; ".join([*stale, *unnamed, *bench_tables.without_commit(shown)])


def wrong_readme():
	"""Returns figures that README.md should name, by the tables of the set, and does not."""
	tables = bench_tables.Tables()
	rivals = pick(tables.rows("paper_rivals"), outcome="ok")

	def frame(kind, blades, view, *shadows):
		rows = [pick(rivals, kind=kind, blades=blades, view=view, shadows=one)[0] for one in shadows]
		return " / ".join(f"{ms(row):.1f}" for row in rows)

	both, million = ("off", "on"), 1048576
	thrown = pick(tables.rows("detail"), detail="seen", seconds=3)[0]
	rest = {row["field"]: float(row["wall_ms"]) for row in tables.rows("rest")}
	told = " ".join((ROOT / "README.md").read_text().split())
	named = [
		f"{frame('field', million, 'eye', *both)} ms | {frame('multimesh 7', million, 'eye', *both)} ms as one MultiMesh",
		f"{float(thrown['simulate_ms']):.1f} ms on the GPU, {float(thrown['management_ms']):.1f} ms on the processor",
		f"added to a frame | {max(0.0, rest['hidden'] - rest['nothing']):.1f} ms",
		f"{frame('rings', 262144, 'eye', 'off')} against {frame('field', 262144, 'eye', 'off')} ms for 262,144 blades",
		f"{frame('rings', million, 'above', *both)} against {frame('field', million, 'above', *both)} ms for a million",
		f"take {frame('rings', million, 'eye', *both)} ms its way",
		f"Of commit {tables.commit}",
	]
	return "; ".join(f"it lacks {text!r}" for text in named if text not in told)


def wrong_links():
	return "; ".join(f"{page.name}: {text}" for page in sorted((ROOT / "lab").rglob("*.md")) for text in links.wrong_in_page(page))


CHECKS = {
	"lab/pages": wrong_pages,
	"lab/links": wrong_links,
	"lab/costs": cost_table.wrong,
	"lab/README": wrong_readme,
	"lab/drivers": drivers_page.wrong,
	"lab/rods": rods.wrong,
	**bench_tests.TESTS,
}


def run(only):
	"""Pages and tools, the scenes without a GPU, and what compilers of drivers make of the passes, for one card."""
	tally = Tally()
	for name, wrong in CHECKS.items():
		if only in name:
			noted(tally, name, wrong())
	lab_project.make()
	tally.add(in_engine("lab", *engine.headless(), only, project=lab_project.PLACE))
	tally.add(driver_tests.run_quick(only))
	return tally


def run_drivers(only):
	return driver_tests.run(only)
