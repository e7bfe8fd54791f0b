# SPDX-License-Identifier: MIT
"""Programs that read shaders as a graphics driver would, without a card. The layers `drivers` and `lab` run them.

Mesa's drivers and spirv-cross are Debian's packages. Of Mesa's sources two things are built that Debian does not pack:
`spirv2dxil`, which Godot uses for Direct3D 12, and a library that answers for the kernel, so that Intel's driver sees a card.
"""

import json
import os
import pathlib
import platform
import shutil
import subprocess
import sys
import tarfile

from tools.fetch import machine, packages, pip_packages, settle
from tools.fetch.roots import DRIVERS
from tools.places import BUILD, ROOT, TOOLS
from tools.say import Failure, progress

FOLDER = BUILD / "drivers"
LIBRARIES = DRIVERS.place / settle.LIBRARIES
MESA = TOOLS / "mesa"  # what was built of its sources
SOURCES, MAKING = TOOLS / "mesa_sources", TOOLS / "mesa_build"
MESON = TOOLS / "meson"
DXIL = TOOLS / "dxil"
MEMBERS = ("WinAdapter.h", "dxcapi.h", f"libdxcompiler_{platform.machine()}.so.3.7")  # of the package that has the validator
REQUIREMENTS = ROOT / "lab/tools/drivers_requirements.txt"
BUILT = ("src/microsoft/spirv_to_dxil/spirv2dxil", "src/intel/tools/libintel_noop_drm_shim.so")
OFF = ("glx", "egl", "gbm", "gles1", "gles2", "llvm", "zlib", "zstd", "expat", "xmlconfig", "shader-cache")
OPTIONS = (
	"--wrap-mode=nodownload", "-Dbuildtype=release", "-Doptimization=1", "-Dplatforms=", "-Dvulkan-drivers=", "-Dgallium-drivers=",
	"-Dvideo-codecs=", "-Dopengl=false", "-Dspirv-to-dxil=true", "-Dtools=drm-shim,intel", *(f"-D{name}=disabled" for name in OFF),
)  # fmt: skip
# What those two need not, and where the sources ask for it.
EDITS = (
	("meson.build", "error('Intel tools require expat')", "message('no expat')"),
	("meson.build", "or with_freedreno_vk or with_intel_tools or with_gallium", "or with_freedreno_vk or with_gallium"),
	("src/drm-shim/drm_shim.h", "#include <xf86drm.h>", '#include "util/libdrm.h"\n#define DRM_MAJOR 226'),
)


def driver(name):
	"""Returns a driver of Debian's Mesa."""
	found = LIBRARIES / f"libvulkan_{name}.so"
	return found if found.exists() else None


def spirv_cross():
	found = DRIVERS.place / "usr/bin/spirv-cross"
	return found if found.exists() else None


NEEDED = (
	(
		lambda: driver("radeon") and (DRIVERS.place / "usr/include/vulkan/vulkan.h").exists(),
		("mesa-vulkan-drivers", "libvulkan-dev"),
		DRIVERS,
	),
	(spirv_cross, ("spirv-cross",), DRIVERS),
)


def mesa_version():
	"""Mesa's own version, such as 25.0.7."""
	found = packages.version("mesa-vulkan-drivers", DRIVERS)
	return found.split("-")[0]


def run(command, name="", **options):
	"""Runs a program; returns its output. Raises Failure with that output if it fails; `name`: name of the program in it."""
	result = subprocess.run(list(map(str, command)), capture_output=True, text=True, stdin=subprocess.DEVNULL, **options)
	if result.returncode:
		raise Failure(f"{name or pathlib.Path(command[0]).name} failed:\n{(result.stdout + result.stderr)[-3000:]}")
	return result.stdout


def run_fetched(program, *arguments, **options):
	"""Runs a program with the libraries of the fetched packages."""
	return run([*settle.through_loader(DRIVERS.place, program), *arguments], program.name, **options)


def compiled(source, *flags):
	"""Returns a program from one source in lab/drivers/, compiled if the source is newer."""
	program = FOLDER / pathlib.Path(source).stem
	if not program.exists() or program.stat().st_mtime < (ROOT / source).stat().st_mtime:
		FOLDER.mkdir(parents=True, exist_ok=True)
		language = ["-xc", "-std=gnu11"] if source.endswith(".c") else ["-std=c++20"]
		run([*machine.compiler().split(), *language, "-O1", "-Wall", "-Wextra", "-o", program, ROOT / source, *flags])
	return program


def pipelines():
	"""Returns the program that makes pipelines. It is linked against the fetched Vulkan loader, and runs with it."""
	return compiled(
		"lab/drivers/pipelines.c", "-idirafter", DRIVERS.place / "usr/include", f"-L{LIBRARIES}",
		"-Wl,--allow-shlib-undefined", "-l:libvulkan.so.1",
	)  # fmt: skip


def with_driver(name, description):
	"""The environment in which programs see the driver `name` of Debian's Mesa alone, which the file `description` tells them of."""
	description.write_text(json.dumps({"file_format_version": "1.0.1", "ICD": {"library_path": str(driver(name)), "api_version": "1.3.0"}}))
	return {
		**os.environ, "VK_DRIVER_FILES": str(description), "VK_LOADER_LAYERS_DISABLE": "~all~", "MESA_SHADER_CACHE_DISABLE": "true",
	}  # fmt: skip


