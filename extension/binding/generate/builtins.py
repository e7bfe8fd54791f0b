# SPDX-License-Identifier: MIT
"""The builtin types with storage of their own: the methods and operators that the hand-written headers lack.

The hand-written header of a type includes `gen/<type>.inc` inside its class; that file declares the rest.
The packed arrays differ only in their element, so their headers are written whole. Types that are plain numbers
get nothing: upstream writes those by hand, with other types than the dump says.
"""

import os
import re

from generate.api import OPAQUE, PLAIN, guard, snake
from generate.calls import Function, definition
from generate.interface import HEADER

OPERATORS = {
	"==": "EQUAL",
	"!=": "NOT_EQUAL",
	"<": "LESS",
	"<=": "LESS_EQUAL",
	">": "GREATER",
	">=": "GREATER_EQUAL",
	"+": "ADD",
}
ELEMENTS = {
	"PackedByteArray": "uint8_t",
	"PackedInt32Array": "int32_t",
	"PackedInt64Array": "int64_t",
	"PackedFloat32Array": "float",
	"PackedFloat64Array": "double",
	"PackedStringArray": "String",
	"PackedVector2Array": "Vector2",
	"PackedVector3Array": "Vector3",
	"PackedColorArray": "Color",
	"PackedVector4Array": "Vector4",
}


# Global functions that upstream leaves out, and those that it calls otherwise.
NOT_UPSTREAM = {"is_instance_valid"}
RENAMED = {"typeof": "type_of"}


def type_code(name):
	"""GDEXTENSION_VARIANT_TYPE_* of a builtin type."""
	if name in ("AABB", "RID"):
		return "GDEXTENSION_VARIANT_TYPE_" + name
	return "GDEXTENSION_VARIANT_TYPE_" + re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).upper().replace("2_D", "2D").replace("3_D", "3D")


def hand_written(core, name):
	"""Returns the methods that a hand-written header declares at class scope."""
	path = os.path.join(core, "variant", snake(name) + ".hpp")
	if not os.path.exists(path):
		return set()
	with open(path, encoding="utf-8") as file:
		return set(re.findall(r"^\t(?:[\w:<>]+ )+[*&]?(\w+)\(", file.read(), re.M))


def method(api, name, entry):
	"""Returns the declaration and definition of one method, or None."""
	function = Function(api, entry)
	if not function.known():
		return None
	# Variant is not yet complete where these are declared, so it can have no default value there.
	function.arguments = [(kind, argument, None if kind.kind == "variant" else default) for kind, argument, default in function.arguments]
	place = "nullptr" if function.static else "const_cast<%s *>(this)" % name if function.const else "this"
	plain = guard(function.name)
	tail = " const" if function.const and not function.static else ""
	if function.vararg:
		return vararg_method(function, name, place, tail)
	lookup = 'static constinit internal::BuiltinMethod method{ %s, "%s", %d };' % (type_code(name), function.name, function.hash)
	body = function.body(lambda arguments, count, result: "method.call(%s, %s, %s, %d);" % (place, arguments, result, count))
	declaration = "%s%s%s(%s)%s;" % ("static " if function.static else "", function.result_text(), plain, function.parameters(True), tail)
	head = "%s%s::%s(%s)%s" % (function.result_text(), name, plain, function.parameters(False), tail)
	return declaration, definition(head, [lookup] + body)


PRIVATE = "\nprivate:\n\t%s;\n\npublic:\n\t"  # what a template of the same name calls


def pass_on(name, fixed):
	"""Returns the end of a vararg template: hands the array `values` to the function that takes pointers."""
	count = "sizeof...(Arguments) + %d" % fixed if fixed else "sizeof...(Arguments)"
	return "\t\treturn %s_variants(internal::VariantPointers<%s>(values).pointers, %s);\n\t}" % (name, count, count)


