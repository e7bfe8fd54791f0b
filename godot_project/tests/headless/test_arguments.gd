# SPDX-License-Identifier: MIT
## Every method of every class gets arguments that make no sense: NaN, far too large, negative, null. NaN is refused with a message that
## names the class. No call hangs, and none changes anything beyond the field.
extends "res://tests/world_case.gd"

const FAR := 1e30
## By type: what stands in the place of a good argument.
const BAD := {
	TYPE_INT: [-1, 9223372036854775807, -9223372036854775807 - 1],
	TYPE_FLOAT: [NAN, INF, -INF, FAR, -FAR, -1.0, 0.0, 500.0],
	TYPE_VECTOR2: [Vector2(NAN, 0), Vector2(INF, INF), Vector2(FAR, -FAR), Vector2(1e6, 1e6)],
	TYPE_VECTOR2I: [Vector2i(-1, -1), Vector2i(2147483647, -2147483648)],
	TYPE_VECTOR3: [Vector3(NAN, 0, 0), Vector3(INF, 0, -INF), Vector3(FAR, FAR, FAR), Vector3(1e6, 0, -1e6)],
	TYPE_RECT2: [Rect2(NAN, 0, 1, 1), Rect2(-INF, -INF, INF, INF), Rect2(-1e6, -1e6, 2e6, 2e6), Rect2(5, 5, -3, -3), Rect2(0, 0, 0, 0)],
	TYPE_AABB: [AABB(Vector3(NAN, 0, 0), Vector3.ONE), AABB(Vector3(-FAR, 0, 0), Vector3(FAR, FAR, FAR)), AABB()],
	TYPE_TRANSFORM3D:
	[
		Transform3D(Basis(), Vector3(NAN, 0, 0)),
		Transform3D(Basis(), Vector3(FAR, 0, 0)),
		Transform3D(Basis(Vector3(FAR, 0, 0), Vector3(0, FAR, 0), Vector3(0, 0, FAR)), Vector3.ZERO),
		Transform3D(Basis(Vector3.ZERO, Vector3.ZERO, Vector3.ZERO), Vector3.ZERO),
	],
	TYPE_OBJECT: [null],
	TYPE_STRING_NAME: [&"", &"nobody"],
	TYPE_PACKED_BYTE_ARRAY: [[], [1, 2, 3]],
	TYPE_PACKED_INT64_ARRAY: [[], [-1], [9223372036854775807]],
}
const WITH_NAN := [TYPE_FLOAT, TYPE_VECTOR2, TYPE_VECTOR3, TYPE_RECT2, TYPE_AABB, TYPE_TRANSFORM3D]  # their first bad value has one
## Methods that ask what is at a place: there is nothing at one that is not a number, as beside the field, and nobody needs to hear of it.
const ANSWER_ANYWHERE := [
	"get_tile_at",
	"is_grass_at",
	"get_density_at",
	"get_height_at",
	"get_bend_at",
	"density_at",
	"height_at",
	"bend_at",
	"explain",
	"sample",
	"get_field_at",
]


## Arguments that a method takes as they are.
func good(argument: Dictionary, place: int) -> Variant:
	match argument.type:
		TYPE_INT:
			return 0
		TYPE_FLOAT:
			return 0.5
		TYPE_VECTOR2:
			return Vector2(place, 0)
		TYPE_VECTOR3:
			return Vector3(0.1 * place, 0, 0)
		TYPE_RECT2:
			return Rect2(-1, -1, 2, 2)
		TYPE_OBJECT:
			return good_object(argument.class_name)
		TYPE_PACKED_INT64_ARRAY:
			return PackedInt64Array([0])
		TYPE_STRING_NAME:
			return &"nobody"
	return type_convert(null, argument.type)


