# SPDX-License-Identifier: MIT
## Motion vectors: how blades moved since the last frame, for TAA and FSR 2.
extends "res://tests/view_case.gd"

const MOTION_VECTORS := true  # see runner.gd
const SIZE := Vector2i(384, 216)
const ROW := 108  # of the picture, where a blade's motion is measured


## Reads the vectors that the renderer has drawn. Its texture cannot be copied from: a shader samples it.
class Vectors:
	extends CompositorEffect
	const COPY := """#version 450
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D velocity;
layout(set = 0, binding = 1, std430) restrict writeonly buffer Copy { vec2 copy[]; };
void main() {
	ivec2 size = textureSize(velocity, 0);
	ivec2 place = ivec2(gl_GlobalInvocationID.xy);
	if (all(lessThan(place, size))) {
		copy[place.y * size.x + place.x] = texelFetch(velocity, place, 0).xy * vec2(size);
	}
}
"""
	var size: Vector2i
	var data: PackedFloat32Array

	func _init() -> void:
		effect_callback_type = EFFECT_CALLBACK_TYPE_POST_TRANSPARENT
		needs_motion_vectors = true

	func _render_callback(_type: int, render_data: RenderData) -> void:
		var buffers: RenderSceneBuffersRD = render_data.get_render_scene_buffers()
		size = buffers.get_internal_size()
		var device := RenderingServer.get_rendering_device()
		var source := RDShaderSource.new()
		source.source_compute = COPY
		var shader := device.shader_create_from_spirv(device.shader_compile_spirv_from_source(source))
		var pipeline := device.compute_pipeline_create(shader)
		var sampler := device.sampler_create(RDSamplerState.new())
		var copy := device.storage_buffer_create(8 * size.x * size.y)
		var bindings: Array[RDUniform] = [RDUniform.new(), RDUniform.new()]
		bindings[0].uniform_type = RenderingDevice.UNIFORM_TYPE_SAMPLER_WITH_TEXTURE
		bindings[0].add_id(sampler)
		bindings[0].add_id(buffers.get_velocity_texture())
		bindings[1].uniform_type = RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER
		bindings[1].binding = 1
		bindings[1].add_id(copy)
		var bound := device.uniform_set_create(bindings, shader, 0)
		var list := device.compute_list_begin()
		device.compute_list_bind_compute_pipeline(list, pipeline)
		device.compute_list_bind_uniform_set(list, bound, 0)
		device.compute_list_dispatch(list, ceili(size.x / 8.0), ceili(size.y / 8.0), 1)
		device.compute_list_end()
		data = device.buffer_get_data(copy).to_float32_array()
		for rid: RID in [bound, pipeline, shader, sampler, copy]:
			device.free_rid(rid)

	## From where what is seen at a pixel was in the frame before, to there; pixels.
	func at(pixel: Vector2i) -> Vector2:
		var place := 2 * (pixel.y * size.x + pixel.x)
		return -Vector2(data[place], data[place + 1])


var vectors: Vectors


func before() -> void:
	open_view(SIZE)
	add_light()
	vectors = Vectors.new()
	camera.compositor = Compositor.new()
	camera.compositor.compositor_effects = [vectors]


## Returns where a row of the picture crosses the blade, pixels; NAN where it does not.
func crossing(image: Image, row: int) -> float:
	var sum := 0.0
	var weight := 0
	for x in range(SIZE.x / 4, 3 * SIZE.x / 4):
		if is_green(image.get_pixel(x, row)):
			sum += x
			weight += 1
	return sum / weight if weight > 0 else NAN


## Follows where the blade crosses a row. How far its vectors are from that, on average, and how far it went, in pixels a frame.
func errors_of(frame_count: int, each_frame: Callable) -> Vector2:
	var last := NAN
	var error := 0.0
	var moved := 0.0
	var counted := 0
	for frame in frame_count:
		each_frame.call(frame)
		var image := await next_picture()
		var here := crossing(image, ROW)
		var slope := (crossing(image, ROW + 8) - crossing(image, ROW - 8)) / 16.0
		if not (is_nan(last) or is_nan(here) or is_nan(slope)):
			var vector := vectors.at(Vector2i(roundi(here), ROW))
			error += absf(here - last - (vector.x - slope * vector.y))
			moved += absf(here - last)
			counted += 1
		last = here
	print("    %.2f of %.2f pixels in %d frames" % [error / maxi(counted, 1), moved / maxi(counted, 1), counted])
	return Vector2(error, moved) / maxi(counted, 1) if counted > frame_count / 2 else Vector2(INF, 0)


