# SPDX-License-Identifier: MIT
## The species that ship with the add-on: each loads, grows, moves, and appears in its demo.
extends "res://tests/field_case.gd"

const Presets := preload("res://demo/presets.gd")
# Levels of users refer to presets by these. They never change.
const IDS := {
	barley = "uid://ctv83qyy1tdgy",
	clover = "uid://cfwg50s07tjm0",
	daisy = "uid://dxyyncbqaylc4",
	fern = "uid://0fguqnufxq6r",
	golf_green = "uid://c02x5oq1f2toi",
	hay_meadow = "uid://pxa1p4x1chkh",
	lawn = "uid://bodno4pdd6c7x",
	meadow = "uid://ch2wvic3j4hlw",
	ox_eye_daisy = "uid://s5luta0ayr3c",
	reed = "uid://bxq36mtk7skf5",
	small_shrub = "uid://dtxqp5wtpfg1x",
	tall_dry_grass = "uid://caw7mvpyn3pmy",
	tundra = "uid://lwkq1sbslvjr",
	wheat = "uid://5in02hu1harp",
}


func names() -> PackedStringArray:
	var found := PackedStringArray()
	for file in DirAccess.get_files_at(Presets.FOLDER):
		if file.get_extension() == "tres":
			found.append(file.get_basename())
	return found


func test_ids_of_presets_stay() -> void:
	assert_eq(names().size(), IDS.size())
	for name in names():
		var id := ResourceLoader.get_resource_uid(Presets.FOLDER + name + ".tres")
		assert_eq(ResourceUID.id_to_text(id), IDS.get(name, "none is listed here"), name)


func test_each_preset_is_shown_and_none_is_the_same_as_another() -> void:
	var known := names()
	assert_eq(known.size(), Presets.FIELDS.size())
	var looks := {}
	for name in known:
		assert_true(Presets.FIELDS.has(name), "%s has a field in the demo" % name)
		var species: GrassSpecies = load(Presets.FOLDER + name + ".tres")
		looks[[species.patch.length_max, species.patch.width_max, species.tip_color, species.card]] = name
	assert_eq(looks.size(), known.size())


func test_each_preset_grows_stands_and_bends() -> void:
	for name in names():
		var field: GrassField = Presets.make(name)
		assert_eq(field.density, Presets.FIELDS[name][0], "a field may be as thick as %s" % name)
		field.size = Vector2.ONE * minf(field.size.x, 32.0 / sqrt(field.density))
		field.position = Vector3.ZERO
		add_child(field)
		await ticks(3)
		assert_greater(field.get_blade_count(), 500, name)
		var species: GrassSpecies = field.species[-1]
		var height: float = field.get_height_at(Vector3.ZERO)
		assert_greater(height, 0.2 * species.patch.length_min, name)
		assert_less(height, species.patch.length_max * 1.35, name)
		var body := AnimatableBody3D.new()
		body.sync_to_physics = false
		add_shape(body, ball(0.6 * species.patch.length_min))
		body.position = Vector3(0, 0.7 * species.patch.length_min, 0)
		add_child(body)
		await ticks(6)
		assert_greater(field.get_awake_tile_count(), 0, "%s is bent by a body" % name)
		body.queue_free()
		field.queue_free()
		await ticks(1)
