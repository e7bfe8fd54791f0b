# SPDX-License-Identifier: MIT
"""Generates those sources of extension/binding that follow from the engine's own description of its interface.

They are made while SCons reads the SConstruct, because the list of files is only known then.
"""

import hashlib
import os
import pathlib
import subprocess
import sys

from tools.places import BUILD, ROOT

HERE = ROOT / "extension/binding"
API = BUILD / "api"


def made(precision="single"):
	"""Returns the folder of the binding's generated part."""
	return BUILD / ("binding_double" if precision == "double" else "binding")


def digest(paths, *texts):
	sum = hashlib.sha256("\n".join(texts).encode())
	for path in sorted(paths):
		sum.update(path.read_bytes())
	return sum.hexdigest()


def up_to_date(stamp, state):
	return stamp.is_file() and stamp.read_text() == state


def dump_api(godot):
	"""Asks the engine for extension_api.json and gdextension_interface.h, once for each engine."""
	engine = pathlib.Path(godot).resolve()
	state = f"{engine} {engine.stat().st_mtime_ns}"
	if up_to_date(API / "stamp", state):
		return
	print("  ask     the engine for its interface")
	API.mkdir(parents=True, exist_ok=True)
	command = [godot, "--headless", "--dump-extension-api", "--dump-gdextension-interface"]
	result = subprocess.run(command, cwd=API, capture_output=True, text=True, timeout=300)
	if not (API / "extension_api.json").is_file() or not (API / "gdextension_interface.h").is_file():
		raise RuntimeError(f"The engine did not describe its interface:\n{result.stdout}{result.stderr}")
	(API / "stamp").write_text(state)


def generate(precision):
	"""Runs the generator if it, its list of classes or the engine's interface changed."""
	out = made(precision)
	inputs = [*HERE.rglob("*.py"), *HERE.rglob("*.hpp"), HERE / "classes.json", API / "extension_api.json"]
	state = digest(inputs)
	if up_to_date(out / "stamp", state):
		return
	print("  make    the binding's classes")
	command = [sys.executable, str(HERE / "generator.py"), "--api", str(API / "extension_api.json"), "--precision", precision]
	subprocess.run([*command, "--classes", str(HERE / "classes.json"), "--out", str(out)], check=True)
	(out / "stamp").write_text(state)


def prepare(env, godot):
	"""Adds the binding to `env`; returns its sources, relative to the project."""
	dump_api(godot)
	generate(env["precision"])
	out = made(env["precision"])
	env.Append(CPPPATH=["#extension/binding/include", f"#{out.relative_to(ROOT)}/include"], SYSTEM_INCLUDES=[str(API)])
	files = [*(HERE / "src").rglob("*.cpp"), *(out / "src").rglob("*.cpp")]
	return sorted(str(file.relative_to(ROOT)) for file in files)


def include_folders():
	"""Returns the include paths of the binding, or of the godot-cpp that GODOT_CPP names."""
	upstream = os.environ.get("GODOT_CPP")
	folders = [f"{upstream}/{folder}" for folder in ("include", "gen/include", "gdextension")] if upstream else None
	return folders or [ROOT / "extension/binding/include", made() / "include", API]