func good_object(type: StringName) -> Object:
	match type:
		&"GrassBrush":
			return brush(GrassBrush.TOOL_ERASE, 1.0)
		&"GrassFillRule":
			return GrassFillRule.new()
		&"GrassMapSnapshot":
			return full_map().take_snapshot()
		&"Shape3D":
			return ball(0.5)
		&"Image":
			return Image.create_empty(4, 4, false, Image.FORMAT_RF)
		&"Node3D":
			return self
	return null


## Returns the class's own methods that are no setters: those have their property's range (test_properties.gd).
func methods_of(type: StringName) -> Array[Dictionary]:
	return ClassDB.class_get_method_list(type, true).filter(
		func(method: Dictionary) -> bool:
			var named: String = method.name
			return not (
				named.begins_with("_")
				or named.begins_with("set_") and named not in ["set_ground", "set_hook_parameter"]
				or method.args.is_empty()
			)
	)


## Hears the errors and warnings that are reported.
class Hearer:
	extends Logger
	var heard := ""

	func _log_error(
		_function: String, _file: String, _line: int, code: String, why: String, _notify: bool, _type: int, _traces: Array[ScriptBacktrace]
	) -> void:
		heard += why if why else code


## Calls every method of `object` with one argument that is not a number after the other.
func refuses_nan(object: Object) -> int:
	var calls := 0
	var hearer := Hearer.new()
	OS.add_logger(hearer)
	for method in methods_of(object.get_class()):
		for bad_place: int in method.args.size():
			if not method.args[bad_place].type in WITH_NAN or method.name in ANSWER_ANYWHERE:
				continue
			var arguments := []
			for place: int in method.args.size():
				arguments.append(BAD[method.args[place].type][0] if place == bad_place else good(method.args[place], place))
			hearer.heard = ""
			object.callv(method.name, arguments)
			calls += 1
			var words := "%s of %s.%s() is not a number: %s" % [method.args[bad_place].name, object.get_class(), method.name, hearer.heard]
			assert_true(hearer.heard.contains(object.get_class()), words)
	OS.remove_logger(hearer)
	return calls


## Calls every method of `object` with one bad argument after the other; `check` after each call.
func try_methods(object: Object, check: Callable) -> int:
	var calls := 0
	for method in methods_of(object.get_class()):
		for bad_place: int in method.args.size():
			for bad: Variant in BAD.get(method.args[bad_place].type, []):
				var arguments := []
				for place: int in method.args.size():
					arguments.append(bad if place == bad_place else good(method.args[place], place))
				object.callv(method.name, arguments)
				calls += 1
				check.call("%s(%s)" % [method.name, arguments])
	return calls


func chunks_beyond(map: GrassMap, reach: int) -> Array[Vector2i]:
	return map.get_chunks().filter(
		func(chunk: Vector2i) -> bool: return chunk.x < -reach or chunk.y < -reach or chunk.x >= reach or chunk.y >= reach
	)


func test_a_field_takes_any_arguments() -> void:
	expect_error("GrassField 'Meadow'")
	var field := add_field({map = full_map()})
	add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	await seen()
	var calls := try_methods(
		field,
		func(words: String) -> void:
			assert_eq(chunks_beyond(field.map, 2), [] as Array[Vector2i], words)
			field.map.base_density = 1.0
	)
	assert_greater(calls, 100)
	field.map.clear()
	await seen()
	assert_true(all_finite(field, [field.get_tile_at(Vector3.ZERO)]))


func test_nan_is_refused_aloud() -> void:
	for part: String in ["GrassField 'Meadow'", "GrassMap", "GrassWorld '"]:
		expect_error(part)
	var field := add_field({map = full_map()})
	await seen()
	assert_greater(refuses_nan(field), 20, "arguments of a field's methods")
	assert_greater(refuses_nan(full_map()), 4, "of a map's")
	assert_greater(refuses_nan(add_world({})), 3, "of a world's")
	for object: Object in [GrassPatch.new(), GrassSpecies.new(), GrassFillRule.new(), GrassBrush.new(), GrassQuality.new()]:
		refuses_nan(object)
	for node: Node3D in [GrassForce3D.new(), GrassExclusion3D.new(), GrassPath3D.new(), GrassBoneColliders3D.new()]:
		add_child(node)
		refuses_nan(node)


