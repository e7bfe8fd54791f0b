# SPDX-License-Identifier: MIT
"""Packs the project to run without the editor: OUT/grass_field, its .pck and the extension's library."""

import pathlib
import re
import shutil
import subprocess
import tarfile

from tools.build import build
from tools.fetch import machine
from tools.places import ADDON_BIN, BUILD, PROJECT, ROOT
from tools.run import engine
from tools.say import Failure, progress, say

PRESET = "Linux"  # in godot_project/export_presets.cfg
TESTS_PRESET = "Tests"  # the same, but that res://tests/runner.tscn is the main scene
BENCH_PRESET = "Benchmark"  # the same, but that res://bench/bench.tscn is the main scene
ALL_PARTS = ROOT / "tools/bench/all.sh"
RECORD_ALL = ROOT / "tools/pages/pictures.sh"
NAME = "grass_field"
KINDS = ("debug", "release")


def install_templates():
	"""Puts the export templates where the engine looks for them: in its data folder, under its version."""
	answer = subprocess.run([machine.godot(), "--version"], capture_output=True, text=True).stdout
	version = re.search(r"^\d+\.\d+(\.\d+)?\.[a-z]+\d*", answer, re.MULTILINE)[0]  # such as 4.6.3.stable
	folder = engine.HOME / "data/godot/export_templates" / version
	folder.mkdir(parents=True, exist_ok=True)
	for kind in KINDS:
		place = folder / f"linux_{kind}.x86_64"
		place.unlink(missing_ok=True)
		place.symlink_to(machine.program(f"godot-template-{kind}"))


def export(out, debug, tests=False):
	kind = "debug" if debug or tests else "release"
	folder = pathlib.Path(out).resolve()
	if folder == PROJECT or PROJECT in folder.parents:
		raise Failure("OUT must lie outside of the project that is packed.", 2)
	build.scons("extension", f"target={kind}")
	templates = [f"godot-template-{kind}" for kind in KINDS]  # the engine asks for both
	machine.ensure((lambda: all(map(machine.program, templates)), tuple(templates)))
	engine.import_project()
	install_templates()
	folder.mkdir(parents=True, exist_ok=True)
	pack(f"--export-{kind}", TESTS_PRESET if tests else PRESET, folder / NAME, folder / f"{NAME}.pck")
	say(f"Packed: {', '.join(sorted(file.name for file in folder.iterdir()))} in {folder}")
	say("Debian's template needs Debian's libraries: elsewhere, put a template of your own in the place of " + NAME)


def pack(how, preset, file, pck):
	output = []
	command, environment = engine.headless()
	with progress("Packing the project"):
		code = engine.run([*command, "--path", str(PROJECT), how, preset, str(file)], environment, output.append)
	if code or not pck.exists():
		raise Failure("The engine could not pack the project:\n" + "\n".join(output[-30:]))


def benchmark(out, times):
	"""Exports everything that another machine's GPU needs for the benchmarks: OUT/bench.pck, the library, shaders, recorded problems, and
	all.sh, which runs the parts. `times`: seconds that they took, by name."""
	from tools.bench import accuracy, commits, parts

	folder = pathlib.Path(out).resolve()
	build.scons("extension", "accuracy")
	engine.import_project()
	folder.mkdir(parents=True, exist_ok=True)
	pack("--export-pack", BENCH_PRESET, folder / "bench.pck", folder / "bench.pck")
	add(folder, [*(BUILD / "bench").glob("*.spv"), ALL_PARTS])
	accuracy.record(folder / "packs", False)
	(folder / "commit").write_text(commits.measured() + "\n")
	(folder / "parts").write_text("\n".join([*parts.listing(times), ""]))
	say(f"Packed, commit {commits.measured()}:")
	carry(folder)
	say("docs/benchmarks/HOWTO.md describes how to run it: all.sh SECONDS OUT")


def pictures(out, recordings):
	"""Exports everything that another machine's GPU needs for the pictures of the docs: OUT/demo.pck, the library, the list `recordings`,
	and pictures.sh, which takes them."""
	folder = pathlib.Path(out).resolve()
	build.scons("extension")
	engine.import_project()
	folder.mkdir(parents=True, exist_ok=True)
	pack("--export-pack", PRESET, folder / "demo.pck", folder / "demo.pck")
	add(folder, [RECORD_ALL])
	(folder / "recordings").write_text("\n".join([*recordings, ""]))
	carry(folder)
	say("There: pictures.sh RECORDED, and then here: ./grass pictures --put RECORDED")


def add(folder, files):
	"""Copies the library and `files` into a pack."""
	libraries = [path for path in ADDON_BIN.glob("*.template_debug.*.so") if ".double." not in path.name]
	for file in [*libraries, *files]:
		shutil.copy(file, folder)
	if strip := shutil.which("strip"):  # less to carry
		subprocess.run([strip, "--strip-debug", *folder.glob("*.so")])


def carry(folder):
	carried = folder.with_name(f"{folder.name}.tar.xz")
	with tarfile.open(carried, "w:xz") as archive:
		archive.add(folder, folder.name)
	say(f"{', '.join(sorted(file.name for file in folder.iterdir()))} in {folder}")
	say(f"To carry: {carried}, {carried.stat().st_size / 1e6:.1f} MB")
