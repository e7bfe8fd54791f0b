# SPDX-License-Identifier: MIT
"""The layer `docs`: code blocks run, commands parse, links lead somewhere, numbers are written once. Nothing is fetched for it."""

import contextlib
import io
import os
import re
import shlex
import shutil
import subprocess

from tools import command_line
from tools.build import binding
from tools.fetch import machine, settle
from tools.pages import links, machines_page, rules_page, snippets
from tools.places import BUILD, PROJECT, ROOT
from tools.release import store
from tools.run import engine
from tools.test import class_sizes, members, one_text, rooms, shader_names, twins
from tools.test.test_runs import Tally, in_engine, noted

PRELUDES = PROJECT / "tests/docs/cpp"  # KEY.h: what a C++ block assumes
COMMAND = re.compile(r"`(\./grass[^`\n]*)`|^\s+(\./grass.*)$|^(\./grass.*)$", re.MULTILINE)
EMPTY = BUILD / "snippets_project"  # an empty project that has the add-on, where shell blocks run
SHELL_LIMIT = 300  # seconds
EQUATION = re.compile(r"\[Eq \w+\]|\$[^$`\n]+\$|\$\$")


def wrong_command(command, layers):
	"""Returns what is wrong with a `./grass ...` that a page names, or "". The user replaces words such as LAYER.
	`layers`: names of the layers of tests."""

	words = shlex.split(re.sub(r"[\[\]]|\.\.\.", "", command), comments=True)[1:]
	said = io.StringIO()
	try:
		with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
			options = command_line.parser().parse_args(words)
	except SystemExit as end:
		return "" if not end.code else f"`{command}` is no command: {said.getvalue().strip().splitlines()[-1]}"
	unknown = [layer for layer in getattr(options, "layers", []) if layer not in layers and not layer.isupper()]
	return f"`{command}` names no layer" if unknown else ""


def commands(path, layers):
	found = ["".join(groups) for groups in COMMAND.findall(path.read_text())]
	return found, "; ".join(filter(None, (wrong_command(command, layers) for command in found)))


def wrong_workflow(path, layers):
	"""Returns what is wrong with the `./grass` commands of a workflow."""
	found = re.findall(r"^\s*(?:- )?(?:run: )?(\./grass .*)$", path.read_text(), re.MULTILINE)
	return "; ".join(filter(None, (wrong_command(command, layers) for command in found)))


def wrong_cpp(block):
	"""Compiles a C++ block as a user's extension would, without an output."""
	source = snippets.MADE / f"{block.key}.cpp"
	source.write_text(f'#include "{PRELUDES / block.key}.h"\n#line {block.line} "{block.file}"\n{block.text}')
	includes = [f"-isystem{folder}" for folder in binding.include_folders()]
	flags = ["-std=c++20", "-fsyntax-only", "-Wall", "-Werror", "-DGDEXTENSION", "-DLINUX_ENABLED", "-DTHREADS_ENABLED"]
	result = subprocess.run([machine.compiler(), *flags, *includes, str(source)], capture_output=True, text=True)
	return result.stderr.strip() if result.returncode else ""


def wrong_shell(block):
	"""Runs a shell block in an empty project that has the add-on. A block of `./grass` commands has been parsed with its page."""
	if all(line.startswith("./grass") for line in block.text.split("\n") if line):
		return ""
	shutil.rmtree(EMPTY, ignore_errors=True)
	shutil.copytree(PROJECT / "addons", EMPTY / "addons")
	(EMPTY / "project.godot").write_text("config_version=5\n")
	(EMPTY / "tests").mkdir()
	test = next(other for other in snippets.find() if other.key == "ci_a_test")
	(EMPTY / "tests/test_grass.gd").write_text(test.text)
	programs = EMPTY / ".bin"
	programs.mkdir()
	(programs / "godot").write_text(f'#!/bin/sh\nexec {shlex.quote(machine.godot())} "$@"\n')
	(programs / "godot").chmod(0o755)
	everything = {**os.environ, **settle.environment(), **engine.private_home(), "PATH": f"{programs}:{os.environ['PATH']}"}
	try:
		command = ["sh", "-ec", block.text]
		result = subprocess.run(command, cwd=EMPTY, env=everything, capture_output=True, text=True, timeout=SHELL_LIMIT)
	except subprocess.TimeoutExpired:
		return f"still running after {SHELL_LIMIT} s"
	return f"ended with code {result.returncode}: {(result.stdout + result.stderr)[-1500:]}" if result.returncode else ""