func test_a_map_takes_any_arguments() -> void:
	expect_error("GrassMap 'Lawn'")
	var map := full_map()
	map.resource_name = "Lawn"
	var calls := try_methods(map, func(_words: String) -> void: assert_true(is_finite(map.sample(GrassMap.CHANNEL_DENSITY, Vector2.ZERO))))
	assert_greater(calls, 20)
	assert_less(map.get_chunks().size(), 20)


func test_a_world_takes_any_arguments() -> void:
	expect_error("GrassWorld '")
	expect_error("GrassField '")
	var world := add_world({radius = 100.0})
	await go(world, Vector3(64, 0, 64))
	try_methods(world, func(_words: String) -> void: world.global_position = Vector3.ZERO)
	await loaded(world)
	assert_greater(world.get_statistics().plots, 0)


func test_other_classes_take_any_arguments() -> void:
	for object: Object in [GrassPatch.new(), GrassSpecies.new(), GrassFillRule.new(), GrassBrush.new()]:
		if object is GrassPatch:
			expect_error("GrassPatch: no such parameter")
		try_methods(object, func(_words: String) -> void: pass)
	for node: Node3D in [GrassForce3D.new(), GrassExclusion3D.new(), GrassPath3D.new(), GrassBoneColliders3D.new()]:
		add_child(node)
		try_methods(node, func(_words: String) -> void: assert_true(node.is_inside_tree()))


func test_a_boot_of_any_size_treads_within_the_field() -> void:
	expect_error("GrassField 'Meadow': `radius` cannot be 500.0 (allowed: 0.0 to 64.0 m); using 64.0")
	var field := add_field({size = Vector2(32, 32), map = full_map()})
	await ticks(2)
	var trodden := field.trample(Vector3.ZERO, 500.0, 1.0)
	assert_less(trodden, 33.0 * 33.0 + 1.0, "m²: the field and the texel around it")
	assert_greater(trodden, 32.0 * 32.0 - 1.0, "m²")
	var chunks := field.map.get_chunks()
	chunks.sort()
	assert_eq(chunks, [Vector2i(-1, -1), Vector2i(-1, 0), Vector2i(0, -1), Vector2i(0, 0)] as Array[Vector2i])
	assert_eq(field.trample(Vector3(100, 0, 0), 10.0, 1.0), 0.0, "beside the field")


func test_ground_is_baked_where_the_field_is() -> void:
	expect_error("GrassField 'Meadow': the region of bake_ground() is outside of the field")
	var field := add_field({map = full_map()})
	var slab := box(Vector3(400, 1, 400))
	add_body(StaticBody3D.new(), slab, Vector3(0, -0.5, 0))
	await ticks(2)
	var found := field.bake_ground()
	assert_greater(found, 16)
	assert_eq(field.bake_ground(Rect2(-1e6, -1e6, 2e6, 2e6)), found)
	assert_eq(field.bake_ground(Rect2(50, 50, 4, 4)), 0)


func test_a_map_says_what_it_cannot_hold() -> void:
	expect_error("GrassMap: the region of fill() must lie within 16,384 m to each side")
	expect_error("GrassMap: the region of set_ground() must lie within 16,384 m to each side")
	expect_error("GrassMap: the ends of a stroke are 2000000 m apart; at most 4096 m can be painted at once")
	var map := GrassMap.new()
	assert_eq(map.fill(GrassFillRule.new(), Rect2(-1e6, -1e6, 2e6, 2e6)), 0.0)
	assert_false(map.set_ground(Image.create_empty(4, 4, false, Image.FORMAT_RF), Rect2(-16384, -16384, 32768, 32768)))
	assert_eq(map.stroke(brush(GrassBrush.TOOL_PAINT, 1.0), Vector2(-1e6, 0), Vector2(1e6, 0)), 0.0)
	assert_true(map.is_empty())
