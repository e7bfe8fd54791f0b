# SPDX-License-Identifier: MIT
"""lab/results/paper.md: measurements beside the paper's numbers, a section for each part. lab/tools/new_set.py writes it."""

from lab.tools.paper_rows import KINDS, NAMES, ms, pick, xy
from tools.pages.tables import grid, wrapped

# Fan et al. 2015, section 6, on a Radeon HD 7970. Of table 1 our copy of the text holds four numbers a row; by their ratios and
# by "28 ms with more than 30 M triangles" they are frames a second of 2K and 4K tiles, each without and with LOD.
PAPER_TABLE1 = {64: (71, 73, 66, 67), 128: (72, 76, 56, 62), 256: (57, 72, 30, 49), 512: (31, 50, 16, 35)}


def fit(points):
	"""Least squares: (slope, constant, R^2)."""
	n = len(points)
	mean_x, mean_y = sum(x for x, _ in points) / n, sum(y for _, y in points) / n
	spread = sum((x - mean_x) ** 2 for x, _ in points)
	slope = sum((x - mean_x) * (y - mean_y) for x, y in points) / spread
	rest = sum((y - mean_y - slope * (x - mean_x)) ** 2 for x, y in points)
	total = sum((y - mean_y) ** 2 for _, y in points)
	return slope, mean_y - slope * mean_x, 1.0 - rest / total if total else 1.0


def number(value):
	return f"{value:,.0f}" if value >= 1000 else f"{value:.3g}"


def page(tables):
	"""Returns the page: a section for each part that was measured."""
	lines = ["# Beside the paper", ""]
	lines += [
		'Fan, Li, Hillesland, Sheng: "Simulation and Rendering for Millions of Grass Blades" (I3D 2015), section 6, measured a Radeon HD 7970. '
		"`./grass bench all` measures the same things here, and GrassField against the alternatives in Godot. It also writes this page.",
		"",
	]
	sections = {"table1": table1, "passes": passes, "awake": awake, "tiles": tiles, "lists": lists, "memory": memory, "rivals": rivals}
	for part, section in sections.items():
		name = f"paper_{part}"
		if not tables.has(name):
			continue
		rows, failed = tables.outcomes(name)
		if tables.parts[name].get("quick"):
			lines += ["**A sample follows: a check of the benchmark, not a measurement.**", ""]
		lines += section(rows) if rows else []
		lines += [f"Failed: {'; '.join(', '.join(filter(None, row.values())) for row in failed)}.", ""] if failed else []
		lines += tables.source(name)
	return wrapped("\n".join(lines))


def table1(rows):
	lines = [
		"## Table 1: frames a second, by tiles and blades a tile", "",
		"A tile of ours always has 64 blades (decided with the workgroup's size). A tile of 128, 256 or 512 becomes 2, 4 or 8 tiles of ours on the same "
		"0.5 m square of ground: the same number of blades on the same area, in smaller tiles. LOD: blades only as in the paper, and blades and segments, "
		"our default. From above all tiles are in view; the paper does not state its view. 4x MSAA, no shadows. GPU time of the frame, culling included.",
	]  # fmt: skip
	for view in ("above", "eye"):
		found = pick(rows, view=view)
		counts = list(dict.fromkeys(row["tiles"] for row in found))
		if not found:
			continue
		body = []
		for blades in dict.fromkeys(row["blades_a_tile"] for row in found):
			cells = []
			for count in counts:
				by_lod = {row["lod"]: row for row in pick(found, blades_a_tile=blades, tiles=count)}
				cells.append(
					" / ".join(
						f"{1000.0 / ms(by_lod[lod]):.0f}" if lod in by_lod and ms(by_lod[lod]) else "–" for lod in ("none", "blades", "all")
					)
				)
			paper = PAPER_TABLE1[int(blades)]
			body.append([blades, *cells, f"{paper[0]} / {paper[1]}", f"{paper[2]} / {paper[3]}"])
		where = "From above" if view == "above" else "From eye level"
		lines += ["", f"{where}: no LOD / LOD of blades / LOD of blades and segments; the paper: no LOD / LOD."]
		lines += grid(["blades a tile", *(f"{count} tiles" for count in counts), "paper, 2K", "paper, 4K"], body)
	return [*lines, "Our copy of the paper has four numbers a row; their ratios say that they belong to 2K and 4K tiles.", "",
		"![Frame time against blades](paper/table1.svg)", ""]  # fmt: skip


