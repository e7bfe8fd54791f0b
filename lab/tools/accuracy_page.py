# SPDX-License-Identifier: MIT
"""The two excerpts of lab/results/accuracy.md from accuracy/accuracy.csv. `./grass bench all --gpu-results` writes them."""

import re

from lab.tools import accuracy
from lab.tools.paper_rows import pick
from tools.pages.tables import grid

TABLE = re.compile(r"(<!-- table (free|contact) -->\n).*?(<!-- end -->)", re.DOTALL)
# method, knots, steps a frame, iterations
ROWS = (
	("PBD", 16, 1, 2), ("PBD", 16, 4, 4), ("DIRECT", 8, 1, 2), ("DIRECT", 16, 1, 1), ("DIRECT", 16, 1, 2), ("DIRECT", 16, 1, 4),
	("DIRECT", 16, 4, 2), ("DIRECT", 16, 4, 4), ("DIRECT", 32, 1, 2),
)  # fmt: skip
DEFAULT = ROWS[4]
COLUMNS = {
	"free": {"static_1": "sag Γ = 1", "static_5": "sag Γ = 5", "frequency": "frequency", "amplitude_lost": "amplitude lost a period",
		"transient": "swing after release"},
	"contact": {"slow_pass": "past a ball at 1 m/s", "fast_pass": "at 5 m/s", "slow_ensemble": "sward's height", "fast_ensemble": "sward pressed",
		"plate": "off a plate", "post": "off a post", "tremble": "trembling"},
}  # fmt: skip


def table(kind, notes, rows):
	body = []
	for which in ROWS:
		method, knots, substeps, iterations = which
		of = pick(rows, precision="CPU float", method=method, knots=knots, substeps=substeps, iterations=iterations)
		values = {row["error"]: row for row in of}
		if any(error not in values for error in COLUMNS[kind]):
			continue  # a sample has fewer
		name = f"**{method} {knots}** (default)" if which == DEFAULT else f"{method} {knots}"
		ms = float(next(values[error] for error in COLUMNS[kind])["ms"])
		body.append([name, f"{substeps} × {iterations}", f"{ms:.0f}", *(f"{float(values[error]['value']):.2g}" for error in COLUMNS[kind])])
	values = {row["error"]: row["value"] for row in pick(rows, precision="reference", knots=DEFAULT[1])}
	if values:
		body.append(
			["the reference itself", "", "", *(f"{float(values[error]):.2g}" if error in values else "" for error in COLUMNS[kind])]
		)
	head = ["method, knots", "", "ms", *COLUMNS[kind].values()]
	return [*grid(head, body), f"[accuracy.csv](accuracy/accuracy.csv): {'; '.join(notes)}.", ""]


def made(text, notes, rows):
	return TABLE.sub(lambda found: found[1] + "\n".join(["", *table(found[2], notes, rows)][1:]) + "\n" + found[3], text)


def write(tables):
	page, file = tables.folder / "accuracy.md", tables.folder / "accuracy/accuracy.csv"
	if page.exists() and file.exists():
		page.write_text(made(page.read_text(), *accuracy.read_table(file)))
