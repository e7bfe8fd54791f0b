# SPDX-License-Identifier: MIT
"""The folders (roots) that Debian packages are unpacked into, each of one suite, for one architecture.

The engine and what it needs come from `testing`; compilers for other platforms and what runs their programs from a stable
release, so that a library is made by the same compiler wherever it is made.
"""

import pathlib
from dataclasses import dataclass

from tools import places
from tools.places import TOOLS, UNPACKED

# Not unpacked: documentation, what the machine's own Python replaces, what compilers of other languages bring.
LEFT_OUT = (
	"./usr/share/doc/*",
	"./usr/share/man/*",
	"./usr/share/locale/*",
	"./usr/share/info/*",
	"./usr/share/lintian/*",
	"./usr/share/zoneinfo/*",
	"./usr/share/perl5/*",
	"./usr/bin/*python*",
	"./usr/bin/py*3*",
	"./usr/lib/python3.*",
	"./usr/lib/*/gconv/*",
	"./usr/share/vulkan/implicit_layer.d/*",
	"./usr/bin/*lto-dump*",
	"./usr/bin/qemu-[!ar]*",
	"./usr/lib/gcc*/*lto1",
	"./usr/lib/gcc*/adalib/*",
	"./usr/lib/gcc*/libgfortran*",
	"./usr/lib/*/libnode.so*",
)
OF_CARDS = (  # left out as well where nobody asks for them: cards use the system's drivers
	"./usr/bin/spirv-*",
	"./usr/share/vulkan/icd.d/*",
	*(
		f"./usr/lib/*/libvulkan_{name}.so"
		for name in (
			"asahi",
			"freedreno",
			"gfxstream",
			"intel",
			"intel_hasvk",
			"nouveau",
			"panfrost",
			"broadcom",
			"powervr_mesa",
			"radeon",
			"virtio",
		)
	),
)


@dataclass(frozen=True)
class Root:
	"""A folder of unpacked packages, and the state of apt that fills it."""

	place: pathlib.Path
	suite: str
	architecture: str = ""  # by Debian's name; empty: this machine's
	of_cards: bool = False  # GPUs' drivers and what translates shaders; its programs run by settle.through_loader() only
	has_sources: bool = False  # packages' sources are fetched by it as well

	@property
	def apt(self):
		return TOOLS / "apt" / self.place.name

	@property
	def archives(self):
		return self.apt / "archives"

	@property
	def partial(self):
		return self.place.with_name(self.place.name + ".partial")

	@property
	def old(self):
		return self.place.with_name(self.place.name + ".old")

	@property
	def left_out(self):
		"""Patterns of files that are not unpacked."""
		return LEFT_OUT if self.of_cards else (*LEFT_OUT, *OF_CARDS)


MAIN = Root(UNPACKED, "testing")
CROSS = Root(places.CROSS, "bookworm")  # compilers for other platforms, Wine, qemu
RISCV = Root(places.RISCV, "bookworm")  # apart: few builds need it
GLIBC = {  # what a library for Linux is linked against: glibc 2.31
	"x86_64": Root(TOOLS / "linux_x86_64", "bullseye", "amd64"),
	"arm64": Root(TOOLS / "linux_arm64", "bullseye", "arm64"),
}
DRIVERS = Root(
	places.DRIVERS, "trixie", of_cards=True, has_sources=True
)  # a stable release, so that figures of its compilers can be compared
EMSCRIPTEN = Root(places.EMSCRIPTEN, "testing")  # the first suite whose version Godot 4.6 takes
BROWSER = Root(places.BROWSER, "testing")
ENGINE_SOURCES = Root(TOOLS / "engine_sources", "testing", has_sources=True)  # of the engine that MAIN has
CSHARP = Root(places.CSHARP, "bookworm")  # a C# compiler
ENGINE_ARM64 = Root(TOOLS / "engine_arm64", "testing", "arm64")
