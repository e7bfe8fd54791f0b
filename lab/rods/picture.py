# SPDX-License-Identifier: MIT
"""The plot of rods.csv: error against the time of a processor."""

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams |= {"svg.hashsalt": "rods", "svg.fonttype": "none", "font.size": 9}

from matplotlib import pyplot  # noqa: E402

PANELS = {"sag_5": "sag under a load of 5: error, share", "way": "tip after release: RMS error, lengths"}
MARKS = {7: "o", 15: "s"}  # by elements
LEAST = 1e-5  # below it an error is drawn there


def draw(rows, path):
	figure, axes = pyplot.subplots(1, 2, figsize=(9.5, 4.2), layout="constrained")
	programs = list(dict.fromkeys(row["program"] for row in rows if row.get("us_a_frame")))
	for panel, (column, title) in zip(axes, PANELS.items()):
		for colour, program in enumerate(programs):
			for elements, mark in MARKS.items():
				of = [row for row in rows if row["program"] == program and row["elements"] == elements and row.get(column)]
				points = sorted((float(row["us_a_frame"]), max(abs(float(row[column])), LEAST)) for row in of)
				label = program if elements == 15 else None
				panel.plot(*zip(*points) if points else ((), ()), marker=mark, color=f"C{colour}", linewidth=0.7, markersize=5, label=label)
		panel.set(xscale="log", yscale="log", xlabel="processor time for 1/60 s of one rod, µs", title=title)
		panel.grid(alpha=0.3)
	axes[0].legend(title="circle: 7 elements, square: 15", title_fontsize=8, fontsize=8)
	figure.savefig(path, metadata={"Date": None, "Creator": None})
