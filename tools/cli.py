# SPDX-License-Identifier: MIT
"""The commands of ./grass: calls the module that does the work."""

import signal
import sys

from tools.command_line import EXPLANATION, parser
from tools.places import OUT
from tools.say import Failure, complain, say


def dispatch(options):
	"""Returns the exit code."""
	if options.command == "try":  # first: it runs on systems that the rest does not know
		from tools.release import trial

		trial.compare(options.zips) if options.compare else trial.run_all(options.zips[0], options.out, options.driver, options.picture)
		return 0
	from tools.build import build
	from tools.release import export
	from tools.run import scenes
	from tools.test import testing  # here, so that the explanation appears at once

	if options.command == "demo":
		scenes.demo(options.place, options.out, options.size, options.method)
	elif options.command == "pictures":
		pictures(options)
	elif options.command == "bench":
		return bench(options)
	elif options.command == "editor":
		scenes.editor()
	elif options.command == "build":
		build.scons(*options.arguments)
	elif options.command == "format":
		from tools.test import formatting

		formatting.format_all()
	elif options.command == "tidy":
		from tools.test import tidy

		return tidy.run(options.files)
	elif options.command == "debug":
		from tools.run import debugging

		return debugging.run(options.only, options.at, options.trace)
	elif options.command == "docs":
		from tools.pages.site import build as site  # imported here: unlike the rest it needs Python 3.11

		site.make()
	elif options.command == "export":
		export.export(options.out, options.debug, options.tests)
	elif options.command == "page":
		from tools.release import page

		page.serve(options.out) if options.serve else page.make(options.out)
	elif options.command == "csharp":
		from tools.csharp import wrappers

		say(f"Written: the C# wrappers, in {wrappers.write(options.out)}")
	elif options.command == "release":
		from tools.release import release

		release.write_fixtures() if options.fixtures else release.make(options.only, options.out)
	elif options.command == "clean":
		build.clean(options.all)
	elif options.command == "test":
		unknown = set(options.layers) - set(testing.LAYERS)
		if unknown:
			raise Failure(f"There is no layer {', '.join(sorted(unknown))}; the layers are {', '.join(testing.LAYERS)}.", 2)
		return 0 if testing.run(tuple(options.layers) or testing.ALL, options.only, options.gpu) else 1
	return 0


def pictures(options):
	from lab.tools import pack, pictures

	if options.pack:
		pack.pictures(options.pack, pictures.listing())
	elif options.put:
		pictures.put(options.put, options.only)
	else:
		pictures.record(options.out, options.only)


def bench(options):
	"""Returns the exit code."""
	from lab.tools import bench_all, driver_figures, drivers_page, pack, rods
	from tools.test import testing

	if options.what == "stress":
		return testing.stress_in_full()
	if options.what == "drivers":
		if driver_figures.run(options.out, options.only):
			drivers_page.write()
	elif options.what == "rods":
		rods.run(options.out)
	elif options.what == "pack":
		pack.benchmark(options.out or OUT / "bench_pack", bench_all.times())
	elif options.list:
		bench_all.show_list()
	else:
		bench_all.run(options.out, options.quick, options.only, options.gpu_results)
	return 0


def main(arguments):
	if not arguments or arguments[0] in ("-h", "--help", "help"):
		print(EXPLANATION, end="")
		return 0
	# SIGTERM unwinds like Ctrl-C, so that the processes that were started are stopped, too.
	signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
	options = parser().parse_args(arguments)
	try:
		return dispatch(options)
	except Failure as failure:
		complain(failure)
		return failure.code
	except KeyboardInterrupt:
		complain("stopped")
		return 130


if __name__ == "__main__":
	sys.exit(main(sys.argv[1:]))
