# SPDX-License-Identifier: MIT
"""The sections of lab/results/README.md, each made of tables of parts. SECTIONS lists them in order."""

from lab.tools import small_card
from lab.tools.paper_page import number
from lab.tools.paper_rows import pick
from tools.pages.tables import grid

# Instructions, operations (a fused product and sum are one instruction and two operations) and bytes a second, by card.
PEAKS = {"H100": (33.45e12, 66.9e12, 3.35e12), "H200": (33.45e12, 66.9e12, 4.8e12)}
SCENES = {"0": "free", "4": "balls"}
TITLES = {
	"free": "nothing near any more",
	"strains": "nothing near for some time: by strains",
	"balls": "4 balls in each tile",
	"lid": "below a lid",
	"bodies": "bodies at rest",
	"rolling": "bodies that turn",
}


def floor(row, blades, peaks):
	"""Returns (ms, what bounds it) of a step of `blades` that does only the necessary work."""
	bounds = {name: float(row[name]) / peak for name, peak in zip(("instructions", "operations", "bytes"), peaks)}
	bound = max(bounds, key=bounds.get)
	return bounds[bound] * blades * 1e3, bound


def measured(rows, method, scene, blades):
	"""GPU time of a step in ms, with the pass that a field would use."""
	near = next((key for key, name in SCENES.items() if name == scene), scene)
	which = "simulate_free" if scene == "free" else "simulate"
	found = pick(rows, method=method, iterations=2, awake_blades=blades, colliders_a_tile=near, **{"pass": which})
	return float(found[0]["gpu_ms"]) if found else None


def simulation(tables):
	rows, counted = tables.rows("kernel"), tables.rows("flops")
	peaks = next((peaks for card, peaks in PEAKS.items() if card in tables.machine("kernel")), None)
	lines = [
		"## Simulating: GPU time of a step",
		"",
		"A step of one tick for blades of 16 knots, the simulation pass alone. The floor is the time that the card needs at least to issue "
		"the instructions, do the operations or move the bytes of the step, whichever takes longest.",
	]
	body = []
	for row in counted:
		for blades in (65536, 1048576):
			time = measured(rows, row["method"], row["scene"], blades)
			if time is None:
				continue
			least, bound = floor(row, blades, peaks) if peaks else (None, "")
			floors = [f"{least:.3f} ({bound})", f"{time / least:.1f}"] if peaks else ["–", "–"]
			body.append([f"METHOD_{row['method']}", TITLES[row["scene"]], number(blades), f"{time:.3f}", *floors])
	for row in reversed(pick(rows, **{"pass": "strains"})):
		body.append(
			[f"METHOD_{row['method']}", TITLES["strains"], number(int(row["awake_blades"])), f"{float(row['gpu_ms']):.3f}", "–", "–"]
		)
	lines += grid(["method", "scene", "blades", "ms", "floor, ms", "times the floor"], body)
	lines += tables.source("kernel", "flops")
	body = []
	for scene in ("lid", "bodies", "rolling"):
		with_edges = pick(rows, method="DIRECT", awake_blades=262144, colliders_a_tile=scene, **{"pass": "simulate_edges"})
		body.append([TITLES[scene], f"{measured(rows, 'DIRECT', scene, 262144):.2f}", f"{float(with_edges[0]['gpu_ms']):.2f}"])
	lines += ["262,144 blades by METHOD_DIRECT, with the pass for round shapes and the one that also tests edges:"]
	return lines + grid(["scene", "ms", "ms with edges"], body)


def drawing(tables):
	forward, mobile = tables.rows("draw"), tables.rows("draw_mobile")
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
	lines += grid(head, body) + tables.source("draw", "draw_mobile")
	return lines + ["The paper's own tables and a comparison with MultiMeshes: [paper.md](paper.md).", ""]


def limits(tables):
	rows = tables.rows("limits")
	rates = {row["stage"]: float(row["tera_operations_a_second"]) for row in rows}
	lines = [
		"### What the card can shade",
		"",
		"The same sums in fragments, in vertices and in a compute shader. This card shades on a small part of the units that it computes on, "
		f"{rates['compute'] / rates['fragments']:.0f} times slower, so all times of drawing on it are times of that part.",
	]
	body = [[row["stage"], row["tera_operations_a_second"]] for row in rows]
	return lines + grid(["stage", "10^12 operations a second"], body) + tables.source("limits")


def processor(tables):
	rows = tables.rows("cpu")
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
	return lines + tables.source("cpu")


def movers(tables):
	lines = [
		"## Movers: what one of each does in a tick",
		"",
		"One mover goes to and fro at 2 m/s. Shapes are the colliders that the solver gets for it, tiles the awake ones (0.25 m2 each), calls "
		"the calls of the engine that read it.",
	]
	columns = ("colliders", "awake_tiles", "tiles_looked_at_a_tick", "engine_calls_a_tick")
	body = [[row["mover"].replace("_", " "), *(row[name] for name in columns)] for row in tables.rows("movers")]
	return lines + grid(["mover", "shapes", "tiles", "tiles looked at", "calls"], body) + tables.source("movers")


