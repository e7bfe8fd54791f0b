# SPDX-License-Identifier: MIT
## A game records what happens to a field in a file; another field plays it, and the tool names the first tick with other grass.
extends "res://tests/field_case.gd"

const TOOL := "res://addons/grass_field/tools/play_record.gd"
const TICKS := 90
const PAINTED_IN := 40  # a tick in which a game changes the map

var path := "user://grass_%d.grassrecord" % OS.get_process_id()


func after() -> void:
	DirAccess.remove_absolute(path)


## Bodies that move, come and rest, a gust, a blade that was cut: all that reaches a field.
func record_scene(properties := {}) -> Dictionary:
	var tall := GrassSpecies.new()
	tall.natural_frequency = 0.8
	tall.patch = GrassPatch.new()
	tall.patch.seed = 5
	var field := add_field(
		{size = Vector2(12, 8), density = 200.0, seed = 3, species = [tall, GrassSpecies.new()], map = full_map()}.merged(properties)
	)
	field.rotate_y(0.5)
	var roller := add_held_body(ball(0.3), Vector3(-3, 0.2, 0))
	add_held_body(ball(0.25), Vector3(2, 0.1, 1))
	await ticks(20)  # grass that is bent before the record begins
	assert_eq(field.record(path), OK)
	for tick in TICKS:
		roller.position.x = -3.0 + tick / 20.0
		if tick == 10:
			field.push(Vector3(0, 0.3, -2), Vector3(12, 0, 0), 2.0, 0.5)
		if tick == PAINTED_IN:
			field.cut(ball(0.5), Transform3D(Basis(), Vector3(1, 0.2, 0)))
		if tick == 70:
			field.friction = 0.5
		await ticks(1)
	field.stop_record()
	var state := field.get_record_state()
	roller.free()
	field.free()
	return state


## Plays the file in a new field. `meddle` gets the field and the number of ticks that were played, in each tick.
func play(meddle := func(_field: GrassField, _tick: int) -> void: pass) -> Dictionary:
	var field := add_field({size = Vector2(2, 2)})
	await ticks(2)
	assert_eq(field.play_record(path), OK)
	while field.get_record_state().mode == "playing":
		meddle.call(field, field.get_record_state().ticks)
		await ticks(1)
	var state := field.get_record_state()
	field.free()
	return state


func test_a_record_plays_as_it_was() -> void:
	for method: GrassField.SolverMethod in [GrassField.METHOD_DIRECT, GrassField.METHOD_PBD]:
		var recorded := await record_scene({method = method})
		assert_eq(recorded.message, "was stopped")
		assert_greater(recorded.ticks, TICKS - 10)
		var played := await play()
		assert_eq(played.ticks, recorded.ticks)
		assert_eq(played.compared, recorded.ticks)
		assert_eq(played.differs_at, -1)
		assert_true(played.complete)
		assert_eq(played.version, GrassField.get_version())


func checksum(bytes: PackedByteArray) -> int:
	var sum := 0xffffffff
	for byte in bytes:
		sum ^= byte
		for bit in 8:
			sum = sum >> 1 ^ (0xedb88320 if sum & 1 else 0)
	return sum ^ 0xffffffff


## The second part of the file, its first ticks, with the first number `from` in it replaced by `to`.
func replace_number(from: float, to: float) -> void:
	const HEAD := 16  # kind, size, packed size, checksum
	var file := FileAccess.get_file_as_bytes(path)
	var at := 12 + HEAD + file.decode_u32(12 + 8)
	var end := at + HEAD + file.decode_u32(at + 8)
	var ticks_of_part := file.slice(at + HEAD, end).decompress(file.decode_u32(at + 4), FileAccess.COMPRESSION_ZSTD)
	var found := 0
	while ticks_of_part.decode_double(found) != from:
		found += 1
	ticks_of_part.encode_double(found, to)
	var packed := ticks_of_part.compress(FileAccess.COMPRESSION_ZSTD)
	file.encode_u32(at + 8, packed.size())
	file.encode_u32(at + 12, checksum(packed))
	FileAccess.open(path, FileAccess.WRITE).store_buffer(file.slice(0, at + HEAD) + packed + file.slice(end))


func test_a_body_that_was_elsewhere_is_found_in_its_tick() -> void:
	var field := add_field({size = Vector2(8, 8)})
	assert_eq(field.record(path), OK)
	var body := add_held_body(ball(0.3), Vector3(-2, 0.2, 0))
	while field.get_record_state().ticks < 50:
		body.position.x = -2.0 + field.get_record_state().ticks / 16.0
		await ticks(1)
	field.free()
	body.free()
	assert_eq((await play()).differs_at, -1)
	replace_number(-2.0 + 30 / 16.0, -2.0 + 30 / 16.0 + 0.001)
	var played := await play()
	assert_true(played.complete)
	assert_eq(played.differs_at, 30)


