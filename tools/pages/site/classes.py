# SPDX-License-Identifier: MIT
"""The class reference as pages, from extension/doc_classes.

Why our own: each entry links to the guides that tell of it (mentions.py), and a reference to what no class has fails the build. The
engine's converter writes reStructuredText, for another site generator.
"""

import re
import textwrap
import xml.etree.ElementTree
from dataclasses import dataclass

from tools.pages.snippets import CLASSES

GODOT = "https://docs.godotengine.org/en/stable/classes/class_"
KINDS = {"members": "member", "methods": "method", "signals": "signal", "constants": "constant"}
TITLES = {"members": "Properties", "methods": "Methods", "signals": "Signals", "constants": "Constants"}
INDEX = """\
# Class reference

The same texts stand in the editor: press F1 and search for a class, or let the mouse rest on a property.

| class | what it is |
|---|---|
"""
GODOT_KINDS = {"member": "property", "method": "method", "signal": "signal", "constant": "constant"}
TAG = re.compile(
	r"\[(codeblock|gdscript)\]\n(.*?)\s*\[/\1\]|\[code\](.*?)\[/code\]|\[(/?[bi])\]"
	r"|\[url=(.*?)\](.*?)\[/url\]|\[(\w+)(?: ([\w.@]+))?\]",
	re.DOTALL,
)


@dataclass
class Class:
	node: xml.etree.ElementTree.Element
	members: dict  # name: (kind, element)

	@property
	def name(self):
		return self.node.get("name")

	def anchor(self, member):
		return f"#{self.members[member][0]}-{member}" if member else ""


def read_all():
	made = {}
	for path in sorted(CLASSES.glob("*.xml")):
		node = xml.etree.ElementTree.parse(path).getroot()
		members = {}
		for group, kind in KINDS.items():
			members |= {entry.get("name"): (kind, entry) for entry in node.iterfind(f"{group}/{kind}")}
		made[node.get("name")] = Class(node, members)
	return made


def escaped(text):
	return re.sub(r"([\\`*_|#$\[\]])", r"\\\1", text).replace("<", "&lt;")


