# SPDX-License-Identifier: MIT
"""The table of lab/results/drivers.md: what Mesa's compilers make of the passes. `./grass bench drivers --out lab/results` writes it."""

import re

from lab.tools import driver_figures
from tools.pages.tables import grid, has_table, with_table
from tools.places import ROOT

PAGE = ROOT / "lab/results/drivers.md"


def cell(row):
	numbers = (f"{int(row[figure]):,}" for figure in driver_figures.FIGURES)
	return f"{' / '.join(numbers)} / {float(row['seconds']):.1f}"


def figures():
	"""Returns a table for each driver: pipelines down, cards across. Variants for species are left to the CSV."""
	notes, rows = driver_figures.read()
	lines = []
	for driver in dict.fromkeys(card.driver for card in driver_figures.CARDS.values()):
		cards = {name: card for name, card in driver_figures.CARDS.items() if card.driver == driver}
		body = []
		for key in dict.fromkeys(key[1:] for key in rows if key[0] in cards and "species" not in key[1]):
			body.append([driver_figures.label_of(*key), *(cell(rows[name, *key]) if (name, *key) in rows else "" for name in cards)])
		lines += grid(["pipeline", *(card.title for card in cards.values())], body)[:-1]
	made = dict.fromkeys(re.sub(r"^\w+(?:: | (?=\w+: ))", "", note) for note in notes)  # a card's name says nothing here
	return [*lines, "", "[drivers.csv](drivers/drivers.csv):", "", *(f"- {note}" for note in made), ""]


def page(text):
	"""Returns the page with its table made anew."""
	return with_table(text, "figures", figures())


def wrong():
	"""Returns what is wrong with the page, or ""."""
	text = PAGE.read_text()
	return "" if has_table(text, "figures") and text == page(text) else "run `python3 -m lab.tools.drivers_page`"


def write():
	PAGE.write_text(page(PAGE.read_text()))


if __name__ == "__main__":
	write()
