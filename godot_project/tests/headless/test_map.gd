# SPDX-License-Identifier: MIT
## GrassMap as a resource: painting, snapshots, and files that are whole, damaged, or being replaced.
extends "res://tests/case.gd"

const FOLDER := "user://maps/"
const FILE := FOLDER + "meadow.grassmap"


func before() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)


func after() -> void:
	remove_folder(FOLDER)


func _brush(tool: GrassBrush.Tool, radius: float, properties := {}) -> GrassBrush:
	var brush := GrassBrush.new()
	brush.tool = tool
	brush.radius = radius
	brush.strength = 1.0
	for property: String in properties:
		brush.set(property, properties[property])
	return brush


func _small_map() -> GrassMap:
	var map := GrassMap.new()
	map.stroke(_brush(GrassBrush.TOOL_PAINT, 8.0), Vector2(-30, -5), Vector2(40, 20))
	map.stroke(_brush(GrassBrush.TOOL_TINT, 5.0, {color = Color.ORANGE}), Vector2.ZERO, Vector2(9, 9))
	map.stroke(_brush(GrassBrush.TOOL_COMB, 5.0), Vector2.ZERO, Vector2(9, 0))
	return map


func _load(path: String) -> GrassMap:
	return ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE) as GrassMap


func _write(path: String, bytes: PackedByteArray) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_buffer(bytes)
	file.close()


func test_strokes_change_the_map_and_say_how_much() -> void:
	var map := GrassMap.new()
	var changes: Array = []
	map.chunks_changed.connect(func(chunks: Array[Vector2i], region: Rect2) -> void: changes.append([chunks, region]))
	var brush := _brush(GrassBrush.TOOL_PAINT, 10.0, {hardness = 1.0})
	assert_near(map.stroke(brush, Vector2(32, 32), Vector2(32, 32)), PI * 100.0, 3.0)
	assert_eq(changes, [[[Vector2i(0, 0)] as Array[Vector2i], Rect2(22, 22, 20, 20)]])
	assert_eq(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(32, 32)), 1.0)
	assert_eq(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(32, 43)), 0.0)
	assert_eq(map.stroke(brush, Vector2(32, 32), Vector2(32, 32)), 0.0, "painted already")
	assert_eq(changes.size(), 1)
	brush.tool = GrassBrush.TOOL_CUT
	brush.cut_height = 0.1
	map.stroke(brush, Vector2(20, 32), Vector2(40, 32))
	assert_near(map.sample(GrassMap.CHANNEL_CUT, Vector2(30, 32)), 0.1, 0.001)


func test_a_snapshot_undoes_and_redoes_a_stroke() -> void:
	var map := _small_map()
	var before_stroke := map.take_snapshot()
	var data := map.get_data()
	map.stroke(_brush(GrassBrush.TOOL_ERASE, 20.0), Vector2(-100, 0), Vector2(100, 0))
	var after_stroke := map.take_snapshot()
	var erased := map.get_data()
	assert_ne(erased, data)
	map.restore_snapshot(before_stroke)
	assert_eq(map.get_data(), data)
	map.restore_snapshot(after_stroke)
	assert_eq(map.get_data(), erased)


func test_a_snapshot_can_take_back_one_of_two_changes() -> void:
	var map := _small_map()
	var before_stroke := map.take_snapshot()
	map.stroke(_brush(GrassBrush.TOOL_ERASE, 2.0), Vector2(0, 6), Vector2(0, 6))
	var after_stroke := map.take_snapshot()
	map.stroke(_brush(GrassBrush.TOOL_ERASE, 2.0), Vector2(20, 13), Vector2(20, 13))
	var both := map.get_data()
	var changes: Array[Rect2] = []
	map.chunks_changed.connect(func(_chunks: Array[Vector2i], region: Rect2) -> void: changes.append(region))
	map.restore_snapshot(before_stroke, after_stroke)
	assert_near(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(0, 6)), 1.0, 0.01)
	assert_near(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(20, 13)), 0.0, 0.01)
	assert_eq(changes.size(), 1)
	map.restore_snapshot(after_stroke, before_stroke)
	assert_eq(map.get_data(), both)
	map.restore_snapshot(after_stroke, before_stroke)
	assert_eq(map.get_data(), both, "done already")
	assert_eq(changes.size(), 2, "nobody is told of nothing")


