# SPDX-License-Identifier: MIT
"""The differences between platforms: compiler, names, defines, linked libraries."""

import shutil
from dataclasses import dataclass

from SCons.Variables import EnumVariable

from tools.build import toolchains
from tools.places import BUILD, ROOT, TOOLS

PRECISIONS = ("single", ("single", "double"))  # the default first
ARCHITECTURES = ("x86_64", "arm64", "universal", "wasm32")


@dataclass(frozen=True)
class Platform:
	suffix: str  # of a library
	defines: tuple  # those of godot-cpp, whose headers ask for them
	program: str = ""  # suffix of a program


PLATFORMS = {
	"linux": Platform(".so", ("LINUX_ENABLED", "UNIX_ENABLED")),
	"windows": Platform(".dll", ("WINDOWS_ENABLED",), ".exe"),
	"macos": Platform(".dylib", ("MACOS_ENABLED", "UNIX_ENABLED")),
	"android": Platform(".so", ("ANDROID_ENABLED", "UNIX_ENABLED")),
	"web": Platform(".wasm", ("WEB_ENABLED", "UNIX_ENABLED"), ".js"),
}


def add_options(options):
	system, arch = toolchains.HERE
	options.Add(
		EnumVariable("platform", "what is built for; other than linux and windows: with a toolchain of yours", system, tuple(PLATFORMS))
	)
	options.Add(EnumVariable("arch", "processor that is built for", arch, ARCHITECTURES))
	options.Add(EnumVariable("precision", "of the engine that loads the library: its numbers are float or double", *PRECISIONS))
	options.Add(
		"cxx", "C++ compiler to take instead of the one that is found (so does CXX in the environment, where nothing is fetched)", ""
	)


def is_here(env):
	return (env["platform"], env["arch"]) == toolchains.HERE


def folder(env):
	"""The folder of objects: for this machine it is build/ itself."""
	return "build" if is_here(env) else f"build/{env['platform']}_{env['arch']}"


def flavour(env):
	"""The part of a library's name that says what it is for, as godot-cpp names it."""
	return f"{env['platform']}.template_{env['target']}{'.double' if env['precision'] == 'double' else ''}.{env['arch']}"


def prepare(env):
	"""Sets compiler, names and flags of `env`, for programs and the library. Returns the platform, or None if it has no compiler."""
	system, arch = env["platform"], env["arch"]
	found = env["cxx"] or toolchains.compiler(system, arch)
	if not found or not shutil.which(found.split()[0]):
		print(f"There is no C++ compiler for {system} {arch}: name one as cxx=COMMAND, or in the environment as CXX.")
		return None
	env.Replace(CXX=found, SHLIBPREFIX="", SHLIBSUFFIX=PLATFORMS[system].suffix, PROGSUFFIX=PLATFORMS[system].program)
	is_zig = "/zig c++" in found
	if arch == "x86_64":
		env.Append(CCFLAGS=["-march=x86_64" if is_zig else "-march=x86-64"])
	if arch == "arm64" and not toolchains.is_clang(found):  # GCC would warn about each vector that older compilers passed in another way
		env.Append(CCFLAGS=["-Wno-psabi"])
	if system == "windows":
		# GCC cannot align the stack to more than 16 bytes there (its bug 54412), so wide moves must not count on it. The runtime
		# is linked in, and a file's bytes tell nothing of when it was made.
		env.Append(CCFLAGS=["-Wa,-muse-unaligned-vector-move"], LINKFLAGS=["-static", "-Wl,--no-insert-timestamp"])
	else:
		env.Append(CCFLAGS=["-fPIC"])
	if system in ("linux", "windows"):
		env.Append(LINKFLAGS=["-Wl,--no-undefined"])
	if is_zig:  # zig links only files named .o, and traps on undefined behaviour by default
		env.Replace(SHOBJSUFFIX=".o")
		env.Append(CCFLAGS=["-fno-sanitize=undefined"])
	if system == "web":
		env.Append(CCFLAGS=["-pthread"], LINKFLAGS=["-pthread"])
	return PLATFORMS[system]


def link_library(env):
	"""Links everything that the library needs into it, so that it loads where nothing is installed. Returns sources to add."""
	system, arch = env["platform"], env["arch"]
	if system == "macos":  # it is found by its path in the project, not by one of the machine that built it
		env.Append(LINKFLAGS=["-Wl,-install_name,@rpath/${TARGET.file}"])
	if system == "web":
		env.Append(CCFLAGS=["-sSIDE_MODULE=1"], LINKFLAGS=["-sSIDE_MODULE=1"])
	if system != "linux":
		return []
	# Symbols that are linked in stay hidden: the engine has a libstdc++ of its own.
	env.Append(LINKFLAGS=["-static-libgcc", "-static-libstdc++", "-Wl,--exclude-libs,ALL"])
	return link_old_glibc(env, arch)


def forget_folders(env):
	"""Keeps the folder of the build out of the library, so that the same sources make the same bytes anywhere."""
	names = ((ROOT, "."), (f"{ROOT}/", ""), (f"{TOOLS.resolve()}/", ".tools/"))  # the last that fits counts
	maps = [f"-ffile-prefix-map={folder}={name}" for folder, name in names]
	env.Append(CCFLAGS=[*maps, "-frandom-seed=$SOURCE"])
	if not toolchains.is_clang(env["CXX"]):  # GCC names a system's header by its real path, if that is shorter
		env.Append(CCFLAGS=["-fno-canonical-system-headers"])
	if env["platform"] == "linux":
		env.Append(LINKFLAGS=["-Wl,--build-id=sha1"])


def link_program(env):
	"""Links everything that a program needs into it, if it would need another machine's libraries to run."""
	if env["platform"] == "linux" and not is_here(env):
		env.Append(LINKFLAGS=["-static"])


def link_old_glibc(env, arch):
	"""Links against glibc 2.31, if it is there. Returns sources to add."""
	root = toolchains.glibc(arch)
	if root is None or not toolchains.can_link_old_glibc(env["platform"], arch):
		return []
	name = toolchains.GNU[arch]
	# Of that system's GCC only what unwinds the stack: a newer one asks the C library for a function that it has since 2.35.
	unwinder = BUILD / "glibc" / arch / "libgcc_eh.a"
	unwinder.parent.mkdir(parents=True, exist_ok=True)
	shutil.copyfile(next(root.glob(f"usr/lib/gcc/{name}/*/libgcc_eh.a")), unwinder)
	folders = [unwinder.parent, root / f"usr/lib/{name}"]
	env.Append(
		LINKFLAGS=[f"--sysroot={root}", f"-B{folders[1]}", *(f"-L{folder}" for folder in folders), "-Wl,--no-as-needed"],
		LIBS=["pthread", "dl"],
	)
	return ["extension/old_glibc/old_glibc.cpp"]
