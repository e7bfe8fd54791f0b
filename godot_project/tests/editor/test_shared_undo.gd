# SPDX-License-Identifier: MIT
## One .grassmap in two scenes: undo in one leaves what was painted in the other.
@tool
extends "res://tests/editor/owned_case.gd"

const HEAD := '[gd_scene format=3]\n[ext_resource type="GrassMap" path="%s" id="1"]\n[node name="%s" type="Node3D"]\n'
const FIELD := '[node name="Field" type="GrassField" parent="."]\nsize = Vector2(12, 12)\ndensity = 4.0\nmap = ExtResource("1")\n'
const FIRST := Vector2(0, 0)
const SECOND := Vector2(0, 3)


func on_disk(path: String, place: Vector2) -> float:
	var map: GrassMap = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	return map.sample(GrassMap.CHANNEL_DENSITY, place)


func stroke_at(place: Vector2) -> void:
	await take("Erase")
	await stroke([Vector3(place.x - 1, 0, place.y), Vector3(place.x + 1, 0, place.y)])


func test_undo_takes_back_its_own_stroke_alone() -> void:
	var path := "res://tests/editor/two_%d.grassmap" % _count
	var map := GrassMap.new()
	map.base_density = 1.0
	ResourceSaver.save(map, path)
	write(base, HEAD % [path, "X"] + FIELD)
	write(level, HEAD % [path, "Y"] + FIELD)
	await open(base)
	await stroke_at(FIRST)
	await open(level)
	await stroke_at(SECOND)
	EditorInterface.save_scene()
	await open_tab(base)
	await undo()
	assert_near(sample(field, FIRST), 1.0, 0.01, "its own is gone")
	assert_less(sample(field, SECOND), 0.3, "the other scene's stays")
	EditorInterface.save_scene()
	assert_near(on_disk(path, FIRST), 1.0, 0.01)
	assert_less(on_disk(path, SECOND), 0.3, "in the file as well")
	await redo()
	assert_less(sample(field, FIRST), 0.3)
	assert_less(sample(field, SECOND), 0.3)
	await open_tab(level)
	await undo()
	assert_less(sample(field, FIRST), 0.3)
	assert_near(sample(field, SECOND), 1.0, 0.01)


## Goes to a scene that is open already.
func open_tab(path: String) -> void:
	EditorInterface.open_scene_from_path(path)
	await frames(4)
	field = EditorInterface.get_edited_scene_root().get_node("Field")
	await select(field)
