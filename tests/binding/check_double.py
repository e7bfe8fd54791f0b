# SPDX-License-Identifier: MIT
"""Checks that the hashes which generate/precision.py computes are those of double-precision engines.

Usage: check_double.py BINDING extension_api.json
Prints one line for each that is not.
"""

import json
import pathlib
import sys

# From the engine's own table of hashes that older libraries ask for, which tells those of double precision (Godot 4.3 and later,
# core/extension/gdextension_compat_hashes.cpp): initial values of each kind, also beside objects that are none.
KNOWN = {
	("Animation", "bezier_track_insert_key"): 3767441357,
	("EditorNode3DGizmo", "add_mesh"): 2161761131,
	("Node3D", "look_at"): 819337406,
	("Node3D", "look_at_from_position"): 1809580162,
	("PhysicsServer2D", "body_add_shape"): 3597527023,
	("PhysicsServer2D", "body_apply_impulse"): 1124035137,
	("PhysicsServer3D", "area_add_shape"): 183938777,
	("PhysicsServer3D", "body_apply_impulse"): 2238283471,
}


def main(binding, api):
	sys.path.insert(0, binding)
	from generate.precision import as_double

	dump = as_double(json.loads(pathlib.Path(api).read_text()))
	hashes = {(entry["name"], method["name"]): method.get("hash") for entry in dump["classes"] for method in entry.get("methods", [])}
	for (owner, name), known in KNOWN.items():
		if (found := hashes.get((owner, name))) != known:
			print(f"{owner}.{name}: {found} instead of {known}")


if __name__ == "__main__":
	main(*sys.argv[1:])
