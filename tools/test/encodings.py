# SPDX-License-Identifier: MIT
"""Finds texts of the extension that would be read in the wrong encoding.

A `String` of a `const char *` is Latin-1, so "…" becomes three letters.
Texts beyond ASCII go through `String::utf8()`, those of the core and units of a Tunable through extension/shared/text.h.
"""

import re

from tools.places import ROOT

KNOW_BYTES = {"core", "binding"}
CONVERTS = ROOT / "extension/shared/text.h"
LITERAL = re.compile(r'"(?:[^"\\\n]|\\.)*"')
BEYOND_ASCII = re.compile(r"[^\x00-\x7f]|\\u|\\U|\\x[89a-fA-F]|\\[2-3][0-7]{2}")
TO_UTF8 = re.compile(r"\bString::utf8\(\s*$")
UNIT = re.compile(r'"[a-z_]+", $')  # what stands before the unit of a Tunable
LITERALS = re.compile(r'(?:"(?:[^"\\\n]|\\.)*"\s*)+$')  # before a literal: those that the compiler joins with it


def without_comments(source):
	"""Returns the source with its comments blanked out, so that lines keep their numbers."""
	kept = re.compile(r'"(?:[^"\\\n]|\\.)*"|' + r"'(?:[^'\\\n]|\\.)*'|//[^\n]*|/\*.*?\*/", re.DOTALL)
	return kept.sub(lambda found: found[0] if found[0][0] in "\"'" else re.sub(r"[^\n]", " ", found[0]), source)


def wrong_in(source, is_core):
	"""Returns numbers of lines with such texts, each with what is wrong. `is_core`: of the core, which knows no String."""
	source = without_comments(source)
	found = []
	for literal in LITERAL.finditer(source):
		before = LITERALS.sub("", source[: literal.start()])
		is_bytes = is_core and "\\x" in literal[0]  # the beginning of a file
		is_unit = UNIT.search(source[: literal.start()])
		if BEYOND_ASCII.search(literal[0]) and not TO_UTF8.search(before) and not is_bytes and not is_unit:
			found.append((literal.start(), f"{literal[0][:40]} is not ASCII and not in String::utf8()"))
	if not is_core:
		found += [(text.start(), f"{text[0]}: use text_of() or unit_of()") for text in re.finditer(r"\bc_str\(\)|\.unit\b", source)]
	return [f"{source.count(chr(10), 0, place) + 1}: {what}" for place, what in sorted(found)]


def check():
	"""Returns what is wrong in the extension's sources, as texts."""
	wrong = []
	for path in sorted((ROOT / "extension").rglob("*")):
		if path.suffix in (".h", ".hpp", ".cpp", ".inc"):
			is_core = path.relative_to(ROOT).parts[1] in KNOW_BYTES or path == CONVERTS
			wrong += [f"{path.relative_to(ROOT)}:{text}" for text in wrong_in(path.read_text(), is_core)]
	return wrong
