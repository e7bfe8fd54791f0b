# SPDX-License-Identifier: MIT
"""Finds numbers that C++ and the shaders both define. Each belongs into one file under shaders/ that both include."""

import re

from tools.places import ROOT

NUMBER = r"-?(?:0x[0-9a-fA-F]+|\d[\d.]*(?:e-?\d+)?)[uf]?"
IN_SHADERS = re.compile(rf"^\s*(?:#define|GRASS_CONSTANT \w+|const \w+) (\w+)(?: =)? {NUMBER};?(?:\s*//.*)?$", re.MULTILINE)
IN_CPP = re.compile(rf"\bconstexpr \w+ (\w+) = {NUMBER}[;,]")


def names(folder, pattern, suffixes):
	files = (path for path in (ROOT / folder).rglob("*") if path.suffix in suffixes)
	return {name: path.relative_to(ROOT) for path in files for name in pattern.findall(path.read_text())}


def stated_twice():
	"""Returns what is wrong, or "": the constants and their files."""
	shaders = names("shaders", IN_SHADERS, (".inc", ".glsl", ".gdshader", ".gdshaderinc"))
	cpp = names("extension/core", IN_CPP, (".h", ".cpp"))
	if not shaders or not cpp:
		return "no constant was found where many are"
	return "; ".join(f"{name}: {shaders[name]} and {cpp[name]}" for name in sorted(shaders.keys() & cpp.keys()))
