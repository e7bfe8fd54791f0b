# SPDX-License-Identifier: MIT
## Files of every version so far load with their values: tests/fixtures/VERSION, written by `./grass release --fixtures`.
extends "res://tests/field_case.gd"

const Fixture = preload("res://tests/fixtures/fixture.gd")
const FOLDER := "res://tests/fixtures/"


func _versions() -> PackedStringArray:
	return DirAccess.get_directories_at(FOLDER)


func _kept(version: String) -> Dictionary:
	return JSON.parse_string(FileAccess.get_file_as_string("%s%s/expected.json" % [FOLDER, version]))


func test_files_of_every_version_hold_what_they_held() -> void:
	assert_greater(_versions().size(), 0)
	for version in _versions():
		var expected := _kept(version)
		assert_greater(expected.size(), 6, version)
		for file: String in expected:
			var path := "%s%s/%s" % [FOLDER, version, file]
			var resource := ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
			if not assert_true(resource != null, path):
				continue
			var root: Node = resource.instantiate() if resource is PackedScene else null
			var found: Variant = Fixture.describe_scene(root) if root else Fixture.describe(resource)
			assert_eq(Fixture.differences(_as_now(expected[file]) if root else expected[file], found), PackedStringArray(), path)
			if root:
				root.free()


## Of 0.9.0: what is a species' now was a field's, too, and did not count in a field with species.
const MOVED: Array[String] = [
	"patch",
	"natural_frequency",
	"damping_ratio",
	"root_stiffness",
	"bend_stiffness",
	"wear_recovery",
	"root_color",
	"tip_color",
	"dry_color",
	"dry"
]

## Names of 0.9.0 that have another one now: old -> new.
const OLD_PROPERTIES := {ground = "soil_enabled", max_speed = "swing_speed_max"}
const OLD_METHODS := {density_at = "get_density_at", height_at = "get_height_at", bend_at = "get_bend_at", get_tiles = "get_grid_size"}


func _as_now(kept: Dictionary) -> Dictionary:
	for node: Variant in kept.values():
		if node is Dictionary and node.get("class") == "GrassField":
			for name in MOVED:
				node.values.erase(name)
			for old: String in OLD_PROPERTIES:
				if node.values.has(old):
					node.values[OLD_PROPERTIES[old]] = node.values[old]
					node.values.erase(old)
	return kept


func test_a_field_of_0_9_0_without_species_keeps_its_look() -> void:
	const PATH := "user://field_0_9_0.tscn"
	const LINES: Array[String] = [
		"[gd_scene format=3]",
		'[sub_resource type="GrassPatch" id="patch"]',
		"length_max = 0.8",
		'[node name="Field" type="GrassField"]',
		'patch = SubResource("patch")',
		"natural_frequency = 2.5",
		"root_stiffness = 2.0",
		"tip_color = Color(1, 0, 0, 1)",
		"dry = 0.5",
	]
	var file := FileAccess.open(PATH, FileAccess.WRITE)
	file.store_string("\n".join(LINES))
	file.close()
	var field: GrassField = load(PATH).instantiate()
	assert_eq(field.species.size(), 1)
	assert_near(field.species[0].patch.length_max, 0.8, 1e-6)
	assert_near(field.species[0].natural_frequency, 2.5, 1e-6)
	assert_near(field.species[0].root_stiffness, 2.0, 1e-6)
	assert_eq(field.species[0].tip_color, Color.RED)
	assert_near(field.dry, 0.5, 1e-6, "scripts read it as before")
	var packed := PackedScene.new()
	packed.pack(field)
	var again: GrassField = packed.instantiate()
	assert_near(again.species[0].dry, 0.5, 1e-6, "and it is saved with its species")
	again.free()
	field.species = [GrassSpecies.new()]
	field.dry = 0.9
	assert_near(field.species[0].dry, 0.25, 1e-6, "as in 0.9.0, it does not touch species")
	field.free()


