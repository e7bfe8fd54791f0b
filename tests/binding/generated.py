# SPDX-License-Identifier: MIT
"""The surface of what is generated: upstream's rules, from the API dump to C++ types, said once more and apart from the generator.

Usage: generated.py EXTENSION_API_JSON CLASSES_JSON BINDING_INCLUDE OUT_CPP
"""

import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import members

NUMBERS = {"int": "int64_t", "float": "double", "bool": "bool"}
PLAIN = ("bool", "int", "float")
# Types whose methods upstream writes by hand, or that are no classes.
BY_HAND = {*PLAIN, "Nil", "RID", "Vector2", "Vector2i", "Rect2", "Rect2i", "Vector3", "Vector3i", "Transform2D",
	"Vector4", "Vector4i", "Plane",
	"Quaternion", "AABB", "Basis", "Transform3D", "Projection", "Color"}  # fmt: skip
UNUSED = {"Vector3i", "Transform2D", "Vector4i"}  # by the extension; what has them is left out
RENAMED = {("Node", "get_node"): "get_node_internal", ("", "typeof"): "type_of"}
OPERATORS = {"==", "!=", "<", "<=", ">", ">=", "+"}  # of two values of a type
LEFT_OUT = {"is_instance_valid"}
PACKED = {"Byte": "uint8_t", "Int32": "int32_t", "Int64": "int64_t", "Float32": "float", "Float64": "double", "String": "String",
	"Vector2": "Vector2", "Vector3": "Vector3", "Color": "Color", "Vector4": "Vector4"}  # fmt: skip


def header(name):
	"""Returns the path of a class's header: Node3D is node3d.hpp, RDShaderSPIRV rd_shader_spirv.hpp."""
	name = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
	name = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name).lower()
	return re.sub(r"_?([23])_d", r"\1d", name)


class Rules:
	def __init__(self, dump, enabled):
		self.dump = dump
		self.classes = {entry["name"]: entry for entry in dump["classes"]}
		self.chosen = set()
		for name in [*enabled, "ClassDB", "Object", "RefCounted"]:
			while name:
				self.chosen.add(name)
				name = self.classes[name].get("inherits")

	def known(self, entry):
		"""Returns whether the function's types are among the chosen ones."""
		types = [argument["type"] for argument in entry.get("arguments", [])]
		types.append(entry.get("return_value", {}).get("type", ""))
		for kind in types:
			element = kind.split("::")[-1].split(":")[-1].split(".")[0]
			if (
				"*" in kind
				or element in UNUSED
				or kind.startswith("typeddictionary")
				or (element in self.classes and element not in self.chosen)
			):
				return False
		return True

	def result(self, kind, meta=None):
		if meta and kind in ("int", "float"):  # others say that an object is required
			return meta if meta in ("float", "double") else meta + "_t"
		if kind in NUMBERS:
			return NUMBERS[kind]
		if kind.startswith("typedarray::"):
			return f"TypedArray<{self.element(kind.split('::')[1].split(':')[-1])}>"
		if kind.startswith(("enum::", "bitfield::")):
			prefix, name = kind.split("::")
			name = re.sub(r"^ClassDB\.", "ClassDBSingleton.", name).replace(".", "::")
			return name if prefix == "enum" else f"BitField<{name}>"
		return self.element(kind) + (" *" if kind in self.classes and not self.classes[kind]["is_refcounted"] else "")

	def element(self, kind):
		return f"Ref<{kind}>" if kind in self.classes and self.classes[kind]["is_refcounted"] else kind

	def parameter(self, argument):
		kind, name = argument["type"], self.result(argument["type"], argument.get("meta"))
		by_value = kind in PLAIN or kind.startswith(("enum::", "bitfield::")) or name.endswith("*")
		return name if by_value else f"const {name} &"

	def signature(self, entry):
		result = entry.get("return_value") or {"type": entry.get("return_type", "void")}
		parameters = ", ".join(self.parameter(argument) for argument in entry.get("arguments", []))
		return f"{self.result(result['type'], result.get('meta'))}({parameters})"

	def call(self, owner, entry, prefix):
		"""Returns a template of any number of arguments, by a use of it."""
		result = (entry.get("return_value") or {"type": entry.get("return_type", "void")})["type"]
		given = [f"a<std::remove_cvref_t<{self.parameter(argument)}>>()" for argument in entry.get("arguments", [])] + ["1", "String()"]
		return f"CALL({owner}, {entry['name']}, {self.result(result)}, {prefix}{entry['name']}({', '.join(given)}))"

	def function(self, owner, entry):
		name = RENAMED.get((owner, entry["name"]), entry["name"])
		if entry.get("is_vararg"):
			return self.call(owner, entry, f"{owner}::" if entry.get("is_static") else f"a<{owner}>().")
		if entry.get("is_static"):
			return f"STATIC({owner}, {name}, {self.signature(entry)})"
		return f"METHOD({owner}, {name}, {self.signature(entry)}{' const' if entry.get('is_const') else ''})"

	def of_class(self, name):
		entry, owner = self.classes[name], "ClassDBSingleton" if name == "ClassDB" else name
		lines = [self.function(owner, method) for method in entry.get("methods", []) if self.known(method)]
		for enum in entry.get("enums", []):
			lines += [f"VALUE({owner}::{value['name']}, {value['value']})" for value in enum["values"]]
		lines += [f"VALUE({owner}::{constant['name']}, {constant['value']})" for constant in entry.get("constants", [])]
		if any(singleton["type"] == name for singleton in self.dump["singletons"]):
			lines.append(f"STATIC({owner}, get_singleton, {owner} *())")
		return lines

	def of_builtin(self, entry, by_hand):
		name = entry["name"]
		lines = [self.function(name, method) for method in entry.get("methods", []) if method["name"] not in by_hand]
		if name != "StringName":
			for operator in entry["operators"]:
				if operator["name"] in OPERATORS and operator.get("right_type") == name:
					lines.append(
						f"METHOD({name}, operator{operator['name']}, {self.result(operator['return_type'])}(const {name} &) const)"
					)
		return lines + packed(name)

	def of_utilities(self):
		for entry in self.dump["utility_functions"]:
			if entry["name"] not in LEFT_OUT:
				entry = {**entry, "name": RENAMED.get(("", entry["name"]), entry["name"]), "is_static": True}
				yield self.function("UtilityFunctions", entry)

	def of_global_enums(self):
		for enum in self.dump["global_enums"]:
			if "." not in enum["name"]:
				yield from (f"VALUE({value['name']}, {value['value']})" for value in enum["values"])


