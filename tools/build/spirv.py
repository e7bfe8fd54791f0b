# SPDX-License-Identifier: MIT
"""Reads a compute pass's SPIR-V: its declarations and its demands on a driver. spirv_rules.py judges them."""

import struct
from dataclasses import dataclass, field, replace

# Numbers of SPIR-V's own, by its names.
OP = {
	10: "Extension", 11: "ExtInstImport", 16: "ExecutionMode", 17: "Capability", 20: "TypeBool", 21: "TypeInt", 22: "TypeFloat",
	23: "TypeVector", 24: "TypeMatrix", 25: "TypeImage", 26: "TypeSampler", 27: "TypeSampledImage", 28: "TypeArray",
	29: "TypeRuntimeArray", 30: "TypeStruct", 32: "TypePointer", 43: "Constant", 48: "SpecConstantTrue", 49: "SpecConstantFalse",
	50: "SpecConstant", 59: "Variable", 71: "Decorate", 72: "MemberDecorate",
}  # fmt: skip
CAPABILITIES = {1: "Shader", 9: "Float16", 10: "Float64", 11: "Int64", 22: "Int16", 39: "Int8", 49: "StorageImageExtendedFormats",
	50: "ImageQuery", 55: "StorageImageReadWithoutFormat", 56: "StorageImageWriteWithoutFormat", 61: "GroupNonUniform"}  # fmt: skip
BUILT_INS = {24: "NumWorkgroups", 25: "WorkgroupSize", 26: "WorkgroupId", 27: "LocalInvocationId", 28: "GlobalInvocationId",
	29: "LocalInvocationIndex", 36: "SubgroupSize", 41: "SubgroupLocalInvocationId"}  # fmt: skip
FORMATS = {0: "unknown", 1: "rgba32f", 2: "rgba16f", 3: "r32f", 4: "rgba8", 24: "r32i", 33: "r32ui"}
LOCAL_SIZE, SPECIALIZATION, BUILT_IN, NOT_WRITTEN, NOT_READ, BINDING = 17, 1, 11, 24, 25, 33  # modes and decorations
CONSTANT, UNIFORM, WORKGROUP, PUSH, STORAGE = 0, 2, 4, 9, 12  # storage classes


@dataclass
class Binding:
	"""A resource that a pass binds."""

	kind: str  # buffer, uniforms, image, texture (with a sampler), plain texture or sampler
	is_written: bool
	is_read: bool
	format: str = ""  # of an image
	count: int = 1  # of an array's elements


@dataclass
class Module:
	"""The declarations of one pass."""

	version: tuple
	capabilities: list = field(default_factory=list)
	extensions: list = field(default_factory=list)  # and sets of instructions that are not GLSL's
	built_ins: list = field(default_factory=list)
	constants: dict = field(default_factory=dict)  # specialization constants: their types, by number
	bindings: dict = field(default_factory=dict)  # Binding, by number
	group: tuple = (0, 0, 0)
	shared: int = 0  # bytes
	pushed: int = 0


def name(table, number):
	return table.get(number, str(number))


def text(words):
	return struct.pack(f"<{len(words)}I", *words).split(b"\0")[0].decode()


