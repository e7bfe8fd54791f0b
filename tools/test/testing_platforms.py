# SPDX-License-Identifier: MIT
"""Layers of tests for other platforms: libraries and programs for them are checked, loaded and run here, under Wine and qemu.

`windows` and `arm64` run all that can be run; `riscv` loads the library, and compares bits, also with the recorded ones; `platforms`,
a part of every run, loads what is little optimised. `double` does so with the library for engines in double precision, of which
`platforms` checks the binding alone.
"""

import os
import pathlib
import platform
import re
import subprocess
import tempfile
from unittest import mock

from tools.build import build, names, toolchains
from tools.fetch import machine
from tools.fetch.roots import ENGINE_ARM64, GLIBC, RISCV
from tools.places import ADDON_BIN, BUILD, ROOT
from tools.run import engine
from tools.say import Failure, progress
from tools.test.test_runs import Tally, core, in_engine

LAYERS = ("platforms", "windows", "arm64", "riscv", "double")
WINDOWS, ARM64, RV64 = ("windows", "x86_64"), ("linux", "arm64"), ("linux", "rv64")
ENTRY, CROSSING_ENTRY = "grass_field_library_init", "crossing_init"
LOAD_LIMIT, STEP_LIMIT = 300, 3600  # seconds
# The libraries that every Windows has.
WINDOWS_LIBRARIES = {"kernel32.dll", "msvcrt.dll", "user32.dll", "advapi32.dll", "ws2_32.dll", "bcrypt.dll", "shell32.dll", "ntdll.dll"}
ARM64_ENGINE = (lambda: engine_arm64() if engine_arm64().exists() else None, ("godot",), ENGINE_ARM64)
# The tests that run in the engine for arm64, where GDScript is about fifty times slower: growing, waking, bending, going to rest.
ARM64_HEADLESS = ("/test_field.", "/test_bodies.", "test_nothing_moves_when_a_tile")


def engine_arm64():
	return ENGINE_ARM64.place / "usr/bin/godot"


def library(target, quick):
	return (names.folder(*target) / "quick" if quick else ADDON_BIN) / names.library(*target)


def program(target, name):
	return names.program(*target, name)


def runner(target):
	"""Returns (command prefix, environment additions) to run a program for `target` here."""
	if target == WINDOWS:
		quiet = {"WINEPREFIX": str(BUILD / "wine"), "WINEARCH": "win64", "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml="}
		return [toolchains.tool("wine64")], {**quiet, "DISPLAY": "", "WAYLAND_DISPLAY": ""}
	if target == ARM64:
		return [toolchains.tool("qemu-aarch64-static"), "-L", str(GLIBC["arm64"].place)], {"GRASS_EMULATED": "1"}
	if target == RV64:
		return [toolchains.tool("qemu-riscv64-static"), "-L", str(RISCV.place / "usr" / toolchains.GNU["rv64"])], {"GRASS_EMULATED": "1"}
	# Here: with the C library of 2020, if the library was linked against it.
	place = toolchains.glibc(target[1])
	if place is None or not toolchains.can_link_old_glibc(*target):
		return [], {}
	libraries = place / "usr/lib" / toolchains.GNU[target[1]]
	return [str(next(libraries.glob("ld-2*.so"))), "--library-path", str(libraries)], {}


def run(target, *arguments, limit=LOAD_LIMIT):
	"""Runs a program for `target`. Returns its output; raises Failure if it fails."""
	command, additions = runner(target)
	try:
		result = subprocess.run(
			[*command, *map(str, arguments)], capture_output=True, timeout=limit, stdin=subprocess.DEVNULL, env={**os.environ, **additions}
		)
	except subprocess.TimeoutExpired:
		raise Failure(f"still running after {limit} s") from None
	if result.returncode:
		words = (result.stdout[-500:] + result.stderr[-2000:]).decode(errors="replace").strip()
		raise Failure(f"ended with code {result.returncode}: {words}")
	return result.stdout.decode()


def registered(target, quick=False):
	"""Returns the classes that the library for `target` registers, as listed by the host. Raises Failure if it does not load."""
	return run(target, program(target, "host/host"), library(target, quick), ENTRY)


def in_double(library, entry, *options):
	"""What this machine's host says that has the vectors of a double-precision engine. Raises Failure if the library does not load."""
	return run(toolchains.HERE, BUILD / "host-double/host", library, entry, *options)


def refused(action):
	"""Raises Failure unless a library says that it is for the other precision."""
	try:
		action()
	except Failure as failure:
		if "This library is for an engine in" in str(failure):
			return
		raise
	raise Failure("it loads")


