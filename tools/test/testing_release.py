# SPDX-License-Identifier: MIT
"""The layers `package` and `release`: the zips of ./grass release are complete, small, the same twice, and run in an empty project.

`package`, a part of every run, packs this machine's debug library as the other layers use it; `release`, by name only, builds
what ships for this machine, here and in a second folder, and draws and exports with it.
"""

import contextlib
import hashlib
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import tempfile
import zipfile
import zlib

from tools.build import names, toolchains
from tools.fetch import machine, settle
from tools.places import ADDON_BIN, BUILD, PROJECT, ROOT, TOOLS, UNPACKED
from tools.release import export, release, trial
from tools.run import engine
from tools.say import Failure, progress
from tools.test.test_runs import Tally

WORK = BUILD / "package"
PLACE = "addons/grass_field"
MOST_ALONE = 3_200_000  # bytes of a zip with a single library; 3,156,326 of one compiled file by file, which is the largest
RUN_LIMIT, BUILD_LIMIT = 900, 7200  # seconds
SOURCES = ("SConstruct", "VERSION", "LICENSE", "CHANGELOG.md", "grass", "tools", "extension", "shaders", "tests", "godot_project")


class Skip(Exception):
	"""A check that cannot run here, with the reason."""


def check(condition, text):
	if not condition:
		raise Failure(text)


@contextlib.contextmanager
def other_habits():
	"""Sets another umask, time zone and locale."""
	umask, old = os.umask(0o077), {key: os.environ.get(key) for key in ("TZ", "LC_ALL")}
	os.environ.update(TZ="Asia/Tokyo", LC_ALL="C")
	try:
		yield
	finally:
		os.umask(umask)
		for key, value in old.items():
			os.environ.pop(key) if value is None else os.environ.update({key: value})


def digests(folder):
	return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(folder.iterdir())}


def same_twice(sources):
	"""Packs into two folders, the second time with another umask, time zone and locale."""
	release.pack(sources, WORK / "once")
	with other_habits():
		release.pack(sources, WORK / "twice")
	check(digests(WORK / "once") == digests(WORK / "twice"), f"{digests(WORK / 'once')} is not {digests(WORK / 'twice')}")


def names_in(kind):
	(path,) = (WORK / "once").glob(f"grass_field-{kind}{release.version()}.zip")
	with zipfile.ZipFile(path) as file:
		check(file.testzip() is None, f"{path.name} is damaged")
		return path, {name: file.read(name) for name in file.namelist()}


def only_the_addon(sources):
	path, files = names_in("")
	strangers = [name for name in files if not name.startswith(f"{PLACE}/")]
	check(not strangers, f"{strangers} are no part of the add-on")
	for name in ("LICENSE", "README.md", "grass_field.gdextension", "grass_field.gdextension.uid"):
		check(f"{PLACE}/{name}" in files, f"{name} is missing")
	most = min(MOST_ALONE * sum(2 if target.arch == "universal" else 1 for target in sources), release.SIZE_MOST)
	rows = "\n".join(release.sizes(path))
	check(path.stat().st_size <= most, f"{path.stat().st_size:,} bytes with {len(sources)} libraries, at most {most:,}:\n{rows}")


def extension_names_what_is_there(sources):
	_, files = names_in("")
	text = files[f"{PLACE}/grass_field.gdextension"].decode()
	for section in ("configuration", "libraries", "icons"):
		check(f"[{section}]" in text, f"the section {section} is missing")
	named = {f"{PLACE}/{name}" for name in re.findall(r'= "((?:bin|icons)/.*)"', text)}
	there = {name for name in files if f"{PLACE}/bin/" in name}
	check(len(there) == len(sources), f"{there} for {len(sources)} libraries")
	check(there <= named, f"{there - named} is named nowhere")
	for target in sources:
		kinds = re.findall(rf'^{target.system}\.(\w+)\.{target.tags} = "bin/{target.library}"', text, re.MULTILINE)
		check(kinds == (["debug", "release"] if target.kind == "release" else ["debug"]), f"{target.library} stands for {kinds}")
	check(named <= set(files), f"{named - set(files)} is named, but not there")


def no_paths_of_this_machine(sources):
	_, files = names_in("")
	for name, data in files.items():
		check(str(ROOT).encode() not in data, f"{name} tells {ROOT}")


