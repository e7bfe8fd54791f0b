# SPDX-License-Identifier: MIT
"""Words for the person at the terminal: progress on anything slow, and failures that say what to do."""

import contextlib
import sys
import threading
import time


class Failure(Exception):
	"""Something the user can act on. The front door prints the text, without a traceback, and exits with `code`."""

	def __init__(self, text, code=1):
		super().__init__(text)
		self.code = code


def say(text):
	print(f"[grass] {text}", flush=True)


@contextlib.contextmanager
def progress(text, how_far=None, every=3.0):
	"""Says `text` at once, and after each `every` seconds how long it has been going on, and what `how_far()` returns."""
	say(text + " ...")
	done = threading.Event()
	start = time.monotonic()

	def tick():
		while not done.wait(every):
			say(f"{text} ... {time.monotonic() - start:.0f} s" + (f", {how_far()}" if how_far else ""))

	ticker = threading.Thread(target=tick, daemon=True)
	ticker.start()
	try:
		yield
	finally:
		done.set()
		ticker.join()


def complain(text):
	print(f"[grass] {text}", file=sys.stderr, flush=True)
