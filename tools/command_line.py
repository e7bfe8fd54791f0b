# SPDX-License-Identifier: MIT
"""The command line of ./grass: its explanation and its arguments. tools/cli.py runs it, the layer `docs` checks pages against it."""

import argparse

EXPLANATION = """\
GrassField: grass that every physics body pushes, for Godot 4.6.

  ./grass demo     runs the demo (or: meadow, lawn, reeds, forces, burning, levels, walk, presets) and prints where its pictures are
  ./grass test     builds and runs every layer of tests
  ./grass build    builds the extension for the project in godot_project/
  ./grass format   formats every source
  ./grass tidy     looks for mistakes in the C++ sources
  ./grass debug    opens the tests in gdb, with a library that can be debugged
  ./grass editor   opens that project in the engine's editor
  ./grass bench    runs the benchmarks (lab/README.md)
  ./grass pictures records the pictures of the docs, the film and the gallery (lab/README.md)
  ./grass docs     makes the site, out/site
  ./grass export OUT   packs the project to run elsewhere
  ./grass page     packs the demo as a page that a browser plays, out/page
  ./grass csharp OUT   writes the C# wrappers, which releases have in addons/grass_field/csharp
  ./grass release  makes the zips of a release, out/release
  ./grass try ZIP  runs a packed release in an empty project, on any system
  ./grass clean    removes everything that was built (--all: also everything that was fetched)

Missing tools (engine, SCons, Eigen, doctest, glslang, software Vulkan, Xvfb) are fetched into .tools/ here: nothing is
installed, and no root is needed. GODOT=/path/to/godot names an engine of your own, 4.6 or newer.
`./grass COMMAND --help` lists a command's options; docs/internals/building.md has the details.
"""


DEMOS = ("demo", "meadow", "lawn", "reeds", "presets", "forces", "burning", "levels", "walk")
BENCHMARKS = """all (default): every part that a page shows, each once; a second start goes on where the first was. stress: only the stress
	tests, in full; takes hours. drivers: the passes as compiled by Mesa, for cards that are not here. rods: blades beside
	other programs' rods, which are fetched. pack: everything that another
	machine's GPU needs, into --out"""


