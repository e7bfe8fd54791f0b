# SPDX-License-Identifier: MIT
"""The differences between platforms: compiler, names, defines, linked libraries."""

import shutil
from dataclasses import dataclass

from SCons.Variables import BoolVariable, EnumVariable

from tools.build import names, phones, toolchains
from tools.fetch.roots import RISCV
from tools.places import BUILD, ROOT, TOOLS

PRECISIONS = ("single", ("single", "double"))  # the default first
ARCHITECTURES = ("x86_64", "arm64", "rv64", "universal", "wasm32")


@dataclass(frozen=True)
class Platform:
	defines: tuple  # those of godot-cpp, whose headers ask for them
	has_editor: bool = True  # an editor that loads extensions
	has_compute: bool = True  # a renderer that runs compute passes


PLATFORMS = {
	"linux": Platform(("LINUX_ENABLED", "UNIX_ENABLED")),
	"windows": Platform(("WINDOWS_ENABLED",)),
	"macos": Platform(("MACOS_ENABLED", "UNIX_ENABLED")),
	"android": Platform(("ANDROID_ENABLED", "UNIX_ENABLED")),
	"ios": Platform(("IOS_ENABLED", "UNIX_ENABLED"), has_editor=False),
	"web": Platform(("WEB_ENABLED", "UNIX_ENABLED"), has_editor=False, has_compute=False),
}


def add_options(options):
	system, arch = names.HERE
	options.Add(EnumVariable("platform", "what is built for; android, ios: with a toolchain of yours", system, tuple(PLATFORMS)))
	options.Add(EnumVariable("arch", "processor that is built for", arch, ARCHITECTURES))
	options.Add(BoolVariable("threads", "for Web: the engine that loads the library is built with threads", True))
	options.Add(EnumVariable("precision", "of the engine that loads the library: its numbers are float or double", *PRECISIONS))
	options.Add(
		"cxx", "C++ compiler to take instead of the one that is found (so does CXX in the environment, where nothing is fetched)", ""
	)


def is_here(env):
	return (env["platform"], env["arch"]) == names.HERE


def has_symbols(env):
	return names.has_symbols(env["platform"], env["arch"])


def has_threads(env):
	return env["platform"] != "web" or env["threads"]


def folder(env):
	"""Returns the folder of objects, from the project's."""
	return names.folder(env["platform"], env["arch"], has_threads(env)).relative_to(ROOT).as_posix()


def generated(env):
	"""Returns the folder of compute_shaders.gen.h. Where there are no compute passes it comes before build/gen, which has them."""
	return "build/gen" if PLATFORMS[env["platform"]].has_compute else "build/gen/without_compute"


def flavour(env, of=names.flavour):
	"""Returns the part of a library's name that says what it is for; of names.library: the whole name."""
	return of(env["platform"], env["arch"], env["target"], env["precision"], has_threads(env))