def sums_are_right(_sources):
	result = subprocess.run(["sha256sum", "--check", "--strict", "SHA256SUMS"], cwd=WORK / "once", capture_output=True, text=True)
	check(result.returncode == 0 and result.stdout.count(": OK") == 4, result.stdout + result.stderr)


def parts_are_listed(sources):
	"""Every file of the zip by its checksum, the zip itself, and what is linked into each library."""
	path, files = names_in("")
	document = json.loads(path.with_suffix(".spdx.json").read_text())
	sums = {file["fileName"]: file["checksums"][1]["checksumValue"] for file in document["files"]}
	wrong = [name for name, data in files.items() if sums.pop(f"./{name}", "") != hashlib.sha256(data).hexdigest()]
	check(not wrong and not sums, f"{wrong} have other checksums, {sorted(sums)} are not in the zip")
	own = document["packages"][0]
	check(own["checksums"][0]["checksumValue"] == hashlib.sha256(path.read_bytes()).hexdigest(), "the zip has another checksum")
	known = {entry["SPDXID"] for kind in ("packages", "files") for entry in document[kind]} | {document["SPDXID"]}
	for relation in document["relationships"]:
		check({relation["spdxElementId"], relation["relatedSpdxElement"]} <= known, f"{relation} names what is not listed")
	linked = {relation["spdxElementId"] for relation in document["relationships"] if relation["relationshipType"] == "STATIC_LINK"}
	libraries = {file["SPDXID"] for file in document["files"] if "/bin/" in file["fileName"]}
	check(linked == libraries and len(libraries) == len(sources), f"{libraries ^ linked} have no parts, or are no libraries")
	check(all(re.match(r"\d", entry["versionInfo"]) for entry in document["packages"]), "a part has no version")


def picture(shade):
	"""Returns a grey PNG of 32 x 32 pixels."""
	parts = (
		(b"IHDR", struct.pack(">IIBBBBB", 32, 32, 8, 0, 0, 0, 0)),
		(b"IDAT", zlib.compress((b"\0" + bytes([shade]) * 32) * 32)),
		(b"IEND", b""),
	)
	return b"\x89PNG\r\n\x1a\n" + b"".join(
		struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)) for kind, data in parts
	)


def pictures_are_compared(_sources):
	"""So are pictures: lighter ones are found, by more than drivers round."""
	folder = WORK / "drawn"
	shutil.rmtree(folder, ignore_errors=True)
	folder.mkdir()
	for name, shade in (("a", 100), ("b", 101)):
		(folder / f"{name}.png").write_bytes(picture(shade))
	trial.compare([folder], *engine.headless())
	(folder / "c.png").write_bytes(picture(103))
	try:
		trial.compare([folder], *engine.headless())
	except Failure as failure:
		check("3.00 apart" in str(failure), str(failure))
		return
	raise Failure("a lighter picture is taken for the same")


def results_are_compared(_sources):
	"""`./grass try --compare` tells systems apart."""
	folder = WORK / "seen"
	shutil.rmtree(folder, ignore_errors=True)
	folder.mkdir()
	one = {"system": "here", "engine": "4.6", "bits": "c0ffee"}
	for name, other in (("a", {}), ("b", {"system": "there"})):
		(folder / f"{name}.json").write_text(json.dumps({**one, **other}))
	trial.compare([folder])
	(folder / "c.json").write_text(json.dumps({**one, "bits": "decade"}))
	try:
		trial.compare([folder])
	except Failure:
		return
	raise Failure("other bits are taken for the same")


def symbols_find_their_library(sources):
	_, files = names_in("symbols-")
	with_symbols = [target for target in sources if names.has_symbols(target.system, target.arch)]
	check(set(files) == {f"{target.library}.debug" for target in with_symbols}, f"there are {sorted(files)}")
	_, libraries = names_in("")
	for target in with_symbols:
		check(
			f"{target.library}.debug".encode() in libraries[f"{PLACE}/bin/{target.library}"], f"{target.library} names no file of symbols"
		)


def demo_is_whole(_sources):
	_, files = names_in("demo-")
	strangers = [name for name in files if name.startswith(("tests/", "lab/", ".godot/"))]
	check(not strangers, f"{strangers} are no part of the demo")
	texts = {name: data.decode() for name, data in files.items() if name.endswith((".gd", ".tscn", ".tres", ".godot"))}
	for name, text in texts.items():
		for path in re.findall(r'"res://([^"%]+\.\w+)"', text):
			check(path in files, f"{name} names res://{path}, which is not there")