class Reader:
	"""Reads a module in one go: decorations and declarations come before computations."""

	def __init__(self, words):
		self.types, self.numbers, self.marks, self.member_marks = {}, {}, {}, {}
		self.module = Module(((words[1] >> 16) & 255, (words[1] >> 8) & 255))
		at = 5
		while at < len(words):
			length, operation = words[at] >> 16, OP.get(words[at] & 0xFFFF)
			if operation:
				self.take(operation, words[at + 1 : at + length])
			at += length

	def take(self, operation, words):
		module = self.module
		if operation == "Capability":
			module.capabilities.append(name(CAPABILITIES, words[0]))
		elif operation == "Extension":
			module.extensions.append(text(words))
		elif operation == "ExtInstImport" and text(words[1:]) != "GLSL.std.450":
			module.extensions.append(text(words[1:]))
		elif operation == "ExecutionMode" and words[1] == LOCAL_SIZE:
			module.group = tuple(words[2:5])
		elif operation == "Decorate":
			self.marks.setdefault(words[0], {})[words[1]] = words[2] if len(words) > 2 else True
			if words[1] == BUILT_IN:
				module.built_ins.append(name(BUILT_INS, words[2]))
		elif operation == "MemberDecorate":
			self.member_marks.setdefault(words[0], {}).setdefault(words[2], set()).add(words[1])
		elif operation.startswith("Type"):
			self.types[words[0]] = (operation, words[1:])
		elif operation == "Constant":
			self.numbers[words[1]] = words[2]
		elif operation.startswith("SpecConstant"):
			self.numbers[words[1]] = words[2] if operation == "SpecConstant" else 0
			if SPECIALIZATION in self.marks.get(words[1], {}):
				module.constants[self.marks[words[1]][SPECIALIZATION]] = self.type_name(words[0])
		elif operation == "Variable":
			self.variable(self.types[words[0]][1][1], words[1], words[2])

	def variable(self, kind, which, storage):
		marks = self.marks.get(which, {})
		if storage == WORKGROUP:
			self.module.shared += self.layout(kind)[0]
		elif storage == PUSH:
			self.module.pushed += self.layout(kind)[0]
		elif storage in (CONSTANT, UNIFORM, STORAGE) and BINDING in marks:
			self.module.bindings[marks[BINDING]] = self.binding(kind, marks, storage)

	def binding(self, kind, marks, storage):
		operation, words = self.types[kind]
		if operation == "TypeArray":
			element = self.binding(words[0], marks, storage)
			return replace(element, count=element.count * self.numbers[words[1]])
		if operation == "TypeRuntimeArray":  # asks for a capability
			return self.binding(words[0], marks, storage)
		if operation == "TypeStruct":  # a buffer is not written if it or all of its members are marked so
			only_read = NOT_WRITTEN in marks or len(self.member_marks.get(kind, {}).get(NOT_WRITTEN, ())) == len(words)
			only_written = NOT_READ in marks or len(self.member_marks.get(kind, {}).get(NOT_READ, ())) == len(words)
			return Binding("buffer" if storage == STORAGE else "uniforms", storage == STORAGE and not only_read, not only_written)
		if operation == "TypeImage" and words[5] == 2:
			return Binding("image", NOT_WRITTEN not in marks, NOT_READ not in marks, name(FORMATS, words[6]))
		return Binding({"TypeSampledImage": "texture", "TypeSampler": "sampler"}.get(operation, "plain texture"), False, True)

	def type_name(self, kind):
		operation, words = self.types[kind]
		if operation == "TypeBool":
			return "bool"
		letter = "float" if operation == "TypeFloat" else "int" if words[1] else "uint"
		return letter if words[0] == 32 else f"{letter}{words[0]}"

	def layout(self, kind):
		"""Returns (bytes, alignment) of a type by the rules of std430, by which Vulkan counts shared memory as well."""
		operation, words = self.types[kind]
		if operation == "TypeBool":
			return 4, 4
		if operation in ("TypeInt", "TypeFloat"):
			return words[0] // 8, words[0] // 8
		if operation == "TypeVector":
			size = self.layout(words[0])[0]
			return size * words[1], size * (2 if words[1] == 2 else 4)
		if operation in ("TypeMatrix", "TypeArray"):
			size, alignment = self.layout(words[0])
			return up(size, alignment) * (words[1] if operation == "TypeMatrix" else self.numbers[words[1]]), alignment
		end, widest = 0, 4
		for member in words:
			size, alignment = self.layout(member)
			end, widest = up(end, alignment) + size, max(widest, alignment)
		return up(end, widest), widest


def up(size, alignment):
	return -(-size // alignment) * alignment


def read(words):
	"""Returns the Module of a pass's words."""
	return Reader(words).module


def read_file(path):
	data = path.read_bytes()
	return read(struct.unpack(f"<{len(data) // 4}I", data))
