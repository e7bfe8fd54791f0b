# SPDX-License-Identifier: MIT
"""Finds every code block that a user may copy: in README.md, in docs/ and in the class reference.

A block has a key, by which its check or its prelude in godot_project/tests/docs finds it: the page and the heading
(`game_a_mower`), or the class and the member (`grass_field_cut`). GDScript becomes a script whose lines have the numbers
that they have on the page, so that the engine's errors name the right one.
"""

import html
import json
import re
import shutil
import textwrap
from dataclasses import dataclass

from tools.places import BUILD, ROOT

MADE = BUILD / "snippets"
CLASSES = ROOT / "extension/doc_classes"
LANGUAGES = ("gdscript", "cpp", "csharp", "sh", "text")
ELSEWHERE = ("csharp", "text")  # languages whose blocks the layer `docs` leaves alone; the layer `csharp` compiles those in C#

# Blocks that are not run, by key, and why. Each is counted as a skip.
SKIPPED = {}

MEMBER = re.compile(r"^(?:func|static|signal|class|class_name|extends|const|enum|@)", re.MULTILINE)
STAGE = 'extends "res://tests/docs/stage.gd"'


MAIN_LOOP = re.compile(r"^extends SceneTree$", re.MULTILINE)  # a script for --script, which says by its exit code how it went


@dataclass
class Block:
	file: str  # from the project's root
	line: int  # of the block's first line of code
	key: str
	language: str
	text: str

	@property
	def place(self):
		return f"{self.file}:{self.line}"


def pages():
	"""Returns every Markdown page that is kept up to date: not those of the history."""
	return [*sorted(ROOT.glob("*.md")), *(page for page in sorted((ROOT / "docs").rglob("*.md")) if page.parent.name != "history")]


def identifier(text):
	return re.sub(r"\W+", "_", text.lower().replace("++", "pp")).strip("_")


def snake_case(name):
	return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def unique(key, taken):
	"""`key`, with a number from its second use on."""
	taken[key] = taken.get(key, 0) + 1
	return key if taken[key] == 1 else f"{key}_{taken[key]}"


def in_page(path):
	blocks, taken, heading, opened = [], {}, "", None
	for number, line in enumerate(path.read_text().splitlines(), 1):
		if opened and line.strip() == "```":
			blocks.append(opened)
			opened = None
		elif opened:
			opened.text += line + "\n"
		elif line.startswith("```"):
			key = unique("_".join(filter(None, (identifier(path.stem), identifier(heading)))), taken)
			opened = Block(str(path.relative_to(ROOT)), number + 1, key, line[3:].strip(), "")
		elif line.startswith("#"):
			heading = line.lstrip("# ")
	return blocks


def in_class(path):
	text, blocks, taken = path.read_text(), [], {}
	for match in re.finditer(r"\[(codeblock|gdscript)[^\]]*\]\n(.*?)\s*\[/\1\]", text, re.DOTALL):
		before = text[: match.start(2)]
		members = re.findall(r'<(?:method|member|signal|constant) name="(\w+)"', before)
		code = textwrap.dedent(html.unescape(match[2])) + "\n"
		key = unique("_".join([snake_case(path.stem), *members[-1:]]), taken)
		blocks.append(Block(str(path.relative_to(ROOT)), before.count("\n") + 1, key, "gdscript", code))
	return blocks


def find():
	blocks = [block for page in pages() for block in in_page(page)]
	return blocks + [block for path in sorted(CLASSES.glob("*.xml")) for block in in_class(path)]


def with_tabs(text):
	"""Four spaces at the start of a line are a tab: a script has one or the other."""
	return re.sub(r"^(?: {4})+", lambda match: "\t" * (len(match[0]) // 4), text, flags=re.MULTILINE)


def script(block):
	"""Returns the block as a script. Statements become the function run(), which leaves what they declare in `locals`."""
	text = with_tabs(block.text)
	if MEMBER.search(text):
		header = "" if re.search(r"^extends ", text, re.MULTILINE) else STAGE
		return header.ljust(len(header) + block.line - 1, "\n") + text
	header = f"{STAGE}\nfunc run() -> void:\n"
	names = re.findall(r"^var (\w+)", text, re.MULTILINE)
	kept = "".join(f'\tlocals["{name}"] = {name}\n' for name in names)
	return header.ljust(len(header) + block.line - 3, "\n") + textwrap.indent(text, "\t") + kept


def needs_check(block):
	return block.language == "gdscript" and block.key not in SKIPPED and not MAIN_LOOP.search(block.text)


def write_scripts(blocks):
	"""Writes the scripts of `blocks`, and a list of them for godot_project/tests/docs/runner.gd. Returns their folder."""
	shutil.rmtree(MADE, ignore_errors=True)
	MADE.mkdir(parents=True)
	listed = []
	for block in blocks:
		path = MADE / f"{block.file.replace('/', '_')}_{block.key}.gd"
		path.write_text(script(block))
		listed.append({"name": f"{block.place} {block.key}", "key": block.key, "path": str(path)})
	(MADE / "blocks.json").write_text(json.dumps(listed))
	return MADE
