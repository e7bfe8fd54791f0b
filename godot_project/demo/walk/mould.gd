# SPDX-License-Identifier: MIT
## Builds the mesh of a thing from a few kinds of parts, each in the paint that was set last. A thing is one mesh with one material
## (thing.gdshader), which draws it in one call: its vertices carry colour, dirt, roughness, metal and
## grain.
extends RefCounted

const SIDES := 20  # of a lathed part
const SMOOTH := 0.75  # cosine of the sharpest bend of a profile that looks round

## Heights on the thing up to which it is full of dirt, and from which on it has none, metres.
var dirt := Vector2(-1.0, 0.0)

## Along which axis of the thing fibres run (1 to 3, as x, y and z; 0: a grain without a direction), and how much is seen of it, 0 to 1.
var grain := Vector2.ZERO

var _points := PackedVector3Array()
var _normals := PackedVector3Array()
var _colors := PackedColorArray()
var _finishes := PackedVector2Array()
var _grains := PackedVector2Array()
var _indices := PackedInt32Array()
var _color := Color.WHITE
var _finish := Vector2.ZERO  # roughness, metal


static func at(place: Vector3, turned := Vector3.ZERO) -> Transform3D:
	return Transform3D(Basis.from_euler(turned), place)


func commit() -> ArrayMesh:
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = _points
	arrays[Mesh.ARRAY_NORMAL] = _normals
	arrays[Mesh.ARRAY_COLOR] = _colors
	arrays[Mesh.ARRAY_TEX_UV] = _finishes
	arrays[Mesh.ARRAY_TEX_UV2] = _grains
	arrays[Mesh.ARRAY_INDEX] = _indices
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh


func paint(color: Color, roughness := 0.6, metallic := 0.0) -> void:
	_color = color
	_finish = Vector2(roughness, metallic)


## Adds a box with bevelled edges, which look round. top: width and length of its upper side over those of the lower one.
func box(size: Vector3, place: Transform3D, bevel := 0.012, top := Vector2.ONE) -> void:
	var half := 0.5 * size
	var inner := half - Vector3.ONE * minf(bevel, 0.8 * half[half.min_axis_index()])
	var first := _points.size()
	for corner in 8:  # three vertices each, one for each side that meets there
		var way := Vector3(1.0 if corner & 1 else -1.0, 1.0 if corner & 2 else -1.0, 1.0 if corner & 4 else -1.0)
		for axis in 3:
			var point := way * inner
			point[axis] = way[axis] * half[axis]
			var share := 0.5 + 0.5 * point.y / half.y
			var normal := Vector3.ZERO
			normal[axis] = way[axis]
			_add(place * (point * Vector3(lerpf(1.0, top.x, share), 1.0, lerpf(1.0, top.y, share))), place.basis * normal)
		_triangle(first + 3 * corner, first + 3 * corner + 1, first + 3 * corner + 2)
	for axis in 3:
		var along := 3 << axis  # from a vertex to that at the other end of an edge
		var u := (axis + 1) % 3
		var v := (axis + 2) % 3
		for end in 2:
			var side := first + end * along + axis
			_four(side, side + (3 << u), side + (3 << v), side + (3 << u) + (3 << v))
		for edge in 4:
			var start := first + (edge & 1) * (3 << u) + (edge >> 1) * (3 << v)
			_four(start + u, start + along + u, start + v, start + along + v)


## Adds what a lathe turns around the y axis of `place`. profile: radius and place along that axis, upwards where it is seen from outside.
func lathe(profile: PackedVector2Array, place: Transform3D, sides := SIDES) -> void:
	for i in profile.size() - 1:
		var along := (profile[i + 1] - profile[i]).normalized()
		var first := _points.size()
		for end in 2:
			var other := clampi(i - 1 + 3 * end, 0, profile.size() - 1)  # the point before, or the one after
			var beyond := (profile[i + end] - profile[other]).normalized() * (1.0 if end == 0 else -1.0)
			var bent := (along + beyond).normalized() if along.dot(beyond) > SMOOTH else along
			for side in sides + 1:
				var out := Vector2.from_angle(TAU * side / sides)
				var point := profile[i + end]
				_add(
					place * Vector3(out.x * point.x, point.y, out.y * point.x),
					place.basis * Vector3(out.x * bent.y, -bent.x, out.y * bent.y)
				)
		for side in sides:
			_four(first + side, first + side + 1, first + sides + 1 + side, first + sides + 2 + side)


## Adds the part of a sphere between two angles around the y axis.
func gore(radius: float, from: float, to: float) -> void:
	const ROWS := 16
	const COLUMNS := 4
	var first := _points.size()
	for row in ROWS + 1:
		for column in COLUMNS + 1:
			var up := PI * (float(row) / ROWS - 0.5)
			var way := Vector2.from_angle(lerpf(from, to, float(column) / COLUMNS)) * cos(up)
			var normal := Vector3(way.x, sin(up), way.y)
			_add(radius * normal, normal)
	for row in ROWS:
		for column in COLUMNS:
			var here := first + row * (COLUMNS + 1) + column
			_four(here, here + 1, here + COLUMNS + 1, here + COLUMNS + 2)


