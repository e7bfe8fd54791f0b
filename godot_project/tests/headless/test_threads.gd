# SPDX-License-Identifier: MIT
## Another thread calls a field and its resources while the main thread runs ticks and frames.
extends "res://tests/fuzz_case.gd"


## Runs `work` on a thread while frames go on.
func on_a_thread(work: Callable) -> Variant:
	var thread := Thread.new()
	thread.start(work)
	while thread.is_alive():
		await frames(1)
	return thread.wait_to_finish()


func test_calls_from_another_thread_are_refused() -> void:
	expect_error("GrassField 'Meadow': cut() belongs to the main thread")
	expect_error("GrassField 'Meadow': set_map() belongs to the main thread")
	expect_error("GrassField 'Meadow': set_param() belongs to the main thread")
	expect_error("GrassField 'Meadow': get_statistics() belongs to the main thread")
	expect_error("GrassField 'Meadow': get_counters() belongs to the main thread")
	var field := add_field({map = full_map()})
	var map := field.map
	await ticks(2)
	await on_a_thread(
		func() -> void:
			field.cut(ball(0.5), Transform3D())
			field.map = null
			field.friction = 0.7
			field.get_statistics()
			field.get_counters()
	)
	assert_eq(field.map, map)
	assert_near(field.friction, 1.0, 1e-6)
	assert_eq(field.get_density_at(Vector3.ZERO), 1.0)
	assert_near(field.get_mown_share(ball(0.5), Transform3D()), 0.0, 1e-6)


func test_resources_that_a_field_uses_are_refused_too() -> void:
	for text: String in [
		"GrassMap: a change", "GrassMap: clear()", "GrassPatch: set_seed()", "GrassSpecies: set_param()", "GrassFillRule: set_seed()"
	]:
		expect_error(text + " belongs to the main thread")
	var species := GrassSpecies.new()
	species.patch = GrassPatch.new()
	var used: Array[GrassSpecies] = [species]
	var field := add_field({map = full_map(), species = used, fill_rule = GrassFillRule.new()})
	await ticks(2)
	await on_a_thread(
		func() -> void:
			field.map.stroke(brush(GrassBrush.TOOL_ERASE, 1.0), Vector2.ZERO, Vector2.ZERO)
			field.map.clear()
			species.patch.seed = 3
			species.natural_frequency = 3.0
			field.fill_rule.seed = 4
	)
	assert_eq(field.get_density_at(Vector3.ZERO), 1.0)
	assert_eq([species.patch.seed, field.fill_rule.seed], [GrassPatch.new().seed, GrassFillRule.new().seed])


func test_a_field_is_prepared_on_a_thread() -> void:
	var field: GrassField = await on_a_thread(
		func() -> GrassField:
			var made := GrassField.new()
			made.size = Vector2(4, 4)
			made.wind_speed = 0.0
			made.species = [GrassSpecies.new()]
			made.species[0].patch = GrassPatch.new()
			made.species[0].patch.length_max = 0.6
			made.map = full_map()
			made.map.stroke(brush(GrassBrush.TOOL_ERASE, 0.5), Vector2.ONE, Vector2.ONE)
			return made
	)
	add_child(field)
	await seen()
	assert_eq(field.get_density_at(Vector3(1, 0, 1)), 0.0)
	assert_greater(await bend_with_ball(field, Vector3(-1, 0.25, -1)), 0.02)


func test_a_storm_of_calls_does_no_harm() -> void:
	expect_error("belongs to the main thread")
	var field := add_field({map = full_map(), fill_rule = GrassFillRule.new()})
	add_held_body(ball(0.3), Vector3(0, 0.2, 0))
	await ticks(2)
	await on_a_thread(
		func() -> void:
			for i in 300:
				field.cut(ball(0.5), Transform3D())
				field.trample(Vector3.ZERO, 0.5, 0.5)
				field.regrow(0.1)
				field.map = null if i % 2 else GrassMap.new()
				field.get_knots(Vector2i.ZERO, 0)
				field.get_bend_at(Vector3.ZERO)
	)
	await seen()
	assert_greater(field.get_awake_tile_count(), 0)
	assert_true(all_finite(field, [field.get_tile_at(Vector3.ZERO)]))


## Its ticks run on the main thread all the same.
func test_a_thread_group_of_its_own_makes_no_difference() -> void:
	var field := add_field({process_thread_group = Node.PROCESS_THREAD_GROUP_SUB_THREAD})
	add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	await ticks(5)
	assert_greater(field.get_awake_tile_count(), 0)


## The map is one of two at any time, so whatever a thread reads is one of them as a whole.
func test_a_map_is_read_and_saved_while_it_changes() -> void:
	var field := add_field({map = full_map()})
	var map := field.map
	var eraser := brush(GrassBrush.TOOL_ERASE, 3.0)
	var known := [map.get_data()]
	map.stroke(eraser, Vector2(-320, 0), Vector2(320, 0))
	known.append(map.get_data())
	var counts := [0, map.get_chunks().size()]
	assert_greater(counts[1], 10)
	var odd: Array[String] = []
	var readings := [0]
	var stop := [false]
	var path := "user://autosave.grassmap"
	var read := func() -> void:
		while not stop[0]:
			readings[0] += 1
			for i in 20:
				var copy := GrassMap.new()
				copy.restore_snapshot(map.take_snapshot())
				if copy.get_chunks().size() not in counts or map.get_chunks().size() not in counts:
					odd.append("chunks")
				if map.sample(GrassMap.CHANNEL_DENSITY, Vector2.ZERO) not in [0.0, 1.0]:
					odd.append("sample")
				if map.get_memory_usage() < 0 or map.base_density != 1.0:
					odd.append("memory")
			if map.get_data() not in known:
				odd.append("data")
			if ResourceSaver.save(map, path) != OK:
				odd.append("save")
	var thread := Thread.new()
	thread.start(read)
	var changes := 0
	while changes < 200 or readings[0] < 10:
		map.clear()
		map.stroke(eraser, Vector2(-320, 0), Vector2(320, 0))
		changes += 1
		if changes % 10 == 0:
			await frames(1)
	stop[0] = true
	thread.wait_to_finish()
	assert_eq(odd, [] as Array[String])
	var saved: GrassMap = load(path)
	assert_true(saved.get_data() in known, "what was saved meanwhile is whole")
	DirAccess.remove_absolute(path)


