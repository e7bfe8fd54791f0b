# SPDX-License-Identifier: MIT
"""The engine's classes: one header each, and a few sources with all their methods."""

from generate.api import snake
from generate.builtins import PRIVATE, pass_on
from generate.calls import Function, definition
from generate.interface import HEADER

SOURCES = 4  # how many .cpp files the classes are spread over: fewer compile faster, more compile in parallel


def header_of(api, name):
	"""Returns the include path of an engine class."""
	return "godot_cpp/classes/%s.hpp" % snake("ClassDB_Singleton" if name == "ClassDB" else name).replace("__", "_")


def enum_text(enum, indent):
	"""Returns an enum of the dump. A bit field is 64 bits wide, as the engine passes it."""
	wide = " : uint64_t" if enum["is_bitfield"] else ""
	values = "".join("%s\t%s = %d,\n" % (indent, value["name"], value["value"]) for value in enum["values"])
	return "%senum %s%s {\n%s%s};\n" % (indent, enum["name"], wide, values, indent)


def write_global_constants(output, api):
	"""The enums that belong to no class."""
	enums = [enum for enum in api.dump["global_enums"] if "." not in enum["name"]]
	text = HEADER + "#pragma once\n\n#include <cstdint>\n\nnamespace godot {\n\n" + "\n".join(enum_text(enum, "") for enum in enums)
	output.write("include/godot_cpp/classes/global_constants.hpp", text + "\n} // namespace godot\n")
	casts = ["%s(%s)" % ("VARIANT_BITFIELD_CAST" if enum["is_bitfield"] else "VARIANT_ENUM_CAST", enum["name"]) for enum in enums]
	head = HEADER + "#pragma once\n\n#include <godot_cpp/core/binder_common.hpp>\n\n"
	output.write("include/godot_cpp/classes/global_constants_binds.hpp", head + "\n".join(casts) + "\n")


