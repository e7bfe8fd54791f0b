# SPDX-License-Identifier: MIT
"""Runs the engine: without a window, or in one, on the machine's GPU or on software Vulkan."""

import contextlib
import os
import queue
import signal
import subprocess
import threading
import time

from tools.fetch import machine, settle
from tools.places import BUILD, PROJECT, UNPACKED
from tools.run.display import die_with_parent, screen
from tools.say import Failure, progress

# Seconds without a line of output after which a run is taken for hung, where lines are expected. More than the runner of the
# tests gives one of them, so that it can still name the one that hangs.
SILENCE_LIMIT = 1200
HOME = BUILD / "home" / os.environ.get("GRASS_HOME", "")  # the engine's settings, caches and user:// while we run it


def private_home():
	"""Returns environment additions that keep the engine out of the user's own settings. What software Vulkan compiled, all homes share."""
	homes = {f"XDG_{kind}_HOME": str(HOME / kind.lower()) for kind in ("DATA", "CONFIG", "CACHE")}
	return {**homes, "MESA_SHADER_CACHE_DIR": str(BUILD / "home/mesa")}


def software_vulkan():
	"""Returns (command prefix, environment additions) that run the engine on lavapipe."""
	driver = machine.software_vulkan()
	if driver.suffix == ".json":  # the system's
		return [], {"VK_DRIVER_FILES": str(driver)}
	# An engine of the machine's runs on the fetched driver only with the fetched C library.
	fetched_engine = str(UNPACKED) in machine.godot()
	return ([] if fetched_engine else settle.through_loader(UNPACKED, "")[:-1]), {"VK_DRIVER_FILES": str(UNPACKED / settle.SOFTWARE_VULKAN)}


def window_arguments(method, size):
	driver = "opengl3" if method == "gl_compatibility" else "vulkan"
	window = ["--rendering-driver", driver, "--rendering-method", method, "--audio-driver", "Dummy", "--disable-vsync"]
	return [*window, "--windowed", "--resolution", size]


@contextlib.contextmanager
def window(method="forward_plus", size="1280x720", software=False, hardware=False, more=None):
	"""Yields (command, environment additions) of an engine with a window.

	The machine's screen and GPU are used where it has them (a GPU only with a screen), unless `software`: then, or
	where there are none, a virtual screen and lavapipe. With `hardware` it is the GPU in any case. `software` is for tests, which draw
	few frames of many shaders: lavapipe compiles them without optimising them. `more`: further additions to the environment.
	"""
	virtual = software or not machine.display()
	prefix, driver = software_vulkan() if not hardware and (virtual or not machine.gpu()) else ([], {})
	if software:
		driver = {**driver, "GALLIVM_PERF": "nopt"}
	with screen(own=virtual) as display:
		on_x11 = ["--display-driver", "x11"] if virtual else []
		command = [*prefix, machine.godot(), *on_x11, *window_arguments(method, size)]
		yield command, {**driver, **display, **(more or {})}


def headless():
	"""Returns (command, environment additions) of an engine without a window and without a GPU."""
	return [machine.godot(), "--headless"], {}


def start(command, environment):
	everything = {**os.environ, **settle.environment(), **private_home(), **environment}
	return subprocess.Popen(
		command, env=everything, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
		text=True, errors="replace", start_new_session=True, preexec_fn=die_with_parent,
	)  # fmt: skip


def busy(process):
	"""Seconds for which processors were busy for a running process so far, all of its threads and the programs that it has run together; 0
	where the system does not say."""
	try:
		with open(f"/proc/{process.pid}/stat") as file:
			fields = file.read().rpartition(")")[2].split()
	except OSError:
		return 0.0
	return sum(int(field) for field in fields[11:15]) / os.sysconf("SC_CLK_TCK")


def run(command, environment, on_line=print, limit=1800, silence=SILENCE_LIMIT, on_start=None):
	"""Runs an engine; hands each line it prints to `on_line`, and its process to `on_start`. Returns its exit code (negative: ended by
	that signal).

	Failure after `limit` seconds, or after `silence` seconds without a line.
	"""
	process = start(command, environment)
	if on_start:
		on_start(process)
	lines = queue.Queue()

	def read():
		for line in process.stdout:
			lines.put(line.rstrip("\n"))
		lines.put(None)

	threading.Thread(target=read, daemon=True).start()
	deadline = time.monotonic() + limit
	try:
		while True:
			try:
				line = lines.get(timeout=max(0.0, min(silence, deadline - time.monotonic())))
			except queue.Empty:
				raise Failure(f"The engine hangs: stopped after {silence} s of silence or {limit} s in all.") from None
			if line is None:
				return process.wait(60)
			on_line(line)
	finally:
		with contextlib.suppress(ProcessLookupError):
			os.killpg(process.pid, signal.SIGKILL)
		process.wait()


def project_state(project):
	"""Returns the files on which the engine's import depends: every source file of a project, by time and size."""
	parts = []
	for folder, folders, names in os.walk(project):
		folders[:] = sorted(name for name in folders if name not in (".godot", "bin"))
		for name in sorted(names):
			if not name.endswith((".import", ".uid")):
				stat = os.stat(os.path.join(folder, name))
				parts.append(f"{folder}/{name} {stat.st_mtime_ns} {stat.st_size}")
	return "\n".join([machine.godot(), *parts])


def import_project(project=PROJECT):
	"""Lets the engine scan a project's files and import those that changed since the last time."""
	stamp = project / ".godot/imported_state"
	extensions = project / ".godot/extension_list.cfg"
	state = project_state(project)
	if extensions.exists() and stamp.exists() and stamp.read_text() == state:
		return
	if not extensions.exists():  # the engine would find it only after it has read the scripts that use it
		extensions.parent.mkdir(exist_ok=True)
		found = sorted(file.relative_to(project).as_posix() for file in project.rglob("*.gdextension"))
		extensions.write_text("".join(f"res://{file}\n" for file in found))
	output = []
	command, environment = headless()
	with progress("Importing the project"):
		code = run([*command, "--path", str(project), "--import"], environment, output.append)
	if code:
		raise Failure("The engine could not import the project:\n" + "\n".join(output[-30:]))
	stamp.write_text(state)
