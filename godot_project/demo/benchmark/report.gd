# SPDX-License-Identifier: MIT
## The text that a player pastes into a report, and the file that tools read (tools/pages/machines_page.py).
extends RefCounted

const Parts := preload("res://demo/benchmark/parts.gd")
const FILE := "grass_benchmark.json"
const TEXT := "grass_benchmark.txt"
const COLUMNS := ["frame", "gpu", "cpu", "simulate", "cull", "manage"]
const NONE := "-"


static func text(result: Dictionary) -> String:
	var lines: Array[String] = ["GrassField %s" % result.grass]
	for key: String in result.machine:
		lines.append("%-17s %s" % [key, result.machine[key]])
	lines.append("%-17s %d ms" % ["first field", result.first_field_ms])
	lines.append("%-17s %s" % ["share", "whole" if result.share == 1.0 else "%.3f of the sides and times" % result.share])
	lines.append("")
	lines.append("ms, median      " + "".join(COLUMNS.map(func(column: String) -> String: return "%10s" % column)) + "     blades")
	for part: String in result.parts:
		lines.append(_row(part, result.parts[part]))
	lines.append("")
	for picture: String in result.pictures:
		var found: Dictionary = result.pictures[picture]
		lines.append("%-17s %s, %.4f off" % [picture, "as expected" if found.alike else "NOT AS EXPECTED", found.difference])
	if result.pictures.is_empty():
		lines.append("pictures          none: nothing is drawn")
	return "\n".join(lines)


## Returns the folder as the system names it.
static func write(folder: String, result: Dictionary, words: String) -> String:
	DirAccess.make_dir_recursive_absolute(folder)
	_store(folder.path_join(FILE), JSON.stringify(result, "\t", false) + "\n")
	_store(folder.path_join(TEXT), words + "\n")
	return ProjectSettings.globalize_path(folder)


static func _row(name: String, part: Dictionary) -> String:
	var row := "%-16s" % name
	for column: String in COLUMNS:
		row += "%10s" % ("%.3f" % part[column][0] if part[column][0] > 0.0 else NONE)
	return row + "%11d" % part.blades


static func _store(path: String, content: String) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	if file == null:
		push_error("Benchmark: cannot write %s (%s)." % [path, error_string(FileAccess.get_open_error())])
	else:
		file.store_string(content)
