# SPDX-License-Identifier: MIT
"""Where things lie in the project. Nothing is written outside of these folders, except what the user names."""

import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"  # everything that is compiled or generated
OUT = ROOT / "out"  # what the demo and the benchmark write: pictures and tables
PROJECT = ROOT / "godot_project"
ADDON_BIN = PROJECT / "addons/grass_field/bin"

TOOLS = ROOT / ".tools"  # what was fetched because the machine lacks it
UNPACKED = TOOLS / "root"  # the fetched packages, laid out as under /
ZIG = TOOLS / "zig"  # the compiler for macOS, from PyPI, and the reader of what it makes
CROSS = TOOLS / "cross"  # compilers for other platforms, and what runs their programs
DRIVERS = TOOLS / "drivers"  # compilers of GPUs' drivers, and what reads shaders
