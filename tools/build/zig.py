# SPDX-License-Identifier: MIT
"""The compiler for systems whose own toolchain cannot be fetched: macOS, without Apple's SDK, and Windows on arm64."""

import os

from tools.fetch import pip_packages
from tools.places import ROOT, TOOLS, ZIG

TARGETS = {  # by zig's names; of macOS the oldest that the library loads on
	("macos", "x86_64"): "x86_64-macos.11.0",
	("macos", "arm64"): "aarch64-macos.11.0",
	("windows", "arm64"): "aarch64-windows-gnu",
}
CACHE = TOOLS / "zig_cache"


def is_for(system, arch):
	"""Returns whether it builds for `system` and `arch`, if the user names no toolchain of his own."""
	return (system, arch) in TARGETS and not os.environ.get("CXX")


def compiler(system, arch):
	"""Returns the command. None if it is not fetched yet."""
	return f"{ZIG}/ziglang/zig c++ -target {TARGETS[system, arch]}" if (ZIG / "ziglang/zig").exists() else None


def ensure():
	"""Fetches the compiler, and the reader of what it makes for macOS."""
	pip_packages.ensure(ROOT / "tools/build/zig_requirements.txt", ZIG, "the compiler for macOS and for Windows on arm64")


def environment():
	return {"ZIG_GLOBAL_CACHE_DIR": str(CACHE), "ZIG_LOCAL_CACHE_DIR": str(CACHE)}