def double_checks(whole):
	"""(name, function that raises Failure) of the checks of what is built for engines in double precision."""
	single, crossing = library(toolchains.HERE, False), BUILD / "quick-double/libcrossing.so"
	double = single.with_name(single.name.replace("template_debug", "template_debug.double"))
	if whole:
		yield (
			"double: registers what the library in single precision does",
			lambda: same_lines(registered(toolchains.HERE), in_double(double, ENTRY)),
		)
		yield "double: a world 10,000 km away knows the plots of places", lambda: in_double(double, ENTRY, "far")
		return
	yield "double: vectors cross with all their digits", lambda: in_double(crossing, CROSSING_ENTRY, "far")
	yield "double: an engine in double precision is refused by a library in single", lambda: refused(lambda: in_double(single, ENTRY))
	yield (
		"double: an engine in single precision is refused by a library in double",
		lambda: refused(lambda: run(toolchains.HERE, program(toolchains.HERE, "host/host"), crossing, CROSSING_ENTRY)),
	)


def same_lines(here, there):
	"""Raises Failure unless both texts are the same, and long."""
	ours, theirs = here.splitlines(True), there.splitlines(True)
	if len(ours) < 100:
		raise Failure(f"only {len(ours)} lines are listed: {ours}")
	for line, (one, other) in enumerate(zip(ours, theirs), 1):
		if one != other:
			raise Failure(f"line {line} is {other!r}, on this machine {one!r}")
	if len(ours) != len(theirs):
		raise Failure(f"{len(theirs)} lines instead of {len(ours)}")


def same_registration(target, quick):
	same_lines(registered(toolchains.HERE), registered(target, quick))


def same_bits(target):
	here = subprocess.run([program(toolchains.HERE, "bits/bits")], capture_output=True, text=True, check=True).stdout
	there = run(target, program(target, "bits/bits"), limit=STEP_LIMIT)
	same_lines(here, there.replace("\r\n", "\n"))  # programs for Windows end lines so


def dump(target, option, quick):
	command = [toolchains.objdump(*target), option, str(library(target, quick))]
	return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def only_windows_libraries(quick):
	names = {name.lower() for name in re.findall(r"DLL Name: (\S+)", dump(WINDOWS, "-p", quick))}
	if not names or names - WINDOWS_LIBRARIES:
		raise Failure(f"imports {', '.join(sorted(names - WINDOWS_LIBRARIES)) or 'nothing'}")


def only_old_glibc(target, quick):
	text = dump(target, "-p", quick)
	versions = {tuple(map(int, version.split("."))) for version in re.findall(r"\bGLIBC_([\d.]+)", text)}
	needed = set(re.findall(r"NEEDED\s+(\S+)", text))
	if not versions or max(versions) > toolchains.GLIBC_MOST[target[1]]:
		raise Failure(f"needs glibc {'.'.join(map(str, max(versions, default=())))}")
	if others := {name for name in needed if not re.match(r"(libc|libm|libdl|libpthread|ld-linux\S*)\.so", name)}:
		raise Failure(f"needs {', '.join(sorted(others))}")


def checks(target, quick):
	"""(name, function that raises Failure) of each check."""
	kind = "windows" if target == WINDOWS else target[1]
	if target == WINDOWS:
		yield f"{kind}: needs no library that Windows lacks", lambda: only_windows_libraries(quick)
	else:
		yield (
			f"{kind}: needs glibc {'.'.join(map(str, toolchains.GLIBC_MOST[target[1]]))} at most, and no libstdc++",
			lambda: only_old_glibc(target, quick),
		)
	if target != toolchains.HERE:
		yield f"{kind}: loads, and registers what the library for this machine does", lambda: same_registration(target, quick)
	if target != toolchains.HERE and not quick:
		yield f"{kind}: steps 100 random scenes to the bits that they have on this machine", lambda: same_bits(target)


def finds_an_ndk():
	"""Raises Failure unless the NDK that the environment names is taken, of several in an SDK the newest."""
	system = f"toolchains/llvm/prebuilt/{platform.system().lower()}-x86_64/bin"
	with tempfile.TemporaryDirectory() as place, mock.patch.dict(os.environ):
		for name in ("CXX", "ANDROID_NDK_ROOT"):
			os.environ.pop(name, None)
		os.environ["ANDROID_HOME"] = place
		if found := toolchains.compiler("android", "arm64"):
			raise Failure(f"an empty SDK has {found}")
		for version in ("9.0.1", "28.1.13356709", "27.3.5"):
			folder = pathlib.Path(place, "ndk", version, system)
			folder.mkdir(parents=True)
			(folder / "clang++").touch()
		newest, named = (pathlib.Path(place, "ndk", version) for version in ("28.1.13356709", "27.3.5"))
		for folder, arch, target in ((newest, "arm64", "aarch64-linux-android24"), (named, "x86_64", "x86_64-linux-android24")):
			expected = f"{folder / system}/clang++ --target={target}"
			if (found := toolchains.compiler("android", arch)) != expected:
				raise Failure(f"{found} instead of {expected}")
			os.environ["ANDROID_NDK_ROOT"] = str(named)


