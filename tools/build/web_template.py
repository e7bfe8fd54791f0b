# SPDX-License-Identifier: MIT
"""The engine for Web: an export template without threads that loads extensions, built from Debian's sources of the engine.

The official templates are made by another Emscripten than Debian's, which a side module must share with its engine. Debian leaves out
libraries that the engine brings along; they come from their own packages, and only those that a small engine needs.
"""

import os
import pathlib
import shutil
import subprocess

from tools.build import emscripten
from tools.fetch import machine, packages
from tools.fetch.roots import DRIVERS, ENGINE_SOURCES
from tools.places import TOOLS, WEB_TEMPLATE
from tools.say import Failure, progress

SOURCES = TOOLS / "web_template_sources"
LIBRARIES = TOOLS / "web_template_libraries"
LOG = TOOLS / "web_template.log"
NAME = "godot.web.template_release.wasm32.nothreads.dlink.zip"
TEMPLATE = WEB_TEMPLATE / NAME
NAMED = "GRASS_WEB_TEMPLATE"  # of the environment: the template to take instead, without threads and with extensions
# Of each package the folder that the engine calls by the second name. A stable release's, which changes rarely.
PARTS = {
	"zlib": ("", "zlib"),
	"libzstd": ("lib", "zstd"),
	"libpng1.6": ("", "libpng"),
	"mbedtls": ("", "mbedtls"),
	"freetype": ("", "freetype"),
}
HASHES = ("AES", "BASE64", "CTR_DRBG", "ENTROPY", "MD", "MD5", "SHA1", "SHA256")
SETTINGS = (*(f"{name}_C" for name in HASHES), "CIPHER_MODE_CBC", "CIPHER_MODE_CFB", "ENTROPY_FORCE_SHA256", "NO_PLATFORM_ENTROPY")
WIPING = """\
#include <stddef.h>

void mbedtls_platform_zeroize(void *p_bytes, size_t p_count) {
	for (volatile unsigned char *byte = p_bytes; p_count > 0; p_count--)
		*byte++ = 0;
}
"""
MODULES = ("gdscript", "godot_physics_3d", "freetype", "text_server_fb", "noise")
OPTIONS = (
	"platform=web",
	"target=template_release",
	"dlink_enabled=yes",
	"threads=no",
	"optimize=custom",  # what is built once and run for minutes
	"ccflags=-O1",
	"linkflags=-O1",
	"lto=none",
	"scu_build=yes",
	"scu_limit=16",
	"modules_enabled_by_default=no",
	*(f"module_{name}_enabled=yes" for name in MODULES),
	*(f"{name}=no" for name in ("brotli", "builtin_certs", "graphite", "openxr", "sdl", "accesskit", "progress")),
	*(f"disable_{name}=yes" for name in ("navigation_2d", "navigation_3d", "physics_2d", "xr")),
)


def put_libraries():
	"""Fetches the libraries that Debian leaves out, and lays them where the engine looks for them."""
	for package, (folder, name) in PARTS.items():
		packages.fetch_source(package, DRIVERS, LIBRARIES / package)
		shutil.copytree(LIBRARIES / package / folder, SOURCES / "thirdparty" / name)
	png, mbedtls = (SOURCES / "thirdparty" / name for name in ("libpng", "mbedtls"))
	shutil.copyfile(png / "scripts/pnglibconf.h.prebuilt", png / "pnglibconf.h")
	certificates = SOURCES / "thirdparty/certs/ca-bundle.crt"  # which only a module reads that is left out
	certificates.parent.mkdir()
	certificates.touch()
	# Two files that the engine has in this library's folder, and Debian leaves out with it.
	(mbedtls / "include/godot_core_mbedtls_config.h").write_text("".join(f"#define MBEDTLS_{name}\n" for name in SETTINGS))
	(mbedtls / "library/godot_core_mbedtls_platform.c").write_text(WIPING)


def make():
	command, additions = machine.scons()
	path = f"{emscripten.FETCHED / 'share/emscripten'}:{os.environ['PATH']}"
	environment = {**os.environ, **additions, **emscripten.environment(), "PATH": path}
	jobs = os.environ.get("GRASS_JOBS", os.cpu_count())
	with open(LOG, "w") as log, progress("Building the engine for Web (half an hour, once)", every=60):
		code = subprocess.run(
			[*command, f"-j{jobs}", *OPTIONS], cwd=SOURCES, env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=log
		).returncode
	if code:
		raise Failure(f"The engine for Web could not be built; {LOG.relative_to(TOOLS.parent)} says why.")


def ensure():
	"""Builds it, if that was not done yet and the environment names no other. Returns the template."""
	if named := os.environ.get(NAMED):
		if not os.path.isfile(named):
			raise Failure(f"{NAMED} names {named}: there is no such file.")
		return pathlib.Path(named).resolve()
	if TEMPLATE.exists():
		return TEMPLATE
	emscripten.ensure()
	machine.ensure(*machine.BUILDING)
	whole = SOURCES / "whole"
	if not whole.exists():
		packages.fetch_source("godot", ENGINE_SOURCES, SOURCES)
		put_libraries()
		whole.touch()
	make()
	WEB_TEMPLATE.mkdir(exist_ok=True)
	shutil.copyfile(SOURCES / "bin" / NAME, TEMPLATE)
	for folder in (SOURCES, LIBRARIES):
		shutil.rmtree(folder)
	return TEMPLATE