class EngineClass:
	"""One class: the text of its header and of its methods."""

	def __init__(self, api, name):
		self.api = api
		self.entry = api.classes[name]
		self.dump_name = name
		self.name = api.class_name(name)
		self.parent = self.entry.get("inherits")
		functions = [Function(api, entry) for entry in self.entry.get("methods", [])]
		functions = [function for function in functions if function.known()]
		for function in functions:
			function.cpp_name = RENAMED.get((name, function.name), function.cpp_name)
		self.virtuals = [function for function in functions if function.virtual]
		self.methods = [function for function in functions if not function.virtual]

	def header(self):
		"""Returns the whole header."""
		includes, forward = self.dependencies()
		lines = [HEADER + "#pragma once\n"]
		lines += ["#include <%s>" % path for path in includes]
		lines.append("\nnamespace godot {\n")
		lines += ["class %s;" % name for name in forward]
		lines.append("\nclass %s : public %s {" % (self.name, self.api.class_name(self.parent) if self.parent else "Wrapped"))
		lines.append(
			"\tENGINE_CLASS(%s, %s, %s)\n" % (self.name, self.dump_name, self.api.class_name(self.parent) if self.parent else "Wrapped")
		)
		lines.append("public:")
		for enum in self.entry.get("enums", []):
			lines.append(enum_text(enum, "\t"))
		in_enums = {value["name"] for enum in self.entry.get("enums", []) for value in enum["values"]}
		for constant in self.entry.get("constants", []):
			if constant["name"] not in in_enums:
				lines.append("\tstatic constexpr int %s = %d;" % (constant["name"], constant["value"]))
		if self.dump_name in self.api.singletons:
			lines.append("\tstatic constexpr bool _is_singleton = true;\n\tstatic %s *get_singleton();\n" % self.name)
		lines += ["\t" + self.declaration(function) for function in self.methods]
		lines += [
			"\tvirtual %s%s(%s)%s;" % (f.result_text(), f.name, f.parameters(True), " const" if f.const else "") for f in self.virtuals
		]
		if self.dump_name in EXTRA:
			lines.append("\n\t" + "\n\t".join(EXTRA[self.dump_name]))
		lines += self.register_virtuals()
		lines.append("};\n\n} // namespace godot\n")
		for enum in self.entry.get("enums", []):
			lines.append("%s(%s::%s)" % ("VARIANT_BITFIELD_CAST" if enum["is_bitfield"] else "VARIANT_ENUM_CAST", self.name, enum["name"]))
		if self.dump_name == "Object":
			lines.append("\n#include <godot_cpp/core/object.hpp>")
		return "\n".join(lines) + "\n"

	def register_virtuals(self):
		"""Returns the template that binds those virtual methods that a user's class overrides."""
		lines = ["\nprotected:", "\ttemplate <typename T, typename Base>", "\tstatic void register_virtuals() {"]
		if self.parent:
			lines.append("\t\t%s::register_virtuals<T, Base>();" % self.api.class_name(self.parent))
		for function in self.virtuals:
			lines.append(
				'\t\tinternal::bind_virtual<T, &T::%s, &Base::%s>("%s", %dU);'
				% (function.name, function.name, function.name, function.hash)
			)
		return lines + ["\t}"]

	def dependencies(self):
		"""Returns which headers the class needs, and which classes it only names."""
		includes, forward = set(), set()
		for function in self.methods + self.virtuals:
			for kind in function.types():
				if kind.engine_class and kind.engine_class != self.dump_name:
					if kind.kind == "enum":
						includes.add(header_of(self.api, kind.engine_class))
					else:
						forward.add(self.api.class_name(kind.engine_class))
			for kind, _, default in function.arguments:
				element = kind.element_class
				if element and element != self.dump_name:
					# A default value is made where the header is read: the class must be whole.
					(includes.add(header_of(self.api, element)) if default else forward.add(element))
			if function.result and function.result.element_class:
				forward.add(function.result.element_class)
		base = "godot_cpp/classes/wrapped.hpp" if not self.parent else header_of(self.api, self.parent)
		first = [base, "godot_cpp/classes/ref.hpp"] if self.dump_name not in ("Object", "RefCounted") else [base]
		return first + sorted(includes - {base}), sorted(forward - {"Object", self.name} if self.parent else forward)

	def declaration(self, function):
		"""Returns a method's declaration; a vararg method is a template over one that takes Variants."""
		static = "static " if function.static else ""
		tail = " const" if function.const and not function.static else ""
		if not function.vararg:
			return "%s%s%s(%s)%s;" % (static, function.result_text(), function.cpp_name, function.parameters(True), tail)
		first = "".join(kind.declare(name) + ", " for kind, name, _ in function.arguments)
		given = "".join("Variant(%s), " % name for _, name, _ in function.arguments)
		count = len(function.arguments)
		text = PRIVATE % ("%s%s_variants(const Variant *const *p_arguments, int p_count)%s" % (function.result_text(), function.name, tail))
		text += "template <typename... Arguments>\n\t%s%s(%sconst Arguments &...p_arguments)%s {\n" % (
			function.result_text(),
			function.name,
			first,
			tail,
		)
		text += "\t\tconst Variant values[] = { %sVariant(p_arguments)..., Variant() };\n" % given
		return text + pass_on(function.name, count)

	def source(self):
		"""Returns the definitions of all methods."""
		parts = ["ENGINE_CLASS_DEFINE(%s)\n" % self.name]
		if self.dump_name in self.api.singletons:
			parts.append(
				definition(
					"%s *%s::get_singleton()" % (self.name, self.name),
					[
						'static constinit internal::Singleton singleton{ "%s" };' % self.dump_name,
						"return static_cast<%s *>(singleton.get());" % self.name,
					],
				)
			)
		for function in self.methods:
			tail = " const" if function.const and not function.static else ""
			lookup = 'static constinit internal::EngineMethod method{ "%s", "%s", %d };' % (self.dump_name, function.name, function.hash)
			if function.vararg:
				head = "%s%s::%s_variants(const Variant *const *p_arguments, int p_count)%s" % (
					function.result_text(),
					self.name,
					function.name,
					tail,
				)
				call = "method.call_variants(_owner, p_arguments, p_count)"
				give = {None: call + ";", "Variant": "return " + call + ";"}.get(function.result and function.result.name)
				parts.append(definition(head, [lookup, give or "return static_cast<%s>(int64_t(%s));" % (function.result.name, call)]))
				continue
			owner = "nullptr" if function.static else "_owner"
			body = function.body(lambda arguments, count, result: "method.call(%s, %s, %s);" % (owner, arguments, result))
			head = "%s%s::%s(%s)%s" % (function.result_text(), self.name, function.cpp_name, function.parameters(False), tail)
			parts.append(definition(head, [lookup] + body))
		parts += [self.virtual_default(function) for function in self.virtuals]
		return "\n".join(parts)

	def virtual_default(self, function):
		"""Returns what a virtual method does where no class overrides it: nothing."""
		types = ", ".join(kind.declare("").rstrip() for kind, _, _ in function.arguments)
		head = "%s%s::%s(%s)%s" % (function.result_text(), self.name, function.name, types, " const" if function.const else "")
		if not function.result:
			return head + " {}\n"
		nothing = "nullptr" if function.result.name.endswith("*") else function.result.name + "{}"
		return definition(head, ["return %s;" % nothing])


