# SPDX-License-Identifier: MIT
## Grass without a GrassField: MultiMeshes of blades, as one makes them by hand in Godot. The instances are written by a
## compute shader, since 16 million of them take a script minutes.
extends Node3D

const DENSITY := 256.0  # blades a square metre
const TILE := 8.0  # metres
## The levels by distance: up to where (metres), segments of a blade, share of the blades, how much wider they are, whether they cast
## shadows. About the same as a GrassField with its default numbers.
const LEVELS: Array[Dictionary] = [
	{to = 18.0, segments = 7, share = 1.0, wider = 1.0, shadow = true},
	{to = 50.0, segments = 3, share = 0.7, wider = 1.2, shadow = true},
	{to = 80.0, segments = 3, share = 0.4, wider = 1.6, shadow = false},
	{to = 0.0, segments = 3, share = 0.2, wider = 2.2, shadow = false},
]
const RING_TILE := 5.0  # metres
## The same in the way of GodotGrass (2Retr0, MIT), re-created from what it does, without its code: blades of five triangles, far ones of
## one, its distances, and its shares of the blades near the eye. They are not widened, and all cast shadows.
const RINGS: Array[Dictionary] = [
	{to = 12.0, segments = 3, share = 1.0, wider = 1.0, shadow = true},
	{to = 40.0, segments = 3, share = 0.25, wider = 1.0, shadow = true},
	{to = 70.0, segments = 1, share = 0.0676, wider = 1.0, shadow = true},
	{to = 100.0, segments = 1, share = 0.01, wider = 1.0, shadow = true},
	{to = 0.0, segments = 1, share = 0.0004, wider = 1.0, shadow = true},
]
const FILL := """#version 450
layout(local_size_x = 64) in;
layout(push_constant, std430) uniform Block { uint count; float side; uint seed; uint row; } block;
layout(set = 0, binding = 0, std430) writeonly buffer Instances { vec4 rows[]; };
uint hash(uint v) {
	uint s = v * 747796405u + 2891336453u;
	uint w = ((s >> ((s >> 28u) + 4u)) ^ s) * 277803737u;
	return (w >> 22u) ^ w;
}
float random(uint i, uint channel) { return float(hash(i + hash(channel + block.seed)) >> 8u) / 16777216.0; }
void main() {
	uint i = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * block.row;
	if (i >= block.count) { return; }
	vec2 start = vec2(random(i / 65536u, 9u), random(i / 65536u, 10u));
	vec2 even = fract(vec2(0.7548776662, 0.5698402910) * float(i % 65536u) + start);
	vec2 place = (even + 0.002 * vec2(random(i, 1u), random(i, 2u)) - 0.5) * block.side;
	float turn = 6.2831853 * random(i, 3u), tall = 0.6 + 0.8 * random(i, 4u), wide = 0.7 + 0.6 * random(i, 5u), lean = 0.3 * random(i, 6u);
	float c = cos(turn), s = sin(turn);
	rows[3u * i] = vec4(c * wide, -s * lean * tall, s, place.x);
	rows[3u * i + 1u] = vec4(0.0, tall, 0.0, 0.0);
	rows[3u * i + 2u] = vec4(-s * wide, -c * lean * tall, c, place.y);
}
"""

var error := ""  ## why there is no grass; empty if there is
var blades := 0

var _made: Array[RID] = []  # RenderingServer's, in the order in which they may be freed
var _meshes: Array[ArrayMesh] = []
var _material := ShaderMaterial.new()


func _init() -> void:
	_material.shader = preload("res://bench/rival.gdshader")
	var noise := FastNoiseLite.new()
	noise.frequency = 0.03
	_material.set_shader_parameter("noise", ImageTexture.create_from_image(noise.get_seamless_image(128, 128)))


## One MultiMesh over the whole field, one instance a blade.
func make_plain(p_side: float, p_segments: int) -> void:
	blades = roundi(p_side * p_side * DENSITY)
	var multimesh := _make_multimesh(_make_mesh(p_segments, 1.0), blades, p_side)
	_add_instance(multimesh, Vector3.ZERO, {})


## Tiles of about p_tile metres that share one MultiMesh for each of p_levels, switched by distance.
func make_tiled(p_side: float, p_tile: float, p_levels: Array[Dictionary]) -> void:
	blades = roundi(p_side * p_side * DENSITY)
	var across := maxi(1, roundi(p_side / p_tile))
	var tile := p_side / across
	var from := 0.0
	for level in p_levels:
		var count := maxi(1, roundi(tile * tile * DENSITY * level.share))
		var multimesh := _make_multimesh(_make_mesh(level.segments, level.wider), count, tile)
		for x in across:
			for z in across:
				var place := Vector3((x + 0.5) * tile - 0.5 * p_side, 0.0, (z + 0.5) * tile - 0.5 * p_side)
				_add_instance(multimesh, place, {from = from, to = level.to, shadow = level.shadow})
		from = level.to


