# SPDX-License-Identifier: MIT
"""`./grass tidy`: clang-tidy over C++ sources, those that are named or those that changed. Some ten seconds a file, so no layer does it."""

import subprocess

from tools import docs_tests, machine, toolchains
from tools.packages import CROSS
from tools.places import BUILD, ROOT
from tools.say import Failure, say

VERSION = "14"  # Debian 12's, as of clang-format


def clang_tidy():
	return toolchains.tool(f"clang-tidy-{VERSION}")


def changed():
	"""C++ sources that differ from the last commit, or are not in it."""
	command = ["git", "status", "--porcelain", "--untracked-files=all", "--", "extension", "tests"]
	lines = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
	return [path for path in (line[3:].split(" -> ")[-1] for line in lines if line[:2].strip() != "D") if path.endswith(".cpp")]


def run(files):
	"""Returns the exit code: 1 where something was found."""
	machine.ensure(*machine.BUILDING, (clang_tidy, (f"clang-tidy-{VERSION}", f"libclang-common-{VERSION}-dev", "patchelf"), CROSS))
	if not (BUILD / "gen/class_docs.gen.h").exists():
		raise Failure("Build once before: `./grass build`.")
	system = [machine.eigen(), machine.doctest(), *map(str, docs_tests.include_folders())]
	folders = ["extension", "shaders", "build/gen", "tests/unit", "tests/fuzz", "tests/stress", "tests/binding"]
	flags = ["-std=c++20", *(f"-I{folder}" for folder in folders), *(f"-isystem{folder}" for folder in system)]
	defines = ["-DGDEXTENSION", "-DLINUX_ENABLED", "-DUNIX_ENABLED", "-DTHREADS_ENABLED"]
	failed = 0
	for file in files or changed():
		say(f"clang-tidy {file}")
		failed |= subprocess.run([clang_tidy(), "--quiet", file, "--", *flags, *defines], cwd=ROOT, stderr=subprocess.DEVNULL).returncode
	return 1 if failed else 0