# Methods that a template of the same name stands before.
RENAMED = {("Node", "get_node"): "get_node_internal"}

# What the C interface offers beyond the dump (src/extras.cpp), and what is handy in C++.
EXTRA = {
	"Node": [
		"template <typename T>",
		"T *get_node(const NodePath &p_path) const { return Object::cast_to<T>(get_node_internal(p_path)); }",
	],
	"Object": [
		"template <typename T>",
		"static T *cast_to(Object *p_object);",
		"template <typename T>",
		"static const T *cast_to(const Object *p_object);",
	],
	"Image": [
		"// The pixels themselves.",
		"uint8_t *ptrw();",
		"const uint8_t *ptr();",
	],
	"FileAccess": [
		"uint64_t get_buffer(uint8_t *p_bytes, uint64_t p_length) const;",
		"void store_buffer(const uint8_t *p_bytes, uint64_t p_length);",
	],
	"WorkerThreadPool": [
		"// Tasks that are plain functions.",
		"int64_t add_native_task(void (*p_function)(void *), void *p_data, bool p_high_priority = false,",
		"\t\tconst String &p_description = String());",
		"int64_t add_native_group_task(void (*p_function)(void *, uint32_t), void *p_data, int p_elements, int p_tasks = -1,",
		"\t\tbool p_high_priority = false, const String &p_description = String());",
	],
}


def write_classes(output, api):
	"""Writes every chosen class."""
	texts = [[] for _ in range(SOURCES)]
	for name in api.chosen:
		engine_class = EngineClass(api, name)
		output.write("include/" + header_of(api, name), engine_class.header())
		smallest = min(texts, key=lambda parts: sum(map(len, parts)))
		smallest.append(engine_class.source())
	includes = "\n".join("#include <%s>" % header_of(api, name) for name in api.chosen)
	for index, parts in enumerate(texts):
		text = HEADER + includes + "\n#include <godot_cpp/core/engine_class.hpp>\n\nnamespace godot {\n\n"
		text += "\n".join(parts) + "\n} // namespace godot\n"
		output.write("src/classes_%d.cpp" % index, text)
	known = "\n".join("\tregister_engine_class<%s>();" % api.class_name(name) for name in api.chosen)
	text = HEADER + includes + "\n#include <godot_cpp/core/engine_class.hpp>\n\nnamespace godot::internal {\n\n"
	text += "void register_engine_classes() {\n%s\n}\n\n} // namespace godot::internal\n" % known
	output.write("src/engine_classes.cpp", text)
