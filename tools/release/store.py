# SPDX-License-Identifier: MIT
"""The add-on's page in Godot's Asset Store, as files in store/, and the rules that it must keep.

The rules are those of the engine's documentation ("Submitting to the Asset Store", and its questions and answers), read in November 2026.
"""

import json
import re

from tools.places import PROJECT, ROOT

PLACE = ROOT / "tools/release/store"
TYPES = ("Addon", "Full Project")
PICTURES = 5
SUMMARY_MOST = 120  # characters that the editor's list shows; the rules name no limit
ADDON = PROJECT / "addons/grass_field"


def page():
	return json.loads((PLACE / "page.json").read_text())


def changes(version):
	"""Returns what CHANGELOG.md says about a version; of one that has no entry yet, what is unreleased."""
	parts = re.split(r"^## ", (ROOT / "CHANGELOG.md").read_text(), flags=re.MULTILINE)[1:]
	texts = {re.match(r"\[?([\w.]+)", part)[1]: part.partition("\n")[2].strip() + "\n" for part in parts}
	return texts.get(version) or texts.get("Unreleased", "")


def is_picture(path):
	data = (ROOT / path).read_bytes() if (ROOT / path).is_file() else b""
	return data[:3] == b"\xff\xd8\xff" or data[:8] == b"\x89PNG\r\n\x1a\n"


def wrong(told=None):
	"""Returns what of the rules the page breaks, or "". `told`: another page, for a test of this one."""
	told = told or page()
	licence = (ROOT / "LICENSE").read_text()
	oldest = re.search(r'compatibility_minimum = "(.+)"', (ADDON / "grass_field.gdextension").read_text())[1]
	sentence = re.compile(r"[A-Z][^.]*[.].*", re.DOTALL)
	rules = {
		"the name is no title": re.fullmatch(r"[A-Z]\w[\w ]*", told["name"]),
		"the address has more than small letters, digits and hyphens": re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", told["slug"]),
		f"the type is none of {', '.join(TYPES)}": told["type"] in TYPES,
		f"the summary is no sentence of at most {SUMMARY_MOST} characters": sentence.fullmatch(told["summary"])
		and len(told["summary"]) <= SUMMARY_MOST,
		"the description is empty or not in sentences": sentence.match((PLACE / "description.md").read_text()),
		"there are no tags": told["tags"],
		"the licence is not that of LICENSE": licence.startswith(f"{told['license']} License"),
		"LICENSE names no year and holder": re.search(r"^Copyright \(c\) \d{4} \S+", licence, re.MULTILINE),
		"the oldest Godot is not that of the .gdextension": told["minimum_godot"] == oldest,
		"the thumbnail is no PNG or JPEG of the project": is_picture(told["thumbnail"]),
		f"there are not {PICTURES} pictures, PNG or JPEG": len(told["screenshots"]) == PICTURES
		and all(map(is_picture, told["screenshots"])),
		"a picture's caption is no sentence": all(map(sentence.fullmatch, told["screenshots"].values())),
		"the film is no file of the project": (ROOT / told["film"]).is_file(),
		"nothing says what was made by AI": sentence.match(told["ai_disclosure"]),
		"the add-on has no README of its own": (ADDON / "README.md").is_file(),
		"there is no .gitignore": (ROOT / ".gitignore").is_file(),
		"the version has no changes to tell": changes((ROOT / "VERSION").read_text().strip()),
	}
	return "; ".join(what for what, holds in rules.items() if not holds)


def wrong_or_blind():
	"""Returns the same; and that each of these faults is found."""
	told = page()
	faults = {
		"slug": "Grass Field",
		"type": "Plugin",
		"summary": "grass",
		"license": "GPL",
		"minimum_godot": "4.2",
		"thumbnail": "docs/images/none.jpg",
		"screenshots": {},
		"film": "docs/film",
		"ai_disclosure": "",
	}
	blind = [f"a wrong {key} is not found" for key, value in faults.items() if not wrong({**told, key: value})]
	return "; ".join(filter(None, [wrong(told), *blind]))
