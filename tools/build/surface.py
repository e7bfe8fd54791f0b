# SPDX-License-Identifier: MIT
"""The surface of godot-cpp that the extension may use (tests/binding), compiled against the binding or a real godot-cpp."""

import pathlib
import sys

from tools.build import binding
from tools.places import ROOT

HERE = ROOT / "tests/binding"
GENERATED = "build/binding_surface/surface_generated.cpp"


def objects(env, variant, godot):
	"""Returns the objects of the surface files; they are compiled, never linked."""
	binding.dump_api(godot)
	scripts = [str(HERE / name) for name in ("generated.py", "members.py")]
	inputs = [str(binding.API / "extension_api.json"), str(binding.HERE / "classes.json"), str(binding.HERE / "include")]
	command = [sys.executable, scripts[0], *inputs, "$TARGET"]
	generated = env.Command(f"#{GENERATED}", [*scripts, *inputs[:2]], [command])
	env.Depends(generated, [str(path) for path in sorted((binding.HERE / "include").rglob("*.hpp"))])
	surface = env.Clone()
	surface.Append(CPPPATH=["#tests/binding"])
	surface["CCFLAGS"] = [flag for flag in surface["CCFLAGS"] if flag not in ("-O2", "-g1")] + ["-O0"]
	files = [*sorted(str(path.relative_to(ROOT)) for path in HERE.glob("*.cpp")), GENERATED]
	return [surface.Object(f"#build/{variant}/surface/{pathlib.Path(file).stem}", f"#{file}") for file in files]