def archive_is_the_addon(_sources):
	"""The files that Godot's Asset Library would get from the repository."""
	names = release.git("ls-files")
	if not names:
		raise Skip("this is no git repository")
	ignored = release.git("-c", "core.quotePath=false", "check-attr", "export-ignore", "--", *folders_of(names.splitlines()))
	gone = {line.rsplit(": ", 2)[0] for line in ignored.splitlines() if line.endswith(": set")}
	kept = [name for name in names.splitlines() if not gone & set(folders_of([name]))]
	strangers = [name for name in kept if name != "LICENSE" and not name.startswith(f"{PROJECT.name}/{PLACE}/")]
	check(not strangers, f"{strangers} are no part of the add-on")
	check(f"{PROJECT.name}/{PLACE}/grass_field.gdextension" in kept, "the add-on itself is left out")


def folders_of(names):
	"""`names` of files, and of all folders above them."""
	return sorted({str(path) for name in names for path in (pathlib.PurePosixPath(name), *pathlib.PurePosixPath(name).parents)} - {"."})


def run_engine(command, environment, *arguments, expected=None):
	"""Runs an engine to its end. Returns its output; raises Failure if it contains an error, unless that has the words `expected`."""
	said = []
	code = engine.run([*map(str, command), *map(str, arguments)], environment, said.append, RUN_LIMIT)
	words = "\n".join(said[-20:])
	check(code == 0, f"the engine ended with code {code}: {words}")
	errors = [line for line in said if re.match(r"(SCRIPT )?ERROR:", line) and not (expected and expected in line)]
	check(not errors, f"the engine complains: {words}")
	return "\n".join(said)


def unpack(kind, project):
	return trial.unpack(names_in(kind)[0], project, sample=not kind)


def editor_opens(kind):
	def action(_sources):
		project = unpack(kind, WORK / f"project_{kind}")
		run_engine(*engine.headless(), "--path", project, "--editor", "--quit-after", 20)
		run_engine(*engine.headless(), "--path", project, "--import")

	return action


def bends(said, renderer):
	version, method, *more = trial.seen(said)
	check(version == release.version() and method == renderer, f"it says {version}, {method}, {more}")
	check(bool(more[-1]) == (renderer == "headless"), f"it tells the blades' bits: {more[-1]}")


def runs_headless(_sources):
	command, environment = engine.headless()
	bends(run_engine(command, environment, "--path", WORK / "project_", "--fixed-fps", 60), "headless")


def runs_with(renderer):
	def action(_sources):
		with engine.window(renderer, "320x180", software=True) as (command, environment):
			bends(run_engine(command, environment, "--path", WORK / "project_", "--fixed-fps", 60), renderer)

	return action


def demo_runs(_sources):
	command, environment = engine.headless()
	small = ("--size", 8, "--bodies", 8)
	run_engine(command, environment, "--path", WORK / "project_demo-", "--fixed-fps", 60, "--quit-after", 120, "--", *small)


def fit(game):
	"""Lets a copy of a fetched template find the libraries that were fetched with it."""
	if not machine.program("godot-template-release").startswith(str(UNPACKED)):
		return
	patchelf = settle.through_loader(UNPACKED, UNPACKED / "usr/bin/patchelf")
	libraries = UNPACKED / settle.LIBRARIES
	search = ":".join(f"{libraries}{folder}" for folder in settle.FOLDERS)
	settle.replace(game, [*patchelf, "--set-interpreter", f"{libraries}/{settle.LOADER}", "--force-rpath", "--set-rpath", search])


def export_runs(kind, preset="Linux"):
	def action(_sources):
		out = WORK / f"export_{preset}_{kind}"
		shutil.rmtree(out, ignore_errors=True)
		out.mkdir()
		export.install_templates()
		run_engine(*engine.headless(), "--path", WORK / "project_", f"--export-{kind}", preset, out / "game")
		check(list(out.glob("libgrass_field.*")), f"the library is not in {sorted(path.name for path in out.iterdir())}")
		fit(out / "game")
		bends(run_engine([out / "game", "--headless"], {}, "--fixed-fps", 60), "headless")

	return action


