# SPDX-License-Identifier: MIT
"""The dump of a single-precision engine as the same engine would write it if it were built with `precision=double`.

An engine finds a method by a hash of its types and of its initial values. If one of these values is made of real_t, or a list is
(PackedFloat32Array becomes PackedFloat64Array), a double-precision engine has another hash, so it is computed here as the engine does.
The hash that the dump has must come out in the same way; a method for which it does not is left out.
"""

import itertools
import re
import struct

OF_REALS = {"Vector2", "Vector3", "Vector4", "Rect2", "AABB", "Plane", "Quaternion", "Transform2D", "Basis", "Transform3D", "Projection"}
OF_INTEGERS = {"Vector2i", "Vector3i", "Vector4i", "Rect2i"}
# Methods of the classes in classes.json whose list of numbers is one of real_t. The dump does not tell.
LISTS_OF_REALS = {
	("Curve3D", "get_baked_tilts"),
	("HeightMapShape3D", "get_map_data"),
	("HeightMapShape3D", "set_map_data"),
	("PhysicsDirectSpaceState3D", "cast_motion"),
}
SEED, WORD, LONG = 0x7F07C65, 0xFFFFFFFF, 0xFFFFFFFFFFFFFFFF


class Unknown(Exception):
	"""An initial value that is not understood."""


def mix(value, seed=SEED):
	"""One step of MurmurHash3 over 32 bits."""
	value = value * 0xCC9E2D51 & WORD
	value = (value << 15 | value >> 17) & WORD
	seed ^= value * 0x1B873593 & WORD
	seed = (seed << 13 | seed >> 19) & WORD
	return (seed * 5 + 0xE6546B64) & WORD


def mix_float(value, seed=SEED):
	return mix(struct.unpack("<I", struct.pack("<f", value))[0], seed)


def mix_double(value, seed=SEED):
	low, high = struct.unpack("<II", struct.pack("<d", value))
	return mix(high, mix(low, seed))


def finish(value):
	value = (value ^ value >> 16) * 0x85EBCA6B & WORD
	value = (value ^ value >> 13) * 0xC2B2AE35 & WORD
	return value ^ value >> 16


def hash_integer(value):
	value = ((value << 18) + ~value) & LONG
	value = (value ^ value >> 31) * 21 & LONG
	value ^= value >> 11
	value = value + (value << 6) & LONG
	return (value ^ value >> 22) & WORD


def hash_text(text):
	value = 5381
	for letter in text:
		value = value * 33 + ord(letter) & WORD
	return value


def hash_numbers(kind, numbers, is_double):
	"""Of a value such as Vector3(0, 1, 0)."""
	if kind not in OF_REALS | OF_INTEGERS | {"Color"}:
		raise Unknown
	mixed, seed = mix_double if is_double and kind in OF_REALS else mix_float, SEED
	for number in numbers:
		seed = mix(int(number) & WORD, seed) if kind in OF_INTEGERS else mixed(float(number), seed)
	return finish(seed)


def hash_value(kind, text, nulls, is_double):
	"""Of an initial value. The next of `nulls` is that of an object that is none."""
	if text == "null":
		return next(nulls)
	if text in ("true", "false"):
		return int(text == "true")
	if quoted := re.fullmatch(r'&?"(.*)"', text):
		return hash_text(quoted[1])
	if text == "RID()":
		return hash_integer(0)
	if numbers := re.fullmatch(r"(\w+)\(([-\d., e+]+)\)", text):
		return hash_numbers(numbers[1], numbers[2].split(","), is_double)
	if not re.fullmatch(r"-?[\d.]+(e[-+]?\d+)?", text):
		raise Unknown
	return mix_double(float(text)) if kind == "float" else hash_integer(int(text))


class Double:
	"""Turns the dump into a double-precision engine's."""

	def __init__(self, dump):
		self.dump = dump
		self.classes = {entry["name"] for entry in dump["classes"]}
		types = next(enum for enum in dump["global_enums"] if enum["name"] == "Variant.Type")["values"]
		self.types = {value["name"].removeprefix("TYPE_").replace("_", ""): value["value"] for value in types}

	def hash_type(self, text, seed):
		if text.startswith(("enum::", "bitfield::")):
			return mix(hash_text(text.split("::")[1]), mix(self.types["INT"], seed))
		if text in self.classes or "," in text:
			return mix(hash_text(text), mix(self.types["OBJECT"], seed))
		name = {"typedarray": "ARRAY", "typeddictionary": "DICTIONARY", "Variant": "NIL"}.get(text.split("::")[0], text.upper())
		if name not in self.types:
			raise Unknown
		return mix(self.types[name], seed)

	def hash_method(self, method, nulls, is_double):
		arguments = method.get("arguments", [])
		results = [method["return_value"]] if "return_value" in method else []
		initial = [argument for argument in arguments if "default_value" in argument]
		seed = mix(len(arguments), mix(len(results)))
		for value in results + arguments:
			seed = self.hash_type(value["type"], seed)
		seed, null = mix(len(initial), seed), iter(nulls)
		for value in initial:
			seed = mix(hash_value(value["type"], value["default_value"], null, is_double), seed)
		return finish(mix(int(method["is_vararg"]), mix(int(method["is_const"]), seed)))

	def convert(self, owner, method):
		"""Changes a method in place. Returns whether it can be called."""
		values = [*method.get("arguments", []), *([method["return_value"]] if "return_value" in method else [])]
		has_list = (owner, method["name"]) in LISTS_OF_REALS
		is_other = has_list or any(value.get("default_value", "").split("(")[0] in OF_REALS for value in values)
		nulls = None
		if is_other and not method["is_virtual"]:
			# An object that is none is an empty Variant, or one with no object: the dump does not tell.
			count = sum(value.get("default_value") == "null" for value in values)
			choices = itertools.product((0, hash_integer(0)), repeat=count)
			try:
				nulls = next(choice for choice in choices if self.hash_method(method, choice, False) == method["hash"])
			except (Unknown, StopIteration):
				return False
		for value in values:
			if value.get("meta") == "float":
				value["meta"] = "double"  # as most are; numbers cross as doubles in either engine
			if has_list and value["type"] == "PackedFloat32Array":
				value["type"] = "PackedFloat64Array"
		if nulls is not None:
			method["hash"] = self.hash_method(method, nulls, True)
			method.pop("hash_compatibility", None)
		return True


def as_double(dump):
	"""Returns the dump, changed in place; one of a double-precision engine as it is."""
	if dump["header"]["precision"] != "double":
		double = Double(dump)
		for entry in dump["classes"]:
			entry["methods"] = [method for method in entry.get("methods", []) if double.convert(entry["name"], method)]
		dump["header"]["precision"] = "double"
	return dump
