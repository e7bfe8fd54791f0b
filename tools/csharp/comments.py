# SPDX-License-Identifier: MIT
"""The class reference's text as C# comments. Its GDScript is left out."""

import re
from xml.sax.saxutils import escape

from tools.csharp import names

CODE = re.compile(r"\s*\[codeblock[^\]]*\].*?\[/codeblock\]\s*", re.DOTALL)
TAG = re.compile(r"\[(member|method|signal|constant|enum|param) ([\w.@]+)\]|\[([A-Z]\w+)\]|\[/?(code|b|i)\]")
MARKS = {"[code]": "<c>", "[/code]": "</c>", "[b]": "<b>", "[/b]": "</b>", "[i]": "<i>", "[/i]": "</i>"}


class Linker:
	"""Turns the names in a text into links."""

	def __init__(self, classes):
		self.classes = {made.name: made for made in classes}

	def target(self, kind, path, here):
		"""Returns what a link such as [method GrassField.cut] names in C#; "" if it is none of our classes."""
		owner, _, name = path.rpartition(".")
		made = self.classes.get(owner or here.name)
		if made is None:
			return ""
		own = "" if made is here else f"{made.name}."
		if kind == "enum":
			return f"{own}{names.enum(made, name)}" if name in made.enums else ""
		if kind == "constant":
			for enum, constants in made.enums.items():
				for value, constant in names.enum_values(constants):
					if constant.name == name:
						return f"{own}{names.enum(made, enum)}.{value}"
			return ""
		known = {"member": made.members, "method": made.methods, "signal": made.signals}[kind]
		return f"{own}{names.pascal(name)}" if name in {member.name for member in known} else ""

	def text(self, text, here):
		def one(match):
			kind, path, name, _mark = match.groups()
			if kind == "param":
				return f'<paramref name="{names.camel(path).lstrip("@")}"/>'
			if kind:
				target = self.target(kind, path, here)
				return f'<see cref="{target}"/>' if target else f"<c>{path}</c>"
			if name:
				return f'<see cref="{name}"/>' if name in self.classes else f"<c>{name}</c>"
			return MARKS[match[0]]

		return TAG.sub(one, escape(text))

	def plain(self, text):
		"""Returns a text in which the names of C# stand without links."""
		return TAG.sub(lambda match: names.pascal(match[2]) if match[2] else match[3] or "", text)

	def comment(self, text, here, tag="summary"):
		"""Returns the lines of a comment, without their indentation."""
		paragraphs = [line.strip() for line in CODE.sub("\n", text).splitlines() if line.strip()]
		if not paragraphs:
			return []
		made = [self.text(paragraph, here) for paragraph in paragraphs]
		if len(made) > 1:
			made = [f"<para>{paragraph}</para>" for paragraph in made]
		made[0] = f"<{tag}>{made[0]}"
		made[-1] = f"{made[-1]}</{tag}>"
		return [f"/// {line}" for line in made]