def packed(name):
	"""Returns what the packed arrays have beside the dump."""
	element = PACKED.get(name[len("Packed") : -len("Array")]) if name.startswith("Packed") else None
	if not element:
		return []
	return [
		f"CONSTRUCTOR({name})", f"CONSTRUCTOR({name}, const Array &)", f"CONSTRUCTOR({name}, std::initializer_list<{element}>)",
		f"METHOD({name}, ptr, const {element} *() const)", f"METHOD({name}, ptrw, {element} *())",
		f"METHOD({name}, operator[], const {element} &(int64_t) const)", f"METHOD({name}, operator[], {element} &(int64_t))",
		f"CALL({name}, begin, {element} &, *a<{name}>().begin())", f"CALL({name}, begin, const {element} &, *a<const {name}>().begin())",
		f"CALL({name}, end, bool, a<{name}>().begin() != a<{name}>().end())",
	]  # fmt: skip


def main(api, classes, include, out):
	rules = Rules(json.loads(pathlib.Path(api).read_text()), json.loads(pathlib.Path(classes).read_text())["enabled_classes"])
	names = sorted(rules.chosen)
	lines = ["// SPDX-License-Identifier: MIT", '#include "surface.h"', ""]
	lines += [f"#include <godot_cpp/classes/{header('ClassDBSingleton' if name == 'ClassDB' else name)}.hpp>" for name in names]
	lines += ["#include <godot_cpp/core/class_db.hpp>", "#include <godot_cpp/variant/utility_functions.hpp>", "", "using namespace godot;"]
	for name in names:
		lines += ["", *rules.of_class(name)]
	for entry in rules.dump["builtin_classes"]:
		if entry["name"] not in BY_HAND:
			written = pathlib.Path(include, f"godot_cpp/variant/{header(entry['name'])}.hpp")
			by_hand = {name for _, name in members.offered(members.plain(written.read_text()))} if written.exists() else set()
			lines += ["", *rules.of_builtin(entry, by_hand)]
	lines += ["", *rules.of_utilities(), "", *rules.of_global_enums(), ""]
	pathlib.Path(out).parent.mkdir(parents=True, exist_ok=True)
	pathlib.Path(out).write_text("\n".join(lines))


if __name__ == "__main__":
	main(*sys.argv[1:])