## Adds a disc or a short cylinder along the y axis of `place`.
func disc(radius: float, height: float, place: Transform3D, bevel := 0.008) -> void:
	var half := 0.5 * height
	var edge := minf(bevel, half)
	var rim: Array[Vector2] = [Vector2(radius - edge, half), Vector2(radius, half - edge)]
	lathe([Vector2(0.0, -half), rim[0] * Vector2(1, -1), rim[1] * Vector2(1, -1), rim[1], rim[0], Vector2(0.0, half)], place)


## Adds a tube through points.
func tube(points: PackedVector3Array, radius: float) -> void:
	for i in points.size() - 1:
		var along := points[i + 1] - points[i]
		var long := along.length()
		var profile := PackedVector2Array([Vector2(0.0, -radius), Vector2(0.7 * radius, -0.7 * radius), Vector2(radius, 0.0)])
		profile.append_array([Vector2(radius, long), Vector2(0.7 * radius, long + 0.7 * radius), Vector2(0.0, long + radius)])
		lathe(profile, Transform3D(Basis(Quaternion(Vector3.UP, along / long)), points[i]), 10)


## Adds a plate, whose outline is in the plane of z (ahead) and y, from `left` to `right` along x.
func plate(outline: PackedVector2Array, left: float, right: float) -> void:
	var triangles := Geometry2D.triangulate_polygon(outline)
	for x: float in [left, right]:
		var first := _points.size()
		for point in outline:
			_add(Vector3(x, point.y, point.x), Vector3.RIGHT * signf(x - 0.5 * (left + right)))
		for i in range(0, triangles.size(), 3):
			_triangle(first + triangles[i], first + triangles[i + 1], first + triangles[i + 2])
	var turns := -1.0 if Geometry2D.is_polygon_clockwise(outline) else 1.0
	for i in outline.size():
		var next := outline[(i + 1) % outline.size()]
		var out := turns * (next - outline[i]).orthogonal().normalized()
		_band(outline[i], next, out, out, left, right)


## Adds a sheet that is bent along a line in the plane of z (ahead) and y, from `left` to `right` along x.
func sheet(line: PackedVector2Array, left: float, right: float, thick: float) -> void:
	var out := PackedVector2Array()
	for i in line.size():
		out.append((line[mini(i + 1, line.size() - 1)] - line[maxi(i - 1, 0)]).orthogonal().normalized())
	var last := line.size() - 1
	for i in last:
		_band(line[i], line[i + 1], out[i], out[i + 1], left, right)
		_band(line[i] - thick * out[i], line[i + 1] - thick * out[i + 1], -out[i], -out[i + 1], left, right)
		for x: float in [left, right]:
			var first := _points.size()
			for point: Vector2 in [line[i], line[i + 1], line[i] - thick * out[i], line[i + 1] - thick * out[i + 1]]:
				_add(Vector3(x, point.y, point.x), Vector3.RIGHT * signf(x - 0.5 * (left + right)))
			_four(first, first + 1, first + 2, first + 3)
	for end: int in [0, last]:
		var way := (line[end] - line[1 if end == 0 else last - 1]).normalized()
		_band(line[end], line[end] - thick * out[end], way, way, left, right)


## Adds the convex hull of points, with flat sides.
func hull(points: PackedVector3Array) -> void:
	for a in points.size():
		for b in range(a + 1, points.size()):
			for c in range(b + 1, points.size()):
				var plane := Plane(points[a], points[b], points[c])
				var above := 0
				var below := 0
				for point in points:
					above += int(plane.distance_to(point) > 1e-5)
					below += int(plane.distance_to(point) < -1e-5)
				if above == 0 or below == 0:
					var first := _points.size()
					for i: int in [a, b, c]:
						_add(points[i], plane.normal * (1.0 if above == 0 else -1.0))
					_triangle(first, first + 1, first + 2)


func _band(from: Vector2, to: Vector2, from_out: Vector2, to_out: Vector2, left: float, right: float) -> void:
	var first := _points.size()
	for x: float in [left, right]:
		_add(Vector3(x, from.y, from.x), Vector3(0.0, from_out.y, from_out.x))
		_add(Vector3(x, to.y, to.x), Vector3(0.0, to_out.y, to_out.x))
	_four(first, first + 1, first + 2, first + 3)


func _add(point: Vector3, normal: Vector3) -> void:
	_points.append(point)
	_normals.append(normal.normalized())
	_colors.append(Color(_color, 1.0 - smoothstep(dirt.x, dirt.y, point.y)))
	_finishes.append(_finish)
	_grains.append(grain)


## Adds two triangles between two vertices and the two beside them.
func _four(a: int, b: int, c: int, d: int) -> void:
	_triangle(a, b, c)
	_triangle(c, b, d)


## Adds a triangle that is seen from where its normals point.
func _triangle(a: int, b: int, c: int) -> void:
	var faces := (_points[b] - _points[a]).cross(_points[c] - _points[a])
	var is_clockwise := faces.dot(_normals[a] + _normals[b] + _normals[c]) < 0.0
	_indices.append_array([a, b, c] if is_clockwise else [a, c, b])
