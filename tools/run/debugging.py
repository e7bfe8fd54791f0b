# SPDX-License-Identifier: MIT
"""`./grass debug`: the headless tests in gdb, with a library that has names, lines and assertions."""

import os
import subprocess

from tools.build import build
from tools.fetch import machine, settle
from tools.places import PROJECT, UNPACKED
from tools.run import engine


def gdb():
	return machine.program("gdb")


def run(only, at, trace):
	"""Builds the library with `dev=yes` and starts gdb on the engine; with `trace` it prints a backtrace and ends. Returns gdb's code."""
	build.scons("dev=yes")
	machine.ensure((gdb, ("gdb", "patchelf")))
	engine.import_project()
	command, additions = engine.headless()
	arguments = ["--path", str(PROJECT), "--fixed-fps", "60", "res://tests/runner.tscn", "--", "--layer=headless"]
	if only:
		arguments.append(f"--only={only}")
	orders = ["set breakpoint pending on", "set print thread-events off", *([f"break {at}"] if at else [])]
	orders += ["run", "backtrace", "kill"] if trace else []
	given = ["-iex", f"set auto-load safe-path {UNPACKED}:/usr", *(word for order in orders for word in ("-ex", order))]  # of libthread_db
	environment = {**os.environ, **settle.environment(), **engine.private_home(), **additions}
	return subprocess.run(
		[gdb(), "--quiet", *(["--batch"] if trace else []), *given, "--args", *command, *arguments], env=environment
	).returncode
