# SPDX-License-Identifier: MIT
"""A test of the layer `gpu`: a game that ends right after it has drawn its first field does end, although nothing is cached and the engine
still makes pipelines."""

import tempfile

from tools.places import PROJECT
from tools.run import engine
from tools.say import Failure, progress
from tools.test.test_runs import Tally

NAME = "gpu/quit.a_game_ends_while_pipelines_are_made"
SCENE = "res://tests/gpu/quit.tscn"
SIZE = "64x64"  # of the window, the least: which pipelines are made does not hang on it
LIMIT = 400  # seconds; a fifth of a minute where nothing else runs


def layer(only, where):
	"""Returns the Tally, empty if `only` names other tests. `where`: how engine.window() opens a window."""
	if only and not any(part in NAME for part in only.split(",")):
		return Tally()
	said = []
	with (
		tempfile.TemporaryDirectory() as empty,
		engine.window(**{**where, "size": SIZE}) as (command, environment),
		progress(f"Running {NAME}"),
	):
		homes = {f"XDG_{kind}_HOME": empty for kind in ("DATA", "CONFIG", "CACHE")}
		try:
			code = engine.run(
				[*command, "--path", str(PROJECT), SCENE], {**environment, **homes, "MESA_SHADER_CACHE_DIR": empty}, said.append, LIMIT
			)
		except Failure as failure:
			code = failure
	words = "\n".join(said)
	if code == 0 and "drawn: " in words and "ERROR" not in words:
		print(f"  pass {NAME}")
		return Tally(1)
	print(words)
	return Tally(failed=[f"{NAME}: {code}"])
