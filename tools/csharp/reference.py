# SPDX-License-Identifier: MIT
"""Reads the class reference, extension/doc_classes: what each class offers to scripts. The layer `csharp` compares it with the engine."""

import textwrap
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field

from tools.places import ROOT

FOLDER = ROOT / "extension/doc_classes"


@dataclass
class Value:
	"""A parameter, a result or a property."""

	name: str
	type: str  # by Godot's name, such as Vector2i[]
	enum: str = ""  # such as GrassField.SleepMode
	default: str | None = None  # as Godot writes it
	text: str = ""
	read_only: bool = False
	deprecated: str = ""  # what to use instead


@dataclass
class Method:
	name: str
	result: Value
	params: list
	text: str
	is_static: bool = False
	deprecated: str = ""


@dataclass
class Signal:
	name: str
	params: list
	text: str


@dataclass
class Constant:
	name: str
	value: int
	enum: str
	text: str


@dataclass
class Class:
	name: str
	inherits: str
	brief: str
	text: str
	methods: list = field(default_factory=list)
	members: list = field(default_factory=list)
	signals: list = field(default_factory=list)
	constants: list = field(default_factory=list)

	@property
	def enums(self):
		"""Enum -> its constants."""
		found = {}
		for constant in self.constants:
			found.setdefault(constant.enum, []).append(constant)
		return {name: constants for name, constants in found.items() if name}


def text_of(element):
	return textwrap.dedent(element.text or "").strip() if element is not None else ""


def value(element):
	attributes = element.attrib
	return Value(
		attributes.get("name", ""),
		attributes["type"],
		attributes.get("enum", ""),
		attributes.get("default"),
		text_of(element),
		attributes.get("setter") == "",
		attributes.get("deprecated", ""),
	)


def params(element):
	return [value(param) for param in sorted(element.findall("param"), key=lambda param: int(param.get("index")))]


def read(path):
	top = xml.parse(path).getroot()
	made = Class(top.get("name"), top.get("inherits"), text_of(top.find("brief_description")), text_of(top.find("description")))
	for element in top.iterfind("methods/method"):
		static = "static" in element.get("qualifiers", "").split()
		text = text_of(element.find("description"))
		made.methods.append(
			Method(element.get("name"), value(element.find("return")), params(element), text, static, element.get("deprecated", ""))
		)
	for element in top.iterfind("signals/signal"):
		made.signals.append(Signal(element.get("name"), params(element), text_of(element.find("description"))))
	for element in top.iterfind("constants/constant"):
		made.constants.append(Constant(element.get("name"), int(element.get("value")), element.get("enum", ""), text_of(element)))
	made.members = [value(element) for element in top.iterfind("members/member")]
	return made


def classes():
	return [read(path) for path in sorted(FOLDER.glob("*.xml"))]
