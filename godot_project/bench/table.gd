# SPDX-License-Identifier: MIT
## A CSV that is written row by row, so that a failure does not lose earlier rows. Its first line names the device.
extends RefCounted

const Measure := preload("res://bench/measure.gd")

var _file: FileAccess
var _columns: PackedStringArray


func _init(p_path: String) -> void:
	_file = FileAccess.open(p_path, FileAccess.WRITE)
	if _file == null:
		push_error("Bench: cannot write %s (%s)." % [p_path, error_string(FileAccess.get_open_error())])
		return
	var software := ", software" if Measure.is_software() else ""
	var size: Vector2i = DisplayServer.window_get_size()
	_file.store_line(
		(
			"# %s, %s, Godot %s, %d x %d%s"
			% [
				RenderingServer.get_video_adapter_name(),
				RenderingServer.get_current_rendering_method(),
				Engine.get_version_info().string,
				size.x,
				size.y,
				software
			]
		)
	)


func columns(p_columns: PackedStringArray) -> void:
	_columns = p_columns
	_store(p_columns)


## p_values: by column; missing ones stay empty. `outcome` is "ok", or the reason why there are no numbers.
func add(p_values: Dictionary) -> void:
	var row := PackedStringArray()
	for column in _columns:
		var value: Variant = p_values.get(column, "ok" if column == "outcome" else "")
		row.append("%.4f" % value if value is float else str(value))
	_store(row)


func _store(p_row: PackedStringArray) -> void:
	print(", ".join(p_row))
	if _file != null:
		_file.store_csv_line(p_row)
		_file.flush()
