# SPDX-License-Identifier: MIT
"""Tables of pages that are made from data."""

import re
import textwrap


WIDTH = 100  # of prose, characters


def wrapped(text):
	"""Returns a page whose prose is no wider than that of pages written by hand. Tables and headings stay as they are."""
	made = []
	for line in text.split("\n"):
		is_whole = len(line) <= WIDTH or line[0] in "|#<"
		indent = "  " if line.startswith("- ") else ""
		made += [line] if is_whole else textwrap.wrap(line, WIDTH, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)
	return "\n".join(made)


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
