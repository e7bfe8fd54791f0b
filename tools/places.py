# SPDX-License-Identifier: MIT
"""The folders of the project. Nothing is written outside of them, except where the user says."""

import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"  # everything that is compiled or generated
OUT = ROOT / "out"  # pictures and tables of the demo and the benchmarks
PROJECT = ROOT / "godot_project"
ADDON_BIN = PROJECT / "addons/grass_field/bin"

TOOLS = ROOT / ".tools"  # everything that was fetched because the machine lacks it
UNPACKED = TOOLS / "root"  # the fetched packages, laid out as under /
ZIG = TOOLS / "zig"  # the compiler for macOS, from PyPI, and the reader of what it makes
CROSS = TOOLS / "cross"  # compilers for other platforms, and programs that run what they make
RISCV = TOOLS / "riscv"  # the compiler for RISC-V, and what runs its programs
DRIVERS = TOOLS / "drivers"  # compilers of GPUs' drivers, and programs that read shaders
EMSCRIPTEN = TOOLS / "emscripten"  # the compiler for Web, packed by Debian
WEB_TEMPLATE = TOOLS / "web_template"  # the engine for Web, built from Debian's sources
BROWSER = TOOLS / "browser"  # Chromium, which opens the page
NODE = TOOLS / "node"  # Node.js, from PyPI, which runs what it makes
CSHARP = TOOLS / "csharp"  # a C# compiler, and what runs C# programs