def passes(rows):
	theirs = {"simulate": "5.6", "draw grass": "5.4", "all else drawn": "0.6 (sky 0.3, terrain 0.3)"}
	text = f"{number(float(rows[0]['blades']))} blades, 128 bodies thrown 5 to 8 s ago, {number(float(rows[0]['awake_blades']))} blades awake (paper: 4 M, 128, 23 K). 4x MSAA, from eye level."
	body = [
		[row["pass"], number(float(row["gpu_ms"])), theirs.get(row["pass"], "on the CPU" if row["pass"] == "cull" else "")] for row in rows
	]
	return ["## Table 2: GPU time of a frame by pass", "", text, *grid(["pass", "ms", "paper, ms"], body)]


def awake(rows):
	lines = ["## Figure 7: simulation time", ""]
	points = xy(pick(rows, series="awake"), "awake_blades", "simulate_ms")
	if len(points) > 2:
		slope, constant, r2 = fit(points)
		lines += [
			f"Against awake blades: {constant * 1e3:.0f} us + {slope * 1e6:.3g} ns a blade, R² = {r2:.3f}. The paper's is a straight line, too.",
			"",
		]
		lines += grid(["awake blades", "ms a step"], [[number(x), f"{y:.3f}"] for x, y in points])
	points = xy(pick(rows, series="total"), "blades", "simulate_ms")
	if len(points) > 1:
		times = [y for _, y in points]
		middle = sum(times) / len(times)
		apart = max(abs(y - middle) for y in times) / middle
		held = "so it holds" if apart <= 0.05 else "so it does not hold"
		lines += [
			f"Against all blades, {number(float(pick(rows, series='total')[0]['awake_blades']))} awake: within {apart:.1%} of {middle:.3f} ms (aim: 5 %, {held}).",
			"",
		]
		lines += grid(["blades", "ms a step"], [[number(x), f"{y:.3f}"] for x, y in points])
	return [*lines, "![Simulation time](paper/figure7.svg)", ""]


def tiles(rows):
	theirs = {"64": "5.52", "256": "10.52"}
	body, means = [], {}
	for kind in ("64", "256"):
		if found := pick(rows, blades_a_tile=kind):
			means[kind] = [sum(float(row[name]) for row in found) / len(found) for name in ("awake_blades", "simulate_ms")]
			body.append([kind, number(float(found[0]["blades"])), number(means[kind][0]), f"{means[kind][1]:.3f}", theirs[kind]])
	lines = [
		"## Tiles of 64 blades against tiles of 256", "",
		"The same density, 128 thrown bodies, 5 seconds after the throw, the mean of all throws. A tile of ours always has 64 blades, so tiles of 256 are four fields on one "
		"spot, each a quarter as dense with tiles twice as wide (four times the area), which the same bodies wake together; their times are added. Tiles sleep by timer, as "
		"in the paper.",
		*grid(["blades a tile", "blades", "awake blades", "ms a step", "paper, ms"], body),
	]  # fmt: skip
	if len(means) == 2:
		ratio = [large / small for small, large in zip(means["64"], means["256"])]
		lines += [
			f"Tiles of 256 keep {ratio[0]:.2f} times as many blades awake and need {ratio[1]:.2f} times as long (paper: 1.91 times).",
			"",
		]
	return lines


