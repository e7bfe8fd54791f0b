# SPDX-License-Identifier: MIT
"""What Mesa's compilers make of each pipeline: registers, spills, scratch, code. `./grass bench drivers` writes the table.

Each pass is compiled in all its variants, by both methods, with one tile in a workgroup, a crowded one or many, for cards
that need not be here. The layers `drivers` and `lab` compare that with the committed table.
"""

import concurrent.futures
import csv
import datetime
import os
import pathlib
import subprocess
from dataclasses import dataclass

from lab.tools import driver_tools
from tools.build import build, embed, spirv
from tools.places import BUILD, OUT, ROOT
from tools.say import Failure, progress, say

SPIRV = BUILD / "gen/spirv"
TABLE = ROOT / "lab/results/drivers/drivers.csv"
KEYS = ("card", "pass", "method", "tiles")
FIGURES = ("registers", "spills", "scratch", "code")
COLUMNS = (*KEYS, *FIGURES, "seconds")
MARGIN = 1.05  # a figure may grow so far
METHODS = {"DIRECT": 0, "PBD": 1}  # values of GRASS_CONSTANT_METHOD
TILES = {"one": 0, "crowd": 1, "many": 2}  # values of GRASS_CONSTANT_TILES
CROWDED = "edges"  # the variant that fields take for crowds (gpu/field_passes.cpp)
LETTERS = {"buffer": "b", "uniforms": "u", "image": "i", "texture": "t", "plain texture": "p", "sampler": "s"}  # of pipelines.c


@dataclass(frozen=True)
class Card:
	title: str
	driver: str  # of Mesa
	environment: dict  # that makes the driver take this card
	statistics: dict  # the driver's, for our figures: those of one figure are added
	is_slow: bool = False  # its compiler takes ten times as long: variants for species, which differ by some 2 %, are left out

	def figures(self, said):
		"""Returns our figures of what the driver said of a pipeline. Intel's may have several programs: the largest counts."""
		largest = {name: max(map(int, values)) for name, values in said.items() if name != "seconds"}
		return {figure: sum(largest.get(name, 0) for name in names) for figure, names in self.statistics.items()}


AMD = {"registers": ["VGPRs"], "spills": ["Spilled VGPRs", "Spilled SGPRs"], "scratch": ["Scratch size"], "code": ["Code size"]}
INTEL = {
	"registers": ["Max live registers"], "spills": ["Spill Count"], "scratch": ["Scratch Memory Size"], "code": ["Instruction Count"],
}  # fmt: skip
SHIM = {"LD_PRELOAD": str(driver_tools.MESA / "libintel_noop_drm_shim.so")}
CARDS = {
	"vangogh": Card("Steam Deck (RDNA 2)", "radeon", {"RADV_FORCE_FAMILY": "vangogh"}, AMD),
	"navi21": Card("Radeon RX 6800 (RDNA 2)", "radeon", {"RADV_FORCE_FAMILY": "navi21"}, AMD),
	"navi33": Card("Radeon RX 7600 (RDNA 3)", "radeon", {"RADV_FORCE_FAMILY": "navi33"}, AMD),
	"polaris10": Card("Radeon RX 480 (GCN 4)", "radeon", {"RADV_FORCE_FAMILY": "polaris10"}, AMD),
	"skl": Card("Intel HD 530 (Gen 9)", "intel", {**SHIM, "INTEL_STUB_GPU_PLATFORM": "skl"}, INTEL, True),
	"tgl": Card("Intel Iris Xe (Gen 12)", "intel", {**SHIM, "INTEL_STUB_GPU_PLATFORM": "tgl"}, INTEL, True),
}
QUICK = "vangogh"


def label_of(name, method, tiles):
	return " ".join(filter(None, (name, method, tiles.replace("one", ""))))


@dataclass(frozen=True)
class Pipeline:
	file: pathlib.Path
	name: str  # of the pass and its variant: `simulate edges`
	method: str  # "" where there is but one
	tiles: str  # "" where there is but one kind

	def key(self):
		return self.name, self.method, self.tiles

	def family(self):
		return self.name.split()[0]

	def label(self):
		return label_of(*self.key())

	def job(self):
		"""Returns a line for lab/drivers/pipelines.c."""
		bound = " ".join(f"{number}:{LETTERS[binding.kind]}" for number, binding in sorted(spirv.read_file(self.file).bindings.items()))
		return f"{self.label().replace(' ', '_')} {self.file} {METHODS.get(self.method, 0)} {TILES.get(self.tiles, 0)} {bound}\n"


def passes():
	"""Returns the SPIR-V that the build made of each pass and its variants: {`simulate species edges`: file}."""
	found = {}
	for source in sorted(ROOT.glob("shaders/*/*.glsl")):
		for _, suffix, name in embed.variants(source.relative_to(ROOT).as_posix()):
			label = source.stem + suffix.removeprefix("_GRASS").lower()
			found[label.replace("_", " ")] = SPIRV / name
	if lacking := [file.name for file in found.values() if not file.exists()]:
		raise Failure(f"{SPIRV} lacks {', '.join(lacking)}: `./grass build shaders` makes them.")
	return found


def pipelines(with_species=True):
	"""Returns what a field may ask a driver for."""
	found = []
	for name, file in passes().items():
		if "species" in name and not with_species:
			continue
		has_kinds = bool(spirv.read_file(file).constants)
		kinds = [(method, tiles) for method in METHODS for tiles in TILES if is_wanted(name, method, tiles)] if has_kinds else [("", "")]
		found += [Pipeline(file, name, method, tiles) for method, tiles in kinds]
	return found


