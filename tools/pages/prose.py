# SPDX-License-Identifier: MIT
"""One width for prose: wraps the paragraphs of Markdown pages, and the comments of sources, that are wider than their width.

Tables, code, headings, equations, links and code spans stay whole; a line that one of them makes too wide is left alone.

Why our own: formatters of Markdown rewrite whole pages and know no comments of sources, which are as much of this.
"""

import re

PAGE_WIDTH = 100
SOURCE_WIDTH = 140
TAB = 4
# Text that may not be broken: code spans, links and pictures, formulas, each with the characters attached to it.
WHOLE = re.compile(r"(?:\[Eq \w+\]|`[^`\n]+`|!?\[(?:[^\[\]]|\[[^\]]*\])*\]\([^)]*\)|\$[^$\n]+\$|[^\s`$\[]+|[\[$`])+")
ITEM = re.compile(r"(\s*)([-*+]|\d+\.)(\s+)")
TEXT = re.compile(r"""(?<!")"(?!")(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'(?=[,)\]}% ])""")
STARTS_SOMETHING = re.compile(r"(?:[-*+]|\d+\.|#+|>|\||===+|---+)$|[|>]")  # a word that may not begin a line
APART = re.compile(r"\s*(?:#|\||<|\$\$|>|!\[[^\]]*\]\([^)]*\)\s*$|\[[^\]]+\]:|-{3,}\s*$|\*{3,}\s*$)")
MARKS = {".py": "#", ".gd": "#"}  # what begins a comment; elsewhere //
COMMENT = {"#": re.compile(r"(\s*)(##?)( )(\S.*)$"), "//": re.compile(r"(\s*)(///?)( )(\S.*)$")}


def filled(words, first, rest, width):
	"""The lines that `words` fill, after `first` in the first line and `rest` in the others."""
	lines, line = [], first
	for word in words:
		start = line in (first, rest)
		if not start and len(line.expandtabs(TAB)) + 1 + len(word) > width and not STARTS_SOMETHING.match(word):
			lines.append(line.rstrip())
			line, start = rest, True
		line += word if start else f" {word}"
	return [*lines, line]


def wrapped(lines, width, always):
	"""A paragraph of a page, wrapped: if a line of it is too wide, or `always`."""
	if not always and all(len(line) <= width for line in lines):
		return lines
	item = ITEM.match(lines[0])
	first = item[0] if item else re.match(r"\s*", lines[0])[0]
	rest = " " * len(first) if item else first
	text = " ".join(line.strip() for line in [lines[0][len(first) :], *lines[1:]])
	return filled(WHOLE.findall(text), first, rest, width)


def page(text, always=False):
	"""The text of a page with its paragraphs wrapped."""
	made, paragraph, fence, equation, in_code = [], [], False, False, False

	def end():
		made.extend(wrapped(paragraph, PAGE_WIDTH, always) if paragraph else [])
		paragraph.clear()

	for line in text.split("\n"):
		is_fence, is_equation = line.lstrip().startswith("```"), line.strip() == "$$"
		indented = line.startswith("    ") and not paragraph and (in_code or (not made or not made[-1].strip()) and not ITEM.match(line))
		if fence or equation or is_fence or is_equation or indented or APART.match(line) or not line.strip() or line.endswith("  "):
			end()
			made.append(line)
			fence, equation = fence ^ (is_fence and not equation), equation ^ (is_equation and not fence)
			in_code = indented or (in_code and not line.strip())
			continue
		in_code = False
		if ITEM.match(line):
			end()
		paragraph.append(line)
	end()
	return "\n".join(made)


def ends_there(line, following):
	"""Whether a line of a comment ends early on purpose: the next word would have fitted into it."""
	return len(line.expandtabs(TAB)) + 1 + len(following.split()[0]) <= SOURCE_WIDTH


def comments(text, suffix):
	"""A source in which comments on lines of their own are wrapped if one of their lines is too wide."""
	pattern, made, block = COMMENT[MARKS.get(suffix, "//")], [], []

	def end():
		wide = [match for match in block if len(match[0].expandtabs(TAB)) > SOURCE_WIDTH]
		if wide:
			start = "".join(block[0].group(1, 2, 3))
			words = [word for match in block for word in match[4].split()]
			made.extend(filled(words, start, start, SOURCE_WIDTH))
		else:
			made.extend(match[0] for match in block)
		block.clear()

	for line in text.split("\n"):
		match = pattern.match(line)
		if block and (not match or match.group(1, 2) != block[0].group(1, 2) or ends_there(block[-1][0], match[4])):
			end()
		if match:
			block.append(match)
		else:
			made.append(line)
	end()
	return "\n".join(made)


def width(line):
	"""The width of a line of a source, in columns. String literals do not count: a message is easier to find in one piece."""
	is_docstring = line.lstrip().startswith('"""')
	return len((line if is_docstring else TEXT.sub('""', line)).expandtabs(TAB))


def too_wide(path):
	"""The numbers of lines that are too wide and could be narrower: prose of a page, or any line of a source."""
	text = path.read_text()
	if path.suffix == ".md":
		before, after = text.split("\n"), set(page(text).split("\n"))
		return [number for number, line in enumerate(before, 1) if len(line) > PAGE_WIDTH and line not in after]
	return [number for number, line in enumerate(text.split("\n"), 1) if width(line) > SOURCE_WIDTH]
