# SPDX-License-Identifier: MIT
## Light probes over a row of plots, like those of a LightmapGI. The engine bakes lightmaps in its editor only, at the push of a button
## (LightmapGI has no method for it), so this script gathers the light of each probe itself: from the sky, the ground and the walls, along
## some rays. A field takes its light from the probes at its middle, if its `gi_mode` is Dynamic.
extends Node3D

const RAYS := 400
const AROUND := 0.4  # metres from a plot's middle to its four probes
const HEIGHT := 0.3
const SKY := Color(0.5, 0.62, 0.8)
const GROUND := Color(0.1, 0.11, 0.06)
const WALL_LIGHT := 1.1  # light that a white wall reflects

var _lightmap := RenderingServer.lightmap_create()
var _instance := RenderingServer.instance_create()


## p_middles: of the plots, from left to right; p_walls: middle and colour of each; p_size: of a wall.
func _init(p_middles: PackedVector3Array, p_walls: Dictionary, p_size: Vector3) -> void:
	var points := PackedVector3Array()
	var harmonics := PackedColorArray()
	var tetrahedra := PackedInt32Array()
	for middle in p_middles:
		for off: Vector3 in [Vector3(1, -1, -1), Vector3(-1, -1, -1), Vector3(0, -1, 1), Vector3(0, 1, 0)]:
			tetrahedra.append(points.size())
			points.append(middle + Vector3(0, HEIGHT, 0) + off * AROUND * Vector3(1, 0.5, 1))
			harmonics.append_array(_gather(points[-1], p_walls, p_size))
	var bounds := AABB(p_middles[0], Vector3.ZERO).expand(p_middles[-1]).grow(50.0)
	RenderingServer.lightmap_set_probe_bounds(_lightmap, bounds)
	RenderingServer.lightmap_set_probe_interior(_lightmap, false)
	RenderingServer.lightmap_set_probe_capture_data(_lightmap, points, harmonics, tetrahedra, _tree(p_middles))
	RenderingServer.instance_set_base(_instance, _lightmap)


func _enter_tree() -> void:
	RenderingServer.instance_set_scenario(_instance, get_world_3d().scenario)


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		RenderingServer.free_rid(_instance)
		RenderingServer.free_rid(_lightmap)


## Nine spherical harmonics of the light that reaches a place.
func _gather(place: Vector3, walls: Dictionary, size: Vector3) -> PackedColorArray:
	var sums := PackedColorArray()
	sums.resize(9)
	for i in RAYS:
		var height := 1.0 - 2.0 * (i + 0.5) / RAYS
		var angle := 2.39996 * i
		var way := Vector3(cos(angle) * sqrt(1.0 - height * height), height, sin(angle) * sqrt(1.0 - height * height))
		var light := SKY if height > 0.0 else GROUND
		for wall: Vector3 in walls:
			if AABB(wall - 0.5 * size, size).intersects_ray(place, way) != null:
				light = walls[wall].srgb_to_linear() * WALL_LIGHT
		var basis := [
			0.282095,
			0.488603 * way.y,
			0.488603 * way.z,
			0.488603 * way.x,
			1.092548 * way.x * way.y,
			1.092548 * way.y * way.z,
			0.315392 * (3.0 * way.z * way.z - 1.0),
			1.092548 * way.x * way.z,
			0.546274 * (way.x * way.x - way.y * way.y)
		]
		for k in 9:
			# An even light of 1 is an ambient light of 1, as the engine adds harmonics up.
			sums[k] += light * float(basis[k]) * 4.0 * PI / RAYS / PI
	return sums


## Planes between neighbouring plots: below each are the probes of the left plot, above it those of the next ones.
func _tree(middles: PackedVector3Array) -> PackedInt32Array:
	var tree := PackedInt32Array()
	for i in middles.size():
		var last := i == middles.size() - 1
		var border := middles[i].x + 1000.0 if last else 0.5 * (middles[i].x + middles[i + 1].x)
		tree.append_array(PackedFloat32Array([1.0, 0.0, 0.0, border]).to_byte_array().to_int32_array())
		tree.append_array([-(i + 1) if last else i + 1, -(i + 1)])
	return tree
