# SPDX-License-Identifier: MIT
"""Fails where the binding offers something that no surface file states: what is stated is compiled against upstream, too.

Usage: check_surface.py BINDING_INCLUDE GENERATED_INCLUDE SURFACE_CPP...
Prints a line for each lack, "written: " or "generated: " and what it is. Returns 1 if there is any.
"""

import collections
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import members

# The binding's own machinery, all of it in godot::internal, and what names the types of others.
INTERNAL = {
	"builtin_call", "class_hooks", "engine_class", "forward", "packed_array", "type_code", "variant_pointers", "virtual_bind", "wrapped",
}  # fmt: skip
OWN_MACROS = {"ENGINE_CLASS", "ENGINE_CLASS_DEFINE"}


def lacks(folder, stated, texts):
	"""What the headers in `folder` offer and nothing states."""
	words = set(re.findall(r"\w+", texts))
	for path in sorted(path for path in folder.rglob("*") if path.suffix in (".hpp", ".inc") and path.stem not in INTERNAL):
		if path.name == "gdextension_interface_loader.hpp" or path.name == "variant_builtins.inc":
			continue  # the engine's own functions; a list of types
		text = path.read_text()
		owner = owner_of(path) if path.suffix == ".inc" else ""
		offered = collections.Counter(members.offered(members.plain(text), owner, "public" if owner else None))
		for (name, member), count in offered.items():
			if stated[name, member] < count:
				yield f"{path.name}: {name + '::' if name else ''}{member} is there {count} times, stated {stated[name, member]} times"
		for macro in sorted(members.macros(text) - OWN_MACROS):
			if macro not in words and not macro.startswith("GODOT_VERSION"):
				yield f"{path.name}: the macro {macro} is used by no surface file"


def owner_of(path):
	"""The class that includes gen/node_path.inc is NodePath."""
	return "".join(word.capitalize() for word in path.stem.split("_"))


def main(written, generated, *surfaces):
	texts = "\n".join(pathlib.Path(surface).read_text() for surface in surfaces)
	stated = members.stated([texts])
	found = [("written", lack) for lack in lacks(pathlib.Path(written), stated, texts)]
	found += [("generated", lack) for lack in lacks(pathlib.Path(generated), stated, texts)]
	for kind, lack in found:
		print(f"{kind}: {lack}")
	return 1 if found else 0


if __name__ == "__main__":
	sys.exit(main(*sys.argv[1:]))
