# SPDX-License-Identifier: MIT
"""The tables of docs/internals/drivers.md: the build's rules, and what Mesa's compilers make of the passes.

`python3 -m tools.bench.drivers_page` writes them.

The layer `docs` fails where the page's tables are not those.
"""

import re

from tools.bench import driver_figures
from tools.bench.paper_page import grid
from tools.build import spirv_rules
from tools.pages import prose
from tools.places import ROOT

PAGE = ROOT / "docs/internals/drivers.md"


def rules():
	"""The build's rules."""
	return grid(["what", "allowed", "driver", "why"], [[rule.name, rule.allowed, rule.driver, rule.reason] for rule in spirv_rules.RULES])


def cell(row):
	numbers = (f"{int(row[figure]):,}" for figure in driver_figures.FIGURES)
	return f"{' / '.join(numbers)} / {float(row['seconds']):.1f}"


def figures():
	"""A table for each driver: pipelines down, cards across. Variants for species are left to the CSV."""
	notes, rows = driver_figures.read()
	lines = []
	for driver in dict.fromkeys(card.driver for card in driver_figures.CARDS.values()):
		cards = {name: card for name, card in driver_figures.CARDS.items() if card.driver == driver}
		body = []
		for key in dict.fromkeys(key[1:] for key in rows if key[0] in cards and "species" not in key[1]):
			body.append([driver_figures.label_of(*key), *(cell(rows[name, *key]) if (name, *key) in rows else "" for name in cards)])
		lines += grid(["pipeline", *(card.title for card in cards.values())], body)[:-1]
	made = dict.fromkeys(re.sub(r"^\w+(?:: | (?=\w+: ))", "", note) for note in notes)  # a card's name says nothing here
	return [*lines, "", "[drivers.csv](../benchmarks/drivers/drivers.csv):", "", *(f"- {note}" for note in made), ""]


TABLES = {"rules": rules, "figures": figures}


def page(text):
	"""The page with its tables made anew."""
	for name, make in TABLES.items():
		pattern = rf"(<!-- table {name} -->\n).*?(<!-- end -->)"
		text = re.sub(pattern, lambda found: found[1] + "\n".join(make()) + found[2], text, flags=re.DOTALL)
	return prose.page(text)


def wrong():
	"""What is wrong with the page, or ""."""
	text = PAGE.read_text()
	lacking = [name for name in TABLES if f"<!-- table {name} -->" not in text]
	return f"it has no table {lacking[0]}" if lacking else "" if text == page(text) else "run `python3 -m tools.bench.drivers_page`"


def write():
	PAGE.write_text(page(PAGE.read_text()))


if __name__ == "__main__":
	write()
