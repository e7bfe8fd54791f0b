# SPDX-License-Identifier: MIT
"""Tests of what runs and shows the benchmarks, for the layer `lab`: nothing is measured. Each returns what is wrong, or ""."""

import contextlib
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
from unittest import mock

from lab.tools import bench_page, new_set, paper_page, parts, run_parts, summary
from lab.tools.bench_tables import FOLDER, Tables
from lab.tools.paper_rows import ms, pick
from tools.places import ROOT
from tools.say import Failure

COMMIT = "c0ffee12"
# In the place of an engine: fails for the part `second` until there is a file OUT/well.
RUN = """#!/bin/sh
while [ "$1" != -- ]; do shift; done
while [ $# -gt 0 ]; do
	case $1 in --as) name=$2 ;; --out) out=$2 ;; --commit) commit=$2 ;; esac
	shift
done
echo "$name" >>"$out/started"
[ "$name" = second ] && [ ! -e "$out/well" ] && exit 1
echo "{\\"part\\": \\"$name\\", \\"commit\\": \\"$commit\\", \\"quick\\": false}" >"$out/$name.json"
"""


def expected(*pairs):
	"""Returns what differs, of (what it is, its value, what it should be)."""
	return "; ".join(f"{what}: {value!r}, not {wanted!r}" for what, value, wanted in pairs if value != wanted)


def resumed():
	"""all.sh starts the parts that fit, none twice but those that failed, and goes on."""
	with tempfile.TemporaryDirectory() as place:
		pack, out = pathlib.Path(place, "pack"), pathlib.Path(place, "out")
		pack.mkdir()
		shutil.copy(ROOT / "lab/tools/all.sh", pack)
		(pack / "run.sh").write_text(RUN)
		(pack / "run.sh").chmod(0o755)
		(pack / "commit").write_text(COMMIT + "\n")
		lines = ["first first 10 forward_plus 64x64 shared -", "second draw 10 mobile 64x64 shared spirv --fixed-fps 60"]
		(pack / "parts").write_text("\n".join([*lines, "long long 10000 forward_plus 64x64 empty -", ""]))

		def start(seconds):
			command = ["sh", str(pack / "all.sh"), str(seconds), str(out)]
			found = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "TMPDIR": place})
			return found.returncode, (out / "started").read_text().split()

		short, cut = start(100), sorted(run_parts.records(out))
		(out / "well").touch()
		again, all_but_one = start(100), sorted(run_parts.records(out))
		long, everything = start(100000), sorted(run_parts.records(out))
		last = start(100)
		(pack / "commit").write_text("0ther\n")
		other = start(100)[0]
	return expected(
		("a part that fails", short, (1, ["first", "second"])),
		("records then", cut, ["first"]),
		("the next start", again, (1, ["first", "second", "second"])),
		("records after it", all_but_one, ["first", "second"]),
		("with more time", long, (0, ["first", "second", "second", "long"])),
		("records at the end", everything, ["first", "long", "second"]),
		("when all are done", last, (0, ["first", "second", "second", "long"])),
		("a folder of another commit", other, 2),
	)


def records():
	"""Parts of the right commit and size are done; a record that was cut off, or of another commit, is not."""
	chosen = parts.chosen("draw,rest,limits,sleep")
	with tempfile.TemporaryDirectory() as place:
		folder = pathlib.Path(place)
		for name, commit in (("draw", COMMIT), ("rest", "0ther")):
			(folder / f"{name}.json").write_text(json.dumps({"part": name, "commit": commit, "quick": False}))
		(folder / "limits.json").write_text('{"part": "lim')
		todo = [part.name for part in run_parts.left(chosen, folder, COMMIT, False)]
		samples = [part.name for part in run_parts.left(chosen, folder, COMMIT, True)]
		run_parts.write_manifest(folder)
		manifest = json.loads((folder / "manifest.json").read_text())
	return expected(
		("left", todo, ["rest", "limits", "sleep"]),
		("left as samples", samples, [part.name for part in chosen]),
		("in the manifest", sorted(manifest["parts"]), ["draw", "rest"]),
	)


