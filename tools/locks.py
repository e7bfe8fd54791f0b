# SPDX-License-Identifier: MIT
"""Locks for work that only one process at a time may do in this checkout, since layers of tests run side by side."""

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
