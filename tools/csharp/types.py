# SPDX-License-Identifier: MIT
"""How Godot's types stand in C#: the type, and how a value comes out of a Variant and goes into one."""

import re
from dataclasses import dataclass

from tools.csharp import names
from tools.say import Failure

# Godot's type -> (type, method of Variant).
PLAIN = {
	"bool": ("bool", "AsBool"),
	"float": ("float", "AsSingle"),
	"String": ("string", "AsString"),
	"StringName": ("StringName", "AsStringName"),
	"NodePath": ("NodePath", "AsNodePath"),
	"Vector2": ("Vector2", "AsVector2"),
	"Vector2i": ("Vector2I", "AsVector2I"),
	"Vector3": ("Vector3", "AsVector3"),
	"Rect2": ("Rect2", "AsRect2"),
	"Rect2i": ("Rect2I", "AsRect2I"),
	"AABB": ("Aabb", "AsAabb"),
	"Transform3D": ("Transform3D", "AsTransform3D"),
	"Color": ("Color", "AsColor"),
	"RID": ("Rid", "AsRid"),
	"Callable": ("Callable", "AsCallable"),
	"Dictionary": ("Godot.Collections.Dictionary", "AsGodotDictionary"),
	"Array": ("Godot.Collections.Array", "AsGodotArray"),
	"PackedByteArray": ("byte[]", "AsByteArray"),
	"PackedInt32Array": ("int[]", "AsInt32Array"),
	"PackedInt64Array": ("long[]", "AsInt64Array"),
	"PackedFloat32Array": ("float[]", "AsFloat32Array"),
	"PackedFloat64Array": ("double[]", "AsFloat64Array"),
	"PackedStringArray": ("string[]", "AsStringArray"),
	"PackedVector2Array": ("Vector2[]", "AsVector2Array"),
	"PackedVector3Array": ("Vector3[]", "AsVector3Array"),
	"PackedColorArray": ("Color[]", "AsColorArray"),
}
INTEGERS = {"int": "AsInt32", "uint": "AsUInt32", "long": "AsInt64"}
IDENTITY = "Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0)"


@dataclass
class Type:
	name: str  # in C#
	out: str  # the value in the Variant {0}
	into: str = "{0}"  # what goes into a Variant
	raw: str = ""  # the type of a signal's argument, if it is another
	unwrapped: str = "{0}"  # that argument as `name`


def integer(value, is_result):
	"""Counts and bytes may be large, bit masks have 32 bits and no sign."""
	if re.search(r"(^|_)(mask|layers)$", value.name):
		return "uint"
	return "long" if is_result or value.name == "seed" else "int"


class Types:
	def __init__(self, classes):
		self.classes = {made.name: made for made in classes}

	def of(self, value, is_result=False):
		"""`is_result`: of a method. Raises Failure for a type that C# has no counterpart for here."""
		if value.enum:
			owner, _, name = value.enum.rpartition(".")
			enum = f"{owner}.{names.enum(self.classes[owner], name)}"
			return Type(enum, f"({enum}){{0}}.AsInt64()", "(long){0}", "long", f"({enum}){{0}}")
		if value.type == "void":
			return Type("void", "{0}")
		if value.type == "Variant":
			return Type("Variant", "{0}")
		if value.type == "int":
			name = integer(value, is_result)
			return Type(name, f"{{0}}.{INTEGERS[name]}()")
		if value.type in PLAIN:
			name, method = PLAIN[value.type]
			return Type(name, f"{{0}}.{method}()")
		if value.type.endswith("[]"):
			return self.array(value.type[:-2])
		if value.type in self.classes:
			return Type(value.type, f"{value.type}.Wrap({{0}})", "{0}", "GodotObject", f"{value.type}.Wrap({{0}})")
		if re.fullmatch(r"[A-Z]\w*", value.type) and not re.fullmatch(r"Packed\w+Array", value.type):
			return Type(value.type, f"({value.type}){{0}}.AsGodotObject()")
		raise Failure(f"{value.type} has no counterpart in tools/csharp/types.py, which {value.name} needs.")

	def array(self, element):
		if element in self.classes:
			array = "Godot.Collections.Array"
			return Type(f"{element}[]", f"WrapAll({{0}}, {element}.Wrap)", "Unwrap({0})", array, f"WrapAll({{0}}, {element}.Wrap)")
		name = PLAIN[element][0] if element in PLAIN else element
		return Type(f"Godot.Collections.Array<{name}>", f"{{0}}.AsGodotArray<{name}>()")

	def param(self, value):
		"""Returns (declaration, argument) of a method's parameter."""
		kind, name = self.of(value), names.camel(value.name)
		if value.default is None:
			return f"{kind.name} {name}", kind.into.format(name)
		if value.default == IDENTITY:
			return f"{kind.name}? {name} = null", f"{name} ?? {kind.name}.Identity"
		return f"{kind.name} {name} = {self.constant(value, kind)}", kind.into.format(name)

	def constant(self, value, kind):
		"""Returns a default as C# writes it."""
		text = value.default
		if value.enum:
			return f"({kind.name}){text}"
		if text in ("null", '""', '&""', 'NodePath("")', "[]", "{}") and kind.name != "string":
			return "null"
		if value.type == "float":
			return f"{float(text):g}f"
		if value.type in ("int", "bool", "String"):
			return text
		if re.fullmatch(r"\w+\((0(, 0)*)?\)", text) and "[]" not in kind.name:
			return f"default({kind.name})"
		raise Failure(f"{value.name} has the default {text}, which tools/csharp/types.py does not know.")
