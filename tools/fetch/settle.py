# SPDX-License-Identifier: MIT
"""Makes fetched programs run from their folder, with the loader and the libraries that came with them.

The machine's own may be older. Starting them through the loader would do for most, but /proc/self/exe would name the
loader, and the engine starts itself by that name (the editor's Play button).
"""

import json
import os
import platform
import subprocess

from tools.places import BROWSER, CROSS, EMSCRIPTEN, RISCV, UNPACKED
from tools.say import Failure, progress

MULTIARCH = f"{platform.machine()}-linux-gnu"
LOADER = {"x86_64": "ld-linux-x86-64.so.2", "aarch64": "ld-linux-aarch64.so.1"}.get(platform.machine(), "ld.so")
LIBRARIES = f"usr/lib/{MULTIARCH}"
FOLDERS = ("", "/pulseaudio", "/blas", "/lapack")  # below LIBRARIES
PROGRAMS = (
	*(f"usr/bin/{name}" for name in ("godot", "Xvfb", "xkbcomp", "glslang", "ffmpeg", "x86_64-w64-mingw32-*", "*-linux-gnu-*")),
	"usr/bin/wasm-*",
	"usr/lib/gcc*/*/*/*", "usr/lib/wine/*", "usr/lib/llvm-*/bin/*", "usr/lib/chromium/chrom*",
)  # fmt: skip
SETTLED = "settled"  # file in the root: the place for which the programs were patched
SOFTWARE_VULKAN = "software_vulkan.json"  # file in the root: names lavapipe to the Vulkan loader


def through_loader(root, program):
	"""Returns the command that runs `program` with the loader in `root`."""
	library_path = ":".join(f"{root}/{LIBRARIES}{folder}" for folder in FOLDERS)
	return [f"{root}/{LIBRARIES}/{LOADER}", "--library-path", library_path, str(program)]


def patch(root, place):
	"""Patches the programs in `root` to run once it lies at `place`. Files are replaced, never written into."""
	patchelf = [*through_loader(root, root / "usr/bin/patchelf")]
	loader = f"{place}/{LIBRARIES}/{LOADER}"
	for program in (file for pattern in PROGRAMS for file in root.glob(pattern) if is_elf(file)):
		if ask(patchelf, "--print-interpreter", program) not in ("", loader):  # a library has none
			libraries = os.path.relpath(root / LIBRARIES, program.parent)
			search = ":".join(f"$ORIGIN/{libraries}{folder}" for folder in FOLDERS)
			replace(program, [*patchelf, "--set-interpreter", loader, "--force-rpath", "--set-rpath", search])
	for library in (root / LIBRARIES).rglob("*.so*"):
		# a search path of its own would be taken instead of the program's
		if library.is_file() and not library.is_symlink() and ask(patchelf, "--print-rpath", library):
			replace(library, [*patchelf, "--remove-rpath"])
	localise_keyboard(root / "usr/bin/Xvfb")
	localise_wine(root)
	lavapipe = {"library_path": f"{place}/{LIBRARIES}/libvulkan_lvp.so", "api_version": "1.3.0"}
	rewrite(root / SOFTWARE_VULKAN, json.dumps({"file_format_version": "1.0.1", "ICD": lavapipe}).encode())
	rewrite(root / SETTLED, str(place).encode())


def keep_links_inside(root):
	"""A link from the top, such as /lib/libm.so.6, would lead to the machine's own file: let it begin in `root`."""
	for folder, folders, names in os.walk(root):
		for link in (os.path.join(folder, name) for name in [*folders, *names]):
			if os.path.islink(link) and os.path.isabs(target := os.readlink(link)) and os.path.lexists(f"{root}{target}"):
				os.unlink(link)
				os.symlink(os.path.relpath(f"{root}{target}", folder), link)


def is_elf(file):
	if file.is_symlink() or not file.is_file():
		return False
	with open(file, "rb") as data:
		return data.read(4) == b"\x7fELF"


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


def localise_wine(root):
	"""Wine looks under /usr for its server, by way of a script, and for a library of MinGW's: put both where it looks first."""
	script, library = root / "usr/lib/wine/wineserver", root / LIBRARIES / "wine/x86_64-windows/zlib1.dll"
	for place, file in ((script, root / "usr/lib/wine/wineserver64"), (library, root / "usr/x86_64-w64-mingw32/lib/zlib1.dll")):
		if file.exists() and not place.is_symlink():
			place.unlink(missing_ok=True)
			place.symlink_to(os.path.relpath(file, place.parent))


def check():
	"""Patches the programs again if the project was moved since they were unpacked."""
	for place in (UNPACKED, CROSS, EMSCRIPTEN, RISCV, BROWSER):
		marker = place / SETTLED
		if (place / "usr/bin/patchelf").exists() and not (marker.exists() and marker.read_text() == str(place)):
			with progress("Fitting the fetched programs to their new place"):
				patch(place, place)


def environment():
	"""Returns environment additions that replace what the system of a bare machine lacks."""
	stand_ins = (("FONTCONFIG_PATH", "etc/fonts"), ("XLOCALEDIR", "usr/share/X11/locale"))
	lacking = [(name, folder) for name, folder in stand_ins if not os.path.isdir("/" + folder) and (UNPACKED / folder).is_dir()]
	return {name: str(UNPACKED / folder) for name, folder in lacking}
