# SPDX-License-Identifier: MIT
"""Compilers for this machine and for other platforms, and the programs that run their output here.

The machine's own are taken where it has them, else those of Debian 12, fetched (packages.py). A library for Linux is
linked against glibc 2.31, so that it loads on systems of 2020 and later.
"""

import os
import pathlib
import platform
import re
import shutil
import subprocess

from tools.build import emscripten, phones, zig
from tools.build.names import HERE
from tools.fetch import machine
from tools.fetch.roots import CROSS, GLIBC, RISCV

GLIBC_MOST = {
	"x86_64": (2, 31),
	"arm64": (2, 31),
	"rv64": (2, 36),
}  # the newest that a library may need; Debian has no older one for RISC-V
GNU = {"x86_64": "x86_64-linux-gnu", "arm64": "aarch64-linux-gnu", "rv64": "riscv64-linux-gnu"}  # by the toolchains' names
MINGW = "x86_64-w64-mingw32"


def tool(*names):
	"""Returns the path of the first of `names` that the machine has, otherwise of a fetched one. None if there is neither."""
	folders = (CROSS.place / "usr/bin", CROSS.place / "usr/lib/wine", RISCV.place / "usr/bin")
	fetched = (folder / name for name in names for folder in folders)
	return next(filter(None, map(shutil.which, names)), None) or next((str(file) for file in fetched if file.exists()), None)


def compiler(system, arch):
	"""Returns the C++ compiler that makes programs for `system` and `arch`. None if it is not fetched yet, or cannot be."""
	if (system, arch) == HERE:
		return machine.compiler()
	if system == "windows" and arch == "x86_64":
		found = tool(f"{MINGW}-g++-posix")  # the variant that has std::thread
	elif system == "linux" and arch in GNU:
		found = tool(f"{GNU[arch]}-g++")
	elif zig.is_for(system, arch):
		return zig.compiler(system, arch)
	elif system == "web" and not os.environ.get("CXX"):
		return emscripten.compiler()
	elif system in phones.ADVICE and not os.environ.get("CXX"):
		return phones.compiler(system, arch)
	else:
		return os.environ.get("CXX")  # a toolchain of the user's, named by its environment
	launcher = os.environ.get("GRASS_LAUNCHER")  # such as ccache
	return f"{launcher} {found}" if found and launcher else found


def is_clang(command):
	"""Returns whether a compiler takes clang's flags."""
	return bool(re.search(r"clang|/zig c\+\+|em\+\+", command or ""))


def glibc(arch):
	"""Returns the folder of the glibc that libraries for Linux are linked against. None if it is missing."""
	place = GLIBC[arch].place if arch in GLIBC else pathlib.Path()
	return place if arch in GLIBC and (place / f"usr/lib/{GNU[arch]}/libc.so").exists() else None


def can_link_old_glibc(system, arch):
	"""The machine's own libstdc++ needs the machine's glibc, if that is newer than the one that the fetched compilers come with."""
	if system != "linux" or arch not in GLIBC:
		return False
	if (system, arch) != HERE:
		return True
	library, version = platform.libc_ver()
	is_gcc = not is_clang(machine.compiler())  # clang would look for GCC's own files beside that glibc
	return library == "glibc" and tuple(map(int, version.split(".")[:2])) <= (2, 36) and is_gcc


def needs(system, arch):
	"""Returns the needs that machine.ensure() has to find to build for `system` and `arch`."""
	found = []
	packages = {
		("windows", "x86_64"): ("g++-mingw-w64-x86-64-posix", CROSS),
		("linux", "arm64"): ("g++-aarch64-linux-gnu", CROSS),
		("linux", "rv64"): ("g++-riscv64-linux-gnu", RISCV),
		("linux", "x86_64"): ("g++-x86-64-linux-gnu", CROSS),
	}
	if (system, arch) != HERE and (system, arch) in packages:
		package, root = packages[system, arch]
		found.append((lambda: compiler(system, arch), (package, "patchelf"), root))
	if can_link_old_glibc(system, arch) and shutil.which("apt-get"):
		found.append((lambda: glibc(arch), ("libc6-dev", "libgcc-10-dev"), GLIBC[arch]))
	return found


def ensure(system, arch):
	"""Fetches what builds for `system` and `arch`. Returns what it needs in its environment."""
	machine.ensure(*machine.BUILDING, *needs(system, arch))
	if zig.is_for(system, arch):
		zig.ensure()
		return zig.environment()
	if system == "web" and not os.environ.get("CXX"):
		emscripten.ensure()
		return emscripten.environment()
	return {}


CLANG = "14"  # Debian 12's; of clang-tidy and clang-format as well


def clang():
	"""The path of clang, which compiles what only tests take, in half of GCC's time: the fetched one, since a machine's own may lack the
	sanitizers' libraries. None if there is neither."""
	name = f"clang++-{CLANG}"
	fetched = CROSS.place / "usr/bin" / name
	return str(fetched) if fetched.exists() else shutil.which(name)


def clang_for_arm64():
	"""clang for Linux on arm64, as a command, with the headers and libraries of the GCC that is there."""
	gcc = pathlib.Path(tool(f"{GNU['arm64']}-g++"))
	return f"{clang()} --target={GNU['arm64']} --gcc-toolchain={gcc.parent.parent}"


def clang_sanitizer():
	"""Returns the address sanitizer's library of clang. None if it is missing."""
	if not clang():
		return None
	folder = subprocess.run([clang(), "-print-runtime-dir"], capture_output=True, text=True).stdout.strip()
	return next(pathlib.Path(folder).glob("libclang_rt.asan*.a"), None)


CLANG_NEED = (clang_sanitizer, (f"clang-{CLANG}", f"libclang-rt-{CLANG}-dev", "patchelf"), CROSS)
WINE = (lambda: tool("wine64"), ("wine64", "patchelf"), CROSS)
QEMU = (lambda: tool("qemu-aarch64-static"), ("qemu-user-static", "patchelf"), CROSS)
QEMU_RISCV = (lambda: tool("qemu-riscv64-static"), ("qemu-user-static", "patchelf"), RISCV)


def binutil(name, system, arch):
	"""objdump, strip and similar tools for files of `system` and `arch`."""
	prefix = MINGW if system == "windows" else GNU[arch]
	return tool(f"{prefix}-{name}", *([name] if (system, arch) == HERE else []))


def objdump(system, arch):
	return binutil("objdump", system, arch)
