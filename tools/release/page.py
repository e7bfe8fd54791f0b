# SPDX-License-Identifier: MIT
"""`./grass page`: the demo as a page that a browser plays, in the engine for Web that tools/build/web_template.py builds."""

import contextlib
import functools
import http.server
import pathlib
import re
import shutil
import threading
import zipfile

from tools.build import build, names, web_template
from tools.fetch import machine
from tools.places import ADDON_BIN, BUILD, OUT, ROOT
from tools.release import release
from tools.run import engine
from tools.say import Failure, progress, say

WORK = BUILD / "page"
PROJECT = WORK / "project"
SCENE = "res://demo/page.tscn"
PRESETS = ROOT / "tools/release/page/export_presets.cfg"
WEB = release.Target("web", "wasm32", "release", threads=False)


def make_project(template):
	"""The demo with the add-on as it ships, for this machine's editor and for Web; its main scene is the page."""
	here = release.Target(*names.HERE, "debug")
	release.pack({here: ADDON_BIN / here.library, WEB: WEB.built}, WORK / "packed")
	shutil.rmtree(PROJECT, ignore_errors=True)
	with zipfile.ZipFile(WORK / f"packed/grass_field-demo-{release.version()}.zip") as file:
		file.extractall(PROJECT)
	settings = PROJECT / "project.godot"
	text = re.sub(r"(?m)^run/main_scene=.*$", f'run/main_scene="{SCENE}"', settings.read_text())
	# The template reads no WebP, as which the editor keeps pictures by itself.
	settings.write_text(text.replace("[rendering]\n", "[rendering]\n\ntextures/lossless_compression/force_png=true\n"))
	(PROJECT / "export_presets.cfg").write_text(PRESETS.read_text().replace("TEMPLATE", str(template)))


def export(folder):
	"""Exports the project as index.html and its files into a new `folder`. Returns what the engine said."""
	shutil.rmtree(folder, ignore_errors=True)
	folder.mkdir(parents=True)
	command, environment = engine.headless()
	said = []
	with progress("Packing the page", every=10):
		code = engine.run(
			[*command, "--path", str(PROJECT), "--export-release", "Page", str(folder / "index.html")], environment, said.append
		)
	words = "\n".join(said)
	if code or not (folder / "index.html").exists() or re.search(r"^(SCRIPT )?ERROR:", words, re.MULTILINE):
		raise Failure(f"The engine could not pack the page:\n{words[-3000:]}")


def make(out=None):
	"""Builds everything, and exports. Returns the folder with index.html."""
	template = web_template.ensure()
	machine.ensure(*machine.BUILDING)
	build.scons("extension")
	build.scons("extension", "symbols=yes", *WEB.options)
	make_project(template)
	engine.import_project(PROJECT)
	folder = pathlib.Path(out or OUT / "page").resolve()
	export(folder)
	say(f"Packed, for any server: {folder}")
	return folder


class Files(http.server.SimpleHTTPRequestHandler):
	extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, ".wasm": "application/wasm"}

	def log_message(self, *_):
		pass


@contextlib.contextmanager
def served(folder):
	"""Serves a folder to this machine. Yields its address."""
	server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Files, directory=str(folder)))
	threading.Thread(target=server.serve_forever, daemon=True).start()
	try:
		yield f"http://127.0.0.1:{server.server_address[1]}/"
	finally:
		server.shutdown()
		server.server_close()


def serve(out=None):
	"""Makes the page, and serves it until somebody stops it."""
	with served(make(out)) as address:
		say(f"Open {address} in a browser; Ctrl+C ends this.")
		threading.Event().wait()
