# SPDX-License-Identifier: MIT
## Times drawing and simulation on this machine, counts what sleep saves, and writes CSV: `./grass bench`, or by hand.
## Absolute times mean something on a GPU only; the files name the device.
##   --out DIR      folder for the files
##   --only PART    draw, simulate, sleep, kernel or accuracy
##   --spirv DIR    simulate_KNOTS.spv, for the parts `kernel` and `accuracy`, which are left out without it
##   --packs DIR    the problems of the part `accuracy`, which is left out without it
extends Node3D

const Draw := preload("res://bench/bench_draw.gd")
const Simulate := preload("res://bench/bench_simulate.gd")
const Sleep := preload("res://bench/bench_sleep.gd")
const Kernel := preload("res://bench/bench_kernel.gd")
const Accuracy := preload("res://bench/bench_accuracy.gd")


func _ready() -> void:
	var folder := _argument("--out", OS.get_user_data_dir())
	DirAccess.make_dir_recursive_absolute(folder)
	print("device: %s, %s" % [RenderingServer.get_video_adapter_name(), RenderingServer.get_current_rendering_method()])
	var only := _argument("--only", "")
	var spirv := _argument("--spirv", "")
	var wants := { Kernel: [spirv], Accuracy: [_argument("--packs", ""), spirv, folder] } # what a part takes, in order
	for script: GDScript in [Draw, Simulate, Sleep, Kernel, Accuracy]:
		var part: Node = script.new()
		var arguments: Array = wants.get(script, [])
		if not part.FILE.begins_with(only) or arguments.has(""):
			part.free()
			continue
		add_child(part)
		var rows: Array[PackedStringArray] = await part.run.callv(arguments + [is_software()])
		part.queue_free()
		_write(folder.path_join(part.FILE), rows)
	get_tree().quit()


static func is_software() -> bool:
	return RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU


## Middle value; 0 of nothing.
static func median(p_values: Array[float]) -> float:
	var sorted := p_values.duplicate()
	sorted.sort()
	return sorted[sorted.size() >> 1] if sorted else 0.0


func _argument(p_name: String, p_default: String) -> String:
	var arguments := OS.get_cmdline_user_args()
	var at := arguments.find(p_name)
	return arguments[at + 1] if at >= 0 and at + 1 < arguments.size() else p_default


func _write(p_path: String, p_rows: Array[PackedStringArray]) -> void:
	var file := FileAccess.open(p_path, FileAccess.WRITE)
	if file == null:
		push_error("Bench: cannot write %s (%s)." % [p_path, error_string(FileAccess.get_open_error())])
		return
	file.store_line("# %s, %s, Godot %s" % [RenderingServer.get_video_adapter_name(), RenderingServer.get_current_rendering_method(), Engine.get_version_info().string])
	for row in p_rows:
		file.store_csv_line(row)
		print(", ".join(row))
