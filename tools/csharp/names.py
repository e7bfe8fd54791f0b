# SPDX-License-Identifier: MIT
"""Names by the rules of Godot's own C#: GetTileAt for get_tile_at, KindEnum for an enum that shares its name with a property."""

import os
import re

KEYWORDS = frozenset(
	"abstract as base bool break byte case catch char checked class const continue decimal default delegate do double else enum event"
	" explicit extern false finally fixed float for foreach goto if implicit in int interface internal is lock long namespace new null"
	" object operator out override params private protected public readonly ref return sbyte sealed short sizeof stackalloc static"
	" string struct switch this throw true try typeof uint ulong unchecked unsafe ushort using virtual void volatile while".split()
)


def pascal(name):
	return "".join(part[:1].upper() + part[1:].lower() for part in name.split("_"))


def camel(name):
	made = pascal(name)
	made = made[:1].lower() + made[1:]
	return f"@{made}" if made in KEYWORDS else made


def enum(made, name):
	"""Returns the name of an enum of the class `made`."""
	taken = {pascal(member.name) for member in (*made.members, *made.methods, *made.signals)}
	return f"{name}Enum" if name in taken else name


def enum_values(constants):
	"""[(name, constant)] without the words that all names begin with."""
	names = [constant.name for constant in constants]
	shared = os.path.commonprefix(names) if len(names) > 1 else ""
	shared = shared[: shared.rfind("_") + 1]
	if any(re.match(r"\d|$", name[len(shared) :]) for name in names):
		shared = ""
	return [(pascal(constant.name[len(shared) :]), constant) for constant in constants]
