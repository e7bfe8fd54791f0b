# SPDX-License-Identifier: MIT
"""Packs a release: out/release/ with the add-on, the demo, debug symbols, the list of all parts (SPDX) and checksums.

The same commit makes the same bytes from any folder: entries are sorted, with the commit's time and fixed permissions, and the
libraries forget where they were built (SConstruct, symbols=yes).
"""

import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import zipfile
from dataclasses import dataclass

from tools.build import build, names, toolchains
from tools.csharp import wrappers
from tools.fetch import machine
from tools.places import OUT, PROJECT, ROOT
from tools.release import sbom, store
from tools.run import engine
from tools.say import Failure, say

# Bytes of the add-on's zip. Nine libraries, two of them in one file, need 19 million. Packed passes would save a tenth of that, but
# would take a codec of our own.
SIZE_MOST = 20_000_000
ADDON = PROJECT / "addons/grass_field"
EARLIEST = 315532800  # 1980, where the time of zip entries begins


@dataclass(frozen=True)
class Target:
	"""A library. Only those of the kind `release` ship, for both kinds of exports and the editor: the code is the same (decision 39)."""

	system: str
	arch: str
	kind: str
	threads: bool = True  # of the engine; only Web has one without

	def __str__(self):
		return f"{self.system}.{self.arch}{'' if self.threads else '.nothreads'}.{self.kind}"

	@property
	def tags(self):
		"""Returns those of its lines in the .gdextension, but debug and release."""
		arch = "" if self.arch == "universal" else f".{self.arch}"
		return f"single{'.threads' if self.system == 'web' and self.threads else ''}{arch}"

	@property
	def library(self):
		return names.library(self.system, self.arch, self.kind, threads=self.threads)

	@property
	def options(self):
		"""Returns those that build it."""
		of_web = [f"threads={'yes' if self.threads else 'no'}"] if self.system == "web" else []
		return [f"platform={self.system}", f"arch={self.arch}", f"target={self.kind}", *of_web]

	@property
	def built(self):
		return names.folder(self.system, self.arch, self.threads) / "symbols" / self.kind / self.library


SHIPPED = (
	("linux", "x86_64"),
	("linux", "arm64"),
	("linux", "rv64"),
	("windows", "x86_64"),
	("windows", "arm64"),
	("macos", "universal"),
	("web", "wasm32"),
)
TARGETS = (*(Target(system, arch, "release") for system, arch in SHIPPED), Target("web", "wasm32", "release", threads=False))


def chosen(only):
	"""Returns those of TARGETS that `only` names by their beginnings, between commas: linux.x86_64, windows."""
	parts = [part.strip() for part in only.split(",")]
	for part in parts:
		if not any(f"{target}.".startswith(f"{part}." if part else "") for target in TARGETS):
			raise Failure(f"--only {part}: there is no such library; there are {', '.join(map(str, TARGETS))}.", 2)
	return [target for target in TARGETS if any(f"{target}.".startswith(f"{part}." if part else "") for part in parts)]


def version():
	return (ROOT / "VERSION").read_text().strip()


def git(*arguments):
	"""Returns the output of git for this folder, whoever owns it. Empty if it is no repository."""
	if not (ROOT / ".git").exists() or not shutil.which("git"):
		return ""
	result = subprocess.run(["git", "-c", f"safe.directory={ROOT}", *arguments], cwd=ROOT, capture_output=True, text=True)
	if result.returncode:
		raise Failure(f"git {arguments[0]}: {result.stderr.strip()}")
	return result.stdout.strip()


def commit_time():
	"""Seconds since 1970: SOURCE_DATE_EPOCH, or the commit's time."""
	return max(EARLIEST, int(os.environ.get("SOURCE_DATE_EPOCH") or git("log", "-1", "--format=%ct") or EARLIEST))


