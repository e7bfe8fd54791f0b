# SPDX-License-Identifier: MIT
"""Words for the person at the terminal: progress on anything slow, and failures that say what to do."""

import contextlib
import sys
import threading
import time


class Failure(Exception):
	"""An error that the user can act on. ./grass prints the text, without a traceback, and exits with `code`."""

	def __init__(self, text, code=1):
		super().__init__(text)
		self.code = code


def say(text):
	print(f"[grass] {text}", flush=True)


@contextlib.contextmanager
def progress(text, how_far=None, every=3.0):
	"""Prints `text` at once, and every `every` seconds how long the work has taken, and the result of `how_far()`."""
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
