# SPDX-License-Identifier: MIT
"""Tables of pages that are made from data."""

import re


def grid(head, rows):
	"""Returns the lines of a table, between empty ones."""
	return ["", f"| {' | '.join(head)} |", "|" + "---|" * len(head), *(f"| {' | '.join(map(str, row))} |" for row in rows), ""]


def with_table(text, name, lines):
	"""Returns the text of a page with `lines` between the marks of the table `name`."""
	return re.sub(
		rf"(<!-- table {name} -->\n).*?(<!-- end -->)", lambda found: found[1] + "\n".join(lines) + found[2], text, flags=re.DOTALL
	)


def has_table(text, name):
	return f"<!-- table {name} -->" in text