def wrong_main_loop(block):
	"""Runs a script that is a main loop of its own."""
	path = snippets.MADE / f"{block.key}.gd"
	path.write_text(snippets.script(block))
	command, environment = engine.headless()
	said = []
	code = engine.run([*command, "--path", str(PROJECT), "--fixed-fps", "60", "--script", str(path)], environment, said.append, SHELL_LIMIT)
	return f"ended with code {code}: {' | '.join(said[-10:])}" if code else ""


def wrong_checks(blocks):
	"""Returns checks, headers and skips of blocks that no longer exist."""
	known = {block.key for block in blocks}
	texts = [(PROJECT / "tests/docs" / name).read_text() for name in ("guides.gd", "classes.gd")]
	checks = [name for text in texts for name in re.findall(r"^func (\w+)\(\) -> void:", text, re.MULTILINE)]
	headers = [path.stem for path in PRELUDES.glob("*.h")]
	return ", ".join(f"{key} is no block" for key in (*checks, *headers, *snippets.SKIPPED) if key not in known)


def wrong_guide():
	"""Returns pages of the guide with an equation: those are for docs/internals."""
	wrong = []
	for path in sorted((ROOT / "docs/guide").glob("*.md")):
		found = EQUATION.search(links.CODE.sub("", path.read_text()))
		wrong += [f"{path.name}: {found[0]}"] if found else []
	return "; ".join(wrong)


def wrong_navigation():
	"""Returns pages that the site's navigation does not name: the site itself is not built by tests."""
	docs = ROOT / "docs"
	named = (ROOT / "tools/pages/site/mkdocs.yml").read_text().partition("\nnav:\n")[2]
	pages = [page.relative_to(docs) for page in sorted(docs.rglob("*.md"))]
	return ", ".join(str(page) for page in pages if str(page) not in named and f"{page.parent}/*" not in named)


def run(only, layers):
	"""Runs the whole layer. `layers`: names of all layers of tests."""
	tally, in_godot = Tally(), []
	for name, wrong in CHECKED_PAGES.items():
		if only in name:
			noted(tally, name, wrong())
	for path in snippets.pages():
		page = path.relative_to(ROOT)
		if only in (name := f"docs/{page} links"):
			noted(tally, name, "; ".join(links.wrong_in_page(path)))
		found, wrong = commands(path, layers)
		if found and only in (name := f"docs/{page} commands"):
			noted(tally, name, wrong)
	for path in sorted((ROOT / ".github/workflows").glob("*.yml")):
		if only in (name := f"docs/{path.relative_to(ROOT)} commands"):
			noted(tally, name, wrong_workflow(path, layers))
	if only in (name := "docs/numbers stand once"):  # as architecture.md says
		noted(tally, name, one_text.stated_twice())
	blocks = snippets.find()
	if only in (name := "docs/checks"):
		noted(tally, name, wrong_checks(blocks))
	blocks = [block for block in blocks if only in f"docs/{block.place} {block.key}"]
	folder = snippets.write_scripts([block for block in blocks if snippets.needs_check(block)])
	for block in blocks:
		name = f"docs/{block.place} {block.key}"
		if block.key in snippets.SKIPPED:
			tally.skipped.append(f"{name}: {snippets.SKIPPED[block.key]}")
		elif snippets.needs_check(block):
			in_godot.append(block)
		elif block.language == "gdscript":
			noted(tally, name, wrong_main_loop(block))
		elif block.language in CHECKS:
			noted(tally, name, CHECKS[block.language](block))
		elif block.language not in snippets.ELSEWHERE:
			noted(tally, name, f"a block of {block.language or 'no language'}: write one of {', '.join(snippets.LANGUAGES)} behind its ```")
	if in_godot:
		environment = {"GRASS_SNIPPETS": str(folder)}
		start = ("--fixed-fps", "60", "res://tests/docs/runner.tscn")
		command, additions = engine.headless()
		tally.add(in_engine("docs", command, {**additions, **environment}, only, start=start))
	return tally


CHECKED_PAGES = {
	"docs/rooms": rooms.wrong,
	"docs/names in shaders": shader_names.wrong,
	"docs/twins": twins.wrong,
	"docs/class sizes": class_sizes.wrong,
	"docs/members": members.wrong,
	"docs/guide has no equation": wrong_guide,
	"docs/navigation of the site": wrong_navigation,
	"docs/rules for passes": rules_page.wrong,
	"docs/machines": machines_page.wrong,
	"docs/page of the store": store.wrong_or_blind,
}
CHECKS = {"cpp": wrong_cpp, "sh": wrong_shell}