def vararg_method(function, name, place, tail):
	"""Returns a template for the caller's arguments over one function that takes them as Variants."""
	first = "".join(kind.declare(argument) + ", " for kind, argument, _ in function.arguments)
	given = "".join("Variant(%s), " % argument for _, argument, _ in function.arguments)
	head = "%s%s_variants(const Variant *const *p_arguments, int p_count)%s" % (function.result_text(), function.name, tail)
	# For the same reason what the template says of Variant must depend on its arguments.
	declaration = PRIVATE % head + "template <typename... Arguments>\n\tauto %s(%sconst Arguments &...p_arguments)%s {\n" % (
		function.name,
		first,
		tail,
	)
	declaration += "\t\tusing Value = typename internal::Later<Variant, Arguments...>::Type;\n"
	declaration += "\t\tconst Value values[] = { %sValue(p_arguments)..., Value() };\n" % given.replace("Variant(", "Value(")
	declaration += pass_on(function.name, len(function.arguments))
	lookup = 'static constinit internal::BuiltinMethod method{ %s, "%s", %d };' % (type_code(name), function.name, function.hash)
	call = "method.call(%s, reinterpret_cast<const GDExtensionConstTypePtr *>(p_arguments), %s, p_count);"
	body = [lookup]
	if function.result:
		declare, give = function.returned()
		body += [declare, call % (place, "&result"), give]
	else:
		body += [call % (place, "nullptr")]
	return declaration, definition(head.replace(function.name + "_variants", name + "::" + function.name + "_variants", 1), body)


def operators(name, entry):
	"""Comparisons and concatenation between two values of the type."""
	found = []
	for operator in entry["operators"]:
		symbol, right, result = operator["name"], operator.get("right_type"), operator["return_type"]
		if symbol not in OPERATORS or right != name:
			continue
		head = "operator%s(const %s &p_other) const" % (symbol, name)
		body = [
			"static constinit internal::BuiltinOperator evaluator{ GDEXTENSION_VARIANT_OP_%s, %s, %s };"
			% (OPERATORS[symbol], type_code(name), type_code(name)),
			"%s result%s;" % (result, " = false" if result == "bool" else ""),
			"evaluator.call(this, &p_other, &result);",
			"return result;",
		]
		found.append(("%s %s;" % (result, head), definition("%s %s::%s" % (result, name, head), body)))
	return found


def constructor_counts(api):
	"""Returns the table of how many constructors each builtin type has, in the order of their numbers."""
	types = next(enum for enum in api.dump["global_enums"] if enum["name"] == "Variant.Type")["values"]
	counts = {type_code(name): len(api.builtins[name]["constructors"]) for name in OPAQUE}
	row = [str(counts.get("GDEXTENSION_VARIANT_" + item["name"], 0)) for item in types if item["name"] != "TYPE_MAX"]
	return "const int internal::builtin_constructor_counts[] = { %s };\n" % ", ".join(row)


# Members at which a type would show that it is laid out otherwise.
LAST_MEMBERS = {("AABB", "size"), ("Plane", "d"), ("Quaternion", "w"), ("Rect2", "size"), ("Transform3D", "origin"), ("Vector4", "w")}


def layout_checks(api):
	"""The build fails if a type is not as large as the engine says, of this precision and 64 bits."""
	build = "%s_64" % {"single": "float", "double": "double"}[api.dump["header"]["precision"]]
	sizes, offsets = (
		next(entry for entry in api.dump["builtin_class_%s" % part] if entry["build_configuration"] == build)
		for part in ("sizes", "member_offsets")
	)
	check = "static_assert(sizeof(void *) != 8 || %s == %d);"
	lines = [check % ("sizeof(%s)" % item["name"], item["size"]) for item in sizes["sizes"] if item["name"] in {*OPAQUE, *PLAIN, "Variant"}]
	for entry in offsets["classes"]:
		for member in entry["members"]:
			if (entry["name"], member["member"]) in LAST_MEMBERS:
				lines.append(check % ("offsetof(%s, %s)" % (entry["name"], member["member"]), member["offset"]))
	return "\n".join(lines) + "\n"


def packed_header(name, declarations):
	"""Returns the whole header of one packed array."""
	element = ELEMENTS[name]
	include = "#include <godot_cpp/variant/%s.hpp>\n" % snake(element) if element in PLAIN + OPAQUE else ""
	lines = [
		HEADER + "#pragma once\n",
		"#include <godot_cpp/variant/packed_array.hpp>",
		include,
		"namespace godot {\n",
		"class %s : public internal::PackedArray<%s, %s, %s> {" % (name, name, element, type_code(name)),
		"public:",
		"\tusing PackedArray::PackedArray;",
		"\t%s() = default;" % name,
		"\t%s(const Array &p_from);\n" % name,
		"\t" + "\n\t".join(declarations),
		"};\n\n} // namespace godot\n",
	]
	return "\n".join(lines)


