# SPDX-License-Identifier: MIT
"""Compares what C++ and the shaders say of each other as twins. Part of the layer `docs`.

The twin of a file, by a sentence with `twin of`, says the same of that file, and has the functions that the sentence names; before a
function the sentence names one that is called the same. A function of a shader whose comment says `Twice:`, with the reason, has the same
name in a twin of its file.
"""

import re

from tools.places import ROOT

FOLDERS = ("shaders", "extension/core")
SENTENCE = re.compile(r"\btwin of (.*?)\.(?= |$)", re.IGNORECASE)
FILE = re.compile(r"\b(?:core|shaders)/[\w/]+\.\w+")
CALL = re.compile(r"\b(\w+)\(\)")
TWINNED = re.compile(r"^// .*\btwin of .*?(\w+)\(\) in .*\n(?://.*\n)*(?!//)\S.*?\b(\w+)\(", re.MULTILINE)
TWICE = re.compile(r"^// Twice: .*\n(?://.*\n)*(?:(?:struct \w+ \{\n(?:\t.*\n)*\};\n)?)\S+ (\w+)\(", re.MULTILINE)


def comments(text):
	"""Returns each block of comments, as one line."""
	return [" ".join(line.strip("/ \t") for line in block.splitlines()) for block in re.findall(r"(?:^[ \t]*//.*\n)+", text, re.MULTILINE)]


def place(name):
	return ROOT / name if name.startswith("shaders/") else ROOT / "extension" / name


def wrong():
	"""Returns what is wrong, or ""."""
	files = [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*")) if path.is_file()]
	texts = {path: path.read_text() for path in files}
	claims = {}
	for path, text in texts.items():
		claims[path] = [sentence for comment in comments(text) for sentence in SENTENCE.findall(comment) if FILE.search(sentence)]
	twins = {path: {place(name) for sentence in said for name in FILE.findall(sentence)} for path, said in claims.items()}
	if not any(twins.values()):
		return "no twins were found where many are"
	lines = []
	for path in files:
		name = path.relative_to(ROOT)
		for twin in sorted(twins[path]):
			if path not in twins.get(twin, ()):
				lines.append(f"{name} is the twin of {twin.relative_to(ROOT)}, which does not say so")
		defined = {function for near in {path, *twins[path]} & texts.keys() for function in re.findall(r"\b(\w+)\(", texts[near])}
		lines += [f"{name}: no twin has {call}()" for said in claims[path] for call in CALL.findall(said) if call not in defined]
		lines += [
			f"{name}: {own}() is the twin of {other}(), so both need one name"
			for other, own in TWINNED.findall(texts[path])
			if own != other
		]
		beside = "".join(texts.get(twin, "") for twin in twins[path])
		lines += [f"{name}: no twin has {call}(), written twice" for call in TWICE.findall(texts[path]) if f" {call}(" not in beside]
	return "; ".join(lines)
