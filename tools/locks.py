# SPDX-License-Identifier: MIT
"""What only one process of ours may do at a time in this checkout: layers of tests run side by side."""

import contextlib
import fcntl

from tools.places import BUILD


@contextlib.contextmanager
def alone(what):
	"""Waits until no other process is in here with the same `what`."""
	BUILD.mkdir(exist_ok=True)
	with open(BUILD / f"{what}.lock", "w") as file:
		fcntl.flock(file, fcntl.LOCK_EX)
		yield