def split(target, source, folder):
	"""Puts the library `source` without its symbols into `folder`, and these beside it, NAME.debug. Returns both paths; where the
	linker leaves the symbols out, None for the second."""
	if not names.has_symbols(target.system, target.arch):
		return pathlib.Path(shutil.copy(source, folder / target.library)), None
	objcopy = toolchains.binutil("objcopy", target.system, target.arch)
	if not objcopy:
		raise Failure(f"There is no objcopy for {target.system} {target.arch}: it comes with the compiler, as binutils.")
	library, symbols = folder / target.library, folder / f"{target.library}.debug"

	def run(*arguments):
		result = subprocess.run([objcopy, *map(str, arguments)], cwd=folder, capture_output=True, text=True)
		if result.returncode:
			raise Failure(f"{source.name}: {result.stderr.strip()}")

	run("--only-keep-debug", source, symbols.name)
	run("--strip-all", f"--add-gnu-debuglink={symbols.name}", source, library.name)
	return library, symbols


def gdextension(libraries):
	"""The text of a grass_field.gdextension that names exactly `libraries` (file names); a library that ships is named for debug, too."""
	text, named = "", set()
	for line in (ADDON / "grass_field.gdextension").read_text().splitlines(True):
		match = re.search(r'"bin/(.*)"', line)
		if match and match[1] not in libraries:
			line = line.replace(match[1], ships := match[1].replace("template_debug", "template_release"))
			if ships not in libraries:
				continue
		text += line
		named.add(match[1] if match else "")
	if missing := set(libraries) - named:
		raise Failure(f"grass_field.gdextension does not name {', '.join(sorted(missing))}.")
	return text


def files_in(folder, *left_out):
	"""Returns path in the project -> bytes, of every file in a folder of the project."""
	found = {}
	for path in sorted(folder.rglob("*")):
		name = path.relative_to(PROJECT).as_posix()
		if path.is_file() and not name.startswith(left_out) and not name.endswith(".tmp"):
			found[name] = path.read_bytes()
	return found


