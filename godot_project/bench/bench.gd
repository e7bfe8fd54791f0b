# SPDX-License-Identifier: MIT
## Times drawing and simulation on this machine, counts what sleep saves, and writes CSV: `./grass bench`, or by hand.
## Absolute times mean something on a GPU only; the files name the device.
##   --out DIR      folder for the files
##   --only PART    what the part's file begins with: draw, limits, meadow, forces, movers, simulate, sleep, awake, rest, crowd, detail,
##                  levels, cpu, questions, change, hitch, species, kernel, accuracy; paper or paper_table1 and so on, which are left out
##                  without it
##   --spirv DIR    simulate_KNOTS.spv, for the parts `kernel`, `accuracy` and `paper_lists`, which are left out without it
##   --packs DIR    the problems of the part `accuracy`, which is left out without it
##   --quick yes    the parts `paper` as small as in software
##   --pictures DIR where the part `paper_rivals` puts pictures; none without it
extends Node3D

const Draw := preload("res://bench/bench_draw.gd")
const Simulate := preload("res://bench/bench_simulate.gd")
const Sleep := preload("res://bench/bench_sleep.gd")
const Rest := preload("res://bench/bench_rest.gd")
const Crowd := preload("res://bench/bench_crowd.gd")
const Detail := preload("res://bench/bench_detail.gd")
const Levels := preload("res://bench/bench_levels.gd")
const Awake := preload("res://bench/bench_awake.gd")
const Cpu := preload("res://bench/bench_cpu.gd")
const Questions := preload("res://bench/bench_questions.gd")
const Change := preload("res://bench/bench_change.gd")
const Kernel := preload("res://bench/bench_kernel.gd")
const Accuracy := preload("res://bench/bench_accuracy.gd")
const Meadow := preload("res://bench/bench_meadow.gd")
const Forces := preload("res://bench/bench_forces.gd")
const Movers := preload("res://bench/bench_movers.gd")
const Limits := preload("res://bench/bench_limits.gd")
const Hitch := preload("res://bench/bench_hitch.gd")
const Species := preload("res://bench/bench_species.gd")
const PaperTable1 := preload("res://bench/paper_table1.gd")
const PaperPasses := preload("res://bench/paper_passes.gd")
const PaperAwake := preload("res://bench/paper_awake.gd")
const PaperTiles := preload("res://bench/paper_tiles.gd")
const PaperLists := preload("res://bench/paper_lists.gd")
const PaperMemory := preload("res://bench/paper_memory.gd")
const PaperRivals := preload("res://bench/paper_rivals.gd")
const Measure := preload("res://bench/measure.gd")
const Table := preload("res://bench/table.gd")

const PAPER: Array[GDScript] = [PaperMemory, PaperLists, PaperAwake, PaperTiles, PaperPasses, PaperTable1, PaperRivals]


func _ready() -> void:
	var folder := _argument("--out", OS.get_user_data_dir())
	DirAccess.make_dir_recursive_absolute(folder)
	print("device: %s, %s" % [RenderingServer.get_video_adapter_name(), RenderingServer.get_current_rendering_method()])
	var only := _argument("--only", "")
	var spirv := _argument("--spirv", "")
	var wants := {Kernel: [spirv], Accuracy: [_argument("--packs", ""), spirv, folder]}  # what a part takes, in order
	for script: GDScript in [
		Draw,
		Limits,
		Meadow,
		Forces,
		Movers,
		Simulate,
		Sleep,
		Awake,
		Rest,
		Crowd,
		Detail,
		Levels,
		Cpu,
		Questions,
		Change,
		Hitch,
		Species,
		Kernel,
		Accuracy
	]:
		var part: Node = script.new()
		var arguments: Array = wants.get(script, [])
		if not part.FILE.begins_with(only) or arguments.has(""):
			part.free()
			continue
		add_child(part)
		var rows: Array[PackedStringArray] = await part.run.callv(arguments + [Measure.is_software()])
		part.queue_free()
		_write(folder.path_join(part.FILE), rows)
	if only.begins_with("paper"):
		await _run_paper(only, folder, spirv)
	get_tree().quit()


## These parts write their rows as they come, so a later failure loses nothing.
func _run_paper(p_only: String, p_folder: String, p_spirv: String) -> void:
	var wants := {PaperLists: [p_spirv], PaperRivals: [_argument("--pictures", "")]}
	for script in PAPER:
		var part: Node = script.new()
		if part.FILE.begins_with(p_only):
			add_child(part)
			var table := Table.new(p_folder.path_join(part.FILE))
			var start := Time.get_ticks_msec()
			await part.run.callv(wants.get(script, []) + [table, Measure.is_software() or _argument("--quick", "") == "yes"])
			print("%s: %.1f s" % [part.FILE, (Time.get_ticks_msec() - start) * 1e-3])
		part.queue_free()
		await get_tree().process_frame


func _argument(p_name: String, p_default: String) -> String:
	var arguments := OS.get_cmdline_user_args()
	var at := arguments.find(p_name)
	return arguments[at + 1] if at >= 0 and at + 1 < arguments.size() else p_default


func _write(p_path: String, p_rows: Array[PackedStringArray]) -> void:
	var file := FileAccess.open(p_path, FileAccess.WRITE)
	if file == null:
		push_error("Bench: cannot write %s (%s)." % [p_path, error_string(FileAccess.get_open_error())])
		return
	file.store_line(
		(
			"# %s, %s, Godot %s, %s"
			% [
				RenderingServer.get_video_adapter_name(),
				RenderingServer.get_current_rendering_method(),
				Engine.get_version_info().string,
				OS.get_processor_name()
			]
		)
	)
	for row in p_rows:
		file.store_csv_line(row)
		print(", ".join(row))
