# SPDX-License-Identifier: MIT
"""The film: ffmpeg makes a video of its frames, and the loop that opens the README. pictures.py records them."""

import itertools
import pathlib
import subprocess
import tempfile

from tools.fetch import machine
from tools.say import Failure, say

RATE = 30  # frames a second
SIZE = "1280x720"
FFMPEG = (lambda: machine.program("ffmpeg"), ("ffmpeg", "patchelf"))
VIDEO = {"most": 8_000_000, "qualities": (28, 30, 31, 32, 33, 34, 35, 36)}  # bytes; x264's scale, the best that is not too large
LOOP = {"most": 6_000_000, "qualities": (50, 40, 35, 30, 25, 20)}  # libwebp's scale
# Each picture of a loop is whole, so it takes an excerpt of each shot: the middle.
LOOP_WIDTH, LOOP_RATE, LOOP_SECONDS = 800, 15, 1.2


def encode(folder):
	"""FOLDER/frames, recorded here or on another machine -> FOLDER/film.mp4 and film.webp."""
	machine.ensure(FFMPEG)
	folder = pathlib.Path(folder).resolve()
	if not any((folder / "frames").glob("*.webp")):
		raise Failure(f"{folder}/frames has no pictures. `./grass pictures --only film` records them.", 2)
	h264 = ["-c:v", "libx264", "-preset", "veryslow", "-tune", "film", "-pix_fmt", "yuv420p", "-movflags", "+faststart"]
	best(folder / "frames", RATE, folder / "film.mp4", VIDEO, [*h264, "-crf"])
	with tempfile.TemporaryDirectory() as excerpt:
		for number, frame in enumerate(excerpts(folder / "frames")):
			(pathlib.Path(excerpt) / f"{number:04d}.webp").symlink_to(frame)
		scale = ["-vf", f"scale={LOOP_WIDTH}:-2:flags=lanczos"]
		webp = ["-c:v", "libwebp_anim", "-compression_level", "6", "-loop", "0", "-quality"]
		best(pathlib.Path(excerpt), LOOP_RATE, folder / "film.webp", LOOP, [*scale, *webp])


def excerpts(frames):
	"""The frames of the loop. A frame is called NUMBER_SHOT_FRAME.webp."""
	shots = itertools.groupby(sorted(frames.glob("*.webp")), lambda frame: frame.name.rpartition("_")[0])
	for shot in (list(found) for _, found in shots):
		first = max(0, int(0.5 * (len(shot) - LOOP_SECONDS * RATE)))
		yield from shot[first : first + int(LOOP_SECONDS * RATE) : RATE // LOOP_RATE]


def best(frames, rate, target, limits, codec):
	"""Encodes frames in the best quality of `limits` that is small enough; `codec` ends with the option that sets it."""
	for quality in limits["qualities"]:
		source = ["-framerate", str(rate), "-pattern_type", "glob", "-i", str(frames / "*.webp")]
		command = [machine.program("ffmpeg"), "-y", "-loglevel", "error", *source, *codec, str(quality), str(target)]
		result = subprocess.run(command, capture_output=True, text=True)
		if result.returncode:
			raise Failure(f"ffmpeg could not make {target.name}:\n{result.stderr}")
		size = target.stat().st_size
		if size <= limits["most"]:
			say(f"{target}: {size / 1e6:.1f} MB, quality {quality}")
			return
	raise Failure(f"{target} has {size} bytes, more than {limits['most']}.")
