# SPDX-License-Identifier: MIT
"""What the engine's API dump says, in C++ terms: names, types, how values cross the C interface."""

import re

# Builtin types with a storage of their own, copied and destroyed by the engine.
OPAQUE = [
	"String",
	"StringName",
	"NodePath",
	"RID",
	"Callable",
	"Signal",
	"Dictionary",
	"Array",
	"PackedByteArray",
	"PackedInt32Array",
	"PackedInt64Array",
	"PackedFloat32Array",
	"PackedFloat64Array",
	"PackedStringArray",
	"PackedVector2Array",
	"PackedVector3Array",
	"PackedColorArray",
	"PackedVector4Array",
]
# Builtin types that are plain numbers.
PLAIN = [
	"Vector2",
	"Vector2i",
	"Rect2",
	"Rect2i",
	"Vector3",
	"Vector4",
	"Plane",
	"Quaternion",
	"AABB",
	"Basis",
	"Transform3D",
	"Projection",
	"Color",
]
# Builtin types that the extension has no use for; methods with them are left out.
UNUSED = {"Vector3i", "Transform2D", "Vector4i"}
KEYWORDS = {
	"class",
	"default",
	"operator",
	"template",
	"private",
	"public",
	"new",
	"delete",
	"enum",
	"char",
	"bool",
	"int",
	"float",
	"double",
	"switch",
	"case",
	"continue",
	"export",
	"inline",
	"const",
	"namespace",
	"typename",
}


def snake(name):
	"""Returns the header name of a class: Node3D -> node3d, RDShaderSPIRV -> rd_shader_spirv."""
	name = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()
	return re.sub(r"([23])_d", r"\1d", name)


def guard(name):
	"""Returns a name that is no C++ keyword."""
	return name + "_" if name in KEYWORDS else name


class Type:
	"""One type of the dump as C++ sees it.

	name: the C++ type of a returned value; parameter: of a parameter; kind: how it crosses the C interface
	(bool, int, float, enum, builtin, variant, array, object, ref).
	"""

	def __init__(self, name, kind, parameter=None, engine_class=None, element_class=None):
		self.name = name
		self.kind = kind
		self.parameter = parameter or name
		self.engine_class = engine_class
		self.element_class = element_class  # of a typed array

	def declare(self, name):
		"""Returns a parameter declaration."""
		joint = "" if self.parameter.endswith(("&", "*")) else " "
		return self.parameter + joint + name

	def result(self):
		"""Returns the type of the result with what must stand between it and the function's name."""
		return self.name if self.name.endswith("*") else self.name + " "


class Api:
	"""The dump and the choice of classes."""

	def __init__(self, dump, enabled):
		self.dump = dump
		self.classes = {entry["name"]: entry for entry in dump["classes"]}
		self.builtins = {entry["name"]: entry for entry in dump["builtin_classes"]}
		self.singletons = {entry["name"] for entry in dump["singletons"]}
		unknown = [name for name in enabled if name not in self.classes]
		if unknown:
			raise SystemExit("classes.json names classes that this engine does not have: " + ", ".join(unknown))
		chosen = set()
		for name in list(enabled) + ["ClassDB", "Object", "RefCounted"]:
			while name:
				chosen.add(name)
				name = self.classes[name].get("inherits")
		# A base must be declared before what inherits it.
		self.chosen = sorted(chosen, key=lambda name: (self.depth(name), name))

	def depth(self, name):
		"""Returns how many ancestors a class has."""
		parent = self.classes[name].get("inherits")
		return 1 + self.depth(parent) if parent else 0

	def is_refcounted(self, name):
		return self.classes[name]["is_refcounted"]

	def class_name(self, name):
		"""Returns the C++ name of an engine class (ClassDB is the binding's own registry)."""
		return "ClassDBSingleton" if name == "ClassDB" else name

	def type(self, text, meta=None):
		"""Returns the Type of a type in the dump, or None where the binding has no use for it."""
		if "*" in text or text.split("::")[-1] in UNUSED:
			return None
		if text == "bool":
			return Type("bool", "bool")
		if text == "int":
			fixed = meta and re.fullmatch(r"u?int\d+", meta)
			name = meta + "_t" if fixed or meta in ("char16", "char32") else "int64_t"
			return Type(name, "int")
		if text == "float":
			return Type("float" if meta == "float" else "double", "float")
		if text == "Variant":
			return Type("Variant", "variant", "const Variant &")
		if text in self.builtins:
			return Type(text, "builtin", "const %s &" % text)
		if text.startswith(("enum::", "bitfield::")):
			return self.enum(text)
		if text.startswith("typedarray::"):
			return self.typed_array(text[len("typedarray::") :])
		return self.object(text)

	def enum(self, text):
		prefix, name = text.split("::")
		owner, dot, plain = name.partition(".")
		engine_class = None
		if dot and owner in self.classes:
			if owner not in self.chosen:
				return None
			engine_class = owner
			name = self.class_name(owner) + "." + plain
		name = name.replace(".", "::")
		if prefix == "bitfield":
			name = "BitField<%s>" % name
		return Type(name, "enum", None, engine_class)

	def typed_array(self, text):
		element = text.split(":")[-1]
		element_class = None
		if element in self.classes:
			if element not in self.chosen:
				return None
			element_class = element
			element = "Ref<%s>" % element if self.is_refcounted(element) else element
		name = "TypedArray<%s>" % element
		return Type(name, "array", "const %s &" % name, None, element_class)

	def object(self, name):
		if name not in self.chosen:
			return None
		if self.is_refcounted(name):
			return Type("Ref<%s>" % name, "ref", "const Ref<%s> &" % name, name)
		return Type(self.class_name(name) + " *", "object", None, name)

	def default(self, kind, text):
		"""Returns a default value of the dump as a C++ expression for a parameter of this Type."""
		if text == "null":
			return "Ref<%s>()" % kind.engine_class if kind.kind == "ref" else "nullptr"
		if kind.kind == "enum":
			return "%s(%s)" % (kind.name, text) if kind.name.startswith("BitField") else "(%s)%s" % (kind.name, text)
		if kind.kind == "array":
			return kind.name + "()"
		if text in ("[]", "{}"):
			return kind.name + "()"
		if text.startswith("&"):
			text = text[1:]
		if kind.name in ("String", "StringName") and text == '""':
			return kind.name + "()"
		if kind.name == "NodePath" and text.startswith("NodePath("):
			return "NodePath()" if text == 'NodePath("")' else text
		return text
