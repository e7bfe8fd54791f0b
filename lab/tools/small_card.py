# SPDX-License-Identifier: MIT
"""What a step would take on a card with a tenth of the processors, reckoned from the blades that were simulated."""

from lab.tools.paper_page import number
from lab.tools.paper_rows import pick
from tools.pages.tables import grid

FEWER = 10  # times fewer processors than the measured card
BLADES = 262_144  # a measured step of so many keeps all processors busy


def bounds(row, ms_a_blade):
	"""(least, most) ms of a tick on the smaller card. Its threads are as long as those of the measured card, its processors fewer."""
	longest, shared = float(row["simulate_ms"]), FEWER * ms_a_blade * float(row["simulated_blades_a_tick"])
	return max(longest, shared), longest + shared


def section(tables):
	rolling = pick(
		tables.rows("kernel"), method="DIRECT", iterations=2, awake_blades=BLADES, colliders_a_tile="rolling", **{"pass": "simulate"}
	)
	ms_a_blade = float(rolling[0]["gpu_ms"]) / BLADES
	lines = [
		"### The same throw on a small card, by count",
		"",
		f"Nobody has measured a card with a tenth of the processors yet. A tick takes it at least as long as the card above, whose longest "
		f"thread decides, and at least {FEWER} times as long as all processors of that card need for as many blades among bodies that turn "
		f"({number(BLADES)} in {ms_a_blade * BLADES:.2f} ms); at most it takes the sum of both.",
	]
	body = []
	for whole in pick(tables.rows("detail"), detail="whole"):
		seen = pick(tables.rows("detail"), detail="seen", seconds=whole["seconds"])[0]
		body.append([f"to {whole['seconds']} s", *("{:.1f} to {:.1f}".format(*bounds(row, ms_a_blade)) for row in (whole, seen))])
	return lines + grid(["after the throw", "ms, whole", "seen"], body) + tables.source("detail", "kernel")
