# SPDX-License-Identifier: MIT
"""The names of what is built for a platform: folders of objects and programs, files of libraries, as godot-cpp calls them."""

import platform

from tools.places import BUILD

HERE = (
	{"Linux": "linux", "Windows": "windows", "Darwin": "macos"}.get(platform.system(), "linux"),
	{"aarch64": "arm64", "AMD64": "x86_64", "riscv64": "rv64"}.get(platform.machine(), platform.machine()),
)
SUFFIXES = {"linux": "so", "windows": "dll", "macos": "dylib", "android": "so", "ios": "dylib", "web": "wasm"}  # of libraries
PROGRAMS = {"windows": ".exe", "web": ".js"}  # suffixes of programs, where they have one


def folder(system, arch, threads=True):
	"""Returns the folder of objects and programs: for this machine it is build/ itself."""
	return BUILD if (system, arch) == HERE else BUILD / f"{system}_{arch}{'' if threads else '_nothreads'}"


def program(system, arch, name, threads=True):
	"""Returns the path of a program, such as host/host."""
	return folder(system, arch, threads) / f"{name}{PROGRAMS.get(system, '')}"


def flavour(system, arch, kind="debug", precision="single", threads=True):
	"""Returns the part of a library's name that says what it is for. `threads`: of the engine; only Web has one without."""
	return f"{system}.template_{kind}{'.double' if precision == 'double' else ''}.{arch}{'' if threads else '.nothreads'}"


def has_symbols(system, arch):
	"""Returns whether its libraries come with symbols that can be split off: those that GCC makes."""
	return system == "linux" or (system, arch) == ("windows", "x86_64")


def library(system, *more, **options):
	"""Returns the name of the library's file, for what flavour() takes."""
	return f"libgrass_field.{flavour(system, *more, **options)}.{SUFFIXES[system]}"