def copied(place):
	"""A copy of lab/results, and results of a card and of here: the committed tables, as if of one commit. One part is missing."""
	folder, card, here = (pathlib.Path(place, name) for name in ("docs", "card", "here"))
	shutil.copytree(FOLDER, folder)
	tables = Tables(folder)
	for name in tables.parts:
		if name == "levels" or name.startswith("accuracy"):
			continue
		to = here if parts.BY_NAME[name].where == parts.HERE else card
		to.mkdir(exist_ok=True)
		shutil.copy(folder / tables.path(name), to / f"{name}.csv")
		record = {**tables.parts[name], "part": name, "commit": COMMIT, "date": "2031-02-03", "device": "NVIDIA H200", "quick": False}
		record["command"] = f"--only {name} --out {place} --spirv /a/b"
		(to / f"{name}.json").write_text(json.dumps({**record, "processor": "AMD EPYC 9000", "seconds": 12.5}))
	speeds = [f"DIRECT,swinging,{numbers},{speed},{speed / 0.5}" for numbers, speed in (("double", 0.5), ("float", 0.75))]
	(here / "speed.csv").write_text("\n".join(["# a processor", "method,scene,numbers,million_blades_a_second,times_double", *speeds, ""]))
	record = {"part": "speed", "commit": COMMIT, "quick": False, "date": "2031-02-03", "processor": "AMD EPYC 9000", "seconds": 1.0}
	(here / "speed.json").write_text(json.dumps(record))
	return folder, card, here


def one_set():
	"""A new set becomes tables in two folders, pages of its commit, and a line at the table of another one; what it replaces is gone."""
	with tempfile.TemporaryDirectory() as place:
		folder, card, here = copied(place)
		before = Tables(folder)
		with contextlib.redirect_stdout(io.StringIO()):
			new_set.write(card, here, folder, COMMIT, False)
		after = Tables(folder)
		page, paper = ((folder / name).read_text() for name in ("README.md", "paper.md"))
		flat = " ".join(page.split())
		lines = re.findall(r"\*\*Of another commit than the set's, (\w+): ([^*]*)\.\*\*", flat)
		others = [("levels.csv ({commit})".format(**before.parts["levels"]))]
		places = {path.parent.name for path in folder.glob("2031*/*")}
		earlier = [name for name in before.parts if not name.startswith("accuracy")]
		still = [name for name in earlier if (folder / before.path(name)).exists()]
		by_hand = "".join(page.read_text() for page in folder.glob("*.md") if page.name not in ("README.md", "paper.md"))
		named = [name for name in earlier if name == "levels" or before.path(name) in by_hand]
		return expected(
			("folders", places, {"2031-02-03-h200", "2031-02-03-epyc"}),
			("the set's commit", after.commit, COMMIT),
			("seconds of a part", after.parts["draw"]["seconds"], 12.5),
			("its command", after.parts["draw"]["command"], "--only draw --out OUT --spirv SPIRV"),
			("lines about other commits", lines, [(COMMIT, ", ".join(others))]),
			("such lines on the page of the paper", paper.count("Of another commit"), 0),
			("what the page says first", f"of commit {COMMIT}, but for those" in flat, True),
			("pages are what their tables make", (bench_page.page(after), paper_page.page(after)), (page, paper)),
			("the row of speeds", "| METHOD_DIRECT, swinging | 0.5 | 0.75 (1.5) |" in (folder / "solver.md").read_text(), True),
			("tables still there: that of the missing part, and those that text names", still, named),
		)


def here_alone():
	"""Where no card was asked, the set stays that of its commit, and the processor's tables say of which they are."""
	with tempfile.TemporaryDirectory() as place:
		folder, card, here = copied(place)
		before = Tables(folder)
		with contextlib.redirect_stdout(io.StringIO()):
			new_set.write(pathlib.Path(place, "none"), here, folder, COMMIT, False)
		after = Tables(folder)
		page = (folder / "README.md").read_text()
		return expected(
			("the set's commit", after.commit, before.commit),
			("a card's table", after.parts["draw"], before.parts["draw"]),
			("the processor's", after.parts["flops"]["table"], "2031-02-03-epyc/flops.csv"),
			("the page names its commit", f"flops.csv ({COMMIT})" in page, True),
		)


def refused():
	"""Samples, and tables of sources that are not committed, do not become pages of lab/results."""
	said = []
	for spoiled in ({"quick": True}, {"commit": COMMIT + "-dirty"}):
		with tempfile.TemporaryDirectory() as place, mock.patch.object(new_set, "FOLDER", pathlib.Path(place, "docs")):
			folder, card, here = copied(place)
			before = (folder / "set.json").read_text()
			(card / "rest.json").write_text(json.dumps({**json.loads((card / "rest.json").read_text()), **spoiled}))
			try:
				new_set.write(card, here, folder, COMMIT, False)
			except Failure as failure:
				said.append("rest" in str(failure) and (folder / "set.json").read_text() == before)
	return expected(("refused, with nothing written", said, [True, True]))


