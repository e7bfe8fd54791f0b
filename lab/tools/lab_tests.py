# SPDX-License-Identifier: MIT
"""The layers `lab` and `drivers`, by name only: the laboratory's own tests. Nothing is measured."""

from lab.tools import accuracy, accuracy_page, bench_page, bench_tables, bench_tests, cost_table, driver_tests, drivers_page
from lab.tools import lab_project, paper_page, solver_page
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


def wrong_links():
	return "; ".join(f"{page.name}: {text}" for page in sorted((ROOT / "lab").rglob("*.md")) for text in links.wrong_in_page(page))


CHECKS = {
	"lab/pages": wrong_pages,
	"lab/links": wrong_links,
	"lab/costs": cost_table.wrong,
	"lab/drivers": drivers_page.wrong,
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
