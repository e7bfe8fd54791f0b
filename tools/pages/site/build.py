# SPDX-License-Identifier: MIT
"""Makes the site, out/site: the pages of docs/ and the class reference, by MkDocs with Material. It works without a network."""

import os
import re
import shutil
import subprocess
import sys

from tools.fetch import pip_packages
from tools.pages import links
from tools.pages.site import classes, mentions
from tools.places import BUILD, OUT, PROJECT, ROOT, TOOLS
from tools.say import Failure, progress, say

HERE = ROOT / "tools/pages/site"
SOURCE = BUILD / "site_src"
SITE = OUT / "site"
PAGE, PLAY = OUT / "page", "play"  # the demo as a page, if ./grass page has made it; its folder in the site
PACKAGES = TOOLS / "site"  # what requirements.txt names
PYTHON_MINIMUM = (3, 11)  # Material's


def ensure_packages():
	"""Installs the packages that build the site into .tools/site."""
	if sys.version_info < PYTHON_MINIMUM:
		raise Failure(f"The site needs Python {'.'.join(map(str, PYTHON_MINIMUM))} or newer; this is {sys.version.split()[0]}.")
	pip_packages.ensure(HERE / "requirements.txt", PACKAGES, "what the site is built with")


def as_python_markdown(text):
	"""Adds blank lines that forges do not need: around displayed equations, before lists and before tables."""
	parts = re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL)
	for index in range(0, len(parts), 2):
		part = re.sub(r"^(\$\$.*?\$\$)$", r"\n\1\n", parts[index], flags=re.MULTILINE | re.DOTALL)
		part = re.sub(r"^(?![-*|#\s]|\d+\. )(.+)\n(?=(?:- |1\. |\|))", r"\1\n\n", part, flags=re.MULTILINE)
		parts[index] = re.sub(r"^( +)(?=(?:-|\d+\.) )", lambda match: " " * (len(match[1]) // 2 * 4), part, flags=re.MULTILINE)
	return "".join(parts)


def on_site(text, is_history):
	"""A page's text whose links out of the site are words: to the laboratory, and from pages of the history to anything but such pages."""

	def link(match):
		stays = re.match(r"\d{4}-[\w-]+\.md", match[1]) if is_history else not re.match(r"(?:\.\./)+lab/", match[1])
		return match[0] if stays else re.sub(r"^!?\[|\]\([^()]*\)$", "", match[0])

	return links.LINK.sub(link, text)


def write_source():
	"""Everything that MkDocs reads, in build/site_src."""
	shutil.rmtree(SOURCE, ignore_errors=True)
	shutil.copytree(ROOT / "docs", SOURCE)
	shutil.copytree(HERE / "assets", SOURCE / "assets")
	shutil.copy(PROJECT / "addons/grass_field/icons/grass_field.svg", SOURCE / "assets/favicon.svg")
	reference = classes.read_all()
	told = mentions.Mentions(reference)
	for path in sorted(SOURCE.rglob("*.md")):
		text = on_site(path.read_text(), path.parent.name == "history" and path.name != "README.md")
		path.write_text(told.linked(path.relative_to(SOURCE).as_posix(), as_python_markdown(text)))
	classes.write(reference, told, SOURCE / "classes")


def make():
	ensure_packages()
	write_source()
	shutil.rmtree(SITE, ignore_errors=True)
	is_played = (PAGE / "index.html").exists()
	if is_played:
		with (SOURCE / "guide/web.md").open("a") as file:
			file.write(f'\n<a href="../{PLAY}/index.html">Play the demo in this browser</a>, if a server has sent you this page.\n')
	version = (ROOT / "VERSION").read_text().strip()
	path = os.pathsep.join([str(PACKAGES), str(ROOT)])
	environment = {**os.environ, "PYTHONPATH": path, "GRASS_VERSION": version, "NO_MKDOCS_2_WARNING": "1"}
	command = [sys.executable, "-m", "mkdocs", "build", "--quiet", "--strict", "--config-file", str(HERE / "mkdocs.yml")]
	with progress("Making the site"):
		code = subprocess.run(command, env=environment, cwd=ROOT).returncode
	if is_played and not code:
		shutil.copytree(PAGE, SITE / PLAY)
	wrong = [] if code else links.wrong_in_site(SITE)
	if code or wrong:
		raise Failure("\n".join(["The site has faults:", *wrong]))
	say(f"The site: {SITE / 'index.html'}")