func test_the_first_tick_that_differs_is_named() -> void:
	await record_scene()
	var played := await play(
		func(field: GrassField, tick: int) -> void:
			if tick == 20:
				field.cut(ball(1.0), Transform3D(Basis(), Vector3(-2, 0.2, 0)))
	)
	assert_eq(played.differs_at, 20)


func test_a_field_that_is_made_again_goes_on_in_the_record() -> void:
	var field := add_field()
	add_held_body(ball(0.3), Vector3(0, 0.2, 0))
	assert_eq(field.record(path), OK)
	await ticks(10)
	field.density = 400.0
	await ticks(20)
	field.free()  # ends it
	var played := await play()
	assert_greater(played.ticks, 15)
	assert_eq(played.compared, played.ticks)
	assert_eq(played.differs_at, -1)
	assert_true(played.complete)


func test_a_file_that_was_cut_off_plays_to_there() -> void:
	var recorded := await record_scene()
	var bytes := FileAccess.get_file_as_bytes(path)
	FileAccess.open(path, FileAccess.WRITE).store_buffer(bytes.slice(0, bytes.size() - 60))
	var played := await play()
	assert_eq(played.ticks, 60)  # a part
	assert_less(played.ticks, recorded.ticks)
	assert_eq(played.differs_at, -1)
	assert_false(played.complete)
	assert_true(played.message.begins_with("was cut off within part"))


func test_broken_files_say_what_is_wrong() -> void:
	await record_scene()
	var bytes := FileAccess.get_file_as_bytes(path)
	bytes[bytes.size() - 70] ^= 1
	FileAccess.open(path, FileAccess.WRITE).store_buffer(bytes)
	expect_error("the file is damaged in part 3")
	assert_eq((await play()).ticks, 60)
	FileAccess.open(path, FileAccess.WRITE).store_string("no record of anything")
	var field := add_field()
	expect_error("cannot play '%s': the file is no record of grass" % path)
	assert_eq(field.play_record(path), ERR_FILE_UNRECOGNIZED)
	after()
	expect_error("cannot open the record")
	assert_ne(field.play_record(path), OK)
	expect_error("cannot record into")
	assert_ne(field.record("res://no/such/folder/x.grassrecord"), OK)
	field.simulated = false
	expect_error("with `simulated` on")
	assert_eq(field.record(path), ERR_UNCONFIGURED)


func test_a_record_ends_at_its_limit() -> void:
	const SETTING := "grass_field/limits/record_megabytes"
	ProjectSettings.set_setting(SETTING, 1)
	var field := add_field({size = Vector2(1, 1), pool_tiles = 1})  # little to simulate
	var shape := ball(0.02)
	var bodies: Array[Node3D] = []
	for i in 200:
		bodies.append(Node3D.new())
		add_child(bodies[-1])
		field.register_collider(bodies[-1], shape)
	assert_eq(field.record(path), OK)
	var random := RandomNumberGenerator.new()
	while field.get_record_state().mode == "recording" and field.get_record_state().ticks < 600:
		for body in bodies:
			body.position = Vector3(random.randf() - 0.5, 0.5, random.randf() - 0.5)
			body.rotation = Vector3(random.randf(), random.randf(), random.randf())
		await ticks(1)
	var recorded := field.get_record_state()
	assert_true(recorded.message.begins_with("reached its limit of 1 MB (the project setting"), recorded.message)
	assert_less(FileAccess.get_file_as_bytes(path).size(), 1048576)
	field.free()
	var played := await play()
	assert_true(played.complete)
	assert_greater(played.ticks, 0)
	assert_less(played.ticks, recorded.ticks + 1)
	assert_eq(played.differs_at, -1)
	ProjectSettings.set_setting(SETTING, 64)


func test_the_tool_plays_a_file() -> void:
	await record_scene()
	var arguments := ["--headless", "--fixed-fps", "60", "--path", ProjectSettings.globalize_path("res://"), "--script", TOOL, "--"]
	arguments.append(ProjectSettings.globalize_path(path))
	var output := []
	assert_eq(OS.execute(OS.get_executable_path(), arguments, output, true), 0, str(output))
	assert_true("The grass is the same in " in output[0], str(output))