class Writer:
	"""Writes the pages of one class."""

	def __init__(self, reference, told, made):
		self.reference, self.told, self.made = reference, told, made

	def type_link(self, name):
		if name.endswith("[]"):
			return f"[Array]({GODOT}array.html)\\[{self.type_link(name[:-2])}\\]"
		if name == "void":
			return "void"
		owner, _, inner = name.partition(".")
		if owner in self.reference:
			return f"[{name}]({owner}.md{'#' + inner.lower() if inner else ''})"
		return f"[{name}]({GODOT}{owner.lower()}.html)"

	def member_link(self, kind, name):
		owner, _, member = name.rpartition(".")
		shown = f"`{name}()`" if kind == "method" else f"`{name}`"
		made = self.reference.get(owner or self.made.name)
		if made:
			page = "" if made is self.made else f"{made.name}.md"
			if member not in made.members:
				raise ValueError(f"{self.made.name}.xml: [{kind} {name}] names nothing that {made.name} has")
			return f"[{shown}]({page}{made.anchor(member)})"
		what = "private-method" if kind == "method" and member.startswith("_") else GODOT_KINDS[kind]
		return f"[{shown}]({GODOT}{owner.lower()}.html#class-{owner.lower()}-{what}-{member.strip('_').lower().replace('_', '-')})"

	def tag(self, match):
		_, block, code, style, address, text, word, argument = match.groups()
		if block is not None:
			return f"\n```gdscript\n{textwrap.dedent(block)}\n```\n"
		if code is not None:
			return f"`{code}`"
		if style:
			return "**" if style.endswith("b") else "*"
		if address:
			return f"[{text}]({address})"
		if word == "param":
			return f"`{argument}`"
		if word == "enum":
			return self.type_link(argument if "." in argument else f"{self.made.name}.{argument}")
		return self.member_link(word, argument) if argument else self.type_link(word)

	def text(self, element):
		"""Returns a description as Markdown: each line of it is a paragraph."""
		return self.marked(textwrap.dedent((element.text or "").strip("\n")))

	def marked(self, source):
		made, end = "", 0
		for match in TAG.finditer(source):
			made += escaped(source[end : match.start()]).replace("\n", "\n\n") + self.tag(match)
			end = match.end()
		return (made + escaped(source[end:]).replace("\n", "\n\n")).strip()

	def standing(self, element):
		"""Returns a line if a name is an old one, or may still change."""
		for word in ("deprecated", "experimental"):
			if element.get(word) is not None:
				return f"**{word.capitalize()}.** {self.marked(element.get(word))}".strip()
		return ""

	def parameters(self, entry):
		values = [
			f"{parameter.get('name')}: {self.type_link(parameter.get('enum') or parameter.get('type'))}"
			+ (f" = {escaped(parameter.get('default'))}" if parameter.get("default") is not None else "")
			for parameter in entry.iterfind("param")
		]
		return f"({', '.join(values)})"

	def kind_of_value(self, kind, entry):
		if kind == "method":
			result = entry.find("return")
			return self.type_link(result.get("enum") or result.get("type"))
		return self.type_link(entry.get("enum") or entry.get("type")) if kind == "member" else ""

	def told_in(self, member):
		places = self.told.places.get((self.made.name, member), {})
		return ", ".join(f"[{title}](../{address})" for title, address in places.items())

	def entry(self, kind, entry):
		name = entry.get("name")
		level = "####" if entry.get("enum") and kind == "constant" else "###"
		head = f"{level} {escaped(name)} {{#{kind}-{name} .member}}"
		value = self.kind_of_value(kind, entry)
		if kind == "constant":
			line = f"`{name} = {entry.get('value')}`"
		elif kind == "member":
			default = entry.get("default")
			line = f"{value} **{escaped(name)}**" + (f" = `{default}`" if default is not None else "")
		else:
			line = f"{value} **{escaped(name)}**{self.parameters(entry)}".strip()
		description = entry if kind in ("member", "constant") else entry.find("description")
		told = self.told_in(name)
		return "\n\n".join(
			filter(None, (head, line, self.standing(entry), self.text(description), f"In the guides: {told}" if told else ""))
		)

	def summary(self, group, kind, entries):
		"""Returns a table of properties or methods."""
		if group not in ("members", "methods"):
			return ""
		is_member = kind == "member"
		rows = ["| type | property | default |\n|---|---|---|" if is_member else "| returns | method |\n|---|---|"]
		for entry in entries:
			row = f"| {self.kind_of_value(kind, entry)} | [{escaped(entry.get('name'))}](#{kind}-{entry.get('name')})"
			default = f"`{entry.get('default')}`" if entry.get("default") else ""
			rows.append(f"{row} | {default} |" if is_member else f"{row}{self.parameters(entry)} |")
		return "\n".join(rows)

	def constants(self, entries):
		"""Enums, each under its name, then what is in none."""
		parts = []
		for enum in dict.fromkeys(entry.get("enum") for entry in entries):
			parts.append(f"### enum {enum} {{#{enum.lower()}}}" if enum else "")
			parts += [self.entry("constant", entry) for entry in entries if entry.get("enum") == enum]
		return parts

	def page(self):
		node, parts = self.made.node, [f"# {self.made.name}"]
		told = self.told_in(None)
		parts.append(f"Inherits: {self.type_link(node.get('inherits'))}")
		parts.append(self.standing(node))
		parts += [self.text(node.find(part)) for part in ("brief_description", "description")]
		parts.append(f"In the guides: {told}" if told else "")
		for group, kind in KINDS.items():
			entries = node.findall(f"{group}/{kind}")
			if not entries:
				continue
			parts += [f"## {TITLES[group]}", self.summary(group, kind, entries)]
			parts += self.constants(entries) if kind == "constant" else [self.entry(kind, entry) for entry in entries]
		return "\n\n".join(filter(None, parts)) + "\n"


def write(reference, told, folder):
	folder.mkdir()
	rows = []
	for name, made in reference.items():
		writer = Writer(reference, told, made)
		(folder / f"{name}.md").write_text(writer.page())
		rows.append(f"| [{name}]({name}.md) | {writer.text(made.node.find('brief_description'))} |")
	(folder / "index.md").write_text(INDEX + "\n".join(rows) + "\n")
