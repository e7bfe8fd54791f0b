# SPDX-License-Identifier: MIT
"""docs/benchmarks/README.md: today's figures, made from the committed tables. `python3 -m tools.bench.bench_page` writes it.

The layer `docs` fails if the page is not what the tables make.
"""

import re

from tools.bench.bench_tables import FOLDER, TABLES, read
from tools.bench.paper_page import grid, number
from tools.bench.paper_rows import pick
from tools.pages import prose

PAGE = FOLDER / "README.md"
LEFT_OUT = r", (?:Godot|Intel|forward_plus|mobile)[^,;]*|; (?:bench\.tscn.*|\./grass bench.*|\d{4}-\d\d-\d\d)"  # of what a table says of its device
# An H200: instructions and operations a second (a fused product and sum are one instruction and two operations), bytes a second.
INSTRUCTIONS, OPERATIONS, BYTES = 33.45e12, 66.9e12, 4.8e12
SCENES = {"0": "free", "4": "balls"}
TITLES = {
	"free": "nothing near",
	"balls": "4 balls in each tile",
	"lid": "below a lid",
	"bodies": "bodies at rest",
	"rolling": "bodies that turn",
}


def source(*names):
	"""The line below a table: its files, and their notes about the device."""
	files = " and ".join(f"[{TABLES[name].split('/')[1]}]({TABLES[name]})" for name in names)
	return [f"{files}: {re.sub(LEFT_OUT, '', read(names[0])[0])}.", ""]


def floor(row, blades):
	"""(ms, what bounds it) of a step of `blades` that does only the necessary work."""
	bounds = {"instructions": float(row["instructions"]) / INSTRUCTIONS, "operations": float(row["operations"]) / OPERATIONS}
	bounds["bytes"] = float(row["bytes"]) / BYTES
	bound = max(bounds, key=bounds.get)
	return bounds[bound] * blades * 1e3, bound


def measured(rows, method, scene, blades):
	"""GPU time of a step in ms, with the pass that a field would use."""
	near = next((key for key, name in SCENES.items() if name == scene), scene)
	which = "simulate_free" if scene == "free" else "simulate"
	found = pick(rows, method=method, iterations=2, awake_blades=blades, colliders_a_tile=near, **{"pass": which})
	return float(found[0]["gpu_ms"]) if found else None


def simulation():
	rows, counted = read("kernel")[1], read("flops")[1]
	lines = [
		"## Simulating: GPU time of a step",
		"",
		"A step of one tick for blades of 16 knots, the simulation pass alone. The floor is the time that the card needs at least to issue "
		"the instructions, do the operations or move the bytes of the step, whichever takes longest.",
	]
	body = []
	for row in counted:
		for blades in (65536, 1048576):
			time, (least, bound) = measured(rows, row["method"], row["scene"], blades), floor(row, blades)
			body.append(
				[
					f"METHOD_{row['method']}",
					TITLES[row["scene"]],
					number(blades),
					f"{time:.3f}",
					f"{least:.3f} ({bound})",
					f"{time / least:.1f}",
				]
			)
	lines += grid(["method", "scene", "blades", "ms", "floor, ms", "times the floor"], body)
	lines += source("kernel", "flops")
	body = []
	for scene in ("lid", "bodies", "rolling"):
		with_edges = pick(rows, method="DIRECT", awake_blades=262144, colliders_a_tile=scene, **{"pass": "simulate_edges"})
		body.append([TITLES[scene], f"{measured(rows, 'DIRECT', scene, 262144):.2f}", f"{float(with_edges[0]['gpu_ms']):.2f}"])
	lines += ["262,144 blades by METHOD_DIRECT, with the pass for round shapes and the one that also tests edges:"]
	return lines + grid(["scene", "ms", "ms with edges"], body)


def drawing():
	forward, mobile = read("draw")[1], read("draw_mobile")[1]
	empty = float(pick(mobile, view="nothing")[0]["gpu_ms"])
	lines = [
		"## Drawing: GPU time of a frame",
		"",
		"1920 x 1080, from eye level (1.7 m), wind on, no MSAA. A data-centre card computes fast and draws slowly, so the ratios say more "
		f"than the times. Each time includes an empty frame, {empty:.1f} ms in Mobile.",
	]
	body = []
	for blades in (262144, 1048576, 4194304, 16777216):
		cells = []
		for rows in (forward, mobile):
			cells += [
				f"{float(pick(rows, blades=blades, view='eye', shadows=shadows, msaa=0)[0]['gpu_ms']):.1f}" for shadows in ("off", "on")
			]
		row = pick(forward, blades=blades, view="eye", shadows="off", msaa=0)[0]
		triangles = f"{int(row['drawn_triangles']) / 1e6:.2g} M"
		body.append([number(blades), number(float(row["drawn_blades"])), triangles, *cells, f"{float(row['cull_ms']):.2f}"])
	head = ["blades", "drawn", "triangles", "Forward+", "with shadows", "Mobile", "with shadows", "culling"]
	lines += grid(head, body) + source("draw", "draw_mobile")
	return lines + ["The paper's own tables and a comparison with MultiMeshes: [paper.md](paper.md).", ""]


