# SPDX-License-Identifier: MIT
"""The table of docs/guide/machines.md: results of the demo's benchmark that people sent, one file each in docs/guide/machines.

`python3 -m tools.pages.machines_page` writes it. The layer `docs` fails where the page differs from the files.
"""

import json
import re

from tools.pages.tables import grid
from tools.places import ROOT

PAGE = ROOT / "docs/guide/machines.md"
FOLDER = ROOT / "docs/guide/machines"
TABLE = re.compile(r"(<!-- table machines -->\n).*?(<!-- end -->)", re.DOTALL)
NONE = "No result has come yet."
PARTS = {
	"meadow_16": "meadow, 16", "meadow_64": "meadow, 64", "meadow_256": "meadow, 256", "walk": "walker", "bodies_10": "10 bodies",
	"bodies_128": "128 bodies",
}  # fmt: skip
HEAD = ["machine", "renderer", "first field, s", *PARTS.values(), "pictures"]


def row(result):
	machine = result["machine"]
	pictures = [name for name, picture in result["pictures"].items() if not picture["alike"]]
	return [
		f"{machine['device']}, {machine['system']}, {machine['driver']}",
		f"{machine['renderer']}, {machine['rendering_driver']}",
		f"{result['first_field_ms'] / 1000:.1f}",
		*(f"{result['parts'][part]['frame'][0]:.1f}" for part in PARTS),
		f"other than expected: {', '.join(pictures)}" if pictures else "as expected",
	]


def table(folder=FOLDER):
	"""Returns the table of the results in a folder. Those that software drew, or a part of the benchmark, are left out."""
	results = [json.loads(path.read_text()) for path in sorted(folder.glob("*.json"))]
	rows = [row(result) for result in results if result["share"] == 1 and result["machine"]["kind"] not in ("none", "software")]
	return "\n".join(grid(HEAD, rows)[1:-1]) if rows else NONE


def page(text):
	return TABLE.sub(lambda match: f"{match[1]}\n{table()}\n\n{match[2]}", text)


def wrong():
	"""Returns what is wrong with the page, or ""."."""
	text = PAGE.read_text()
	return "" if text == page(text) and TABLE.search(text) else "run `python3 -m tools.pages.machines_page`"


if __name__ == "__main__":
	PAGE.write_text(page(PAGE.read_text()))
