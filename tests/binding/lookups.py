# SPDX-License-Identifier: MIT
"""What the built binding looks up in the engine by name, as its sources say, and what an engine offers, as its dump says."""

import json
import re
from dataclasses import dataclass, field

SIZES = "float_64"  # the build of the engine that the extension is for
RECORDS = {
	"method": re.compile(r'EngineMethod \w+\{ "(\w+)", "(\w+)", (\d+) \}'),
	"builtin method": re.compile(r'BuiltinMethod \w+\{ GDEXTENSION_VARIANT_TYPE_(\w+), "(\w+)", (\d+) \}'),
	"function": re.compile(r'UtilityFunction \w+\{ ()"(\w+)", (\d+) \}'),
	"operator": re.compile(r"BuiltinOperator \w+\{ GDEXTENSION_VARIANT_OP_(\w+), GDEXTENSION_VARIANT_TYPE_(\w+), GDEXTENSION_VARIANT_TYPE_(\w+) \}"),
	"singleton": re.compile(r'Singleton \w+\{ ()"(\w+)"() \}'),
}  # fmt: skip


@dataclass
class Interface:
	"""What an engine offers, by name: of its dump."""

	version: str = ""
	parents: dict = field(default_factory=dict)  # class: its parent
	methods: dict = field(default_factory=dict)  # (class, name): the hashes that find it
	virtuals: dict = field(default_factory=dict)
	builtin_methods: dict = field(default_factory=dict)  # (type, name): hashes
	functions: dict = field(default_factory=dict)  # ("", name): hashes
	operators: set = field(default_factory=set)  # (symbol, left, right)
	constructors: dict = field(default_factory=dict)  # (type, index): types of its arguments
	singletons: dict = field(default_factory=dict)
	values: dict = field(default_factory=dict)  # (class or type or "", name of a constant): value
	signals: dict = field(default_factory=dict)  # (class, name): types of its arguments
	layout: dict = field(default_factory=dict)  # (type, member): place in it; (type, ""): its size


def hashes(entry):
	return {entry.get("hash", 0), *entry.get("hash_compatibility", [])}


def types(entry):
	return tuple(argument["type"] for argument in entry.get("arguments", []))


def constants(owner, entry):
	"""Values of the constants and enums of a class or builtin type. A builtin type's constants that are no numbers have a type."""
	values = [value for enum in entry.get("enums", []) for value in enum["values"]]
	values += [value for value in entry.get("constants", []) if value.get("type", "int") == "int"]
	return {(owner, value["name"]): int(value["value"]) for value in values}


def interface(path):
	dump = json.loads(path.read_text())
	found = Interface(".".join(str(dump["header"][f"version_{part}"]) for part in ("major", "minor", "patch")))
	for entry in dump["classes"]:
		name = entry["name"]
		found.parents[name] = entry.get("inherits")
		for method in entry.get("methods", []):
			(found.virtuals if method["is_virtual"] else found.methods)[name, method["name"]] = hashes(method)
		found.signals |= {(name, signal["name"]): types(signal) for signal in entry.get("signals", [])}
		found.values |= constants(name, entry)
	for entry in dump["builtin_classes"]:
		name = entry["name"]
		found.builtin_methods |= {(name, method["name"]): hashes(method) for method in entry.get("methods", [])}
		found.operators |= {(operator["name"], name, operator.get("right_type")) for operator in entry["operators"]}
		found.constructors |= {(name, constructor["index"]): types(constructor) for constructor in entry["constructors"]}
		found.values |= constants(name, entry)
	found.functions = {("", function["name"]): hashes(function) for function in dump["utility_functions"]}
	found.singletons = {singleton["name"]: singleton["type"] for singleton in dump["singletons"]}
	found.values |= {("", value["name"]): int(value["value"]) for enum in dump["global_enums"] for value in enum["values"]}
	for build in dump["builtin_class_sizes"]:
		if build["build_configuration"] == SIZES:
			found.layout |= {(entry["name"], ""): entry["size"] for entry in build["sizes"]}
	for build in dump["builtin_class_member_offsets"]:
		if build["build_configuration"] == SIZES:
			found.layout |= {(entry["name"], part["member"]): part["offset"] for entry in build["classes"] for part in entry["members"]}
	return found


@dataclass
class Lookups:
	"""(owner, name, hash) of each kind that the binding's sources hold, and what they take for given."""

	records: dict
	classes: set  # that the binding wraps
	virtuals: set
	functions: set  # of the C interface, which loading demands
	words: set  # of the extension and of the binding's handwritten part: what is not among them is never called


def lookups(generated, written):
	"""Of the text of the binding's generated part, and of what is written by hand: the rest of it, and the extension."""
	records = {kind: set(pattern.findall(generated + written)) for kind, pattern in RECORDS.items()}
	heads = re.split(r"\tENGINE_CLASS\(", generated)[1:]
	named = {head: re.match(r"\w+, (\w+),", head)[1] for head in heads}
	bound = re.compile(r'bind_virtual<[^"]*>\("(\w+)", (\d+)U\)')
	virtuals = {(named[head], *found) for head in heads for found in bound.findall(head.split("\n};\n")[0])}
	functions = set(re.findall(r'\{ "(\w+)", reinterpret_cast<GDExtensionInterfaceFunctionPtr \*>\(&[\w:]+\), true \}', generated))
	return Lookups(records, set(named.values()), virtuals, functions, set(re.findall(r"\w+", written)))


def c_functions(header):
	"""Name -> types of its result and of its parameters, of the functions that the C interface's header documents."""
	entry = re.compile(r"@name (\w+)(?:(?!\*/).)*\*/\s*typedef\s+([^;(]*?)\(\*\w+\)\s*\(([^;]*)\)\s*;", re.S)
	found = {}
	for name, result, parameters in entry.findall(header):
		kinds = [re.sub(r"\w+$", "", part.strip()) for part in parameters.split(",") if part.strip() not in ("", "void")]
		found[name] = [re.sub(r"\s", "", kind) for kind in (result, *kinds)]
	return found


def c_description(text, version):
	"""Returns the same of the description of the interface as JSON, of what an engine of `version` has."""
	found = {}
	for entry in json.loads(text)["interface"]:
		if [*map(int, entry["since"].split("."))] <= [*map(int, version.split("."))]:
			kinds = [entry.get("return_value", {}).get("type", "void"), *types(entry)]
			found[entry["name"]] = [re.sub(r"\s", "", kind) for kind in kinds]
	return found