def limits():
	rows = read("limits")[1]
	rates = {row["stage"]: float(row["tera_operations_a_second"]) for row in rows}
	lines = [
		"### What the card can shade",
		"",
		"The same sums in fragments, in vertices and in a compute shader. This card shades on a small part of the units that it computes on, "
		f"{rates['compute'] / rates['fragments']:.0f} times slower, so all times of drawing on it are times of that part.",
	]
	body = [[row["stage"], row["tera_operations_a_second"]] for row in rows]
	return lines + grid(["stage", "10^12 operations a second"], body) + source("limits")


def processor():
	rows = read("cpu")[1]
	lines = [
		"## The CPU: a tick",
		"",
		"The worst case of a tick: bodies float through the grass at 1 to 5 m/s, and the full pool of 4,096 tiles gives up slots in every "
		"tick. Nothing depends on the size of the field. The target was 0.2 ms for 128 bodies.",
	]
	body = []
	for row in rows:
		if row["tiles"] in ("19881", "16000000") and row["bodies"] in ("0", "128", "1024", "5000"):
			parts = [float(row[name]) for name in ("gather_ms", "tiles_ms", "upload_ms")]
			body.append(
				[number(float(row["tiles"])), number(float(row["bodies"])), *(f"{part:.3f}" for part in parts), f"{sum(parts):.3f}"]
			)
	lines += grid(["tiles", "bodies", "reading bodies, ms", "choosing tiles, ms", "uploading, ms", "in all, ms"], body)
	return lines + source("cpu")


def movers():
	lines = [
		"## Movers: what one of each does in a tick",
		"",
		"One mover goes to and fro at 2 m/s. Shapes are the colliders that the solver gets for it, tiles the awake ones (0.25 m2 each), calls "
		"the calls of the engine that read it.",
	]
	columns = ("colliders", "awake_tiles", "tiles_looked_at_a_tick", "engine_calls_a_tick")
	body = [[row["mover"].replace("_", " "), *(row[name] for name in columns)] for row in read("movers")[1]]
	return lines + grid(["mover", "shapes", "tiles", "tiles looked at", "calls"], body) + source("movers")


def changes():
	lines = [
		"## Changing a standing field",
		"",
		"A field of 500 x 500 m (64 million blades) that changes while it is drawn: frames until the change shows, and the longest piece of "
		"work in one of them. Times above 9 ms come from the engine's compiling of a shader, once a process.",
	]
	body = [[row["change"], row["frames"], f"{float(row['build_ms']):.1f}"] for row in read("change")[1] if row["makings"] != "0"]
	return lines + grid(["change", "frames", "longest piece, ms"], body) + source("change")


def hitches():
	cold = {row["change"]: row["over_ms"] for row in read("hitch_cold")[1]}
	lines = [
		"## The longest frame after a change",
		"",
		"The same field, drawn: by how much the longest frame after each change exceeds the median of the frames before, with a driver and "
		"an engine that have seen all shaders before, and with empty caches. A bare shader shows the engine's own time for a material with a "
		"shader that does nothing.",
	]
	body = [[row["change"], row["median_ms"], row["over_ms"], cold[row["change"]]] for row in read("hitch")[1]]
	return lines + grid(["change", "median, ms", "longest over it, ms", "with empty caches, ms"], body) + source("hitch", "hitch_cold")


def resting():
	lines = [
		"## A field at rest",
		"",
		"64 million blades, a still camera, no wind, nothing awake: the time of a frame, and the number of things that the field does in one "
		"(dispatches, uploads, updates and reads of bodies together).",
	]
	counters = [name for name in read("rest")[1][0] if name.endswith("_a_frame")]
	body = [
		[row["field"].replace("_", " "), row["wall_ms"], row["gpu_ms"], f"{sum(float(row[name]) for name in counters):g}"]
		for row in read("rest")[1]
	]
	return lines + grid(["the field", "a frame, ms", "on the GPU, ms", "done in a frame"], body) + source("rest")


