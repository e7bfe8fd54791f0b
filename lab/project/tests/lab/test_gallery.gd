# SPDX-License-Identifier: MIT
## Every view of the gallery can be built, and has grass in front of the camera.
extends "res://tests/case.gd"

const Views := preload("res://demo/gallery/views.gd")

var gallery: Node3D


func before() -> void:
	gallery = (load("res://demo/gallery.tscn") as PackedScene).instantiate()
	gallery._options.size = "small"
	add_child(gallery)


func after() -> void:
	gallery.free()


func test_views() -> void:
	var camera: Camera3D = gallery.get_node("Camera")
	var names := Views.ALL.keys()
	names.sort_custom(func(a: String, b: String) -> bool: return Views.of(a).place < Views.of(b).place)  # builds each place once
	for name: String in names:
		gallery.show_view(name)
		await ticks(2)
		var view := Views.of(name)
		var field: GrassField = gallery._place.field
		assert_eq(gallery._place.kind, view.place, name)
		assert_greater(gallery._place.blade_count(), 10000, name)
		assert_greater(camera.global_position.y, 0.1, name)
		assert_true(camera.is_position_in_frustum(field.global_position), name + ": the field is in the picture")
		assert_eq(gallery._light.get_children().filter(func(node: Node) -> bool: return node is WorldEnvironment).size(), 1, name)


func test_painted() -> void:
	gallery.show_view("painted")
	await ticks(2)
	var field: GrassField = gallery._place.field
	var on_path := Vector3(5.0 * sin(0.35 * 18) - 2.0 * cos(0.35 * 18), 0, 4)
	assert_less(field.get_density_at(on_path), 0.2, "the path")
	assert_greater(field.get_density_at(Vector3(-9, 0, 9)), 0.9, "beside it")
