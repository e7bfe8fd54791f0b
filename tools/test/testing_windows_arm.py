# SPDX-License-Identifier: MIT
"""The layer `windows-arm64`: builds the library for Windows on arm64 and checks it with a reader that is not ours. Nothing loads it."""

import json
import re
import subprocess
import sys

from tools.build import build, zig
from tools.places import ZIG
from tools.say import Failure
from tools.test import testing_platforms
from tools.test.test_runs import Tally

TARGET = ("windows", "arm64")
READER = """
import json, sys
import pefile

file = pefile.PE(sys.argv[1])
print(json.dumps({
	"machine": pefile.MACHINE_TYPE[file.FILE_HEADER.Machine],
	"is_library": file.is_dll(),
	"libraries": [entry.dll.decode().lower() for entry in file.DIRECTORY_ENTRY_IMPORT],
	"offered": [symbol.name.decode() for symbol in file.DIRECTORY_ENTRY_EXPORT.symbols if symbol.name],
}))
"""
# Since Windows 10 each has the universal C runtime, in parts with such names.
RUNTIME = re.compile(r"api-ms-win-crt-[\w-]+\.dll|ucrtbase\.dll")


def read(path):
	"""Returns what pefile reads of a library."""
	zig.ensure()
	result = subprocess.run([sys.executable, "-c", READER, str(path)], env={"PYTHONPATH": str(ZIG)}, capture_output=True, text=True)
	if result.returncode:
		raise Failure(f"pefile cannot read {path.name}: {result.stderr[-500:]}")
	return json.loads(result.stdout)


def expect(condition, text):
	if not condition:
		raise Failure(text)


def is_for_arm64(file):
	expect(file["machine"] == "IMAGE_FILE_MACHINE_ARM64" and file["is_library"], f"it is {file['machine']}, library: {file['is_library']}")


def needs_only_the_system(file):
	others = [name for name in file["libraries"] if name not in testing_platforms.WINDOWS_LIBRARIES and not RUNTIME.fullmatch(name)]
	expect(file["libraries"] and not others, f"it needs {', '.join(others) or 'nothing'}")


def offers_its_entry(file):
	expect(file["offered"] == [testing_platforms.ENTRY], f"it offers {len(file['offered'])}: {', '.join(file['offered'][:5])}")


CHECKS = {
	"windows-arm64: a library for arm64": is_for_arm64,
	"windows-arm64: needs no library that Windows lacks": needs_only_the_system,
	"windows-arm64: offers its entry alone": offers_its_entry,
}


def run_layer(only):
	options = (*testing_platforms.of(TARGET), "target=release", "symbols=yes")  # as it would ship
	build.scons("extension", *options)
	file, tally = read(build.library(*TARGET, dict(option.split("=") for option in options))), Tally()
	testing_platforms.check(tally, only, ((name, lambda action=action: action(file)) for name, action in CHECKS.items()))
	return tally
