# SPDX-License-Identifier: MIT
"""Finds what GCC 12 does wrong on Windows in the sources of the library. Part of the layer `format`.

Waits of a std::atomic, and what libstdc++ builds on them: there is no futex, and notifications are missed. What ships waits with a
mutex and a std::condition_variable, as core/base/shared_loop.h does. And objects with a destructor that are thread_local: it runs when
the thread's memory is gone.
"""

import re

from tools.places import ROOT

COMMENT = re.compile(r"//.*")
CALL = re.compile(r"\b(\w+)(?:\.|->)(?:wait|notify_one|notify_all)\(")
WAITING = r"std::(?:condition_variable|(?:shared_)?future<[^;]*>) "  # what may be waited for
BUILT_ON_ATOMICS = re.compile(r"\bstd::(?:atomic(?:_flag)?_(?:wait|notify)\w*|counting_semaphore|binary_semaphore|latch|barrier)\b")
OF_THREAD = re.compile(r"\bthread_local\b[^;({=]*\b(?:std::|godot::|String|Array|Dictionary|Variant|Ref<)")
PLANTED = """std::atomic<int> _helping;
_helping.wait(1);
// a std::latch in a comment
std::latch all(2);
_ready.notify_all();
static thread_local std::vector<int> scratch;
thread_local const bool is_main = std::max(1, 2) == 2;"""


def found_in(text, declared):
	"""What is forbidden in a source's text, as (line, words, what to do). `declared`: the text in which it declares what it waits for."""
	found = []
	for number, line in enumerate(COMMENT.sub("", text).split("\n"), 1):
		waits = [
			*BUILT_ON_ATOMICS.finditer(line),
			*(call for call in CALL.finditer(line) if not re.search(rf"{WAITING}{call[1]}\b", declared)),
		]
		found += [(number, wait[0], "wait with a mutex and a std::condition_variable") for wait in waits]
		found += [(number, own[0], "let the caller own it") for own in OF_THREAD.finditer(line)]
	return found


def forbidden():
	"""Returns what is wrong in the sources of the library, as texts."""
	if len(found_in(PLANTED, PLANTED)) != 4:
		return ["tools/test/windows_rules.py: it does not find what is planted"]
	wrong = []
	for path in sorted(path for suffix in ("h", "cpp") for path in (ROOT / "extension").rglob(f"*.{suffix}")):
		header = path.with_suffix(".h")
		declared = path.read_text() + (header.read_text() if header != path and header.exists() else "")
		wrong += [f"{path.relative_to(ROOT)}:{line}: {words}: {advice}" for line, words, advice in found_in(path.read_text(), declared)]
	return wrong
