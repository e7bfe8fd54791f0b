# SPDX-License-Identifier: MIT
"""Libraries for macOS: one file for both processors, joined from two that zig links without Apple's SDK."""

import os
import struct

from tools.build.names import HERE

MAGIC, ALIGNMENT = 0xCAFEBABE, 14  # of a file for several processors; 2^14 bytes are a page of arm64
PROCESSORS = {"x86_64": (0x01000007, 3), "arm64": (0x0100000C, 0)}  # type and subtype


def is_ours(system, arch):
	"""Returns whether this build joins the libraries of both processors: a toolchain of the user's makes one file in one go."""
	return (system, arch) == ("macos", "universal") and HERE[0] != "macos" and not os.environ.get("CXX")


def join(slices, path):
	"""Writes one file for several processors from `architecture -> path of its own file`."""
	data = {arch: file.read_bytes() for arch, file in slices.items()}
	head = struct.pack(">II", MAGIC, len(data))
	start, body = 1 << ALIGNMENT, b""  # the head needs less
	for arch, content in data.items():
		head += struct.pack(">5I", *PROCESSORS[arch], start + len(body), len(content), ALIGNMENT)
		body += content + bytes(-len(content) % (1 << ALIGNMENT))
	path.parent.mkdir(parents=True, exist_ok=True)
	path.write_bytes(head.ljust(start, b"\0") + body)
	path.chmod(0o755)
	return path
