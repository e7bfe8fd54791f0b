# SPDX-License-Identifier: MIT
## Ground of noise: a HeightMapShape3D and a mesh of the same heights, made when the node enters the tree, so that a scene stores only a few
## numbers.
@tool
extends StaticBody3D

@export_range(8, 256, 2, "suffix:m") var size := 64:
	set(value):
		size = value
		_make()
@export var noise: FastNoiseLite:
	set(value):
		noise = value
		_make()
@export_range(0.0, 20.0, 0.1, "suffix:m") var relief := 3.0:  ## from the middle of the noise to its top
	set(value):
		relief = value
		_make()
@export var profile: Curve:  ## metres added, by the place along z: 0 at the far side (-z), 1 at the near side
	set(value):
		profile = value
		_make()
@export var material: Material:
	set(value):
		material = value
		_make()

var shape := HeightMapShape3D.new()

var _mesh := MeshInstance3D.new()


func _init() -> void:
	var collider := CollisionShape3D.new()
	collider.shape = shape
	add_child(collider, false, INTERNAL_MODE_FRONT)
	add_child(_mesh, false, INTERNAL_MODE_FRONT)


func _ready() -> void:
	_make()


## Height above the node at `x`, `z` metres from its middle, metres: that of the shape's squares, not of the noise between them.
func height_at(x: float, z: float) -> float:
	var place := (Vector2(x, z) + Vector2.ONE * 0.5 * size).clampf(0.0, size - 1e-3)
	var cell := Vector2i(place)
	var part := place - Vector2(cell)
	var width := size + 1
	var first := cell.y * width + cell.x
	var heights := shape.map_data
	var near := lerpf(heights[first], heights[first + 1], part.x)
	return lerpf(near, lerpf(heights[first + width], heights[first + width + 1], part.x), part.y)


func _make() -> void:
	if not is_node_ready() or noise == null:
		return
	var heights := PackedFloat32Array()
	for z in size + 1:
		var along := profile.sample_baked(float(z) / size) if profile else 0.0
		for x in size + 1:
			heights.append(along + relief * noise.get_noise_2d(x, z))
	shape.map_width = size + 1
	shape.map_depth = size + 1
	shape.map_data = heights
	_mesh.mesh = _mesh_of(heights)
	_mesh.material_override = material


func _mesh_of(heights: PackedFloat32Array) -> ArrayMesh:
	var surface := SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	var width := size + 1
	for z in width:
		for x in width:
			surface.set_uv(Vector2(x, z))
			surface.add_vertex(Vector3(x - 0.5 * size, heights[z * width + x], z - 0.5 * size))
	for z in size:
		for x in size:
			var first := z * width + x
			for corner: int in [first, first + 1, first + width, first + 1, first + width + 1, first + width]:
				surface.add_index(corner)
	surface.generate_normals()
	return surface.commit()