def crowds():
	lines = [
		"## The CPU: a crowd",
		"",
		"The quickest of 300 ticks in which so many bodies move, or sleep, in a field with a small pool: the time to read them, and to choose "
		"tiles.",
	]
	body = [
		[number(float(row["bodies"])), row["crowd"], row["gather_ms_min"], row["tiles_ms_min"], row["engine_calls_a_tick"]]
		for row in read("crowd")[1]
	]
	return lines + grid(["bodies", "they", "reading, ms", "tiles, ms", "calls of the engine"], body) + source("crowd")


def sleeping():
	rows = read("sleep")[1]
	most = max(float(row["tile_steps"]) for row in rows)
	body = [[row["asleep"], number(float(row["tile_steps"])), f"{float(row['tile_steps']) / most:.0%}"] for row in rows]
	lines = [
		"## Sleeping",
		"",
		"The steps of tiles in one scene, by the rule that puts tiles to sleep ([the rules](../internals/solver.md#going-to-sleep)).",
	]
	return lines + grid(["asleep", "steps of tiles", "of the most"], body) + source("sleep")


def awake():
	rows = read("awake")[1]
	lines = [
		"### How many awake tiles move",
		"",
		"128 bodies thrown among 4 million blades, seconds after the throw: tiles that are awake and simulated, those of them with a blade "
		"that is farther from rest than the column says, and those with a blade that moves farther than that in a tick. "
		f"The paper's scene of this size keeps 23,000 blades awake, {23000 // 64} tiles of ours. We keep those awake that a body could touch, and "
		"those that still swing visibly, for the picture and for queries of a game.",
	]
	columns = ("off_0.000001_m", "off_0.01_m", "off_0.05_m", "moved_0.001_m", "moved_0.01_m", "moved_0.05_m")
	body = [[row["asleep"], row["seconds"], row["awake"], row["simulated"], *(row[name] for name in columns)] for row in rows]
	head = ["asleep", "s", "awake", "simulated", "1 um off", "1 cm", "5 cm", "1 mm a tick", "1 cm", "5 cm"]
	return lines + grid(head, body) + source("awake")


def detail():
	rows = read("detail")[1]
	lines = [
		"### Only the blades that cameras need",
		"",
		"The same throw seen by a player at the edge of the field: the device's time of a tick, with all blades of awake tiles simulated "
		"(`SIMULATION_WHOLE`) and with those that a camera needs (`SIMULATION_SEEN`). A row is of the seconds since the one before.",
	]
	body = []
	for whole in pick(rows, detail="whole"):
		seen = pick(rows, detail="seen", seconds=whole["seconds"])[0]
		times = [float(row["simulate_ms"]) for row in (whole, seen)]
		blades = [number(float(row["simulated_blades_a_tick"])) for row in (whole, seen)]
		body.append([f"to {whole['seconds']} s", *blades, *(f"{ms:.2f}" for ms in times), f"{times[1] / times[0]:.2f}"])
	return lines + grid(["after the throw", "blades, whole", "seen", "ms, whole", "seen", "share"], body) + source("detail")


def levels():
	rows = read("levels")[1]
	lines = [
		"### Levels of GrassQuality, for one eye and for two",
		"",
		"A field of 128 m with the defaults and shadows, from eye level: what it adds to a frame without grass, as one picture of "
		"1920 x 1080 and for both eyes of a headset.",
	]
	body = []
	for level in ("low", "medium", "high", "ultra"):
		cells = [level]
		for eyes in ("1", "2"):
			of_eyes = {row["level"]: float(row["gpu_ms"]) for row in rows if row["eyes"] == eyes}
			added = {name: of_eyes[name] - of_eyes["nothing"] for name in (level, "high")}
			cells += [f"{added[level]:.1f}", f"{added[level] / added['high']:.2f}"]
		body.append(cells)
	return lines + grid(["level", "ms, one eye", "of *high*", "ms, two eyes", "of *high*"], body) + source("levels")


def page():
	lines = [
		"# Benchmarks",
		"",
		"Today's figures, generated from the newest committed tables (`python3 -m tools.bench.bench_page`). "
		"[Measure your own machine](machines.md); [how to run all](HOWTO.md); [how the figures came about](history.md); "
		"[figures of the solver](solver.md); [accuracy against run time](accuracy.md); "
		"[beside the paper, and against MultiMeshes](paper.md).",
		"",
		*simulation(),
		*drawing(),
		*levels(),
		*limits(),
		*processor(),
		*crowds(),
		*movers(),
		*changes(),
		*hitches(),
		*resting(),
		*sleeping(),
		*awake(),
		*detail(),
	]
	return prose.page("\n".join(lines).rstrip() + "\n")


if __name__ == "__main__":
	PAGE.write_text(page())