def server_is_packed(_sources):
	"""Packs for a dedicated server as a fresh checkout does: without what an export before has kept, scenes' resources are changed."""
	project, pack = WORK / "project_", WORK / "server.pck"
	shutil.rmtree(project / ".godot/exported", ignore_errors=True)
	pack.unlink(missing_ok=True)
	missing = "names no library for"  # the engine packs for a release, of which there may be no library here
	run_engine(*engine.headless(), "--path", project, "--export-pack", "Server", pack, expected=missing)
	check(pack.exists(), "there is no pack")
	check((project / ".godot/exported").exists(), "nothing was changed for the server")


def same_elsewhere(sources):
	"""Builds and packs once more, from a copy of the sources in another folder, without a compiler's cache."""
	(target,) = sources
	release.pack(sources, WORK / "here")
	with tempfile.TemporaryDirectory() as folder:
		other = pathlib.Path(folder) / "another/place"
		other.mkdir(parents=True)
		ignored = shutil.ignore_patterns("bin", ".godot", "__pycache__")
		for name in SOURCES:
			copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy2
			copy(ROOT / name, other / name, **({"ignore": ignored} if (ROOT / name).is_dir() else {}))
		(other / TOOLS.name).symlink_to(TOOLS.resolve())
		environment = {**os.environ, "SOURCE_DATE_EPOCH": str(release.commit_time()), "PYTHONPATH": "", "CCACHE_DISABLE": "1"}
		command = ["./grass", "release", "--only", str(target)]
		with progress("Building in another folder", every=30):
			result = subprocess.run(
				command, cwd=other, env=environment, capture_output=True, text=True, timeout=BUILD_LIMIT, stdin=subprocess.DEVNULL
			)
		check(result.returncode == 0, f"it does not build there: {(result.stdout + result.stderr)[-2000:]}")
		there = digests(other / "out/release")
		check(there == digests(WORK / "here"), f"{digests(WORK / 'here')} here, {there} there")


PACKING = {
	"packed twice, the same bytes": same_twice,
	"the zip holds the add-on alone, in 20 MB": only_the_addon,
	"the .gdextension names what is there and nothing else": extension_names_what_is_there,
	"no path of this machine": no_paths_of_this_machine,
	"SHA256SUMS are right": sums_are_right,
	"every part is listed": parts_are_listed,
	"results of several systems are compared": results_are_compared,
	"pictures of several drivers are compared": pictures_are_compared,
	"each library finds its symbols": symbols_find_their_library,
	"the demo is whole": demo_is_whole,
	"an archive of the repository holds the add-on alone": archive_is_the_addon,
	"the editor opens an empty project with the zip": editor_opens(""),
	"a scene in it runs headless": runs_headless,
	"a dedicated server is packed": server_is_packed,
}
BY_NAME = {
	"the editor opens the demo": editor_opens("demo-"),
	"the demo runs headless": demo_runs,
	"a scene runs on software Vulkan, Forward+": runs_with("forward_plus"),
	"a scene runs on software Vulkan, Mobile": runs_with("mobile"),
	"a scene runs on software OpenGL, Compatibility": runs_with("gl_compatibility"),
	"an export runs, debug": export_runs("debug"),
	"an export runs, release": export_runs("release"),
	"an export of selected scenes runs": export_runs("release", "Scenes"),
	"built in another folder, the same bytes": same_elsewhere,
}


def sources_of(layer):
	"""Returns target -> library, not stripped."""
	system, arch = toolchains.HERE
	here = [target for target in release.TARGETS if (target.system, target.arch) == (system, arch)]
	if not here:
		raise Failure(f"No library for {system} {arch} ships.")
	if layer == "package":
		target = release.Target(system, arch, "debug")
		return {target: ADDON_BIN / target.library}
	templates = [f"godot-template-{kind}" for kind in export.KINDS]
	machine.ensure((lambda: all(map(machine.program, templates)), tuple(templates)))
	return release.build_libraries(here)


def run_layer(layer, only):
	"""All checks, in order: the first ones make the files that the others check, so they always run."""
	tally = Tally()
	sources = sources_of(layer)
	for name, action in {**PACKING, **(BY_NAME if layer == "release" else {})}.items():
		if only not in name and action not in (same_twice, PACKING["the editor opens an empty project with the zip"]):
			continue
		try:
			action(sources)
			tally.passed += 1
			print(f"  pass {layer}: {name}", flush=True)
		except Skip as skip:
			tally.skipped.append(f"{layer}: {name}: {skip}")
		except Failure as failure:
			tally.failed.append(f"{layer}: {name}: {failure}")
			print(f"  fail {layer}: {name}: {failure}", flush=True)
	return tally
