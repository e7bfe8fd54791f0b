# SPDX-License-Identifier: MIT
"""The layer `macos`: builds the library for macOS and checks it with a reader that is not ours. Nothing loads it: there is no Mac."""

import json
import re
import subprocess
import sys

from tools.build import build, zig
from tools.places import ZIG
from tools.say import Failure
from tools.test import testing_platforms
from tools.test.test_runs import Tally

OPTIONS = ("platform=macos", "arch=universal", "quick=yes")
# The libraries that every macOS has; zig links its own C++ library into ours.
LIBRARIES = {"/usr/lib/libSystem.B.dylib"}
ENTRY = "_" + testing_platforms.ENTRY
# Of our symbols only the entry, and those that the linker makes; operators new and delete take memory from the system, whoever calls them.
OURS = re.compile(rf"{ENTRY}|__Z(n[aw]|d[al])\w+|__mh_dylib_header|___dso_handle")
OLDEST = 11 << 16  # macOS 11.0, the first for arm64
READER = """
import json, sys
from macholib import mach_o
from macholib.MachO import MachO
from macholib.SymbolTable import SymbolTable

found, file = {}, MachO(sys.argv[1])
for part in file.headers:
	details = {mach_o.LC_NAMES.get(command[0].cmd): command[1] for command in part.commands}
	names = [command[2].rstrip(b"\\0").decode() for command in part.commands if command[0].cmd == mach_o.LC_LOAD_DYLIB]
	own = [command[2].rstrip(b"\\0").decode() for command in part.commands if command[0].cmd == mach_o.LC_ID_DYLIB]
	symbols = SymbolTable(file, part).nlists
	offered = [name.decode() for entry, name in symbols if entry.n_type & 0x0F == 0x0F and not entry.n_type & 0xF0]
	signature = details.get("LC_CODE_SIGNATURE")
	version = details.get("LC_BUILD_VERSION")
	found[mach_o.CPU_TYPE_NAMES[part.header.cputype]] = {
		"type": part.filetype, "name": own, "libraries": names, "offered": offered,
		"signature": signature and signature.datasize, "oldest": version and int(version.minos),
	}
print(json.dumps(found))
"""


def read(path):
	"""Returns processor -> the data that macholib reads from the library's part for it."""
	zig.ensure()
	command = [sys.executable, "-c", READER, str(path)]
	result = subprocess.run(command, env={"PYTHONPATH": str(ZIG)}, capture_output=True, text=True)
	if result.returncode:
		raise Failure(f"macholib cannot read {path.name}: {result.stderr[-500:]}")
	return json.loads(result.stdout)


def expect(condition, text):
	if not condition:
		raise Failure(text)


def is_for_both(parts):
	expect(set(parts) == {"ARM64", "x86_64"}, f"it is for {sorted(parts)}")
	expect(all(part["type"] == "dylib" for part in parts.values()), f"{parts}")


def needs_only_the_system(parts):
	for name, part in parts.items():
		expect(set(part["libraries"]) == LIBRARIES, f"{name} needs {part['libraries']}")


def offers_its_entry(parts):
	for name, part in parts.items():
		strangers = [symbol for symbol in part["offered"] if not OURS.fullmatch(symbol)]
		expect(ENTRY in part["offered"] and not strangers, f"{name} offers {len(part['offered'])}, such as {(strangers or ['nothing'])[0]}")


def is_signed(parts):
	expect(parts["ARM64"]["signature"], "ARM64 has no signature, and such a processor loads nothing without one")


def names_no_folder(parts):
	for name, part in parts.items():
		expect(part["name"] and part["name"][0].startswith("@rpath/"), f"{name} calls itself {part['name']}")


def loads_on_old_systems(parts):
	for name, part in parts.items():
		expect(part["oldest"] == OLDEST, f"{name} asks for {part['oldest']}")


CHECKS = {
	"macos: one file for both processors": is_for_both,
	"macos: needs no library but the system's": needs_only_the_system,
	"macos: offers its entry, and nothing else of ours": offers_its_entry,
	"macos: the part for arm64 is signed": is_signed,
	"macos: loads from macOS 11 on": loads_on_old_systems,
	"macos: names no folder of this machine": names_no_folder,
}


def run_layer(only):
	build.scons("extension", *OPTIONS)
	parts = read(build.library("macos", "universal", dict(option.split("=") for option in OPTIONS)))
	tally = Tally()
	testing_platforms.check(tally, only, ((name, lambda action=action: action(parts)) for name, action in CHECKS.items()))
	return tally
