# SPDX-License-Identifier: MIT
"""clang-tidy: `./grass tidy` and the layer `tidy` over the extension, `./grass tidy FILE...` over these sources.

Most of clang-tidy's time goes into headers, Eigen's and the binding's: sources are looked at by the dozen, included by one.
"""

import concurrent.futures
import os
import re
import subprocess

from tools.build import binding, toolchains, unity
from tools.fetch import machine
from tools.fetch.roots import CROSS
from tools.places import BUILD, ROOT
from tools.say import Failure, progress

PLACE = "build/tidy"
MOST = 200  # files that are looked at as one
APART = ("binding", "old_glibc")  # the engine's interface, in godot-cpp's ways; a few symbols for the linker
INCLUDES_SOURCES = "-bugprone-suspicious-include"  # it does so on purpose


def clang_tidy():
	return toolchains.tool(f"clang-tidy-{toolchains.CLANG}")


def ensure():
	machine.ensure(
		*machine.BUILDING, (clang_tidy, (f"clang-tidy-{toolchains.CLANG}", f"libclang-common-{toolchains.CLANG}-dev", "patchelf"), CROSS)
	)
	if not (BUILD / "gen/class_docs.gen.h").exists():
		raise Failure("Build once before: `./grass build`.")


def flags():
	system = [machine.eigen(), machine.doctest(), *map(str, binding.include_folders())]
	folders = ["extension", "shaders", "build/gen", "tests/unit", "tests/fuzz", "tests/stress", "tests/binding"]
	defines = ["-DGDEXTENSION", "-DLINUX_ENABLED", "-DUNIX_ENABLED", "-DTHREADS_ENABLED"]
	return ["-std=c++20", *(f"-I{folder}" for folder in folders), *(f"-isystem{folder}" for folder in system), *defines]


def parts():
	"""Sources to look at, each with a name for it: some of many files of the core or of the rest, and what the build keeps alone."""
	sources = (path.relative_to(ROOT) for path in (ROOT / "extension").rglob("*.cpp"))
	files = unity.across_folders([str(path) for path in sources if path.parts[1] not in APART], PLACE, MOST)
	return {file: re.sub(rf"^{PLACE}/|\.cpp$", "", file).replace("/", "_").removeprefix("extension_") for file in files}


def look(file, more=()):
	"""The messages of clang-tidy about a source, with paths from the project's root; if there are none but it failed, the reason."""
	command = [clang_tidy(), "--quiet", *more, file, "--", *flags()]
	result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
	if result.returncode and not result.stdout:
		return result.stderr[-2000:]
	return re.sub(r"^(/[^:\n]+)", lambda found: os.path.relpath(found[1], ROOT), result.stdout, flags=re.MULTILINE)


def look_at_parts(only=""):
	"""Yields (name, what clang-tidy says) of each part whose name contains `only`, as many at a time as there are processors."""
	ensure()
	chosen = {file: name for file, name in parts().items() if only in f"tidy/{name}"}
	with progress("Running clang-tidy"), concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
		running = {pool.submit(look, file, [f"--checks={INCLUDES_SOURCES}"]): name for file, name in chosen.items()}
		for done in concurrent.futures.as_completed(running):
			yield running[done], done.result()


def layer(only, tally):
	"""The layer `tidy`: a test for each part. Returns `tally`."""
	for name, said in look_at_parts(only):
		print(f"{'fail' if said else 'pass':>6} tidy/{name}", flush=True)
		if said:
			print(said, flush=True)
			tally.failed.append(f"tidy/{name}: {said.splitlines()[0]}")
		else:
			tally.passed += 1
	return tally


def run(files):
	"""Returns the exit code: 1 if something was found."""
	ensure()
	found = [look(file) for file in files] if files else [said for _, said in look_at_parts()]
	print("".join(found), end="")
	return 1 if any(found) else 0
