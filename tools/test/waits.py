# SPDX-License-Identifier: MIT
"""Finds waits of a std::atomic, and what libstdc++ builds on them: Windows has no futex, and GCC 12 misses notifications there. Part of the
layer `format`. What ships waits with a mutex and a std::condition_variable, as core/base/shared_loop.h does."""

import re

from tools.places import ROOT

COMMENT = re.compile(r"//.*")
CALL = re.compile(r"\b(\w+)(?:\.|->)(?:wait|notify_one|notify_all)\(")
WAITING = r"std::(?:condition_variable|(?:shared_)?future<[^;]*>) "  # what may be waited for
BUILT_ON_ATOMICS = re.compile(r"\bstd::(?:atomic(?:_flag)?_(?:wait|notify)\w*|counting_semaphore|binary_semaphore|latch|barrier)\b")
PLANTED = "std::atomic<int> _helping;\n_helping.wait(1);\n// a std::latch in a comment\nstd::latch all(2);\n_ready.notify_all();"


def found_in(text, declared):
	"""The forbidden waits in a source's text, as (line, words). `declared`: the text in which it declares what it waits for."""
	found = []
	for number, line in enumerate(COMMENT.sub("", text).split("\n"), 1):
		found += [(number, match[0]) for match in BUILT_ON_ATOMICS.finditer(line)]
		found += [(number, match[0]) for match in CALL.finditer(line) if not re.search(rf"{WAITING}{match[1]}\b", declared)]
	return found


def forbidden():
	"""What is wrong in the sources of the library, as texts."""
	if len(found_in(PLANTED, PLANTED)) != 3:
		return ["tools/test/waits.py: it does not find what is planted"]
	wrong = []
	for path in sorted(path for suffix in ("h", "cpp") for path in (ROOT / "extension").rglob(f"*.{suffix}")):
		header = path.with_suffix(".h")
		declared = path.read_text() + (header.read_text() if header != path and header.exists() else "")
		wrong += [
			f"{path.relative_to(ROOT)}:{line}: {words}: wait with a mutex and a std::condition_variable"
			for line, words in found_in(path.read_text(), declared)
		]
	return wrong
