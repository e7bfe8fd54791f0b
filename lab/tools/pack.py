# SPDX-License-Identifier: MIT
"""Packs for another machine's GPU: the benchmarks, and the recordings of the docs' pictures."""

import pathlib
import shutil
import subprocess
import tarfile

from lab.tools import accuracy, commits, lab_project, parts
from tools.build import build
from tools.places import ADDON_BIN, BUILD, ROOT
from tools.release import export
from tools.say import say

BENCHMARK = "Benchmark"  # of lab/project/export_presets.cfg: res://bench/bench.tscn is the main scene
ALL_PARTS = ROOT / "lab/tools/all.sh"
RECORD_ALL = ROOT / "lab/tools/pictures.sh"


def packed(preset, folder, name, *targets):
	build.scons("extension", *targets)
	lab_project.make()
	folder.mkdir(parents=True, exist_ok=True)
	export.pack("--export-pack", preset, folder / name, folder / name, lab_project.PLACE)


def benchmark(out, times):
	"""Exports everything that another machine's GPU needs for the benchmarks: OUT/bench.pck, the library, shaders, recorded problems, and
	all.sh, which runs the parts. `times`: seconds that they took, by name."""
	folder = pathlib.Path(out).resolve()
	packed(BENCHMARK, folder, "bench.pck", "accuracy")
	add(folder, [*(BUILD / "bench").glob("*.spv"), ALL_PARTS])
	accuracy.record(folder / "packs", False)
	(folder / "commit").write_text(commits.measured() + "\n")
	(folder / "parts").write_text("\n".join([*parts.listing(times), ""]))
	say(f"Packed, commit {commits.measured()}:")
	carry(folder)
	say("lab/results/HOWTO.md describes how to run it: all.sh SECONDS OUT")


def pictures(out, recordings):
	"""Exports everything that another machine's GPU needs for the pictures of the docs: OUT/demo.pck, the library, the list `recordings`,
	and pictures.sh, which takes them."""
	folder = pathlib.Path(out).resolve()
	packed(export.PRESET, folder, "demo.pck")
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