func test_saved_and_loaded_it_is_the_same_map() -> void:
	var map := _small_map()
	map.base_density = 0.5
	for file: String in ["meadow.grassmap", "meadow.res", "meadow.tres"]:
		assert_eq(ResourceSaver.save(map, FOLDER + file), OK, file)
		var loaded := _load(FOLDER + file)
		if not assert_true(loaded != null, file):
			continue
		assert_eq(loaded.get_data(), map.get_data(), file)
		assert_eq(loaded.base_density, map.base_density, file)
	assert_eq(map.duplicate().get_data(), map.get_data())
	assert_eq(Array(DirAccess.get_files_at(FOLDER)).filter(func(file: String) -> bool: return file.ends_with(".tmp")), [])


func test_the_engine_knows_the_file_as_a_map() -> void:
	ResourceSaver.save(_small_map(), FILE)
	assert_true(ResourceLoader.exists(FILE, "GrassMap"))
	assert_true(ResourceLoader.get_recognized_extensions_for_type("GrassMap").has("grassmap"))
	assert_true(ResourceSaver.get_recognized_extensions(GrassMap.new()).has("grassmap"))
	assert_eq((load(FILE) as GrassMap).resource_path, FILE)


func test_a_square_kilometre_of_painted_meadow_takes_at_most_4_megabytes() -> void:
	var map := GrassMap.new()
	var random := RandomNumberGenerator.new()
	random.seed = 4
	var place := func() -> Vector2: return Vector2(random.randf_range(-500, 500), random.randf_range(-500, 500))
	for z in range(-490, 500, 40):
		map.stroke(_brush(GrassBrush.TOOL_PAINT, 30.0, {target = 0.7}), Vector2(-480, z), Vector2(480, z))
	for n in 300:  # patches and paths of everything
		var from: Vector2 = place.call()
		var to := from + Vector2.from_angle(random.randf() * TAU) * random.randf_range(5, 60)
		var radius := random.randf_range(2, 25)
		for tool: GrassBrush.Tool in [
			GrassBrush.TOOL_DENSITY, GrassBrush.TOOL_HEIGHT, GrassBrush.TOOL_TINT, GrassBrush.TOOL_SPECIES, GrassBrush.TOOL_COMB
		]:
			var brush := _brush(tool, radius, {target = random.randf(), hardness = random.randf(), strength = random.randf_range(0.2, 1)})
			brush.color = Color(random.randf(), random.randf(), random.randf())
			brush.species = random.randi() % 4
			map.stroke(brush, from, to)
		map.stroke(_brush(GrassBrush.TOOL_FLATTEN, 1.0), from, to + Vector2(50, 20))
		map.stroke(_brush(GrassBrush.TOOL_CUT, 2.0), from + Vector2(30, 30), to)
	assert_eq(ResourceSaver.save(map, FILE), OK)
	var size := FileAccess.get_file_as_bytes(FILE).size()
	print("1 km^2 of painted meadow: %d chunks, %d bytes on disk, %d in memory" % [map.get_chunks().size(), size, map.get_memory_usage()])
	assert_greater(map.get_chunks().size(), 240)
	assert_less(size, 4_000_000)
	assert_eq(_load(FILE).get_data(), map.get_data())


func test_a_file_that_is_no_map_is_refused_by_name() -> void:
	_write(FILE, "not a map at all".to_utf8_buffer())
	expect_error("'%s': the file is not a grass map" % FILE)
	expect_error("loading resource")
	assert_true(_load(FILE) == null)


