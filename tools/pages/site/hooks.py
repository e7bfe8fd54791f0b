# SPDX-License-Identifier: MIT
"""Functions that MkDocs calls while it builds the site: the version, folders in the navigation, equations."""

import html
import os
import pathlib
import re

from latex2mathml.converter import convert

BAR = re.compile(r"<mo[^>]*>(?:&#x0007C;|&#x02223;|\|)</mo>")  # of a length; alone it would be spaced as an operator
EQUATION = re.compile(r'<(span|div) class="arithmatex">\\([(\[])(.*?)\\[)\]]</\1>', re.DOTALL)


def expanded(nav, pages):
	"""`nav` with the pages of a folder in place of `folder/*`."""
	taken = re.findall(r"[\w./-]+\.md", str(nav))
	whole = []
	for entry in nav:
		if isinstance(entry, dict):
			whole += [{title: expanded(inner, pages) if isinstance(inner, list) else inner} for title, inner in entry.items()]
		elif entry.endswith("/*"):
			found = sorted(path.relative_to(pages).as_posix() for path in (pages / entry[:-2]).glob("*.md"))
			whole += [path for path in found if path not in taken]
		else:
			whole.append(entry)
	return whole


def on_config(config):
	config.site_name = f"GrassField {os.environ['GRASS_VERSION']}"
	config.copyright = f"GrassField {os.environ['GRASS_VERSION']}, {config.copyright}"
	config.nav = expanded(config.nav, pathlib.Path(config.docs_dir))
	return config


def on_page_content(content, page, config, files):
	"""Equations as MathML, which browsers draw by themselves."""

	def math(match):
		display = match[2] == "["
		source = re.sub(r"\\(mathbf|mathrm) (\w)", r"\\\1{\2}", html.unescape(match[3]))
		made = convert(source, display="block" if display else "inline")
		made = BAR.sub('<mo stretchy="false" lspace="0" rspace="0">|</mo>', made)
		made = re.sub(r"<mo>(&#x0002B;|&#x02212;)</mo><mo>&#x0003D;</mo>", r"<mo>\1=</mo>", made)
		return f'<div class="equation">{made}</div>' if display else made

	# A table that is wider than the page scrolls by itself.
	wide = re.sub(r"<table>.*?</table>", lambda match: f'<div class="wide">{match[0]}</div>', content, flags=re.DOTALL)
	return EQUATION.sub(math, wide)