def write_builtins(output, api, core):
	"""Writes gen/*.inc, the packed arrays' headers, builtin_types.hpp and builtins.cpp."""
	source = [HEADER + "#include <godot_cpp/core/object.hpp>\n#include <godot_cpp/variant/variant.hpp>\n\nnamespace godot {\n"]
	for name in OPAQUE:
		entry = api.builtins[name]
		skip = hand_written(core, name)
		pairs = [method(api, name, item) for item in entry.get("methods", []) if item["name"] not in skip]
		pairs = [pair for pair in pairs if pair]
		if name in OPAQUE and name not in ("RID", "StringName"):
			pairs += operators(name, entry)
		declarations = [declaration for declaration, _ in pairs]
		if name in ELEMENTS:
			output.write("include/godot_cpp/variant/%s.hpp" % snake(name), packed_header(name, declarations))
			constructor = next(item["index"] for item in entry["constructors"] if item.get("arguments", [{}])[0].get("type") == "Array")
			source.append("%s::%s(const Array &p_from) :\n\t\tPackedArray(%d, &p_from) {}\n" % (name, name, constructor))
		else:
			output.write("include/godot_cpp/variant/gen/%s.inc" % snake(name), HEADER + "\n".join(declarations) + "\n")
		source += [text for _, text in pairs]
	source.append(constructor_counts(api))
	source.append(layout_checks(api))
	source.append("} // namespace godot\n")
	output.write("src/builtins.cpp", "\n".join(source))

	lines = [HEADER + "#pragma once\n"]
	lines += ["#include <godot_cpp/variant/%s.hpp>" % snake(name) for name in sorted(OPAQUE + PLAIN)]
	output.write("include/godot_cpp/variant/builtin_types.hpp", "\n".join(lines) + "\n")


def write_utility_functions(output, api):
	"""UtilityFunctions: the engine's global functions."""
	declarations, source = [], []
	for entry in api.dump["utility_functions"]:
		function = Function(api, entry)
		if not function.known() or function.name in NOT_UPSTREAM:
			continue
		lookup = 'static constinit internal::UtilityFunction function{ "%s", %d };' % (function.name, function.hash)
		plain = guard(RENAMED.get(function.name, function.name))
		if function.vararg:
			head = "%s%s_variants(const Variant *const *p_arguments, int p_count)" % (function.result_text(), plain)
			first = "".join(kind.declare(argument) + ", " for kind, argument, _ in function.arguments)
			declaration = PRIVATE % (
				"static " + head
			) + "template <typename... Arguments>\n\tstatic %s%s(%sconst Arguments &...p_arguments) {\n" % (
				function.result_text(),
				plain,
				first,
			)
			given = "".join(argument + ", " for _, argument, _ in function.arguments)
			declaration += "\t\tconst Variant values[] = { %sVariant(p_arguments)..., Variant() };\n" % given
			declarations.append(declaration + pass_on(plain, len(function.arguments)))
			call = "function.call(reinterpret_cast<const GDExtensionConstTypePtr *>(p_arguments), %s, p_count);"
			declare, give = function.returned() if function.result else (None, None)
			body = [lookup, declare, call % "&result", give] if function.result else [lookup, call % "nullptr"]
			source.append(definition(head.replace(plain, "UtilityFunctions::" + plain, 1), body))
			continue
		body = function.body(lambda arguments, count, result: "function.call(%s, %s, %d);" % (arguments, result, count))
		declarations.append("static %s%s(%s);" % (function.result_text(), plain, function.parameters(True)))
		source.append(
			definition("%sUtilityFunctions::%s(%s)" % (function.result_text(), plain, function.parameters(False)), [lookup] + body)
		)
	header = "#pragma once\n\n#include <godot_cpp/variant/variant.hpp>\n\nnamespace godot {\n\n"
	header += "class UtilityFunctions {\npublic:\n\t%s\n};\n\n} // namespace godot\n"
	output.write("include/godot_cpp/variant/utility_functions.hpp", HEADER + header % "\n\t".join(declarations))
	includes = "#include <godot_cpp/core/object.hpp>\n#include <godot_cpp/variant/utility_functions.hpp>\n"
	text = "%s%s\nnamespace godot {\n\n%s\n} // namespace godot\n" % (HEADER, includes, "\n".join(source))
	output.write("src/utility_functions.cpp", text)