def parser():
	top = argparse.ArgumentParser(prog="./grass", add_help=False)
	commands = top.add_subparsers(dest="command", metavar="COMMAND")

	demo = commands.add_parser("demo", help="run the demo")
	demo.add_argument("place", nargs="?", default="demo", choices=DEMOS, help="demo: 128 bodies thrown into a field (default); or a place")
	demo.add_argument("--out", default=None, metavar="DIR", help="folder for pictures and table (default: out/PLACE)")
	demo.add_argument(
		"--size",
		choices=("small", "large"),
		help="of pictures, and of the field that bodies are thrown into; default: large on a GPU, small on software Vulkan",
	)
	demo.add_argument("--method", choices=("forward_plus", "mobile", "gl_compatibility"), default="forward_plus")

	pictures = commands.add_parser("pictures", help="record the pictures of the docs, into out/pictures")
	pictures.add_argument("--out", default=None, metavar="DIR", help="folder for the recordings (default: out/pictures)")
	pictures.add_argument("--only", default="", metavar="NAME,...", help="only these; lab/tools/pictures.py lists them")
	pictures.add_argument("--pack", metavar="DIR", help="instead, put everything into DIR that another machine's GPU needs to record them")
	pictures.add_argument("--put", metavar="DIR", help="instead, make docs/images of what was recorded in DIR")

	test = commands.add_parser("test", help="build and run the tests")
	test.add_argument(
		"layers",
		nargs="*",
		metavar="LAYER",
		help="which; docs/internals/building.md lists them (default: all but those that it runs 'by name only')",
	)
	test.add_argument("--only", default="", metavar="PART", help="only tests whose name contains PART")
	test.add_argument("--gpu", action="store_true", help="the gpu layer on this machine's GPU instead of software Vulkan")

	build = commands.add_parser("build", help="build the extension")
	build.add_argument("arguments", nargs="*", metavar="TARGET|OPTION=VALUE", help="passed on to SCons, such as target=release")

	commands.add_parser("format", help="format every source: C++, Python, GDScript")
	tidy = commands.add_parser("tidy", help="clang-tidy over C++ sources")
	tidy.add_argument("files", nargs="*", metavar="FILE", help="which (default: those of the extension, room by room)")
	debug = commands.add_parser("debug", help="run the headless tests in gdb, with a library built with -Og -g3")
	debug.add_argument("--only", default="", metavar="PART", help="only tests whose name contains PART")
	debug.add_argument("--trace", action="store_true", help="run at once, print a backtrace where it stops, and end")
	debug.add_argument("--break", dest="at", default="", metavar="PLACE", help="stop at this function or FILE:LINE")
	commands.add_parser("editor", help="open the project in the editor")
	bench = commands.add_parser("bench", help="run the benchmarks")
	bench.add_argument("what", nargs="?", choices=("all", "stress", "drivers", "rods", "pack"), default="all", help=BENCHMARKS)
	bench.add_argument("--quick", action="store_true", help="a sample of each part, on software Vulkan too")
	bench.add_argument("--list", action="store_true", help="only list the parts: where each runs, seconds that it took, pages that show it")
	bench.add_argument(
		"--gpu-results", metavar="DIR", help="take what the pack wrote to DIR on another machine's GPU, and write tables and pages to --out"
	)
	bench.add_argument("--out", default=None, metavar="DIR", help="folder for the tables (default: out/bench)")
	bench.add_argument(
		"--only",
		default="",
		metavar="PART,...",
		help="only these parts (--list names them), or all of here or card; of drivers: cards and passes, such as vangogh,cull",
	)

	commands.add_parser("docs", help="make the site, out/site")

	export = commands.add_parser("export", help="pack the project to run elsewhere")
	export.add_argument("out", metavar="OUT", help="folder to write to")
	export.add_argument("--debug", action="store_true", help="with the debug template and library")
	export.add_argument("--tests", action="store_true", help="the tests, to run the gpu layer on a machine without engine and compiler")

	page = commands.add_parser("page", help="pack the demo as a page that a browser plays; the first time builds an engine for it")
	page.add_argument("--out", default=None, metavar="DIR", help="folder to write to (default: out/page, where ./grass docs finds it)")
	page.add_argument("--serve", action="store_true", help="and serve it to this machine's browser until it is stopped")

	csharp = commands.add_parser("csharp", help="write the C# wrappers of the classes")
	csharp.add_argument("out", metavar="OUT", help="folder to write to, in a project with C#")

	release = commands.add_parser("release", help="make the zips of a release, out/release")
	release.add_argument(
		"--only", default="", metavar="TARGET", help="only these libraries, such as linux.x86_64 or linux.x86_64.release,windows"
	)
	release.add_argument("--out", default=None, metavar="DIR", help="folder for the zips (default: out/release)")
	release.add_argument("--fixtures", action="store_true", help="instead, write files of this version for the tests of later ones")

	trial = commands.add_parser("try", help="run a packed release in an empty project, in the engine that GODOT names")
	trial.add_argument("zips", nargs="+", metavar="ZIP", help="the add-on's zip, or the folder that holds it")
	trial.add_argument("--out", default=None, metavar="FILE", help="write what was seen, as JSON")
	trial.add_argument(
		"--driver", default="", help="in a window, with this rendering driver: vulkan, d3d12, metal, opengl3 (default: no window)"
	)
	trial.add_argument("--picture", default=None, metavar="FILE", help="of the window")
	trial.add_argument(
		"--compare",
		action="store_true",
		help="instead, compare such files and pictures, or all in these folders: bits are the same, pictures alike",
	)

	clean = commands.add_parser("clean", help="remove what was built")
	clean.add_argument("--all", action="store_true", help="also remove what was fetched")
	return top