## Grass within p_radius of a place lies flat, as below a player.
func flatten(p_place: Vector3, p_radius: float) -> void:
	_material.set_shader_parameter("player", Vector4(p_place.x, p_place.y, p_place.z, p_radius))


func _exit_tree() -> void:
	for rid in _made:
		RenderingServer.free_rid(rid)
	_made.clear()


func _add_instance(p_multimesh: RID, p_place: Vector3, p_range: Dictionary) -> void:
	var instance := RenderingServer.instance_create2(p_multimesh, get_world_3d().scenario)
	RenderingServer.instance_set_transform(instance, Transform3D(Basis(), p_place))
	if p_range:
		RenderingServer.instance_geometry_set_visibility_range(
			instance, p_range.from, p_range.to, 0.0, 0.0, RenderingServer.VISIBILITY_RANGE_FADE_DISABLED
		)
		if not p_range.shadow:
			RenderingServer.instance_geometry_set_cast_shadows_setting(instance, RenderingServer.SHADOW_CASTING_SETTING_OFF)
	_made.push_front(instance)


func _make_multimesh(p_mesh: ArrayMesh, p_count: int, p_side: float) -> RID:
	var multimesh := RenderingServer.multimesh_create()
	_made.push_back(multimesh)
	RenderingServer.multimesh_allocate_data(multimesh, p_count, RenderingServer.MULTIMESH_TRANSFORM_3D)
	RenderingServer.multimesh_set_mesh(multimesh, p_mesh.get_rid())
	RenderingServer.multimesh_set_custom_aabb(multimesh, AABB(Vector3(-0.5 * p_side, 0.0, -0.5 * p_side), Vector3(p_side, 1.0, p_side)))
	RenderingServer.call_on_render_thread(_fill.bind(multimesh, p_count, p_side))
	return multimesh


## Runs on the render thread.
func _fill(p_multimesh: RID, p_count: int, p_side: float) -> void:
	var device := RenderingServer.get_rendering_device()
	var buffer := RenderingServer.multimesh_get_buffer_rd_rid(p_multimesh) if device else RID()
	if not buffer.is_valid():
		error = "no room for %d instances" % p_count
		return
	var source := RDShaderSource.new()
	source.source_compute = FILL
	var shader := device.shader_create_from_spirv(device.shader_compile_spirv_from_source(source))
	var pipeline := device.compute_pipeline_create(shader)
	var uniform := RDUniform.new()
	uniform.uniform_type = RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER
	uniform.binding = 0
	uniform.add_id(buffer)
	var bound := device.uniform_set_create([uniform], shader, 0)
	var push := PackedByteArray()
	push.resize(16)
	push.encode_u32(0, p_count)
	push.encode_float(4, p_side)
	push.encode_u32(8, 7)
	push.encode_u32(12, 64 * 1024)
	var list := device.compute_list_begin()
	device.compute_list_bind_compute_pipeline(list, pipeline)
	device.compute_list_bind_uniform_set(list, bound, 0)
	device.compute_list_set_push_constant(list, push, push.size())
	device.compute_list_dispatch(list, 1024, ceili(p_count / 65536.0), 1)
	device.compute_list_end()
	device.free_rid(pipeline)
	device.free_rid(shader)


## Returns a blade half a metre long that leans and narrows: two vertices a row, one triangle at the tip.
func _make_mesh(p_segments: int, p_widening: float) -> ArrayMesh:
	var places := PackedVector3Array()
	var normals := PackedVector3Array()
	var uvs := PackedVector2Array()
	var indices := PackedInt32Array()
	for row in p_segments + 1:
		var along := float(row) / p_segments
		var width := 0.015 * p_widening * (0.7 + 0.3 * smoothstep(0.0, 0.3, along)) * (1.0 - along * along * along)
		for side: float in [-1.0, 1.0]:
			places.append(Vector3(0.5 * side * width, 0.48 * along, 0.28 * along * along))
			normals.append(Vector3(0.4 * side, -1.16 * along, 1.0).normalized())
			uvs.append(Vector2(0.5 + 0.5 * side, along))
	for row in p_segments:
		var left := 2 * row
		indices.append_array([left, left + 2, left + 1])
		if row + 1 < p_segments:
			indices.append_array([left + 1, left + 2, left + 3])
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = places
	arrays[Mesh.ARRAY_NORMAL] = normals
	arrays[Mesh.ARRAY_TEX_UV] = uvs
	arrays[Mesh.ARRAY_INDEX] = indices
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	mesh.surface_set_material(0, _material)
	_meshes.append(mesh)
	return mesh
