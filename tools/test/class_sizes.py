# SPDX-License-Identifier: MIT
"""Limits the size of a class: the header that declares it, with all sources that define its methods. Part of the layer `docs`.

Files are short because classes are, not because a class is cut over many files. Lines of code count: no blank ones, no comments.
"""

import re

from tools.places import ROOT

FOLDER = ROOT / "extension"
SKIPPED = ("binding", "old_glibc")
LIMIT = 400
# Headers of larger classes, with their lines. An entry may only shrink, and leaves when its class fits.
LARGER = {
	"extension/core/tiles/tile_meetings.h": 707,
	"extension/core/tiles/tiles.h": 798,
	"extension/editor/grass_editor_plugin.h": 697,
}

COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
DECLARED = re.compile(r"^(?:template <[^\n]*> )?(?:class|struct) (\w+)(?![^{;]*;)", re.MULTILINE)
# At the start of a line, only definitions of methods have a name with a class before it and a bracket after it.
DEFINED = re.compile(r"^(?=[\w~:])[^\n(]*?\b(\w+)::(?:~?\w+|operator[^\n(]+)\(", re.MULTILINE)


def code_lines(text):
	"""Returns how many lines of C++ are neither blank nor only comment."""
	code = COMMENT.sub(lambda found: found[0] if found[0][0] == '"' else "\n" * found[0].count("\n"), text)
	return sum(1 for line in code.split("\n") if line.strip())


def sizes():
	"""Returns lines of code by header, of those headers that declare classes."""
	texts = {
		path.relative_to(ROOT).as_posix(): path.read_text()
		for kind in ("h", "cpp")
		for path in sorted(FOLDER.rglob(f"*.{kind}"))
		if path.relative_to(FOLDER).parts[0] not in SKIPPED
	}
	sources = [(code_lines(text), set(DEFINED.findall(text))) for name, text in texts.items() if name.endswith(".cpp")]
	found = {}
	for name, text in texts.items():
		classes = set(DECLARED.findall(text)) if name.endswith(".h") else set()
		if classes:
			found[name] = code_lines(text) + sum(lines for lines, defined in sources if defined & classes)
	return found


def wrong_size(name, size):
	"""Returns what is wrong with a size, or ""."""
	most = LARGER.get(name, LIMIT)
	if name not in LARGER:
		return f"{name} with its sources has {size} lines of code, {most} at most: look for a second class in it" if size > most else ""
	if size <= LIMIT:
		return f"{name} has {size} lines of code, which is small enough: take it off LARGER in tools/test/class_sizes.py"
	return f"{name} with its sources has {size} lines of code, LARGER says {most}, which may only shrink" if size != most else ""


def wrong():
	"""Returns what is wrong with the sizes, or ""."""
	found = sizes()
	lines = [wrong_size(name, size) for name, size in found.items()]
	lines += [f"tools/test/class_sizes.py lists {name}, which declares no class" for name in LARGER if name not in found]
	return "; ".join(line for line in lines if line)