def is_wanted(name, method, tiles):
	"""Returns whether a field takes the variant `name` of simulate by this method for such tiles."""
	return tiles != "crowd" or name.endswith(CROWDED)


def of_card(name):
	"""Returns the pipelines that the table has of a card."""
	return pipelines(not CARDS[name].is_slow)


def compile_for(name, chosen):
	"""Returns rows of the table: of card `name`, for the `chosen` pipelines."""
	card = CARDS[name]
	jobs = driver_tools.FOLDER / f"{name}.list"
	jobs.parent.mkdir(parents=True, exist_ok=True)
	jobs.write_text("".join(pipeline.job() for pipeline in chosen))
	said = driver_tools.make_pipelines(card.driver, jobs, card.environment)
	rows = []
	for pipeline in chosen:
		of_this = said.get(pipeline.label().replace(" ", "_"), {})
		if "seconds" not in of_this:
			raise Failure(f"{name}: the driver refused {pipeline.label()}: VkResult {''.join(of_this.get('refused', ['unknown']))}")
		key = dict(zip(KEYS, (name, *pipeline.key())))
		rows.append({**key, **card.figures(of_this), "seconds": of_this["seconds"][0]})
	return rows


def compile_all(chosen):
	"""For pipelines by card yields (card, its rows or the Failure), as many at a time as there are processors."""
	with progress(f"Compiling {sum(map(len, chosen.values()))} pipelines for {', '.join(chosen) or 'no card'}", every=30):
		with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
			running = {pool.submit(compile_for, name, some): name for name, some in chosen.items()}
			for done in concurrent.futures.as_completed(running):
				yield running[done], done.exception() or done.result()


def key_of(row):
	return tuple(row[name] for name in KEYS)


def read():
	"""Returns (what the committed table says of its making, its rows by key)."""
	lines = TABLE.read_text().splitlines() if TABLE.exists() else []
	rows = csv.DictReader(line for line in lines if not line.startswith("#"))
	return [line[2:] for line in lines if line.startswith("#")], {key_of(row): row for row in rows}


def grown(row, known):
	"""Returns what has grown too far against the table's row, in words; "" if nothing has."""
	if known is None:
		return "the table lacks it"
	pairs = ((figure, int(known[figure]), int(row[figure])) for figure in FIGURES)
	return ", ".join(f"{figure} grew from {old:,} to {new:,}" for figure, old, new in pairs if new > old * MARGIN)


def commit():
	"""Returns the commit that changed shaders last, and whether they have changed since."""

	def git(*arguments):
		return subprocess.run(["git", *arguments, "--", "shaders"], cwd=ROOT, capture_output=True, text=True).stdout.strip()

	return f"commit {git('log', '-1', '--format=%h') or 'unknown'}" + (" with changes" if git("status", "--porcelain") else "")


def made_by(notes, card, family):
	"""Returns what a table says of the making of a card's rows for the passes of a family: `simulate` for `simulate edges`."""
	by_label = dict(note.split(": ", 1) for note in notes)
	return by_label.get(f"{card} {family}", by_label.get(card, ""))


def write(rows, families, folder, command):
	"""Writes the table: `rows`, and what the committed one has beside them. `families`: the passes that they are of, if not of all."""
	notes, known = read()
	note = f"Mesa {driver_tools.mesa_version()}; {commit()}; {command}; {datetime.date.today()}"
	labels = dict(line.split(": ", 1) for line in notes)
	for card in {row["card"] for row in rows}:
		if not families:
			labels = {label: text for label, text in labels.items() if label.split()[0] != card}
		labels.update({f"{card} {family}": note for family in families} or {card: note})
	built = {(card, *one.key()) for card in CARDS for one in of_card(card)}
	made = {key_of(row): row for row in rows}
	rows = [row for key, row in {**known, **made}.items() if key in built]
	rows.sort(key=lambda row: (list(CARDS).index(row["card"]), *key_of(row)[1:]))
	folder.mkdir(parents=True, exist_ok=True)
	with open(folder / TABLE.name, "w", newline="") as file:
		file.writelines(f"# {label}: {text}\n" for label, text in sorted(labels.items()))
		writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
		writer.writeheader()
		writer.writerows(rows)


def run(out, only):
	"""`./grass bench drivers`: the table anew; `only`: for these cards, of these passes. Returns whether it is the table of the docs."""
	build.scons("shaders")
	driver_tools.ensure()
	words = only.split(",") if only else []
	names = [name for name in CARDS if name in words or not set(words) & set(CARDS)]
	families = [word for word in words if word not in CARDS]
	known = {one.family() for one in pipelines()}
	if unknown := set(families) - known:
		raise Failure(f"--only takes some of {', '.join([*CARDS, *sorted(known)])}, not {', '.join(sorted(unknown))}.", 2)
	if any(CARDS[name].driver == "intel" for name in names):
		driver_tools.ensure_mesa()
	rows = []
	for name, made in compile_all({name: [one for one in of_card(name) if not families or one.family() in families] for name in names}):
		if isinstance(made, Exception):
			raise made
		rows += made
	folder = pathlib.Path(out or OUT / "bench").resolve() / "drivers"
	write(rows, families, folder, f"./grass bench drivers{f' --only {only}' if only else ''}")
	say(f"{folder / TABLE.name}: {len(rows)} pipelines")
	return folder == TABLE.parent