def prepare(env):
	"""Sets compiler, names and flags of `env`, for programs and the library. Returns the platform, or None if it has no compiler."""
	system, arch = env["platform"], env["arch"]
	found = env["cxx"] or toolchains.compiler(system, arch)
	if not found or not shutil.which(found.split()[0]):
		advice = f"{phones.ADVICE[system]}. Or " if system in phones.ADVICE else ""
		print(f"There is no C++ compiler for {system} {arch}: {advice}name one as cxx=COMMAND, or in the environment as CXX.")
		return None
	env.Replace(CXX=found, SHLIBPREFIX="", SHLIBSUFFIX=f".{names.SUFFIXES[system]}", PROGSUFFIX=names.PROGRAMS.get(system, ""))
	is_zig = "/zig c++" in found
	if arch == "x86_64":
		env.Append(CCFLAGS=["-march=x86_64" if is_zig else "-march=x86-64"])
	if arch in ("arm64", "rv64") and not toolchains.is_clang(found):
		env.Append(CCFLAGS=["-Wno-psabi"])  # GCC would warn about each vector that older compilers passed in another way
	if arch == "rv64" and not toolchains.is_clang(found):  # GCC 12 calls a function for what is atomic and shorter than a word
		env.Append(LIBS=[":libatomic.a"])
	if system == "windows" and not is_zig:
		# GCC cannot align the stack to more than 16 bytes there (its bug 54412), so wide moves must not count on it. The runtime
		# is linked in, and a file's bytes tell nothing of when it was made.
		env.Append(CCFLAGS=["-Wa,-muse-unaligned-vector-move"], LINKFLAGS=["-static", "-Wl,--no-insert-timestamp"])
	elif system != "windows":
		env.Append(CCFLAGS=["-fPIC"])
	if system in ("linux", "windows", "android") and not is_zig:
		env.Append(LINKFLAGS=["-Wl,--no-undefined"])
	if is_zig:  # zig links only files named .o, and traps on undefined behaviour by default
		env.Replace(SHOBJSUFFIX=".o")
		env.Append(CCFLAGS=["-fno-sanitize=undefined"])
	if system == "web":
		threads = ["-pthread"] if has_threads(env) else []
		env.Append(CCFLAGS=[*threads, "-msimd128"], LINKFLAGS=threads)
	return PLATFORMS[system]


def link_library(env):
	"""Links everything that the library needs into it, so that it loads where nothing is installed. Returns sources to add."""
	system, arch = env["platform"], env["arch"]
	if system in ("macos", "ios"):  # it is found by its path in the project, not by one of the machine that built it
		env.Append(LINKFLAGS=["-Wl,-install_name,@rpath/${TARGET.file}"])
	if system == "web":
		env.Append(LINKFLAGS=["-sSIDE_MODULE=1"])
	if system == "android":  # its C++ library is linked in and stays hidden; devices of 2025 and later load in pages of 16 KiB
		env.Append(LINKFLAGS=["-static-libstdc++", "-Wl,--exclude-libs,ALL", "-Wl,-z,max-page-size=16384"])
	if system != "linux":
		return []
	# Symbols that are linked in stay hidden: the engine has a libstdc++ of its own.
	env.Append(LINKFLAGS=["-static-libgcc", "-static-libstdc++", "-Wl,--exclude-libs,ALL"])
	if arch == "rv64" and env["CXX"].startswith(str(RISCV.place)):  # its C library names its files as they lie on a machine
		env.Append(LINKFLAGS=[f"-Wl,--sysroot={RISCV.place}"])
	return link_old_glibc(env, arch)


def link_host(env):
	"""Links a program that loads the library. Returns sources to add."""
	if env["platform"] != "web":
		return link_library(env)
	env.Append(LINKFLAGS=["-sMAIN_MODULE=1", "-sNODERAWFS"])  # everything that a library may ask for; the machine's files
	link_program(env)
	return []


def forget_folders(env):
	"""Keeps the folder of the build out of the library, so that the same sources make the same bytes anywhere."""
	places = ((ROOT, "."), (f"{ROOT}/", ""), (f"{TOOLS.resolve()}/", ".tools/"))  # the last that fits counts
	maps = [f"-ffile-prefix-map={place}={name}" for place, name in places]
	env.Append(CCFLAGS=[*maps, "-frandom-seed=$SOURCE"])
	if not toolchains.is_clang(env["CXX"]):  # GCC names a system's header by its real path, if that is shorter
		env.Append(CCFLAGS=["-fno-canonical-system-headers"])
	if env["platform"] == "linux":
		env.Append(LINKFLAGS=["-Wl,--build-id=sha1"])


def link_program(env):
	"""Links everything that a program needs into it, if it would need another machine's libraries to run."""
	if env["platform"] == "linux" and not is_here(env):
		env.Append(LINKFLAGS=["-static"])
	if env["platform"] == "web":  # it runs in Node.js, which has as much memory as it asks for
		env.Append(LINKFLAGS=["-sALLOW_MEMORY_GROWTH", "-sSTACK_SIZE=4MB", "-sEXIT_RUNTIME"])


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
