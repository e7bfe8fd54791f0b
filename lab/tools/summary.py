# SPDX-License-Identifier: MIT
"""What a user asks first of the benchmarks: ten lines at the top of lab/results/README.md. Each figure is from a table of the set."""

from lab.tools.bench_sections import measured
from lab.tools.paper_rows import ms, pick

MILLION = 1048576


def value(rows, column, **wanted):
	found = pick(rows, **wanted)
	return float(found[0][column]) if found else None


def meadow(tables):
	rows = tables.rows("meadow")
	added = [value(rows, "gpu_ms", field="plain", shadows=on) - value(rows, "gpu_ms", field="nothing", shadows=on) for on in ("off", "on")]
	return f"A meadow of ten million blades, drawn from eye level: {added[0]:.1f} ms more a frame, {added[1]:.1f} ms with shadows."


def against(tables, kind, what):
	"""Both frames, without and with shadows; None where one was not measured."""
	rows = pick(tables.rows("paper_rivals"), view="eye", blades=MILLION, outcome="ok")
	times = [[f"{ms(row):.1f}" for on in ("off", "on") for row in pick(rows, kind=drawn, shadows=on)] for drawn in (kind, "field")]
	if any(len(both) != 2 for both in times):
		return None
	theirs, ours = (" / ".join(both) for both in times)
	return f"{what}: {theirs} ms a frame without / with shadows, ours {ours} ms (a million blades)."


def rings(tables):
	return against(tables, "rings", "Grass in the way of GodotGrass (our own re-creation: tiles, far ones sparse)")


def multimesh(tables):
	return against(tables, "multimesh 7", "Grass as one MultiMesh of blades with 7 segments")


def drawn(tables):
	parts = ("draw", "Forward+"), ("draw_mobile", "Mobile")
	off, on = (
		[value(tables.rows(part), "gpu_ms", blades=MILLION, view="eye", shadows=shadows, msaa=0) for part, _ in parts]
		for shadows in ("off", "on")
	)
	return f"A field of a million blades, the whole frame: {off[0]:.1f} ms in Forward+ and {off[1]:.1f} ms in Mobile, with shadows {on[0]:.1f} and {on[1]:.1f} ms."


def simulated(tables):
	rows = tables.rows("kernel")
	free, balls = (measured(rows, "DIRECT", scene, MILLION) for scene in ("free", "balls"))
	strains = value(rows, "gpu_ms", awake_blades=MILLION, **{"pass": "strains"})
	return (
		f"A tick that bends a million blades, on the card: {strains:.1f} ms where they swing, {free:.1f} ms where something has just let "
		f"them go, {balls:.1f} ms with four balls in each tile."
	)


def body(tables):
	if "llvmpipe" in tables.machine("movers"):
		return None
	rows = tables.rows("movers")
	parts = ("gather_ms", "tiles_ms", "upload_ms")
	tick = [sum(value(rows, part, mover=mover) for part in parts) for mover in ("none", "ball")]
	return f"A ball that goes through the grass, a tick: {value(rows, 'simulate_ms', mover='ball'):.2f} ms on the card, {tick[1] - tick[0]:.2f} ms more on the processor."


def bodies(tables):
	row = pick(tables.rows("detail"), detail="seen", seconds=3)[0]
	return f"128 bodies thrown among four million blades, a tick: {float(row['simulate_ms']):.1f} ms on the card, {float(row['management_ms']):.1f} ms on the processor."


def crowd(tables):
	row = pick(tables.rows("crowd"), bodies=128, crowd="moving")[0]
	return f"128 bodies that move, on the processor alone, a tick: {float(row['gather_ms_median']) + float(row['tiles_ms_median']):.2f} ms."


def memory(tables):
	found = {row["what"]: int(row["bytes"]) / 1e6 for row in tables.rows("paper_memory")}
	fields = {int(what.split()[-2]): size for what, size in found.items() if what.startswith("all of a field of")}
	(fewer, small), (more, large) = sorted(fields.items())
	rest = (large - small) / (more - fewer) * 1e6
	return f"Memory of a field: {rest:.1f} MB for each million blades at rest, and {found['pool']:.0f} MB for those that bodies move."


def hidden(tables):
	rows = tables.rows("rest")
	behind, hid = (
		max(0.0, value(rows, "wall_ms", field=field) - value(rows, "wall_ms", field="nothing")) for field in ("behind", "hidden")
	)
	return f"64 million blades at rest behind the camera add {behind:.2f} ms to a frame, hidden ones {hid:.2f} ms."


# Each with the part that it is of.
LINES = (
	(meadow, "meadow"),
	(rings, "paper_rivals"),
	(multimesh, "paper_rivals"),
	(drawn, "draw"),
	(simulated, "kernel"),
	(body, "movers"),
	(bodies, "detail"),
	(crowd, "crowd"),
	(memory, "paper_memory"),
	(hidden, "rest"),
)


def lines(tables):
	"""Returns the lines; one whose table is only a sample, or lacks the rows, is left out."""
	found = []
	for line, part in LINES:
		if not tables.has(part) or tables.parts[part].get("quick"):
			continue
		if text := line(tables):
			of = f", {tables.parts[part]['commit']}" if tables.others(part) or not tables.commit else ""
			found.append(f"- {text} ([{tables.machine(part)}{of}]({tables.path(part)}))")
	return [*found, ""] if found else []
