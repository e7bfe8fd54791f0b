# SPDX-License-Identifier: MIT
"""Fetches what the machine lacks: Debian packages, unpacked into folders of the project (roots.py).

No root, nothing installed: apt gets a state of its own, and `dpkg-deb` unpacks. The folder appears under its name only
when it is whole (unpacked beside it, then renamed), so a run that was interrupted leaves nothing half-done behind.
"""

import contextlib
import fcntl
import os
import pathlib
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor

from tools.fetch import settle
from tools.fetch.roots import MAIN
from tools.places import TOOLS
from tools.say import Failure, progress

MERGED = ("bin", "sbin", "lib", "lib64")  # links into usr, as on a machine; older packages still fill both
STATUS = "var/lib/dpkg/status"  # which packages are unpacked, in the form in which apt reads it

BY_HAND = (
	"Install them by hand, then run this again: Godot 4.6 or newer (or name one: GODOT=/path/to/godot), SCons 4, Eigen 3.4"
	" or newer, doctest 2.4 or newer, glslang; for tests and the demo without a display or a GPU also Xvfb, xkbcomp and"
	" Mesa's software Vulkan (lavapipe)."
)

CONFIGURATION = """\
Dir::State "{apt}";
Dir::State::Lists "{apt}/lists";
Dir::State::status "{status}";
Dir::Cache "{apt}";
Dir::Etc::sourcelist "{apt}/sources.list";
Dir::Etc::sourceparts "/dev/null";
Dir::Etc::preferences "/dev/null";
Dir::Etc::preferencesparts "/dev/null";
APT::Default-Release "{suite}";
APT::Install-Recommends "false";
APT::Sandbox::User "{user}";
APT::Update::Error-Mode "any";
APT::Get::List-Cleanup "false";
Acquire::Languages "none";
Acquire::Retries "3";
Acquire::IndexTargets::deb::DEP-11::DefaultEnabled "false";
Acquire::IndexTargets::deb::Contents-deb::DefaultEnabled "false";
Debug::NoLocking "true";
{architecture}#clear APT::Update::Post-Invoke;
#clear APT::Update::Post-Invoke-Success;
#clear DPkg::Post-Invoke;
"""


_held = []  # file descriptors of the lock: children keep it held, should this program be killed before them


def run(*command, **options):
	return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, pass_fds=_held, **options)


def apt_get(root, *arguments, cwd=None):
	"""Runs apt-get on the private state of `root`; returns its output. Raises Failure with that output if it fails."""
	result = run("apt-get", "-c", str(root.apt / "apt.conf"), "-q", *arguments, env={**os.environ, "LC_ALL": "C"}, cwd=cwd)
	if result.returncode:
		words = [line for line in (result.stdout + result.stderr).splitlines() if line[:2] in ("E:", "W:", "Er")]
		raise Failure("Fetching packages failed. Is the network there? apt says:\n  " + "\n  ".join(words[-6:]) + f"\n{BY_HAND}")
	return result.stdout


def mirror():
	"""Returns the address of the Debian mirror that this machine uses, or that GRASS_DEBIAN_MIRROR names."""
	if named := os.environ.get("GRASS_DEBIAN_MIRROR"):
		return named
	if not shutil.which("apt-get") or not shutil.which("dpkg-deb"):
		raise Failure("This machine has no apt to fetch what is missing with. " + BY_HAND)
	sites = run("apt-get", "indextargets", "--format", "$(SITE)", "Created-By: Packages").stdout.split()
	found = next((site for site in sites if re.search(r"/debian/?$", site)), None)
	if found is None:
		raise Failure("This machine's apt knows no Debian mirror (GRASS_DEBIAN_MIRROR=URL names one). " + BY_HAND)
	return found


def configure(root):
	"""Writes the private state of apt."""
	keyring = pathlib.Path("/usr/share/keyrings/debian-archive-keyring.gpg")
	signed = f"[signed-by={keyring}] " if keyring.exists() else ""
	for folder in (root.apt / "lists/partial", root.archives / "partial", root.apt / "none/partial"):
		folder.mkdir(parents=True, exist_ok=True)
	kinds = ("deb", "deb-src") if root.has_sources else ("deb",)
	(root.apt / "sources.list").write_text("".join(f"{kind} {signed}{mirror()} {root.suite} main\n" for kind in kinds))
	status = root.place / STATUS
	if not status.exists():
		status = root.apt / "status"
		status.touch()
	user = "root" if os.geteuid() == 0 else ""
	name = root.architecture
	architecture = f'APT::Architecture "{name}";\nAPT::Architectures {{ "{name}"; }};\n' if name else ""
	text = CONFIGURATION.format(apt=root.apt, status=status, user=user, suite=root.suite, architecture=architecture)
	(root.apt / "apt.conf").write_text(text)


