# SPDX-License-Identifier: MIT
## A CSV that is written row by row, so that a failure does not lose earlier rows. Its first line names the device and the commit.
extends RefCounted

const Machine := preload("res://demo/benchmark/machine.gd")
const Measure := preload("res://bench/measure.gd")

var count := 0  ## rows
var failed := 0  ## rows whose outcome is not "ok"

var _file: FileAccess
var _columns: PackedStringArray


func _init(p_path: String, p_commit := "unknown") -> void:
	_file = FileAccess.open(p_path, FileAccess.WRITE)
	if _file == null:
		push_error("Bench: cannot write %s (%s)." % [p_path, error_string(FileAccess.get_open_error())])
		return
	var machine := Machine.describe()
	var software := ", software" if Measure.is_software() else ""
	var what: Array[String] = [
		machine.device, machine.driver, machine.renderer, "Godot " + machine.engine, machine.processor, machine.window
	]
	var known := what.filter(func(text: String) -> bool: return not text.strip_edges().is_empty())
	_file.store_line("# %s%s; commit %s; %s" % [", ".join(known), software, p_commit, Time.get_date_string_from_system(true)])


func columns(p_columns: PackedStringArray) -> void:
	_columns = p_columns
	_store(p_columns)


## p_values: by column; missing ones stay empty. `outcome` is "ok", or the reason why there are no numbers.
func add(p_values: Dictionary) -> void:
	var row := PackedStringArray()
	for column in _columns:
		var value: Variant = p_values.get(column, "ok" if column == "outcome" else "")
		row.append("%.4f" % value if value is float else str(value))
	failed += int(p_values.get("outcome", "ok") != "ok")
	count += 1
	_store(row)


## The columns' names and then rows of texts.
func add_all(p_rows: Array[PackedStringArray]) -> void:
	for row in p_rows:
		_store(row)
	count += maxi(0, p_rows.size() - 1)


func _store(p_row: PackedStringArray) -> void:
	print(", ".join(p_row))
	if _file != null:
		_file.store_csv_line(p_row)
		_file.flush()