def changes(tables):
	lines = [
		"## Changing a standing field",
		"",
		"A field of 500 x 500 m (64 million blades) that changes while it is drawn: frames until the change shows, and the longest piece of "
		"work in one of them. Times above 9 ms come from the engine's compiling of a shader, once a process.",
	]
	body = [[row["change"], row["frames"], f"{float(row['build_ms']):.1f}"] for row in tables.rows("change") if row["makings"] != "0"]
	return lines + grid(["change", "frames", "longest piece, ms"], body) + tables.source("change")


def hitches(tables):
	cold = {row["change"]: row["over_ms"] for row in tables.rows("hitch_cold")}
	lines = [
		"## The longest frame after a change",
		"",
		"The same field, drawn: by how much the longest frame after each change exceeds the median of the frames before, with a driver and "
		"an engine that have seen all shaders before, and with empty caches. A bare shader shows the engine's own time for a material with a "
		"shader that does nothing.",
	]
	body = [[row["change"], row["median_ms"], row["over_ms"], cold[row["change"]]] for row in tables.rows("hitch_warm")]
	return (
		lines
		+ grid(["change", "median, ms", "longest over it, ms", "with empty caches, ms"], body)
		+ tables.source("hitch_warm", "hitch_cold")
	)


def resting(tables):
	lines = [
		"## A field at rest",
		"",
		"64 million blades, a still camera, no wind, nothing awake: the time of a frame, and the number of things that the field does in one "
		"(dispatches, uploads, updates and reads of bodies together).",
	]
	counters = [name for name in tables.rows("rest")[0] if name.endswith("_a_frame")]
	body = [
		[row["field"].replace("_", " "), row["wall_ms"], row["gpu_ms"], f"{sum(float(row[name]) for name in counters):g}"]
		for row in tables.rows("rest")
	]
	return lines + grid(["the field", "a frame, ms", "on the GPU, ms", "done in a frame"], body) + tables.source("rest")


def crowds(tables):
	lines = [
		"## The CPU: a crowd",
		"",
		"The quickest of 300 ticks in which so many bodies move, or sleep, in a field with a small pool: the time to read them, and to choose "
		"tiles.",
	]
	body = [
		[number(float(row["bodies"])), row["crowd"], row["gather_ms_min"], row["tiles_ms_min"], row["engine_calls_a_tick"]]
		for row in tables.rows("crowd")
	]
	return lines + grid(["bodies", "they", "reading, ms", "tiles, ms", "calls of the engine"], body) + tables.source("crowd")


def sleeping(tables):
	rows = tables.rows("sleep")
	most = max(float(row["tile_steps"]) for row in rows)
	body = [[row["asleep"], number(float(row["tile_steps"])), f"{float(row['tile_steps']) / most:.0%}"] for row in rows]
	lines = [
		"## Sleeping",
		"",
		"The steps of tiles in one scene, by the rule that puts tiles to sleep ([the rules](../../docs/internals/solver.md#going-to-sleep)).",
	]
	return lines + grid(["asleep", "steps of tiles", "of the most"], body) + tables.source("sleep")


def awake(tables):
	rows = tables.rows("awake")
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
	return lines + grid(head, body) + tables.source("awake")


def detail(tables):
	rows = tables.rows("detail")
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
	return lines + grid(["after the throw", "blades, whole", "seen", "ms, whole", "seen", "share"], body) + tables.source("detail")


def levels(tables):
	rows = tables.rows("levels")
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
	return lines + grid(["level", "ms, one eye", "of *high*", "ms, two eyes", "of *high*"], body) + tables.source("levels")


def meadow(tables):
	rows = tables.rows("meadow")
	lines = [
		"### A meadow of ten million blades",
		"",
		"400 x 400 m with 64 blades a square metre, 1920 x 1080, 2x MSAA, from eye level: one species, and four of them with a painted map.",
	]
	body = [[row["field"], row["shadows"], *(f"{float(row[name]):.2f}" for name in ("gpu_ms", "least_ms", "most_ms"))] for row in rows]
	return lines + grid(["the field", "shadows", "a frame, ms", "least", "most"], body) + tables.source("meadow")


def backend(tables):
	lines = [
		"### The CPU backend: a tick",
		"",
		"Where there are no compute shaders (Compatibility, an engine without a window), the processor bends the blades: a lid moves in the "
		"tips of so many, METHOD_DIRECT.",
	]
	body = [[number(float(row["awake_blades"])), f"{float(row['simulate_ms']):.2f}"] for row in tables.rows("simulate")]
	return lines + grid(["awake blades", "ms a tick"], body) + tables.source("simulate")


# Each with the parts that it shows.
SECTIONS = (
	(simulation, ("kernel", "flops")),
	(drawing, ("draw", "draw_mobile")),
	(meadow, ("meadow",)),
	(levels, ("levels",)),
	(limits, ("limits",)),
	(processor, ("cpu",)),
	(crowds, ("crowd",)),
	(backend, ("simulate",)),
	(movers, ("movers",)),
	(changes, ("change",)),
	(hitches, ("hitch_warm", "hitch_cold")),
	(resting, ("rest",)),
	(sleeping, ("sleep",)),
	(awake, ("awake",)),
	(detail, ("detail",)),
	(small_card.section, ("detail", "kernel")),
)