func test_a_scene_with_old_names_loads_and_is_saved_with_new_ones() -> void:
	const PATH := "user://old_names.tscn"
	var file := FileAccess.open(PATH, FileAccess.WRITE)
	file.store_string('[gd_scene format=3]\n[node name="Field" type="GrassField"]\nground = false\nmax_speed = 33.0\n')
	file.close()
	var field: GrassField = load(PATH).instantiate()
	assert_eq([field.soil_enabled, field.swing_speed_max], [false, 33.0])
	var packed := PackedScene.new()
	packed.pack(field)
	assert_eq(ResourceSaver.save(packed, PATH), OK)
	var text := FileAccess.get_file_as_string(PATH)
	for old: String in OLD_PROPERTIES:
		assert_false(text.contains("\n%s = " % old), old)
		assert_true(text.contains("\n%s = " % OLD_PROPERTIES[old]), OLD_PROPERTIES[old])
	field.free()


func test_scripts_with_old_names_work() -> void:
	var field := add_field({map = full_map()})
	await grown(field)
	field.ground = false
	field.max_speed = 44.0
	assert_eq([field.soil_enabled, field.swing_speed_max, field.ground, field.max_speed], [false, 44.0, false, 44.0])
	var place := Vector3(0.3, 0.0, 0.4)
	assert_greater(field.density_at(place), 0.9)
	assert_eq(field.density_at(place), field.get_density_at(place))
	assert_greater(field.height_at(place), 0.2)
	assert_eq(field.height_at(place), field.get_height_at(place))
	assert_eq(field.bend_at(place), field.get_bend_at(place))
	assert_greater(field.get_tiles().x, 0)
	assert_eq(field.get_tiles(), field.get_grid_size())


func test_the_class_reference_calls_old_names_deprecated() -> void:
	var text := FileAccess.get_file_as_string("res://../extension/doc_classes/GrassField.xml")
	for old: Dictionary in [OLD_PROPERTIES, OLD_METHODS]:
		var kind := "member" if old == OLD_PROPERTIES else "method"
		for name: String in old:
			var mark := '<%s name="%s"[^>]* deprecated="Use \\[%s %s\\] instead."' % [kind, name, kind, old[name]]
			assert_true(RegEx.create_from_string(mark).search(text) != null, name)


func test_every_file_of_a_version_is_expected_and_every_kind_is_there() -> void:
	for version in _versions():
		var files := Array(DirAccess.get_files_at(FOLDER + version))
		files = files.filter(func(file: String) -> bool: return file != "expected.json" and not file.ends_with(".uid"))
		var expected := _kept(version).keys()
		files.sort()
		expected.sort()
		assert_eq(files, expected, version)
		for type: String in ["GrassField", "GrassPatch", "GrassSpecies", "GrassMap", "GrassBrush", "GrassFillRule", "GrassExclusion3D"]:
			assert_true(JSON.stringify(_kept(version)).contains('"class":"%s"' % type), "%s: a %s" % [version, type])


func test_a_field_of_every_version_grows() -> void:
	for version in _versions():
		var scene: Node = load("%s%s/field.tscn" % [FOLDER, version]).instantiate()
		add_child(scene)
		var field: GrassField = scene.get_node("GrassField")
		await grown(field)
		assert_greater(field.get_blade_count(), 0, version)
		scene.free()


func test_differences_are_found() -> void:
	var brush := GrassBrush.new()
	var before: Dictionary = JSON.parse_string(JSON.stringify(Fixture.describe(brush)))
	assert_eq(Fixture.differences(before, Fixture.describe(brush)), PackedStringArray())
	brush.radius += 0.01
	assert_eq(Fixture.differences(before, Fixture.describe(brush)).size(), 1)
	var map := full_map()
	before = Fixture.describe(map)
	map.stroke(self.brush(GrassBrush.TOOL_ERASE, 3.0), Vector2.ZERO, Vector2.ZERO)
	assert_greater(Fixture.differences(before, Fixture.describe(map)).size(), 0)
