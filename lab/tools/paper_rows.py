# SPDX-License-Identifier: MIT
"""The rows of the tables of lab/results/paper.md: which ones, which of their columns, and their names."""

GREEN, ORANGE, BLUE, GREY, PURPLE = "#1b7f4b", "#c2571a", "#2a5f9e", "#777777", "#7a3e9d"
KINDS = {"field": GREEN, "rings": PURPLE, "tiles": BLUE, "multimesh 7": ORANGE, "multimesh 15": GREY}
NAMES = {
	"field": "GrassField",
	"rings": "in the way of GodotGrass",
	"tiles": "MultiMesh a tile, by distance",
	"multimesh 7": "MultiMesh, 7 segments",
	"multimesh 15": "MultiMesh, 15 segments",
}


def pick(rows, **wanted):
	return [row for row in rows if all(row[name] == str(value) for name, value in wanted.items())]


def ms(row):
	"""GPU time of a frame: drawing, and culling, which the engine's measurement of a viewport leaves out."""
	return float(row["gpu_ms"]) + float(row["cull_ms"] or 0.0)


def xy(rows, x, y):
	return sorted((float(row[x]), float(row[y])) for row in rows)
