# SPDX-License-Identifier: MIT
"""The demo's film: the engine's movie writer records it, ffmpeg makes a video and a loop of it."""

import pathlib
import re
import subprocess

from tools.fetch import machine
from tools.places import OUT, PROJECT
from tools.run import engine, scenes
from tools.say import Failure, progress, say

SCENE = "res://demo/film.tscn"
RATE = 60  # frames a second
SIZE = "1280x720"  # the project's: the movie writer takes no other
FFMPEG = (lambda: machine.program("ffmpeg"), ("ffmpeg", "patchelf"))
MOST_BYTES = 6_000_000  # of the loop, which opens the README
LOOP = {"width": 480, "qualities": (60, 50, 40, 30)}  # the best that is not too large
SAYS = re.compile(r"film: from frame (\d+), (\d+) frames, fade (\d+)")


def record(out):
	"""Records the film into `out` and encodes it."""
	scenes.ready(SCENE)
	engine.import_project()
	folder = pathlib.Path(out or OUT / "film").resolve()
	folder.mkdir(parents=True, exist_ok=True)
	movie, said = folder / "film.avi", []
	with engine.window(size=SIZE) as (command, environment), progress("Recording the film", every=10):
		arguments = ["--write-movie", str(movie), "--fixed-fps", str(RATE), "--path", str(PROJECT), SCENE]
		code = engine.run([*command, *arguments], environment, said.append, scenes.LIMIT, silence=scenes.LIMIT)
	if code or not movie.exists():
		raise Failure("The film was not recorded:\n" + "\n".join(said[-20:]))
	encode(folder, "\n".join(said))


def encode_recorded(folder):
	"""Encodes FOLDER/film.avi from another machine; FOLDER/film.log is the output of the scene."""
	folder = pathlib.Path(folder).resolve()
	missing = [name for name in ("film.avi", "film.log") if not (folder / name).exists()]
	if missing:
		raise Failure(f"{folder} has no {' and no '.join(missing)}.", 2)
	encode(folder, (folder / "film.log").read_text())


def encode(folder, said):
	"""FOLDER/film.avi -> film.mp4 and film.webp, which both loop. `said`: output of the scene, which names the frames of the film."""
	machine.ensure(FFMPEG)
	found = SAYS.search(said)
	if not found:
		raise Failure("The scene did not say where its film begins.")
	first, frames, fade = (int(number) for number in found.groups())
	mp4, webp = folder / "film.mp4", folder / "film.webp"
	ffmpeg(
		folder,
		first,
		frames,
		fade,
		"",
		mp4,
		"-c:v",
		"libx264",
		"-crf",
		"20",
		"-preset",
		"slow",
		"-pix_fmt",
		"yuv420p",
		"-movflags",
		"+faststart",
	)
	for quality in LOOP["qualities"]:
		scale = f",scale={LOOP['width']}:-2:flags=lanczos"
		ffmpeg(
			folder,
			first,
			frames,
			fade,
			scale,
			webp,
			"-c:v",
			"libwebp_anim",
			"-quality",
			str(quality),
			"-compression_level",
			"5",
			"-loop",
			"0",
		)
		if webp.stat().st_size <= MOST_BYTES:
			break
	else:
		raise Failure(f"The loop has {webp.stat().st_size} bytes, more than {MOST_BYTES}.")
	say(
		f"The film is in {folder}: film.mp4, {mp4.stat().st_size / 1e6:.1f} MB, and film.webp, {webp.stat().st_size / 1e6:.1f} MB (quality {quality})"
	)


def ffmpeg(folder, first, frames, fade, filters, target, *codec):
	"""The film's frames; the frames after its end fade into its beginning, so that the loop has no cut."""
	graph = (
		f"[0:v]trim=start_frame={first}:end_frame={first + frames},setpts=PTS-STARTPTS,fps={RATE},split[a][b];"
		f"[a]trim=end_frame={fade},setpts=PTS-STARTPTS[begin];[b]trim=start_frame={fade},setpts=PTS-STARTPTS[rest];"
		f"[0:v]trim=start_frame={first + frames}:end_frame={first + frames + fade},setpts=PTS-STARTPTS,fps={RATE}[after];"
		f"[after][begin]xfade=transition=fade:duration={fade / RATE}:offset=0[joint];[joint][rest]concat=n=2:v=1{filters}[film]"
	)
	command = [machine.program("ffmpeg"), "-y", "-loglevel", "error", "-i", str(folder / "film.avi"), "-filter_complex", graph]
	result = subprocess.run([*command, "-map", "[film]", "-r", str(RATE), "-an", *codec, str(target)], capture_output=True, text=True)
	if result.returncode:
		raise Failure(f"ffmpeg could not make {target.name}:\n{result.stderr}")
