# SPDX-License-Identifier: MIT
"""The layer `binding`: our binding offers a part of godot-cpp and nothing else, works in the engine, and finds everything that it calls in
other versions of Godot. Each group of its surface counts one, and so does each test case that runs and each kind of looked up names."""

import os
import re
import shutil
import subprocess
import sys

from tools import locks
from tools.fetch import godot_interfaces, machine
from tools.places import BUILD, ROOT
from tools.run import engine
from tools.say import Failure

HERE = ROOT / "tests/binding"
GENERATED = BUILD / "binding_surface/surface_generated.cpp"
BINDING = ROOT / "extension/binding/include"
RUN = BUILD / "binding_tests"  # the project of the tests that run, and their library
RUN_LIMIT = 300  # seconds


class Skip(str):
	"""The reason why something was not checked."""


def run(only):
	"""Returns (names of passed checks, names and reasons of failed ones, names and reasons of skipped ones)."""
	parts = (*compiled(), *complete(), *working(), *elsewhere(), *in_double())
	results = {name: reason for name, reason in parts if only in name}
	for name, reason in results.items():
		word = "skip" if isinstance(reason, Skip) else "fail" if reason else "pass"
		print(f"{word:>6} {name}{': ' + reason if reason else ''}", flush=True)
	skipped = [f"{name}: {reason}" for name, reason in results.items() if isinstance(reason, Skip)]
	failed = [f"{name}: {reason}" for name, reason in results.items() if reason and not isinstance(reason, Skip)]
	return [name for name, reason in results.items() if not reason], failed, skipped


def compiled():
	"""Compiles every surface file against the binding, or against the godot-cpp that GODOT_CPP names."""
	command, additions = machine.scons()
	environment = {**os.environ, **additions, "PYTHONDONTWRITEBYTECODE": "1"}
	with locks.alone("scons"):
		result = subprocess.run([*command, "-Q", "-k", "binding_surface"], cwd=ROOT, env=environment, capture_output=True, text=True)
	print(result.stdout + result.stderr, end="")
	failed = set(re.findall(r"/surface/(surface_\w+)\.o\] Error", result.stdout + result.stderr))
	for name in sorted({path.stem for path in HERE.glob("*.cpp")} | {GENERATED.stem}):
		yield f"binding/{name}", "it does not compile; the lines above say where" if name in failed else ""
	if result.returncode and not failed:
		yield "binding/build", f"SCons ended with code {result.returncode}"


def complete():
	"""Checks that the surface files state everything that the headers offer."""
	surfaces = [str(path) for path in (*sorted(HERE.glob("*.cpp")), GENERATED)]
	command = [sys.executable, str(HERE / "check_surface.py"), str(BINDING), str(BUILD / "binding/include"), *surfaces]
	result = subprocess.run(command, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}, capture_output=True, text=True)
	print(result.stdout + result.stderr, end="")
	for kind in ("written", "generated"):
		lacks = re.findall(rf"^{kind}: (.*)$", result.stdout, re.M)
		broken = result.returncode not in (0, 1) or (result.returncode and not result.stdout)
		yield f"binding/{kind}_headers_are_stated", "; ".join(lacks) or ("the check itself failed" if broken else "")


def working():
	"""Runs the test cases of tests/binding/runtime in the engine."""
	cases = [name for path in sorted(HERE.glob("runtime/*.cpp")) for name in re.findall(r'^TEST_CASE\("(.+)"\)', path.read_text(), re.M)]
	command, additions = machine.scons()
	environment = {**os.environ, **additions, "PYTHONDONTWRITEBYTECODE": "1"}
	with locks.alone("scons"):
		code = subprocess.run([*command, "-Q", "binding_tests"], cwd=ROOT, env=environment).returncode
	if code:
		yield "binding/runtime", "it does not build; the lines above say where"
		return
	for path in (HERE / "project").iterdir():
		shutil.copy(path, RUN)
	(RUN / ".godot").mkdir(exist_ok=True)
	(RUN / ".godot/extension_list.cfg").write_text("res://binding_tests.gdextension\n")
	program, additions = engine.headless()
	said = []
	try:
		code = engine.run([*program, "--path", str(RUN), "--script", "res://main.gd"], additions, said.append, RUN_LIMIT)
	except Failure as failure:
		code = str(failure)
	text = "\n".join(said)
	ran = re.search(r"test cases:\s*(\d+)\s*\|", text)
	complete = ran and int(ran[1]) == len(cases)
	blocks = [block for block in re.split(r"^=+$", text, flags=re.M) if "ERROR" in block]
	for name in cases:
		reports = [" ".join(block.split()) for block in blocks if f"TEST CASE:  {name}" in block]
		yield f"binding/runtime {name}", reports[0] if reports else "" if complete else f"the engine ended with {code}: {text[-500:]}"
	leaks = [line for line in said if re.search(r"leaked at exit|still in use at exit|were leaked", line)]
	failed = any(f"TEST CASE:  {name}" in block for name in cases for block in blocks)
	yield "binding/runtime ends cleanly", "; ".join(leaks) or ("" if code == (1 if failed else 0) else f"the engine ended with {code}")


def in_double():
	"""Checks how methods of double-precision engines are found, of which there is none here."""
	command = [sys.executable, str(HERE / "check_double.py"), str(ROOT / "extension/binding"), str(BUILD / "api/extension_api.json")]
	result = subprocess.run(command, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}, capture_output=True, text=True)
	said = (result.stdout + result.stderr).strip()
	yield (
		"binding/hashes of double-precision engines",
		"; ".join(said.splitlines()) or ("it ends with an error" if result.returncode else ""),
	)


def elsewhere():
	"""Checks that each version of Godot, from the first that the binding is made for to the newest published one, has everything that the
	binding looks up."""
	ours = re.search(r'"version_major": (\d+),\s*"version_minor": (\d+)', (BUILD / "api/extension_api.json").read_text())
	versions, description = godot_interfaces.published((int(ours[1]), int(ours[2])))
	if not versions:
		lacking = f"no interface from {ours[1]}.{ours[2]} on is published" if description else "there is no cargo to fetch their interfaces"
		yield "binding/other versions of Godot", Skip(f"{lacking} (GODOT_API=extension_api.json names one)")
	command = [
		sys.executable,
		str(HERE / "check_interface.py"),
		str(ROOT),
		str(BUILD / "api"),
		str(description or "-"),
		*map(str, versions),
	]
	result = subprocess.run(command, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}, capture_output=True, text=True)
	for version, kind, reason in re.findall(r"^(\S+): ([^:]+): (.*)$", result.stdout, re.M):
		of = "finds a change in" if version == "test" else f"Godot {version} has our"
		yield f"binding/{of} {kind}", reason
	if result.returncode:
		yield "binding/other versions of Godot", f"the check itself failed: {result.stderr[-1000:]}"
