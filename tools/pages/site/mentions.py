# SPDX-License-Identifier: MIT
"""Links from the pages to the class reference and back: which page mentions which class and member."""

import posixpath
import re

from tools.pages.links import slug

CODE = re.compile(r"(?<![`\[])`([^`\n]+)`(?![`\]])")
NAME = re.compile(r"(?:(Grass\w+)\.|field\.)?(\w+)(?:\([^`]*\))?")
IN_BLOCK = re.compile(r"\b(Grass\w+)\b|\.(\w+)\b")
FIRST = "GrassField"  # whose member is meant where several classes have one of that name
GUIDE = "guide/"  # the folder of the user's pages; on others a plain word in code is rather a file or a C++ name


class Mentions:
	def __init__(self, reference):
		self.reference = reference  # name: classes.Class
		self.places = {}  # (class, member or None): {page title: address}

	def found(self, owner, name):
		"""Returns (class, member or None) that `owner.name` or `name` means, or None."""
		if not owner and name in self.reference:
			return name, None
		having = [other for other, made in self.reference.items() if name in made.members and owner in (None, other)]
		if not having or len(name) < 3:
			return None
		return (FIRST if FIRST in having else having[0], name) if FIRST in having or len(having) == 1 else None

	def note(self, target, title, address):
		for key in {target, (target[0], None)}:
			self.places.setdefault(key, {}).setdefault(title, address)

	def linked(self, page, text):
		"""Returns the page's text, in which names of classes and members link to them."""
		title = next(iter(re.findall(r"^# +(.+)$", text, re.MULTILINE)), page)
		is_guide = page.startswith(GUIDE)
		anchor, taken, in_fence, lines = "", {}, False, []

		def note(target):
			if target and is_guide:
				self.note(target, title, page + (f"#{anchor}" if anchor else ""))

		def link(match):
			named = NAME.fullmatch(match[1])
			target = named and self.found(named[1], named[2])
			is_plain = target and target[1] and not named[1] and not re.search(r"_|\(", match[1])
			if not target or is_plain and not is_guide:
				return match[0]
			note(target)
			address = posixpath.relpath(f"classes/{target[0]}.md", posixpath.dirname(page) or ".")
			return f"[`{match[1]}`]({address}{self.reference[target[0]].anchor(target[1])})"

		for line in text.split("\n"):
			if line.startswith("```"):
				in_fence = not in_fence
			elif in_fence:
				for owner, name in IN_BLOCK.findall(line):
					note(self.found(None, owner or name))
			elif line.startswith("#"):
				made = slug(line.lstrip("# "), taken)
				anchor = "" if line.startswith("# ") else made
			else:
				# Not inside of a link's own text.
				line = "".join(
					part if index % 2 else CODE.sub(link, part) for index, part in enumerate(re.split(r"(!?\[[^\]]*\]\([^)]*\))", line))
				)
			lines.append(line)
		return "\n".join(lines)