def addon(libraries):
	"""Returns path -> bytes of the add-on with `libraries`, paths of files."""
	place = ADDON.relative_to(PROJECT).as_posix()
	files = files_in(ADDON, f"{place}/bin/")
	files[f"{place}/grass_field.gdextension"] = gdextension([path.name for path in libraries]).encode()
	files[f"{place}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
	files |= {f"{place}/csharp/{name}": text.encode() for name, text in wrappers.texts().items()}
	return {**files, **{f"{place}/bin/{path.name}": path.read_bytes() for path in libraries}}


def demo():
	"""Returns path -> bytes of the demo's project without the add-on: without tests."""
	project = (PROJECT / "project.godot").read_text()
	project = re.sub(r"^run/main_scene\.tests=.*\n", "", project, flags=re.MULTILINE)
	return {**files_in(PROJECT / "demo"), "project.godot": project.encode(), "LICENSE": (ROOT / "LICENSE").read_bytes()}


def write_zip(path, files):
	"""Writes `files` (path -> bytes) so that only they and the commit's time decide the zip's bytes."""
	when = time.gmtime(commit_time())[:6]
	with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as file:
		for name in sorted(files):
			entry = zipfile.ZipInfo(name, when)
			entry.create_system, entry.external_attr, entry.compress_type = 3, 0o100644 << 16, zipfile.ZIP_DEFLATED
			file.writestr(entry, files[name], compresslevel=9)
	return path


def sizes(path):
	"""Returns rows of a table: bytes, unpacked and in the zip, of each library in the add-on's zip and of each folder beside them."""
	sums = {}
	with zipfile.ZipFile(path) as file:
		for entry in file.infolist():
			first, *rest = entry.filename.split("/")[2:]
			name = rest[0] if first == "bin" else f"{first}/" if rest else "other files"
			unpacked, packed = sums.get(name, (0, 0))
			sums[name] = unpacked + entry.file_size, packed + entry.compress_size
	rows = sorted(sums.items(), key=lambda row: -row[1][1])
	return ["| what | bytes | in the zip |", "|---|---|---|", *(f"| `{name}` | {a:,} | {b:,} |" for name, (a, b) in rows)]


def pack(sources, folder):
	"""Packs the libraries (target -> path of the file with symbols) into `folder`. Returns the paths of the zips."""
	folder.mkdir(parents=True, exist_ok=True)
	for old in (*folder.glob("grass_field-*.zip"), *folder.glob("grass_field-*.json")):
		old.unlink()
	name = f"grass_field-{version()}.zip"
	with tempfile.TemporaryDirectory() as parts:
		pairs = [split(target, source, pathlib.Path(parts)) for target, source in sources.items()]
		files = addon([library for library, _ in pairs])
		symbols = {path.name: path.read_bytes() for _, path in pairs if path}
	zips = [
		write_zip(folder / name, files),
		write_zip(folder / name.replace("field-", "field-demo-"), {**demo(), **files}),
		write_zip(folder / name.replace("field-", "field-symbols-"), symbols),
	]
	parts_list = (folder / name).with_suffix(".spdx.json")
	parts_list.write_text(sbom.text(version(), zips[0], files, list(sources), commit_time()))
	sums = (f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in sorted([*zips, parts_list]))
	(folder / "SHA256SUMS").write_text("".join(sums))
	(folder / "changes.md").write_text(store.changes(version()))
	if (size := zips[0].stat().st_size) > SIZE_MOST:
		raise Failure("\n".join((f"{name} has {size:,} bytes, {SIZE_MOST:,} at most:", *sizes(zips[0]))))
	return zips


def build_libraries(targets):
	"""Builds each with symbols. Returns target -> path."""
	for target in targets:
		build.scons("extension", "symbols=yes", *target.options)
	return {target: target.built for target in targets}


def check_glibc(target, library):
	"""Raises Failure if a library for Linux would not load on the systems that it is for."""
	if target.system != "linux":
		return
	command = [toolchains.objdump(target.system, target.arch), "-p", str(library)]
	text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
	newest = max(tuple(map(int, found.split("."))) for found in re.findall(r"\bGLIBC_([\d.]+)", text))
	most = toolchains.GLIBC_MOST[target.arch]
	if newest > most:
		raise Failure(
			f"{library.name} needs glibc {'.'.join(map(str, newest))}, more than {'.'.join(map(str, most))}:"
			" make releases with the GCC of Debian 12 (docs/internals/building.md, Other platforms)."
		)


def make(only="", out=None):
	"""Builds and packs the libraries that `only` names (empty: all)."""
	targets = chosen(only or "")
	folder = pathlib.Path(out or OUT / "release").resolve()
	machine.ensure(*machine.BUILDING)
	if changed := git("status", "--porcelain"):
		say(f"Not the commit alone: {len(changed.splitlines())} files have changed since, such as {changed.split()[1]}")
	libraries = build_libraries(targets)
	for target, library in libraries.items():
		check_glibc(target, library)
	zips = pack(libraries, folder)
	say("\n".join(sizes(zips[0])))
	for path in zips:
		say(f"{path.stat().st_size / 1e6:6.2f} MB  {path.name}")
	say(f"Packed, with an SPDX list of parts and SHA256SUMS: {folder}")


def write_fixtures():
	"""Writes files of this version, with no value at its default. Every later version must load them."""
	folder = PROJECT / "tests/fixtures" / version()
	build.scons("extension")
	engine.import_project()
	folder.mkdir(parents=True, exist_ok=True)
	command, environment = engine.headless()
	arguments = ["--path", str(PROJECT), "--script", "res://tests/fixtures/write_fixtures.gd", "--", version()]
	if engine.run([*command, *arguments], environment):
		raise Failure("The fixtures could not be written.")
	say(f"Written: {folder.relative_to(ROOT)}")
