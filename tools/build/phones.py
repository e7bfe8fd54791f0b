# SPDX-License-Identifier: MIT
"""The compilers for phones, which their makers let nobody pass on: that of an Android NDK, and that of Xcode."""

import os
import pathlib
import platform
import shutil
import subprocess

NDK_TARGETS = {"arm64": "aarch64-linux-android", "x86_64": "x86_64-linux-android"}
ANDROID_API = 24  # Android 7, the oldest that Godot's templates run on
IOS_VERSION = "14.0"  # the oldest that Godot's templates run on
ADVICE = {
	"android": "ANDROID_NDK_ROOT names the folder of an NDK, or ANDROID_HOME that of an SDK that has one",
	"ios": "Xcode on a Mac has it",
}


def ndk():
	"""Returns the folder of the NDK that the environment names, or the newest of the SDK that it names. None if there is none."""
	if named := os.environ.get("ANDROID_NDK_ROOT"):
		return pathlib.Path(named)
	found = pathlib.Path(os.environ.get("ANDROID_HOME", "/nowhere")).glob("ndk/*/toolchains")
	return max(
		(path.parent for path in found), key=lambda path: [int(part) for part in path.name.split(".") if part.isdigit()], default=None
	)


def ndk_compiler(arch):
	"""clang for Android, as a command. None if there is no NDK, or none for `arch`."""
	folder = ndk()
	if folder is None or arch not in NDK_TARGETS:
		return None
	compilers = folder.glob(f"toolchains/llvm/prebuilt/{platform.system().lower()}-*/bin/clang++*")
	found = next((path for path in sorted(compilers) if path.stem == "clang++"), None)
	return f"{found} --target={NDK_TARGETS[arch]}{ANDROID_API}" if found else None


def xcode_compiler(arch):
	"""clang for iOS, as a command. None if there is no Xcode, or `arch` is not that of a device."""
	if arch != "arm64" or not shutil.which("xcrun"):
		return None
	asked = subprocess.run(["xcrun", "--sdk", "iphoneos", "--show-sdk-path"], capture_output=True, text=True)
	return f"clang++ -arch arm64 -isysroot {asked.stdout.strip()} -miphoneos-version-min={IOS_VERSION}" if asked.returncode == 0 else None


def compiler(system, arch):
	return ndk_compiler(arch) if system == "android" else xcode_compiler(arch)
