# SPDX-License-Identifier: MIT
"""The demo's page (tools/release/page.py) played in Chromium, on software WebGL: for the layer `web`."""

import contextlib
import functools
import json
import os
import re
import shutil
import subprocess

from tools.build import emscripten
from tools.fetch import machine
from tools.fetch.roots import BROWSER
from tools.places import ROOT
from tools.release import page, release, trial
from tools.run import engine
from tools.say import Failure, progress

TESTS = ROOT / "tests/web"
FOLDER = page.WORK / "site"  # the page, told to tell what it sees
PICTURES = page.WORK / "pictures"
PLAY_LIMIT, DESKTOP_LIMIT = 700, 600  # seconds
APART_MOST, FAR_MOST = 4.0, 40.0  # of the page's first picture from the desktop's, in steps of 255
LIGHTER_LEAST = 12.0  # of a square without shadows
HARMLESS = re.compile(r"favicon\.ico|^WARNING: (?:All|Some) |swiftshader|GL Driver Message|GPU stall")
WORDS = "GrassField page: "


def browser():
	"""The path of Chromium: the machine's, or the fetched one. None if there is neither."""
	fetched = BROWSER.place / "usr/lib/chromium/chromium"
	return shutil.which("chromium") or shutil.which("google-chrome") or (str(fetched) if fetched.exists() else None)


def picture_on_desktop():
	"""The page's first picture, as this machine's engine draws it with the same renderer."""
	file = PICTURES / "desktop.png"
	said = []
	with engine.window("gl_compatibility", "320x180", software=True) as (command, environment):
		arguments = ["--path", str(page.PROJECT), "--", "--tell", "yes", "--picture", str(file)]
		code = engine.run([*command, *arguments], environment, said.append, DESKTOP_LIMIT)
	if code or not file.exists():
		raise Failure("The scene does not run on this machine:\n" + "\n".join(said[-20:]))


def told():
	"""A copy of the page whose scene is started as a test."""
	shutil.rmtree(FOLDER, ignore_errors=True)
	shutil.copytree(page.OUT / "page", FOLDER)
	index = FOLDER / "index.html"
	text = index.read_text()
	if '"args":[]' not in text:
		raise Failure("The page's index.html takes arguments in another way.")
	index.write_text(text.replace('"args":[]', '"args":["--","--tell","yes"]'))


@functools.cache
def played():
	"""What the page said: (lines of its console, what failed, what its scene told)."""
	machine.ensure((browser, ("chromium", "patchelf"), BROWSER))
	shutil.rmtree(PICTURES, ignore_errors=True)
	PICTURES.mkdir(parents=True)
	told()
	with page.served(FOLDER) as address, progress("Playing the page", every=30):
		command = [emscripten.PROGRAM, TESTS / "play.mjs", browser(), f"{address}index.html", PICTURES]
		environment = {**os.environ, **emscripten.QUIET}
		result = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=PLAY_LIMIT, env=environment)
	lines, failed, facts = [], [], []
	for row in result.stdout.splitlines():
		with contextlib.suppress(json.JSONDecodeError):
			row = json.loads(row)
			lines += [row["said"]] if "said" in row else []
			failed += [row["failed"]] if "failed" in row else []
	facts = [json.loads(line.removeprefix(WORDS)) for line in lines if line.startswith(WORDS)]
	failed += [result.stderr[-2000:]] if result.returncode and not failed else []
	(PICTURES / "console.txt").write_text("\n".join([*lines, *failed]))
	return lines, failed, facts


@functools.cache
def compared():
	"""What tests/release/compare.gd says of pairs of pictures, by their names."""
	played()
	picture_on_desktop()
	pairs = (("desktop", "stands"), ("stands", "without_shadows"))
	command, environment = engine.headless()
	return dict(zip(pairs, trial.pictures_apart(command, [[PICTURES / f"{name}.png" for name in pair] for pair in pairs], environment)))


def expect(condition, text):
	if not condition:
		raise Failure(text)


def console_is_clean():
	lines, failed, _ = played()
	wrong = failed + [line for line in lines if re.match(r"(?:USER |SCRIPT )?(?:ERROR|WARNING):", line)]
	wrong = [line for line in wrong if not HARMLESS.search(line)]
	expect(not wrong, "\n".join(wrong[:10]))


def grass_stands():
	facts = played()[2]
	expect(facts, "the scene told nothing")
	first = facts[0]
	expect(first["does"] == "stands" and first["backend"] == "CPU" and first["version"] == release.version(), f"it tells {first}")
	expect(first["blades"] > 40000 and first["drawn_tiles"] > 20, f"it tells {first}")


def painting_holds():
	first = played()[2][0]
	expect(first["beside_path"] > 0.15, f"grass stands {first['beside_path']:.2f} m tall beside the path")
	expect(0 < first["on_path"] < 0.5 * first["beside_path"], f"grass stands {first['on_path']:.2f} m tall on the path")


def world_stands():
	first = played()[2][0]
	expect(first["plots"] >= 4 and first["in_country"] > 0.1, f"it tells {first}")


def key_rolls_the_ball():
	facts = played()[2]
	rolled = [one for one in facts if one["ball"] - facts[0]["ball"] > 0.5]
	expect(rolled, f"the ball was at {facts[0]['ball']} m and is at {facts[-1]['ball']} m")
	expect(max(one["bend"] for one in rolled) > 0.2, "the ball bent no grass on its way")


def space_mows():
	facts = played()[2]
	expect(facts[0]["mown"] == 0 and facts[-1]["mown"] > 0, f"{facts[0]['mown']} to {facts[-1]['mown']} of the lawn are mown")


def looks_as_on_the_desktop():
	found = compared()["desktop", "stands"]
	expect(found["apart"] <= APART_MOST and found["far"] <= FAR_MOST, f"{found} in {PICTURES}")


def sun_casts_shadows():
	found = compared()["stands", "without_shadows"]
	expect(found["lighter"] >= LIGHTER_LEAST, f"{found} in {PICTURES}")


CHECKS = {
	"opens, and its console holds no error": console_is_clean,
	"grass stands, with cards": grass_stands,
	"what was painted holds": painting_holds,
	"a world's plots stand": world_stands,
	"a key rolls the ball, which bends grass": key_rolls_the_ball,
	"the space bar mows": space_mows,
	"its picture is the desktop's": looks_as_on_the_desktop,
	"the sun casts shadows": sun_casts_shadows,
}
