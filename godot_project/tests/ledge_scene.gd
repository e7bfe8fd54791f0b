# SPDX-License-Identifier: MIT
## A level with edges: a floor with walls, blocks, stairs, a bridge, a cliff and a GridMap, anywhere between the heights of a map.
extends RefCounted

const HALF := 14.0  # metres: everything lies within that of the origin


## Adds the level's bodies, with shapes that are seen, to `parent`. `offset`, in metres, moves what stands on the floor; `turn`, in
## radians, turns it.
static func add_to(parent: Node3D, offset: Vector2, turn: float) -> void:
	add_box(parent, Vector3(0, -0.5, 0), Vector3(3 * HALF, 1, 3 * HALF))
	var level := Node3D.new()
	level.position = Vector3(offset.x, 0, offset.y)
	level.rotation.y = turn
	parent.add_child(level)
	add_box(level, Vector3(-6, 0.5, -6), Vector3(3, 1, 2.6))
	add_box(level, Vector3(-6, 1.5, -6.3), Vector3(1.4, 1, 1.1), 0.4)
	add_box(level, Vector3(5, 0.25, -7), Vector3(4, 0.5, 3), 0.7)
	add_box(level, Vector3(0, 1.25, -3.1), Vector3(7, 2.5, 0.2))  # a wall
	add_box(level, Vector3(-9, 1.0, 2), Vector3(0.35, 2, 6), 0.2)
	for step in 6:
		add_box(level, Vector3(-4.0 + 0.35 * step, 0.09 * (step + 1), 5), Vector3(0.35, 0.18 * (step + 1), 2.5))
	add_box(level, Vector3(2, 0.9, 8.5), Vector3(7, 0.2, 1.5))  # a bridge
	add_box(level, Vector3(-1.2, 0.4, 8.5), Vector3(0.6, 0.8, 1.5))
	add_box(level, Vector3(5.2, 0.4, 8.5), Vector3(0.6, 0.8, 1.5))
	add_box(level, Vector3(9.5, 1.5, 1), Vector3(4, 3, 9), 0.1, Vector3(0, 0, 0.15))  # a cliff with a sloping top
	add_grid(level, Vector3(1, 0, 1))


static func add_box(parent: Node3D, place: Vector3, size: Vector3, turn := 0.0, tilt := Vector3.ZERO) -> void:
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = size
	body.add_child(shape)
	var look := MeshInstance3D.new()
	look.mesh = BoxMesh.new()
	(look.mesh as BoxMesh).size = size
	body.add_child(look)
	body.position = place
	body.rotation = Vector3(0, turn, 0) + tilt
	parent.add_child(body)


static func add_grid(parent: Node3D, place: Vector3) -> void:
	var box := BoxShape3D.new()
	box.size = Vector3(1.2, 0.6, 1.2)
	var mesh := BoxMesh.new()
	mesh.size = box.size
	var library := MeshLibrary.new()
	library.create_item(0)
	library.set_item_mesh(0, mesh)
	library.set_item_shapes(0, [box, Transform3D()])
	var grid := GridMap.new()
	grid.mesh_library = library
	grid.cell_size = Vector3(1.2, 0.6, 1.2)
	grid.position = place
	for cell: Vector3i in [
		Vector3i(0, 0, 0), Vector3i(1, 0, 0), Vector3i(1, 1, 0), Vector3i(1, 0, 1), Vector3i(0, 0, 2), Vector3i(2, 2, 0)
	]:
		grid.set_cell_item(cell, 0)
	parent.add_child(grid)
