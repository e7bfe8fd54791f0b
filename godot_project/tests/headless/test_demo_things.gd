# SPDX-License-Identifier: MIT
## Things of the demo: the parts that their meshes are built from are closed and face outwards, and weather reaches them.
extends "res://tests/case.gd"

const Mould := preload("res://demo/walk/mould.gd")
const Look := preload("res://demo/walk/look.gd")
const Trees := preload("res://demo/walk/trees.gd")
const Weather := preload("res://demo/walk/weather.gd")
const Country := preload("res://demo/walk/country.gd")
const Hills := preload("res://demo/walk/hills.gd")
const JeepLook := preload("res://demo/walk/jeep_look.gd")
const MowerLook := preload("res://demo/walk/mower_look.gd")
const BodyLook := preload("res://demo/body_look.gd")


## Returns what the sides of a mesh enclose, m³. Triangles that face inwards, or are missing, change it.
func volume(mesh: ArrayMesh) -> float:
	var arrays := mesh.surface_get_arrays(0)
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	var sum := 0.0
	for i in range(0, indices.size(), 3):
		sum += points[indices[i]].dot(points[indices[i + 2]].cross(points[indices[i + 1]])) / 6.0
	return sum


func made(build: Callable) -> ArrayMesh:
	var mould := Mould.new()
	build.call(mould)
	return mould.commit()


func test_parts_are_closed_and_face_outwards() -> void:
	var off := Mould.at(Vector3(3, 1, 2), Vector3(0.4, 1.0, -0.3))
	var box := made(func(mould: Mould) -> void: mould.box(Vector3(1, 2, 3), off, 0.002))
	assert_near(volume(box), 6.0, 0.03, "a box")
	var tapered := made(func(mould: Mould) -> void: mould.box(Vector3(1, 2, 3), off, 0.002, Vector2(0.5, 0.5)))
	assert_near(volume(tapered), 3.5, 0.03, "a box that tapers")
	var disc := made(func(mould: Mould) -> void: mould.disc(0.5, 1.0, off, 0.001))
	assert_near(volume(disc), 0.25 * PI, 0.02, "a disc")
	var tube := made(func(mould: Mould) -> void: mould.tube([Vector3(1, 0, 0), Vector3(1, 0, 4)], 0.1))
	assert_near(volume(tube), 0.04 * PI, 0.012, "a tube")
	var ball := made(func(mould: Mould) -> void: mould.gore(1.0, 0.0, TAU / 8.0))
	assert_near(volume(ball), PI / 6.0, 0.01, "an eighth of a ball; its flat sides go through the middle")
	var corner: PackedVector2Array = [Vector2(0, 0), Vector2(2, 0), Vector2(2, 1), Vector2(1, 1), Vector2(1, 2), Vector2(0, 2)]
	for turned: bool in [false, true]:
		if turned:
			corner.reverse()
		var plate := made(func(mould: Mould) -> void: mould.plate(corner, -3.0, -2.5))
		assert_near(volume(plate), 1.5, 0.001, "a plate")
	var sheet := made(func(mould: Mould) -> void: mould.sheet([Vector2(0, 1), Vector2(1, 1), Vector2(2, 1)], 0.0, 3.0, 0.1))
	assert_near(volume(sheet), 0.6, 0.001, "a sheet")
	var hull := made(func(mould: Mould) -> void: mould.hull([Vector3.ZERO, Vector3.RIGHT, Vector3.UP, Vector3.BACK]))
	assert_near(volume(hull), 1.0 / 6.0, 1e-4, "a hull")


func test_things_are_whole_and_small() -> void:
	var things := {"jeep": JeepLook.body(), "wheel": JeepLook.wheel(0.4), "mower": MowerLook.mesh(Vector3(1.0, 0.16, 0.8), 0.08)}
	for kind in BodyLook.Kind.STONE:
		things["body %d" % kind] = BodyLook.mesh(kind, 0)
	for name: String in things:
		var arrays: Array = things[name].surface_get_arrays(0)
		assert_less(arrays[Mesh.ARRAY_VERTEX].size(), 20_000, name)
		assert_greater(volume(things[name]), 0.0, name)


func test_weather_reaches_things_and_trees() -> void:
	var weather := Weather.new()
	add_child(weather)
	var country := Country.new()
	var hills := Hills.new()
	for kind: String in ["snow", "rain", "clear"]:
		weather.kind = kind
		weather.settle()
		weather.advance(0.0, country, hills, Vector3.ZERO)
		for material: ShaderMaterial in [Look.painted(), Trees._foliage(), hills._material]:
			assert_near(material.get_shader_parameter("snow"), weather.now.snow, 1e-6, kind)
			assert_near(material.get_shader_parameter("wetness"), weather.now.wet, 1e-6, kind)
	for node: Node in [weather, country, hills]:
		node.free()