func test_a_file_of_the_future_is_refused_and_left_alone() -> void:
	var bytes := _small_map().get_data()
	bytes.encode_u32(8, 77)
	_write(FILE, bytes)
	expect_error("'%s': the file was saved by a newer version of this addon (format 77" % FILE)
	expect_error("loading resource")
	assert_true(_load(FILE) == null)
	assert_eq(FileAccess.get_file_as_bytes(FILE), bytes)


func test_broken_files_load_nothing_and_say_what_is_wrong() -> void:
	var good := _small_map().get_data()
	var random := RandomNumberGenerator.new()
	random.seed = 12
	expect_error("is damaged")
	expect_error("is cut off")
	expect_error("loading resource")
	for n in 120:
		var bytes := good.duplicate()
		if n % 3 == 0:
			bytes.resize(random.randi_range(0, good.size() - 1))
			if bytes.size() < 12:
				expect_error("is not a grass map")
		else:
			bytes[random.randi_range(12, good.size() - 1)] ^= random.randi_range(1, 255)
		_write(FILE, bytes)
		assert_true(_load(FILE) == null, "case %d" % n)


## With right checksums and broken contents, so that the decompressor and what comes after it meet them.
func test_forged_files_load_whole_or_not_at_all() -> void:
	var good := _small_map().get_data()
	var random := RandomNumberGenerator.new()
	random.seed = 5
	var count := good.decode_u32(16)
	var table_end := 20 + 20 * count
	for part: String in ["is damaged", "loading resource"]:
		expect_error(part)
	var refused := 0
	for n in 60:
		var bytes := good.duplicate()
		bytes[random.randi_range(table_end + 4, bytes.size() - 1)] ^= random.randi_range(1, 255)
		var begin := table_end + 4
		for chunk in count:
			var size := bytes.decode_u32(20 + 20 * chunk + 12)
			bytes.encode_u32(20 + 20 * chunk + 16, _crc(bytes.slice(begin, begin + size)))
			begin += size
		bytes.encode_u32(table_end, _crc(bytes.slice(0, table_end)))
		_write(FILE, bytes)
		var map := _load(FILE)
		refused += int(map == null)
		assert_true(map == null or map.get_chunks().size() == count, "case %d" % n)
	assert_greater(refused, 5)


func _crc(bytes: PackedByteArray) -> int:
	var crc := 0xffffffff
	for byte in bytes:
		crc ^= byte
		for bit in 8:
			crc = (crc >> 1) ^ (0xedb88320 if crc & 1 else 0)
	return crc ^ 0xffffffff


func test_saving_where_nothing_can_be_written_says_so_and_keeps_what_is_there() -> void:
	expect_error("Cannot save the grass map 'user://no/such/folder/meadow.grassmap'")
	assert_ne(ResourceSaver.save(_small_map(), "user://no/such/folder/meadow.grassmap"), OK)
	# A folder in the file's place: the new file is whole, but cannot take it.
	DirAccess.make_dir_absolute(FILE)
	_write(FILE + "/kept", "kept".to_utf8_buffer())
	expect_error("cannot be replaced")
	assert_ne(ResourceSaver.save(_small_map(), FILE), OK)
	assert_eq(FileAccess.get_file_as_string(FILE + "/kept"), "kept")
	assert_false(FileAccess.file_exists(FILE + ".tmp"))
	DirAccess.remove_absolute(FILE + "/kept")
	DirAccess.remove_absolute(FILE)


func test_data_that_cannot_be_read_is_kept_as_it_is() -> void:
	var map := GrassMap.new()
	var data := "GRASSMAP nobody knows".to_utf8_buffer()
	expect_error("GrassMap: `data` was saved by a newer version")
	map.data = data
	assert_eq(map.data, data)
	assert_true(map.is_empty())
	expect_error("its data could not be read, so it cannot be changed")
	assert_eq(map.stroke(_brush(GrassBrush.TOOL_PAINT, 3.0), Vector2.ZERO, Vector2.ZERO), 0.0)
	assert_eq(map.data, data)
	map.clear()
	assert_greater(map.stroke(_brush(GrassBrush.TOOL_PAINT, 3.0), Vector2.ZERO, Vector2.ZERO), 0.0)