## Adds a field of few blades, one of which the camera sees, and nothing else: its tip.
func add_one_blade(wind_speed: float, properties := {}) -> GrassField:
	var sparse := {size = Vector2(2, 2), density = 1.0, wind_speed = wind_speed, soil_enabled = false}
	var field := add_seen_field(sparse.merged(properties, true))
	await ticks(2)
	var knots := field.get_knots(Vector2i.ZERO, 0)
	look(knots[9] + Vector3(0, 0, 0.4), knots[9])
	camera.far = 0.8
	await drawn()
	return field


## Returns a green stalk, drawn in place of the blade.
func stalks() -> Dictionary:
	var box := BoxMesh.new()
	box.size = Vector3(0.02, 1.0, 0.02)
	var tool := SurfaceTool.new()
	tool.append_from(box, 0, Transform3D(Basis(), Vector3(0, 0.5, 0)))
	var mesh := tool.commit()
	var material := StandardMaterial3D.new()
	material.albedo_color = Color(0.2, 0.7, 0.1)
	mesh.surface_set_material(0, material)
	var species := GrassSpecies.new()
	species.plant_mesh = mesh
	return {species = [species] as Array[GrassSpecies]}


func test_a_plant_in_the_wind() -> void:
	var field := await add_one_blade(5.0, stalks())
	assert_greater(field.get_counters().drawn_plants, 0)
	Engine.time_scale = 6.0
	var found := await errors_of(24, func(_frame: int) -> void: pass)
	Engine.time_scale = 1.0
	assert_less(found.x, 0.5)
	assert_greater(found.y, 1.0)


func test_a_plant_that_a_ball_pushes() -> void:
	var field := await add_one_blade(0.0, stalks())
	await push_tip(field)


func test_wind() -> void:
	await add_one_blade(5.0)
	Engine.time_scale = 6.0
	var found := await errors_of(24, func(_frame: int) -> void: pass)
	Engine.time_scale = 1.0
	assert_less(found.x, 0.5)
	assert_greater(found.y, 1.0)


func test_a_field_that_moves() -> void:
	var field := await add_one_blade(0.0)
	var found := await errors_of(20, func(frame: int) -> void: field.position.x = 0.02 * sin(0.5 * frame))
	assert_less(found.x, 0.5)
	assert_greater(found.y, 1.0)


func test_a_blade_that_a_ball_pushes() -> void:
	var field := await add_one_blade(0.0)
	await push_tip(field)


func push_tip(field: GrassField) -> void:
	var tip := field.get_knots(Vector2i.ZERO, 0)[-1]
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	add_shape(body, ball(0.1))
	body.position = tip - Vector3(0.3, 0.15, 0)
	viewport.add_child(body)
	var found := await errors_of(40, func(_frame: int) -> void: body.position.x += 0.015)
	assert_less(found.x, 0.5)
	assert_greater(found.y, 0.9)


## Blades at rest that wake in the slot of a tile that was bent: they have not moved.
func test_a_tile_that_takes_the_slot_of_another() -> void:
	var field := await add_one_blade(0.0, {size = Vector2(8, 4), density = 4.0, pool_tiles = 1})
	assert_eq(field.get_grid_size(), Vector2i(2, 1))
	var press := AnimatableBody3D.new()
	press.sync_to_physics = false
	add_shape(press, ball(0.15))
	press.position = field.get_knots(Vector2i(1, 0), 0)[9] + Vector3(0.05, 0, 0)
	viewport.add_child(press)
	await ticks(20)
	assert_true(field.is_tile_awake(Vector2i(1, 0)))
	press.free()
	var waking := AnimatableBody3D.new()
	waking.sync_to_physics = false
	add_shape(waking, ball(0.02))
	var root := field.get_knots(Vector2i.ZERO, 0)[0]
	waking.position = root.lerp(field.get_tile_center(Vector2i.ZERO), 0.5) + Vector3(0, 0.02, 0)
	viewport.add_child(waking)
	var farthest := 0.0
	for frame in 10:
		var here := crossing(await next_picture(), ROW)
		if assert_false(is_nan(here)):
			farthest = maxf(farthest, vectors.at(Vector2i(roundi(here), ROW)).length())
	assert_true(field.is_tile_awake(Vector2i.ZERO))
	assert_less(farthest, 0.1, "pixels")