def download(root, packages):
	"""Fetches `packages` and their dependencies that are not unpacked yet. Returns the archives' paths."""
	with progress("Looking up packages"):
		apt_get(root, "update")
	# Each line: 'address' file size checksum. With an empty cache, or what was fetched before is left out.
	uris = apt_get(root, "-o", f"Dir::Cache::archives={root.apt}/none", "-y", "--print-uris", "install", *packages)
	wanted = {name: int(size) for name, size in re.findall(r"^'[^']+' (\S+\.deb) (\d+)", uris, re.MULTILINE)}
	total = sum(wanted.values()) / 1e6

	def fetched():
		files = [*root.archives.glob("*.deb"), *(root.archives / "partial").glob("*.deb")]
		sizes = (file.stat().st_size for file in files if file.exists())
		return f"{sum(sizes) / 1e6:.0f} of {total:.0f} MB"

	with progress(f"Fetching {len(wanted)} packages", fetched):
		apt_get(root, "-y", "--download-only", "install", *packages)
	return [root.archives / name for name in wanted]


def unpack_one(archive, root):
	"""Unpacks one archive; returns its entry for the status file."""
	reader = subprocess.Popen(["dpkg-deb", "--fsys-tarfile", str(archive)], stdout=subprocess.PIPE, pass_fds=_held)
	left_out = [f"--exclude={pattern}" for pattern in root.left_out]
	command = ["tar", "-x", "-C", str(root.partial), "--no-same-owner", "--keep-directory-symlink", "--wildcards", *left_out]
	result = subprocess.run(command, stdin=reader.stdout, capture_output=True, text=True, pass_fds=_held)
	reader.stdout.close()
	if reader.wait() or result.returncode:
		raise Failure(f"Unpacking {archive.name} failed: {result.stderr.strip() or 'is the disk full?'}")
	control = run("dpkg-deb", "--field", str(archive), check=True).stdout
	name, rest = control.split("\n", 1)
	return f"{name}\nStatus: install ok installed\n{rest.rstrip()}\n\n"


def unpack(root, archives):
	"""Makes a new folder from the old one and `archives`, and replaces the old one with it."""
	for leftover in (root.partial, root.old):
		shutil.rmtree(leftover, ignore_errors=True)
	if root.place.exists():  # hard links cost no space; tar and patchelf replace files, they do not write into them
		subprocess.run(["cp", "-al", str(root.place), str(root.partial)], check=True)
	else:
		for name in MERGED:
			(root.partial / "usr" / name).mkdir(parents=True)
			(root.partial / name).symlink_to(f"usr/{name}")
	entries = []
	pool = ThreadPoolExecutor(os.cpu_count())
	try:
		with progress("Unpacking", lambda: f"{len(entries)} of {len(archives)}"):
			for entry in pool.map(unpack_one, archives, [root] * len(archives)):
				entries.append(entry)
			settle.keep_links_inside(root.partial)
			if not root.architecture and not root.of_cards:
				settle.patch(root.partial, root.place)
	finally:
		pool.shutdown(cancel_futures=True)
	merge_status(root.partial / STATUS, entries)
	if root.place.exists():
		root.place.rename(root.old)
	root.partial.rename(root.place)
	shutil.rmtree(root.old, ignore_errors=True)
	shutil.rmtree(root.archives, ignore_errors=True)


def merge_status(status, entries):
	"""Writes the status file: the old entries, those of the same packages replaced."""
	old = re.findall(r"^Package:.*?\n\n", status.read_text(), re.MULTILINE | re.DOTALL) if status.exists() else []
	by_name = {entry.split("\n", 1)[0]: entry for entry in [*old, *entries]}
	status.parent.mkdir(parents=True, exist_ok=True)
	status.unlink(missing_ok=True)
	status.write_text("".join(by_name.values()))


def version(package, root):
	"""Returns the version of an unpacked package; "" if it is not unpacked."""
	text = (root.place / STATUS).read_text() if (root.place / STATUS).exists() else ""
	entry = re.search(rf"^Package: {re.escape(package)}\n.*?^Version: (\S+)$", text, re.MULTILINE | re.DOTALL)
	return entry[1] if entry else ""


@contextlib.contextmanager
def alone():
	"""A lock, so that two runs at once do not fetch twice: the second waits."""
	TOOLS.mkdir(exist_ok=True)
	with open(TOOLS / "lock", "w") as lock:
		try:
			fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
		except BlockingIOError:
			with progress("Waiting for another run that fetches packages"):
				fcntl.flock(lock, fcntl.LOCK_EX)
		_held.append(lock.fileno())
		yield
		_held.clear()


def fetch(packages, root=MAIN):
	"""Gets `packages` into the folder of `root`."""
	try:
		with alone():
			configure(root)
			unpack(root, download(root, packages))
	except OSError as error:
		raise Failure(f"Fetching packages failed: {error}") from error


def fetch_source(package, root, folder):
	"""Unpacks the original sources of `package`, which Debian has from its authors, into `folder`."""
	try:
		with alone(), progress(f"Fetching the sources of {package}"):
			configure(root)
			apt_get(root, "update")
			shutil.rmtree(folder, ignore_errors=True)
			making = folder.with_name(folder.name + ".partial")
			shutil.rmtree(making, ignore_errors=True)
			making.mkdir(parents=True)
			apt_get(root, "--download-only", "--tar-only", "--only-source", "source", package, cwd=making)
			archive = next(making.glob("*.orig.tar.*"))
			run("tar", "-x", "-C", str(making), "--strip-components=1", "--no-same-owner", "-f", str(archive), check=True)
			archive.unlink()
			making.rename(folder)
	except (OSError, StopIteration, subprocess.CalledProcessError) as error:
		raise Failure(f"Fetching the sources of {package} failed: {error}") from error
