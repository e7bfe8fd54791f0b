# SPDX-License-Identifier: MIT
"""What a header of the binding offers, and what the surface files state of it."""

import collections
import re

STATEMENT = re.compile(r"^(METHOD|STATIC|FUNCTION|CONSTRUCTOR|EXPLICIT_CONSTRUCTOR|FIELD|CONSTANT|VALUE|TYPE|CALL|USE)\((.*)\)", re.M)


def plain(text):
	"""Returns the text without comments, strings and preprocessor lines."""
	text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
	text = re.sub(r'"(?:\\.|[^"\\])*"', '""', text)
	text = re.sub(r"^\s*ENGINE_CLASS\(.*\)$", "", text, flags=re.M)
	return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", "", text, flags=re.M)


def macros(text):
	"""Returns the macros that a header leaves defined; those with a leading _ are the binding's own."""
	text = re.sub(r"//[^\n]*", "", text)
	gone = set(re.findall(r"^#undef (\w+)", text, re.M))
	return set(re.findall(r"^\s*#define (?!_GODOT)(\w+)", text, re.M)) - gone


def close(text, start):
	"""Returns the place behind the brace that closes the one at `start`."""
	depth = 0
	for place in range(start, len(text)):
		depth += {"{": 1, "}": -1}.get(text[place], 0)
		if depth == 0:
			return place + 1
	raise ValueError("a brace is never closed")


def pieces(text):
	"""(head, body) of each declaration; the body is None where it ends with a semicolon."""
	start = place = 0
	while place < len(text):
		head = text[start:place]
		if text[place] == ";":
			yield head, None
			start = place + 1
		elif text[place] == "{":
			end = close(text, place)
			is_type = re.search(r"\b(namespace|class|struct|union|enum)\b[^()=]*$", head)
			# The braces of an initial value, or of a member in a constructor's list, end nothing.
			if not is_type and ("=" in re.sub(r"operator\S*", "", head).split("(")[0] or re.search(r"\)[^()]*:[^:].*\w$", head, re.S)):
				place = end
				continue
			yield head, text[place + 1 : end - 1]
			start = place = end
			if is_type and "namespace" not in head:
				place = text.index(";", end)
				start = place + 1
				place += 1
			continue
		place += 1


def scope(head):
	"""Returns (kind, name) of the namespace, class or enum that `head` begins."""
	match = re.search(r"\b(namespace|class|struct|union|enum)\b(?: class)?\s*([\w:]*)", head)
	return (match[1], match[2]) if match and "(" not in head else (None, None)


def name_of(head):
	"""Returns the name that a declaration declares, or None."""
	if alias := re.match(r"(?:template\s*<.*>\s*)?using (\w+) =", head):
		return alias[1]
	if "operator" not in head and "=" in head.split("(")[0]:
		head = head.split("=")[0]
	head = re.sub(r"template\s*<(?:[^<>]|<[^<>]*>)*>", "", head)
	if found := re.search(r"\boperator\s*(\(\)|\[\]|[^\s\w(]+|(?:const )?[\w:]+(?: ?\*)?)\s*\(", head):
		return "operator " + found[1].removeprefix("::godot::") if re.match(r"\w|:", found[1]) else "operator" + found[1]
	if found := re.search(r"(~?\w+)\s*\(", head):
		return found[1]
	names = re.findall(r"(\w+)\s*(?:\[\d+\])?\s*(?:=.*)?$", head.strip().split("=")[0].strip())
	return names[-1] if names else None


def offered(text, owner="", access=None):
	"""(class, member) of everything public, as often as it is declared."""
	for head, body in pieces(text):
		for label in re.findall(r"\b(public|protected|private)\s*:(?!:)", head):
			access = label
		head = re.sub(r"\b(?:public|protected|private)\s*:(?!:)", "", head).strip()
		kind, name = scope(head)
		if kind == "namespace":
			if name not in ("internal", "godot::internal", "gdextension_interface"):
				inner = "" if name == "godot" else name.removeprefix("godot::")
				yield from offered(body, inner, None)
			continue
		if access in ("private", "protected") or re.match(r"(friend|using namespace|static_assert|extern|_Pragma)\b", head) or not head:
			continue
		if "= delete" in head or re.match(r"template\s*<>", head) or (not owner and "::" in head.split("(")[0]):
			continue
		if kind == "enum" and body is not None:
			yield from ((owner, value) for value in re.findall(r"(\w+)\s*(?:=[^,]*)?(?:,|$)", body.strip()))
		elif kind in ("class", "struct") and body is not None and name:
			inner = f"{owner}::{name}" if owner else name
			yield from offered(body, inner, "private" if kind == "class" else "public")
		elif kind == "union" or (kind == "struct" and not name):
			yield from offered(body, owner, "public")
		elif kind in ("class", "struct") and body is None:
			continue
		else:
			last = owner.split("::")[-1]
			for found in [name_of(head)] if re.search(r"[(=]", head) or "," not in head else re.findall(r"(\w+)\s*(?:,|$)", head):
				copies = found in (last, "operator=") and re.search(rf"\((?:const )?{last}\s*&&?\s*\w*\)", head)
				if found and not found.startswith(("_", "~", "operator new", "operator delete")) and not copies:
					yield owner, found


def stated(texts):
	"""Returns how often each (class, member) is stated."""
	count = collections.Counter()
	aliases = dict(re.findall(r"^using (\w+) = (\w+)", "\n".join(texts), re.M))
	for kind, inner in STATEMENT.findall("\n".join(texts)):
		parts = [part.strip() for part in inner.split(",")]
		if kind.endswith("CONSTRUCTOR"):
			owner = re.match(r"[\w:]+", parts[0])[0]
			count[owner, owner.split("::")[-1]] += 1
			continue
		if kind in ("FUNCTION", "CONSTANT", "VALUE", "TYPE"):
			owner, _, name = parts[0].rpartition("::")
		else:
			owner, name = parts[:2]
		owner = aliases.get(owner, owner)
		count[owner, name.replace("operator ::godot::", "operator ")] += 1
	return count
