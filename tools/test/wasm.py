# SPDX-License-Identifier: MIT
"""Reads what a WebAssembly module asks of who loads it, and what it offers."""

from dataclasses import dataclass, field

CUSTOM, IMPORTS, EXPORTS = 0, 2, 7  # kinds of sections
FUNCTION, TABLE, MEMORY, GLOBAL, TAG = range(5)  # kinds of what is imported
SHARED = 2  # a flag of memory's limits


class Reader:
	def __init__(self, data, at=0):
		self.data, self.at = data, at

	def byte(self):
		self.at += 1
		return self.data[self.at - 1]

	def number(self):
		"""Returns an unsigned number of seven bits a byte, the lowest first."""
		value, shift = 0, 0
		while True:
			byte = self.byte()
			value |= (byte & 0x7F) << shift
			shift += 7
			if byte < 0x80:
				return value

	def text(self):
		length = self.number()
		self.at += length
		return self.data[self.at - length : self.at].decode()

	def limits(self):
		"""Returns the flags of limits, which it reads."""
		flags = self.byte()
		self.number()
		if flags & 1:
			self.number()
		return flags


@dataclass
class Module:
	size: int
	names: list = field(default_factory=list)  # of custom sections
	imports: set = field(default_factory=set)  # of functions
	exports: set = field(default_factory=set)
	has_shared_memory: bool = False


def read(path):
	"""Returns the Module of a file. Raises ValueError if it is none."""
	data = path.read_bytes()
	if data[:8] != b"\0asm\1\0\0\0":
		raise ValueError(f"{path.name} is no WebAssembly module")
	module, sections = Module(len(data)), Reader(data, 8)
	while sections.at < len(data):
		kind, length = sections.byte(), sections.number()
		part = Reader(data, sections.at)
		sections.at += length
		if kind == CUSTOM:
			module.names.append(part.text())
		elif kind == IMPORTS:
			read_imports(part, module)
		elif kind == EXPORTS:
			for _ in range(part.number()):
				module.exports.add(part.text())
				part.byte()
				part.number()
	return module


def read_imports(part, module):
	for _ in range(part.number()):
		part.text()
		name, kind = part.text(), part.byte()
		if kind == FUNCTION:
			module.imports.add(name)
			part.number()
		elif kind == TABLE:
			part.byte()
			part.limits()
		elif kind == MEMORY:
			module.has_shared_memory |= bool(part.limits() & SHARED)
		elif kind == GLOBAL:
			part.byte()
			part.byte()
		elif kind == TAG:
			part.byte()
			part.number()
