# SPDX-License-Identifier: MIT
"""`./grass bench`: runs the parts on this machine, or takes what a card elsewhere measured, and writes all pages from that one set."""

import pathlib

from lab.tools import commits, new_set, parts, run_parts
from lab.tools.bench_tables import Tables
from tools.places import OUT
from tools.say import Failure, say


def times():
	"""Seconds that each part of the committed set took."""
	return {name: part["seconds"] for name, part in Tables().parts.items() if part.get("seconds")}


def show_list():
	took = times()
	print("\n".join(run_parts.listing(took)))
	on_card = [part for part in parts.PARTS if part.where == parts.CARD and part.pages]
	say(f"A card needs {sum(took.get(part.name, part.seconds) for part in on_card):.0f} s; '?': not measured yet, an estimate")


def run(out, is_quick, only, gpu_results):
	chosen = parts.chosen(only)
	here = run_parts.only_here(chosen)
	folder = pathlib.Path(OUT / "bench" if gpu_results or not out else out).resolve()
	on_card = [] if gpu_results else [part for part in chosen if part.where == parts.CARD]
	if on_card and not is_quick and not only and not run_parts.has_card():
		raise Failure("There is no GPU with a screen here. --quick runs all as samples, --only here what the processor is asked for; "
			"lab/results/HOWTO.md tells how to ask a card elsewhere.")  # fmt: skip
	failed = run_parts.run([*on_card, *here], folder, is_quick)
	if failed:
		raise Failure(f"These failed, another start tries them again: {', '.join(failed)}. Tables and records are in {folder}.")
	if not gpu_results:
		say(f"Tables and records are in {folder}. `./grass bench all --gpu-results {folder} --out lab/results` writes the pages.")
		return
	if not out:
		raise Failure("--gpu-results needs --out: lab/results, or another folder for tables and pages.", 2)
	new_set.write(pathlib.Path(gpu_results).resolve(), folder, pathlib.Path(out).resolve(), commits.measured(), is_quick)
