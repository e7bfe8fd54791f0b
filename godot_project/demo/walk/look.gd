# SPDX-License-Identifier: MIT
## Makes the shapes and materials of the things that move in the walk, in one line each. Things of the same paint share their material, so
## that weather and sky reach them all.
extends RefCounted

const SHADER := "res://demo/walk/thing.gdshader"
const SKY := Color(0.6, 0.7, 0.82)  # that shines on things, by day

static var _painted: ShaderMaterial


## The material of meshes that a mould made.
static func painted() -> ShaderMaterial:
	if _painted == null:
		_painted = ShaderMaterial.new()
		_painted.shader = load(SHADER)
	return _painted


## Covers things with snow, and wets them; each 0 to 1.
static func cover(snow: float, wetness: float) -> void:
	painted().set_shader_parameter("snow", snow)
	painted().set_shader_parameter("wetness", wetness)


## Lets this colour of the sky shine on things.
static func reflect(sky: Color) -> void:
	painted().set_shader_parameter("sky", sky)


static func paint(color: Color, roughness := 0.6, metallic := 0.0) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.albedo_color = color
	material.roughness = roughness
	material.metallic = metallic
	return material


static func add_mesh(to: Node3D, mesh: Mesh, at: Vector3, material: Material = painted()) -> MeshInstance3D:
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
	lamp.spot_angle = 44.0
	lamp.spot_angle_attenuation = 1.8  # no rim is seen
	lamp.visible = false
	to.add_child(lamp)
	return lamp
