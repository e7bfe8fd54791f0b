# SPDX-License-Identifier: MIT
"""The pictures of the docs that a GPU draws: records them here, lists them for a pack, and writes docs/images.

Each recording is a process of its own, which a place of the demo ends when its pictures are taken.
"""

import os
import pathlib
import shutil

from lab.tools import film, gallery, lab_project
from tools.fetch import machine
from tools.places import OUT, ROOT
from tools.run import engine, scenes
from tools.say import Failure, progress, say

IMAGES = ROOT / "docs/images"
RATE = ["--fixed-fps", str(film.RATE)]  # so that a slow frame shows what a quick one does
SIZE = "1920x1080"
SIZES = {"film": film.SIZE}  # of the others' windows
QUALITY = 4  # ffmpeg's scale, 2 is best
FRAMES = {"film": "frames"}  # the folder in a recording's own where film.py looks for them
# Place of the demo -> picture of the docs: what the place calls it, and its width in pixels. Places without pictures have a function below.
RECORDINGS = {
	"demo": {"meadow": ("3_at_1.2_s", 1280), "awake_tiles": ("8_birds_eye_awake_tiles", 960)},
	"forces": {"forces": ("blast_at_1.25", 1280)},
	"burning": {"burning": ("front_at_8", 960)},
	"levels": {"levels": ("levels_at_2", 960)},
	"meadow": {"demo_meadow": ("view_at_2", 960)},
	"lawn": {"demo_lawn": ("stripes_at_3", 960)},
	"reeds": {"demo_reeds": ("bow_at_5", 960)},
	"walk": {"demo_walk": ("5_jeep", 960)},
	"presets": {},
	"pairs": {},
	"gallery": {},
	"film": {},
}


def chosen(only):
	names = only.split(",") if only else list(RECORDINGS)
	if unknown := set(names) - set(RECORDINGS):
		raise Failure(f"There is no recording {', '.join(sorted(unknown))}; there are {', '.join(RECORDINGS)}.", 2)
	return names


def record(out, only):
	"""Records here, into OUT/NAME each."""
	folder = pathlib.Path(out or OUT / "pictures").resolve()
	lab_project.ready()
	kind = "large" if machine.gpu() and machine.display() else "small"
	for name in chosen(only):
		to = folder / name / FRAMES.get(name, "")
		to.mkdir(parents=True, exist_ok=True)
		said = []
		with engine.window(size=SIZES.get(name, SIZE)) as (command, environment), progress(f"Recording {name}", every=10):
			arguments = ["--path", str(lab_project.PLACE), f"res://demo/{name}.tscn", "--", "--out", str(to), "--size", kind]
			code = engine.run([*command, *RATE, *arguments], environment, said.append, scenes.LIMIT, silence=scenes.LIMIT)
		if code:
			raise Failure(f"{name} was not recorded:\n" + "\n".join(said[-20:]))
	say(f"Recorded: {folder}. `./grass pictures --put {folder}` makes the pictures of the docs of it")


def listing():
	"""Returns the lines of the pack's file `recordings`, which pictures.sh reads."""
	return [" ".join([name, SIZES.get(name, SIZE), os.path.join(name, FRAMES.get(name, "")), *RATE]) for name in RECORDINGS]


def put(recorded, only):
	"""Makes the pictures of the docs of what was recorded, here or on another machine."""
	folder = pathlib.Path(recorded).resolve()
	machine.ensure(film.FFMPEG)
	names = [name for name in chosen(only) if (folder / name).is_dir()]
	if not names:
		raise Failure(f"{folder} has no recordings. `./grass pictures` writes them.", 2)
	for name in names:
		for picture, (source, width) in RECORDINGS[name].items():
			gallery.shrink(folder / name / f"{source}.png", IMAGES / f"{picture}.jpg", width, QUALITY)
		if name in WRITERS:
			WRITERS[name](folder / name)
	say(f"Written: the pictures of {', '.join(names)} in {IMAGES.relative_to(ROOT)}")


def copy_to(target):
	def copy(folder):
		for file in sorted(folder.glob("*.jpg")):
			shutil.copy(file, target)

	return copy


def write_film(folder):
	film.encode(folder)
	for name in ("film.mp4", "film.webp"):
		shutil.copy(folder / name, IMAGES)


WRITERS = {"presets": copy_to(IMAGES), "pairs": copy_to(IMAGES / "pairs"), "gallery": gallery.write_page, "film": write_film}
