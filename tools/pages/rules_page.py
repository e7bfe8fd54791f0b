# SPDX-License-Identifier: MIT
"""The table of the build's rules for passes in docs/internals/drivers.md. `python3 -m tools.pages.rules_page` writes it.

The layer `docs` fails where the page differs from the rules.
"""

from tools.build import spirv_rules
from tools.pages.tables import grid, has_table, with_table
from tools.places import ROOT

PAGE = ROOT / "docs/internals/drivers.md"


def page(text):
	rows = [[rule.name, rule.allowed, rule.driver, rule.reason] for rule in spirv_rules.RULES]
	return with_table(text, "rules", grid(["what", "allowed", "driver", "why"], rows))


def wrong():
	"""Returns what is wrong with the page, or ""."""
	text = PAGE.read_text()
	return "" if has_table(text, "rules") and text == page(text) else "run `python3 -m tools.pages.rules_page`"


if __name__ == "__main__":
	PAGE.write_text(page(PAGE.read_text()))
