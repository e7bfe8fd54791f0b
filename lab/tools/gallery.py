# SPDX-License-Identifier: MIT
"""The gallery: its page, docs/guide/gallery.md, and small pictures beside it. pictures.py renders its views."""

import json
import pathlib
import subprocess

from tools.fetch import machine
from lab.tools.film import FFMPEG
from tools.places import ROOT
from tools.say import Failure, say

PAGE = ROOT / "docs/guide/gallery.md"
PICTURES = ROOT / "docs/images/conditions"
WIDTH, QUALITY = 960, 6  # pixels; ffmpeg's scale, 2 is best
KINDS = {"msaa": "4x MSAA", "taa": "TAA"}
HEAD = """\
The same grass in many lights and from many places, each with 4x MSAA (left) and with TAA (right).
`./grass pictures --only gallery` made them on {device}, in Forward+ at 1920 x 1080.
The folder `lab/project/demo/gallery/` defines the views. How light grass is at each distance was
[measured](../../lab/results/light.md)."""


def write_page(folder):
	"""Writes the page. FOLDER: what was recorded of the gallery, here or on another machine."""
	machine.ensure(FFMPEG)
	folder = pathlib.Path(folder).resolve()
	if not (folder / "gallery.json").exists():
		raise Failure(f"{folder} has no gallery.json. `./grass pictures --only gallery` writes it.", 2)
	about = json.loads((folder / "gallery.json").read_text())
	PICTURES.mkdir(parents=True, exist_ok=True)
	device = "software Vulkan" if "llvmpipe" in about["device"] else f"an {about['device']}"
	lines = ["# Gallery", "", HEAD.format(device=device), ""]
	for view in about["views"]:
		for kind in KINDS:
			shrink(folder / f"{view['name']}_{kind}.jpg", PICTURES / f"{view['name']}_{kind}.jpg", WIDTH, QUALITY)
		lines += section(view)
	PAGE.write_text("\n".join(lines))
	say(f"Written: {PAGE.relative_to(ROOT)} and {PICTURES.relative_to(ROOT)}")


def section(view):
	pictures = [f"![{view['about']}, {words}](../images/conditions/{view['name']}_{kind}.jpg)" for kind, words in KINDS.items()]
	return [
		f"## {view['about']}",
		"",
		f"| {' | '.join(KINDS.values())} |",
		"|---|---|",
		f"| {' | '.join(pictures)} |",
		"",
		*facts(view),
		"",
	]


def facts(view):
	return [f"- {fact[0].upper()}{fact[1:]}" for fact in view["settings"]]


def shrink(source, target, width, quality):
	command = [machine.program("ffmpeg"), "-y", "-loglevel", "error", "-i", str(source)]
	scale = ["-vf", f"scale={width}:-2:flags=lanczos", "-q:v", str(quality)]
	result = subprocess.run([*command, *scale, str(target)], capture_output=True, text=True)
	if result.returncode:
		raise Failure(f"ffmpeg could not make {target.name}:\n{result.stderr}")
