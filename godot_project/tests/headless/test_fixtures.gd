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
			assert_eq(Fixture.differences(expected[file], found), PackedStringArray(), path)
			if root:
				root.free()


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
