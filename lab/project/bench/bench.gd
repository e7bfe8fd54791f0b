# SPDX-License-Identifier: MIT
## Runs one part of the benchmarks and writes its table, NAME.csv, and then its record, NAME.json: that there is one says that the part is
## done. `./grass bench` and the pack's all.sh start it once for each part. Absolute times mean something on a GPU only.
##   --only PART    which of PARTS
##   --as NAME      what table and record are called; default: PART
##   --out DIR      folder for both
##   --commit TEXT  the commit that is measured
##   --quick yes    as small as in software
##   --spirv DIR    simulate_KNOTS.spv, for the parts `kernel`, `accuracy` and `paper_lists`
##   --packs DIR    the problems of the part `accuracy`
##   --pictures DIR where the part `paper_rivals` puts pictures; none without it
extends Node3D

const Machine := preload("res://demo/benchmark/machine.gd")
const Measure := preload("res://bench/measure.gd")
const Table := preload("res://bench/table.gd")

const PARTS: Dictionary[String, GDScript] = {
	"accuracy": preload("res://bench/bench_accuracy.gd"),
	"awake": preload("res://bench/bench_awake.gd"),
	"change": preload("res://bench/bench_change.gd"),
	"cpu": preload("res://bench/bench_cpu.gd"),
	"crowd": preload("res://bench/bench_crowd.gd"),
	"detail": preload("res://bench/bench_detail.gd"),
	"draw": preload("res://bench/bench_draw.gd"),
	"forces": preload("res://bench/bench_forces.gd"),
	"hitch": preload("res://bench/bench_hitch.gd"),
	"kernel": preload("res://bench/bench_kernel.gd"),
	"levels": preload("res://bench/bench_levels.gd"),
	"limits": preload("res://bench/bench_limits.gd"),
	"meadow": preload("res://bench/bench_meadow.gd"),
	"movers": preload("res://bench/bench_movers.gd"),
	"paper_awake": preload("res://bench/paper_awake.gd"),
	"paper_lists": preload("res://bench/paper_lists.gd"),
	"paper_memory": preload("res://bench/paper_memory.gd"),
	"paper_passes": preload("res://bench/paper_passes.gd"),
	"paper_rivals": preload("res://bench/paper_rivals.gd"),
	"paper_table1": preload("res://bench/paper_table1.gd"),
	"paper_tiles": preload("res://bench/paper_tiles.gd"),
	"questions": preload("res://bench/bench_questions.gd"),
	"rest": preload("res://bench/bench_rest.gd"),
	"room": preload("res://bench/bench_room.gd"),
	"simulate": preload("res://bench/bench_simulate.gd"),
	"sleep": preload("res://bench/bench_sleep.gd"),
	"species": preload("res://bench/bench_species.gd"),
	"town": preload("res://bench/bench_town.gd"),
	"touch": preload("res://bench/bench_touch.gd"),
}


func _ready() -> void:
	var done := await _run(_argument("--only", ""), _argument("--out", OS.get_user_data_dir()))
	get_tree().quit(0 if done else 1)


func _run(p_only: String, p_folder: String) -> bool:
	if not PARTS.has(p_only):
		push_error("Bench: --only takes one of %s." % ", ".join(PARTS.keys()))
		return false
	var name := _argument("--as", p_only)
	var spirv := _argument("--spirv", "")
	var wants: Dictionary[String, Array] = {  # what a part takes, in order
		"kernel": [spirv],
		"paper_lists": [spirv],
		"paper_rivals": [_argument("--pictures", "")],
		"accuracy": [_argument("--packs", ""), spirv, p_folder],
	}
	if p_only in ["kernel", "paper_lists", "accuracy"] and "" in wants[p_only]:
		push_error("Bench: the part %s needs --spirv%s." % [p_only, " and --packs" if p_only == "accuracy" else ""])
		return false
	DirAccess.make_dir_recursive_absolute(p_folder)
	var table := Table.new(p_folder.path_join(name + ".csv"), _argument("--commit", "unknown"))
	var part: Node = PARTS[p_only].new()
	add_child(part)
	var arguments: Array = wants.get(p_only, [])
	var is_small := Measure.is_software() or _argument("--quick", "") == "yes"
	if p_only.begins_with("paper_"):  # these write their rows as they come
		await part.run.callv(arguments + [table, is_small])
	else:
		table.add_all(await part.run.callv(arguments + [is_small]))
	if table.count == 0:
		push_error("Bench: the part %s measured nothing." % name)
		return false
	return _record(p_folder.path_join(name + ".json"), name, table)


## Written last, and at once: a part that was stopped has none.
func _record(p_path: String, p_name: String, p_table: Table) -> bool:
	var record := Machine.describe()
	(
		record
		. merge(
			{
				part = p_name,
				state = "done" if p_table.failed == 0 else "done, but for %d rows" % p_table.failed,
				commit = _argument("--commit", "unknown"),
				quick = _argument("--quick", "") == "yes",
				date = Time.get_date_string_from_system(true),
				seconds = snappedf(Time.get_ticks_msec() * 1e-3, 0.1),  # since the engine started
				command = " ".join(OS.get_cmdline_user_args()),
			}
		)
	)
	var file := FileAccess.open(p_path + ".tmp", FileAccess.WRITE)
	if file == null or not file.store_string(JSON.stringify(record, "\t", false) + "\n"):
		push_error("Bench: cannot write %s (%s)." % [p_path, error_string(FileAccess.get_open_error())])
		return false
	file.close()
	print("%s: %.1f s" % [p_name, record.seconds])
	return DirAccess.rename_absolute(p_path + ".tmp", p_path) == OK


func _argument(p_name: String, p_default: String) -> String:
	var arguments := OS.get_cmdline_user_args()
	var at := arguments.find(p_name)
	return arguments[at + 1] if at >= 0 and at + 1 < arguments.size() else p_default
