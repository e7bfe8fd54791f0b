# SPDX-License-Identifier: MIT
"""The layer `binding`: our binding offers what godot-cpp offers and nothing else. Each group of its surface counts one."""

import os
import re
import subprocess
import sys

from tools import machine
from tools.places import BUILD, ROOT

HERE = ROOT / "tests/binding"
GENERATED = BUILD / "binding_surface/surface_generated.cpp"
BINDING = ROOT / "extension/binding/include"


def run(only):
	"""(names of what passed, names and reasons of what failed)."""
	results = {name: reason for name, reason in (*compiled(), *complete()) if only in name}
	for name, reason in results.items():
		print(f"{'fail' if reason else 'pass':>6} {name}{': ' + reason if reason else ''}", flush=True)
	return [name for name, reason in results.items() if not reason], [f"{name}: {reason}" for name, reason in results.items() if reason]


def compiled():
	"""Every surface file against the binding, or against what GODOT_CPP names."""
	command, additions = machine.scons()
	environment = {**os.environ, **additions, "PYTHONDONTWRITEBYTECODE": "1"}
	result = subprocess.run([*command, "-Q", "-k", "binding_surface"], cwd=ROOT, env=environment, capture_output=True, text=True)
	print(result.stdout + result.stderr, end="")
	failed = set(re.findall(r"/surface/(surface_\w+)\.o\] Error", result.stdout + result.stderr))
	for name in sorted({path.stem for path in HERE.glob("*.cpp")} | {GENERATED.stem}):
		yield f"binding/{name}", "it does not compile; the lines above say where" if name in failed else ""
	if result.returncode and not failed:
		yield "binding/build", f"SCons ended with code {result.returncode}"


def complete():
	"""Whether the surface files state all that the headers offer."""
	surfaces = [str(path) for path in (*sorted(HERE.glob("*.cpp")), GENERATED)]
	command = [sys.executable, str(HERE / "check_surface.py"), str(BINDING), str(BUILD / "binding/include"), *surfaces]
	result = subprocess.run(command, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}, capture_output=True, text=True)
	print(result.stdout + result.stderr, end="")
	for kind in ("written", "generated"):
		lacks = re.findall(rf"^{kind}: (.*)$", result.stdout, re.M)
		broken = result.returncode not in (0, 1) or (result.returncode and not result.stdout)
		yield f"binding/{kind}_headers_are_stated", "; ".join(lacks) or ("the check itself failed" if broken else "")