def strain_parity(spirv):
	"""Returns how far the pass by strains and its C++ are apart, and how far from rest blades go: blade lengths."""
	source = ROOT / "lab/drivers/strain_parity.cpp"
	program = FOLDER / source.stem
	FOLDER.mkdir(parents=True, exist_ok=True)
	options = ("-std=c++20", "-O1", "-ffp-contract=off", "-DGRASS_IS_SANITIZED", "-DEIGEN_DONT_VECTORIZE")
	folders = (f"-I{ROOT / 'extension'}", f"-I{ROOT / 'shaders'}", "-isystem", machine.eigen(), "-idirafter", DRIVERS.place / "usr/include")
	linked = (f"-L{LIBRARIES}", "-Wl,--allow-shlib-undefined", "-l:libvulkan.so.1")
	run([*machine.compiler().split(), *options, *folders, "-o", program, source, *linked])
	said = run_fetched(program, spirv, env=with_driver("lvp", FOLDER / "lvp.json"))
	return tuple(map(float, said.split()))


def make_pipelines(name, jobs, additions):
	"""Returns the statistics of driver `name`'s compiler for the pipelines that `jobs` lists: {pipeline: {statistic: value}}."""
	environment = {**with_driver(name, jobs.with_suffix(".json")), **additions}
	said = {}
	for line in run_fetched(pipelines(), jobs, env=environment).splitlines():
		if line.count("\t") == 2:
			pipeline, statistic, value = line.split("\t")
			said.setdefault(pipeline, {}).setdefault(statistic, []).append(value)
	return said


def ensure():
	"""Fetches everything that both layers need."""
	machine.ensure(*machine.BUILDING, *NEEDED)
	pipelines()  # compiled before several threads want it


def ensure_mesa():
	"""Builds those two programs from Mesa's sources, in the version of the fetched drivers. Takes minutes, once."""
	stamp = MESA / "version"
	if stamp.exists() and stamp.read_text() == mesa_version():
		return
	pip_packages.ensure(REQUIREMENTS, MESON, "Meson")
	packages.fetch_source("mesa", DRIVERS, SOURCES)
	for name, old, new in EDITS:
		text = (SOURCES / name).read_text()
		if old not in text:
			raise Failure(f"Mesa's {name} has no {old!r} any more: lab/tools/driver_tools.py has to follow.")
		(SOURCES / name).write_text(text.replace(old, new))
	shutil.rmtree(MAKING, ignore_errors=True)
	no_packages = SOURCES / "no_packages.ini"  # the machine's own libraries are left out
	no_packages.write_text("[binaries]\npkg-config = 'no-pkg-config'\ncmake = 'no-cmake'\n")
	environment = {**os.environ, "PYTHONPATH": str(MESON), "PATH": f"{MESON}/bin:{os.environ['PATH']}"}
	with progress("Building two parts of Mesa", every=30):
		run(
			[sys.executable, "-m", "mesonbuild.mesonmain", "setup", MAKING, SOURCES, f"--native-file={no_packages}", *OPTIONS],
			env=environment,
		)
		run([MESON / "bin/ninja", "-C", MAKING, f"-j{os.environ.get('GRASS_JOBS', os.cpu_count())}", *BUILT], env=environment)
	shutil.rmtree(MESA, ignore_errors=True)
	MESA.mkdir()
	for name in BUILT:
		shutil.copy2(MAKING / name, MESA)
	stamp.write_text(mesa_version())
	for folder in (SOURCES, MAKING):
		shutil.rmtree(folder)


def ensure_validator():
	"""Microsoft's validator of DXIL, which a pip package contains."""
	if all((DXIL / name).exists() for name in MEMBERS):
		return
	archive = pip_packages.source("compushady==0.17.5", TOOLS / "dxil.partial", "Microsoft's validator of DXIL")
	with tarfile.open(archive) as package:
		for member in package.getmembers():
			if (name := pathlib.PurePath(member.name).name) in MEMBERS:
				(archive.parent / name).write_bytes(package.extractfile(member).read())
	archive.unlink()
	shutil.rmtree(DXIL, ignore_errors=True)
	archive.parent.rename(DXIL)


def to_msl(file):
	"""Returns a pass in Metal's language, by the translator that Godot uses. Raises Failure if that fails."""
	return run_fetched(spirv_cross(), "--msl", "--msl-version", "20100", file)


def to_dxil(file, stage="compute"):
	"""Returns the file of a shader as DXIL. Raises Failure if the translation fails."""
	made = FOLDER / f"{file.stem}.dxil"
	made.unlink(missing_ok=True)
	run([MESA / "spirv2dxil", "-s", stage, "-e", "main", "-m", "2", "-x", "7", "-o", made, file])
	if not made.exists():
		raise Failure("spirv2dxil wrote nothing.")
	return made


def wrong_dxil(files):
	"""Returns the validator's complaints about each of `files`; "" if there are none."""
	validator = compiled("lab/drivers/validate_dxil.cpp", "-isystem", DXIL, "-ldl")
	lines = run([validator, DXIL / MEMBERS[2], *files]).splitlines()
	said = dict(line.split("\t", 1) for line in lines)
	return {file: "" if said.get(str(file)) == "valid" else said.get(str(file), "nothing was said") for file in files}