func test_bad_values_are_refused_or_clamped() -> void:
	var brush := GrassBrush.new()
	brush.radius = 1e9
	assert_eq(brush.radius, 64.0)
	brush.strength = NAN
	assert_eq(brush.strength, 0.5)
	brush.species = 900
	assert_eq(brush.species, 255)
	expect_error("species cannot be smoothed")
	brush.channel = GrassMap.CHANNEL_SPECIES
	assert_eq(brush.channel, GrassMap.CHANNEL_DENSITY)
	expect_error("`tool` must be one of")
	brush.tool = 99 as GrassBrush.Tool
	var map := GrassMap.new()
	expect_error("a stroke needs a GrassBrush")
	assert_eq(map.stroke(null, Vector2.ZERO, Vector2.ZERO), 0.0)
	expect_error("must be finite numbers")
	assert_eq(map.stroke(brush, Vector2(NAN, 0), Vector2.ZERO), 0.0)
	expect_error("no such channel")
	map.sample(99 as GrassMap.Channel, Vector2.ZERO)
	expect_error("fewer components")
	map.sample(GrassMap.CHANNEL_DENSITY, Vector2.ZERO, 1)
	assert_eq(map.sample(GrassMap.CHANNEL_HEIGHT, Vector2(INF, 0)), 1.0)
	expect_error("needs a snapshot from take_snapshot()")
	map.restore_snapshot(null)


func _stamp(size: Vector2i) -> ImageTexture:
	var image := Image.create_empty(size.x, size.y, false, Image.FORMAT_RGBA8)
	image.fill_rect(Rect2i(size.x / 2, 0, size.x / 2, size.y), Color.WHITE)  # the rest is transparent
	return ImageTexture.create_from_image(image)


func test_a_stamp_leaves_what_it_shows_where_the_stroke_ends() -> void:
	var map := GrassMap.new()
	var brush := _brush(GrassBrush.TOOL_PAINT, 4.0, {strength = 1.0, stamp = _stamp(Vector2i(64, 64))})
	map.stroke(brush, Vector2(-20, 0), Vector2.ZERO)
	assert_near(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(2, 3)), 1.0, 0.01)
	assert_near(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(-2, 3)), 0.0, 0.01, "transparent")
	assert_near(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(-20, 0)), 0.0, 0.01, "where the stroke began")
	brush.stamp_rotation = 90.0
	map.stroke(brush, Vector2(50, 0), Vector2(50, 0))
	assert_near(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(48, 2)), 1.0, 0.01, "from x towards z")
	assert_near(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(52, -2)), 0.0, 0.01)
	brush.stamp = _stamp(Vector2i(2048, 16))
	brush.stamp_rotation = 0.0
	map.stroke(brush, Vector2(100, 0), Vector2(100, 0))
	assert_near(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(102, 3)), 1.0, 0.01, "a picture that is too large is made smaller")


func test_stamps_turn_at_random_and_the_same_strokes_leave_the_same() -> void:
	var brush := _brush(GrassBrush.TOOL_PAINT, 4.0, {strength = 1.0, stamp = _stamp(Vector2i(32, 32)), stamp_random = 360.0})
	var maps: Array[GrassMap] = [GrassMap.new(), GrassMap.new()]
	var directions := {}
	for i in 8:
		var place := Vector2(20.0 * i, 0.0)
		var sides: Array[bool] = []
		for map in maps:
			map.stroke(brush, place, place)
			for side: Vector2 in [Vector2(2, 0), Vector2(0, 2), Vector2(-2, 0), Vector2(0, -2)]:
				sides.append(map.sample(GrassMap.CHANNEL_DENSITY, place + side) > 0.5)
		assert_eq(sides.slice(0, 4), sides.slice(4))
		directions[sides] = true
	assert_greater(directions.size(), 2)
