# SPDX-License-Identifier: MIT
## Rigid bodies of mixed shapes, thrown into a field: balls, boxes, capsules, cylinders and odd convex stones.
extends RefCounted

const COLORS: Array[Color] = [
	Color(0.75, 0.22, 0.15), Color(0.85, 0.6, 0.2), Color(0.2, 0.4, 0.65), Color(0.8, 0.78, 0.72), Color(0.35, 0.3, 0.5)
]

var _random := RandomNumberGenerator.new()


func _init(p_seed: int) -> void:
	_random.seed = p_seed


## Returns a body of a random kind, 0.25 to 0.6 m in size. The same seed gives the same bodies.
func make() -> RigidBody3D:
	var size := _random.randf_range(0.25, 0.6)
	var body := RigidBody3D.new()
	var shape := CollisionShape3D.new()
	var look := MeshInstance3D.new()
	match _random.randi() % 5:
		0:
			shape.shape = SphereShape3D.new()
			shape.shape.radius = size * 0.5
			look.mesh = SphereMesh.new()
			look.mesh.radius = size * 0.5
			look.mesh.height = size
		1:
			shape.shape = BoxShape3D.new()
			shape.shape.size = Vector3(size, size * 0.6, size * 0.8)
			look.mesh = BoxMesh.new()
			look.mesh.size = shape.shape.size
		2:
			shape.shape = CapsuleShape3D.new()
			shape.shape.radius = size * 0.3
			shape.shape.height = size * 1.6
			look.mesh = CapsuleMesh.new()
			look.mesh.radius = size * 0.3
			look.mesh.height = size * 1.6
		3:
			shape.shape = CylinderShape3D.new()
			shape.shape.radius = size * 0.45
			shape.shape.height = size * 0.7
			look.mesh = CylinderMesh.new()
			look.mesh.top_radius = size * 0.45
			look.mesh.bottom_radius = size * 0.45
			look.mesh.height = size * 0.7
		4:
			_make_stone(shape, look, size)
	look.material_override = StandardMaterial3D.new()
	look.material_override.albedo_color = COLORS[_random.randi() % COLORS.size()]
	look.material_override.roughness = 0.6
	body.mass = 8.0 * size * size * size / 0.064
	body.add_child(shape)
	body.add_child(look)
	return body


## Places `body` above the rim of a field of `extent` metres and sends it across.
func throw(body: RigidBody3D, extent: float) -> void:
	var from := _random.randf_range(-0.45, 0.45) * extent
	var towards := Vector3(1.0, 0.0, _random.randf_range(-0.5, 0.5)).normalized()
	body.position = Vector3(-0.42 * extent, _random.randf_range(0.8, 2.5), from)
	body.rotation = Vector3(_random.randf(), _random.randf(), _random.randf()) * TAU
	body.linear_velocity = towards * _random.randf_range(4.0, 0.4 * extent + 5.0) + Vector3(0.0, _random.randf_range(0.0, 3.0), 0.0)
	body.angular_velocity = Vector3(_random.randfn(), _random.randfn(), _random.randfn()) * 6.0
	body.angular_damp = 1.2
	body.linear_damp = 0.35


func _make_stone(r_shape: CollisionShape3D, r_look: MeshInstance3D, size: float) -> void:
	var points := PackedVector3Array()
	for i in 14:
		points.append(Vector3(_random.randfn(), _random.randfn(), _random.randfn()).normalized() * size * _random.randf_range(0.4, 0.6))
	r_shape.shape = ConvexPolygonShape3D.new()
	r_shape.shape.points = points
	r_look.mesh = hull_mesh(points)


# The faces of the convex hull: every triple of points that has all others on one side.
static func hull_mesh(points: PackedVector3Array) -> ArrayMesh:
	var surface := SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	surface.set_smooth_group(-1)
	for a in points.size():
		for b in range(a + 1, points.size()):
			for c in range(b + 1, points.size()):
				var plane := Plane(points[a], points[b], points[c])
				var above := 0
				for point in points:
					above += int(plane.distance_to(point) > 1e-5)
				var below := 0
				for point in points:
					below += int(plane.distance_to(point) < -1e-5)
				if above == 0:
					for i: int in [a, b, c]:
						surface.add_vertex(points[i])
				elif below == 0:
					for i: int in [a, c, b]:
						surface.add_vertex(points[i])
	surface.generate_normals()
	return surface.commit()
