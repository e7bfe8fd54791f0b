# SPDX-License-Identifier: MIT
"""Runs layers of tests side by side, each in a process of its own: a layer that waits for the engine leaves half of the processors idle."""

import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from tools.places import BUILD, ROOT
from tools.run.display import die_with_parent
from tools.say import progress
from tools.test.test_runs import Tally

HAND_OVER = "GRASS_TALLY"  # in the environment of a part: the file that it writes its tally to
MOST = 4  # at once: an editor on software Vulkan takes some gigabytes


def is_part():
	"""Returns whether this process runs one layer for another process, which has built everything that the layers need."""
	return HAND_OVER in os.environ


def hand_over(tally):
	"""Returns whether all went well."""
	pathlib.Path(os.environ[HAND_OVER]).write_text(json.dumps(vars(tally)))
	return not tally.failed


def run(layers, only, hardware):
	"""Returns the Tally of each layer, by its name. They begin in this order, as many at once as there are processors."""
	arguments = [*(["--only", only] if only else []), *(["--gpu"] if hardware else [])]
	running = []

	def run_one(layer):
		running.append(layer)
		tally = run_part(layer, arguments)
		running.remove(layer)
		return tally

	pool = concurrent.futures.ThreadPoolExecutor(min(os.cpu_count() or 1, MOST))
	with progress("Running layers", lambda: ", ".join(running), 30.0), pool:
		return dict(zip(layers, pool.map(run_one, layers)))


def run_part(layer, arguments):
	"""Runs one layer. Prints its output when it has ended, so that the output of two layers does not mix."""
	folder = BUILD / "layers"
	folder.mkdir(exist_ok=True)
	result = folder / f"{layer}.json"
	result.unlink(missing_ok=True)
	environment = {**os.environ, HAND_OVER: str(result), "GRASS_HOME": layer}  # no two engines share caches and user://
	command = [sys.executable, "-m", "tools.cli", "test", layer, *arguments]
	with tempfile.TemporaryFile("w+", errors="replace") as words:
		code = subprocess.run(
			command, cwd=ROOT, env=environment, stdout=words, stderr=subprocess.STDOUT, preexec_fn=die_with_parent
		).returncode
		words.seek(0)
		print(words.read(), end="", flush=True)
	if result.exists():
		tally = Tally(**json.loads(result.read_text()))
		if code and not tally.failed:
			tally.failed.append(f"{layer}: ended with code {code} after its last test")
		return tally
	return Tally(failed=[f"{layer}: ended with code {code}, the lines above say why"])
