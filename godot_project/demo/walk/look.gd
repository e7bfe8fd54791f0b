# SPDX-License-Identifier: MIT
## Makes the shapes and materials of the things that move in the walk, in one line each.
extends RefCounted


static func paint(color: Color, roughness := 0.6, metallic := 0.0) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.albedo_color = color
	material.roughness = roughness
	material.metallic = metallic
	return material


static func add_box(to: Node3D, size: Vector3, at: Vector3, color: Color, metallic := 0.0) -> MeshInstance3D:
	var mesh := BoxMesh.new()
	mesh.size = size
	return add_mesh(to, mesh, at, paint(color, 0.5, metallic))


static func add_mesh(to: Node3D, mesh: Mesh, at: Vector3, material: Material) -> MeshInstance3D:
	var look := MeshInstance3D.new()
	look.mesh = mesh
	look.position = at
	look.material_override = material
	to.add_child(look)
	return look


static func add_shape(to: Node3D, shape: Shape3D, at := Vector3.ZERO) -> CollisionShape3D:
	var node := CollisionShape3D.new()
	node.shape = shape
	node.position = at
	to.add_child(node)
	return node


static func box(size: Vector3) -> BoxShape3D:
	var shape := BoxShape3D.new()
	shape.size = size
	return shape


## Adds a lamp that shines along -z.
static func add_lamp(to: Node3D, at: Vector3, energy: float, reach: float) -> SpotLight3D:
	var lamp := SpotLight3D.new()
	lamp.position = at
	lamp.light_color = Color(1.0, 0.94, 0.82)
	lamp.light_energy = energy
	lamp.spot_range = reach
	lamp.spot_angle = 38.0
	lamp.spot_angle_attenuation = 0.5  # a soft rim
	lamp.visible = false
	to.add_child(lamp)
	return lamp