def says_what_is_missing(system, words):
	"""Raises Failure unless a build for `system`, whose toolchain this machine lacks, ends with `words`."""
	command, additions = machine.scons()
	kept = {name: value for name, value in os.environ.items() if not name.startswith("ANDROID_") and name != "CXX"}
	command = [*command, "-Q", f"platform={system}", "arch=arm64"]
	result = subprocess.run(command, cwd=ROOT, env={**kept, **additions}, capture_output=True, text=True)
	if result.returncode == 0 or words not in result.stdout:
		raise Failure(f"code {result.returncode}: {result.stdout[-500:]}{result.stderr[-500:]}")


def phone_checks():
	yield "android: an NDK is found by what the environment names", finds_an_ndk
	yield "android: a build without an NDK says what to name", lambda: says_what_is_missing("android", "ANDROID_NDK_ROOT names the folder")
	if platform.system() != "Darwin":
		yield "ios: a build without Xcode says what it lacks", lambda: says_what_is_missing("ios", "Xcode on a Mac has it")


def check(tally, only, every):
	"""Runs the checks, adds them to `tally`."""
	for name, action in every:
		if only not in name:
			continue
		try:
			action()
			tally.passed += 1
			print(f"  pass {name}", flush=True)
		except Failure as failure:
			tally.failed.append(f"{name}: {failure}")
			print(f"  fail {name}: {failure}", flush=True)


def by_clang(target):
	"""The option that builds the library for arm64 that only loads with clang: it takes half of GCC's time, and sees what GCC does not."""
	return [f"cxx={toolchains.clang_for_arm64()}"] if target == ARM64 != toolchains.HERE else []


def of(target):
	"""Returns the options that build for `target`."""
	return (f"platform={target[0]}", f"arch={target[1]}")


def prepare(layers):
	"""Fetches and builds everything that `layers` need."""
	if not set(layers) & set(LAYERS):
		return
	targets = [target for name, target in (("windows", WINDOWS), ("arm64", ARM64)) if {name, "platforms"} & set(layers)]
	machine.ensure(
		*([toolchains.WINE] if WINDOWS in targets else []),
		*([toolchains.QEMU] if ARM64 in targets else []),
		*([toolchains.QEMU_RISCV, *toolchains.needs(*RV64)] if "riscv" in layers else []),
		*([toolchains.CLANG_NEED] if "platforms" in layers else []),
		*(need for target in targets for need in toolchains.needs(*target)),
		*([ARM64_ENGINE] if "arm64" in layers else []),
	)
	build.scons("extension", "host", *(["bits"] if {"windows", "arm64", "riscv"} & set(layers) else []))
	if "double" in layers:
		build.scons("extension", "precision=double")
		build.scons("host", "precision=double", "quick=yes")
	if "riscv" in layers:
		build.scons("extension", "host", "bits", "golden", *of(RV64))
	if "platforms" in layers:
		build.scons("crossing", "host", "precision=double", "quick=yes")
	for layer, target in (("windows", WINDOWS), ("arm64", ARM64)):
		options = of(target)
		if "platforms" in layers:
			build.scons("extension", "host", "quick=yes", *options, *by_clang(target))
		if layer in layers:
			build.scons("extension", "host", "bits", "unit", *(["stress"] if layer == "windows" else []), *options)


def run_layer(layer, only):
	tally = Tally()
	if layer == "platforms":
		if toolchains.can_link_old_glibc(*toolchains.HERE):
			check(tally, only, checks(toolchains.HERE, False))
		else:
			tally.skipped.append("platforms: needs glibc 2.31 at most (this machine's compiler links against its own, newer one)")
		for target in (WINDOWS, ARM64):
			check(tally, only, checks(target, True))
		check(tally, only, double_checks(False))
		check(tally, only, phone_checks())
		return tally
	if layer == "double":
		check(tally, only, double_checks(True))
		return tally
	target = {"windows": WINDOWS, "arm64": ARM64, "riscv": RV64}[layer]
	check(tally, only, checks(target, False))
	command, additions = runner(target)
	for name in {WINDOWS: ("unit", "stress"), ARM64: ("unit",), RV64: ("golden",)}[target]:
		tests = [*command, str(program(target, f"{name}/{name}_tests"))]
		tally.add(core(name, only, tests, additions, f"{layer} {name}", slow=target != WINDOWS))
	if target == ARM64:
		tally.add(in_arm64_engine(only))
	return tally


def in_arm64_engine(only):
	"""Runs a few of the headless tests in Debian's engine for arm64."""
	engine.import_project()
	command = [toolchains.tool("qemu-aarch64-static"), "-L", str(ENGINE_ARM64.place), str(engine_arm64()), "--headless"]
	with progress("Running the engine for arm64"):
		tests = only or ",".join(ARM64_HEADLESS)
		return in_engine("headless", command, {}, tests, bool(only), "arm64 headless", more=("--limit=1200",))
