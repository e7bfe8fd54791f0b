# SPDX-License-Identifier: MIT
"""A screen for the engine: the machine's, or an X server of our own that draws to memory."""

import contextlib
import ctypes
import os
import pathlib
import select
import signal
import subprocess
import tempfile

from tools.fetch import machine, settle
from tools.places import UNPACKED
from tools.say import Failure

START_LIMIT = 120  # seconds; the server takes well under one on an idle machine
PR_SET_PDEATHSIG = 1


def die_with_parent():
	"""Runs in the child: lets the kernel end it if this program is killed without a chance to clean up."""
	ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)


def server_command(number_pipe, size):
	server = machine.x_server()
	command = [server, "-displayfd", str(number_pipe), "-screen", "0", f"{size}x24", "-nolisten", "tcp", "-noreset"]
	for keyboard in ("usr/share/xkeyboard-config-2", "usr/share/X11/xkb"):
		if str(UNPACKED) in server and (UNPACKED / keyboard).is_dir():
			return [*command, "-xkbdir", str(UNPACKED / keyboard)]
	return command


def server_environment():
	"""Returns environment of the X server: a fetched one finds no OpenGL drivers in the system's folder."""
	drivers = UNPACKED / settle.LIBRARIES / "dri"
	fetched = str(UNPACKED) in machine.x_server() and drivers.is_dir()
	return {**os.environ, "LIBGL_DRIVERS_PATH": str(drivers)} if fetched else None


@contextlib.contextmanager
def virtual(size="1920x1080"):
	"""Starts Xvfb on a free display number; yields the environment additions that name it; stops it."""
	reading, writing = os.pipe()
	folder = pathlib.Path(machine.x_server()).parent  # a fetched server looks for xkbcomp in its working folder
	words = tempfile.TemporaryFile("w+")
	server = subprocess.Popen(
		server_command(writing, size), cwd=folder, env=server_environment(), pass_fds=[writing], preexec_fn=die_with_parent,
		stdin=subprocess.DEVNULL, stdout=words, stderr=words,
	)  # fmt: skip
	os.close(writing)
	try:
		ready, _, _ = select.select([reading], [], [], START_LIMIT)
		number = os.read(reading, 16).decode().strip() if ready else ""
		if not number:
			words.seek(0)
			raise Failure(f"The X server did not start:\n{words.read()}")
		yield {"DISPLAY": f":{number}", "WAYLAND_DISPLAY": ""}
	finally:
		os.close(reading)
		server.terminate()
		try:
			server.wait(10)
		except subprocess.TimeoutExpired:
			server.kill()


@contextlib.contextmanager
def screen(own=False):
	"""The machine's screen if it has one and `own` is false, otherwise a virtual one."""
	if machine.display() and not own:
		yield {}
	else:
		with virtual() as environment:
			yield environment
