# SPDX-License-Identifier: MIT
## The debugger's monitors of all fields together. get_statistics() and get_counters() have the keys that the class reference names.
extends "res://tests/field_case.gd"

const MONITORS: Array[String] = [
	"awake_tiles", "simulated_blades", "drawn_blades", "drawn_triangles", "management", "simulate", "cull", "memory"
]
const CLASS_REFERENCE := "res://../extension/doc_classes/GrassField.xml"


func monitor(what: String) -> float:
	return Performance.get_custom_monitor("grass_field/" + what)


func has_monitors() -> int:
	var count := 0
	for what in MONITORS:
		count += int(Performance.has_custom_monitor("grass_field/" + what))
	return count


## Returns the words that the class reference sets as code in the description of a method: keys, for the most part.
func documented(method: String) -> Array[String]:
	var text := FileAccess.get_file_as_string(ProjectSettings.globalize_path(CLASS_REFERENCE))
	var description := text.get_slice('<method name="%s"' % method, 1).get_slice("</method>", 0)
	var words: Array[String] = []
	for found in RegEx.create_from_string("\\[code\\]([a-z_]+)\\[/code\\]").search_all(description):
		words.append(found.get_string(1))
	return words


func test_the_class_reference_has_each_key() -> void:
	var field := add_field()
	await ticks(2)
	var keys := {get_statistics = field.get_statistics(), get_counters = field.get_counters()}
	for method: String in keys:
		var words := documented(method)
		assert_greater(words.size(), 10, "words about " + method)
		for key: String in keys[method]:
			assert_true(key in words, "%s: the class reference lacks %s" % [method, key])
		for word in words:
			var is_key: bool = keys.get_statistics.has(word) or keys.get_counters.has(word)
			assert_true(is_key or word == "true", "the class reference of %s has %s, which is no key" % [method, word])


func test_monitors_come_and_go_with_the_fields() -> void:
	assert_eq(has_monitors(), 0)
	var first := add_field()
	assert_eq(has_monitors(), MONITORS.size())
	var second := add_field()
	first.free()
	assert_eq(has_monitors(), MONITORS.size(), "one is left")
	remove_child(second)
	assert_eq(has_monitors(), 0, "out of the tree")
	add_child(second)
	assert_eq(has_monitors(), MONITORS.size())
	second.free()
	assert_eq(has_monitors(), 0)


func test_a_scripts_own_monitor_stays() -> void:
	Performance.add_custom_monitor("grass_field/memory", func() -> float: return 42.0)
	var field := add_field()
	assert_eq(has_monitors(), MONITORS.size())
	assert_eq(monitor("memory"), 42.0)
	field.free()
	assert_eq(has_monitors(), 1, "the script's own")
	assert_eq(monitor("memory"), 42.0)
	Performance.remove_custom_monitor("grass_field/memory")


func test_monitors_add_up_the_fields() -> void:
	var fields: Array[GrassField] = [add_field(), add_field({position = Vector3(100, 0, 0)})]
	await ticks(2)
	for what in MONITORS:
		assert_true(is_finite(monitor(what)), what)
	assert_eq(monitor("awake_tiles"), 0.0)
	monitor("simulate")  # from now on it is measured
	add_held_body(ball(0.2), Vector3(0.25, 0.25, 0.25))
	add_held_body(ball(0.4), Vector3(100.25, 0.25, 0.25))
	await ticks(5)
	var sums := {awake_tiles = 0.0, memory = 0.0, management_ms = 0.0, simulate_ms = 0.0}
	for field in fields:
		assert_greater(field.get_awake_tile_count(), 0)
		for key: String in sums:
			sums[key] += field.get_statistics()[key]
	assert_eq(monitor("awake_tiles"), sums.awake_tiles)
	assert_eq(monitor("simulated_blades"), BLADES * sums.awake_tiles)
	assert_near(monitor("memory"), sums.memory, 1e5, "bytes")
	assert_near(monitor("management"), 1e-3 * sums.management_ms, 1e-9, "seconds")
	assert_near(monitor("simulate"), 1e-3 * sums.simulate_ms, 1e-9, "seconds")
	assert_greater(sums.simulate_ms, 0.0)


func test_memory_counts_what_grows() -> void:
	var field := add_field()
	await ticks(2)
	var at_rest := field.get_memory_usage()
	assert_greater(at_rest, 16384 * 16 * 8, "at least the patch")
	var body := add_held_body(ball(0.5), Vector3(0, 0.25, 0))
	await ticks(5)
	var a_tile := 4 * 64 * (3 * 16 + 2 * 3 * 14 + 14 + 3)  # bytes of a tile's state on the CPU
	assert_true(field.get_memory_usage() - at_rest >= field.get_awake_tile_count() * a_tile, "the awake tiles' state")
	body.free()
