# SPDX-License-Identifier: MIT
"""Says what interfaces of other engines lack of what the built binding looks up: each class, method and hash that is called.

Usage: check_interface.py ROOT API_FOLDER C_DESCRIPTION|- EXTENSION_API_JSON...
Prints `version: what is looked up: ` and what is lacking, nothing if nothing is. The lines of the version `test` are of this check
itself: in a copy of our own interface one entry is changed, and must be found.
"""

import copy
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import lookups

OPERATORS = {"EQUAL": "==", "NOT_EQUAL": "!=", "LESS": "<", "LESS_EQUAL": "<=", "GREATER": ">", "GREATER_EQUAL": ">=", "ADD": "+"}


def text_of(*folders):
	files = (path for folder in folders for path in sorted(folder.rglob("*")))
	return "\n".join(path.read_text() for path in files if path.suffix in (".cpp", ".hpp", ".h", ".inc"))


def line_of(name, parents):
	"""The class and its ancestors."""
	yield name
	while name := parents.get(name):
		yield name


def method_lacks(wanted, offered, parents=None):
	"""Methods that are gone, or found by none of their hashes. The engine looks in the class and in its ancestors."""
	for owner, name, hash in sorted(wanted):
		found = next((offered[place, name] for place in line_of(owner, parents or {}) if (place, name) in offered), None)
		if found is None:
			yield f"{owner}.{name} is gone"
		elif int(hash) not in found:
			yield f"{owner}.{name} has changed: {hash} is none of {sorted(found)}"


def map_lacks(ours, theirs, is_wanted=lambda key: True):
	"""Entries of a map of ours that are wanted, and not the same in theirs."""
	for key, value in ours.items():
		if is_wanted(key) and theirs.get(key) != value:
			yield f"{'.'.join(filter(None, map(str, key)))} is {theirs.get(key, 'gone')} instead of {value}"


def class_lacks(found, ours, newer):
	for name in sorted(found.classes):
		if name not in newer.parents:
			yield f"{name} is gone"
		elif ours.parents[name] and ours.parents[name] not in line_of(name, newer.parents):
			yield f"{name} is no {ours.parents[name]} any more"
	for _, name, _ in sorted(found.records["singleton"]):
		if newer.singletons.get(name) != ours.singletons.get(name):
			yield f"the singleton {name} is {newer.singletons.get(name, 'gone')}"


def lacks(found, ours, newer):
	"""Returns kind -> what `newer` lacks of what is looked up; `ours` is the interface that the binding was generated from."""
	names = {name.upper(): name for name, _ in ours.constructors}  # STRINGNAME: StringName

	def builtin(code):
		return names[code.replace("_", "")]

	def called(records):
		return {record for record in records if record[1] in found.words}

	methods = {(builtin(code), name, hash) for code, name, hash in called(found.records["builtin method"])}
	operators = {(OPERATORS[name], builtin(left), builtin(right)) for name, left, right in found.records["operator"]}
	known = {"", *found.classes, *names.values()}

	def is_used(key):
		return key[0] in known and key[1] in found.words

	return {
		"classes": [*class_lacks(found, ours, newer)],
		"methods": [*method_lacks(called(found.records["method"]), newer.methods, newer.parents)],
		"virtual methods": [*method_lacks(found.virtuals, newer.virtuals, newer.parents)],
		"methods of builtin types": [*method_lacks(methods, newer.builtin_methods)],
		"operators": [f"{left} {symbol} {right} is gone" for symbol, left, right in sorted(operators - newer.operators)],
		"constructors": [*map_lacks(ours.constructors, newer.constructors)],
		"layout": [*map_lacks(ours.layout, newer.layout, lambda key: key[0] in known)],
		"functions": [*method_lacks(called(found.records["function"]), newer.functions)],
		"values": [*map_lacks(ours.values, newer.values, is_used)],
		"signals": [*map_lacks(ours.signals, newer.signals, is_used)],
	}


def c_lacks(found, ours, theirs):
	"""Returns what a C interface lacks of the functions that loading demands: a function with other parameters it lacks, too."""
	return [*map_lacks({(name,): ours[name] for name in sorted(found.functions)}, {(name,): kinds for name, kinds in theirs.items()})]


# What is changed in a copy of our own interface -> what has to be found, and only that.
CHANGES = {
	"classes": lambda copied: copied.parents.pop("Image"),
	"methods": lambda copied: copied.methods.update({("Image", "get_width"): {1}}),
	"virtual methods": lambda copied: copied.virtuals.update({("Node", "_get_configuration_warnings"): {1}}),
	"methods of builtin types": lambda copied: copied.builtin_methods.update({("PackedByteArray", "resize"): {1}}),
	"operators": lambda copied: copied.operators.remove(("==", "NodePath", "NodePath")),
	"constructors": lambda copied: copied.constructors.update({("NodePath", 2): ("StringName",)}),
	"layout": lambda copied: copied.layout.update({("Transform3D", ""): 64}),
	"functions": lambda copied: copied.functions.update({("", "is_instance_id_valid"): {1}}),
	"values": lambda copied: copied.values.update({("", "PROPERTY_HINT_RANGE"): 2}),
	"signals": lambda copied: copied.signals.pop(("SceneTree", "node_added")),
}


def self_test(found, ours, c):
	"""(kind, why the check did not find its change) of each."""
	for kind, change in CHANGES.items():
		changed = copy.deepcopy(ours)
		change(changed)
		said = {other: words for other, words in lacks(found, ours, changed).items() if words}
		yield kind, "" if list(said) == [kind] and len(said[kind]) == 1 else f"found {said}"
	said = c_lacks(found, c, {**c, "print_error": c["print_error"][:-1]})
	yield "C functions", "" if len(said) == 1 else f"found {said}"


def main(root, api, description, *others):
	root, api = pathlib.Path(root), pathlib.Path(api)
	found = lookups.lookups(text_of(root / "build/binding"), text_of(root / "extension"))
	ours = lookups.interface(api / "extension_api.json")
	c = lookups.c_functions((api / "gdextension_interface.h").read_text())
	for path in others:
		newer = lookups.interface(pathlib.Path(path))
		for kind, words in lacks(found, ours, newer).items():
			print(f"{newer.version}: {kind}: {'; '.join(words)}")
		if description != "-":
			words = c_lacks(found, c, lookups.c_description(pathlib.Path(description).read_text(), newer.version))
			print(f"{newer.version}: C functions: {'; '.join(words)}")
	for kind, words in self_test(found, ours, c):
		print(f"test: {kind}: {words}")


if __name__ == "__main__":
	main(*sys.argv[1:])
