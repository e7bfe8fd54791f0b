# SPDX-License-Identifier: MIT
"""The plots of docs/benchmarks/paper.md as SVG, by name."""

from tools.bench.paper_rows import BLUE, GREEN, GREY, KINDS, NAMES, ORANGE, ms, pick, xy
from tools.bench.plot import Plot


def plots(tables):
	drawn = {}
	for name, part, plot in (("figure7", "awake", plot_awake), ("lists", "lists", plot_lists), ("table1", "table1", plot_table1)):
		if rows := tables.outcomes(f"paper_{part}")[0]:
			drawn[name] = plot(rows)
	for view in ("eye", "above"):
		if rows := pick(tables.outcomes("paper_rivals")[0], view=view, shadows="on"):
			drawn[f"rivals_{view}"] = plot_rivals(rows, view)
	return drawn


def plot_awake(rows):
	awake, total = xy(pick(rows, series="awake"), "awake_blades", "simulate_ms"), xy(pick(rows, series="total"), "blades", "simulate_ms")
	every = awake + total
	title, across = "Simulation step against awake and against all blades (paper: figure 7)", "blades: awake (green), in the field (orange)"
	picture = Plot(title, across, "ms", [x for x, _ in every], [y for _, y in every] + [y * 0.5 for _, y in every], log_x=True, log_y=True)
	for points, color in ((awake, GREEN), (total, ORANGE)):
		if points:
			picture.line(points, color)
		for x, y in points:
			picture.mark(x, y, color)
	picture.legend([("against awake blades", GREEN), ("against all blades, the same awake", ORANGE)])
	return picture.svg()


def plot_lists(rows):
	series = {
		(method, kind): xy(pick(rows, method=method, list=kind), "objects", "simulate_ms")
		for method in ("DIRECT", "PBD")
		for kind in ("tile", "scene")
	}
	every = [point for points in series.values() for point in points]
	title = "Simulation step with a list of objects for each tile, and without"
	picture = Plot(title, "objects in the scene", "ms", [x for x, _ in every], [y for _, y in every], log_x=True, log_y=True)
	for (method, kind), points in series.items():
		color = GREEN if method == "DIRECT" else ORANGE
		if points:
			picture.line(points, color, "" if kind == "tile" else "5 4")
		for x, y in points:
			picture.mark(x, y, color, full=kind == "tile")
	picture.legend([("METHOD_DIRECT", GREEN), ("METHOD_PBD", ORANGE)], "full: lists; hollow: every tile asks all objects")
	return picture.svg()


def plot_table1(rows):
	rows = pick(rows, view="above")
	picture = Plot(
		"Frame time from above against blades (paper: table 1)", "blades", "ms GPU", [float(row["blades"]) for row in rows], [ms(row) for row in rows],
		log_x=True, log_y=True,
	)  # fmt: skip
	colors = {"none": GREY, "blades": BLUE, "all": GREEN}
	for row in rows:
		picture.mark(float(row["blades"]), ms(row), colors[row["lod"]])
	picture.legend([("no LOD", GREY), ("fewer blades, as in the paper", BLUE), ("fewer blades and segments", GREEN)])
	return picture.svg()


def plot_rivals(rows, view):
	title = f"Frame time {'from eye level' if view == 'eye' else 'from above'}, with shadows"
	picture = Plot(title, "blades", "ms GPU", [float(row["blades"]) for row in rows], [ms(row) for row in rows], log_x=True, log_y=True)
	for kind, color in KINDS.items():
		points = sorted((float(row["blades"]), ms(row)) for row in pick(rows, kind=kind))
		if points:
			picture.line(points, color)
		for x, y in points:
			picture.mark(x, y, color)
	picture.legend([(NAMES[kind], color) for kind, color in KINDS.items() if pick(rows, kind=kind)])
	return picture.svg()