def lists(rows):
	body = []
	for method in ("DIRECT", "PBD"):
		for objects in sorted({int(row["objects"]) for row in rows}):
			both = [pick(rows, method=method, objects=objects, list=kind) for kind in ("scene", "tile")]
			if all(both):
				(without,), (with_list,) = both
				times = float(without["simulate_ms"]), float(with_list["simulate_ms"])
				entries = f"{float(with_list['entries_a_tile']):.2f}"
				body.append(
					[
						f"METHOD_{method}",
						objects,
						number(float(with_list["awake_tiles"])),
						entries,
						f"{times[0]:.3f}",
						f"{times[1]:.3f}",
						f"{1 - times[1] / times[0]:.0%}",
					]
				)
	head = ["method", "objects", "awake tiles", "objects a tile", "ms without", "ms with", "saved"]
	text = (
		"The simulation pass alone: balls of 0.3 m at random in a field of 80 m; the tiles that they touch are awake and have the list of the objects that touch "
		"them, or all objects of the scene. The paper saved 40 to 60 %."
	)
	return ["## The list of objects of each tile", "", text, *grid(head, body), "![Object lists](paper/lists.svg)", ""]


def memory(rows):
	theirs, goals = {"patch": "24 MB", "pool": "384 MB"}, {"patch": "4 MB", "pool": "128 MB"}
	text = (
		"4,096 tiles of 64 blades in the pool. Patch: what the engine's textures grow by with the first field, noise and a pool of one row included. All "
		"else: as `GrassField.get_memory_usage()` counts, on the GPU and the CPU."
	)
	body = [[row["what"], f"{int(row['bytes']) / 1e6:.2f} MB", theirs.get(row["what"], ""), goals.get(row["what"], "")] for row in rows]
	return ["## Memory", "", text, *grid(["what", "ours", "paper", "at most"], body)]


def rivals(rows):
	lines = [
		"## Against MultiMeshes", "",
		"As many blades, from the same place, under the same sun; 1.7 m above the ground, or from above with all of the field in view. GPU time of the frame, ms, culling included, "
		"no MSAA. *MultiMesh*: one instance a blade, every blade with 7 or 15 segments. *MultiMesh a tile*: tiles of 8 m, switched by `visibility_range` to fewer blades of 3 "
		"segments. *In the way of GodotGrass*: our own re-creation of what that demo does, without its code: tiles of 5 m, blades of five "
		"triangles up to 40 m and then of one, a quarter of the blades from 12 m on, a hundredth from 70 m on, all in shadows, a player that "
		"presses them flat. It draws far fewer blades than a field, and its grass thins visibly. The shader of all has wind, shading and "
		"light as GrassField's; no body bends them.",
	]  # fmt: skip
	for view, shadows in ((view, shadows) for view in ("eye", "above") for shadows in ("on", "off")):
		found = pick(rows, view=view, shadows=shadows)
		if not found:
			continue
		body = []
		for blades in sorted({int(row["blades"]) for row in found}):
			times = {row["kind"]: ms(row) for row in pick(found, blades=blades)}
			share = (
				f"1 / {times['multimesh 7'] / times['field']:.1f}" if {"field", "multimesh 7"} <= times.keys() and times["field"] else "–"
			)
			body.append([number(blades), *(number(times[kind]) if kind in times else "–" for kind in KINDS), share])
		where = f"{'From eye level' if view == 'eye' else 'From above'}, shadows {shadows}:"
		lines += ["", where, *grid(["blades", *NAMES.values(), "GrassField over MultiMesh 7"], body)]
	lines += [*verdicts(rows), "![From eye level](paper/rivals_eye.svg)", "![From above](paper/rivals_above.svg)", ""]
	return lines


def verdicts(rows):
	"""Returns the targets at eye level, and whether they are met."""
	lines = []
	for shadows in ("on", "off"):
		times = {(row["kind"], round(int(row["blades"]) / 2**20)): ms(row) for row in pick(rows, view="eye", shadows=shadows)}
		for millions, share in ((1, 5), (4, 10)):
			ours, plain = times.get(("field", millions)), times.get(("multimesh 7", millions))
			if ours and plain:
				lines.append(
					f"- {millions} M blades, eye level, shadows {shadows}: 1 / {plain / ours:.1f} of the plain MultiMesh's time (aim: at most 1 / {share})."
				)
		if ours := times.get(("field", 16)):
			lines.append(f"- 16 M blades, eye level, shadows {shadows}: {ours:.1f} ms (aim: below 16 ms).")
	return [*lines, ""] if lines else []
