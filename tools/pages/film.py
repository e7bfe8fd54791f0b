# SPDX-License-Identifier: MIT
"""The film: the engine writes its frames, ffmpeg makes a video of them and the loop that opens the README."""

import pathlib
import subprocess

from tools.fetch import machine
from tools.places import OUT, PROJECT
from tools.run import engine, scenes
from tools.say import Failure, progress, say

SCENE = "res://demo/film.tscn"
RATE = 30  # frames a second
SIZE = "1280x720"
FFMPEG = (lambda: machine.program("ffmpeg"), ("ffmpeg", "patchelf"))
VIDEO = {"most": 8_000_000, "qualities": (20, 22, 24, 26, 28, 30, 32)}  # bytes; x264's scale, the best that is not too large
LOOP = {"most": 6_000_000, "width": 960, "rate": 15, "qualities": (60, 50, 40, 30, 20)}  # libwebp's scale


def record(out):
	"""Records the film into `out` and encodes it."""
	scenes.ready(SCENE)
	engine.import_project()
	folder = pathlib.Path(out or OUT / "film").resolve()
	frames = folder / "frames"
	frames.mkdir(parents=True, exist_ok=True)
	size = "large" if machine.gpu() and machine.display() else "small"
	said = []
	with engine.window(size=SIZE) as (command, environment), progress("Recording the film", every=10):
		arguments = ["--fixed-fps", str(RATE), "--path", str(PROJECT), SCENE, "--", "--out", str(frames)]
		code = engine.run([*command, *arguments, "--size", size], environment, said.append, scenes.LIMIT, silence=scenes.LIMIT)
	if code:
		raise Failure("The film was not recorded:\n" + "\n".join(said[-20:]))
	encode(folder)


def encode(folder):
	"""FOLDER/frames, recorded here or on another machine -> FOLDER/film.mp4 and film.webp."""
	machine.ensure(FFMPEG)
	folder = pathlib.Path(folder).resolve()
	if not any((folder / "frames").glob("*.webp")):
		raise Failure(f"{folder}/frames has no pictures. `./grass demo --video` writes them.", 2)
	h264 = ["-c:v", "libx264", "-preset", "veryslow", "-tune", "film", "-pix_fmt", "yuv420p", "-movflags", "+faststart"]
	best(folder, folder / "film.mp4", VIDEO, [], [*h264, "-crf"])
	small = ["-vf", f"fps={LOOP['rate']},scale={LOOP['width']}:-2:flags=lanczos"]
	best(folder, folder / "film.webp", LOOP, small, ["-c:v", "libwebp_anim", "-compression_level", "6", "-loop", "0", "-quality"])


def best(folder, target, limits, filters, codec):
	"""Encodes the frames in the best quality of `limits` that is small enough; `codec` ends with the option that sets it."""
	for quality in limits["qualities"]:
		source = ["-framerate", str(RATE), "-pattern_type", "glob", "-i", str(folder / "frames/*.webp")]
		command = [machine.program("ffmpeg"), "-y", "-loglevel", "error", *source, *filters, *codec, str(quality), str(target)]
		result = subprocess.run(command, capture_output=True, text=True)
		if result.returncode:
			raise Failure(f"ffmpeg could not make {target.name}:\n{result.stderr}")
		size = target.stat().st_size
		if size <= limits["most"]:
			say(f"{target}: {size / 1e6:.1f} MB, quality {quality}")
			return
	raise Failure(f"{target} has {size} bytes, more than {limits['most']}.")
