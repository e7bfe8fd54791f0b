# SPDX-License-Identifier: MIT
"""Finds threads that the library starts by itself. Part of the layer `format`.

A page without threads ends as soon as a program starts one. So one header begins work beside the frames, and there does it at once.
"""

import re

from tools.places import ROOT
from tools.test.encodings import without_comments

ALLOWED = ROOT / "extension/core/base/beside.h"
STARTS = re.compile(r"#include <(?:thread|threads\.h|pthread\.h)>|\bstd::(?:jthread|thread|async)\b(?!::)|\bpthread_create\b")
ADVICE = "begin it with run_beside() of core/base/beside.h"
PLANTED = """#include <thread>
std::thread _thread; // std::thread in a comment
auto made = std::async(std::launch::async, make);
std::future<int> waited_for;
const std::string help = "std::async";
const int most = count_processors();"""


def found_in(text):
	"""Returns what starts a thread in a source's text, as (line, words)."""
	code = re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', without_comments(text))
	return [(number, match[0]) for number, line in enumerate(code.split("\n"), 1) for match in STARTS.finditer(line)]


def forbidden():
	"""Returns what is wrong in the sources of the library, as texts."""
	if [number for number, _ in found_in(PLANTED)] != [1, 2, 3]:
		return ["tools/test/thread_rules.py: it does not find what is planted"]
	paths = sorted(path for suffix in ("h", "hpp", "cpp") for path in (ROOT / "extension").rglob(f"*.{suffix}") if path != ALLOWED)
	return [f"{path.relative_to(ROOT)}:{line}: {words}: {ADVICE}" for path in paths for line, words in found_in(path.read_text())]
