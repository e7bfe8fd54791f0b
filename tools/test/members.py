# SPDX-License-Identifier: MIT
"""Finds members of the extension's classes that point to an engine object. Part of the layer `docs`.

Scripts free engine objects whenever they are called (docs/history/0055), so a member holds an instance id, or a Ref of what counts its
references. ALLOWED lists the others with the reason why each is safe. It may only become shorter.
"""

import json
import re

from tools.places import ROOT

EXTENSION = ROOT / "extension"
COMMENT = re.compile(r"//.*")
OWN_CLASS = re.compile(r"\bGDCLASS\((\w+),")
DECLARATION = re.compile(r"^\s*(?!using\b|return\b|friend\b)[^()\n]*;\s*$", re.MULTILINE)  # of no function
INITIAL = re.compile(r"(?: = |\{)[^,;()\n]*(?=[,;])")  # the value that a member begins with; that of a variable in a function is a call
LAST_WORD = re.compile(r"(\w+)\W*$")

OWN_FIELD = "the field, of which it is a part and with which it ends"
OWN_WORLD = "the world, of which it is a part and with which it ends"
OWN_CHILD = "a child in the editor's own window, which it makes and frees"
ONE_CALL = "a value that lives within one call, in which no script runs"
SINGLETON = "the only instance, which frees itself when the extension is unloaded"
ALLOWED = {
	"editor/answer_view.h": (OWN_CHILD, "_label", "_panel"),
	"editor/brush_numbers.h": (OWN_CHILD, "slider"),
	"editor/brush_toolbar.h": (
		OWN_CHILD,
		"_species",
		"_color",
		"_channel",
		"_limits",
		"_menu",
		"_bake",
		"_stamp",
		"_shape",
		"_offer",
		"_row_end",
		"_no_target",
	),
	"editor/brush_tools.h": (OWN_CHILD, "_tools", "_why"),
	"editor/grass_editor_plugin.h": (OWN_CHILD, "_toolbar"),
	"editor/kept_plots_dialog.h": (SINGLETON, "_singleton"),
	"editor/limits_button.h": (OWN_CHILD, "_panel"),
	"editor/map_pictures.h": (ONE_CALL, "_world", "_fields"),
	"editor/map_step.h": (ONE_CALL, "new_of", "world"),
	"editor/own_map_dialog.h": (f"{SINGLETON}; {OWN_CHILD}", "_singleton", "_opener"),
	"editor/painted_fields.h": (ONE_CALL, "chosen", "fields", "world"),
	"editor/picture_dialog.h": (OWN_CHILD, "_dialog"),
	"editor/species_drops.h": (OWN_CHILD, "_drops"),
	"gpu/render_queue.h": (SINGLETON, "_singleton"),
	"ground/bare_answer.h": (ONE_CALL, "node"),
	"ground/field_filler.h": (OWN_FIELD, "_node"),
	"ground/field_terrain.h": (OWN_FIELD, "_node"),
	"ground/fill_gatherer.h": (ONE_CALL, "_field"),
	"nodes/field_monitors.h": ("fields, which remove themselves when they leave the tree; or " + SINGLETON, "_fields", "_singleton"),
	"nodes/field_turns.h": (SINGLETON, "_singleton"),
	"physics/ground_rays.h": (ONE_CALL, "_standing", "_space"),
	"physics/server_body.h": ("checked by its id in each tick, before the first use", "_state", "_node"),
	"shared/scene_watch.h": (SINGLETON, "_singleton"),
	"world/world_fields.h": (OWN_WORLD, "_world"),
	"world/world_report.h": (OWN_WORLD, "_world"),
	"world/world_work.h": (OWN_WORLD, "_world"),
}


def headers():
	"""(path relative to extension/, text without comments) of every header but the binding's."""
	for path in sorted(EXTENSION.rglob("*.h")):
		if path.relative_to(EXTENSION).parts[0] != "binding":
			yield str(path.relative_to(EXTENSION)), COMMENT.sub("", path.read_text())


def engine_classes():
	"""Returns the engine's classes that the extension uses."""
	return json.loads((EXTENSION / "binding/classes.json").read_text())["enabled_classes"]


def names_in(line):
	"""Returns names that a line declares: of pointers, or what follows the type of a list of them."""
	of_lists = line.rpartition(">")[2] if "<" in line else ""
	declared = of_lists.split(",") if of_lists else [part for part in line.split(",") if "*" in part or "&" in part]
	return [LAST_WORD.search(part)[1] for part in declared]


def pointers(text, classes):
	"""Returns names of what is declared in `text` with a type that points or refers to an object of one of `classes`."""
	points = re.compile(rf"\b(?:{'|'.join(classes)})(?: const)? [*&]")
	return [name for line in DECLARATION.findall(INITIAL.sub("", text)) if points.search(line) for name in names_in(line)]


def wrong():
	"""Returns what is wrong, or ""."""
	texts = dict(headers())
	classes = [*engine_classes(), *(name for text in texts.values() for name in OWN_CLASS.findall(text))]
	found = {(path, name) for path, text in texts.items() for name in pointers(text, classes)}
	allowed = {(path, name) for path, (_, *names) in ALLOWED.items() for name in names}
	new = [f"extension/{path}: `{name}` points to an engine object, which a script may free" for path, name in sorted(found - allowed)]
	advice = ["hold its instance id, or a Ref"] if new else []
	gone = [f"tools/test/members.py allows {path}: {name}, which is no more" for path, name in sorted(allowed - found)]
	return "; ".join(new + advice + gone)
