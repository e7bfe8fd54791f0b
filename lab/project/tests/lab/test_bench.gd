# SPDX-License-Identifier: MIT
## The benchmarks' scripts load, and those that need no GPU measure something: on the CPU, in the small sizes for software rendering.
extends "res://tests/case.gd"

const Table := preload("res://bench/table.gd")


func test_scripts_load() -> void:
	var scripts := Array(DirAccess.get_files_at("res://bench")).filter(func(file: String) -> bool: return file.get_extension() == "gd")
	assert_greater(scripts.size(), 10)
	for file: String in scripts:
		var script := load("res://bench".path_join(file)) as GDScript
		assert_true(script != null and script.can_instantiate(), file)


func test_awake_blades() -> void:
	var rows := await _rows(preload("res://bench/paper_awake.gd"))
	assert_eq(rows.size(), 4)
	for row in rows:
		assert_eq(row.outcome, "ok")
	assert_eq(rows[0].awake_blades, str(64 * 64), "the lid wakes as many tiles as were asked for")
	assert_eq(rows[2].awake_blades, rows[3].awake_blades, "as many are awake in a large field as in a small one")


func test_tiles_of_256() -> void:
	var rows := await _rows(preload("res://bench/paper_tiles.gd"))
	assert_eq(rows.size(), 2)
	for row in rows:
		assert_eq(row.outcome, "ok")
	assert_eq(rows[0].blades, rows[1].blades, "the same density")
	assert_less(rows[0].awake_blades.to_int(), rows[1].awake_blades.to_int(), "larger tiles keep more awake")


## Returns what a part of `./grass bench` writes, by column.
func _rows(p_part: GDScript) -> Array[Dictionary]:
	var path := "user://bench_test.csv"
	var part: Node = p_part.new()
	add_child(part)
	await part.run(Table.new(path), true)
	part.queue_free()
	var file := FileAccess.open(path, FileAccess.READ)
	file.get_line()
	var columns := file.get_csv_line()
	var rows: Array[Dictionary] = []
	while file.get_position() < file.get_length():
		var values := file.get_csv_line()
		var row := {}
		for i in columns.size():
			row[columns[i]] = values[i]
		rows.append(row)
	return rows