func test_a_map_is_read_while_it_is_painted() -> void:
	var field := add_field({map = full_map(), size = Vector2(32, 32)})
	var map := field.map
	var thread := Thread.new()
	var stop := [false]
	var found: Array[int] = [0, 0]  # readings, odd ones
	thread.start(
		func() -> void:
			while not stop[0]:
				var copy := GrassMap.new()
				copy.data = map.data
				found[0] += 1
				found[1] += int(copy.base_density != 1.0)
				copy.restore_snapshot(map.take_snapshot())
	)
	var strokes := 0
	while strokes < 200 or found[0] < 20:
		strokes += 1
		field.trample(Vector3(fmod(strokes * 7.3, 30.0) - 15.0, 0, fmod(strokes * 3.1, 30.0) - 15.0), 2.0, 0.2)
		if strokes % 4 == 0:
			await frames(1)
	stop[0] = true
	thread.wait_to_finish()
	assert_eq(found[1], 0)


## Painted by two threads while nothing uses it, and put into a field while they still paint.
func test_a_map_is_painted_by_threads() -> void:
	expect_error("GrassMap: a change belongs to the main thread")
	var map := full_map()
	var threads: Array[Thread] = []
	var dab := brush(GrassBrush.TOOL_ERASE, 1.0)
	var stop := [false]
	var strokes: Array[int] = [0, 0]
	for i in 2:
		threads.append(Thread.new())
		threads[i].start(
			func() -> void:
				while not stop[0]:
					strokes[i] += 1
					map.stroke(dab, Vector2(strokes[i] % 40, 20 * i), Vector2(strokes[i] % 40, 20 * i))
		)
	var field := add_field({size = Vector2(8, 8)})
	await wait_until(func() -> bool: return strokes.min() > 50, "both threads have painted")
	field.map = map
	var then := strokes.duplicate()
	await wait_until(func() -> bool: return strokes[0] > then[0] + 3 and strokes[1] > then[1] + 3, "both threads have tried again")
	stop[0] = true
	for thread in threads:
		thread.wait_to_finish()
	map.stroke(dab, Vector2.ZERO, Vector2.ZERO)
	assert_eq(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(0.1, 0.1)), 0.0)


## Every property of every class, read on a thread while the main thread sets it.
func test_every_property_is_read_on_a_thread() -> void:
	var species := GrassSpecies.new()
	species.patch = own_patch()
	var field := add_field({map = full_map(), species = [species] as Array[GrassSpecies], fill_rule = GrassFillRule.new()})
	var objects: Array[Object] = [field, species, species.patch, field.fill_rule, field.map, GrassBrush.new()]
	for node: Node3D in [GrassForce3D.new(), GrassExclusion3D.new(), GrassPath3D.new(), GrassBoneColliders3D.new(), GrassWorld.new()]:
		add_child(node)
		objects.append(node)
	var names: Array = objects.map(
		func(object: Object) -> Array:
			return ClassDB.class_get_property_list(object.get_class(), true).map(func(property: Dictionary) -> String: return property.name)
	)
	await ticks(2)
	var thread := Thread.new()
	thread.start(
		func() -> void:
			for i in 40:
				for k: int in objects.size():
					for name_: String in names[k]:
						objects[k].get(name_)
	)
	while thread.is_alive():
		for object in objects:
			for property in stored(object):
				if object is GrassWorld or property.name.begins_with("resource_"):
					continue
				var value: Variant = other_value(property)
				if value != null:
					object.set(property.name, value)
		await frames(1)
	thread.wait_to_finish()
	assert_true(is_finite(field.get_density_at(Vector3.ZERO)))


## One that shares memory: numbers cannot be torn.
func other_value(property: Dictionary) -> Variant:
	match property.type:
		TYPE_STRING_NAME, TYPE_STRING:
			return "group %d" % rng.randi()
		TYPE_NODE_PATH:
			return NodePath("../Nobody%d" % rng.randi())
		TYPE_PACKED_STRING_ARRAY:
			return PackedStringArray(["bone %d" % rng.randi()])
		TYPE_PACKED_VECTOR2_ARRAY:
			return PackedVector2Array([Vector2.ZERO, Vector2.ONE * rng.randf(), Vector2.RIGHT])
		TYPE_PACKED_INT32_ARRAY:
			return PackedInt32Array([rng.randi_range(0, 255)])
		TYPE_OBJECT:
			match property.hint_string:
				"Texture2D":
					return GradientTexture2D.new()
				"Gradient":
					return Gradient.new()
				"Shape3D":
					return BoxShape3D.new()
				"GrassMap":
					return full_map()
				"ShaderInclude":
					return ShaderInclude.new()
				"GrassPatch", "GrassFillRule":
					return resource_for(property.hint_string)
	return null
