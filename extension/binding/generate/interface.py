# SPDX-License-Identifier: MIT
"""The engine's C interface: one function pointer per entry, named as in gdextension_interface.h."""

import re

HEADER = "// SPDX-License-Identifier: MIT\n// Written by extension/binding/generator.py from the engine's own dump; changes are lost.\n\n"


def interface_functions(text):
	"""Returns the (name, typedef, deprecated) of every interface function that the header documents."""
	entry = re.compile(r"/\*\*(?P<notes>(?:(?!\*/).)*?@name (?P<name>\w+)(?:(?!\*/).)*)\*/\s*typedef\s[^;]*?\(\*(?P<type>\w+)\)\s*\(", re.S)
	return [(match["name"], match["type"], "@deprecated" in match["notes"]) for match in entry.finditer(text)]


def write_interface(output, text):
	"""Copies the C header and declares, defines and loads its functions."""
	functions = interface_functions(text)
	output.write("include/gdextension_interface.h", text)

	lines = [HEADER + "#pragma once\n\n#include <gdextension_interface.h>\n\n#include <godot_cpp/core/version.hpp>\n"]
	lines.append("namespace godot::gdextension_interface {\n")
	lines += ["extern %s %s;" % (kind, name) for name, kind, _ in functions]
	lines.append("\n} // namespace godot::gdextension_interface\n")
	lines.append("namespace godot::internal {\n")
	lines.append("// Looks every function up. Returns the name of the first one that the engine lacks (deprecated ones may be")
	lines.append("// missing), or null.")
	lines.append("const char *load_interface(GDExtensionInterfaceGetProcAddress p_get_proc_address);\n")
	lines.append("} // namespace godot::internal\n")
	output.write("include/godot_cpp/core/gdextension_interface_loader.hpp", "\n".join(lines))

	lines = [HEADER + "#include <godot_cpp/core/gdextension_interface_loader.hpp>\n"]
	lines.append("namespace godot::gdextension_interface {\n")
	lines += ["%s %s = nullptr;" % (kind, name) for name, kind, _ in functions]
	lines.append("\n} // namespace godot::gdextension_interface\n")
	lines.append("namespace godot::internal {\n")
	lines.append("const char *load_interface(GDExtensionInterfaceGetProcAddress p_get_proc_address) {")
	lines.append("\tstruct Entry {\n\t\tconst char *name;\n\t\tGDExtensionInterfaceFunctionPtr *function;\n\t\tbool required;\n\t};")
	lines.append("\tconst Entry entries[] = {")
	for name, _, deprecated in functions:
		place = "reinterpret_cast<GDExtensionInterfaceFunctionPtr *>(&gdextension_interface::%s)" % name
		lines.append('\t\t{ "%s", %s, %s },' % (name, place, "false" if deprecated else "true"))
	lines.append("\t};")
	lines.append("\tfor (const Entry &entry : entries) {")
	lines.append("\t\t*entry.function = p_get_proc_address(entry.name);")
	lines.append("\t\tif (!*entry.function && entry.required) {\n\t\t\treturn entry.name;\n\t\t}")
	lines.append("\t}\n\treturn nullptr;\n}\n")
	lines.append("} // namespace godot::internal\n")
	output.write("src/interface.cpp", "\n".join(lines))


def write_version(output, api):
	"""The version of the engine that the dump came from."""
	header = api.dump["header"]
	lines = [HEADER + "#pragma once\n"]
	for part in ("major", "minor", "patch"):
		lines.append("#define GODOT_VERSION_%s %d" % (part.upper(), header["version_" + part]))
	for part in ("status", "build"):
		lines.append('#define GODOT_VERSION_%s "%s"' % (part.upper(), header["version_" + part]))
	output.write("include/godot_cpp/core/version.hpp", "\n".join(lines) + "\n")
