# SPDX-License-Identifier: MIT
"""Finds functions, records and constants that a file of shaders/ uses without an include of theirs. Part of the layer `docs`.

A file that C++ compiles too is not looked at: it stands in a namespace, where it can include little, so it says what it wants before it.
Any other file may leave to the shader what its head says that the shader, or the pass, declares.
"""

import re

from tools.places import ROOT

SHADERS = ROOT / "shaders"
INCLUDE = re.compile(r'^[ \t]*#include "([^"]+)"', re.MULTILINE)
COMMENT = re.compile(r"//.*")
HEAD = re.compile(r"(?:^//.*\n)+", re.MULTILINE)
TYPE = r"(?:GRASS_\w+ )?[A-Za-z_]\w*(?:\(\w+\))?"
DEFINED = re.compile(rf"^(?:#define |(?:GRASS_RECORD )?struct |GRASS_CONSTANT \w+ |const \w+ )(\w+)|^{TYPE} (\w+)\(", re.MULTILINE)
FUNCTION = re.compile(r"\b(\w+)\(")
NAME = re.compile(r"\b([A-Z]\w+)\b")
PASSES = (".glsl", ".gdshader")


def included(text):
	return [SHADERS / name for name in INCLUDE.findall(text) if (SHADERS / name).is_file()]


def all_included(path, texts, found=None):
	found = set() if found is None else found
	for target in included(texts[path]):
		if target not in found:
			found.add(target)
			all_included(target, texts, found)
	return found


def read_by_cpp(texts):
	"""Returns the files that C++ compiles."""
	sources = [path for kind in ("h", "cpp") for path in (ROOT / "extension").rglob(f"*.{kind}")]
	first = {path for source in sources for path in included(source.read_text())}
	return first.union(*(all_included(path, texts) for path in first))


def declared(head):
	"""Returns names in the sentences of a file's head that say what its shader declares."""
	text = " ".join(line.removeprefix("//").strip() for line in head.splitlines())
	return {name for sentence in re.findall(r"The (?:pass|shader) declares [^.]*\.", text) for name in re.findall(r"\w+", sentence)}


def wrong():
	"""Returns what is wrong, or "": the files, the names that they use and where these are."""
	texts = {path: path.read_text() for path in SHADERS.rglob("*") if path.is_file()}
	codes = {path: COMMENT.sub("", text) for path, text in texts.items()}
	own = {path: {define or function for define, function in DEFINED.findall(code)} for path, code in codes.items()}
	homes = {}
	for path in codes:
		for name in own[path] if path.suffix not in PASSES else ():
			homes.setdefault(name, set()).add(path)
	if not homes:
		return "no name was found where many are"
	lines = []
	for path in sorted(codes.keys() - read_by_cpp(texts)):
		near = all_included(path, texts)
		used = {*FUNCTION.findall(codes[path]), *NAME.findall(codes[path])} - own[path] - declared(HEAD.search(texts[path])[0])
		for name in sorted(used & homes.keys()):
			if not homes[name] & near:
				lines.append(f"{path.relative_to(ROOT)} uses {name} of {min(homes[name]).relative_to(SHADERS)}")
	return "; ".join(lines)
