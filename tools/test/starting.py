# SPDX-License-Identifier: MIT
"""Tests of the layer `gpu`: which compute passes a start of the engine stores, and how the next start uses them. Each test starts the
engine with the user folder that the one before has left."""

import os
import re
import struct
import tempfile
import zlib
from pathlib import Path

from tools.places import PROJECT
from tools.run import engine
from tools.say import Failure, progress
from tools.test.test_runs import Tally

NAME = "gpu/start."
SCENE = "res://tests/gpu/start.tscn"
SIZE = "64x64"  # of the window, the least: which passes are made does not hang on it
LIMIT = 400  # seconds; a tenth of a minute where nothing else runs
PASSES = ("cull", "simulate", "gather", "join", "simulate free", "simulate strains", "simulate edges")
AGAIN = " many"  # ends the names of passes of the same code as others, compiled with the first tiles that share a workgroup
KEPT_MOST = 64  # files, SHADER_FILES_MOST
SHOWN = re.compile(r"(\d+) of its (\d+) pixels show blades")
BEGUN, DONE = re.compile(r"^GrassField: compiling '(.+)'$"), re.compile(r"^GrassField: compiled '(.+)', shader (\w+) in ")


class Start:
	"""One start of the engine: its output, and how each pass got its shader."""

	def __init__(self, where, home):
		self.words = []
		homes = {f"XDG_{kind}_HOME": str(home / kind.lower()) for kind in ("DATA", "CONFIG", "CACHE")}
		with engine.window(**{**where, "size": SIZE}) as (command, environment):
			everything = [*command, "--verbose", "--path", str(PROJECT), "--fixed-fps", "60", SCENE]
			self.code = engine.run(everything, {**environment, **homes}, self.words.append, LIMIT)
		self.result = "".join(line for line in self.words if line.startswith("GRASS-START "))
		self.shaders = {found[1]: found[2] for found in map(DONE.match, self.words) if found}

	def check(self, expected):
		"""Raises AssertionError unless the start went well and every pass got its shader in the way that `expected` names."""
		assert self.code == 0, f"the engine ended with code {self.code}"
		errors = [line for line in self.words if "ERROR" in line or "WARNING: GrassField" in line]
		assert not errors, errors
		assert "bent 0:" not in self.result and self.result, f"nothing was simulated: {self.result}"
		covered, pixels = map(int, SHOWN.search(self.result).groups())
		assert covered > 0.2 * pixels, f"the picture shows too few blades: {self.result}"
		shaders = {f"GrassField {name}": expected for name in PASSES}
		found = {name: how for name, how in self.shaders.items() if not name.endswith(AGAIN)}
		assert found == shaders, f"{found} instead of {shaders}"

	def check_order(self):
		"""Raises AssertionError unless passes were compiled one after the other, in the order in which the field needs them."""
		steps = [found for line in self.words for found in [BEGUN.match(line) or DONE.match(line)] if found]
		names = [found[1].removeprefix("GrassField ") for found in steps]
		assert names[0::2] == names[1::2], f"two at once: {names}"
		assert names[0::2][:2] == ["cull", "simulate"], names[0::2]
		assert names.index("simulate free") < names.index("simulate edges"), names[0::2]


def kept_in(home):
	"""Returns the files with shaders, by name."""
	return {file.name: file for file in home.glob("data/**/shader_cache/grass_field/*.shader")}


def contents(home):
	return {name: file.read_bytes() for name, file in kept_in(home).items()}


def key_of(content):
	"""Returns the key in a valid file, otherwise nothing. See extension/core/base/shader_file.h."""
	if len(content) < 24 or content[:8] != b"GRASSSHD":
		return b""
	_, key, shader, checksum = struct.unpack_from("<4I", content, 8)
	is_sound = len(content) == 24 + key + shader and zlib.crc32(content[:20] + content[24:]) == checksum
	return content[24 : 24 + key] if is_sound else b""


def a_first_start_translates_and_keeps(where, home):
	start = Start(where, home)
	start.check("translated")
	start.check_order()
	assert len(kept_in(home)) == len(PASSES), sorted(kept_in(home))
	return start


def a_second_start_reads(where, home, first):
	before = contents(home)
	start = Start(where, home)
	start.check("read")
	start.check_order()
	assert start.result == first.result, f"another picture: {start.result} instead of {first.result}"
	assert contents(home) == before, "the files changed"


def damage(files):
	"""Damages the files in five ways."""
	flipped, empty, foreign, huge, *cut = files
	for file in cut:
		file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])
	changed = bytearray(flipped.read_bytes())
	changed[len(changed) * 3 // 4] ^= 0x10
	flipped.write_bytes(changed)
	foreign.write_bytes(huge.read_bytes())
	os.truncate(huge, 3 << 30)
	empty.write_bytes(b"")


def damaged_files_are_replaced_and_old_ones_removed(where, home, first):
	before = contents(home)
	files = list(kept_in(home).values())
	for n in range(KEPT_MOST + 10):
		old = files[0].with_name(f"{n:016x}.shader")
		old.write_bytes(b"old")
		os.utime(old, (1000 + n, 1000 + n))
	other = files[0].with_name("notes.txt")
	other.write_text("not ours")
	damage(files)
	start = Start(where, home)
	start.check("translated")
	assert start.result == first.result, f"another picture: {start.result} instead of {first.result}"
	after = contents(home)
	for name, content in before.items():
		assert key_of(content), f"{name} was not as the format says"
		assert key_of(after[name]) == key_of(content), f"{name} was not replaced"
	left = sorted(file.name for file in files[0].parent.iterdir())
	assert other.name in left and len(left) == KEPT_MOST + 1, left
	assert f"{KEPT_MOST + 9:016x}.shader" in left and f"{0:016x}.shader" not in left, left


def where_nothing_can_be_kept_nothing_is_said(where, home, first):
	folder = next(iter(kept_in(home).values())).parent
	for file in folder.iterdir():
		file.unlink()
	folder.rmdir()
	folder.write_text("a file in its place")
	start = Start(where, home)
	start.check("translated")
	assert start.result == first.result, f"another picture: {start.result} instead of {first.result}"
	assert folder.is_file()


AFTER_THE_FIRST = (a_second_start_reads, damaged_files_are_replaced_and_old_ones_removed, where_nothing_can_be_kept_nothing_is_said)


def layer(only, where):
	"""Returns the Tally, empty if `only` names other tests. `where`: how engine.window() opens a window."""
	tally = Tally()
	tests = (a_first_start_translates_and_keeps, *AFTER_THE_FIRST)
	if only and not any(part in NAME + test.__name__ for part in only.split(",") for test in tests):
		return tally
	with tempfile.TemporaryDirectory() as home:
		first = ()
		for test in tests:
			name = NAME + test.__name__
			try:
				with progress(f"Running {name}"):
					made = test(where, Path(home), *first)
				first = first or (made,)
				tally.passed += 1
				print(f"  pass {name}", flush=True)
			except (AssertionError, Failure) as failure:
				tally.failed.append(f"{name}: {failure}")
				print(f"  fail {name}: {failure}", flush=True)
				if not first:
					break
	return tally
