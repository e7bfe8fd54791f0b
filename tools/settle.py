# SPDX-License-Identifier: MIT
"""Makes fetched programs run where they lie, with the loader and the libraries that came with them.

The machine's own may be older. Starting them through the loader would do for most, but /proc/self/exe would name the
loader, and the engine starts itself by that name (the editor's Play button).
"""

import json
import os
import platform
import subprocess

from tools.places import UNPACKED
from tools.say import Failure, progress

MULTIARCH = f"{platform.machine()}-linux-gnu"
LOADER = {"x86_64": "ld-linux-x86-64.so.2", "aarch64": "ld-linux-aarch64.so.1"}.get(platform.machine(), "ld.so")
LIBRARIES = f"usr/lib/{MULTIARCH}"
FOLDERS = ("", "/pulseaudio", "/blas", "/lapack")  # below LIBRARIES
PROGRAMS = ("godot", "Xvfb", "xkbcomp", "glslang", "ffmpeg")
SETTLED = "settled"  # file in the root: where the programs believe that it lies
SOFTWARE_VULKAN = "software_vulkan.json"  # file in the root: names lavapipe to the Vulkan loader


def through_loader(root, program):
	"""Command that runs `program` by the loader in `root`."""
	library_path = ":".join(f"{root}/{LIBRARIES}{folder}" for folder in FOLDERS)
	return [f"{root}/{LIBRARIES}/{LOADER}", "--library-path", library_path, str(program)]


def patch(root):
	"""Patches the programs in `root` to run once it lies at UNPACKED. Files are replaced, never written into."""
	patchelf = [*through_loader(root, root / "usr/bin/patchelf")]
	loader = f"{UNPACKED}/{LIBRARIES}/{LOADER}"
	search = ":".join(f"$ORIGIN/../../{LIBRARIES}{folder}" for folder in FOLDERS)
	for name in PROGRAMS:
		program = root / "usr/bin" / name
		if program.exists() and ask(patchelf, "--print-interpreter", program) != loader:
			replace(program, [*patchelf, "--set-interpreter", loader, "--force-rpath", "--set-rpath", search])
	for library in (root / LIBRARIES).rglob("*.so*"):
		# a search path of its own would be taken instead of the program's
		if library.is_file() and not library.is_symlink() and ask(patchelf, "--print-rpath", library):
			replace(library, [*patchelf, "--remove-rpath"])
	localise_keyboard(root / "usr/bin/Xvfb")
	lavapipe = {"library_path": f"{UNPACKED}/{LIBRARIES}/libvulkan_lvp.so", "api_version": "1.3.0"}
	rewrite(root / SOFTWARE_VULKAN, json.dumps({"file_format_version": "1.0.1", "ICD": lavapipe}).encode())
	rewrite(root / SETTLED, str(UNPACKED).encode())


def replace(file, command):
	made = file.with_name(file.name + ".new")
	result = subprocess.run([*command, "--output", str(made), str(file)], capture_output=True, text=True)
	if result.returncode:
		raise Failure(f"{file.name} could not be fitted to its place: {result.stderr.strip()}")
	made.chmod(0o755)
	made.replace(file)


def rewrite(file, data):
	made = file.with_name(file.name + ".new")
	made.write_bytes(data)
	if file.exists():
		made.chmod(file.stat().st_mode)
	made.replace(file)


def ask(patchelf, question, file):
	return subprocess.run([*patchelf, question, str(file)], capture_output=True, text=True).stdout.strip()


def localise_keyboard(xvfb):
	"""The X server runs /usr/bin/xkbcomp to make its keymap; let it run ./xkbcomp instead (display.py starts it there)."""
	if xvfb.exists() and (data := xvfb.read_bytes()).count(there := b"\0/usr/bin\0"):
		rewrite(xvfb, data.replace(there, b"\0.".ljust(len(there), b"\0")))


def check():
	"""Fits the programs anew if the project was moved since they were unpacked."""
	marker = UNPACKED / SETTLED
	if (UNPACKED / "usr/bin/patchelf").exists() and not (marker.exists() and marker.read_text() == str(UNPACKED)):
		with progress("Fitting the fetched programs to their new place"):
			patch(UNPACKED)


def environment():
	"""Environment additions that stand for what the system of a bare machine lacks."""
	stand_ins = (("FONTCONFIG_PATH", "etc/fonts"), ("XLOCALEDIR", "usr/share/X11/locale"))
	lacking = [(name, folder) for name, folder in stand_ins if not os.path.isdir("/" + folder) and (UNPACKED / folder).is_dir()]
	return {name: str(UNPACKED / folder) for name, folder in lacking}
