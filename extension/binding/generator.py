#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the part of the godot-cpp interface that follows from the engine's own API dump.

Usage: generator.py --api extension_api.json [--interface gdextension_interface.h] --classes classes.json [--precision double]
	--out DIR
Writes DIR/include (headers) and DIR/src (sources). Files whose text has not changed keep their time stamp,
so a build that runs this every time rebuilds nothing.
"""

import argparse
import json
import os

from generate.api import Api
from generate.builtins import write_builtins, write_utility_functions
from generate.classes import write_classes, write_global_constants
from generate.interface import write_interface, write_version
from generate.precision import as_double


class Output:
	"""A folder to write into; remembers what it wrote and removes what is no longer written."""

	def __init__(self, folder):
		self.folder = folder
		self.written = set()

	def write(self, path, text):
		"""Writes one file (path relative to the folder), unless it already holds this text."""
		full = os.path.join(self.folder, path)
		self.written.add(os.path.abspath(full))
		os.makedirs(os.path.dirname(full), exist_ok=True)
		if os.path.exists(full):
			with open(full, encoding="utf-8") as file:
				if file.read() == text:
					return
		with open(full, "w", encoding="utf-8") as file:
			file.write(text)

	def remove_stale(self):
		"""Removes headers and sources of an earlier run that this run did not write."""
		for part in ("include", "src"):
			for root, _, files in os.walk(os.path.join(self.folder, part)):
				for name in files:
					full = os.path.abspath(os.path.join(root, name))
					if full not in self.written and name.endswith((".hpp", ".h", ".inc", ".cpp")):
						os.remove(full)


def main():
	parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
	parser.add_argument("--api", required=True, help="extension_api.json of the engine")
	parser.add_argument("--interface", help="gdextension_interface.h of the engine; by default the one beside the api")
	parser.add_argument("--classes", required=True, help="JSON with the key enabled_classes")
	parser.add_argument("--precision", choices=("single", "double"), default="single", help="of the engine that loads the extension")
	parser.add_argument("--out", required=True, help="folder to write to")
	arguments = parser.parse_args()

	with open(arguments.api, encoding="utf-8") as file:
		dump = json.load(file)
	beside = os.path.join(os.path.dirname(arguments.api), "gdextension_interface.h")
	with open(arguments.interface or beside, encoding="utf-8") as file:
		interface = file.read()
	with open(arguments.classes, encoding="utf-8") as file:
		enabled = json.load(file)["enabled_classes"]

	if arguments.precision == "double":
		dump = as_double(dump)
	elif dump["header"]["precision"] != "single":
		raise SystemExit(f"{arguments.api} is of a double-precision engine: build for it with precision=double, or name another engine.")
	api = Api(dump, enabled)
	output = Output(arguments.out)
	core = os.path.join(os.path.dirname(os.path.abspath(__file__)), "include", "godot_cpp")
	write_interface(output, interface)
	write_version(output, api)
	write_global_constants(output, api)
	write_builtins(output, api, core)
	write_utility_functions(output, api)
	write_classes(output, api)
	output.remove_stale()


if __name__ == "__main__":
	main()
