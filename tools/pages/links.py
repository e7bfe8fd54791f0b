# SPDX-License-Identifier: MIT
"""Checks links: those of the Markdown sources, as they work here and on a forge, and those of the built site. Never goes online.

Why our own: link checkers are a binary to fetch for each platform, and none says that a page loads something from elsewhere, so that it
does not work offline, or shows a picture without a text.
"""

import functools
import html.parser
import re
import urllib.parse

LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(([^()\s]*(?:\([^()]*\))?[^()\s]*)(?:\s+\"[^\"]*\")?\)")
CODE = re.compile(r"^```.*?^```|`[^`\n]*`", re.MULTILINE | re.DOTALL)
EXTERNAL = re.compile(r"https://[\w.-]+\.[a-z]{2,}(?:[/?#][^\s]*)?")
LOADS = {"script": "src", "img": "src", "link": "href", "source": "src", "iframe": "src", "video": "src"}


def slug(heading, taken):
	"""Returns the anchor that a forge gives a heading."""
	text = re.sub(r"[^\w\- ]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()).strip().replace(" ", "-")
	taken[text] = taken.get(text, -1) + 1
	return f"{text}-{taken[text]}" if taken[text] else text


@functools.cache
def anchors(path):
	text, taken = re.sub(r"^```.*?^```", "", path.read_text(), flags=re.MULTILINE | re.DOTALL), {}
	return {slug(heading, taken) for heading in re.findall(r"^#+ +(.+?)\s*$", text, re.MULTILINE)}


def wrong_in_page(path):
	"""Returns what is wrong with the links of a Markdown page: a list of texts."""
	wrong = []
	for target in LINK.findall(CODE.sub("", path.read_text())):
		if "://" in target or target.startswith("mailto:"):
			if not EXTERNAL.fullmatch(target):
				wrong.append(f"{target} is no https address")
			continue
		name, _, anchor = target.partition("#")
		file = (path.parent / urllib.parse.unquote(name)).resolve() if name else path
		if not file.exists():
			wrong.append(f"{target} leads nowhere")
		elif anchor and file.suffix == ".md" and anchor not in anchors(file):
			wrong.append(f"{target}: no heading has that anchor")
	return wrong


class Page(html.parser.HTMLParser):
	"""The links of a built page, the files that it loads, and its anchors."""

	def __init__(self, text):
		super().__init__()
		self.links, self.loads, self.ids = [], [], set()
		self.feed(text)

	def handle_starttag(self, tag, attributes):
		values = dict(attributes)
		self.ids.update(filter(None, (values.get("id"), values.get("name") if tag == "a" else None)))
		if tag == "a" and values.get("href"):
			self.links.append(values["href"])
		elif tag in LOADS and values.get(LOADS[tag]) and values.get("rel") != "canonical":
			self.loads.append(values[LOADS[tag]])
		if tag == "img" and not values.get("alt"):
			self.loads.append(f"(a picture without a text: {values.get('src')})")


def wrong_in_site(site):
	"""Returns what is wrong with a built site: links and anchors that lead nowhere, and anything that is not part of it."""
	pages = {file: Page(file.read_text()) for file in sorted(site.rglob("*.html"))}
	wrong = [] if pages else [f"{site} has no page"]
	for file, page in pages.items():
		name = file.relative_to(site)
		if name.name == "404.html":
			continue  # the server shows it at any address, so its links begin at the root
		for target in page.links + page.loads:
			if target.startswith(("data:", "mailto:", "javascript:")):
				continue
			if "://" in target or target.startswith("//"):
				if target in page.loads:
					wrong.append(f"{name}: loads {target}, so it does not work offline")
				elif not EXTERNAL.fullmatch(target):
					wrong.append(f"{name}: {target} is no https address")
				continue
			path, _, anchor = target.partition("#")
			other = (file.parent / urllib.parse.unquote(path.partition("?")[0])).resolve() if path else file
			if not other.is_file():
				wrong.append(f"{name}: {target} leads nowhere")
			elif anchor and other in pages and urllib.parse.unquote(anchor) not in pages[other].ids:
				wrong.append(f"{name}: {target}: there is no such anchor")
	return wrong