def first_lines():
	"""The first lines of the page name figures of the tables that they link, computed here in another way."""
	with tempfile.TemporaryDirectory() as place:
		folder, card, here = copied(place)
		rivals = card / "paper_rivals.csv"
		known = "\nrings," in rivals.read_text()
		theirs = (
			[]
			if known
			else [line.replace("multimesh 7", "rings") for line in rivals.read_text().splitlines() if line.startswith("multimesh 7")]
		)
		rivals.write_text("\n".join([rivals.read_text().rstrip(), *theirs, ""]))
		with contextlib.redirect_stdout(io.StringIO()):
			new_set.write(card, here, folder, COMMIT, False)
		tables = Tables(folder)
		found = [" ".join(line.split()) for line in summary.lines(tables)]
		rows = tables.rows
		meadow = {(row["field"], row["shadows"]): float(row["gpu_ms"]) for row in rows("meadow")}
		frames = {(row["kind"], row["shadows"]): ms(row) for row in pick(rows("paper_rivals"), view="eye", blades=1048576)}
		draws = [float(pick(rows(name), view="eye", blades=1048576, msaa=0, shadows="on")[0]["gpu_ms"]) for name in ("draw", "draw_mobile")]
		free = pick(rows("kernel"), awake_blades=1048576, method="DIRECT", **{"pass": "simulate_free"})[0]
		swings = pick(rows("kernel"), awake_blades=1048576, **{"pass": "strains"})[0]
		ball = pick(rows("movers"), mover="ball")[0]
		seen = pick(rows("detail"), detail="seen", seconds=3)[0]
		crowd = pick(rows("crowd"), bodies=128, crowd="moving")[0]
		bytes_of = {row["what"]: int(row["bytes"]) for row in rows("paper_memory")}
		a_blade = (bytes_of["all of a field of 16777216 blades"] - bytes_of["all of a field of 1048576 blades"]) / (16777216 - 1048576)
		rest = {row["field"]: float(row["wall_ms"]) for row in rows("rest")}
		wanted = [
			f"{meadow['plain', 'on'] - meadow['nothing', 'on']:.1f} ms with shadows",
			f"{frames['rings', 'off']:.1f} / {frames['rings', 'on']:.1f} ms",
			f"ours {frames['field', 'off']:.1f} / {frames['field', 'on']:.1f} ms",
			f"with shadows {draws[0]:.1f} and {draws[1]:.1f} ms",
			f"{float(swings['gpu_ms']):.1f} ms where they swing, {float(free['gpu_ms']):.1f} ms where something",
			f"{float(ball['simulate_ms']):.2f} ms on the card",
			f"{float(seen['simulate_ms']):.1f} ms on the card",
			f"{float(crowd['gather_ms_median']) + float(crowd['tiles_ms_median']):.2f} ms",
			f"{a_blade:.1f} MB for each million blades at rest, and {bytes_of['pool'] / 1e6:.0f} MB",
			f"hidden ones {max(0.0, rest['hidden'] - rest['nothing']):.2f} ms",
		]
		lines = [line for line in found if line]
		wrong = [f"{line!r} lacks {text!r}" for line, text in zip(lines, wanted) if text not in line]
		wrong += [f"no table for {line!r}" for line in lines if not (folder / re.search(r"\]\(([^)]*)\)", line)[1]).exists()]
		return "; ".join(wrong) or expected(("lines", len(lines), 10))


def every_part():
	"""Each part that a page shows is one that bench.gd or build/bench has, and all.sh can read its line."""
	text = (ROOT / "lab/project/bench/bench.gd").read_text()
	scenes = set(re.findall(r'^\t"(\w+)": preload', text, re.MULTILINE))
	unknown = [part.name for part in parts.PARTS if not part.program and part.key() not in scenes]
	lines = [line.split() for line in parts.listing({"draw": 99.4})]
	seconds = {words[0]: words[2] for words in lines}
	unread = [words[0] for words in lines if len(words) < 7 or not words[2].isdigit() or "x" not in words[4]]
	return expected(("unknown", unknown, []), ("lines of the list", unread, []), ("what a part took", seconds["draw"], "99"))


TESTS = {
	"lab/bench parts": every_part,
	"lab/bench resumes on a card": resumed,
	"lab/bench resumes here": records,
	"lab/bench one set": one_set,
	"lab/bench here alone": here_alone,
	"lab/bench samples are no pages": refused,
	"lab/bench first lines": first_lines,
}
